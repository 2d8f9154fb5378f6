// compiler.js - the compiler and the linker in the page, with the flags of the desk.

import { runClang, commands, Exit } from '@yowasp/clang';

// The reader's own is watched as on a desk, and optimised so little that what nobody
// reads or frees is still there to be seen: what it reads and writes (our own malloc
// is judge_page.c), what C leaves undefined, and the turns of its loops.
const WARNINGS = ['-Wall', '-Wextra', '-Wconversion', '-Wshadow', '-Wno-unused-parameter', '-Wno-unused-function', '-Wno-unused-const-variable'];
const EXACT = ['--target=wasm32-wasip1', '-std=c11', '-msimd128', '-ffp-contract=off', '-fno-math-errno', '-fno-trapping-math'];
const SHADOW = 0x10000000;      // as in judge_page.c: there it begins, and has an eighth of that
const BLOCKS = 0x400000;        // and behind it a list of what malloc has given
const INSIDE = ['asan-instrumentation-with-call-threshold=0', `asan-mapping-offset=${SHADOW}`].flatMap(flag => ['-mllvm', `-${flag}`]);
const WATCHED = ['-O1', '-fno-inline', ...['malloc', 'calloc', 'realloc', 'free'].map(name => `-fno-builtin-${name}`), '-gline-tables-only', '-gdwarf-4', '-fsanitize=undefined', '-fno-sanitize=function,vptr,float-cast-overflow,pointer-overflow', '-fno-sanitize-recover=all',
  '-Xclang', '-fsanitize=address', '-Xclang', '-fsanitize-address-use-after-return=never', ...INSIDE];
const COUNTED = ['-fsanitize-coverage=trace-pc,edge,no-prune', '-Wno-deprecated', '-fno-finite-loops'];
const LINKED = ['--no-entry', '--gc-sections', '--stack-first', '-z', 'stack-size=1048576'];
const SHADED = [`--initial-memory=${SHADOW / 8 * 9 + BLOCKS}`];
const LIBRARIES = ['-L/usr/lib/wasm32-wasip1', '-lc', '-lm', '/usr/lib/wasm32-unknown-wasip1/libclang_rt.builtins.a'];

// "mine.c:12:5: error: text", and the lines below it, up to the next.
const MESSAGE = /^(?:\.\/)?([\w./-]+):(\d+):(\d+): (?:fatal )?(error|warning|note): (.*)$/;
export function messagesOf(text) {
  const all = [];
  for (const line of text.split('\n')) {
    const found = line.match(MESSAGE);
    if (found) all.push({ file: found[1], line: +found[2], column: +found[3], kind: found[4], text: found[5].replace(/ \[-W[^\]]*\]$/, ''), more: [] });
    else all.at(-1)?.more.push(line);
  }
  return all;
}

async function call(command, args, files) {
  let text = '';
  const note = bytes => { if (bytes) text += new TextDecoder().decode(bytes); };
  try { return { files: await command(args, files, { stdout: note, stderr: note, fetchProgress() {} }), text }; } catch (error) {
    if (error instanceof Exit) return { text };
    throw error;
  }
}

// The reader's file to an object: { object or nothing, text, messages }.
export async function compile(source, headers, isWatched = true, more = []) {
  const flags = isWatched ? WATCHED : ['-O2', '-gline-tables-only', '-gdwarf-4'];
  const { files, text } = await call(runClang, ['clang', ...EXACT, ...WARNINGS, ...flags, ...COUNTED, ...more, '-Iheaders', '-c', 'mine.c', '-o', 'mine.o'],
    { 'mine.c': source, headers });
  return { object: files?.['mine.o'], text, messages: messagesOf(text) };
}

// Objects to a program: { wasm or nothing, text }.
export async function link(objects, { exported = [], slim = false, isShaded = false } = {}) {
  const { files, text } = await call(commands['wasm-ld'], [...LINKED, ...exported.map(name => `--export=${name}`), ...(slim ? ['--strip-debug'] : []), ...(isShaded ? SHADED : []), ...Object.keys(objects), ...LIBRARIES, '-o', 'program.wasm'], objects);
  return { wasm: files?.['program.wasm'], text };
}
