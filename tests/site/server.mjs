// server.mjs - a static host as plain as they come: files of a folder, packed.

import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { gzipSync } from 'node:zlib';
import { randomBytes } from 'node:crypto';

const kinds = { html: 'text/html', css: 'text/css', js: 'text/javascript', svg: 'image/svg+xml',
  webp: 'image/webp', woff2: 'font/woff2', csv: 'text/csv' };

// The words of a page as one file of so many bytes, packed: no script, no style, no
// picture.  What they weigh is a remark that cannot be packed.
function plain(html, size) {
  const words = html.replace(/<(script|style|svg|picture)\b[\s\S]*?<\/\1>|<(link|img)\b[^>]*>/g, '').replace('<head>', '<head><link rel="icon" href="data:,">');
  const more = Math.max(0, size - gzipSync(words).length);
  return `${words}<!-- ${randomBytes(more).toString('base64')} -->`;
}

// Answers with the address of the folder's files, and a function that ends it.
// PAGE?plain=BYTES is the page that others are measured against.
export function serve(folder) {
  const server = createServer(async (request, answer) => {
    const { pathname: path, searchParams } = new URL(request.url, 'http://localhost');
    const size = searchParams.get('plain');
    const kind = path.split('.').pop();
    try {
      const file = await readFile(folder + decodeURIComponent(path)), bytes = size ? plain(String(file), +size) : file;
      const packed = /^(html|css|js|svg|csv)$/.test(kind) ? gzipSync(bytes) : null;
      answer.writeHead(200, { 'content-type': kinds[kind] ?? 'application/octet-stream',
        ...packed && { 'content-encoding': 'gzip' }, 'content-length': (packed ?? bytes).length });
      answer.end(packed ?? bytes);
    } catch {
      answer.writeHead(404).end();
    }
  });
  return new Promise(done => server.listen(0, '127.0.0.1', () =>
    done({ address: `http://127.0.0.1:${server.address().port}/`, end: () => server.close() })));
}
