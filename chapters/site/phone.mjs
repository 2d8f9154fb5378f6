// phone.mjs - charts laid out for a page 380 pixels wide, with words as large as
// before:   node phone.mjs CHART.svg PHONE.svg [CHART.svg PHONE.svg ...]
//
// A chart is 720 wide.  What stands side by side in it, with a gap between, comes
// one below the other.  A part that is still too wide is drawn closer, but for its
// words, dots and arrowheads; of numbers along an axis that would then touch, every
// second one is left out.

import { readFileSync, writeFileSync } from 'node:fs';

const WIDE = 380, GAP = 24, BELOW = 4;      // between parts, and more between groups
const BROAD = 100;          // what is drawn in a column is no narrower
const SMALL = 20;           // a dot, a tick, an arrowhead
const WIDER = 60;
const LINE = 17;            // from one line of words to the next
const FAR = 25;             // a gap between two drawings of loose parts

const tenth = x => String(Math.round(10 * x) / 10);
const attribute = (tag, key) => tag.match(new RegExp(` ${key}="([^"]*)"`))?.[1];
const around = boxes => ({
  l: Math.min(...boxes.map(b => b.l)), r: Math.max(...boxes.map(b => b.r)),
  t: Math.min(...boxes.map(b => b.t)), b: Math.max(...boxes.map(b => b.b)),
});
const width = box => box.r - box.l;

// --- what is drawn: items with a place (x, y), a box, and a way to draw them ---

// One piece of a path: "10 20l5 5h4z", its steps as [letter, numbers...].
const STEP = { l: 2, h: 1, v: 1, a: 7, z: 0 };
function piece(head, text, path) {
  const [x, y] = text.match(/-?[\d.]+/g).map(Number);
  const steps = [];
  for (const [, word, numbers] of text.replace(/^-?[\d.]+ ?-?[\d.]+/, '').matchAll(/([a-z])([^a-z]*)/g)) {
    const all = numbers.match(/-?[\d.]+/g)?.map(Number) ?? [];
    do steps.push([word, ...all.splice(0, STEP[word])]); while (all.length);
  }
  const corners = [[x, y]];
  let px = x, py = y;
  for (const [word, ...v] of steps) {
    const dx = word === 'l' ? v[0] : word === 'h' ? v[0] : word === 'a' ? v[5] : 0;
    const dy = word === 'l' ? v[1] : word === 'v' ? v[0] : word === 'a' ? v[6] : 0;
    if (word === 'a') corners.push([px + dx / 2, py + dy / 2 - v[0]], [px + dx / 2, py + dy / 2 + v[0]]);
    corners.push([px += dx, py += dy]);
  }
  const box = around(corners.map(([x, y]) => ({ l: x, r: x, t: y, b: y })));
  const isSmall = width(box) <= SMALL && box.b - box.t <= SMALL;
  return { head, path, steps, x, y, ...box, isSmall };
}

// How wide words are in a wide face, of size 1; no less than check_charts.sh says.
const PARTS = [[/[ijl.,:;'’| !()-]/, .36], [/[mwMW%@—−+=≤]/, .9], [/[A-Z0-9]/, .66]];
const span = (text, isBold) => Math.max([...text].length * (isBold ? .62 : .54),
  [...text].reduce((sum, letter) => sum + (PARTS.find(([some]) => some.test(letter))?.[1] ?? .58), 0) * (isBold ? 1.1 : 1));

function words(tag) {
  const text = tag.replace(/<[^>]*>/g, '').replace(/&[a-z]*;/g, 'x');
  const open = tag.slice(0, tag.indexOf('>'));
  const size = Number(attribute(open, 'font-size') ?? 13), isBold = tag.includes('"bold"');
  const long = span(text, isBold) * size;
  const anchor = attribute(open, 'text-anchor');
  const before = long * ({ end: 1, middle: .5 }[anchor] ?? 0);
  const turned = open.match(/translate\(([\d.-]+)[ ,]+([\d.-]+)\) rotate\(([\d.-]+)/);
  const item = { tag, anchor, text, size, isTitle: isBold && anchor === 'middle' && long > 60, isNumber: tag.includes('class="quiet"') && !turned };
  if (turned) {
    const [x, y, angle] = turned.slice(1).map(Number);
    const along = [Math.cos(angle * Math.PI / 180), Math.sin(angle * Math.PI / 180)];
    const [x0, y0, x1, y1] = [-before, long - before].flatMap(way => along.map((part, k) => [x, y][k] + way * part));
    return { ...item, x, y, l: Math.min(x0, x1) - 4, r: Math.max(x0, x1) + 4, t: Math.min(y0, y1) - 4, b: Math.max(y0, y1) + 4, isTurned: true };
  }
  const x = Number(attribute(open, 'x')), y = Number(attribute(open, 'y'));
  return { ...item, x, y, l: x - before, r: x - before + long, t: y - .75 * size, b: y + .25 * size };
}

function read(svg) {
  const items = [];
  svg.split('\n').forEach((tag, path) => {
    if (tag.startsWith('<text')) items.push(words(tag));
    const d = tag.startsWith('<path') && !tag.includes('M0 0h720v') && tag.match(/^<path(.*) d="M(.*)"/);
    if (d) for (const text of d[2].split('M')) items.push(piece(d[1], text, path));
  });
  return items;
}

// --- rows and columns ---

// Boxes that share an interval of an axis, from `low` to `high`, in runs.
function runs(items, low, high) {
  const out = [];
  for (const one of [...items].sort((a, b) => a[low] - b[low])) {
    const last = out.at(-1);
    if (last && one[low] <= last.end + 1) { last.items.push(one); last.end = Math.max(last.end, one[high]); }
    else out.push({ items: [one], end: one[high] });
  }
  return out.map(run => run.items);
}
const isDrawn = item => !item.tag;
const drawn = items => items.filter(isDrawn);

// What is drawn beside each other with a gap between; each part is broad enough.
// Words go to the part that is nearest to their place.  A line of words in the middle
// of several parts holds them together.
const broad = items => drawn(items).length && width(around(drawn(items))) >= BROAD;
function columns(items) {
  const parts = [[]], all = runs(drawn(items), 'l', 'r');
  all.forEach((run, k) => {
    const part = parts.at(-1);
    if (broad(part) && (broad(run) || around(run).l - around(part).r > FAR && broad(all.slice(k).flat()))) parts.push([...run]);
    else part.push(...run);
  });
  if (parts.length === 1) return [items];
  const boxes = parts.map(around);
  for (const word of items.filter(item => item.tag)) {
    const far = boxes.map(box => Math.max(box.l - word.x, word.x - box.r, 0));
    if (word.anchor === 'middle' && boxes.filter(box => Math.min(box.r, word.r) - Math.max(box.l, word.l) > FAR).length > 1) return [items];
    parts[far.indexOf(Math.min(...far))].push(word);
  }
  return parts.map(part => items.filter(item => part.includes(item)));
}

// Do words go with a group?  Not if they hold its columns together, nor where they
// would make one much wider.
function fits(group, row) {
  const before = columns(group), after = columns([...group, ...row]);
  return before.length === after.length && (before.length === 1 || after.every((part, k) => width(around(part)) < width(around(before[k])) + WIDER));
}

// Rows in groups: a drawing with the words above and below it.  What tells of the
// colours, in a line, is a group of its own.
function groups(items) {
  const out = [];
  let waiting = [];                                  // words above a drawing
  for (const row of runs(items, 't', 'b')) {
    const last = out.at(-1);
    const isSame = last && broad(last) && !waiting.length && !row.some(item => item.isTitle) && fits(last, row);
    if (!drawn(row).some(item => !item.isSmall)) {
      if (isSame) last.push(...row); else waiting.push(row);
    } else if (isSame && columns(last).length === 1 && columns(row).length === 1) last.push(...row);
    else {
      const isNearer = words => last && around(words).t - around(last).b < around(row).t - around(words).b;
      if (waiting.length && !waiting[0].some(item => item.isTitle) && isNearer(waiting[0])) out.push(waiting.shift());
      let group = row;
      while (waiting.length && !drawn(waiting.at(-1)).length && fits(group, waiting.at(-1)) && !(columns(row).length === 1 && waiting.at(-1).length > 1)) group = [...waiting.pop(), ...group];
      out.push(...waiting, group);
      waiting = [];
    }
  }
  return [...out, ...waiting];
}
// Its words one by one, with their dots.
function inLine(group) {
  const out = [];
  for (const item of [...group].sort((a, b) => a.l - b.l))
    if (out.length && isDrawn(out.at(-1).at(-1))) out.at(-1).push(item); else out.push([item]);
  return out;
}

// Columns that share the numbers of the first one's axis get them, too.
function shareNumbers(tiles) {
  const [first, ...others] = tiles;
  const numbers = first.filter(item => item.isNumber && item.anchor === 'end');
  if (numbers.length < 3) return;
  const axis = items => Math.min(...items.filter(item => /rule line/.test(item.head)).map(item => item.l));
  for (const other of others) {
    if (other.some(item => item.isNumber && item.anchor === 'end')) continue;
    const by = axis(other) - axis(first);
    if (isFinite(by)) other.push(...numbers.map(item => ({ ...item, x: item.x + by, l: item.l + by, r: item.r + by })));
  }
}

// --- closer together ---

// A drawing without an axis keeps its angles.
function keepsAngles(tile) {
  const ends = tile.filter(item => item.anchor === 'end').map(item => item.x);
  return !tile.some(item => /rule line/.test(item.head)) && !ends.some(x => ends.filter(other => other === x).length > 2);
}
// A long line of words goes where there is room for it.
const isFree = item => item.tag && !item.isTurned && width(item) > (item.isTitle ? 150 : 240);
const isRigid = item => item.tag || item.isSmall;

// The largest s with which all that stands at x stands at a + s x and in the page.
function squeeze(tile) {
  for (let s = 1; ; s -= .01) {
    let low = -Infinity, high = Infinity;
    for (const item of tile.filter(item => !isFree(item))) {
      const scale = isRigid(item) ? 1 : s, x = isRigid(item) && !item.tag ? (item.l + item.r) / 2 : item.x;
      low = Math.max(low, scale * (x - item.l) - s * x);
      high = Math.min(high, WIDE - scale * (item.r - x) - s * x);
    }
    if (low <= high || s < .1) return { s, a: (low + high) / 2 };
  }
}

const moved = (item, x, y) => ({ ...item, x: item.x + x, l: item.l + x, r: item.r + x, y: item.y + y, t: item.t + y, b: item.b + y });
function closer(item, s, a, down) {
  const middle = isRigid(item) && !item.tag ? (item.l + item.r) / 2 : item.x;
  const height = isRigid(item) && !item.tag ? (item.t + item.b) / 2 : item.y;
  if (isRigid(item)) return moved(item, a + s * middle - middle, (down - 1) * height);
  const steps = item.steps.map(([word, ...v]) =>
    word === 'a' ? [word, s * v[0], down * v[1], v[2], v[3], v[4], s * v[5], down * v[6]]
      : [word, ...v.map((x, k) => x * (word === 'v' || k ? down : s))]);
  return { ...item, steps, x: a + s * item.x, y: down * item.y, l: a + s * item.l, r: a + s * item.r, t: down * item.t, b: down * item.b };
}

// Names at the left of bars, if they are long, come above them.
function namesAbove(tile) {
  const names = tile.filter(item => item.anchor === 'end' && tile.filter(other => other.anchor === 'end' && other.x === item.x).length > 3);
  if (!names.some(name => width(name) > 130)) return tile;
  const rows = [...new Set(names.map(name => name.y))].sort((a, b) => a - b);
  const pitch = Math.min(...rows.slice(1).map((y, k) => y - rows[k])), grown = (pitch + LINE) / pitch;
  const place = y => y + (grown - 1) * (y - rows[0]);
  return tile.map(item => {
    if (names.includes(item)) {
      const up = moved(item, 14, place(item.y) - item.y - pitch / 2 - 5), long = width(item);
      return { ...up, tag: item.tag.replace(' text-anchor="end"', ''), anchor: undefined, l: up.x, r: up.x + long };
    }
    if (item.b - item.t > pitch) return { ...closer({ ...item, isSmall: false }, 1, 0, grown), y: place(item.y), t: place(item.t), b: place(item.b) };
    const middle = (item.t + item.b) / 2;
    return moved(item, 0, place(middle) - middle);
  });
}

// Lines of words that stand under each other stay so.
function keepLines(before, after) {
  before.forEach((item, k) => {
    const above = before.findIndex(other => other.tag && item.tag && other.x === item.x && item.y > other.y && item.y - other.y < 1.6 * item.size);
    if (above >= 0) after[k] = moved(after[k], 0, after[above].y + item.y - before[above].y - after[k].y);
  });
}

// Of the numbers under an axis some are left out if they touch.
function thin(tile) {
  const touch = line => line.some((item, k) => k && item.l < line[k - 1].r + 4);
  const gone = new Set();
  for (const y of new Set(tile.filter(item => item.isNumber && item.anchor === 'middle').map(item => item.y))) {
    let line = tile.filter(item => item.y === y && item.isNumber && item.anchor === 'middle').sort((a, b) => a.x - b.x);
    while (line.length > 2 && touch(line)) {
      line.filter((_, k) => k % 2).forEach(item => gone.add(item));
      line = line.filter((_, k) => k % 2 === 0);
    }
  }
  return tile.filter(item => !gone.has(item));
}

// Words that are wider than the page stand in two lines, a title's first above.
function broken(item) {
  if (!item.tag || item.isTurned || width(item) <= WIDE - 4) return [item];
  const [, open, text] = item.tag.match(/^(<text[^>]*>(?:<tspan[^>]*>)?)([^<]*)/);
  const all = text.split(' ');
  let k = 1;
  while (all.slice(0, k).join(' ').length < text.length / 2) k++;
  return [all.slice(0, k), all.slice(k)].map((some, line) => {
    const tag = open + some.join(' ') + (open.includes('<tspan') ? '</tspan>' : '') + '</text>';
    const share = width(item) * some.join(' ').length / text.length / 2, middle = (item.l + item.r) / 2;
    const l = { end: item.r - 2 * share, middle: middle - share }[item.anchor] ?? item.l;
    return moved({ ...item, tag, l, r: l + 2 * share }, 0, (item.isTitle ? line - 1 : line) * LINE);
  });
}

function fit(tile) {
  let out = tile;
  if (width(around(tile)) > WIDE) {
    const { s, a } = squeeze(tile);
    out = tile.map(item => closer(item, s, a, keepsAngles(tile) ? s : 1));
    keepLines(tile, out);
    out = thin(out);
  }
  return out.flatMap(broken);
}
const within = item => item.tag ? moved(item, Math.max(0, 2 - item.l) - Math.max(0, item.r - WIDE + 2), 0) : item;

// --- the page ---

function layOut(items) {
  const out = [];
  let y = 4;
  const place = line => {
    const boxes = line.map(around), wide = boxes.reduce((sum, box) => sum + width(box), 0);
    let x = Math.max(0, (WIDE - wide) / (line.length + 1));
    const top = Math.min(...boxes.map(box => box.t));
    line.forEach((tile, k) => {
      const by = wide > WIDE - 4 ? 0 : x - boxes[k].l;
      out.push(...tile.map(item => within(moved(item, by, y - top))));
      x += width(boxes[k]) + (WIDE - wide) / (line.length + 1);
    });
    y += Math.max(...boxes.map(box => box.b)) - top + GAP;
  };
  for (const group of groups(items)) {
    const tiles = broad(group) ? columns(group) : width(around(group)) > WIDE ? inLine(group) : [group];
    shareNumbers(tiles);
    let line = [];
    for (const tile of tiles.map(namesAbove).map(fit)) {
      if (line.length && [...line, tile].reduce((sum, one) => sum + width(around(one)) + 8, 0) > WIDE) { place(line); line = []; }
      line.push(tile);
    }
    place(line);
    y += BELOW;
  }
  return { items: out, high: Math.ceil(y - GAP - BELOW + 6) };
}

function written(items) {
  let out = '', path;
  for (const item of items) {
    if (item.tag) {
      const x = tenth(item.x), y = tenth(item.y);
      out += (path ? '"/>\n' : '') + (item.isTurned ? item.tag.replace(/translate\([^)]*\)/, `translate(${x} ${y})`)
        : item.tag.replace(/ x="[^"]*"/, ` x="${x}"`).replace(/ y="[^"]*"/, ` y="${y}"`)) + '\n';
      path = undefined;
      continue;
    }
    if (path !== item.path) out += (path ? '"/>\n' : '') + `<path${item.head} d="`;
    path = item.path;
    out += `M${tenth(item.x)} ${tenth(item.y)}` + item.steps.map(([word, ...v]) => word + v.map(tenth).join(' ')).join('').replace(/ -/g, '-');
  }
  return out + (path ? '"/>\n' : '');
}

const files = process.argv.slice(2);
for (let k = 0; k < files.length; k += 2) {
  const svg = readFileSync(files[k], 'utf8');
  const { items, high } = layOut(read(svg));
  const style = svg.match(/<style>[^]*<\/style>/)[0];
  writeFileSync(files[k + 1], `<svg xmlns="http://www.w3.org/2000/svg" width="${WIDE}" height="${high}" viewBox="0 0 ${WIDE} ${high}">\n${style}\n` +
    `<path class="page fill" d="M0 0h${WIDE}v${high}H0z"/>\n${written(items)}</svg>\n`);
}
