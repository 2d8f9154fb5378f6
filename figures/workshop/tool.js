// tool.js - the compiler's package fetches its files from beside itself: here it is
// given them out of what the page has loaded.  It must be read before the package.

import { unzipped } from './unpack.js';

const files = {};

// The bytes of all files, packed, and { name: [from, to] }.
export function give(bytes, places) {
  for (const [name, [from, to]] of Object.entries(places)) files[name] = bytes.subarray(from, to);
}

self.fetch = async url => {
  const name = String(url).replace(/.*\//, '');
  const headers = { 'content-type': name.endsWith('.wasm') ? 'application/wasm' : 'application/octet-stream' };
  return new Response(unzipped(files[name]).body, { headers });
};

// It tells the console of every piece that it reads.
self.console.log = () => {};
