// unpack.js - what came as gzip in base64, as bytes.

export function decode(base64) {
  const letters = atob(base64), bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

export const unzipped = bytes => new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip')));

export const unpack = async base64 => new Uint8Array(await unzipped(decode(base64)).arrayBuffer());

// All of { name: base64 }.
export const unpackAll = async packed => Object.fromEntries(await Promise.all(
  Object.entries(packed).map(async ([name, base64]) => [name, await unpack(base64)])));
