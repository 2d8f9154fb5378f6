// bench.mjs - runs in the page: turns a figure's own dials, steps it by hand, and
// judges what it shows.

// Gives the node of a live figure a function bench(moves).  It answers what was
// wrong first and at which move, and how long the longest frame took.
export function bench(node) {
  const MEASURED = 4;           // some charts have a value of every fourth frame
  const { live } = node, canvas = node.querySelector('.live-stage canvas');
  document.querySelectorAll('[data-live]').forEach(other => other.live.loop.play(false));
  // Only the last picture is painted.
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

  // Is a corner, a ball or an end of a tube before the camera, and within its picture?
  function showsBodies({ place, ball, tube, edge }) {
    const { camera } = live.drawing;
    live.drawing.look();
    const p = camera.projectionMatrix.elements, v = camera.matrixWorldInverse.elements;
    const row = (m, i, x, y, z, w) => m[i] * x + m[i + 4] * y + m[i + 8] * z + m[i + 12] * w;
    const isSeen = at => {
      const eye = [0, 1, 2, 3].map(i => row(v, i, ...at, 1)), [x, y, , w] = [0, 1, 2, 3].map(i => row(p, i, ...eye));
      return w > 0 && Math.abs(x) < w && Math.abs(y) < w;
    };
    for (const [list, size] of [[ball, 8], [tube, 11], [place, 3], [edge, 3]])
      for (let k = 0; k < list.length; k += size) if (isSeen([...list.subarray(k, k + 3)])) return true;
    return false;
  }

  function isEmpty() {
    const lists = live.guard(() => live.core.draw());
    if (canvas) return !showsBodies(lists);
    paint(lists);
    return !showsShapes();
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
