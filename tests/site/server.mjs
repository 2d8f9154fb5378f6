// server.mjs - a static host as plain as they come: files of a folder, packed.

import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { gzipSync } from 'node:zlib';

const kinds = { html: 'text/html', css: 'text/css', js: 'text/javascript', svg: 'image/svg+xml',
  webp: 'image/webp', woff2: 'font/woff2', csv: 'text/csv' };

// Answers with the address of the folder's files, and a function that ends it.
export function serve(folder) {
  const server = createServer(async (request, answer) => {
    const path = new URL(request.url, 'http://localhost').pathname;
    const kind = path.split('.').pop();
    try {
      const bytes = await readFile(folder + decodeURIComponent(path));
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
