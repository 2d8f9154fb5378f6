// film.js - what the little program draws (figures/draw/paint_little.c says how it is
// told), as a film on a canvas: faces and lines, the far ones first.

import { button, make } from './desk.js';

const TONES = [[230, 159, 0], [86, 180, 233], [0, 158, 115], [239, 220, 74], [0, 114, 178], [213, 94, 0], [204, 121, 167]];
const EYE = [0.62, -0.32, 0.72], LAMP = [0.35, 0.85, 0.4], RATE = 15;    // frames a second

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
  const canvas = make('canvas', { width: 1120, height: 700 });
  const play = button('Pause', () => { playing = !playing; play.textContent = playing ? 'Pause' : 'Play'; });
  const node = make('figure', { className: 'workshop-film', hidden: true }, canvas, make('p', {}, play));
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', 'What your program draws, moving');
  let film, frame = 0, playing = !matchMedia('(prefers-reduced-motion: reduce)').matches, timer;

  const ahead = unit(EYE.map(x => -x)), right = unit(cross(ahead, [0, 1, 0])), up = cross(right, ahead);
  function paint() {
    const { frames, low, high } = film, pen = canvas.getContext('2d');
    const middle = low.map((x, k) => (x + high[k]) / 2), size = Math.max(.5, ...low.map((x, k) => high[k] - x));
    const seen = point => { const d = minus(point, middle), s = canvas.height / size / 1.25; return [canvas.width / 2 + s * dot(d, right), canvas.height / 2 - s * dot(d, up), dot(d, ahead)]; };
    pen.clearRect(0, 0, canvas.width, canvas.height);
    pen.lineWidth = 3;
    pen.lineJoin = pen.lineCap = 'round';
    const all = frames[frame].map(({ points, body }) => {
      const at = points.map(seen);
      return { at, points, body, far: at.reduce((sum, one) => sum + one[2], 0) / at.length };
    }).sort((a, b) => b.far - a.far);
    for (const { at, points, body } of all) {
      const tone = TONES[body % TONES.length];
      const light = points.length === 3 ? .55 + .45 * Math.abs(dot(unit(cross(minus(points[1], points[0]), minus(points[2], points[0]))), unit(LAMP))) : 1;
      const colour = `rgb(${tone.map(x => Math.round(x * light)).join()})`;
      pen.beginPath();
      at.forEach(([x, y], k) => { if (k) pen.lineTo(x, y); else pen.moveTo(x, y); });
      pen.strokeStyle = pen.fillStyle = colour;
      if (at.length === 3) { pen.closePath(); pen.lineWidth = 1; pen.fill(); } else pen.lineWidth = 4;
      pen.stroke();
    }
  }
  function tick() {
    if (playing && !document.hidden) { frame = (frame + 1) % film.frames.length; paint(); }
  }
  return {
    node,
    clear() { clearInterval(timer); node.hidden = true; },
    // False if there is no frame.
    show(text) {
      film = read(text);
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
  };
}
