// check_dials.mjs - does each live figure bear whatever its dials are turned to?
// All corners: every dial at its least and its greatest, or at each of its choices;
// then a random walk over dials, buttons and what is dragged.  Nothing may stop, no number be NaN or
// infinite, no frame take seconds, no picture be empty:
//     node check_dials.mjs BUILD [SEED [FIGURE...]]

import { readFileSync, readdirSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { resolve } from 'node:path';
import { attempt, chosen, launch, together, unpainted } from './browser.mjs';
import { bench } from './bench.mjs';

const FRAMES = 30;              // of each corner: half a second
const TURNS = 60, MOST = 8;     // of a walk; and frames after each of them, at most
// A frame may take as long as so many million turns of a loop take in the same page:
// one second where a million take 6.6 ms.  Who waits longer thinks that it hangs.
const LIMIT = 150, TRIES = 3;   // so often a busy machine may be late
const TOGETHER = 2;             // figures, at a time
const TOLD = 20;                // faults that are printed

const [folder, seeded, ...wanted] = process.argv.slice(2);
const site = resolve(folder, 'site'), seed = +(seeded || Date.now() % 2 ** 31);
const browser = await launch(folder);
const sum = { figures: 0, corners: 0, turns: 0, faults: 0 };
let longest = { millions: 0 };

function fault(sentence) {
  if (++sum.faults <= TOLD) console.log(sentence);
}

// Two ends of a slider, or all choices; where these are too many for a product, the first
// and the last of all but the first dial.
const MANY = 300;
const ends = dial => dial.choices ? dial.choices.split('|').map((_, k) => k) : [dial.least, dial.most];
function corners(dials) {
  const lists = dials.map(ends), count = lists.reduce((all, list) => all * list.length, 1);
  return product(lists.map((list, k) => k && count > MANY ? [list[0], list.at(-1)] : list));
}
const product = lists => lists.reduce((all, list) => all.flatMap(one => list.map(x => [...one, x])), [[]]);
const stand = (dial, value) => `${dial.name} ${dial.choices ? dial.choices.split('|')[value] : value}`;

async function open(file, name) {
  const page = await browser.newPage({ viewport: { width: 1000, height: 800 } });
  page.setDefaultTimeout(120e3);
  await unpainted(page);
  page.on('pageerror', error => fault(`${name}: an error: ${error.message}`));
  await page.goto(pathToFileURL(file).href);
  const figure = page.locator(`[data-live="${name}"]`);
  await figure.evaluate(node => node.scrollIntoView({ block: 'center' }));
  await page.waitForSelector(`[data-live="${name}"]:is([data-ready], [data-trapped], [data-failed])`);
  await figure.evaluate(bench);
  return figure;
}

// Makes the moves, and tells what was wrong.  Answers with the figure, which is
// another one where it has stopped.
async function run(figure, file, name, moves, what) {
  let found;
  for (let k = 0; k < TRIES && !found?.wrong && !(found?.millions <= LIMIT); k++)
    found = await figure.evaluate((node, moves) => node.bench(moves), moves);
  const took = `a frame of ${found.ms.toFixed(0)} ms, as long as ${found.millions.toFixed(1)} million turns of a loop`;
  if (found.wrong || found.millions > LIMIT) fault(`${name}: ${what(found.move)}: ${found.wrong || took}`);
  if (found.millions > longest.millions) longest = { millions: found.millions, told: `${took}: ${name}, ${what(found.slow)}` };
  if (!found.stopped) return figure;
  await figure.page().close();
  return open(file, name);
}

async function checkCorners(figure, file, name, { dials }) {
  for (const values of corners(dials)) {
    const moves = values.map((value, dial) => ({ dial, value, frames: 0 }));
    figure = await run(figure, file, name, [...moves, { again: true, frames: FRAMES }],
      () => values.map((value, k) => stand(dials[k], value)).join(', '));
    sum.corners++;
  }
  return figure;
}

// Numbers from 0 to below 1, the same for a seed (xorshift of Marsaglia).
function dice(x) {
  const roll = () => {
    x ^= x << 13; x ^= x >>> 17; x ^= x << 5;
    return (x >>> 0) / 2 ** 32;
  };
  x ||= 1;
  for (let k = 0; k < 8; k++) roll();
  return roll;
}

// The walk of a figure depends on the seed and on its name alone.
async function checkWalk(figure, file, name, { dials, buttons, panes }) {
  const roll = dice([...name].reduce((hash, letter) => 31 * hash + letter.charCodeAt() | 0, seed | 0));
  const any = n => Math.floor(roll() * n);
  const moves = Array.from({ length: TURNS }, () => {
    const frames = any(MOST + 1);
    if (panes.length && any(4) === 0) return { drag: any(2 ** 16), x: roll(), y: roll(), frames };
    if (buttons.length && any(4) === 0) return { button: any(buttons.length), frames };
    if (!dials.length) return { again: true, frames };
    const dial = any(dials.length), { least, most, step } = dials[dial];
    return { dial, value: least + step * any(Math.round((most - least) / step) + 1), frames };
  });
  const told = ({ dial, value, button, drag, x, y }) => drag !== undefined ? `dragged to ${x.toFixed(2)}, ${y.toFixed(2)} of its pane`
    : button !== undefined ? buttons[button] : dial !== undefined ? stand(dials[dial], value) : 'begun again';
  const what = k => `turn ${k + 1} with the seed ${seed}, ${told(moves[k])}`;
  sum.turns += TURNS;
  return run(figure, file, name, moves, what);
}

console.log(`dials: the seed is ${seed}`);
const all = readdirSync(site).filter(file => file.endsWith('.html')).flatMap(page =>
  [...readFileSync(`${site}/${page}`, 'utf8').matchAll(/data-live="(\w+)"/g)].map(found => ({ file: `${site}/${page}`, name: found[1] })));
const asked = chosen(wanted, all.map(({ name }) => name), 'live figure');
await together(TOGETHER, all.filter(({ name }) => asked.includes(name)), ({ file, name }) => attempt(name, fault, async () => {
  let figure = await open(file, name);
  const panel = await figure.evaluate(node => node.live.panel);
  figure = await checkCorners(figure, file, name, panel);
  figure = await checkWalk(figure, file, name, panel);
  await figure.page().close();
  sum.figures++;
}));
await attempt('the browser', fault, () => browser.close());
console.log(`dials: ${sum.figures} figures, ${sum.corners} corners, ${sum.turns} turns at random, ${sum.faults} faults`);
console.log(`dials: the longest was ${longest.told}`);
process.exit(sum.faults || !sum.figures ? 1 : 0);
