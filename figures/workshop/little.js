// little.js - the little program: the reader's, run beside the book's of a stage.

import { ask, script } from './tools.js';
import { button, kept, make, makeDesk, showMessages } from './desk.js';
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
  await script(`stage-${links[0].dataset.stage}`);
  const first = workshop.stages[links[0].dataset.stage];
  const film = makeFilm();
  const desk = await makeDesk(place, { key: 'little', label: 'Your little program', file: 'little.c', verb: 'Compile and run', start: () => first.source, act: run,
    more: [button('The book’s program here', bring), button('See it move', () => draw().catch(fail))] });
  place.desk = desk;
  place.prepend(title);
  place.append(film.node);
  const fail = error => { desk.tell(''); desk.say(make('p', { className: 'workshop-bad' }, error.message)); };

  const facts = async () => { await script(`stage-${stage}`); return workshop.stages[stage]; };
  function choose(name, isNew) {
    stage = name;
    kept.set('stage', name);
    links.forEach(link => link.toggleAttribute('aria-current', link.dataset.stage === name));
    const link = links.find(one => one.dataset.stage === name);
    title.textContent = `Stage ${name}: ${link.textContent}`;
    if (isNew) { desk.say(); film.clear(); }
  }
  links.forEach(link => { link.onclick = event => { event.preventDefault(); choose(link.dataset.stage, true); }; });
  const isOne = name => links.some(link => link.dataset.stage === name);
  addEventListener('hashchange', () => { if (isOne(location.hash.slice(1))) choose(location.hash.slice(1), true); });
  choose(isOne(stage) ? stage : '00a');

  // The book's program of the stage in the place of the reader's, which can be had back.
  async function bring() {
    const old = desk.text;
    desk.text = (await facts()).source;
    desk.say(make('p', {}, `The book’s program of stage ${stage}. `, button('Take that back', () => { desk.text = old; desk.say(); })));
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

  async function draw() {
    const { ran } = await made(true);
    desk.tell('');
    if (!ran) return;
    if (ran.fault) throw Error(ran.fault);
    if (!film.show(ran.printed)) desk.say(make('p', {}, 'This program draws nothing: from stage 03a on the book’s does, with the argument draw.'));
  }
}
