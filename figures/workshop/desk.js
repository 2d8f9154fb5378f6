// desk.js - an editor with its buttons, and what was said: what an exercise and a
// stage of the little program have in common.

import { script, isHere, megabytes, stop } from './tools.js';
import { button, make } from './node.js';

// What was written stays in this browser, if it lets us.
export const kept = {
  get(key) { try { return localStorage.getItem(`tumble:${key}`); } catch { return null; } },
  set(key, value) { try { localStorage.setItem(`tumble:${key}`, value); } catch { /* not kept */ } },
  drop(key) { try { localStorage.removeItem(`tumble:${key}`); } catch { /* nor dropped */ } },
};

// A field as plain as they come, in which the reader writes until the editor is there.
function makeField(place, text, label, changed, act) {
  const field = make('textarea', { value: text, ariaLabel: label, spellcheck: false, autocapitalize: 'off', wrap: 'off', oninput: changed });
  field.onkeydown = event => { if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) { event.preventDefault(); act(); } };
  field.setSelectionRange(0, 0);        // else it begins at its end
  place.append(field);
  return {
    field,
    get text() { return field.value; },
    set text(text) { field.value = text; changed(); },
    mark() {},
    show(line) {
      const at = field.value.split('\n').slice(0, line - 1).join('\n').length + (line > 1);
      field.setSelectionRange(at, at);
      field.scrollTop = (line - 1) * field.scrollHeight / field.value.split('\n').length - field.clientHeight / 2;
    },
  };
}

const loaded = new Promise(done => { if (document.readyState === 'complete') done(); else addEventListener('load', done); });

// plan: { key, label, file, start() the text to begin with, act() what the first
// button does, verb its name, more: buttons }.
export async function makeDesk(place, plan) {
  const said = make('div', { className: 'workshop-said', role: 'status' });
  const bar = make('progress', { max: 1, hidden: true });
  const state = make('span', { className: 'workshop-state' });
  const act = button(plan.verb, run, { className: 'workshop-act' });
  const end = button('Stop', () => stop('Stopped.'), { hidden: true });
  const file = make('input', { type: 'file', accept: '.c,text/x-c,text/plain', hidden: true });
  file.onchange = async () => {
    const [one] = file.files, text = await one?.text();
    file.value = '';
    if (/[\0\ufffd]/.test(text)) desk.say(make('p', { className: 'workshop-bad' }, `${one.name} is no text: what you wrote stays.`));
    else if (one) desk.replace(text, `${one.name} is open here. `);
  };
  const more = make('div', { className: 'workshop-more' }, ...plan.more,
    button('Begin again', () => desk.replace(plan.start(), 'As at the beginning. ')), button('Save as a file', save), button('Open a file', () => file.click()), file);
  const room = make('div', { className: 'workshop-editor' });
  place.replaceChildren(make('div', { className: 'workshop-bar' }, act, end, state, bar), room, more, said);
  if (!isHere()) state.textContent = `The first time brings a compiler, ${megabytes()} MB${matchMedia('(pointer: coarse)').matches ? '.' : '; Ctrl-Enter does the same.'}`;

  const changed = () => kept.set(plan.key, desk.text);
  const desk = {
    editor: makeField(room, kept.get(plan.key) ?? plan.start(), plan.label, changed, run),
    get text() { return desk.editor.text; },
    set text(text) { desk.editor.text = text; },
    say(...nodes) { said.replaceChildren(...nodes); },
    // What is taken away can be had back once.
    replace(text, words) {
      const old = desk.text;
      desk.text = text;
      desk.say(make('p', {}, words, button('Take that back', () => { desk.text = old; desk.say(); })));
    },
    tell(text, part) {
      state.textContent = text;
      bar.hidden = part === undefined;
      if (part !== undefined) bar.value = part;
    },
  };

  // The editor comes when all that is read is there, and goes on where the field was left.
  async function furnish() {
    await loaded;
    await script('editor');
    const { field } = desk.editor, isWriting = document.activeElement === field;
    desk.editor = window.tumble.workshop.makeEditor(room, field.value, plan.label, changed, run);
    desk.editor.take(field, isWriting);
    field.remove();
  }

  async function run() {
    if (act.disabled) return;
    act.disabled = true;
    end.hidden = false;
    desk.say();
    desk.editor.mark([]);
    try {
      await plan.act(desk);
      desk.tell('');
    } catch (error) {
      desk.tell('');
      desk.say(make('p', { className: 'workshop-bad' }, sentence(error)));
    }
    act.disabled = false;
    end.hidden = true;
    reveal();
  }

  // A long file, or a phone: what is said of it stands below the window.
  function reveal() {
    const first = said.firstElementChild;
    if (first && first.getBoundingClientRect().bottom > innerHeight) said.scrollIntoView({ block: 'nearest' });
  }

  function save() {
    const link = make('a', { href: URL.createObjectURL(new Blob([desk.text], { type: 'text/x-c' })), download: plan.file });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1e3);
  }

  furnish().catch(error => desk.tell(error.message));
  return desk;
}

function sentence({ message }) {
  if (/memory|allocat|Array buffer/i.test(message)) return `There is too little memory for the compiler here (${message}).`;
  return message;
}

// What the compiler says of the reader's file: the lines are marked, and named.
export function showMessages(desk, messages) {
  const own = messages.filter(({ file }) => file === 'mine.c');
  desk.editor.mark(own);
  if (!messages.length) return [];
  // Of a file with errors the warnings may be about what the compiler made of it.
  const wrong = messages.filter(({ kind }) => kind === 'error'), shown = wrong.length ? wrong : messages.filter(({ kind }) => kind !== 'note');
  return [make('ul', { className: 'workshop-messages' }, ...shown.slice(0, 20).map(one =>
    make('li', { className: one.kind }, one.file === 'mine.c'
      ? button(`line ${one.line}`, () => desk.editor.show(one.line, true), { className: 'workshop-line' }) : `${one.file}, line ${one.line}`, `: ${one.kind}: ${one.text}`,
      ...(one.more.length ? [make('pre', {}, one.more.slice(0, 3).join('\n').trimEnd())] : []))))];
}
