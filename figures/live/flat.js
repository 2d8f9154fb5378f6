// flat.js - flat drawings as SVG, a pane each, drawn in pixels so that type and
// lines keep their size.  Handles are dragged by mouse, finger and arrow keys.

import { svg, COLOURS } from './node.js';

const PANE = 0, LINE = 1, DASHES = 2, AREA = 3, DOT = 4, ARROW = 5, LABEL = 6, HANDLE = 7, CIRCLE = 8;
const TAGS = { [LINE]: 'polyline', [DASHES]: 'polyline', [AREA]: 'polygon', [DOT]: 'circle', [ARROW]: 'path', [LABEL]: 'text', [CIRCLE]: 'circle' };
const NARROW = 560;             // px; below, panes stand one over the other

export class Flat {
  constructor(figure, stage, panel) {
    this.figure = figure;
    this.panes = panel.panes.map(box => this.makePane(stage, box, panel.says));
    stage.classList.add('live-flat');
    new ResizeObserver(() => {
      stage.classList.toggle('live-stacked', stage.clientWidth < NARROW && this.panes.length > 1);
      if (this.lists) this.draw(this.lists());
    }).observe(stage);
  }

  makePane(stage, [left, bottom, wide, high], says) {
    const node = svg('svg'), shapes = svg('g'), handles = svg('g');
    node.setAttribute('role', 'group');
    node.setAttribute('aria-label', says);
    node.style.setProperty('--live-aspect', wide / high);
    node.append(shapes, handles);
    stage.append(node);
    return { node, shapes, handles, left, bottom, wide, high, used: 0, held: 0 };
  }

  // The items of the list, pane by pane.
  draw({ flat, text }) {
    for (const pane of this.panes) {
      const { width, height } = pane.node.getBoundingClientRect();
      pane.scale = Math.min(width / pane.wide, height / pane.high);
      pane.x = width / 2 - pane.scale * (pane.left + pane.wide / 2);
      pane.y = height / 2 + pane.scale * (pane.bottom + pane.high / 2);
      pane.used = pane.held = 0;
    }
    let pane = this.panes[0];
    for (let i = 0; i < flat.length;) {
      const [kind, tint, number, n] = flat.subarray(i, i + 4);
      const points = flat.subarray(i + 4, i + 4 + 2 * n);
      i += 4 + 2 * n;
      if (kind === PANE) pane = this.panes[number];
      else if (kind === HANDLE) this.handle(pane, number, points, COLOURS[tint], text(points[2]));
      else this.shape(pane, kind, COLOURS[tint], number, points, text);
    }
    for (const { shapes, handles, used, held } of this.panes) {
      while (shapes.childNodes.length > used) shapes.lastChild.remove();
      while (handles.childNodes.length > held) handles.lastChild.remove();
    }
  }

  shape(pane, kind, tint, number, points, text) {
    const at = k => [within(pane.x + pane.scale * points[2 * k]), within(pane.y - pane.scale * points[2 * k + 1])];
    let node = pane.shapes.childNodes[pane.used++];
    if (!node || node.tagName !== TAGS[kind]) {
      const fresh = svg(TAGS[kind]);
      if (node) node.replaceWith(fresh); else pane.shapes.append(fresh);
      node = fresh;
    }
    const name = ['', 'line', 'dashes', 'area', 'dot', 'arrow', 'label', '', 'area'][kind];
    node.setAttribute('class', `live-${name} live-${tint}`);
    if (kind <= AREA) {
      let out = '';
      for (let k = 0; k < points.length / 2; k++) out += at(k).map(v => v.toFixed(1)).join() + ' ';
      node.setAttribute('points', out);
    } else if (kind === DOT) this.place(node, at(0), number);
    else if (kind === CIRCLE) this.place(node, at(0), (number * pane.scale).toFixed(1));
    else if (kind === ARROW) node.setAttribute('d', arrow(at(0), at(1)));
    else {
      node.setAttribute('x', at(0)[0].toFixed(1));
      node.setAttribute('y', at(0)[1].toFixed(1));
      const words = text(number);
      if (node.textContent !== words) node.textContent = words;
    }
  }

  place(node, [x, y], radius) {
    node.setAttribute('cx', x.toFixed(1));
    node.setAttribute('cy', y.toFixed(1));
    node.setAttribute('r', radius);
  }

  handle(pane, number, points, tint, name) {
    let node = pane.handles.childNodes[pane.held++];
    if (!node) {
      node = this.makeHandle(pane);
      pane.handles.append(node);
    }
    node.number = number;
    node.at = [points[0], points[1]];
    node.setAttribute('class', `live-handle live-${tint}`);
    node.setAttribute('aria-label', `${name}: arrow keys move it`);
    this.place(node, [pane.x + pane.scale * points[0], pane.y - pane.scale * points[1]], 9);
  }

  makeHandle(pane) {
    const node = svg('circle'), inside = (x, y) => this.acted('move', node.number,
      Math.min(Math.max(x, pane.left), pane.left + pane.wide),
      Math.min(Math.max(y, pane.bottom), pane.bottom + pane.high), 0);
    const letGo = () => {
      if (node.held) this.acted('release', node.number);
      node.held = false;
    };
    node.setAttribute('tabindex', 0);
    node.setAttribute('role', 'button');
    node.addEventListener('pointerdown', event => { node.setPointerCapture(event.pointerId); node.held = true; });
    node.addEventListener('pointerup', letGo);
    node.addEventListener('pointercancel', letGo);
    node.addEventListener('keyup', letGo);
    node.addEventListener('blur', letGo);
    node.addEventListener('pointermove', event => {
      if (!node.held) return;
      const box = pane.node.getBoundingClientRect();
      inside((event.clientX - box.left - pane.x) / pane.scale, (pane.y - event.clientY + box.top) / pane.scale);
    });
    node.addEventListener('keydown', event => {
      const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      if (!way) return;
      event.preventDefault();
      node.held = true;
      inside(node.at[0] + way[0] * pane.wide / 100, node.at[1] + way[1] * pane.wide / 100);
    });
    return node;
  }

  restyle() {}
}

// What has exploded is far outside, or no number.
const within = px => px > -9999 ? Math.min(px, 9999) : -9999;

function arrow([x, y], [toX, toY]) {
  const length = Math.hypot(toX - x, toY - y) || 1, head = Math.min(9, length / 2);
  const [ux, uy] = [(toX - x) / length, (toY - y) / length], [bx, by] = [toX - head * ux, toY - head * uy];
  const side = 0.45 * head;
  return `M${x},${y}L${toX},${toY}M${bx - side * uy},${by + side * ux}L${toX},${toY}L${bx + side * uy},${by - side * ux}`;
}
