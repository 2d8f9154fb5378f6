// core.js - one figure's WebAssembly: unpacks it, calls it, reads its lists, and
// says in a sentence what a module did that does not return.

const CHARTS = 3, LINES = 4, CURVE = 256;
const FUEL = 20e6;              // turns of loops in a frame; a frame takes up to 1e6
const FIRST = 200e6;            // of all that is not a frame: a body may be built

const text = (bytes, at) => {
  let end = at;
  while (bytes[end]) end++;
  return new TextDecoder().decode(bytes.subarray(at, end));
};

async function unpack(base64) {
  const letters = atob(base64), packed = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) packed[i] = letters.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
}

// Files and clocks are not there: every call of the system answers "no".
const system = new Proxy({}, { get: () => () => 8 });

// Of gzip in base64, or of the bytes themselves.
export async function makeCore(wasm) {
  const core = { said: '' };
  const page = {
    failed(what, file, line, where) {
      const bytes = new Uint8Array(core.x.memory.buffer);
      core.said = `${text(bytes, where)} asserts that ${text(bytes, what)}, and it is not so ` +
        `(${text(bytes, file).replace(/.*\//, '')}, line ${line})`;
    },
    endless() { core.endless = true; },
  };
  const { instance } = await WebAssembly.instantiate(typeof wasm === 'string' ? await unpack(wasm) : wasm,
    { page, wasi_snapshot_preview1: system });
  core.x = instance.exports;
  core.call = (name, ...values) => {
    core.fuel = name === 'step' ? FUEL : FIRST;
    core.x.fuel(core.fuel);
    return core.x[name](...values);
  };
  core.hash = () => BigInt.asUintN(64, core.x.hash()).toString(16).padStart(16, '0');
  core.draw = () => read(core, core.at = core.call('draw'));
  core.peek = () => read(core, core.at);
  return core;
}

// The lists of live_page.h.  Views die when memory grows, so they are made at
// every reading.
function read(core, at) {
  const buffer = core.x.memory.buffer;
  const whole = new Int32Array(buffer), bytes = new Uint8Array(buffer);
  let next = at / 4;
  const list = () => {
    const [where, count] = [whole[next], whole[next + 1]];
    next += 3;
    return new Float32Array(buffer, where, count);
  };
  const out = {};
  for (const name of ['flat', 'place', 'normal', 'tint', 'weave', 'ball', 'tube', 'edge', 'edgeTint'])
    out[name] = list();
  out.corner = new Int32Array(buffer, whole[next], whole[next + 1]);
  const letter = whole[next + 3];
  out.text = where => text(bytes, letter + where);
  next += 8;
  out.points = whole.subarray(next, next + CHARTS * LINES);
  next += CHARTS * LINES;
  out.said = text(bytes, 4 * next);
  out.lit = text(bytes, 4 * next + 200);
  const double = Math.ceil((4 * next + 280) / 8), all = new Float64Array(buffer);
  out.hit = all[double];
  out.value = (chart, line) => all[double + 1 + chart * LINES + line];
  const curve = double + 1 + CHARTS * LINES;
  out.curve = (chart, line) => {
    const k = chart * LINES + line;
    return all.subarray(curve + k * CURVE, curve + k * CURVE + out.points[k]);
  };
  return out;
}

// What stopped?  The names of functions are in the stack, if the build kept them.
export function sentence(core, error) {
  if (core.said) return core.said;
  const names = [...String(error.stack).matchAll(/(?:at |^)(?:[\w.$]*\.)?([\w$]+)(?: \(|@)(?:wasm|[^)\n]*wasm-function)/gm)]
    .map(found => found[1]);
  const own = names.filter(name => !/^(page_|__)/.test(name));
  const where = own[0] || 'a function';
  if (core.endless) return `${where} goes on and on: ${core.fuel / 1e6} million turns in one ${core.fuel === FUEL ? 'frame' : 'call'}`;
  if (/call stack|too much recursion/.test(error.message)) return `${where} calls itself without end`;
  if (/out of bounds/.test(error.message)) return `${where} reads or writes where nothing is`;
  if (/unreachable/.test(error.message)) return `${where} gives up`;
  return `${where}: ${error.message}`;
}
