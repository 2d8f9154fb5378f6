// dials.js - what the reader turns and presses: real inputs with labels.

import { make } from './node.js';

const decimals = step => Math.max(0, -Math.floor(Math.log10(step) + 1e-9));

function slider(dial, turned) {
  const show = value => value.toFixed(decimals(dial.step)) + (dial.unit ? ' ' + dial.unit : '');
  const out = make('output', {}, show(dial.value));
  const input = make('input', {
    type: 'range', min: dial.least, max: dial.most, step: dial.step, value: dial.value,
    oninput: () => { out.value = show(+input.value); turned(+input.value); },
  });
  return make('label', { class: 'live-dial' }, make('span', {}, dial.name), input, out);
}

let groups = 0;
function choice(dial, turned) {
  const group = 'live-choice-' + groups++;
  const options = dial.choices.split('|').map((name, k) => make('label', {},
    make('input', { type: 'radio', name: group, checked: k === dial.value, onchange: () => turned(k) }),
    make('span', {}, name)));
  return make('fieldset', { class: 'live-choice' }, make('legend', {}, dial.name), make('div', {}, ...options));
}

export const makeDial = (dial, turned) => (dial.choices ? choice : slider)(dial, turned);

export const button = (name, pressed) => make('button', { type: 'button', onclick: pressed }, name);
