// film.js - what the little program draws (figures/draw/paint_little.c says how it is
// told), as a film on a canvas: faces and lines, the far ones first, over the shadow
// that they throw straight down.  The book's, if it is there, is a pale twin.

import { button, make } from './node.js';

const TONES = [[221, 138, 77], [91, 149, 201], [107, 166, 119], [157, 127, 191], [207, 90, 94], [183, 180, 173], [92, 160, 168]];
const LAMP = [0.35, 0.85, 0.4], RATE = 15;      // frames a second
const TURN = 0.71, RISE = 0.33;                 // rad, of the eye at first

// Frames of bodies of faces and lines, and the box that holds them all.
function read(text) {
  const frames = [], low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  let body = 0;
  for (const line of text.split('\n')) {
    const [word, ...rest] = line.split(' ');
    if (word === 'frame') { frames.push([]); body = 0; } else if (word === 'body') body++;
    else if ((word === 'face' || word === 'line') && frames.length) {
      const at = rest.map(Number), points = [];
      for (let k = 0; k < at.length; k += 3) points.push(at.slice(k, k + 3));
      points.forEach(point => point.forEach((x, k) => { low[k] = Math.min(low[k], x); high[k] = Math.max(high[k], x); }));
      frames.at(-1).push({ points, body });
    }
  }
  return { frames, low, high };
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = a => { const l = Math.sqrt(dot(a, a)) || 1; return a.map(x => x / l); };
const minus = (a, b) => a.map((x, k) => x - b[k]);

export function makeFilm() {
  const canvas = make('canvas', { width: 1120, height: 700, tabIndex: 0 }), shade = make('canvas', { width: 1120, height: 700 });
  const play = button('Pause', () => { playing = !playing; play.textContent = playing ? 'Pause' : 'Play'; });
  const slow = button('Slow', () => { pace = pace === 1 ? 4 : 1; slow.setAttribute('aria-pressed', pace > 1); });
  const step = button('One frame', () => { if (playing) play.click(); go(); });
  const node = make('figure', { className: 'workshop-film', hidden: true }, canvas, make('p', {}, play, slow, step));
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', 'What your program draws, moving. Arrow keys turn the view.');
  slow.setAttribute('aria-pressed', false);
  let film, twin, frame = 0, ticks = 0, pace = 1, timer, turn = TURN, rise = RISE;
  let playing = !matchMedia('(prefers-reduced-motion: reduce)').matches;
  if (!playing) play.textContent = 'Play';

  // How a point of space is seen: x, y, and how far off.
  function eye() {
    const { low, high } = film, middle = low.map((x, k) => (x + high[k]) / 2), size = Math.max(.5, ...low.map((x, k) => high[k] - x));
    const ahead = [-Math.sin(turn) * Math.cos(rise), -Math.sin(rise), -Math.cos(turn) * Math.cos(rise)];
    const right = unit(cross(ahead, [0, 1, 0])), up = cross(right, ahead), s = canvas.height / size / 1.35;
    return point => { const d = minus(point, middle); return [canvas.width / 2 + s * dot(d, right), canvas.height / 2 - s * dot(d, up), dot(d, ahead)]; };
  }

  function trace(pen, at) {
    pen.beginPath();
    at.forEach(([x, y], k) => { if (k) pen.lineTo(x, y); else pen.moveTo(x, y); });
    if (at.length > 2) pen.closePath();
  }

  // Each piece from the far to the near.
  function pieces(pen, all, seen) {
    const far = all.map(({ points, body }) => {
      const at = points.map(seen);
      return { at, points, body, far: at.reduce((sum, one) => sum + one[2], 0) / at.length };
    }).sort((a, b) => b.far - a.far);
    for (const { at, points, body } of far) {
      const normal = points.length > 2 && unit(cross(minus(points[1], points[0]), minus(points[2], points[0])));
      const light = normal ? .62 + .38 * Math.abs(dot(normal, unit(LAMP))) : 1;
      pen.strokeStyle = pen.fillStyle = `rgb(${TONES[body % TONES.length].map(x => Math.round(x * light)).join()})`;
      pen.lineWidth = normal ? 1 : 4;
      trace(pen, at);
      if (normal) pen.fill();
      pen.stroke();
    }
  }

  function paint() {
    const pen = canvas.getContext('2d'), dim = shade.getContext('2d'), seen = eye(), now = film.frames[frame];
    for (const one of [pen, dim]) {
      one.clearRect(0, 0, canvas.width, canvas.height);
      one.lineJoin = one.lineCap = 'round';
    }
    dim.fillStyle = dim.strokeStyle = '#000';
    for (const { points } of now) {
      trace(dim, points.map(([x, , z]) => seen([x, film.low[1], z])));
      if (points.length > 2) dim.fill(); else { dim.lineWidth = 4; dim.stroke(); }
    }
    pen.filter = 'blur(5px)';
    pen.globalAlpha = .16;
    pen.drawImage(shade, 0, 0);
    pen.filter = 'none';
    pen.globalAlpha = .28;
    if (twin) pieces(pen, twin.frames[Math.min(frame, twin.frames.length - 1)], seen);
    pen.globalAlpha = 1;
    pieces(pen, now, seen);
  }
  function go() { frame = (frame + 1) % film.frames.length; paint(); }
  function tick() { if (playing && !document.hidden && ++ticks % pace === 0) go(); }

  function turnBy(across, up) {
    turn -= across;
    rise = Math.min(1.5, Math.max(0, rise + up));
    if (film) paint();
  }
  let held;
  canvas.addEventListener('pointerdown', event => { canvas.setPointerCapture(event.pointerId); held = event; });
  canvas.addEventListener('pointermove', event => {
    if (!held) return;
    turnBy((event.clientX - held.clientX) * .008, event.pointerType === 'touch' ? 0 : (event.clientY - held.clientY) * .008);
    held = event;
  });
  for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, () => { held = null; });
  canvas.addEventListener('keydown', event => {
    const way = { ArrowLeft: [-.1, 0], ArrowRight: [.1, 0], ArrowUp: [0, .1], ArrowDown: [0, -.1] }[event.key];
    if (!way) return;
    event.preventDefault();
    turnBy(...way);
  });

  return {
    node,
    clear() { clearInterval(timer); node.hidden = true; },
    // False if there is no frame.
    show(text) {
      film = read(text);
      twin = null;
      delete node.dataset.twin;
      clearInterval(timer);
      if (!film.frames.length) return false;
      frame = playing ? 0 : film.frames.length - 1;
      node.hidden = false;
      node.dataset.frames = film.frames.length;
      paint();
      timer = setInterval(tick, 1e3 / RATE);
      node.scrollIntoView({ block: 'nearest' });
      return true;
    },
    // The book's beside it.
    beside(text) {
      const other = read(text);
      if (!other.frames.length) return;
      twin = other;
      node.dataset.twin = other.frames.length;
      paint();
    },
  };
}
