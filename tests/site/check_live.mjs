// check_live.mjs - do the live figures do what a reader expects of them?  Dials
// move the charts, only what is seen runs, unwanted motion stands still, a picture
// stands where scripts are off; and a module of the reader's own runs in the page,
// or the page says what is wrong with it:   node check_live.mjs BUILD [PAGE...]
// With pages, such as 01 or 01-verlet, only what can be said of any page is looked at
// on these.

import { execFileSync } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { resolve } from 'node:path';
import { attempt, chosen, launch, together, unpainted } from './browser.mjs';

const build = resolve(process.argv[2]), some = process.argv.slice(3);
// A machine that does other things as well may need minutes; nothing is judged by it.
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

// A page, and all errors that its console tells of.
async function open(file, options = {}) {
  const page = await browser.newPage({ viewport: { width: 1300, height: 900 }, ...options });
  page.setDefaultTimeout(WAIT.timeout);
  if (options.reducedMotion) await unpainted(page);
  page.errors = [];
  page.on('console', said => said.type() === 'error' && page.errors.push(said.text()));
  page.on('pageerror', error => page.errors.push(error.message));
  page.on('crash', () => { page.crashed = true; });
  await page.goto(pathToFileURL(file).href);
  return page;
}

const settled = (page, name) => page.waitForSelector(`[data-live="${name}"]:is([data-ready][data-hash], [data-trapped], [data-failed])`, WAIT);
const frames = figure => figure.evaluate(node => node.live.frames);

// --- The figures of a page, with motion unwanted: each stands at frame 60 -------
async function checkPage(file, names) {
  const page = await open(file, { reducedMotion: 'reduce' });
  for (const name of names) {
    if (page.crashed) fault(`${name} was not looked at, since its page crashed`);
    else await attempt(`${file.replace(/.*\//, '')}, ${name}`, fault, () => checkFigure(page, name));
  }
  check(page.errors.length === 0, `${file.replace(/.*\//, '')} has no error in its console: ${page.errors[0]}`);
  await page.close();
}

async function checkFigure(page, name) {
  const figure = page.locator(`[data-live="${name}"]`);
  await figure.evaluate(node => node.scrollIntoView({ block: 'center' }));
  await settled(page, name);
  const { hash, wants, running, trapped, failed } = await figure.evaluate(node => ({ ...node.dataset }));
  check(hash === wants, `${name} has the native hash ${wants}, not ${hash ?? trapped ?? failed}`);
  if (trapped || failed) return;
  check(running === '0' && await frames(figure) === 60, `${name} stands at frame 60 where motion is unwanted`);
  await checkPicture(figure, name);
  await checkCode(figure, name);
  await checkDials(page, figure, name);
  await checkChoices(figure, name);
  await checkAgain(figure, name);
  await checkBack(figure, name);
  check(await figure.evaluate(painted), `${name} is painted: more than the ground is seen`);
}

// What is drawn in space, painted once: it has more colours than its floor and horizon.
async function painted({ live }) {
  const { canvas } = live.drawing;
  if (!canvas) return true;
  window.painted = true;
  live.draw();
  const small = new OffscreenCanvas(64, 36).getContext('2d');
  small.drawImage(canvas, 0, 0, 64, 36);
  window.painted = false;
  const seen = new Set(), { data } = small.getImageData(0, 0, 64, 36);
  for (let k = 0; k < data.length; k += 4) seen.add(data[k] >> 4 << 8 | data[k + 1] >> 4 << 4 | data[k + 2] >> 4);
  return seen.size > 8;
}

// The picture that stands in its place holds what is drawn, and nothing else: one with
// the strip of the buttons below it is higher by 67 px.
async function checkPicture(figure, name) {
  const more = await figure.evaluate(async ({ live }) => {
    const picture = Object.assign(new Image(), { src: `figures/live/${live.name}.webp` });
    await picture.decode();
    const aspect = live.isFlat ? +live.stage.style.getPropertyValue('--live-aspect') : 16 / 9;
    return picture.naturalHeight - picture.naturalWidth / aspect;
  });
  check(Math.abs(more) < 4, `the picture of ${name} has the shape of its stage: it is ${more.toFixed(0)} px higher (make still-${name})`);
}

// A figure that shows its code lights one line of it after the other, and none that
// is not there.  (10 s are enough for all of them to come round.)
async function checkCode(figure, name) {
  const found = await figure.evaluate(async node => {
    const code = node.querySelector('.live-code'), lit = new Set();
    if (!code) return null;
    for (let k = 0; k < 600; k++) {
      node.live.tick(1);
      const lines = code.querySelectorAll('[data-lit]');
      if (lines.length > 1) return { lit: -1 };
      if (lines.length) lit.add(lines[0].textContent);
    }
    const lost = code.dataset.lost;
    node.live.act('begin');
    return { lit: lit.size, lost };
  });
  if (!found) return;
  check(!found.lost, `${name} has the line "${found.lost}" in its code`);
  check(found.lit > 1, `${name} lights one line after the other: ${found.lit}`);
}

// All that is seen and computed, but for times, as one string.
const look = figure => figure.evaluate(({ live }) => {
  const lists = live.core.draw();
  const drawn = ['flat', 'place', 'tint', 'ball', 'tube', 'edge'].map(name => lists[name].reduce((sum, x, k) => sum + x * (k % 7 + 1), 0));
  const charts = live.charts.filter(chart => !chart.plan.time).map(chart => JSON.stringify(chart.data));
  return [live.core.hash(), lists.said, ...drawn, ...charts].join();
});

// Every slider, reached by its label and turned by a key, makes another frame 60.
async function checkDials(page, figure, name) {
  let before = await look(figure);
  for (const dial of await figure.locator('input[type=range]').all()) {
    const label = await dial.evaluate(node => node.labels[0].firstChild.textContent);
    await dial.focus();
    await page.keyboard.press(await dial.evaluate(node => node.value === node.max) ? 'Home' : 'End');
    await figure.getByRole('button', { name: 'Start again' }).press('Enter');
    const after = await look(figure);
    check(after !== before, `${name}: the dial "${label}" changes what is seen`);
    before = after;
  }
}

// Each choice of the first dial, with all else as it was at first, has the bits of this
// machine; but for those that ask the C library for sines.
async function checkChoices(figure, name) {
  const wrong = await figure.evaluate(({ live }, frames) => {
    const { dials, wants } = live.panel, turn = all => all.forEach((value, dial) => live.set(dial, value));
    const stand = [...live.turned], first = dials.map(dial => dial.value), found = [];
    if (!dials[0]?.choices) return found;
    for (const [k, wanted] of wants.entries()) {
      turn([k, ...first.slice(1)]);
      live.act('begin');
      live.tick(frames - live.frames);
      if (wanted && live.core.hash() !== wanted) found.push(`choice ${k} has ${live.core.hash()}, not ${wanted}`);
    }
    turn(dials.map((dial, k) => stand[k] ?? dial.value));
    live.act('begin');
    return found;
  }, 60);
  check(!wrong.length, `${name}: ${wrong.length} choices have other bits than on this machine: ${wrong[0]}`);
}

// Start again begins a figure that goes on in the memory that it has, and one that
// has stopped in a new one: with the dials as they stand, the same colours, and
// no motion where it is unwanted.
async function checkAgain(figure, name) {
  const again = figure.getByRole('button', { name: 'Start again' });
  await figure.evaluate(node => { node.old = node.live.core; });
  await again.press('Enter');
  check(await figure.evaluate(node => node.live.core === node.old), `${name} starts again in the memory that it has`);
  const usual = await look(figure);
  await figure.evaluate(({ live }) => live.guard(() => { throw new WebAssembly.RuntimeError('unreachable'); }));
  check(await figure.locator('.live-trap').count() === 1, `${name} that has stopped says so`);
  await again.press('Enter');
  const goesOn = await figure.page().waitForFunction(node => !node.live.stopped, await figure.elementHandle(), WAIT).catch(() => null);
  check(goesOn, `${name} that has stopped starts again`);
  if (!goesOn) return;
  check(await figure.evaluate(node => node.live.core !== node.old), `${name} that has stopped has a new memory`);
  check(await figure.locator('.live-trap').count() === 0, `${name} that goes on says no more that it has stopped`);
  check(await figure.getAttribute('data-running') === '0', `${name} starts again, and stands at frame 60`);
  check(await look(figure) === usual, `${name} that has stopped starts again with its dials and colours`);
}

// A frame back is the frame that was, to the last bit, and so is the next one after it;
// also over what a hand has done.
async function checkBack(figure, name) {
  const press = label => figure.getByRole('button', { name: label, exact: true }).press('Enter');
  const hash = () => figure.evaluate(({ live }) => live.core.hash());
  const seen = [await hash()];
  for (let k = 0; k < 3; k++) {
    if (k === 1) await figure.evaluate(({ live }) => { if (live.panel.buttons.length) live.act('press', 0); });
    await press('One frame');
    seen.push(await hash());
  }
  for (let k = 2; k >= 0; k--) {
    await press('Back by a frame');
    check(await hash() === seen[k] && await frames(figure) === 60 + k, `${name} goes back to frame ${60 + k}`);
  }
  for (let k = 1; k < 70; k++) await figure.evaluate(({ live }) => live.back());
  check(await frames(figure) === 0, `${name} goes back to its beginning, not to frame ${await frames(figure)}`);
}

// What was done is in an address, and is done again where that is opened.
async function checkAddress(file, name, dial) {
  const page = await open(file, { reducedMotion: 'reduce' });
  const figure = page.locator(`[data-live="${name}"]`);
  await figure.evaluate(node => node.scrollIntoView({ block: 'center' }));
  await settled(page, name);
  await figure.evaluate(({ live }, [dial, value]) => {
    live.set(dial, value);
    live.act('begin');
    live.tick(5);
    live.act('press', 0);
    live.tick(25);
  }, dial);
  await figure.getByRole('button', { name: 'Copy an address of this' }).press('Enter');
  await page.waitForFunction(name => location.hash.startsWith(`#${name}=`), name, WAIT);
  const wanted = await figure.evaluate(({ live }) => [live.frames, live.core.hash()]), address = page.url();
  const other = await open(file, { reducedMotion: 'reduce' });
  await other.goto('about:blank');
  await other.goto(address);
  await other.waitForSelector(`[data-live="${name}"][data-ready]`, WAIT);
  const found = await other.locator(`[data-live="${name}"]`).evaluate(({ live }, frames) => { live.tick(Math.max(0, frames - live.frames)); return [live.frames, live.core.hash()]; }, wanted[0]);
  check(found.join() === wanted.join(), `${name}: an address does again what was done: ${wanted} and ${found}`);
  await page.close();
  await other.close();
}

// In the sandbox a touch of the floor puts one more there, above what is there already;
// and what was done last is taken back to the bit, a drag as a whole, without the dials.
async function checkSandbox(file) {
  const page = await open(file, { reducedMotion: 'reduce' });
  const figure = page.locator('[data-live="sandbox"]');
  await figure.evaluate(node => node.scrollIntoView({ block: 'center' }));
  await settled(page, 'sandbox');
  const state = () => figure.evaluate(({ live }) => [live.frames, live.core.hash(), +live.core.draw().said.match(/([0-9]+) bod/)[1]]);
  await figure.evaluate(({ live }) => { live.set(0, 16); live.set(1, 4); live.tick(2); });
  const box = await figure.locator('.live-stage canvas').boundingBox(), at = [box.x + box.width / 2, box.y + 0.8 * box.height];
  await page.mouse.click(...at);
  await figure.evaluate(({ live }) => live.tick(1));
  const one = await state();
  await page.mouse.click(...at);
  await figure.evaluate(({ live }) => live.tick(1));
  check((await state())[2] === 2, 'two touches of the floor put two cloths in');
  const fallen = await figure.evaluate(({ live }) => { live.tick(20); return live.core.draw().place.reduce((most, y, k) => k % 3 === 1 ? Math.max(most, y) : most, 0); });
  check(fallen < 2.2 && fallen > 0, `two cloths at one place fall, one above the other: the highest corner is at ${fallen.toFixed(2)} m`);
  await figure.evaluate(({ live }) => live.turn(3, 5));
  const undo = figure.getByRole('button', { name: 'Take back what you did last' });
  await undo.press('Enter');
  check((await state()).slice(0, 2).join() === one.slice(0, 2).join(), `the second cloth is taken back: ${await state()} is ${one}`);
  check(await figure.evaluate(({ live }) => live.past.acts.at(-1).slice(1).join()) === 'turn,3,5', 'and the wind stays');
  await figure.evaluate(({ live }) => { for (const y of [1, 1.2, 1.4]) { live.act('move', 0, 0, y, 0); live.tick(1); } live.act('release', 0); live.tick(1); });
  await undo.press('Enter');
  check(await figure.evaluate(({ live }) => live.past.acts.every(([, name]) => name !== 'move')), 'a drag is taken back as a whole');
  await undo.press('Enter');
  check((await figure.evaluate(({ live }) => live.core.draw().place.length)) < 20, 'and then the first cloth');
  await undo.press('Enter');
  check(/nothing to take back/.test(await figure.locator('.live-foot').textContent()), 'where nothing is to be taken back, it is said');
  const doll = await figure.evaluate(({ live }) => { live.set(3, 1); live.set(0, 4); live.tick(90); return live.core.draw().said; });
  check(/ragdoll/.test(doll), `the doll falls in a wind, and no number is lost: ${doll}`);
  check(page.errors.length === 0, `the sandbox has no error: ${page.errors[0]}`);
  await page.close();
}

// A film is made from one press to the next.
async function checkFilm(file, name) {
  const page = await open(file);
  const figure = page.locator(`[data-live="${name}"]`);
  await figure.evaluate(node => node.scrollIntoView({ block: 'center' }));
  await settled(page, name);
  await figure.getByRole('button', { name: 'Make a film' }).press('Enter');
  await page.waitForTimeout(2000);
  const [film] = await Promise.all([page.waitForEvent('download', WAIT), figure.getByRole('button', { name: 'Save the film' }).press('Enter')]);
  const size = readFileSync(await film.path()).length;
  check(film.suggestedFilename() === `${name}.webm` && size > 2000, `${name} is filmed: ${film.suggestedFilename()}, ${size} bytes`);
  await page.close();
}

// In a race each lane computes the same frames, and all come to the goal.
async function checkRace(file) {
  const page = await open(file), race = page.locator('[data-race]');
  await race.evaluate(node => node.scrollIntoView({ block: 'center' }));
  const lanes = race.locator('[data-small]');
  const count = (await race.getAttribute('data-runs')).split(' ').length;
  await page.waitForFunction(count => document.querySelectorAll('[data-race] [data-small][data-ready]').length === count, count, WAIT);
  check(await lanes.evaluateAll(nodes => nodes.every(node => node.live.frames === 0)), 'the race waits for its button');
  await lanes.evaluateAll(nodes => nodes.forEach(node => { node.live.drawing.draw = () => {}; }));
  await race.getByRole('button', { name: 'Race' }).press('Enter');
  await page.waitForSelector('[data-race][data-over]', WAIT).catch(() => check(false, 'the race comes to its end'));
  const ends = await lanes.evaluateAll(nodes => nodes.map(node => [node.live.frames, node.querySelector('.live-time').textContent]));
  check(ends.every(([frames, said]) => frames === 180 && /^\d+\.\d\d s, the /.test(said)), `each runs 180 frames, and is timed: ${ends.join('; ')}`);
  check(new Set(ends.map(([, said]) => said.replace(/.*the /, ''))).size === count, `and each has a place of its own: ${ends.join('; ')}`);
  const hashes = await lanes.evaluateAll(nodes => nodes.map(node => node.live.core.hash()));
  check(new Set(hashes).size === count, 'they are different methods');
  check(page.errors.length === 0, `the race has no error in its console: ${page.errors[0]}`);
  await page.close();
}

// --- Motion: only what is seen runs ---------------------------------------------
async function checkMotion(file, name) {
  const page = await open(file, { viewport: { width: 1300, height: 500 } });
  const figure = page.locator(`[data-live="${name}"]`);
  await figure.evaluate(node => node.scrollIntoView({ block: 'center' }));
  await settled(page, name);
  check(await figure.getAttribute('data-running') === '1', `${name} runs while it is seen`);
  await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
  await page.waitForSelector(`[data-live="${name}"][data-running="0"]`, WAIT);
  const stands = await frames(figure);
  await page.waitForTimeout(300);
  check(await frames(figure) === stands, `${name} stands while it is not seen`);
  await figure.getByRole('button', { name: 'Pause' }).press('Enter');
  check(await figure.getByRole('button', { name: 'Play' }).count() === 1, `${name} is paused by a key`);
  await page.close();
}

async function checkDrag(file) {
  const page = await open(file, { reducedMotion: 'reduce' });
  const ring = page.locator('[data-live="orbit"] .live-handle');
  await ring.scrollIntoViewIfNeeded();
  const before = await ring.getAttribute('cx');
  await ring.focus();
  await page.keyboard.press('ArrowRight');
  const moved = await ring.getAttribute('cx');
  check(moved !== before, 'the start of the planet moves by an arrow key');
  const box = await ring.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 60, box.y + 20);
  await page.mouse.up();
  check(await ring.getAttribute('cx') !== moved, 'and is dragged by the mouse');
  await page.close();
}

async function checkTouch(file) {
  const page = await open(file, { reducedMotion: 'reduce' });
  const figure = page.locator('[data-live="cube"]');
  await figure.evaluate(node => node.scrollIntoView({ block: 'center' }));
  await settled(page, 'cube');
  const stick = await find(figure, 0, 100);         // from 100 on: corners
  check(stick, 'a stick of the cube is seen, and not covered');
  if (!stick) return page.close();
  await page.mouse.click(stick.x, stick.y);
  check(/^21 sticks/.test(await figure.locator('.live-said').textContent()), 'a stick of the cube that is touched is taken away');
  await page.close();
}

// Numbers of what is drawn: the first of them that the eye can touch at a place.
const find = (figure, least, most) => figure.evaluate((node, [least, most]) => {
  const canvas = node.querySelector('.live-stage canvas');
  const { left, top, width, height } = canvas.getBoundingClientRect();
  for (let y = top; y < top + height; y += 4)
    for (let x = left; x < left + width; x += 4) {
      if (document.elementFromPoint(x, y) !== canvas) continue;     // a button is before it
      const number = node.live.drawing.pick({ clientX: x, clientY: y });
      if (number >= least && number < most) return { x, y };
    }
  return null;
}, [least, most]);

// Pins of the cloth are put by a button, and cut by a touch.
async function checkPins(file) {
  const page = await open(file, { reducedMotion: 'reduce' });
  const figure = page.locator('[data-live="drape"]');
  await figure.evaluate(node => node.scrollIntoView({ block: 'center' }));
  await settled(page, 'drape');
  check(await find(figure, 2, 100) === null, 'the cloth on the cube has no pin');
  await figure.getByRole('button', { name: 'Pin two corners' }).press('Enter');
  for (const left of [1, 0]) {
    const pin = await find(figure, 2, 100);
    check(pin, `a pin of the cloth is seen, and not covered: ${left + 1} are left`);
    if (!pin) break;
    await page.mouse.click(pin.x, pin.y);
    check((await find(figure, 2, 100) === null) === (left === 0), `a touch cuts a pin of the cloth: ${left} left`);
  }
  await page.close();
}

// What is dragged in a flat figure is let go with the finger.
async function checkRelease(file) {
  const page = await open(file);
  const figure = page.locator('[data-live="bounce"]'), ball = figure.locator('.live-handle');
  await figure.evaluate(node => node.scrollIntoView({ block: 'center' }));
  await settled(page, 'bounce');
  const stage = await figure.locator('.live-stage > svg').boundingBox();
  // It flies, so the finger may come too late: then once more.
  for (let k = 0; k < 20; k++) {
    const box = await ball.boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(stage.x + stage.width / 2, stage.y + 30, { steps: 4 });
    await page.waitForTimeout(200);
    if (Math.abs(await ball.getAttribute('cy') - 30) < 2) break;
    await page.mouse.up();
  }
  const comes = (least, most, sentence) => page.waitForFunction(([least, most]) => {
    const high = +document.querySelector('[data-live="bounce"] .live-handle').getAttribute('cy');
    return high > least && high < most;
  }, [least, most], WAIT).catch(() => check(false, sentence));
  await comes(28, 32, 'the ball is held where the finger is');
  await page.waitForTimeout(300);
  check(Math.abs(await ball.getAttribute('cy') - 30) < 2, 'and stays there');
  await page.mouse.up();
  await comes(60, 1e4, 'the ball that is let go falls');
  await page.close();
}

// The hash comes for figures that nobody has scrolled to, too.
async function checkUnseen(file, names) {
  const page = await open(file, { viewport: { width: 1300, height: 300 } });
  for (const name of names) {
    const hash = await (await page.waitForSelector(`[data-live="${name}"][data-hash]`, { ...WAIT, state: 'attached' })).getAttribute('data-hash');
    check(hash === await page.locator(`[data-live="${name}"]`).getAttribute('data-wants'), `${name} has its hash unseen`);
  }
  await page.close();
}

// Where scripts are off a figure is the picture that its page holds.
function checkStill(file, names) {
  const html = readFileSync(file, 'utf8');
  for (const name of names) check(RegExp(`<figure [^>]*data-live="${name}"[^>]*>\\s*<img [^>]*src="figures/live/${name}[.]webp"`).test(html), `${name} is a picture where scripts are off`);
}

const site = `${build}/site`, of = {};            // the figures of each page
for (const file of readdirSync(site).filter(file => file.endsWith('.html'))) {
  const names = [...readFileSync(`${site}/${file}`, 'utf8').matchAll(/data-live="(\w+)"/g)].map(found => found[1]);
  if (names.length) of[file.replace('.html', '')] = names;
}
const pages = chosen(some, Object.keys(of), 'page with live figures'), path = name => `${site}/${name}.html`;
await together(TOGETHER, pages, async name => {
  await attempt(name, fault, () => checkPage(path(name), of[name]));
  checkStill(path(name), of[name]);
});
if (!some.length) await together(TOGETHER, [
  [checkMotion, '01-verlet', 'orbit'],
  [checkUnseen, '09-system', of['09-system']],
  [checkPins, '09-system'],
  [checkRelease, '00-start'],
  [checkTouch, '03-body'],
  [checkDrag, '01-verlet'],
  [checkAddress, '18-world', 'energy', [2, 0.8]],
  [checkAddress, '19-library', 'sandbox', [2, 4]],
  [checkSandbox, '19-library'],
  [checkFilm, '19-library', 'sandbox'],
  [checkRace, '21-speed'],
], ([act, name, ...rest]) => attempt(`${name}, ${act.name}`, fault, () => act(path(name), ...rest)));

// --- Modules of the reader's own ------------------------------------------------
const awk = (...rest) => execFileSync('awk', [...rest], { encoding: 'utf8' });
const folder = `${build}/live/mine`, edits = ['-f', 'exercises/wrong.awk', 'tests/site/mine.edits'];

async function openMine(source) {
  mkdirSync(folder, { recursive: true });
  writeFileSync(`${folder}/verlet.c`, source);
  execFileSync('make', ['-s', 'live', '01', `MINE=${folder}/verlet.c`, `BUILD=${build}`], { stdio: ['ignore', 'ignore', 'pipe'] });
  return open(`${build}/swapped/live/01/index.html`);
}

async function checkMine(what, source, says) {
  const page = await openMine(source);
  await settled(page, 'orbit');
  const said = await page.locator('[data-live="orbit"]').evaluate(node => (node.dataset.trapped ?? '') + node.querySelector('.live-foot').textContent);
  check(RegExp(says).test(said), `${what}: the page says "${said}"`);
  await page.close();
}

// The memory of a module that stopped is not used again: this one counts its calls,
// and would stop at once.
async function checkRenewal(source) {
  const page = await openMine(source);
  const figure = page.locator('[data-live="orbit"]');
  const stops = async () => {
    await page.waitForSelector('[data-live="orbit"][data-trapped]', WAIT);
    return frames(figure);
  };
  const again = async () => {
    await figure.getByRole('button', { name: 'Start again' }).press('Enter');
    await page.waitForSelector('[data-live="orbit"]:not([data-trapped])', WAIT);
    return stops();
  };
  const first = await stops();
  check(first > 60, `a module that counts stops after frame 60, not at ${first}`);
  const second = await again();
  check(second === first, `a module that counts stops at frame ${first} again, not at ${second}`);
  await figure.getByLabel('steps a revolution').press('End');
  const third = await again();
  check(third > first / 5 && third < first / 3, `four times the steps stop it at a quarter of ${first}, not at ${third}`);
  await page.close();
}

const told = word => [...readFileSync('tests/site/mine.edits', 'utf8').matchAll(RegExp(`^${word} +(.*)$`, 'gm'))].map(found => found[1]);
const verlet = 'lib/particles/verlet.c';
if (!some.length) {
  const mine = (what, ...rest) => attempt(`01-verlet with ${what}`, fault, () => checkMine(what, ...rest));
  await mine('a right module', readFileSync(verlet, 'utf8'), 'to the last bit');
  const says = told('test');
  for (const [k, what] of told('wrong').entries())
    await mine(what, awk('-v', `want=${k + 1}`, ...edits, verlet), says[k]);
  await attempt('01-verlet with a module that counts', fault, () =>
    checkRenewal(readFileSync(verlet, 'utf8').replace('    vec3 here', '    static int calls;\n    assert(calls++ < 60);\n    vec3 here')));
}

await attempt('the browser', fault, () => browser.close());
console.log(`live figures: ${checks} checks, ${faults} faults, ${pages.flatMap(name => of[name]).length} figures on ${pages.length} pages`);
process.exit(faults ? 1 : 0);
