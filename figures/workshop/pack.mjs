// pack.mjs - what the workshop of the page is sent, as plain scripts:
//   node pack.mjs exercise NN-name TESTS.o ANSWER.o SOURCE TESTS
//     what is read of it; what judges it goes to TESTS-judged.js
//   node pack.mjs figure NAME MODULE.c OBJECT...    what a live figure is linked of
//   node pack.mjs stages PRINTED SOURCE OUT         those of the little program, of SOURCE-NNa.c: OUT-NNa.js
//   node pack.mjs headers HEADER...
//   node pack.mjs worker FILE                       a script as a string
//   node pack.mjs compiler FOLDER OUT               the compiler in pieces: OUT/clang-NN.js

import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename } from 'node:path';
import { gzipSync } from 'node:zlib';

const packed = bytes => gzipSync(bytes, { level: 9 }).toString('base64');
const text = file => readFileSync(file, 'utf8');

// The lines of `exercise`: word -> all that follows it.
function plan(file) {
  const of = {};
  for (const line of text(file).split('\n')) {
    const [word, ...rest] = line.split(/\s+/).filter(Boolean);
    if (word) (of[word] ??= []).push(...rest);
  }
  return of;
}

// Where each test stands, and what its comment says, above it or at its head: as in
// exercises/tell.awk.
function testsOf(source) {
  const tests = {};
  let above = [], inside = null;
  source.split('\n').forEach((line, k) => {
    const test = line.match(/^START_TEST\((\w+)/)?.[1], comment = line.match(/^[ \t]*\/\/ ?(.*)/)?.[1] ?? null;
    if (test) {
      inside = tests[test] = { line: k + 1, comment: above };
      above = [];
    } else if (comment !== null && /^[ \t]*\/\/( |$)/.test(line)) (inside ? inside.comment : above).push(comment);
    else if (!line.startsWith('{')) { inside = null; above = []; }
  });
  for (const test of Object.values(tests)) test.comment = test.comment.join('\n');
  return tests;
}

const cut = (task, source, show) => execFileSync('awk', ['-v', `empty=${task.empty?.join(' ') ?? ''}`, '-v', `remove=${task.remove?.join(' ') ?? ''}`,
  '-v', `show=${show ? 1 : ''}`, '-v', `derived=${task.after ? 1 : ''}`, '-f', 'exercises/cut.awk', source], { encoding: 'utf8' });

function hintsOf(file) {
  return text(file).split(/^\d+\. /m).slice(1).map(hint => hint.replace(/\s*\n\s*/g, ' ').trim());
}

function exercise(id, object, answer, source, tests) {
  const dir = `exercises/${id}`, task = plan(`${dir}/exercise`);
  const headers = Object.fromEntries(readdirSync(dir).filter(file => file.endsWith('.h')).map(file => [file, text(`${dir}/${file}`)]));
  const data = ['tests/data/pairs-all.txt'].filter(file => readFileSync(object).includes(file));
  const facts = { name: id.replace('-', '/'), module: task.module?.[0], stub: cut(task, source), solution: cut(task, source, true), hints: hintsOf(`${dir}/hints`),
    headers, data, first: task.first ?? [], leave: task.leave ?? [], tests: testsOf(text(tests)), source: tests };
  writeFileSync(object.replace(/\.o$/, '-judged.js'),
    `Object.assign(tumble.workshop[${JSON.stringify(id)}],${JSON.stringify({ judge: packed(readFileSync(object)), answer: packed(readFileSync(answer)) })});\n`);
  return `tumble.workshop[${JSON.stringify(id)}]=${JSON.stringify(facts)};`;
}

const objects = files => Object.fromEntries(files.map(file => [basename(file), packed(readFileSync(file))]));
const figure = (name, ...files) => `tumble.workshop.figure=${JSON.stringify({ name, objects: objects(files) })};`;
const headers = (...files) => `tumble.workshop.headers=${JSON.stringify(Object.fromEntries(files.map(file => [basename(file), text(file)])))};`;
// Of each stage its program, what that prints, the hash of it, and what it claims.
function stages(printed, from, to) {
  const lines = text('chapters/little/stages.txt').split('\n');
  for (const one of text(printed).split(/^= /m).slice(1)) {
    const [, name, hash, says] = one.match(/^(\S+) \S+ (\S+)\n(.*)$/s);
    const [, , ...claims] = lines.find(line => line.startsWith(`${name} `)).split('|').map(part => part.trim());
    const facts = { source: text(`${from}-${name}.c`), printed: says, hash, claims };
    writeFileSync(`${to}-${name}.js`, `(tumble.workshop.stages||={})[${JSON.stringify(name)}]=${JSON.stringify(facts)};\n`);
  }
  return '';
}

// What tests read, or are linked with.
const data = (...files) => files.map(file => `tumble.workshop[${JSON.stringify(basename(file))}]=${JSON.stringify(packed(readFileSync(file)))};`).join('\n');
const worker = file => `tumble.workshop.worker=${JSON.stringify(text(file))};`;

// --- The compiler -------------------------------------------------------------------

// Of the headers and libraries that came with it what C needs: an entry of a tar is
// a head of 512 bytes, and its bytes filled up to as many times 512.
const NEEDLESS = /c\+\+|threads|wasip2|wasm32-wasi\/|^share|cuda|hip_|hlsl|opencl|openmp|ppc_wrappers|llvm_|zos|(intrin|_math|altivec|arm\w*|riscv\w*|sifive\w*|vec\w+|s390\w*|mm\w*|ia32\w*|msa|htm\w*|larchintrin|amdgpu\w*|nvptx\w*|spirv\w*|gpu\w*|keylocker\w*|hexagon\w*)\.h$/;
function slim(tar) {
  const kept = [];
  for (let at = 0; at < tar.length && tar[at];) {
    const field = (from, size) => tar.toString('latin1', at + from, at + from + size).replace(/\0.*/s, '');
    const name = (field(345, 155) && field(345, 155) + '/') + field(0, 100), size = parseInt(field(124, 12), 8) || 0;
    const next = at + 512 + Math.ceil(size / 512) * 512;
    if (field(156, 1) === '5' || !NEEDLESS.test(name)) kept.push(tar.subarray(at, next));
    at = next;
  }
  return Buffer.concat([...kept, Buffer.alloc(1024)]);
}

// The program packs by a twentieth better than the library does; -9 takes half as long
// again as -7, for a thousandth.
const gzip = bytes => execFileSync('gzip', ['-7nc'], { input: bytes, maxBuffer: 1e9 });
const PIECE = 786432;           // bytes of each, a megabyte of letters
function compiler(folder, out) {
  const files = {}, all = [];
  let at = 0;
  for (const name of readdirSync(folder).filter(name => /wasm$|tar$/.test(name)).sort()) {
    const bytes = readFileSync(`${folder}/${name}`), zip = gzip(/tar$/.test(name) ? slim(bytes) : bytes);
    files[name] = [at, at += zip.length];
    all.push(zip);
  }
  const whole = Buffer.concat(all), pieces = Math.ceil(whole.length / PIECE);
  for (let k = 0; k < pieces; k++)
    writeFileSync(`${out}/clang-${String(k).padStart(2, '0')}.js`, `tumble.workshop.piece(${k},"${whole.toString('base64', k * PIECE, Math.min((k + 1) * PIECE, whole.length))}");\n`);
  return `tumble.workshop.compiler=${JSON.stringify({ pieces, bytes: whole.length, files })};`;
}

const [form, ...rest] = process.argv.slice(2);
process.stdout.write({ exercise, figure, stages, headers, data, worker, compiler }[form](...rest) + '\n');
