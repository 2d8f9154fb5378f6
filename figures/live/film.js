// film.js - a button that films a drawing in space, from one press to the next, and
// saves what it has.

import { make } from './node.js';
import { tool } from './dials.js';

export function film(figure) {
  let reel;
  const save = pieces => make('a', { href: URL.createObjectURL(new Blob(pieces, { type: 'video/webm' })), download: `${figure.name}.webm` }).click();
  const node = tool('Make a film', () => {
    if (reel) { reel.stop(); return; }
    const pieces = [];
    reel = new MediaRecorder(figure.drawing.canvas.captureStream(60), { mimeType: 'video/webm', videoBitsPerSecond: 8e6 });
    reel.ondataavailable = event => pieces.push(event.data);
    reel.onstop = () => { reel = null; node.rename('Make a film'); save(pieces); };
    reel.start();
    node.rename('Save the film');
    figure.loop.play(true);
  });
  return node;
}
