// bench.mjs - runs in the page: turns a figure's own dials, steps it by hand, and
// judges what it shows.

// Gives the node of a live figure a function bench(moves).  It answers what was
// wrong first and at which move, and how long the longest frame took.
export function bench(node) {
  const MEASURED = 4;           // some charts have a value of every fourth frame
  const WIDE = 184, HIGH = 104; // px, of a picture in small
  const { live } = node, canvas = node.querySelector('.live-stage canvas');
  document.querySelectorAll('[data-live]').forEach(other => other.live.loop.play(false));
  // A picture in space is slow to paint without a graphics card: only the last is.
  const paint = live.drawing.draw.bind(live.drawing);
  if (canvas) live.drawing.draw = () => {};

  // ms: how long do a million turns of a loop take here and now?
  function million() {
    let x = 2;
    const from = performance.now();
    for (let k = 0; k < 1e6; k++) x = Math.sqrt(x + k);
    return performance.now() - from + (x < 0);
  }

  // One of the handles goes to a place of its pane: 0 to 1, from the left and from below.
  function drag(any, x, y) {
    const handles = node.querySelectorAll('.live-handle'), handle = handles[any % handles.length];
    if (!handle) return;
    const panes = [...node.querySelectorAll('.live-stage > svg')];
    const [left, bottom, wide, high] = live.panel.panes[panes.indexOf(handle.closest('svg'))];
    handle.inside(left + x * wide, bottom + y * high);
    live.act('release', handle.number);
  }

  // A dial, a button of the figure's own, Start again, or a hand.
  function act({ dial, value, button, again, ...hand }) {
    if (hand.drag !== undefined) return drag(hand.drag, hand.x, hand.y);
    if (again) return [...node.querySelectorAll('button')].find(one => (one.ariaLabel ?? one.textContent) === 'Start again').click();
    if (button !== undefined) return node.querySelectorAll('.live-own')[button].click();
    const inputs = node.querySelectorAll('.live-dial, .live-choice')[dial].querySelectorAll('input');
    if (inputs[0].type === 'radio') return inputs[value].click();
    inputs[0].value = value;
    return inputs[0].dispatchEvent(new Event('input'));
  }

  // What is drawn, said and charted has to be numbers.
  function unsound() {
    const lists = live.guard(() => live.core.draw());
    if (!lists) return null;
    for (const name of ['flat', 'place', 'normal', 'tint', 'ball', 'tube', 'edge'])
      if (!lists[name].every(Number.isFinite)) return `what is drawn as "${name}" is no number`;
    if (/\bnan\b|\binf\b/i.test(lists.said)) return `it says "${lists.said}"`;
    for (const [c, { plan, colours }] of live.charts.entries())
      for (const k of colours.keys()) {
        if (plan.time || live.frames < MEASURED) continue;
        const bad = (plan.over ? [...lists.curve(c, k)] : [lists.value(c, k)]).find(x => !Number.isFinite(x));
        if (bad !== undefined) return `line ${k + 1} of "${plan.name}" is ${bad}`;
      }
    return null;
  }

  // Is there a shape within a pane, but for the handles?
  const isWithin = (one, box) => one.width + one.height > 2 && one.right > box.left &&
    one.left < box.right && one.bottom > box.top && one.top < box.bottom;
  const showsShapes = () => [...node.querySelectorAll('.live-stage > svg')].some(pane =>
    [...pane.querySelectorAll(':scope > g:not(.live-ghost) > :not(.live-handle)')].some(shape => isWithin(shape.getBoundingClientRect(), pane.getBoundingClientRect())));

  // Are there pixels of bodies?  Those of shadows are not solid.
  function showsBodies() {
    const small = new OffscreenCanvas(WIDE, HIGH).getContext('2d');
    small.drawImage(canvas, 0, 0, WIDE, HIGH);
    return small.getImageData(0, 0, WIDE, HIGH).data.some((value, k) => k % 4 === 3 && value === 255);
  }

  function isEmpty() {
    live.guard(() => paint(live.core.draw()));
    return canvas ? !showsBodies() : !showsShapes();
  }

  // One frame; answers what is wrong with it.
  function step(found, unit) {
    const from = performance.now();
    live.step();
    if (!live.stopped) live.guard(() => live.core.draw());
    const ms = performance.now() - from;
    if (ms > found.ms) Object.assign(found, { ms, millions: ms / unit, slow: found.move });
    return live.stopped ? null : unsound();
  }

  node.bench = moves => {
    const unit = Math.max(million(), million());
    const found = { ms: 0, millions: 0, slow: 0, wrong: null };
    for (found.move = 0; found.move < moves.length; found.move++) {
      act(moves[found.move]);
      for (let frame = 1; frame <= moves[found.move].frames && !live.stopped; frame++) {
        found.wrong = step(found, unit);
        if (found.wrong) return found;
      }
      found.stopped = live.stopped;
      if (live.stopped) return { ...found, wrong: `stopped, since ${live.stopped}` };
    }
    found.move = moves.length - 1;
    if (isEmpty()) found.wrong = 'the picture is empty';
    return found;
  };
}
