// lines.js - which line of C is at a place in a WebAssembly file?  Reads what the
// compiler wrote of it (.debug_line, of DWARF 4), as far as lines need it.

function reader(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const r = { at: 0, bytes };
  r.u8 = () => bytes[r.at++];
  r.i8 = () => view.getInt8(r.at++);
  r.u16 = () => view.getUint16((r.at += 2) - 2, true);
  r.u32 = () => view.getUint32((r.at += 4) - 4, true);
  r.leb = () => {
    let value = 0, shift = 0, byte;
    do { byte = r.u8(); value += (byte & 127) * 2 ** shift; shift += 7; } while (byte & 128);
    return value;
  };
  r.sleb = () => {
    let value = 0, shift = 0, byte;
    do { byte = r.u8(); value += (byte & 127) * 2 ** shift; shift += 7; } while (byte & 128);
    return byte & 64 ? value - 2 ** shift : value;
  };
  r.string = () => {
    const from = r.at;
    while (bytes[r.at]) r.at++;
    return new TextDecoder().decode(bytes.subarray(from, r.at++));
  };
  return r;
}

// Where the code begins, and the section of lines.
function sections(bytes) {
  const r = reader(bytes), out = {};
  for (r.at = 8; r.at < bytes.length;) {
    const id = r.u8(), size = r.leb(), from = r.at;
    if (id === 10) out.code = from;
    if (id === 0) {
      const length = r.leb(), name = new TextDecoder().decode(bytes.subarray(r.at, r.at + length));
      if (name === '.debug_line') out.lines = bytes.subarray(r.at + length, from + size);
    }
    r.at = from + size;
  }
  return out;
}

// The rows of one file's table: [place in the code, file, line], and a row without
// a line where a piece of code ends.
function readUnit(r, rows) {
  const end = r.u32() + r.at, version = r.u16(), after = r.u32() + r.at;
  if (version !== 4) { r.at = end; return; }
  r.at += 3;
  const base = r.i8(), range = r.u8(), first = r.u8();
  const sizes = [0, ...Array.from({ length: first - 1 }, () => r.u8())];
  const folders = [''], files = [''];
  for (let name; (name = r.string());) folders.push(name + '/');
  for (let name; (name = r.string());) { files.push((folders[r.leb()] ?? '') + name); r.leb(); r.leb(); }
  r.at = after;
  let at = 0, file = 1, line = 1;
  const row = last => rows.push([at, last ? '' : files[file], last ? 0 : line]);
  while (r.at < end) {
    const op = r.u8();
    if (op >= first) {
      at += Math.floor((op - first) / range);
      line += base + (op - first) % range;
      row();
    } else if (op === 0) {
      const next = r.leb() + r.at, what = r.u8();
      if (what === 1) { row(true); at = 0; file = 1; line = 1; }
      if (what === 2) at = r.u32();
      r.at = next;
    } else if (op === 1) row();
    else if (op === 2) at += r.leb();
    else if (op === 3) line += r.sleb();
    else if (op === 4) file = r.leb();
    else if (op === 8) at += Math.floor((255 - first) / range);
    else if (op === 9) at += r.u16();
    else for (let k = 0; k < sizes[op]; k++) r.leb();
  }
}

// A function that answers with { file, line } for a place in the file, or null.
export function linesOf(wasm) {
  const { code, lines } = sections(wasm), rows = [];
  if (lines) for (const r = reader(lines); r.at < lines.length;) readUnit(r, rows);
  rows.sort((a, b) => a[0] - b[0] || !a[2] - !b[2]);
  return place => {
    let low = 0, high = rows.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (rows[middle][0] <= place - code) low = middle + 1; else high = middle;
    }
    const [, file, line] = rows[low - 1] ?? [];
    return line ? { file, line } : null;
  };
}
