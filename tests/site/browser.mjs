// browser.mjs - the browser of all tests of the site.

import { createRequire } from 'node:module';
import { existsSync } from 'node:fs';
import { resolve } from 'node:path';

// BUILD is the folder in which npm put what the tests need.
export const needs = build => createRequire(resolve(build, 'node/package.json'));

export const launch = build => needs(build)('playwright-core').chromium.launch({
  executablePath: ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(existsSync),
  args: ['--no-sandbox', '--enable-unsafe-swiftshader'],
});

// A picture in space is slow to paint without a graphics card: where what is asked is
// what is computed, none is painted before `window.painted` says so.
export const unpainted = page => page.addInitScript(() => {
  const real = WebGL2RenderingContext.prototype;
  for (const name of ['drawElements', 'drawArrays', 'drawElementsInstanced', 'drawArraysInstanced']) {
    const draw = real[name];
    real[name] = function (...rest) { if (window.painted) draw.apply(this, rest); };
  }
});

// Does the same with each of some things, so many of them at a time: most of what a
// page takes is waiting.
export async function together(most, things, act) {
  const queue = [...things.entries()];
  await Promise.all(Array.from({ length: most }, async () => {
    while (queue.length) {
      const [k, one] = queue.shift();
      await act(one, k);
    }
  }));
}
