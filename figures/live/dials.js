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

const MANY = 8;                 // more choices have a line of their own
let groups = 0;
function choice(dial, turned) {
  const group = 'live-choice-' + groups++;
  const options = dial.choices.split('|').map((name, k) => make('label', {},
    make('input', { type: 'radio', name: group, checked: k === dial.value, onchange: () => turned(k) }),
    make('span', {}, name)));
  return make('fieldset', { class: options.length > MANY ? 'live-choice live-long' : 'live-choice' }, make('legend', {}, dial.name), make('div', {}, ...options));
}

export const makeDial = (dial, turned) => (dial.choices ? choice : slider)(dial, turned);

export const button = (name, pressed, kind) => make('button', { type: 'button', class: kind, onclick: pressed }, name);

// --- Small buttons on the stage: pictures with a name ---
const PICTURES = {
  Pause: 'M8 5v14M16 5v14', Play: 'M8 5l11 7-11 7z', 'Start again': 'M5 12a7 7 0 1 0 2.5-5.4M5 4v4h4',
  'One frame': 'M6 5l9 7-9 7zM19 5v14', 'Take back what you did last': 'M9 14l-5-5 5-5M4 9h10a5 5 0 0 1 0 10h-4', 'Back by a frame': 'M18 5l-9 7 9 7zM5 5v14', 'Copy an address of this': 'M10 14a4 4 0 0 0 6 0l3-3a4 4 0 0 0-6-6l-1 1M14 10a4 4 0 0 0-6 0l-3 3a4 4 0 0 0 6 6l1-1',
  'Make a film': 'M4 6h11v12H4zM15 10l5-3v10l-5-3', 'Save the film': 'M5 5h14v14H5z', Slow: 'M12 7v5l3 2M12 4a8 8 0 1 0 .01 0',
  'Full screen': 'M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5',
};
const picture = name => `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${PICTURES[name]}"/></svg>`;
export function tool(name, pressed) {
  const node = make('button', { type: 'button', class: 'live-tool', onclick: pressed });
  node.rename = to => {
    node.setAttribute('aria-label', to);
    node.title = to;
    node.innerHTML = picture(to);
  };
  node.rename(name);
  return node;
}
