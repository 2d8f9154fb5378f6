// node.js - elements of the page, and the colours that follow light and dark.

export function make(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) node.addEventListener(name.slice(2), value);
    else if (value !== undefined && value !== null && value !== false) node.setAttribute(name, value === true ? '' : value);
  }
  node.append(...children);
  return node;
}

export const svg = tag => document.createElementNS('http://www.w3.org/2000/svg', tag);

// In the order of live_colour (live.h).
export const COLOURS = ['ink', 'quiet', 'rule', 'blue', 'orange', 'green', 'purple', 'red', 'grey'];

export const colour = (figure, name) => getComputedStyle(figure).getPropertyValue('--live-' + name).trim();

export const dark = matchMedia('(prefers-color-scheme: dark)');
