// node.js - elements of the page.

export function make(tag, holds = {}, ...inside) {
  const node = Object.assign(document.createElement(tag), holds);
  node.append(...inside);
  return node;
}
export const button = (text, act, holds = {}) => make('button', { type: 'button', textContent: text, onclick: act, ...holds });
