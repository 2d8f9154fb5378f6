// links.mjs - does each link of each page lead to a page that is there, and to an
// element of it?

import { readFileSync, readdirSync, existsSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';

const decoded = text => decodeURIComponent(text.replace(/&amp;/g, '&'));

function read(path) {
  const text = readFileSync(path, 'utf8').replace(/<pre[\s\S]*?<\/pre>/g, code => (code.match(/<[^>]* (id|href)="[^>]*>/g) ?? []).join(''));
  return {
    ids: new Set([...text.matchAll(/ id="([^"]*)"/g)].map(found => found[1])),
    twice: [...text.matchAll(/ id="([^"]*)"/g)].map(found => found[1]).filter((id, k, list) => list.indexOf(id) !== k),
    links: [...text.matchAll(/ (?:href|src|srcset|data-moving)="([^"]*)"/g)].map(found => found[1]),
  };
}

// Answers with sentences on what is wrong, and with the number of links.
export function checkLinks(folder) {
  const pages = readdirSync(folder, { recursive: true }).filter(path => path.endsWith('.html'));
  const known = new Map(pages.map(path => [path, read(join(folder, path))]));
  const faults = [];
  let count = 0;
  for (const [path, page] of known) {
    for (const id of page.twice) faults.push(`${path}: two elements are called ${id}`);
    for (const link of page.links) {
      if (/^(https?|data|mailto):/.test(link)) continue;
      count++;
      const [file, id] = link.split('#').map(decoded);
      const target = file ? normalize(join(dirname(path), file)) : path;
      if (!existsSync(join(folder, target))) faults.push(`${path}: there is no ${target}`);
      else if (id && !known.get(target)?.ids.has(id)) faults.push(`${path}: ${target} has no #${id}`);
    }
  }
  return { faults, count, pages: pages.length };
}
