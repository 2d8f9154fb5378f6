// judge.js - runs the tests of an exercise one after the other, each in a memory of
// its own, and says what went wrong in the sentences of exercises/tell.awk.

import { linesOf } from './lines.js';

const PRINTED = 20, DEEP = 50;      // lines of what is printed; calls that are looked at
const DEEPER = 'calls itself without end, until the stack is full';
const WORDS = {                     // what C leaves undefined
  add_overflow_abort: 'signed integer overflow', sub_overflow_abort: 'signed integer overflow',
  mul_overflow_abort: 'signed integer overflow', negate_overflow_abort: 'signed integer overflow',
  divrem_overflow_abort: 'division by zero', shift_out_of_bounds_abort: 'a shift by too many bits, or of a negative number',
  pointer_overflow_abort: 'a pointer that leads out of memory', load_invalid_value_abort: 'a value that its type has not',
  vla_bound_not_positive_abort: 'an array without elements', nonnull_arg_abort: 'a null pointer, where one is forbidden',
  invalid_builtin_abort: 'a value that a function does not take', builtin_unreachable: 'the end of a function that returns nothing',
  misaligned: 'a pointer to where such a value cannot stand',
};

// What ends a test before it returns.
class Stop extends Error {
  constructor(kind, text, place) { super(text); Object.assign(this, { kind, text, place }); }
}

const short = x => x < .01 ? 'less than 0.01' : x < 10 ? String(+x.toPrecision(2)) : x.toFixed(0);

function memoryFault(kind) {
  const [access, what] = kind.split(' ');
  if (access === 'leak') return `does not free all that it allocates (a leak of ${what} bytes)`;
  if (what === 'outside') return `${access} outside an array`;
  if (what === 'after-free') return `${access} memory that it has given back`;
  return { stack: DEEPER, null: 'follows a null pointer (a segmentation fault)', wild: 'follows a pointer that leads nowhere (a segmentation fault)',
    out_of_bounds_abort: 'reaches outside an array', 'double-free': 'frees the same memory twice', 'bad-free': 'frees what malloc did not give' }[kind]
    ?? `does what C leaves undefined: ${WORDS[kind] ?? kind}`;
}

// A program: the module, and where its lines are.
export async function load(wasm) {
  const program = { module: await WebAssembly.compile(wasm), lineAt: linesOf(wasm) };
  Error.stackTraceLimit = DEEP;
  return program;
}

// The lines of C that an error came through, from the inside out.
export const places = (program, error) => [...String(error.stack).matchAll(/wasm-function\[\d+\]:(0x[0-9a-f]+)/g)]
  .map(found => program.lineAt(parseInt(found[1], 16))).filter(Boolean);

// All that a program of the page imports.  What it prints goes to `print`.
function imports(host) {
  const bytes = () => new Uint8Array(host.x.memory.buffer), words = () => new DataView(host.x.memory.buffer);
  const text = at => {
    const all = bytes();
    let end = at;
    while (all[end]) end++;
    return new TextDecoder().decode(all.subarray(at, end));
  };
  let file;
  const page = {
    test: (name, from, to) => host.test(text(name), from, to),
    failed: what => { throw new Stop('failed', text(what)); },
    asserted: (what, name, line) => { throw new Stop('asserted', text(what), { file: text(name), line }); },
    undefined: (kind, name, line) => { throw new Stop('memory', text(kind), name ? { file: text(name), line } : undefined); },
    tick: () => { if (host.spend() > host.allowed) throw new Stop('endless', ''); },
    size: name => { file = host.files[text(name)]; return file ? file.length : -1; },
    read: to => bytes().set(file, to),
  };
  const system = {
    proc_exit: () => { throw new Stop('exit', ''); },
    fd_write: (fd, list, count, written) => {
      let sum = 0;
      for (let k = 0; k < count; k++) {
        const at = words().getUint32(list + 8 * k, true), size = words().getUint32(list + 8 * k + 4, true);
        host.print(new TextDecoder().decode(bytes().subarray(at, at + size)));
        sum += size;
      }
      words().setUint32(written, sum, true);
      return 0;
    },
    fd_fdstat_get: (fd, at) => { bytes().fill(0, at, at + 24); bytes()[at] = 2; return 0; },
    clock_time_get: (clock, precision, at) => { words().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true); return 0; },
  };
  return { page, wasi_snapshot_preview1: new Proxy(system, { get: (has, name) => has[name] ?? (() => 8) }) };
}

// The clock goes on while others compute, and a program knows of no other.  But it is
// looked at every few thousand turns of loops: what takes longer in between is not
// computing.
const TURNS = 1;                    // ms, at most
const makeHost = files => ({ files, allowed: Infinity, slice: TURNS, spent: 0, last: 0, printed: '', most: 1e6, test() {},
  print(text) {
    this.printed += text;
    if (this.printed.length > this.most) throw new Stop('prints', '');
  },
  watch(seconds) {
    this.allowed = 1e3 * seconds;
    this.last = performance.now();
  },
  // ms of computing so far.
  spend() {
    const now = performance.now();
    this.spent += Math.min(now - this.last, this.slice);
    this.last = now;
    return this.spent;
  },
});

export async function start(program, files) {
  const host = makeHost(files);
  host.x = (await WebAssembly.instantiate(program.module, imports(host))).exports;
  return host;
}

// The tests in their order: { name, from, to }.
export async function list(program, files, leave) {
  const host = await start(program, files), tests = [];
  host.test = (name, from, to) => { if (!leave.includes(name)) tests.push({ name, from, to }); };
  host.x.page_list();
  return tests;
}

// One test: { seconds, printed } and, if it did not pass, message or fault, places.
export async function run(program, files, { name, from, to }, seconds) {
  let out;
  for (let i = from; i < to; i++) {
    const host = await start(program, files);
    new Uint8Array(host.x.memory.buffer).set(new TextEncoder().encode(name + '\0'), host.x.page_room());
    host.watch(seconds);
    out = { seconds: 0 };
    try { host.x.page_run(i); } catch (error) { out = { ...whatStopped(error, seconds), places: places(program, error) }; }
    out.seconds = host.spend() / 1e3;
    out.printed = host.printed;
    if (out.message !== undefined || out.fault) break;
  }
  return out;
}

// What stopped it?
export function whatStopped(error, seconds) {
  const { kind, text, place } = error;
  if (kind === 'failed') return { message: text };
  if (kind === 'asserted') return { fault: `breaks a rule that is asserted, ${text}`, place };
  if (kind === 'memory') return { fault: memoryFault(text), place };
  if (kind === 'exit') return { message: 'Your code ends the whole program (exit): a function has to return.' };
  if (kind === 'prints') return { message: 'Your code prints without end.' };
  if (kind === 'endless') return { endless: seconds, fault: 'does not end' };
  if (error instanceof RangeError || /call stack|too much recursion/.test(error.message)) return { fault: DEEPER };
  // So many calls that the stack has come to its end.
  if (/out of bounds/.test(error.message) && error.stack.split('wasm-function').length > DEEP - 5) return { fault: DEEPER };
  if (/out of bounds/.test(error.message)) return { fault: 'follows a pointer that leads nowhere (a segmentation fault)' };
  if (/divide by zero/.test(error.message)) return { fault: 'does what C leaves undefined: division by zero' };
  return { fault: `stops the program: ${error.message}` };
}

// --- Sentences ----------------------------------------------------------------------

const isMine = place => place.file.endsWith('mine.c');

// Where it stood: the first line of the reader's own; of a test without end also
// from where that was called.
export function placed(out, source) {
  if (out.place) return `${out.place.file.replace(/.*\/(?=mine\.c)/, '')}, line ${out.place.line}`;
  const own = (out.places ?? []).filter(isMine);
  if (!out.endless) return own.length ? `mine.c, line ${own[0].line}` : '';
  const test = (out.places ?? []).find(place => place.file.endsWith(source));
  const ways = own.map(place => place.line).filter((line, k, all) => line !== all[k - 1]).slice(0, 5);
  if (!ways.length) return '';
  return `mine.c, line ${ways.join(', called from line ')}${test ? `, called from ${source}, line ${test.line}` : ''}`;
}

// "rank(b): got 6, wanted 5" for Check's "Assertion 'rank(b) == 5' failed: rank(b) == 6,
// 5 == 5"; what is only claimed, and any other message, as it is.
const COMPARED = [['==', ''], ['!=', 'not '], ['<=', 'at most '], ['>=', 'at least '], ['<', 'less than '], ['>', 'more than ']];
export function compared(text) {
  const [, held] = text.match(/^Assertion '(.*)' failed$/s) ?? [];
  if (held) return `this should hold, and does not: ${held}`;
  const [, claim, rest] = text.match(/^Assertion '(.*)' failed: (.*)$/s) ?? [];
  for (const [op, word] of claim ? COMPARED : []) {
    const at = claim.indexOf(` ${op} `);
    if (at < 0) continue;
    const left = claim.slice(0, at), right = claim.slice(at + op.length + 2);
    if (!rest.startsWith(`${left} == `)) continue;
    const both = rest.slice(left.length + 4), from = both.indexOf(`, ${right} == `);
    if (from < 0) continue;
    const is = both.slice(from + right.length + 6);
    return `${left}: got ${both.slice(0, from)}, wanted ${word}${is}${is === right ? '' : ` (${right})`}`;
  }
  return text;
}

function sentence(out, facts) {
  if (!out.fault) return compared(out.message) + (/[^a-z]-?nan[^a-z(]/.test(out.message + ' ') && !/wanted[^.]*nan/.test(compared(out.message)) ? '\n(nan is no number: 0 was divided by 0, or a root taken of less than 0.)' : '');
  const place = placed(out, facts.source);
  const test = (out.places ?? []).find(one => one.file.endsWith(facts.source));
  if (out.endless && !place && test) return `The test ${out.fault}: what your code gives keeps it waiting, ${facts.source}, line ${test.line}.`;
  return `Your code ${out.fault}${place ? ': ' + place : ''}.`;
}

// What is told of all outcomes, test -> out: { pass, ran, good, first, line, sentence,
// printed, comment, others, left }.
export function tell(facts, tests, outcomes) {
  const ran = [...outcomes.keys()], bad = name => outcomes.get(name).fault || outcomes.get(name).message !== undefined;
  const queue = [...facts.first.filter(name => outcomes.has(name)), ...ran.filter(name => !facts.first.includes(name))];
  const failed = queue.filter(bad), [first, ...others] = failed;
  const told = { name: facts.name, pass: !failed.length && ran.length > 0, ran: ran.length, good: ran.length - failed.length, left: tests.length - ran.length };
  if (!first) return told;
  const out = outcomes.get(first);
  return { ...told, first, source: facts.source, line: facts.tests[first]?.line, sentence: sentence(out, facts), place: out.place && isMine(out.place) ? out.place : (out.places ?? []).find(isMine),
    printed: out.printed.split('\n').filter(Boolean).slice(0, PRINTED).join('\n'), comment: facts.tests[first]?.comment ?? '', others };
}

const LEAST = 2, TIMES = 20;        // s; as long as the book's own answer takes
// All tests of a program, told one after the other to `tell`: test -> out.  After one
// without end the others are not tried.
async function runAll(program, files, tests, allowed, told) {
  const outcomes = new Map();
  for (const test of tests) {
    const out = await run(program, files, test, allowed(test.name));
    outcomes.set(test.name, out);
    told?.(outcomes.size, tests.length, test.name, out);
    if (out.endless) break;
  }
  return outcomes;
}

// The judge: as exercises/judge.sh has it.  What was stopped is timed with the
// book's own answer (a program as well, made when it is asked for), and has three
// times what is allowed: what ends by then is too slow.
export async function judge(facts, files, wasm, makeAnswer, told) {
  const program = await load(wasm), tests = await list(program, files, facts.leave);
  let outcomes = await runAll(program, files, tests, () => LEAST, told);
  if ([...outcomes.values()].some(out => out.endless)) {
    const ours = await runAll(await load(await makeAnswer()), files, tests.slice(0, outcomes.size), () => 600);
    const own = name => ours.get(name)?.seconds ?? 0, most = name => Math.max(LEAST, TIMES * own(name));
    outcomes = await runAll(program, files, tests, name => 3 * most(name), told);
    for (const [name, out] of outcomes) {
      if (out.endless) out.fault = `does not end (stopped after ${short(out.endless)} seconds of computing, where the book's own answer takes ${short(own(name))})`;
      else if (!out.fault && out.seconds > most(name) && ours.has(name))
        out.fault = `is too slow (${short(out.seconds)} seconds of computing, where the book's own answer takes ${short(own(name))}, and ${short(most(name))} are allowed)`;
    }
  }
  return tell(facts, tests, outcomes);
}

// What the desk prints.
export function asText(told) {
  const indented = (text, by) => text.replace(/^(?=.)/gm, by);
  if (!told.ran) return `${told.name}: no test has run.`;
  if (told.pass) return `${told.name}: all ${told.ran} tests pass.`;
  let text = `${told.name}: ${told.good} of ${told.ran} tests pass.  The first that does not:\n\n  ${told.first}  (${told.source}, line ${told.line})\n${indented(told.sentence, '  ')}\n`;
  if (told.printed) text += `\n  Your code printed:\n${indented(told.printed, '      ')}\n`;
  if (told.comment) text += `\n  The test's own comment:\n${indented(told.comment, '      ')}\n`;
  if (told.others.length) text += `\n  The others: ${told.others.join(', ')}.\n`;
  if (told.left) text += `\n  ${told.left} more were not tried.\n`;
  return text;
}
