// exercise.js - an exercise of the page: its file, its judge, its hints, and what was
// written moving in the chapter's live figure.

import { ask, script } from './tools.js';
import { kept, makeDesk, showMessages } from './desk.js';
import { button, make } from './node.js';

const workshop = window.tumble.workshop;
const bad = sentence => make('p', { className: 'workshop-bad' }, sentence);

export async function openExercise(place) {
  const id = place.dataset.exercise;
  await script(id);
  const facts = workshop[id], { name } = facts;
  facts.files = {};
  const hint = button('Hint', showHint), answer = button('The book’s answer', () => showAnswer());
  const figure = document.querySelector('figure[data-live]');
  const move = figure && facts.module && button('See it move', () => moveFigure().catch(error => { desk.tell(''); desk.say(bad(error.message)); }));
  const desk = await makeDesk(place, { key: name, label: `Your file for ${name}`, file: 'mine.c', verb: 'Compile and judge', start: () => facts.stub, act: judge, more: [hint, answer, ...(move ? [move] : [])] });
  const shown = () => +(kept.get(`${name}:hints`) ?? 0);
  place.desk = desk;
  labelHint();
  const hole = desk.text.split('\n').findIndex(line => line.includes('Yours to write.'));
  if (hole >= 0) desk.editor.show(hole + 1);

  function labelHint() { hint.textContent = shown() < facts.hints.length ? `Hint ${shown() + 1} of ${facts.hints.length}` : 'The hints again'; }
  function showHint() {
    const next = shown() < facts.hints.length ? [shown()] : facts.hints.keys();
    desk.say(...[...next].map(k => make('p', {}, make('b', {}, `Hint ${k + 1} of ${facts.hints.length}. `), facts.hints[k])));
    kept.set(`${name}:hints`, Math.min(shown() + 1, facts.hints.length));
    labelHint();
  }
  function showAnswer(isSure) {
    if (isSure || kept.get(`${name}:passed`)) { desk.say(make('pre', { className: 'workshop-answer', tabIndex: 0 }, facts.solution)); return; }
    desk.say(make('p', {}, `You have read ${shown()} of ${facts.hints.length} hints. `, button('Show it', () => showAnswer(true))));
  }

  async function judge() {
    await Promise.all([script('headers'), script('judge'), script(`${id}-judged`)]);
    for (const file of facts.data) {
      const [name] = file.split('/').slice(-1);
      await script(name.replace('.txt', ''));
      facts.files[file] = workshop[name];
    }
    const source = desk.text, out = await ask('judge', { source, headers: workshop.headers, facts, judge: workshop['judge_page.o'] }, desk.tell);
    const messages = showMessages(desk, out.messages);
    desk.out = out;
    if (!out.told) { desk.say(bad(`${name}: this does not compile: begin with the first error.`), ...messages); return; }
    const { told } = out;
    if (told.pass) showPassed(told, messages); else showFailed(told, messages);
  }

  function showPassed(told, messages) {
    kept.set(`${name}:passed`, new Date().toISOString().slice(0, 10));
    desk.say(make('p', { className: 'workshop-good' }, `${name}: all ${told.ran} tests pass.`), ...(move ? [make('p', {}, 'Now see it move.')] : []), ...messages, ...next());
  }

  function next() {
    const link = document.querySelector('.task a.next');
    return link ? [make('p', {}, 'The next exercise is ', link.cloneNode(true), '.')] : [];
  }

  function showFailed(told, messages) {
    const { place: at } = told;
    if (at) desk.editor.mark([...desk.out.messages.filter(one => one.file === 'mine.c'), { line: at.line, kind: 'error', text: told.sentence }]);
    const lines = [make('p', {}, make('b', {}, `${name}: ${told.good} of ${told.ran} tests pass.`), ' The first that does not:'),
      make('p', {}, make('code', {}, told.first), ` (${told.source}, line ${told.line})`),
      make('p', { className: 'workshop-bad' }, told.sentence, ...(at ? [' ', button(`line ${at.line}`, () => desk.editor.show(at.line, true), { className: 'workshop-line' })] : []))];
    if (told.printed) lines.push(make('p', {}, 'Your code printed:'), make('pre', {}, told.printed));
    if (told.comment) lines.push(make('p', {}, 'The test’s own comment:'), make('blockquote', {}, told.comment));
    if (told.others.length) lines.push(make('p', {}, `The others: ${told.others.join(', ')}.`));
    if (told.left) lines.push(make('p', {}, `${told.left} more were not tried.`));
    desk.say(...lines, ...messages);
  }

  // Right or wrong, it moves beside the book's, which is pale.
  async function moveFigure() {
    desk.say();
    desk.tell('Compiling …');
    await Promise.all([script('headers'), script(`figure-${id}`)]);
    const { wasm, messages } = await ask('figure', { source: desk.text, headers: { ...workshop.headers, ...facts.headers }, objects: workshop.figure.objects }, desk.tell);
    desk.tell('');
    if (!wasm) { desk.say(bad(`${name}: this does not compile: begin with the first error.`), ...showMessages(desk, messages)); return; }
    figure.scrollIntoView({ block: 'center' });
    await figure.live.swap(wasm);
    desk.say(make('p', {}, 'It moves in the figure, beside the book’s, which is pale: ', make('b', {}, figure.querySelector('.live-foot').textContent)));
  }
}
