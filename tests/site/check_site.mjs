// check_site.mjs - are the pages of build/site good pages?  Each is opened in a real
// browser, from a host of our own, as a phone on a slow network would, and looked
// at in light and dark:   node check_site.mjs FOLDER [PAGE...]

import { readdirSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { resolve } from 'node:path';
import { attempt, chosen, launch, needs, together, unpainted } from './browser.mjs';
import { serve } from './server.mjs';
import { checkLinks } from './links.mjs';

const [folder, ...named] = process.argv.slice(2);
const build = resolve(folder, '..');

const PHONE = { width: 390, height: 844 };
const SLOWER = 4;                                   // than this machine's processor
const NETWORK = { offline: false, latency: 150, downloadThroughput: 1.6e6 / 8, uploadThroughput: .75e6 / 8 };
// A page may take twice as long as a plain one of its words and bytes: one half of the
// wait no page is without, the other is for what style, fonts and scripts compute.
// They come in two round trips more: the style, then the fonts that it names.  All of
// it is a ratio, since seconds are of the machine and of what else it does.
// A page that is slow at first is tried again, and only such a page: a busy machine is
// slow by chance, a heavy page every time.
const LOAD = 2, TRIES = 8;
const TRIPS = 2 * NETWORK.latency / 1e3;            // s
// What this network brings in two seconds, but for the two round trips.
const BYTES = (2 - TRIPS) * NETWORK.downloadThroughput;
const TOGETHER = 4;                                 // pages, at a time
const TYPE = 12;                                    // pixels, at least
const WAIT = 600e3;                                 // ms for a live figure's frame 60, and all else

let faults = 0;
const fault = (page, sentence) => { faults++; console.log(`${page}: ${sentence}`); };

// A page that tells of errors, and of what it asks of other machines.
async function open(context, name) {
  const page = await context.newPage();
  page.setDefaultTimeout(WAIT);
  await unpainted(page);
  page.on('console', said => said.type() === 'error' && fault(name, `the console says: ${said.text()}`));
  page.on('pageerror', error => fault(name, `an error: ${error.message}`));
  page.on('request', request => {
    if (!/^(http:\/\/127\.0\.0\.1|file:|data:|blob:)/.test(request.url())) fault(name, `asks for ${request.url()}`);
  });
  return page;
}

// The best of some times: what else this machine does is not the page's fault.  It
// is judged by the same words and bytes as a plain page, loaded between its tries.
async function load(browser, name, address) {
  let page, bytes = 0, seconds = Infinity, plain = Infinity;
  for (let k = 0; k < TRIES && (k === 0 || seconds > LOAD * plain); k++) {
    await page?.context().close();
    const one = await loadOnce(await browser.newContext({ viewport: PHONE }), name, address);
    ({ page, bytes } = one);
    const other = await loadOnce(await browser.newContext({ viewport: PHONE }), `${name}?plain=${bytes}`, address);
    await other.page.context().close();
    seconds = Math.min(seconds, one.seconds);
    plain = Math.min(plain, other.seconds + TRIPS);
  }
  const times = seconds / plain;
  if (times > LOAD) fault(name, `takes ${times.toFixed(2)} times as long as its words and bytes alone`);
  if (bytes > BYTES) fault(name, `has ${bytes} bytes`);
  return { page, seconds, times, bytes };
}

// How long it loads, and how many bytes come, on a slow phone.
async function loadOnce(context, name, address) {
  const page = await open(context, name);
  const session = await context.newCDPSession(page);
  // What comes after the page has loaded, such as a figure's module, is not of its load;
  // on a busy machine it is here before this program hears of the load.
  const came = [];
  session.on('Network.loadingFinished', event => came.push(event));
  const load = new Promise(done => session.once('Page.loadEventFired', done));
  await session.send('Network.enable');
  await session.send('Page.enable');
  await session.send('Network.emulateNetworkConditions', NETWORK);
  await session.send('Emulation.setCPUThrottlingRate', { rate: SLOWER });
  await page.goto(address + name, { waitUntil: 'load' });
  const seconds = await page.evaluate(() => performance.getEntriesByType('navigation')[0].loadEventEnd / 1e3);
  const { timestamp } = await load;
  const bytes = came.filter(event => event.timestamp <= timestamp).reduce((sum, event) => sum + event.encodedDataLength, 0);
  await session.send('Emulation.setCPUThrottlingRate', { rate: 1 });
  await session.send('Network.emulateNetworkConditions', { ...NETWORK, latency: 0, downloadThroughput: -1, uploadThroughput: -1 });
  return { page, seconds, bytes };
}

// What sticks out of the window, but for what scrolls in itself.
async function checkWidth(page, name) {
  await page.addStyleTag({ content: '* { content-visibility: visible !important }' });
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  if (wide > PHONE.width) fault(name, `is ${wide} pixels wide`);
}

// The words of a chart have 13 pixels where the chart is drawn at its own size.
async function checkCharts(page, name) {
  const small = await page.evaluate(least => [...document.querySelectorAll('picture')]
    .filter(({ firstElementChild: narrow, lastElementChild: chart }) => 13 * chart.clientWidth / narrow.width < least)
    .map(picture => picture.lastElementChild.getAttribute('src')), TYPE);
  for (const chart of small) fault(name, `the words of ${chart} have less than ${TYPE} pixels`);
}

const CONTROL = 'a[href], button, input, select, textarea, summary, [tabindex="0"], [contenteditable="true"]';
// Where so many presses of Tab lead, in turn: numbers of stops, or what else it is.  A
// figure that was not there before brings controls of its own.  One press waits for no
// other, as the browser takes them in turn.
async function tabThrough(page, presses) {
  await page.evaluate(control => {
    window.met = [];
    document.addEventListener('focusin', ({ target }) => window.met.push(target.dataset.stop
      ?? `${target.tagName}.${target.className}${target.matches(control) ? ' new' : ''}`));
  }, CONTROL);
  const session = await page.context().newCDPSession(page);
  const key = type => session.send('Input.dispatchKeyEvent', { type, key: 'Tab', code: 'Tab', windowsVirtualKeyCode: 9 });
  await Promise.all(Array.from({ length: presses }, () => [key('rawKeyDown'), key('keyUp')]).flat());
  await session.detach();
  return page.evaluate(() => window.met);
}

// Tab has to come to each control, and to what scrolls, and to nothing else.
async function checkTab(page, name) {
  const wanted = await page.evaluate(control => {
    const scrolls = node => node.scrollWidth > node.clientWidth && /auto|scroll/.test(getComputedStyle(node).overflowX) && !node.querySelector(control);
    const stops = [...document.querySelectorAll('body *')].filter(node =>
      (node.matches(control) || scrolls(node)) && !node.disabled && node.tabIndex >= -1 && node.checkVisibility({ visibilityProperty: true })
      && !node.closest('details:not([open]) > :not(summary)') && !(node.type === 'radio' && !node.checked));
    stops.forEach((node, k) => { node.dataset.stop = k; });
    document.activeElement.blur();
    scrollTo(0, 0);
    return stops.map(node => (node.textContent || node.ariaLabel || node.className).trim().slice(0, 40));
  }, CONTROL);
  const met = await tabThrough(page, wanted.length + 20), seen = new Set();
  for (const stop of met) {
    if (seen.has(stop)) break;
    if (!/^\d+$|new$/.test(stop)) fault(name, `Tab comes to ${stop}, which is no control`);
    seen.add(stop);
  }
  wanted.forEach((text, k) => seen.has(String(k)) || fault(name, `Tab does not come to "${text}"`));
  return wanted.length;
}

// axe-core judges the contrast of all that is written.
async function checkContrast(page, name) {
  if (!await page.evaluate(() => 'axe' in window)) await page.addScriptTag({ path: needs(build).resolve('axe-core') });
  for (const colorScheme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme });
    const bad = await page.evaluate(async () => (await window.axe.run({ runOnly: ['color-contrast'], resultTypes: ['violations'] }))
      .violations.flatMap(rule => rule.nodes.map(node => `${node.target.join(' ')}: ${node.any[0]?.message}`)));
    for (const one of bad.slice(0, 5)) fault(name, `${colorScheme}: ${one}`);
  }
}

// Each live figure comes to frame 60 with the bits of a native run.
async function checkLive(page, name) {
  const figures = await page.locator('figure[data-live]').all();
  for (const figure of figures) {
    // Sections that were not rendered grow as they come near, and move the figure
    // out of view: a reader goes on scrolling.
    let hash;
    for (const end = Date.now() + WAIT; !hash && Date.now() < end;) {
      await figure.evaluate(node => node.scrollIntoView({ block: 'center' }));
      await page.waitForTimeout(100);
      hash = await figure.evaluate(({ dataset }) => dataset.trapped || dataset.ready && dataset.hash);
    }
    const [live, wants] = await figure.evaluate(node => [node.dataset.live, node.dataset.wants]);
    if (hash !== wants) fault(name, `${live} comes to ${hash}, and ${wants} is wanted`);
  }
  return figures.length;
}

// What is typed into the field of a page on the disk finds the code, and the prose.
async function checkSearch(browser, name, finds) {
  const page = await open(await browser.newContext({ viewport: PHONE }), name);
  await page.goto(pathToFileURL(resolve(folder, name)).href);
  for (const [words, wanted] of finds) {
    await page.keyboard.press('/');
    await page.fill('input[type="search"]', words);
    await page.waitForSelector('.found:not([hidden]) a', { timeout: 60e3 }).catch(() => fault(name, `a search for ${words} finds nothing`));
    const first = await page.locator('.found a').first().getAttribute('href');
    if (!first?.startsWith(wanted)) fault(name, `a search for ${words} leads to ${first}, and ${wanted} is wanted`);
    await page.keyboard.press('Enter');
    await page.waitForURL(url => url.href.includes(wanted), { timeout: 60e3 }).catch(() => fault(name, `Enter does not lead to ${wanted}`));
  }
  console.log(`${finds.length} searches`);
  await page.context().close();
}

// The page as it is read from a disk: only its errors matter.
async function openFile(context, name) {
  const page = await open(context, name);
  await page.goto(pathToFileURL(resolve(folder, name)).href, { waitUntil: 'load' });
  await page.close();
}

const { faults: dead, count, pages } = checkLinks(folder);
dead.forEach(sentence => fault('links', sentence));
console.log(`${pages} pages, ${count} links`);

const browser = await launch(build);
const host = await serve(resolve(folder));
// The pages of exercises are made alike: one stands for all.
const known = readdirSync(folder).filter(file => file.endsWith('.html')).map(file => file.replace('.html', ''));
const names = chosen(named, named.length ? known : known.filter(name => !/^write-(?!01-step)/.test(name)), 'page').map(name => `${name}.html`);
async function checkPage(name) {
  const { page, seconds, times, bytes } = await load(browser, name, host.address);
  // What moves is slow to paint without a graphics card: it stands from here on.
  await page.emulateMedia({ reducedMotion: 'reduce' });
  const figures = await checkLive(page, name);
  await checkWidth(page, name);
  await checkCharts(page, name);
  const stops = await checkTab(page, name);
  await checkContrast(page, name);
  await openFile(page.context(), name);
  console.log(`${name.padEnd(24)} ${String(Math.round(bytes / 1e3)).padStart(5)} kB  ${seconds.toFixed(2)} s, ${times.toFixed(2)} times plain` +
    `  ${String(stops).padStart(3)} stops of Tab${figures ? `, ${figures} live figures` : ''}`);
  await page.context().close();
}
// Most of the time a page waits for the slow network: some are looked at together.
await together(TOGETHER, names, name => attempt(name, sentence => fault('the test', sentence), () => checkPage(name)));
await attempt('the search', sentence => fault('index.html', sentence), () => checkSearch(browser, 'index.html', [
  ['gjk_distance', '04-gjk.html#gjk_distance'], ['minkowski diff', '04-gjk.html'], ['why does my cloth stretch', '16-cloth.html'],
]));
await attempt('the browser', sentence => fault('the test', sentence), () => browser.close());
host.end();
console.log(faults ? `${faults} faults` : 'the site is sound');
process.exit(faults ? 1 : 0);
