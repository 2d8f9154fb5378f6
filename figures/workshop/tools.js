// tools.js - brings the compiler, and asks the worker.

import { decode } from './unpack.js';

const PATIENCE = 120e3;         // ms without a word, after which a worker is given up
const workshop = window.tumble.workshop;
const folder = document.currentScript.src.replace(/[^/]*$/, '');
const scripts = {};

// From a disk only plain scripts are let in.
export const script = name => scripts[name] ||= new Promise((done, failed) => document.head.append(Object.assign(document.createElement('script'), {
  src: `${folder}${name}.js`, onload: done, onerror: () => { delete scripts[name]; failed(Error(`workshop/${name}.js is not there`)); },
})));

// --- The compiler -------------------------------------------------------------------
let bytes, worker, asked = 0;
const open = new Map();

export const isHere = () => Boolean(bytes);
export const megabytes = () => Math.round(workshop.compiler.bytes / 1e6);

// All of its pieces, one after the other; told(part) of the way.
async function bring(told) {
  if (bytes) return;
  const { pieces, bytes: size } = workshop.compiler, all = new Uint8Array(size);
  let at = 0;
  for (let k = 0; k < pieces; k++) {
    let piece;
    workshop.piece = (number, base64) => { piece = decode(base64); };
    await script(`clang-${String(k).padStart(2, '0')}`);
    all.set(piece, at);
    at += piece.length;
    told(at / size);
  }
  bytes = all;
}

function begin() {
  worker = new Worker(URL.createObjectURL(new Blob([workshop.worker], { type: 'text/javascript' })));
  worker.onmessage = ({ data: { id, step, done, failed } }) => {
    const one = open.get(id);
    if (!one) return;
    if (step) { one.wait(); one.tell(step); return; }
    clearTimeout(one.timer);
    open.delete(id);
    if (failed) one.failed(Error(failed)); else one.done(done);
  };
  worker.onerror = event => stop(event.message || 'The worker could not be read.');
  worker.postMessage({ id: 0, ask: 'compiler', bytes, files: workshop.compiler.files });
}

// Ends what goes on: the next that is asked begins with a new worker.
export function stop(why) {
  worker?.terminate();
  worker = undefined;
  for (const one of open.values()) { clearTimeout(one.timer); one.failed(Error(why)); }
  open.clear();
}

// The answer of the worker; tell(sentence, part) says how far it is.
export async function ask(what, rest, tell) {
  if (!bytes) {
    await bring(part => tell(`The compiler comes: ${Math.round(part * megabytes())} of ${megabytes()} MB`, part));
    await script('worker');
  }
  if (!worker) { tell('The compiler wakes: some seconds …'); begin(); }
  const id = ++asked;
  return new Promise((done, failed) => {
    const one = { done, failed, tell, wait() {
      clearTimeout(one.timer);
      one.timer = setTimeout(() => stop('Stopped: nothing was heard of it for two minutes.'), PATIENCE);
    } };
    open.set(id, one);
    one.wait();
    worker.postMessage({ id, ask: what, ...rest });
  });
}
