// Takes a picture of the page for the documentation: node web/screenshot.js PAGE OUT.png
// PAGE: the folder of the page (make web).

import { chromium } from 'playwright-core';

import { serverOf } from './serve.js';

const [folder, out] = process.argv.slice(2);
const server = serverOf(folder);
await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-gpu'],
});
const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
page.setDefaultTimeout(120_000);
await page.goto(`http://127.0.0.1:${server.address().port}/`);
await page.waitForFunction(() => Number(document.getElementById('canvas').dataset.drawn ?? 0) >= 1);
await page.screenshot({ path: out });
await browser.close();
server.close();
