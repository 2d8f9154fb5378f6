// past.js - what was done to a figure, and when: so that it can go back by a frame, and
// so that an address can say all of it.  The same hands make the same bits, so a frame
// of the past is an older one, and the steps from there once more.

const EVERY = 60, MOST = 10;    // frames from one memory that is kept to the next; of these
const ROOM = 256e6;             // bytes of all that are kept, but for the last
const LONGEST = 6000;           // letters of an address

const copy = core => core && new Uint8Array(core.x.memory.buffer).slice();
function put(core, bytes) {
  if (!core) return;
  const now = new Uint8Array(core.x.memory.buffer);
  now.set(bytes);
  now.fill(0, bytes.length);
}

export class Past {
  constructor(figure) { this.figure = figure; this.clear(); }

  // From here on the figure has begun.
  clear() {
    this.kept = [];
    this.acts = [];
    this.due = null;
  }

  // Before a step.
  keep() {
    const { frames, core, ghost } = this.figure;
    if (frames % EVERY || this.kept.at(-1)?.frame === frames) return;
    this.kept.push({ frame: frames, acts: this.acts.length, core: copy(core), ghost: copy(ghost) });
    const bytes = () => this.kept.reduce((sum, one) => sum + one.core.length + (one.ghost?.length ?? 0), 0);
    while (this.kept.length > MOST || (this.kept.length > 1 && bytes() > ROOM)) this.kept.shift();
  }

  note(name, values) { this.acts.push([this.figure.frames, name, ...values]); }

  // One frame less.  false: so far back nothing is known.
  back() {
    const to = this.figure.frames - 1;
    return this.goTo(to, this.acts.filter(([frame]) => frame < to));
  }

  // To before what the reader did last, which a turn of a dial is not: that stays.
  undo() {
    const { acts } = this, isDrag = k => /^(move|release)$/.test(acts[k]?.[1]);
    let first = acts.findLastIndex(([, name]) => name !== 'turn');
    if (first < 0) return false;
    while (isDrag(first) && acts[first - 1]?.[1] === 'move') first--;
    const turns = acts.slice(first).filter(([, name]) => name === 'turn');
    if (!this.goTo(acts[first][0], acts.slice(0, first))) return false;
    for (const [, name, ...values] of turns) {
      this.figure.both(name, ...values);
      this.note(name, values);
    }
    return true;
  }

  // The figure as it was in a frame, of all acts after these alone.
  goTo(to, acts) {
    const { figure } = this;
    while (this.kept.length && (this.kept.at(-1).frame > to || this.kept.at(-1).acts > acts.length)) this.kept.pop();
    const from = this.kept.at(-1);
    if (!from) return false;
    put(figure.core, from.core);
    put(figure.ghost, from.ghost);
    const again = acts.slice(from.acts);
    for (let frame = from.frame; frame <= to; frame++) {
      for (const [at, name, ...values] of again) if (at === frame) figure.both(name, ...values);
      if (frame < to) figure.both('step');
    }
    this.acts = acts;
    figure.charts.forEach(chart => chart.drop(figure.frames - to));
    figure.both('measure');
    figure.frames = to;
    return true;
  }

  // --- As an address ------------------------------------------------------------------
  // What is turned, and what was done in which frame.
  async address() {
    const { turned, name } = this.figure;
    const said = JSON.stringify([Object.entries(turned).map(([dial, value]) => [+dial, value]), this.acts]);
    const packed = await letters(said);
    return packed.length > LONGEST ? null : `${location.href.replace(/#.*/, '')}#${name}=${packed}`;
  }

  // What an address says of this figure is done as its frames come.
  async take(packed) {
    const [turned, acts] = JSON.parse(await words(packed));
    turned.forEach(([dial, value]) => this.figure.set(dial, value));
    this.figure.both('begin');
    this.figure.restart();
    this.due = acts;
  }
  replay() {
    while (this.due?.[0]?.[0] === this.figure.frames) {
      const [, name, ...values] = this.due.shift();
      this.figure.act(name, ...values);
    }
  }
}

const through = (stream, bytes) => new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer();
async function letters(text) {
  const bytes = new Uint8Array(await through(new CompressionStream('deflate-raw'), new TextEncoder().encode(text)));
  return btoa(String.fromCharCode(...bytes)).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
}
async function words(packed) {
  const bytes = Uint8Array.from(atob(packed.replace(/-/g, '+').replace(/_/g, '/')), letter => letter.charCodeAt(0));
  return new TextDecoder().decode(await through(new DecompressionStream('deflate-raw'), bytes));
}
