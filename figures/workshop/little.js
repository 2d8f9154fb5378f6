// little.js - the little program, which becomes the reader's own engine: run beside
// the book's of a stage, seen moving, and saved as a page that runs by itself.

import { ask, script } from './tools.js';
import { kept, makeDesk, showMessages } from './desk.js';
import { button, make } from './node.js';
import { makeFilm } from './film.js';

const workshop = window.tumble.workshop;
const SECONDS = 60;             // as at the desk

// The lines that a program prints, NAME VALUE UNIT: name -> { value, unit }.
function linesOf(text) {
  const lines = new Map();
  for (const line of text.split('\n')) {
    const found = line.match(/^(.*?) +(\S+) +(\S+)$/);
    if (found) lines.set(found[1], { value: found[2], unit: found[3] });
  }
  return lines;
}

// Which of a stage's claims hold, and which do not.
function judged(claims, lines) {
  return claims.map(claim => {
    const [, name, how, limit] = claim.match(/^(.*) ([<>]?=?) (-?[\d.e-]+)$/), is = lines.get(name);
    const holds = is && /^-?[\d.]+(e[-+]?\d+)?$/.test(is.value) && { '<': +is.value < +limit, '>': +is.value > +limit, '<=': +is.value <= +limit, '>=': +is.value >= +limit, '=': +is.value === +limit }[how];
    return { claim, holds, why: !is ? 'it is not printed' : `it is ${is.value} ${is.unit}` };
  });
}

const same = (a, b) => a && a.unit === b.unit && Math.abs(a.value - b.value) <= Math.abs(b.value) / 1000;

// What both print, a row each; the same to a thousandth is the same.
function table(yours, ours) {
  const row = (name, is) => {
    const here = yours.get(name), alike = same(here, is);
    return make('tr', { className: alike ? '' : 'workshop-other' }, make('th', { scope: 'row' }, name), make('td', {}, here ? `${here.value} ${here.unit}` : 'not printed'), make('td', {}, `${is.value} ${is.unit}`));
  };
  const head = make('thead', {}, make('tr', {}, ...['', 'yours', 'the book’s'].map(text => make('th', { scope: 'col' }, text))));
  return make('div', { className: 'workshop-table', tabIndex: 0 }, make('table', {}, head, make('tbody', {}, ...[...ours].map(([name, is]) => row(name, is)))));
}

export async function openLittle(place) {
  let stage = location.hash.slice(1) || kept.get('stage');
  const links = [...document.querySelectorAll('[data-stage]')];
  const title = make('h2', { className: 'workshop-stage' });
  // Where the list of stages is not beside the editor, it is above it in one line.
  const stages = make('select', { className: 'workshop-stages', ariaLabel: 'Stage', onchange: () => choose(stages.value, true) });
  for (const link of links) {
    const name = link.dataset.stage, label = `Chapter ${name.slice(0, 2)}`;
    if (stages.lastChild?.label !== label) stages.append(make('optgroup', { label }));
    stages.lastChild.append(new Option(`${name}: ${link.textContent}`, name));
  }
  await script(`stage-${links[0].dataset.stage}`);
  const first = workshop.stages[links[0].dataset.stage];
  const film = makeFilm();
  const desk = await makeDesk(place, { key: 'little', label: 'Your little program', file: 'little.c', verb: 'Compile and run', start: () => first.source, act: run,
    more: [button('The book’s program here', bring), button('See it move', () => draw().catch(fail)), button('Save as a page', () => savePage().catch(fail))] });
  place.desk = desk;
  place.prepend(title, stages);
  place.append(film.node);
  const fail = error => { desk.tell(''); desk.say(make('p', { className: 'workshop-bad' }, error.message)); };

  const facts = async () => { await script(`stage-${stage}`); return workshop.stages[stage]; };
  function choose(name, isNew) {
    stage = name;
    kept.set('stage', name);
    links.forEach(link => link.toggleAttribute('aria-current', link.dataset.stage === name));
    const link = links.find(one => one.dataset.stage === name);
    title.textContent = `Stage ${name}: ${link.textContent}`;
    stages.value = name;
    if (isNew) { desk.say(); film.clear(); }
  }
  links.forEach(link => { link.onclick = event => { event.preventDefault(); choose(link.dataset.stage, true); }; });
  const isOne = name => links.some(link => link.dataset.stage === name);
  addEventListener('hashchange', () => { if (isOne(location.hash.slice(1))) choose(location.hash.slice(1), true); });
  choose(isOne(stage) ? stage : '00a');

  // The book's program of the stage in the place of the reader's, which can be had back.
  async function bring() {
    desk.replace((await facts()).source, `The book’s program of stage ${stage}. `);
  }

  async function made(draws) {
    await script('runner');
    const out = desk.out = await ask('run', { source: desk.text, runner: workshop['printed.o'], seconds: SECONDS, draws }, desk.tell);
    const messages = showMessages(desk, out.messages);
    if (!out.ran) desk.say(make('p', { className: 'workshop-bad' }, 'This does not compile: begin with the first error.'), ...messages);
    return { ...out, messages };
  }

  async function run() {
    const { ran, messages } = await made(false), book = await facts();
    if (!ran) return;
    const yours = linesOf(ran.printed), ours = linesOf(book.printed);
    const alike = [...ours].filter(([name, is]) => same(yours.get(name), is)).length;
    const claims = judged(book.claims, yours), broken = claims.filter(one => !one.holds);
    const isOurs = !ran.fault && ran.hash === book.hash;
    place.dataset.hash = ran.hash;
    place.dataset.wants = book.hash;
    desk.say(
      ...(ran.fault ? [make('p', { className: 'workshop-bad' }, ran.fault)] : []),
      make('p', { className: broken.length ? '' : 'workshop-good' }, broken.length ? `Not yet stage ${stage}:` : `All that stage ${stage} claims holds for yours.`),
      ...(broken.length ? [make('ul', {}, ...broken.map(({ claim, why }) => make('li', {}, `${claim}: ${why}`)))] : []),
      make('p', {}, `${alike} of ${ours.size} lines are the same as the book’s. Bits ${ran.hash.slice(0, 8)}…`, isOurs ? make('b', { className: 'workshop-good' }, ': yours, bit for bit') : `; the book’s are ${book.hash.slice(0, 8)}…`, ` (${ran.seconds.toFixed(1)} s)`),
      table(yours, ours), ...(ran.printed && !yours.size ? [make('pre', {}, ran.printed.slice(0, 4000))] : []), ...messages);
  }

  // What the reader's draws; and when that moves, the book's beside it, pale.
  async function draw() {
    desk.say();
    const { ran } = await made(true);
    desk.tell('');
    if (!ran) return;
    if (ran.fault) throw Error(ran.fault);
    if (!film.show(ran.printed)) { desk.say(nothing()); return; }
    const { source } = await facts();
    if (source === desk.text) { desk.say(make('p', {}, 'Yours is the book’s, to the letter.')); return; }
    const book = await ask('run', { source, runner: workshop['printed.o'], seconds: SECONDS, draws: true }, desk.tell);
    desk.tell('');
    if (!book.ran.printed) return;
    const alike = book.ran.hash === ran.hash;
    if (!alike) film.beside(book.ran.printed);
    desk.say(alike ? make('p', { className: 'workshop-good' }, 'It moves as the book’s does: yours, bit for bit.') : make('p', {}, `The pale one is the book’s of stage ${stage}.`));
  }
  const nothing = () => make('p', {}, 'This program draws nothing: from stage 03a on the book’s does, with the argument draw.');

  // One file that runs anywhere: the program, what runs it, and what it draws.
  async function savePage() {
    desk.say();
    const { ran, wasm } = await made(true);
    desk.tell('');
    if (!ran) return;
    if (ran.fault) throw Error(ran.fault);
    if (!film.show(ran.printed)) { desk.say(nothing()); return; }
    await script('player');
    const page = pageOf(await pack(wasm), desk.text), url = URL.createObjectURL(new Blob([page], { type: 'text/html' }));
    make('a', { href: url, download: 'my-engine.html' }).click();
    setTimeout(() => URL.revokeObjectURL(url), 1e3);
    desk.say(make('p', {}, `my-engine.html, ${Math.round(page.length / 1e3)} kB: it needs nothing but a browser. Keep it, or send it to a friend.`));
  }
}

async function pack(bytes) {
  const all = new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(new CompressionStream('gzip'))).arrayBuffer());
  let letters = '';
  for (let k = 0; k < all.length; k += 0x8000) letters += String.fromCharCode(...all.subarray(k, k + 0x8000));
  return btoa(letters);
}

const written = text => text.replace(/[&<>]/g, sign => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;' })[sign]);
const pageOf = (program, source) => `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><meta name="color-scheme" content="light dark"><title>My engine</title>
<style>
:root { --page: #fffefb; --ink: #22252a; --quiet: #5d636d; --rule: #d9d6cd; }
@media (prefers-color-scheme: dark) { :root { --page: #16181c; --ink: #e4e2dc; --quiet: #a3a8b0; --rule: #3a3f47; } }
body { margin: 0 auto; max-width: 56rem; padding: 1.5rem 1rem 4rem; background: var(--page); color: var(--ink); font: 1.125rem/1.5 Palatino, "Palatino Linotype", Georgia, serif; }
h1 { font-size: 2rem; margin: 0; } p { color: var(--quiet); margin: .4rem 0; } figure { margin: 1rem 0; }
canvas { display: block; width: 100%; height: auto; cursor: grab; touch-action: pan-y; }
button { font: inherit; font-size: .9rem; color: inherit; background: none; border: 1px solid var(--rule); border-radius: 6px; min-height: 44px; padding: 0 1rem; margin-right: .5rem; }
button[aria-pressed=true] { border-color: var(--ink); } pre { overflow-x: auto; font-size: .8rem; line-height: 1.45; }
</style></head><body>
<h1>My engine</h1><p id="said">This needs a browser that runs scripts.</p><main></main>
<details><summary>The whole program: ${source.split('\n').length} lines of C</summary><pre>${written(source)}</pre></details>
<script type="text/plain" id="program">${program}</script>
<script>${workshop.player}</script>
</body></html>
`;
