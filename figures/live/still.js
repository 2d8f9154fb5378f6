// still.js - node still.js PAGE NAME PICTURE: the stage of a live figure at frame
// 60, as PNG: what is drawn, without the buttons and the strip that they stand in.  A
// drawing in space has another light on a dark page, and a second picture of it.

import { chromium } from 'playwright-core';

const [page, name, picture] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
const sheet = await browser.newPage({ viewport: { width: 788, height: 900 }, deviceScaleFactor: 2, reducedMotion: 'reduce' });
await sheet.goto(`file://${page}`);
const figure = sheet.locator(`[data-live="${name}"]`);
await figure.evaluate(node => node.scrollIntoView());
await sheet.waitForSelector(`[data-live="${name}"][data-ready]`, { timeout: 240000 });
await figure.locator('.live-stage').evaluate(stage => { stage.style.borderBottom = stage.style.paddingBottom = 0; stage.querySelector('.live-tools').remove(); });
await sheet.waitForTimeout(300);
await figure.locator('.live-stage').screenshot({ path: picture, timeout: 240000 });
if (!await figure.evaluate(node => node.live.isFlat)) {
  await sheet.emulateMedia({ colorScheme: 'dark', reducedMotion: 'reduce' });
  await sheet.waitForTimeout(1000);
  await figure.locator('.live-stage').screenshot({ path: picture.replace('.png', '-dark.png'), timeout: 240000 });
}
await browser.close();
