// Opens every scene below the folders FILES (separated by spaces) in headless Chromium, such as damaged ones: each must
// end in findings, a picture or a message within 10 seconds, and the page must go on to answer.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { basename, join } from 'node:path';
import test from 'node:test';

import { chromium } from 'playwright-core';

import { servePage } from '../testing.js';

const folders = (process.env.FILES ?? '').split(' ').filter((folder) => folder !== '');
const largest = 50_000_000; // bytes that the browser's automation can hand over

const filesBelow = (folder) =>
  readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    return entry.isDirectory() ? filesBelow(path) : entry.isFile() ? [path] : [];
  });

/** In the page: how the scene of this name ended, or null. */
function ending([name, drawnBefore]) {
  const { textContent: verdict } = document.getElementById('verdict');
  const notice = document.querySelector('.notice.error')?.innerText;
  if (notice !== undefined) {
    return notice;
  }
  if (document.getElementById('name').value !== name || verdict === '') {
    return null;
  }
  const drawn = Number(document.getElementById('canvas').dataset.drawn) > drawnBefore;
  return drawn ? `drawn, ${verdict}` : /last version without errors/.test(verdict) ? verdict : null;
}

test('every file ends in findings, a picture or a message', { skip: folders.length === 0 && 'FILES is not set' }, async (t) => {
  const served = await servePage();
  const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox', '--disable-gpu'] });
  t.after(async () => {
    await browser.close();
    served.close();
  });
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  const uncaught = [];
  page.on('pageerror', (error) => uncaught.push(error.message));
  await page.goto(served.origin);
  await page.waitForFunction(() => document.getElementById('canvas').dataset.drawn);
  await page.selectOption('#size', '320x240');
  const failed = [];
  const files = folders.flatMap(filesBelow);
  const others = files.filter((path) => !/\.(xml|json)$/i.test(path));
  for (const path of files.filter((some) => !others.includes(some))) {
    if (statSync(path).size > largest) {
      continue;
    }
    const before = await page.evaluate(() => {
      document.getElementById('verdict').textContent = ''; // of the scene before
      document.getElementById('notices').replaceChildren();
      return Number(document.getElementById('canvas').dataset.drawn);
    });
    const given = [path, ...others.filter((other) => statSync(other).size < 1_000_000 && /\.(png|jpg|obj)$/i.test(other))];
    const begun = Date.now();
    try {
      await page.setInputFiles('#file-input', given.map((one) => ({ name: basename(one), mimeType: 'application/octet-stream', buffer: readFileSync(one) })));
      const end = await page.waitForFunction(ending, [basename(path), before], { timeout: 10_000 });
      const alive = await Promise.race([page.evaluate(() => true), new Promise((resolve) => setTimeout(resolve, 1000, false))]);
      if (process.env.VERBOSE) {
        console.log(`${path}: ${Date.now() - begun} ms: ${String(await end.jsonValue()).replaceAll('\n', ' ').slice(0, 150)}`);
      }
      assert.ok(alive, 'the page does not answer');
      assert.deepEqual(uncaught.splice(0), []);
    } catch (error) {
      failed.push(`${path}: ${Date.now() - begun} ms: ${error.message.split('\n')[0]}`);
    }
  }
  assert.deepEqual(failed, []);
});
