// check_look.mjs - what a reader meets first: the first page moves, each chapter has a
// live figure within two screens, what is touched is large enough for a finger, on a
// phone a stage stays in view while a dial turns, and a page says what it is about to
// whoever passes it on; each chapter has several figures, each beside its sentence:
//     node check_look.mjs BUILD

import { readFileSync, readdirSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { resolve } from 'node:path';
import { attempt, launch, together, unpainted } from './browser.mjs';

const build = resolve(process.argv[2]), site = `${build}/site`;
const WIDE = { width: 1300, height: 900 }, PHONE = { width: 390, height: 844 };
const SCREENS = 2;              // within so many stands the first live figure
const FIGURES = 3;              // of a chapter, at least
const FINGER = 44;              // px, each way
const LAST = 21;                // chapters after it are lists and appendices
const WAIT = { timeout: 300e3 }, TOGETHER = 3;      // pages, at a time

let checks = 0, faults = 0;
function check(holds, sentence) {
  checks++;
  if (!holds) fault(`not so: ${sentence}`);
}
function fault(sentence) {
  faults++;
  console.log(sentence);
}

const browser = await launch(build);
async function open(name, options) {
  const page = await browser.newPage(options);
  page.setDefaultTimeout(WAIT.timeout);
  if (options.reducedMotion) await unpainted(page);
  page.errors = [];
  page.on('console', said => said.type() === 'error' && page.errors.push(said.text()));
  page.on('pageerror', error => page.errors.push(error.message));
  await page.goto(pathToFileURL(`${site}/${name}`).href);
  await page.addStyleTag({ content: '* { content-visibility: visible !important }' });
  return page;
}
const openings = readFileSync('chapters/site/openings.txt', 'utf8').trim().split('\n').filter(line => !line.startsWith('#')).map(line => line.split(/ *\| */));
let figures = 0;
const names = readdirSync(site).filter(name => name.endsWith('.html'));
const chapters = names.filter(name => /^\d\d/.test(name) && +name.slice(0, 2) <= LAST);

// --- Each page says what it is about ------------------------------------------------
for (const name of names) {
  const html = readFileSync(`${site}/${name}`, 'utf8'), title = html.match(/<title>(.*)<\/title>/)?.[1] ?? '';
  const said = Object.fromEntries([...html.matchAll(/<meta (?:name|property)="([^"]*)" content="([^"]*)">/g)].map(found => found.slice(1)));
  check(!html.includes('It moves in the pages that'), `${name} has each caption once`);
  check(title.length > 8, `${name} has a title: ${title}`);
  check(said.description?.length > 40, `${name} says what it is about: ${said.description}`);
  check(said['og:title'] && said['og:description'] === said.description, `${name} says so to whoever passes it on`);
}

// Small figures.  One that is turned from the start has no hash of its own.
const settled = node => node.elementHandle().then(handle => node.page().waitForFunction(({ dataset }) => dataset.ready && (dataset.hash || dataset.set) || dataset.trapped || dataset.failed, handle, WAIT));
async function checkSmall(page, name) {
  for (const figure of await page.locator('[data-small]').all()) await attempt(name, fault, () => checkOne(figure, name));
}
async function checkOne(figure, name) {
  await figure.evaluate(node => node.scrollIntoView({ block: 'center' }));
  await settled(figure);
  const { hash, wants, small, set, trapped, failed } = await figure.evaluate(node => ({ ...node.dataset }));
  check(!trapped && !failed, `${name}: ${small} moves: ${trapped ?? failed}`);
  check(set || hash === wants, `${name}: ${small} has the native hash ${wants}, not ${hash}`);
  check(await figure.locator('.live-dial, .live-choice').count() <= 1, `${name}: ${small} has one dial at most`);
  const stands = await figure.evaluate(({ dataset, live }) => dataset.set?.split(' ').every(one => {
    const [dial, value] = one.split(':').map(Number), plan = live.panel.dials[dial];
    return plan && live.turned[dial] === value && (plan.choices ? value < plan.choices.split('|').length : value >= plan.least && value <= plan.most);
  }) ?? true);
  check(stands, `${name}: ${small} is turned to ${set} from the start`);
}

// --- Chapters -----------------------------------------------------------------------
// From the top of the page to the top of the first figure, in screens.
async function checkChapter(name) {
  const page = await open(name, { viewport: WIDE, reducedMotion: 'reduce' });
  const at = await page.evaluate(() => {
    const first = document.querySelector('[data-live], [data-small], [data-race]');
    return first ? (first.getBoundingClientRect().top + scrollY) / innerHeight : Infinity;
  });
  check(at < SCREENS, `${name} has a live figure within ${SCREENS} screens: it is at ${at.toFixed(1)}`);
  console.log(`${name.padEnd(22)} ${at.toFixed(1)} screens`);
  const count = await page.locator('[data-live], [data-small]').count();
  check(count >= FIGURES, `${name} has ${FIGURES} figures that move: ${count}`);
  figures += count;
  const placed = await page.locator('figure[data-small], [data-race]').count(), listed = openings.filter(line => `${line[0]}.html` === name).length;
  check(placed === listed, `${name} has all of its small figures (openings.txt): ${placed} of ${listed}`);
  const parted = await page.evaluate(() => [...document.querySelectorAll('figure[data-small], [data-race]')]
    .filter(figure => /:\s*$/.test(figure.previousElementSibling?.textContent ?? '')).map(figure => figure.id));
  check(!parted.length, `${name}: nothing stands between a sentence with a colon and what it announces: ${parted}`);
  // One idea each: what has no chart has one dial at most.
  const many = await page.evaluate(() => [...document.querySelectorAll('.live-small')]
    .filter(figure => figure.querySelectorAll('.live-dial, .live-choice').length > 1).map(figure => figure.id));
  check(!many.length, `${name}: small figures have one dial at most: ${many}`);
  await checkSmall(page, name);
  check(page.errors.length === 0, `${name} has no error in its console: ${page.errors[0]}`);
  await page.close();
}
await together(TOGETHER, chapters, name => attempt(name, fault, () => checkChapter(name)));

// What a finger touches; and the last dial of each figure turns beside its stage.
async function checkFinger(name) {
  const page = await open(name, { viewport: PHONE, hasTouch: true, reducedMotion: 'reduce' });
  const small = await page.evaluate(least => [...document.querySelectorAll('.live-figure :is(button, input[type=range], .live-choice span)')]
    .filter(node => node.checkVisibility()).map(node => ({ node, box: node.getBoundingClientRect() })).filter(({ box }) => box.height < least)
    .map(({ node, box }) => `${node.closest('figure').id} ${node.ariaLabel ?? node.textContent} ${box.height.toFixed(0)}`), FINGER);
  check(!small.length, `${name}: ${FINGER} px for a finger: ${small.slice(0, 4)}`);
  const gone = await page.evaluate(() => [...document.querySelectorAll('.live-figure')].filter(figure => {
    const dial = [...figure.querySelectorAll('.live-dial, .live-choice')].at(-1), stage = figure.querySelector('.live-stage');
    if (!dial) return false;
    dial.scrollIntoView({ block: 'end' });
    const box = stage.getBoundingClientRect();
    return Math.min(box.bottom, innerHeight) - Math.max(box.top, 0) < 0.9 * box.height;
  }).map(figure => figure.id));
  // Words in a flat drawing that begin in their pane end there.
  for (const figure of await page.locator('.live-figure').all()) {
    if (!await figure.evaluate(node => node.live?.isFlat)) continue;
    await figure.evaluate(node => node.scrollIntoView({ block: 'center' }));
    await settled(figure);
    const cut = await figure.evaluate(node => [...node.querySelectorAll('.live-label')].filter(label => {
      const words = label.getBoundingClientRect(), pane = label.closest('svg').getBoundingClientRect();
      return words.left < pane.right && (words.right > pane.right + 1 || words.left < pane.left - 1);
    }).map(label => `${node.id}, ${label.textContent}`));
    check(!cut.length, `${name}: no words of a drawing are cut off: ${cut}`);
  }
  check(!gone.length, `${name}: the stage is seen while the last dial turns: ${gone}`);
  // Who goes back with Tab comes to a dial from below.
  const behind = await page.evaluate(() => [...document.querySelectorAll('.live-figure input')].filter(input => {
    scrollTo(0, document.body.scrollHeight);
    input.focus();
    const box = input.getBoundingClientRect(), stage = input.closest('.live-figure').querySelector('.live-stage').getBoundingClientRect();
    return box.top < stage.bottom - 2;
  }).map(input => input.closest('figure').id));
  check(!behind.length, `${name}: a dial that is come to from below is not behind its stage: ${behind}`);
  await page.close();
}
await together(TOGETHER, chapters, name => attempt(`${name}, on a phone`, fault, () => checkFinger(name)));

// --- The first page -------------------------------------------------------------------
await attempt('index.html', fault, async () => {
  const still = await open('index.html', { viewport: WIDE, reducedMotion: 'reduce' });
  await checkSmall(still, 'index.html');
  await still.close();
  const page = await open('index.html', { viewport: WIDE });
  const figure = page.locator('[data-first]'), frames = () => figure.evaluate(node => node.live.frames);
  check(await figure.evaluate(node => node.getBoundingClientRect().top) < 200, 'the first page begins with what moves');
  check(await page.locator('.begin').evaluate(node => node.getBoundingClientRect().bottom < innerHeight), 'and its button is in the first screen');
  await page.waitForSelector('[data-small][data-ready]', WAIT);
  const before = await frames();
  await page.waitForFunction(before => document.querySelector('[data-small]').live.frames > before + 2, before, WAIT).catch(() => check(false, 'the first page moves by itself'));
  await figure.getByRole('button', { name: 'Pause' }).press('Enter');
  const stands = await frames();
  await figure.getByRole('button', { name: 'One frame' }).press('Enter');
  check(await frames() === stands + 1, 'and goes on by one frame when it is asked to');
  // A body is dragged: where it was held it is no more.
  const hash = () => figure.evaluate(({ live }) => live.core.hash());
  const spot = await figure.evaluate(({ live }) => {
    const { left, top, width, height } = live.drawing.canvas.getBoundingClientRect();
    for (let y = top; y < top + height; y += 6)
      for (let x = left; x < left + width; x += 6) if (live.drawing.pick({ clientX: x, clientY: y }) >= 0) return { x, y };
    return null;
  });
  check(spot, 'there is something to take hold of');
  if (!spot) return page.close();
  const untouched = await hash();
  await page.mouse.move(spot.x, spot.y);
  await page.mouse.down();
  await page.mouse.move(spot.x + 80, spot.y - 40, { steps: 4 });
  await figure.getByRole('button', { name: 'One frame' }).evaluate(node => node.click());
  await page.mouse.up();
  check(await hash() !== untouched, 'and it follows the hand');
  check(page.errors.length === 0, `the first page has no error in its console: ${page.errors[0]}`);
  await page.close();
});

await attempt('the browser', fault, () => browser.close());
console.log(`look: ${figures} figures in ${chapters.length} chapters`);
console.log(`look: ${checks} checks, ${faults} faults`);
process.exit(faults ? 1 : 0);
