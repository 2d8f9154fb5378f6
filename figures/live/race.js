// race.js - the same scene by several methods, side by side, each with the stopwatch of
// its own computing:  <figure data-race="drape" data-runs="0:0 0:1 0:2"> gets a small
// figure for each choice of a dial.  All have the same share of the processor.

import { make } from './node.js';
import { button } from './dials.js';

const FRAMES = 180;             // to the goal: 3 s
const SHARE = 8;                // ms of a picture that each may compute

export class Race {
  constructor(node, panel, Figure) {
    const picture = node.querySelector('img'), caption = node.querySelector('figcaption');
    this.node = node;
    this.state = make('span', { class: 'live-time', role: 'status' });
    this.go = button('Race', () => this.begin());
    this.lanes = node.dataset.runs.split(' ').map(set => this.makeLane(set, panel, picture, Figure));
    picture?.remove();
    node.classList.add('live-figure', 'live-race');
    caption.before(make('div', { class: 'live-lanes' }, ...this.lanes.map(lane => lane.node)), make('div', { class: 'live-one' }, this.go, this.state));
  }

  makeLane(set, panel, picture, Figure) {
    const [dial, value] = set.split(':').map(Number), node = make('div', { class: 'live', 'data-small': panel.name, 'data-set': set, id: `${this.node.id}-${value}` });
    if (picture) node.append(picture.cloneNode());
    const lane = { node, name: panel.dials[dial].choices.split('|')[value], time: make('b', { class: 'live-time' }, ' '), made: make('span') };
    node.live = new Figure(node, panel);
    node.append(make('p', { class: 'live-said' }, `${lane.name} `, lane.time, lane.made));
    // It runs when it races, and no sooner.
    node.live.loop.play(false);
    return lane;
  }

  begin() {
    const ready = this.lanes.filter(({ node }) => node.live.core && !node.live.stopped);
    if (!ready.length) return;
    cancelAnimationFrame(this.id);
    this.place = 0;
    delete this.node.dataset.over;
    for (const lane of ready) {
      lane.node.live.loop.play(false);
      lane.node.live.act('begin');
      lane.spent = lane.ran = 0;
      lane.made.textContent = '';
    }
    this.state.textContent = `${FRAMES / 60} seconds of motion; the watch counts what each computes`;
    const tick = () => {
      const left = ready.filter(lane => this.run(lane));
      if (left.length) this.id = requestAnimationFrame(tick); else this.node.dataset.over = '1';
    };
    this.id = requestAnimationFrame(tick);
  }

  // One share of a lane; false when it is at the goal.
  run(lane) {
    const { live } = lane.node;
    if (lane.ran >= FRAMES || live.stopped) return false;
    for (let spent = 0; lane.ran < FRAMES && spent < SHARE && !live.stopped; lane.ran++) {
      live.step();
      spent += live.took;
      lane.spent += live.took;
    }
    live.draw();
    const isOver = lane.ran >= FRAMES;
    lane.time.textContent = `${(lane.spent / 1e3).toFixed(2)} s${isOver ? `, the ${['first', 'second', 'third', 'fourth'][this.place++]}` : ''}`;
    if (isOver) lane.made.textContent = ` ${live.said.textContent}`;
    return !isOver;
  }
}
