// paper.js - a picture that does not fit below the text goes to the next page, and
// leaves a hole.  Here it becomes a little smaller, or lets the text after it go first.
// Each chapter is laid out in columns as large as the pages will be, and looked at.

const WIDE = 170, HIGH = 251, APART = 20, MM = 96 / 25.4;       // mm; px
const HOLE = .16;                       // of a page: less is no hole
const LITTLE = .75, LEAST = .5;         // how small a picture may be: gladly, and at all
const PAST = 6;                         // pieces of text that may go first

function settle(chapter) {
  const style = chapter.getAttribute('style'), high = HIGH * MM;
  Object.assign(chapter.style, { width: `${WIDE}mm`, height: `${HIGH}mm`, columnWidth: `${WIDE}mm`, columnGap: `${APART}mm`, columnFill: 'auto' });
  const { left, top } = chapter.getBoundingClientRect();
  const first = node => node.getClientRects()[0], last = node => [...node.getClientRects()].at(-1);
  const column = box => Math.round((box.left - left) / ((WIDE + APART) * MM));
  const above = node => {
    for (let one = node; one !== chapter; one = one.parentElement) if (one.previousElementSibling) return one.previousElementSibling;
    return null;
  };
  // px that are left on the page before.  A heading goes with what is below it.
  const hole = figure => {
    const own = column(first(figure));
    for (let one = above(figure); one; one = above(one)) {
      const box = last(one);
      if (!box) continue;
      if (column(box) < own) return Math.max(0, top + high - box.bottom);
      if (!/^H\d$/.test(one.tagName)) return 0;
    }
    return 0;
  };
  const isText = node => node && !/^(H\d|SECTION|FIGURE)$/.test(node.tagName) || node?.matches?.('figure.code, figure.data');

  // The size with which it would stand below the text, as a part of what it has.
  const shrink = (figure, room, least) => {
    const image = figure.querySelector('img'), { height } = image.getBoundingClientRect();
    const size = Math.min(.97, (room - (first(figure).height - height) - 60) / height);
    if (size < least) return false;
    image.style.maxHeight = `${Math.floor(size * height)}px`;
    if (hole(figure) < HOLE * high) return true;
    image.style.maxHeight = '';
    return false;
  };
  // The place, within so many pieces, that leaves the smallest hole.
  const letPass = (figure, room) => {
    let best = figure.previousElementSibling, least = room;
    const home = best, put = after => { if (after) after.after(figure); else figure.parentElement.prepend(figure); };
    for (let k = 0; k < PAST && isText(figure.nextElementSibling) && least >= HOLE * high; k++) {
      const next = figure.nextElementSibling;
      next.after(figure);
      // What announces the next piece stays with it.
      if (/:\s*$/.test(next.textContent)) continue;
      const left = hole(figure);
      if (left < least) { least = left; best = next; }
    }
    if (least > room / 2) best = home;
    put(best);
    return hole(figure) < HOLE * high;
  };
  for (const figure of chapter.querySelectorAll('figure:not(.code, .data)')) {
    const room = hole(figure);
    if (room < HOLE * high) continue;
    if (!shrink(figure, room, LITTLE) && !letPass(figure, room)) shrink(figure, hole(figure), LEAST);
  }
  if (style) chapter.setAttribute('style', style); else chapter.removeAttribute('style');
}

addEventListener('load', () => document.fonts.ready.then(() => document.querySelectorAll('section.level1').forEach(settle)));
