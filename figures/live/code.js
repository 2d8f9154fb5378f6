// code.js - the function that a figure runs, with the line lit that it is at.

import { make } from './node.js';

const NOTE = /^(.*?)(\/\/.*)$/;

export class Code {
  // Where it stands, then its lines.
  constructor([place, ...lines]) {
    this.texts = lines;
    this.lines = lines.map(line => {
      const [, code, note] = line.match(NOTE) ?? [, line, ''];
      return make('span', {}, code, note ? make('i', {}, note) : '', '\n');
    });
    this.pre = make('pre', { tabindex: 0, role: 'region', 'aria-label': `the code, ${place}` }, ...this.lines);
    this.node = make('div', { class: 'live-code' }, make('p', {}, place), this.pre);
  }

  // The first line with these words; one that is not there is a fault that the tests
  // look for.
  light(words) {
    if (words === this.words) return;
    this.words = words;
    const at = words ? this.texts.findIndex(line => line.includes(words)) : -1;
    if (words && at < 0) this.node.dataset.lost = words;
    this.lines.forEach((line, k) => line.toggleAttribute('data-lit', k === at));
  }
}
