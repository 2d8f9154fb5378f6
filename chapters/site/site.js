// site.js - what moves in a page that stands still: the list of headings follows
// the reader, code is unfolded, and the whole book is searched.

const all = (what, where = document) => [...where.querySelectorAll(what)];
function make(kind, holds = {}, ...inside) {
  const node = Object.assign(document.createElement(kind), holds);
  node.append(...inside);
  return node;
}

// --- the list of headings ---
const side = document.querySelector('.side');
if (side) {
  const links = new Map(all('a', side).map(a => [decodeURIComponent(a.hash.slice(1)), a]));
  const heads = [...links.keys()].map(id => document.getElementById(id));
  const narrow = matchMedia('(max-width: 72rem)');
  const fold = () => { side.firstElementChild.open = !narrow.matches; };
  narrow.addEventListener('change', fold);
  fold();
  let now;
  const follow = () => {
    const at = heads.findLast(head => head.getBoundingClientRect().top < 140);
    if (at === now) return;
    links.get(now?.id)?.classList.remove('here');
    links.get(at?.id)?.classList.add('here');
    side.scrollTop = (links.get(at?.id)?.offsetTop ?? 0) - side.clientHeight / 2;
    now = at;
  };
  addEventListener('scroll', () => requestAnimationFrame(follow), { passive: true });
  follow();
}

// --- long pieces of code ---
const pieces = all('figure.code details');
if (pieces.length) {
  const unfold = open => pieces.forEach(piece => { piece.open = open; });
  const button = make('button', { type: 'button' });
  const show = open => {
    button.textContent = open ? 'Fold long code' : 'Unfold all code';
    button.onclick = () => { localStorage.setItem('code', open ? '' : 'open'); unfold(!open); show(!open); };
  };
  const open = localStorage.getItem('code') === 'open';
  if (open) unfold(true);
  show(open);
  side?.firstElementChild.append(button);
  addEventListener('beforeprint', () => unfold(true));
}

// --- exercises: those that passed in this browser ---
for (const head of all('h3[id]')) {
  const name = head.id.replace('-', '/');
  let passed;
  try { passed = localStorage.getItem(`tumble:${name}:passed`); } catch { /* nothing is kept */ }
  if (passed) head.append(make('span', { className: 'passed', title: passed }, ' passed'));
}

// --- search ---
const field = document.querySelector('input[type="search"]');
const script = src => new Promise((done, failed) => document.head.append(make('script', { src, onload: done, onerror: failed })));
// A summary names everything, and a name of code is meant where it is written so.
const weight = (key, term, row) => row.id === 'sources' ? .2 : /^(in-short|what-the-paper-says)$/.test(row.id) || /_/.test(row.head) && !/_/.test(term) ? .5 : 1;
// What is asked in a sentence: its small words are left out, its endings too.
const small = new Set('a an and are at be can do does for from how i in is it me my of on or the this to what when where which who why with'.split(' '));
function stem(word) {
  const term = word.toLowerCase();
  return small.has(term) ? null : /_/.test(term) || term.length < 6 ? term : term.replace(/(ing|ed|es|s)$/, '');
}
let index;
// Read when the field is first used: a row of search.js is a section or a name of code.
const read = () => index ||= Promise.all([script('minisearch.js'), script('search.js')]).then(() => {
  const search = new MiniSearch({
    fields: ['head', 'text', 'page'], storeFields: ['page', 'id', 'head', 'text'], idField: 'key',
    tokenize: text => text.split(/[^\p{L}\p{N}_]+/u).filter(Boolean),
    searchOptions: { boostDocument: weight, processTerm: stem, boost: { head: 6, page: 10 }, prefix: true, fuzzy: term => term.length > 5 ? .15 : 0 },
  });
  search.addAll(window.sections.map(([page, id, head, text], key) => ({ key, page, id, head, text })));
  return search;
});
// The words around the first that is found.
function around(text, terms) {
  const at = Math.max(0, ...terms.slice(0, 1).map(term => text.toLowerCase().indexOf(term)));
  const from = at < 60 ? 0 : text.indexOf(' ', at - 60) + 1;
  const words = text.slice(from, from + 150).split(/([\p{L}\p{N}_]+)/u);
  return words.map(word => terms.includes(word.toLowerCase()) ? make('mark', {}, word) : word);
}
const found = make('ul', { className: 'found', hidden: true });
field.after(found);
async function look() {
  const wanted = field.value.trim();
  if (!wanted) { found.hidden = true; return; }
  const search = await read(), whole = search.search(wanted, { combineWith: 'AND' });
  const hits = (whole.length ? whole : search.search(wanted)).slice(0, 12);
  if (field.value.trim() !== wanted) return;
  found.replaceChildren(...hits.map(hit => make('li', {},
    make('a', { href: `${hit.page}.html${hit.id ? '#' + hit.id : ''}` },
      make('b', {}, hit.head), `${hit.page.replace('-', ' ')} · `, ...around(hit.text, hit.terms)))));
  if (!hits.length) found.append(make('li', {}, 'Nothing is called that.'));
  found.hidden = false;
}
field.addEventListener('focus', read, { once: true });
field.addEventListener('input', look);
field.form.addEventListener('submit', event => {
  event.preventDefault();
  found.querySelector('a')?.click();
});
addEventListener('keydown', event => {
  const { tagName, isContentEditable } = document.activeElement;
  const typing = isContentEditable || /^(INPUT|TEXTAREA|SELECT)$/.test(tagName);
  if (event.key === '/' && !typing) { event.preventDefault(); field.focus(); }
  if (event.key === 'Escape') { found.hidden = true; }
  if (/^Arrow(Up|Down)$/.test(event.key) && !found.hidden && field.form.contains(document.activeElement)) {
    const stops = [field, ...all('a', found)];
    stops[(stops.indexOf(document.activeElement) + (event.key === 'ArrowDown' ? 1 : stops.length - 1)) % stops.length].focus();
    event.preventDefault();
  }
});
addEventListener('click', event => { if (!field.form.contains(event.target)) found.hidden = true; });

// --- moving pictures: after all else has come, while they are seen, and not if the
// reader wants rest ---
for (const figure of all('.moving')) {
  const picture = figure.querySelector('img'), still = picture.src;
  const dark = figure.querySelector('source'), darkStill = dark?.srcset;
  const button = make('button', { type: 'button' });
  let isStopped = matchMedia('(prefers-reduced-motion: reduce)').matches;
  const move = moving => {
    picture.src = moving ? figure.dataset.moving : still;
    if (dark) dark.srcset = moving ? figure.dataset.dark : darkStill;
    button.textContent = moving ? 'Stop' : 'Play';
    button.onclick = () => { isStopped = moving; move(!moving); };
  };
  picture.parentNode.after(button);
  move(false);
  addEventListener('load', () => setTimeout(() => new IntersectionObserver(([seen]) => {
    if (!isStopped) move(seen.isIntersecting);
  }, { threshold: .5 }).observe(picture), 300));
}
