// check_workshop.mjs - is an exercise judged in the page as it is at the desk?  Of one
// of each chapter the book's answer passes, and wrong answers are told in the desk's
// sentence; and the page does what a reader expects of it:
//   node check_workshop.mjs BUILD [WRONGS [NN-name...]]      (or reader, phone, keys, little)
// WRONGS: so many wrong answers of each, from the first to the last (0: all).

import { execFile, execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import { attempt, awaitedLater, chosen, launch, together } from './browser.mjs';
import { serve } from './server.mjs';

const build = resolve(process.argv[2]), most = +(process.argv[3] ?? 2);
const usual = ['01-step', '02-stick', '03-rank', '04-nearest', '05-features', '06-ball', '07-separate', '08-lists', '09-scene', 'reader', 'phone', 'keys', 'little'];
const site = `${build}/site`, WAIT = { timeout: 300e3 };
const TOGETHER = 2;             // exercises, at a time
const TRIES = 3;                // so often a busy machine may be late
if (!existsSync(`${site}/write-01-step.html`)) { console.log('workshop: the site was made without it'); process.exit(0); }
const asked = process.argv.slice(4), written = readdirSync(site).flatMap(file => file.match(/^write-(.*)\.html$/)?.[1] ?? []);
const ids = asked.length ? chosen(asked, [...new Set([...usual, ...written])], 'exercise') : usual;

let checks = 0, faults = 0;
function check(holds, sentence) {
  checks++;
  if (!holds) fault(`not so: ${sentence}`);
}
function fault(sentence) {
  faults++;
  console.log(sentence);
}
const awk = (...rest) => execFileSync('awk', rest, { encoding: 'utf8' });

// --- What an exercise has: its answer, and wrong ones -----------------------------
function answersTo(id) {
  const module = readFileSync(`exercises/${id}/exercise`, 'utf8').match(/^module +(\w+)/m)?.[1];
  const right = module ? execFileSync('sh', ['-c', `ls lib/*/${module}.c`], { encoding: 'utf8' }).trim() : `exercises/${id}/solution.c`;
  const told = awk('-f', 'exercises/wrong.awk', `exercises/${id}/wrong`).trim().split('\n').map(line => line.replace(/^\d+ \S+ /, ''));
  const apart = !most || most >= told.length ? 1 : (told.length - 1) / Math.max(most - 1, 1), tried = !most ? told.length : Math.min(most, told.length);
  const numbers = Array.from({ length: tried }, (_, k) => Math.floor(k * apart));
  return { right: readFileSync(right, 'utf8'),
    wrong: numbers.map(k => ({ number: k + 1, what: told[k], source: awk('-v', `want=${k + 1}`, '-f', 'exercises/wrong.awk', `exercises/${id}/wrong`, right) })) };
}

// What the desk says of the wrong ones.
async function deskOf(id, wrong) {
  const folder = `${build}/workshop/desk/${id}`;
  for (const { number, source } of wrong) {
    mkdirSync(`${folder}/${number}`, { recursive: true });
    writeFileSync(`${folder}/${number}/mine.c`, source);
  }
  await promisify(execFile)('sh', ['tests/site/desk.sh', id.replace('-', '/'), folder, ...wrong.map(one => String(one.number))], { env: { ...process.env, BUILD: process.argv[2] } });
  return wrong.map(({ number }) => readFileSync(`${folder}/${number}/told`, 'utf8'));
}

// What both must say alike: how many pass, which test comes first, and what is wrong.
// Times are of the machine; a place in the reader's file is of how far the compiler
// has moved it; what is undefined is told in the compiler's own words, and so is what
// stands for infinity.
function gist(text) {
  text = text.replaceAll('((double)__builtin_inff())', 'INFINITY').replaceAll('(__builtin_inff ())', 'INFINITY').replaceAll('(__builtin_huge_val ())', 'INFINITY').replaceAll('__builtin_huge_val ()', 'INFINITY');
  const [, counted] = text.match(/^(.* tests pass)/m) ?? [];
  const [, test, sentence] = text.match(/does not:\s+(\w+) {2}\(.*\n {2}(.*)$/m) ?? [];
  return { counted, test, sentence: (sentence ?? '').replace(/(undefined:).*/, '$1').replace(/\((stopped after|[\d.]+ seconds)[^)]*\)/, '')
    .replace(/exercises\/[\w-]+\//g, '').replace(/: (mine\.c, line|\S+, line).*/, '').replace(/, tests\/.*| {2}.*/, '').replace(/\.$/, '').trim() };
}

// --- The page -------------------------------------------------------------------------
const browser = await launch(process.argv[2]);
const host = await serve(site);
async function open(address, options = {}, place = '[data-exercise]') {
  const page = await (await browser.newContext({ viewport: { width: 1300, height: 900 }, acceptDownloads: true, ...options })).newPage();
  page.setDefaultTimeout(WAIT.timeout);
  page.errors = [];
  page.asked = [];
  page.on('console', said => said.type() === 'error' && page.errors.push(said.text()));
  page.on('pageerror', error => page.errors.push(error.message));
  page.on('request', request => page.asked.push(request.url()));
  await page.goto(address);
  await page.waitForFunction(place => document.querySelector(place).desk, place, WAIT);
  return page;
}
// A picture in space is slow to paint without a graphics card, and all else waits.
const calm = page => page.evaluate(() => document.querySelectorAll('[data-live]').forEach(node => node.live.loop.play(false)));
const put = (page, text) => page.evaluate(text => { document.querySelector('[data-exercise]').desk.text = text; }, text);
const said = page => page.textContent('.workshop-said');
// Presses the button, and waits for what is said; with the time that it took.
async function judged(page) {
  const from = Date.now();
  await page.click('.workshop-act');
  await page.waitForFunction(() => !document.querySelector('.workshop-act').disabled, null, WAIT);
  const out = await page.evaluate(() => document.querySelector('[data-exercise]').desk.out);
  return { ...out, ms: Date.now() - from, said: await said(page) };
}
const disk = id => pathToFileURL(`${site}/write-${id}.html`).href;

// What passed moves in the chapter's figure with the book's bits.
async function checkMotion(page, id) {
  await page.getByRole('button', { name: 'See it move' }).press('Enter');
  await page.waitForFunction(() => /yours, bit for bit/.test(document.querySelector('.live-foot').textContent), null, WAIT)
    .catch(async () => check(false, `${id}: the book's answer moves with the book's bits: ${await page.textContent('.live-foot')}`));
  await calm(page);
  checks++;
}

// What is wrong moves as well, away from the book's.
async function checkGhost(page, right) {
  const law = 'last_move, dt * dt, a';
  check(right.includes(law), `verlet.c still has ${law}`);
  await put(page, right.replace(law, 'last_move, 0.9 * dt * dt, a'));
  await page.getByRole('button', { name: 'See it move' }).press('Enter');
  await page.waitForSelector('[data-live][data-parted]', WAIT).catch(() => check(false, 'a wrong step parts from the book’s'));
  check(await page.locator('.live-ghost').first().evaluate(node => node.childNodes.length) > 0, 'and the book’s is drawn beside it');
  checks++;
}

async function checkExercise(id, address) {
  const { right, wrong } = answersTo(id), told = awaitedLater(deskOf(id, wrong));
  const page = await open(address);
  check(!page.asked.some(url => /clang-\d/.test(url)), `${id}: the compiler is not fetched before it is asked for`);
  await put(page, right);
  await calm(page);
  const first = await judged(page), second = await judged(page);
  check(second.told?.pass, `${id}: the book's answer passes: ${second.said.slice(0, 300)}`);
  if (await page.getByRole('button', { name: 'See it move' }).count()) await checkMotion(page, id);
  if (id === '01-step') await checkGhost(page, right);
  // From here on there is no network, and none is asked for.
  const asked = page.asked.length, times = [], desk = await told;
  await page.context().setOffline(true);
  for (const [k, { number, what, source }] of wrong.entries()) {
    await put(page, source);
    // In the page time is the clock's: where others compute as well, what takes long
    // may be taken for what does not end.
    // At the desk a test that is late counts as failed as well.
    let here, there = JSON.stringify(gist(desk[k]));
    for (let tries = 0; tries < TRIES && here !== there; tries++) {
      if (tries) there = JSON.stringify(gist((await deskOf(id, [wrong[k]]))[0]));
      const out = await judged(page);
      here = JSON.stringify(gist(out.text ?? ''));
      if (tries === 0) times.push(out.ms);
    }
    check(here === there, `${id}, wrong ${number} (${what}): the page says ${here}, the desk ${there}`);
  }
  const later = page.asked.slice(asked).filter(url => !/^(blob|data):/.test(url));
  check(!later.length, `${id}: once it has judged it asks for nothing: ${later[0]}`);
  check(page.errors.length === 0, `${id}: no error in the console: ${page.errors[0]}`);
  console.log(`${id}: first ${first.ms} ms, then ${second.ms} ms; ${wrong.length} wrong answers, median ${times.sort((a, b) => a - b)[times.length >> 1]} ms; ${address.replace(/:.*/, '')}`);
  await page.context().close();
}

// --- What a reader does ----------------------------------------------------------------
async function checkReader() {
  const page = await open(disk('01-step')), { right } = answersTo('01-step');
  const text = () => page.evaluate(() => document.querySelector('[data-exercise]').desk.text);
  const stub = await text();
  check(/Yours to write/.test(stub), 'the file begins with its holes');

  // Faults that no test names are told in a sentence, with the line.
  const faulty = async (from, to, wanted) => {
    check(right.includes(from), `verlet.c still has the line ${from}`);
    await put(page, right.replace(from, to));
    const { said } = await judged(page);
    check(wanted.test(said), `"${to}" is told: ${said.slice(0, 300)}`);
  };
  const here = 'vec3 here = p[i].position;';
  await faulty('return status_ok();', 'retrun status_ok();', /line 22.*error: .*retrun/s);
  check(await page.locator('.cm-lint-marker-error').count() === 1, 'and its line is marked');
  await faulty(here, `${here} while (dt > 0) i = i;`, /does not end .*mine\.c, line \d+/s);
  await faulty(here, `${here} *(volatile int *)0xfffffff0 = 1;`, /follows a pointer that leads nowhere .*mine\.c, line \d+/s);
  await faulty(here, `${here} *(volatile int *)dt_none() = 1;`, /does not compile.*dt_none/s);
  await faulty(here, `${here} verlet_step(p, n, gravity, force, dt);`, /calls itself without end, until the stack is full.*mine\.c, line \d+/s);
  await faulty(here, `${here} malloc(24);`, /does not free all that it allocates \(a leak of \d+ bytes\)/);
  await faulty(here, `${here} exit(0);`, /ends the whole program \(exit\)/);
  await faulty(here, `${here} for (;;) printf("on and on\\n");`.replace('for (;;)', 'while (1)'), /prints without end|undeclared|does not compile/);

  // What was written stays, goes to a file, and comes from one.
  await put(page, right);
  await page.reload();
  await page.waitForFunction(() => document.querySelector('[data-exercise]').desk, null, WAIT);
  check(await text() === right, 'what was written is there again');
  const [file] = await Promise.all([page.waitForEvent('download'), page.click('text=Save as a file')]);
  const saved = `${build}/workshop/saved.c`;
  copyFileSync(await file.path(), saved);
  check(file.suggestedFilename() === 'mine.c' && readFileSync(saved, 'utf8') === right, 'it is saved as mine.c');
  await page.click('text=Begin again');
  check(await text() === stub, 'it begins again');
  await page.click('text=Take that back');
  check(await text() === right, 'and that is taken back');
  await put(page, stub);
  const opened = async () => {
    await page.setInputFiles('.workshop input[type=file]', saved);
    await page.waitForFunction(text => document.querySelector('[data-exercise]').desk.text === text, right);
  };
  await opened();
  await page.click('text=Take that back');
  check(await text() === stub, 'what was there before a file was opened can be had back');
  await page.setInputFiles('.workshop input[type=file]', { name: 'photo.c', mimeType: 'text/x-c', buffer: Buffer.from([0xff, 0xd8, 0, 1]) });
  await page.waitForFunction(() => /photo\.c is no text/.test(document.querySelector('.workshop-said').textContent));
  check(await text() === stub, 'what is no text is not opened');
  await opened();
  await page.click('text=Hint 1 of 3');
  check(/Write the step first/.test(await said(page)), 'the first hint is told');

  // By keys alone: what is typed is in the file, and Ctrl-Enter in the editor judges.
  await page.focus('.cm-content');
  await page.keyboard.press('Control+End');
  await page.keyboard.type('// a / b');
  check((await text()).endsWith('// a / b'), `what is typed is in the file, a slash as well: ${(await text()).slice(-20)}`);
  await page.keyboard.press('Control+Enter');
  await page.waitForFunction(() => !document.querySelector('.workshop-act').disabled, null, WAIT);
  check(/all 24 tests pass/.test(await said(page)), 'Ctrl-Enter judges what was written');
  check(page.errors.length === 0, `no error in the console: ${page.errors[0]}`);
  await page.context().close();
}

// On a phone the task is read first: the page begins at its top, when the editor has
// come as well, and there the editor shows what is to be written.  The little program
// begins with its first line.
async function checkPhone() {
  const options = { viewport: { width: 390, height: 844 }, reducedMotion: 'reduce', hasTouch: true };
  const page = await open(disk('03-rank'), options);
  await page.waitForFunction(() => document.querySelector('.cm-activeLine')?.textContent.includes('Yours to write'), null, WAIT);
  await page.waitForTimeout(1000);
  check(await page.evaluate(() => scrollY) === 0, `a phone begins with the task, not ${await page.evaluate(() => scrollY)} px below it`);
  await page.locator('.workshop-act').tap();
  await page.waitForFunction(() => !document.querySelector('.workshop-act').disabled, null, WAIT);
  check(await page.locator('.workshop-said > :first-child').evaluate(node => { const box = node.getBoundingClientRect(); return box.top >= 0 && box.bottom <= innerHeight; }), 'a phone shows what is said, below the editor');
  await page.context().close();
  const little = await open(pathToFileURL(`${site}/little.html`).href, options, '[data-little]');
  await little.waitForSelector('.cm-scroller', WAIT);
  await little.waitForTimeout(1000);
  check(await little.evaluate(() => document.querySelector('.cm-scroller').scrollTop) === 0, 'the little program begins with its first line');
  check(await little.evaluate(() => document.querySelector('.task').scrollHeight <= document.querySelector('.task').clientHeight), 'its task does not scroll in itself');
  await little.locator('.workshop-stages').selectOption('02c', { timeout: 10e3 }).catch(() => {});
  check(await little.locator('[data-stage="02c"][aria-current]').count() === 1, 'and a stage is chosen above the editor');
  await little.context().close();
}

// Tab goes into the editor and, after Escape, out of it; so does what was typed to the
// judge, and on to the next exercise: five in a row, without a mouse.
async function checkKeys(all) {
  const page = await open(disk(all[0]));
  const reach = async (what, where) => {
    for (let k = 0; k < 120; k++) {
      await page.keyboard.press('Tab');
      if (await page.evaluate(where => document.activeElement.matches(where), where)) return true;
    }
    check(false, `Tab comes to ${what}`);
    return false;
  };
  for (const id of all) {
    if (!page.url().includes(id)) {
      await page.goto(disk(id));
      await page.waitForFunction(() => document.querySelector('[data-exercise]').desk, null, WAIT);
    }
    await page.emulateMedia({ reducedMotion: 'reduce' });
    if (!await reach(`the editor of ${id}`, '.cm-content')) continue;
    const judge = async source => {
      await page.evaluate(() => { document.querySelector('.workshop-said').textContent = ''; });
      await page.keyboard.press('Control+a');
      await page.keyboard.insertText(source);
      await page.keyboard.press('Control+Enter');
      await page.waitForFunction(() => /tests? pass|does not compile/.test(document.querySelector('.workshop-said').textContent), null, WAIT).catch(() => {});
      return said(page);
    };
    const { right, wrong: [wrong] } = answersTo(id), first = await judge(wrong.source), then = await judge(right);
    check(/\d+ of \d+ tests pass/.test(first) && !/all \d+ tests pass/.test(first), `${id}: a wrong answer (${wrong.what}) is told by keys: ${first.slice(0, 200)}`);
    check(/all \d+ tests pass/.test(then), `${id} is solved by keys: ${then.slice(0, 200)}`);
    await page.keyboard.press('Escape');
    if (!await reach(`the next exercise after ${id}`, '.workshop-said a.next, .task a.next')) continue;
    const next = await page.evaluate(() => document.activeElement.getAttribute('href'));
    await page.keyboard.press('Enter');
    await page.waitForURL(url => url.href.endsWith(next), WAIT).catch(() => check(false, `Enter leads to ${next}`));
    await page.waitForFunction(() => document.querySelector('[data-exercise]').desk, null, WAIT);
    console.log(`${id}: by keys, and on to ${next}`);
  }
  check(page.errors.length === 0, `no error in the console: ${page.errors[0]}`);
  await page.context().close();
}

// --- The little program --------------------------------------------------------------
// The book's program of a stage runs with the desk's bits, another one does not; what
// a program draws moves.
async function checkLittle(stages) {
  const page = await open(pathToFileURL(`${site}/little.html`).href, {}, '[data-little]');
  const run = async () => {
    const from = Date.now();
    await page.click('.workshop-act');
    await page.waitForFunction(() => !document.querySelector('.workshop-act').disabled, null, WAIT);
    return { ms: Date.now() - from, said: await said(page), ...await page.evaluate(() => document.querySelector('[data-little]').dataset) };
  };
  for (const stage of stages) {
    await page.click(`[data-stage="${stage}"]`);
    await page.getByRole('button', { name: 'The book’s program here' }).click();
    await page.waitForFunction(stage => document.querySelector('.workshop-said').textContent.includes(`of stage ${stage}`), stage, WAIT);
    const { ms, said, hash, wants } = await run();
    check(hash === wants && /yours, bit for bit/.test(said), `stage ${stage} has the bits ${wants}, not ${hash}: ${said.slice(0, 200)}`);
    check(said.includes(`All that stage ${stage} claims holds for yours`), `stage ${stage} holds what it claims: ${said.slice(0, 300)}`);
    console.log(`stage ${stage}: ${ms} ms`);
  }
  const text = () => page.evaluate(() => document.querySelector('[data-little]').desk.text);
  const put = text => page.evaluate(text => { document.querySelector('[data-little]').desk.text = text; }, text);
  await page.click('[data-stage="03b"]');
  await page.getByRole('button', { name: 'The book’s program here' }).click();
  await page.waitForFunction(() => /of stage 03b/.test(document.querySelector('.workshop-said').textContent), null, WAIT);
  const book = await text();
  check(book.includes('9.81'), 'stage 03b has the acceleration of gravity in it');
  await put(book.replace('9.81', '9.8'));
  const other = await run();
  check(other.hash !== other.wants && /the book’s are/.test(other.said), `another gravity has other bits: ${other.said.slice(0, 200)}`);
  await put(book.replace(/int main\(([^)]*)\)\n\{/, 'int main($1)\n{\n    for (volatile int i = 0; i < 1; i--) if (i < -5) i = 0;'));
  const endless = await run();
  check(/does not end \(stopped after 60 seconds\): mine\.c, line \d+/.test(endless.said), `a program without end is told: ${endless.said.slice(0, 200)}`);
  await put(book);
  await page.getByRole('button', { name: 'See it move' }).click();
  await page.waitForSelector('.workshop-film[data-frames]', WAIT);
  check(+await page.getAttribute('.workshop-film', 'data-frames') > 10, 'what stage 03b draws moves');
  await put(book.replace('9.81', '6'));
  await page.getByRole('button', { name: 'See it move' }).click();
  await page.waitForSelector('.workshop-film[data-twin]', WAIT).catch(() => check(false, 'the book’s moves beside another'));

  // A page of it runs by itself, with the same bits.
  await put(book);
  const [file] = await Promise.all([page.waitForEvent('download', WAIT), page.getByRole('button', { name: 'Save as a page' }).click()]);
  const saved = resolve(build, 'workshop', 'my-engine.html');
  copyFileSync(await file.path(), saved);
  const alone = await page.context().newPage();
  alone.on('pageerror', error => page.errors.push(error.message));
  alone.on('request', request => check(/^(file|blob|data):/.test(request.url()), `the saved page asks for nothing: ${request.url()}`));
  await alone.goto(pathToFileURL(saved).href);
  await alone.waitForSelector('.workshop-film[data-frames]', WAIT).catch(async () => check(false, `the saved page moves: ${await alone.textContent('#said')}`));
  check(+await alone.getAttribute('.workshop-film', 'data-frames') > 10, 'the saved page has its frames');
  console.log(`the saved page: ${readFileSync(saved).length} bytes`);
  check(page.errors.length === 0, `no error in the console: ${page.errors[0]}`);
  await page.context().close();
}

await together(TOGETHER, ids, (id, k) => attempt(id, fault, async () => {
  if (id === 'reader') await checkReader();
  else if (id === 'phone') await checkPhone();
  else if (id === 'keys') await checkKeys(['01-step', '02-stick', '03-rank', '06-ball', '07-separate']);
  else if (id === 'little') await checkLittle(['00a', '02c', '05c', '07c', '13e', '16c']);
  else await checkExercise(id, k % 2 ? `${host.address}write-${id}.html` : disk(id));
}));
await attempt('the browser', fault, () => browser.close());
host.end();
console.log(`workshop: ${checks} checks, ${faults} faults`);
process.exit(faults ? 1 : 0);
