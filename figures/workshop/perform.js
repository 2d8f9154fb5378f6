// perform.js - runs a program of the reader's own from its main to its end, and says
// what it printed, and what stopped it.

import { load, start, whatStopped, places, placed } from './judge.js';

// { printed, hash, seconds } and, if it did not end, fault.
export async function perform(wasm, seconds, draws) {
  const program = await load(wasm), host = await start(program, {});
  const began = performance.now(), out = {};
  host.slice = Infinity;        // who looks on has the clock on the wall
  host.watch(seconds);
  host.most = draws ? 1e8 : 1e6;
  try { host.x.page_begin(draws ? 1 : 0); } catch (error) {
    const stopped = { ...whatStopped(error, seconds), places: places(program, error) }, place = placed(stopped, '');
    if (stopped.endless) stopped.fault = `does not end (stopped after ${seconds} seconds)`;
    out.fault = stopped.message ?? `Your program ${stopped.fault}${place ? ': ' + place : ''}.`;
  }
  out.seconds = (performance.now() - began) / 1e3;
  out.printed = host.printed;
  out.hash = BigInt.asUintN(64, host.x.page_hash()).toString(16).padStart(16, '0');
  return out;
}
