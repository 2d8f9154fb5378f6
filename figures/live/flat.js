// flat.js - flat drawings as SVG, a pane each, drawn in pixels so that type and
// lines keep their size.  Handles are dragged by mouse, finger and arrow keys.

import { svg, COLOURS } from './node.js';

const PANE = 0, LINE = 1, DASHES = 2, AREA = 3, DOT = 4, ARROW = 5, LABEL = 6, HANDLE = 7, CIRCLE = 8;
const TAGS = { [LINE]: 'polyline', [DASHES]: 'polyline', [AREA]: 'polygon', [DOT]: 'circle', [ARROW]: 'path', [LABEL]: 'text', [CIRCLE]: 'circle' };
const REACH = 24;               // px, half of what a finger touches
const NARROW = 560;             // px; below, panes stand one over the other
const EDGE = 4;                 // px, between words and the edge of their pane

export class Flat {
  constructor(figure, stage, panel) {
    this.figure = figure;
    this.panes = panel.panes.map(box => this.makePane(stage, box, panel.says));
    stage.classList.add('live-flat');
    new ResizeObserver(() => {
      stage.classList.toggle('live-stacked', stage.clientWidth < NARROW && this.panes.length > 1);
      this.again?.();
    }).observe(stage);
  }

  makePane(stage, [left, bottom, wide, high], says) {
    const node = svg('svg'), ghosts = svg('g'), shapes = svg('g'), handles = svg('g');
    ghosts.setAttribute('class', 'live-ghost');
    node.setAttribute('role', 'group');
    node.setAttribute('aria-label', says);
    node.style.setProperty('--live-aspect', wide / high);
    node.append(ghosts, shapes, handles);
    stage.append(node);
    const pane = { node, shapes, handles, left, bottom, wide, high, held: 0, ghosts };
    this.grabs(pane);
    return pane;
  }

  // The items of the list, pane by pane; and below them those of the ghost, which has
  // no handles.
  draw(lists, ghost) {
    for (const pane of this.panes) {
      const { width, height } = pane.node.getBoundingClientRect();
      pane.scale = Math.min(width / pane.wide, height / pane.high);
      pane.x = width / 2 - pane.scale * (pane.left + pane.wide / 2);
      pane.y = height / 2 + pane.scale * (pane.bottom + pane.high / 2);
      Object.assign(pane, { across: width, down: height });
      pane.held = 0;
      pane.ghosts.used = pane.shapes.used = 0;
    }
    if (ghost) this.lay(ghost, 'ghosts');
    this.lay(lists, 'shapes');
    for (const { ghosts, shapes, handles, held } of this.panes) {
      for (const layer of [ghosts, shapes]) while (layer.childNodes.length > layer.used) layer.lastChild.remove();
      while (handles.childNodes.length > held) handles.lastChild.remove();
    }
  }

  lay({ flat, text }, layer) {
    let pane = this.panes[0];
    for (let i = 0; i < flat.length;) {
      const [kind, tint, number, n] = flat.subarray(i, i + 4);
      const points = flat.subarray(i + 4, i + 4 + 2 * n);
      i += 4 + 2 * n;
      if (kind === PANE) pane = this.panes[number];
      else if (kind !== HANDLE) this.shape(pane, pane[layer], kind, COLOURS[tint], number, points, text);
      else if (layer === 'shapes') this.handle(pane, number, points, COLOURS[tint], text(points[2]));
    }
  }

  shape(pane, layer, kind, tint, number, points, text) {
    const at = k => [within(pane.x + pane.scale * points[2 * k]), within(pane.y - pane.scale * points[2 * k + 1])];
    let node = layer.childNodes[layer.used++];
    if (!node || node.tagName !== TAGS[kind]) {
      const fresh = svg(TAGS[kind]);
      if (node) node.replaceWith(fresh); else layer.append(fresh);
      node = fresh;
    }
    const name = ['', 'line', 'dashes', 'area', 'dot', 'arrow', 'label', '', 'area'][kind];
    node.setAttribute('class', `live-${kind === AREA && number ? 'band' : name} live-${tint}`);
    if (kind <= AREA) {
      let out = '';
      for (let k = 0; k < points.length / 2; k++) out += at(k).map(v => v.toFixed(1)).join() + ' ';
      node.setAttribute('points', out);
    } else if (kind === DOT) this.place(node, at(0), number);
    else if (kind === CIRCLE) this.place(node, at(0), (number * pane.scale).toFixed(1));
    else if (kind === ARROW) node.setAttribute('d', arrow(at(0), at(1)));
    else this.label(node, pane, at(0), text(number));
  }

  // Words that begin inside their pane end there as well, however narrow it is.
  label(node, { across, down }, [x, y], words) {
    if (node.textContent !== words) {
      node.textContent = words;
      node.long = 0;
    }
    node.long ||= node.getComputedTextLength();
    const isInside = x >= 0 && x <= across && y >= 0 && y <= down;
    node.setAttribute('x', (isInside ? Math.max(Math.min(x, across - node.long - EDGE), EDGE) : x).toFixed(1));
    node.setAttribute('y', (isInside ? Math.min(y, down - EDGE) : y).toFixed(1));
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
    node.tint = `live-${tint}`;
    node.setAttribute('class', `live-handle live-${tint}`);
    node.setAttribute('aria-label', `${name}: arrow keys move it`);
    this.place(node, [pane.x + pane.scale * points[0], pane.y - pane.scale * points[1]], 9);
  }

  makeHandle(pane) {
    const node = svg('circle');
    const letGo = () => {
      if (node.held) this.acted('release', node.number);
      node.held = false;
    };
    node.letGo = letGo;
    node.inside = (x, y) => this.acted('move', node.number,
      Math.min(Math.max(x, pane.left), pane.left + pane.wide),
      Math.min(Math.max(y, pane.bottom), pane.bottom + pane.high), 0);
    node.setAttribute('tabindex', 0);
    node.setAttribute('role', 'button');
    node.addEventListener('keyup', letGo);
    node.addEventListener('blur', letGo);
    node.addEventListener('keydown', event => {
      const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      if (!way) return;
      event.preventDefault();
      node.held = true;
      node.inside(node.at[0] + way[0] * pane.wide / 100, node.at[1] + way[1] * pane.wide / 100);
    });
    return node;
  }

  // A finger takes the nearest handle within its reach, which comes to it; or else that
  // of the body it is on, which keeps its distance.
  grabs(pane) {
    const { node, handles } = pane;
    const where = event => {
      const box = node.getBoundingClientRect();
      return [(event.clientX - box.left - pane.x) / pane.scale, (pane.y - event.clientY + box.top) / pane.scale];
    };
    const nearest = ([x, y], all) => all.map(handle => [Math.hypot(handle.at[0] - x, handle.at[1] - y) * pane.scale, handle]).sort((a, b) => a[0] - b[0])[0];
    const found = event => {
      const at = where(event), all = [...handles.childNodes], near = nearest(at, all);
      if (near?.[0] < REACH) return near[1];
      const tint = event.target.matches('.live-area') && [...event.target.classList].find(name => name !== 'live-area');
      return tint && nearest(at, all.filter(handle => handle.tint === tint))?.[1];
    };
    let held, off;
    const letGo = () => { held?.letGo(); held = null; };
    node.addEventListener('pointerdown', event => {
      held = found(event);
      if (!held) return;
      node.setPointerCapture(event.pointerId);
      const [x, y] = where(event);
      const isNear = Math.hypot(held.at[0] - x, held.at[1] - y) * pane.scale < REACH;
      off = isNear ? [0, 0] : [held.at[0] - x, held.at[1] - y];
      held.held = true;
      held.focus({ preventScroll: true });
      event.preventDefault();
    });
    node.addEventListener('pointermove', event => {
      if (!held) return;
      const [x, y] = where(event);
      held.inside(x + off[0], y + off[1]);
    });
    node.addEventListener('pointerup', letGo);
    node.addEventListener('pointercancel', letGo);
    // A finger on nothing scrolls the page; on a handle it holds it.
    node.addEventListener('touchstart', event => {
      const [touch] = event.touches;
      if (found({ target: event.target, clientX: touch.clientX, clientY: touch.clientY })) event.preventDefault();
    }, { passive: false });
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
