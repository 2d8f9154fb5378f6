// main.js - makes the live figures of a page: <figure data-live="orbit"> gets a
// stage, dials, charts and a foot line; its WebAssembly comes when it is near.  Of
// <figure data-small="orbit" data-dial="0" data-set="1:4"> there is the stage, its
// buttons, and at most that dial, with dial 1 turned to 4 from the start; with data-first
// it moves as soon as it can.  One without charts is small as well, and has its one dial.
// One that is no part of another may have the code that it runs, a line lit.

import style from './live.css';
import { make, dark } from './node.js';
import { makeCore, sentence } from './core.js';
import { makeLoop, still } from './loop.js';
import { makeDial, button, tool } from './dials.js';
import { Chart } from './chart.js';
import { Flat } from './flat.js';
import { Code } from './code.js';
import { Past } from './past.js';
import { film } from './film.js';
import { Race } from './race.js';

const FRAMES = 60;              // after which the hash is shown
const NEAR = '700px';           // so far below the window a figure is made ready
const PIECE = 8, CALM = 1500;   // ms: of work at a time; after the page has come
const folder = document.currentScript.src.replace(/[^/]*$/, '');
const scripts = {};
const tumble = window.tumble ||= {};
tumble.wasm ||= {};

// The folder may be read from a disk, where only plain scripts are let in.
const script = name => scripts[name] ||= new Promise((done, failed) => document.head.append(
  make('script', { src: `${folder}${name}.js`, onload: done, onerror: () => failed(Error(`${name}.js is not there`)) })));

const SOON = 400;               // ms
const SLOW = 1 / 4;             // of the clock

const pause = ms => new Promise(done => setTimeout(done, ms));

class Figure {
  constructor(node, panel) {
    Object.assign(this, { node, panel, frames: 0, touched: false, turned: [] });
    this.past = new Past(this);
    this.usual = this.variant = panel.dials[0]?.choices ? panel.dials[0].value : 0;
    node.classList.add('live-figure');
    this.name = panel.name;
    this.isSmall = 'small' in node.dataset || !panel.charts.length;
    node.classList.toggle('live-small', this.isSmall);
    this.stage = make('div', { class: 'live-stage' });
    const picture = node.querySelector('img');
    node.prepend(this.stage);
    if (picture) this.stage.append(picture);
    this.isFlat = panel.panes.length > 0;
    if (this.isFlat) this.stage.style.setProperty('--live-aspect', panel.panes.reduce((sum, box) => sum + box[2] / box[3], 0));
    this.furnish();
    this.loop = makeLoop(node, due => this.tick(due), playing => this.play.rename(playing ? 'Pause' : 'Play'));
  }

  // All but the stage stands from the start, so that no text jumps later.
  furnish() {
    const { panel } = this;
    const again = () => this.act('begin');
    const more = panel.buttons.map((name, k) => button(name, () => this.act('press', k), 'live-own'));
    const dials = panel.dials.map((dial, k) => makeDial(dial, value => this.turn(k, value)));
    this.inputs = dials;
    this.charts = this.isSmall ? [] : panel.charts.map((plan, k) => new Chart(this.node, plan, panel.charts[k - 1]));
    this.said = make('p', { class: 'live-said' });
    this.foot = make('p', { class: 'live-foot' });
    this.tools = this.makeTools(again);
    this.code = 'live' in this.node.dataset && panel.code && new Code(panel.code);
    this.stage.append(this.tools);
    if (this.isSmall) {
      const dial = 'small' in this.node.dataset ? dials[this.node.dataset.dial] : dials[0];
      this.play = this.tools.firstChild;
      const under = [dial || more.length ? make('div', { class: 'live-one' }, ...(dial ? [dial] : []), ...more) : '',
        'live' in this.node.dataset ? this.said : '', this.code ? this.code.node : ''];
      this.stage.after(...under.filter(Boolean));
    } else {
      this.play = button('Pause', () => this.loop.play(!this.loop.playing));
      this.play.rename = name => { this.play.textContent = name; };
      this.stage.after(
        make('div', { class: dials.some(dial => dial.matches('.live-long')) ? 'live-panel live-many' : 'live-panel' },
          make('div', { class: 'live-dials' }, make('div', { class: 'live-buttons' }, this.play, button('Start again', again), ...more), ...dials, this.said),
          make('div', { class: 'live-charts' }, ...this.charts.map(chart => chart.node))),
        ...(this.code ? [this.code.node] : []), this.foot);
    }
    this.tell('');
  }

  // What every stage has at its corner.
  makeTools(again) {
    const slow = tool('Slow', () => {
      this.loop.rate = this.loop.rate === 1 ? SLOW : 1;
      slow.setAttribute('aria-pressed', this.loop.rate !== 1);
    });
    slow.setAttribute('aria-pressed', false);
    const all = [slow, tool('Back by a frame', () => this.back()), tool('One frame', () => { this.loop.play(false); this.tick(1); })];
    if (!this.isSmall && !this.isFlat) all.push(tool('Take back what you did last', () => this.undo()));
    if (!this.isSmall) all.push(...this.makeShared());
    if (this.isSmall) all.unshift(tool('Pause', () => this.loop.play(!this.loop.playing)), tool('Start again', again));
    if (document.fullscreenEnabled) all.push(tool('Full screen', () => document.fullscreenElement ? document.exitFullscreen() : this.node.requestFullscreen()));
    return make('div', { class: 'live-tools' }, ...all);
  }

  // What a reader has done, for others: an address in which it is done again, and a film.
  makeShared() {
    const share = tool('Copy an address of this', async () => {
      const address = await this.past.address();
      if (!address) { this.tell('too much was done for an address'); return; }
      history.replaceState(null, '', address);
      const copied = await navigator.clipboard?.writeText(address).then(() => true, () => false);
      this.tell(`the address of this page says now what you did${copied ? ', and is copied' : ''}`);
    });
    const all = [share];
    if (!this.isFlat && window.MediaRecorder) all.push(film(this));
    return all;
  }

  async wake() {
    await Promise.all([script(this.name), this.isFlat || script('space')]);
    await this.fill();
    this.drawing.acted = (...what) => this.act(...what);
    this.drawing.again = () => this.draw();
    dark.addEventListener('change', () => { this.drawing.restyle(); this.draw(); });
    await this.beginAs();
    if (still()) this.tick(FRAMES - this.frames);
    else if ('first' in this.node.dataset) await this.reach(FRAMES);
    // What is chosen of many is in view.
    for (const one of this.node.querySelectorAll('.live-long :checked')) one.closest('div').scrollLeft = one.parentNode.offsetLeft - one.closest('div').offsetLeft - 16;
    this.node.dataset.ready = '1';
    this.loop.update();
  }

  // As the page wants it, or an address.
  async beginAs() {
    const { set } = this.node.dataset, [, said] = location.hash.match(RegExp(`^#${this.name}=(.+)$`)) ?? [];
    for (const one of set?.split(' ') ?? []) this.set(...one.split(':').map(Number));
    if (said && 'live' in this.node.dataset) await this.past.take(said).catch(() => {});
  }
  // A dial is turned by none of the reader's hands.
  set(dial, value) {
    const input = this.inputs[dial]?.querySelectorAll('input');
    if (input?.length === 1) { input[0].value = value; input[0].dispatchEvent(new Event('input')); }
    else if (input) { input[value].checked = true; this.turn(dial, value); }
  }

  // What begins under the reader's eyes goes on from its picture, which is of frame 60,
  // if that is near.
  async reach(frame) {
    const late = performance.now() + SOON;
    for (let from = performance.now(); this.frames < frame && from < late && !this.stopped;) {
      this.step();
      if (performance.now() - from < PIECE) continue;
      await pause(0);
      from = performance.now();
    }
    this.draw();
  }

  // A new memory, which has the page's colours, and nothing of what stopped.
  async fill() {
    const core = await makeCore(this.own ?? tumble.wasm[this.name]), ghost = this.own && await makeCore(tumble.wasm[this.name]);
    // Both at once: nothing may step what has not begun.
    Object.assign(this, { core, ghost, parted: 0 });
    this.stopped = undefined;
    delete this.node.dataset.trapped;
    this.node.querySelectorAll('.live-trap').forEach(node => node.remove());
    this.drawing ||= this.makeDrawing();
    this.drawing.core = this.core;
    this.drawing.ghost = this.ghost;
    this.drawing.restyle();
    this.both('start');
    this.draw();                // the core's lists have a place from now on
  }

  // What is done to the reader's own is done to the book's beside it, which is drawn
  // pale.  The answer of the reader's, if it came back.
  both(name, ...values) {
    this.ghost?.call(name, ...values);
    return this.guard(() => this.core.call(name, ...values));
  }

  // The first frame in which a bit of the reader's is another than the book's.
  compare() {
    if (!this.ghost || this.parted || this.stopped || this.core.hash() === this.ghost.hash()) return;
    this.parted = this.frames;
    this.node.dataset.parted = this.frames;
  }

  // Without WebGL the picture stays; charts and hash go on.
  makeDrawing() {
    const picture = this.node.querySelector('.live-stage img');
    picture?.remove();
    if (this.isFlat) return new Flat(this.node, this.stage, this.panel);
    try { return new tumble.Space(this.node, this.stage, this.panel); } catch {
      this.stage.replaceChildren(picture || 'This browser has no WebGL.');
      return { draw() {}, restyle() {} };
    }
  }

  // --- Frames ---------------------------------------------------------------------
  tick(due) {
    if (!this.core || this.stopped) return;
    for (let k = 0; k < due && !this.stopped; k++) this.step();
    if (due) this.draw();
  }

  step() {
    this.past.replay();
    this.past.keep();
    const from = performance.now();
    this.guard(() => this.core.call('step'));
    const took = this.took = performance.now() - from;
    this.ghost?.call('step');
    this.frames++;
    this.slow = this.frames < 6 ? took : 0.9 * this.slow + 0.1 * took;
    this.both('measure');
    if (this.stopped) return;
    this.note();
    this.compare();
    if (this.frames === FRAMES) this.showHash(this.core);
  }

  back() {
    this.loop.play(false);
    if (this.core && !this.stopped && this.past.back()) this.isEarlier();
  }

  undo() {
    if (!this.core || this.stopped) return;
    if (this.past.undo()) this.isEarlier(); else this.tell('there is nothing to take back, or it was too long ago');
  }

  isEarlier() {
    if (this.parted > this.frames) {
      this.parted = 0;
      delete this.node.dataset.parted;
    }
    this.draw();
  }

  note() {
    const now = this.core.peek();
    this.charts.forEach((chart, c) => chart.colours.forEach((_, line) => {
      if (chart.plan.over) chart.set(line, now.curve(c, line));
      else chart.add(line, chart.plan.time ? (this.frames < 6 ? NaN : this.slow) : now.value(c, line));
    }));
  }

  draw() {
    if (this.stopped) return;
    const lists = this.guard(() => this.core.draw());
    if (!lists) return;
    this.drawing.draw(lists, this.ghost?.draw());
    if (this.said.textContent !== lists.said) this.said.textContent = lists.said;
    if (this.code) this.code.light(lists.lit);
    for (const chart of this.charts) chart.draw();
  }

  // --- What the reader does -------------------------------------------------------
  restart() {
    this.frames = 0;
    this.past.clear();
    this.slow = this.parted = 0;
    delete this.node.dataset.parted;
    this.charts.forEach(chart => chart.clear());
    this.tell('');
  }

  // What stopped has a memory that nothing may be read from any more: a new one
  // begins, with the dials as they stand.
  async renew() {
    await this.fill();
    this.turned.forEach((value, dial) => this.both('turn', dial, value));
    this.act('begin');
    this.loop.play(!still());
  }

  // The reader's own in the place of the book's: WebAssembly that the workshop has
  // made, as it is.
  async swap(wasm) {
    this.own = wasm;
    this.touched = false;
    delete this.node.dataset.hash;
    if (this.core) {
      await this.fill();
      this.turned.forEach((value, dial) => this.both('turn', dial, value));
      this.act('begin');
      this.loop.play(!still());
    }
    await this.prove();
  }

  act(name, ...values) {
    if (this.core && this.stopped && name === 'begin') {
      this.renew().catch(error => console.error(error));
      return;
    }
    if (!this.core || this.stopped) return;
    if (name === 'begin') this.restart(); else this.past.note(name, values);
    if (name !== 'begin' && (this.frames < FRAMES || name === 'move')) this.touched = true;
    this.both(name, ...values);
    this.redraw();
  }

  turn(dial, value) {
    this.turned[dial] = value;
    if (!this.core || this.stopped) return;
    if (dial === 0 && this.panel.dials[0].choices) this.variant = value; else this.touched = true;
    if (this.both('turn', dial, value)) this.restart(); else this.past.note('turn', [dial, value]);
    this.redraw();
  }

  // A figure that stands still shows what was turned all the same.
  redraw() {
    if (this.loop.playing && this.loop.seen) return;
    if (still()) while (this.frames < FRAMES && !this.stopped) this.step(); else this.note();
    this.draw();
  }

  // --- The foot line ----------------------------------------------------------------
  // Of the run that is seen, or of the one beside it.
  showHash(core) {
    const hash = core.hash(), isBeside = core !== this.core, isUsual = this.variant === this.usual;
    const isOurs = isUsual && !this.touched;
    if (isBeside || isOurs) this.node.dataset.hash = hash;
    if (isBeside && !isOurs) return;
    const wants = isUsual && this.node.dataset.wants || this.panel.wants[this.variant];
    const short = hash.slice(0, 8) + '…';
    if (this.touched) this.tell(`${short} with your settings`, hash);
    else if (wants === '') this.tell(`${short}, on this machine: the scene asks its C library for sines, and their last digits differ`, hash);
    else if (this.parted && !isBeside) this.tell(`${short}; the first bits are other than the book’s in frame ${this.parted}. The pale one is the book’s.`, hash);
    else if (hash === wants && this.own) this.tell(`${short}: yours, bit for bit`, hash);
    else if (hash === wants) this.tell(`${short} to the last bit as on your machine`, hash);
    else this.tell(`${short}; the book's own modules give ${wants.slice(0, 8)}… (sums in another order are enough for that)`, hash);
  }

  // The first 60 frames once more, beside what is seen and in short pieces: so the
  // hash depends neither on how fast this machine draws nor on what is in view.
  async prove() {
    await script(this.name);
    const core = await makeCore(this.own ?? tumble.wasm[this.name]);
    core.call('start');
    for (let frame = 0, from = performance.now(); frame < FRAMES; frame++) {
      core.call('step');
      if (performance.now() - from < PIECE) continue;
      await pause(0);
      from = performance.now();
    }
    this.showHash(core);
  }

  tell(words, hash = '') {
    this.foot.textContent = `Frame 60: ${words || '…'}`;
    this.foot.title = hash;
  }

  // Calls into the figure's own C, and says what happened if it does not return.
  guard(call) {
    try { return call(); } catch (error) {
      this.stopped = sentence(this.core, error);
      this.node.dataset.trapped = this.stopped;
      this.loop.play(false);
      this.stage.after(make('p', { class: 'live-trap', role: 'alert' }, `Stopped: ${this.stopped}.`));
      return undefined;
    }
  }
}

const fail = node => error => { node.dataset.failed = error.message; console.error(error); };

// A section of the page that is not laid out before it is near has a height that
// is guessed: what leads to a figure in it would miss it, and it would not run.
function layOut(node) {
  const section = node.closest('section.level2');
  if (section) section.style.contentVisibility = 'visible';
}

function begin() {
  document.head.append(make('style', {}, style));
  const near = new IntersectionObserver(all => all.filter(one => one.isIntersecting).forEach(({ target }) => {
    near.unobserve(target);
    target.live.wake().catch(fail(target));
  }), { rootMargin: NEAR });
  const nameOf = node => node.dataset.live ?? node.dataset.small;
  const figures = [...document.querySelectorAll('[data-live], [data-small]')].filter(node => tumble.panels?.[nameOf(node)]);
  for (const node of figures) node.live = new Figure(node, tumble.panels[nameOf(node)]);
  for (const node of document.querySelectorAll('[data-race]')) {
    new Race(node, tumble.panels[node.dataset.race], Figure);
    figures.push(...node.querySelectorAll('[data-small]'));
  }
  const told = figures.find(node => 'live' in node.dataset && location.hash.startsWith(`#${node.dataset.live}=`));
  // What moves comes after all that is read.
  const watch = async () => {
    for (const node of figures) {
      if ('first' in node.dataset) { node.live.wake().catch(fail(node)); continue; }
      layOut(node);
      near.observe(node);
    }
    told?.scrollIntoView({ block: 'center' });
    await pause(CALM);
    // A module that does not return says so where it is seen.
    for (const node of figures) if (!('small' in node.dataset)) await node.live.prove().catch(() => {});
  };
  if (document.readyState === 'complete') watch(); else addEventListener('load', watch);
}

if (document.readyState === 'loading') addEventListener('DOMContentLoaded', begin); else begin();
