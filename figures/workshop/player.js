// player.js - the script of a page that a reader saves: it runs the program that
// stands in the page, in a worker that is this script once more, and shows what it
// draws.  little.js makes such pages.

import { makeFilm } from './film.js';
import { perform } from './perform.js';
import { unpack } from './unpack.js';

const SECONDS = 600;            // then a program is given up

async function show(text) {
  const said = document.getElementById('said'), wasm = await unpack(document.getElementById('program').textContent.trim());
  const worker = new Worker(URL.createObjectURL(new Blob([text], { type: 'text/javascript' })));
  const film = makeFilm();
  document.querySelector('main').append(film.node);
  said.textContent = 'It computes …';
  worker.onerror = event => { said.textContent = event.message; };
  worker.onmessage = ({ data }) => {
    worker.terminate();
    film.show(data.printed);
    said.textContent = data.fault ?? `Computed here, just now, in ${data.seconds.toFixed(1)} s. Drag it to look around.`;
    document.body.dataset.hash = data.hash;
  };
  worker.postMessage(wasm);
}

if (self.document) show(document.currentScript.textContent);
else self.onmessage = async ({ data }) => self.postMessage(await perform(data, SECONDS, true));
