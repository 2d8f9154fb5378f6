// worker.js - compiles, links, judges and runs, beside the page.  It is asked by
// { id, ask, ... }, tells of its work by { id, step, ... }, and answers by
// { id, done } or { id, failed }.

import { give } from './tool.js';
import { compile, link } from './compiler.js';
import { asText, judge } from './judge.js';
import { perform } from './perform.js';
import { unpack, unpackAll } from './unpack.js';

const JUDGE = ['page_list', 'page_run', 'page_room'], STAGE = ['page_begin', 'page_hash'];
// What the linker does not find, in a sentence.
function missing(text) {
  const all = [...text.matchAll(/(\S+): undefined symbol: (\w+)/g)].map(([, file, name]) => file.endsWith('mine.o')
    ? `Your file calls ${name}, which is not there.` : `The function ${name} is missing from your file.`);
  return [...new Set(all)].join(' ');
}
const must = ({ wasm, text }) => {
  if (!wasm && missing(text)) throw Error(missing(text));
  if (!wasm) throw Error(text.trim().split('\n').slice(0, 3).map(line => line.replace(/^wasm-ld: error: |mine\.o: /g, '')).join('; '));
  return wasm;
};

const asks = {
  compiler: ({ bytes, files }) => give(bytes, files),

  // An exercise, by its own tests.
  async judge({ source, headers, facts, judge: judgePage }, tell) {
    tell('Compiling …');
    const made = await compile(source, { ...headers, ...facts.headers });
    if (!made.object) return { messages: made.messages, text: made.text };
    tell('Linking …');
    const judged = { 'tests.o': await unpack(facts.judge), 'judge.o': await unpack(judgePage) }, options = { exported: JUDGE, isShaded: true };
    const wasm = must(await link({ 'mine.o': made.object, ...judged }, options));
    const answer = async () => must(await link({ 'answer.o': await unpack(facts.answer), ...judged }, options));
    const told = await judge(facts, await unpackAll(facts.files), wasm, answer,
      (count, all, name) => tell(`Test ${count} of ${all}: ${name}`));
    return { messages: made.messages, told, text: asText(told) };
  },

  // A live figure with the reader's module in it.
  async figure({ source, headers, objects }, tell) {
    tell('Compiling …');
    const made = await compile(source, headers, false);
    if (!made.object) return { messages: made.messages, text: made.text };
    return { wasm: must(await link({ 'mine.o': made.object, ...await unpackAll(objects) }, { slim: true })) };
  },

  // A program of the reader's own, run from its main to its end.
  async run({ source, runner, seconds, draws }, tell) {
    tell('Compiling …');
    const made = await compile(source, {}, false, ['-Dprintf=printf_noted']);
    if (!made.object) return { messages: made.messages, text: made.text };
    tell('Running …');
    const wasm = must(await link({ 'mine.o': made.object, 'runner.o': await unpack(runner) }, { exported: STAGE }));
    return { messages: made.messages, ran: await perform(wasm, seconds, draws), wasm };
  },
};

self.onmessage = async ({ data: { id, ask, ...rest } }) => {
  try {
    self.postMessage({ id, done: await asks[ask](rest, step => self.postMessage({ id, step })) });
  } catch (error) {
    self.postMessage({ id, failed: String(error.message ?? error) });
  }
};
