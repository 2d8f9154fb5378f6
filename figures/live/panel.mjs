// panel.mjs - the panel of a live figure, as JSON: what its own C says of it, and of each
// choice of its first dial the hash of frame 60 on this machine, which bits.txt keeps:
//     node --no-warnings panel.mjs FIGURE-panel.wasm tests/bits/bits.txt OUT

import { closeSync, openSync, readFileSync, writeFileSync } from 'node:fs';
import { WASI } from 'node:wasi';

const [program, bits, out] = process.argv.slice(2);

const said = openSync(out, 'w+');
const wasi = new WASI({ version: 'preview1', args: ['panel'], preopens: { '.': '.' }, stdout: said, returnOnExit: true });
const { instance } = await WebAssembly.instantiate(readFileSync(program), { wasi_snapshot_preview1: wasi.wasiImport });
const status = wasi.start(instance);
closeSync(said);
if (status) process.exit(status);

const { fickle, ...panel } = JSON.parse(readFileSync(out, 'utf8'));
const hashes = Object.fromEntries([...readFileSync(bits, 'utf8').matchAll(/^live (\S+) (\S+)$/gm)].map(found => found.slice(1)));
const choices = panel.dials[0]?.choices?.split('|') ?? [''], usual = panel.dials[0]?.choices ? panel.dials[0].value : 0;
panel.wants = choices.map((_, k) => {
  const name = k === usual ? panel.name : `${panel.name}+${k}`;
  if (fickle >> k & 1) return '';
  if (hashes[name]) return hashes[name];
  console.error(`${bits} has no hash of live ${name}: make checks && sh tests/script/check_bits.sh --renew`);
  process.exit(1);
});
writeFileSync(out, JSON.stringify(panel) + '\n');
