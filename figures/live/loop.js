// loop.js - when does a figure step?  Sixty times a second of the clock on the
// wall, only on screen, and not where motion is unwanted.

const MOST = 2;                 // steps a picture: a slow machine shows it slower
const unwanted = matchMedia('(prefers-reduced-motion: reduce)');

export const still = () => unwanted.matches;

// step(n) is called with 0, 1 or 2; changed(isPlaying) when that changes.  At rate
// 1/4 a second of the figure takes four of the clock.
export function makeLoop(figure, step, changed) {
  const loop = { playing: !still(), seen: false, rate: 1 };
  let id = 0, last = 0, owed = 0;

  function tick(now) {
    id = requestAnimationFrame(tick);
    owed += last ? loop.rate * (now - last) * 60 / 1000 : 1;
    last = now;
    const due = Math.min(Math.floor(owed + 0.05), MOST);
    owed = due === MOST ? 0 : owed - due;
    step(due);
  }
  loop.update = () => {
    const goes = loop.playing && loop.seen && !document.hidden;
    if (goes && !id) { last = 0; id = requestAnimationFrame(tick); }
    if (!goes && id) { cancelAnimationFrame(id); id = 0; }
    figure.dataset.running = goes ? '1' : '0';
    changed(loop.playing);
  };
  loop.play = wanted => { loop.playing = wanted; loop.update(); };
  new IntersectionObserver(seen => {
    loop.seen = seen[seen.length - 1].isIntersecting;
    loop.update();
  }).observe(figure);
  document.addEventListener('visibilitychange', loop.update);
  unwanted.addEventListener('change', () => loop.play(!still()));
  return loop;
}
