// chart.js - lines that move: values over the last frames, or whole curves.

import { make, colour } from './node.js';

const FRAMES = 600, FEW = 120;  // as many stay in sight; at first these fill the chart
const LINE_COLOURS = { 1: ['blue'], 2: ['orange', 'blue'], 3: ['orange', 'blue', 'green'],
  4: ['orange', 'blue', 'green', 'purple'] };
const SUPERSCRIPT = { '-': '⁻', 0: '⁰', 1: '¹', 2: '²', 3: '³', 4: '⁴', 5: '⁵', 6: '⁶', 7: '⁷', 8: '⁸', 9: '⁹' };
const power = n => '10' + [...String(n)].map(c => SUPERSCRIPT[c]).join('');

function short(x) {
  if (!isFinite(x)) return '–';
  const size = Math.abs(x);
  if (size !== 0 && (size < 0.001 || size >= 1e5)) {
    const e = Math.floor(Math.log10(size));
    return (x / 10 ** e).toFixed(1) + ' · ' + power(e);
  }
  return size >= 100 || size === 0 ? x.toFixed(0) : x.toPrecision(2);
}

export class Chart {
  // Curves that have the names of those above them need no second legend.
  constructor(figure, plan, above) {
    Object.assign(this, { figure, plan });
    const isNamed = plan.over && above?.over && String(above.lines) === String(plan.lines);
    const names = plan.lines.length ? plan.lines : [''];
    this.colours = LINE_COLOURS[names.length];
    this.now = names.map(() => make('b'));
    this.canvas = make('canvas', { role: 'img', 'aria-label': `${plan.name}${plan.over ? ' over ' + plan.over : ''}` });
    const legend = names.map((name, k) => make('span', {},
      ...(name ? [make('i', { class: 'live-' + this.colours[k] }), name, ' '] : []), this.now[k]));
    this.node = make('div', { class: 'live-chart' },
      make('div', { class: 'live-chart-head' + (names.length > 1 ? ' live-named' : '') }, make('span', {}, plan.name + (plan.unit ? ', ' + plan.unit : '')), ...(isNamed ? [] : legend)),
      this.canvas);
    this.clear();
  }

  clear() {
    this.data = this.colours.map(() => []);
    this.low = this.plan.least;
    this.high = this.plan.most;
  }

  // The next value of a line, or all values of a curve.
  add(line, value) {
    const data = this.data[line];
    data.push(value);
    if (data.length > FRAMES) data.shift();
  }
  drop(n) { for (const data of this.data) data.length = Math.max(0, data.length - n); }
  set(line, values) { this.data[line] = Array.from(values); }

  // The axis grows to hold all, and shrinks slowly.
  fit() {
    let { least: low, most: high } = this.plan;
    for (const data of this.data) for (const x of data) {
      if (!isFinite(x)) continue;
      if (x > high) high = x;
      if (!this.plan.logarithmic && x < low) low = x;
    }
    if (this.plan.logarithmic) high = Math.min(high, low * 1e12);
    this.low = low;
    this.high = high > this.high ? high : Math.max(high, this.high * 0.98);
  }

  marks() {
    if (this.plan.logarithmic) {
      const from = Math.ceil(Math.log10(this.low) - 1e-9), to = Math.floor(Math.log10(this.high) + 1e-9);
      const every = Math.max(1, Math.ceil((to - from) / 3)), out = [];
      for (let e = from; e <= to; e += every) out.push([10 ** e, power(e)]);
      return out;
    }
    const rough = (this.high - this.low) / 3, ten = 10 ** Math.floor(Math.log10(rough));
    const each = [1, 2, 5, 10].map(k => k * ten).find(k => k >= rough), out = [];
    for (let x = Math.ceil(this.low / each - 1e-9) * each; x <= this.high + each * 1e-9; x += each)
      out.push([x, String(+x.toPrecision(3)).replace('-', '−')]);
    return out;
  }

  draw() {
    const ratio = devicePixelRatio || 1, wide = this.canvas.clientWidth, high = this.canvas.clientHeight;
    if (!wide) return;
    if (this.canvas.width !== Math.round(wide * ratio)) {
      this.canvas.width = Math.round(wide * ratio);
      this.canvas.height = Math.round(high * ratio);
    }
    this.fit();
    const pen = this.canvas.getContext('2d');
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, wide, high);
    const log = this.plan.logarithmic, bottom = high - (this.plan.over ? 18 : 6), left = 42;
    const level = x => log ? Math.log(Math.max(x, this.low) / this.low) / Math.log(this.high / this.low)
      : (x - this.low) / (this.high - this.low);
    const y = x => bottom - (bottom - 8) * Math.min(1, level(x));
    this.drawAxis(pen, y, left, wide, high);
    this.data.forEach((data, line) => {
      if (!data.length) return;
      this.now[line].textContent = this.plan.over ? '' : short(data[data.length - 1]);
      const most = this.plan.over ? Math.max(1, data.length - 1) : Math.max(FEW, data.length) - 1;
      pen.strokeStyle = colour(this.figure, this.colours[line]);
      pen.beginPath();
      data.forEach((value, k) => {
        const px = left + 4 + (wide - left - 6) * k / most;
        if (isFinite(value)) pen.lineTo(px, y(value));
      });
      pen.stroke();
    });
  }

  drawAxis(pen, y, left, wide, high) {
    pen.font = '12px system-ui, "DejaVu Sans", sans-serif';
    pen.textBaseline = 'middle';
    pen.textAlign = 'right';
    pen.lineWidth = 1;
    pen.strokeStyle = colour(this.figure, 'rule');
    pen.fillStyle = colour(this.figure, 'quiet');
    for (const [value, name] of this.marks()) {
      const at = Math.round(y(value)) + 0.5;
      pen.beginPath();
      pen.moveTo(left, at);
      pen.lineTo(wide, at);
      pen.stroke();
      pen.fillText(name, left - 6, Math.min(Math.max(at, 7), high - 7));
    }
    if (this.plan.over) pen.fillText(this.plan.over, wide - 2, high - 6);
    pen.lineWidth = 1.75;
    pen.lineJoin = 'round';
  }
}
