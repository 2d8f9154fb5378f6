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

// A wait that ran out, a page that crashed and a mistake of the test itself come as
// exceptions.  Any of them is one more fault of what was looked at, told in a sentence,
// and the rest is looked at all the same.  What a page is asked may also never be
// answered: so nothing takes longer than LONGEST.
const LONGEST = 30 * 60e3;      // ms
export async function attempt(what, fault, act) {
  let timer;
  const late = new Promise((_, fail) => { timer = setTimeout(() => fail(Error(`no end within ${LONGEST / 60e3} minutes`)), LONGEST); });
  try {
    return await Promise.race([act(), late]);
  } catch (error) {
    fault(`${what}: ${sentence(error)}`);
  } finally {
    clearTimeout(timer);
  }
}

// What an exception says, what was waited for, and where in the test.
function sentence(error) {
  const waited = error.message.match(/- (waiting for .*)/)?.[1];
  const place = error.stack?.match(/at (?:async )?(?:(\S+) \()?file:.*\/(check_\w+\.mjs:\d+)/);
  return [error.message.split('\n')[0], waited, place && [place[1], place[2]].filter(Boolean).join(', ')].filter(Boolean).join('; ');
}

// A promise that is awaited later: until then it may fail unheard.
export const awaitedLater = promise => { promise.catch(() => {}); return promise; };

// Those of the known names that are asked for, all of them if none is: a name is told
// whole, or by what stands before its first hyphen.  An unknown name ends the test.
export function chosen(asked, known, kind) {
  const unknown = asked.filter(word => !known.some(name => named(word, name)));
  if (unknown.length) {
    console.log(`There is no ${kind} called ${unknown.join(' or ')}.  There are ${[...new Set(known)].join(' ')}`);
    process.exit(2);
  }
  return known.filter(name => !asked.length || asked.some(word => named(word, name)));
}
const named = (word, name) => name === word.replace(/\.html$/, '') || name.startsWith(`${word}-`);
