// The report of `scenefile grade` in headless Chromium: node --test web/test/report.test.js. NATIVE: the
// program that makes it.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import test, { after, before } from 'node:test';
import { fileURLToPath } from 'node:url';

import { chromium } from 'playwright-core';

const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));
const skip = !process.env.NATIVE && 'NATIVE is not set';
const patience = 120_000; // ms, for busy machines
const hello = readFileSync(join(root, 'scenes/hello.xml'), 'utf8');
const scenes = { hello, green: hello.replace('r="0.9" g="0.3"', 'r="0.2" g="0.8"'), near: hello.replace('v="35"', 'v="25"') };
const students = ['ada', 'Jörg Müller', 'x <b> & co', 'zoe'];
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
let folder;
let browser;

// All pictures of ada are right, those of Jörg have no shadows, one picture of x is small and one is
// missing, and zoe handed in nothing but a file that is no picture.
function makeClass() {
  const picture = (...names) => join(folder, ...names);
  const draw = (scene, file, size, features) =>
    execFileSync(process.env.NATIVE, ['render', picture('scenes', `${scene}.xml`), '-o', file, '--size', size,
      '--profile', 'course', '--features', features, '--quiet']);
  const all = 'shadows,reflect,refract,texture';
  for (const name of ['references', 'scenes', ...students.map((student) => `class/${student}`)]) {
    mkdirSync(join(folder, name), { recursive: true });
  }
  for (const [scene, text] of Object.entries(scenes)) {
    writeFileSync(picture('scenes', `${scene}.xml`), text);
    draw(scene, picture('references', `${scene}.png`), '320x240', all);
    copyFileSync(picture('references', `${scene}.png`), picture('class/ada', `${scene}.png`));
    draw(scene, picture('class', students[1], `${scene}.png`), '320x240', all.replace('shadows,', ''));
  }
  draw('green', picture('class', students[2], 'green.png'), '240x180', all);
  copyFileSync(picture('references/hello.png'), picture('class', students[2], 'hello.png'));
  writeFileSync(picture('class/zoe/green.png'), hello);
  try {
    execFileSync(process.env.NATIVE, ['grade', picture('class'), '--references', picture('references'), '--scenes',
      picture('scenes'), '--report', picture('report.html'), '--pages', picture('pages'), '--quiet'], { stdio: 'pipe' });
  } catch (error) {
    assert.equal(error.status, 1, String(error.stderr)); // some pictures are wrong
  }
}

before(async () => {
  if (!skip) {
    folder = mkdtempSync(join(tmpdir(), 'scenefile-report-'));
    makeClass();
    browser = await chromium.launch({
      executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
      args: ['--no-sandbox', '--disable-gpu'],
    });
  }
});
after(async () => {
  await browser?.close();
  if (folder) {
    rmSync(folder, { recursive: true });
  }
});

async function open(name, { width = 1280, colorScheme = 'light' } = {}) {
  const page = await browser.newPage({ viewport: { width, height: 800 }, colorScheme });
  page.setDefaultTimeout(patience);
  page.problems = [];
  page.on('pageerror', (error) => page.problems.push(error.message));
  page.on('console', (message) => message.type() === 'error' && page.problems.push(message.text()));
  page.on('request', (request) => /^(file|data):/.test(request.url()) || page.problems.push(`a request to ${request.url()}`));
  await page.goto(`file://${join(folder, name)}`);
  return page;
}

const shownStudents = (page) =>
  page.$$eval('tbody tr', (rows) => rows.filter((row) => row.offsetHeight > 0).map((row) => row.cells[0].textContent));

test('the report sorts by every column, in both directions', { skip }, async () => {
  const page = await open('report.html');
  assert.deepEqual((await shownStudents(page)).sort(), [...students].sort());
  await page.click('thead th:nth-child(2) button');
  assert.deepEqual((await shownStudents(page)).slice(-1), ['ada']);
  await page.click('thead th:nth-child(2) button');
  assert.deepEqual((await shownStudents(page)).slice(0, 1), ['ada']);
  assert.equal(await page.getAttribute('thead th:nth-child(2)', 'aria-sort'), 'descending');
  assert.deepEqual(page.problems, []);
});

test('it filters by student, cause and state', { skip }, async () => {
  const page = await open('report.html');
  await page.fill('#name', 'müller');
  assert.deepEqual(await shownStudents(page), [students[1]]);
  await page.fill('#name', '');
  await page.selectOption('#cause', 'shadows');
  assert.deepEqual(await shownStudents(page), [students[1]]);
  await page.selectOption('#cause', '');
  await page.selectOption('#state', 'passed');
  assert.deepEqual(await shownStudents(page), ['ada']);
  assert.equal(await page.textContent('#shown'), '1 of 4 students');
});

test('it shows the cause of a student and of a picture, and the size', { skip }, async () => {
  const page = await open('report.html');
  const row = (student) => page.locator('tbody tr', { hasText: student });
  assert.match(await row('Müller').locator('td').nth(1).textContent(), /^shadows in 3 of 3/);
  assert.equal(await row('<b>').locator('td').nth(2).textContent(), 'size');
  assert.equal(await row('<b>').locator('td').nth(4).textContent(), 'missing');
  assert.equal(await row('zoe').locator('td').nth(2).textContent(), 'unreadable');
});

test('a link of the table opens the details, with the picture', { skip }, async () => {
  const page = await open('report.html');
  assert.equal(await page.locator('img:visible').count(), 0);
  await page.locator('tbody tr', { hasText: '<b>' }).locator('td a').first().click();
  const image = page.locator('details[open] img').first();
  await image.scrollIntoViewIfNeeded();
  await page.waitForFunction(() => document.querySelector('details[open] img').naturalWidth > 0);
  assert.equal(await image.getAttribute('loading'), 'lazy');
  assert.match(await page.textContent('details[open]'), /the size is 240x180, expected 320x240; compared/);
});

test('the header and the names stay in view', { skip }, async () => {
  const page = await open('report.html', { width: 400 });
  const places = () => page.evaluate(() => ['thead th', 'tbody th'].map((name) => {
    const { left, top } = document.querySelector(name).getBoundingClientRect();
    return [Math.round(left), Math.round(top)];
  }));
  await page.setViewportSize({ width: 400, height: 160 });
  const [head, name] = await places();
  await page.evaluate(() => document.querySelector('.wide').scrollTo(80, 60));
  const [headAfter, nameAfter] = await places();
  assert.deepEqual(headAfter, head);
  assert.equal(nameAfter[0], name[0]);
  assert.ok(nameAfter[1] < name[1], 'the table does not scroll');
});

for (const name of ['report.html', 'pages/Jörg_Müller.html']) {
  for (const [width, colorScheme] of [[1280, 'light'], [1280, 'dark'], [400, 'light'], [400, 'dark']]) {
    test(`axe finds nothing serious in ${name} at ${width} pixels, ${colorScheme}`, { skip }, async () => {
      const page = await open(name, { width, colorScheme });
      await page.evaluate(() => document.querySelectorAll('details').forEach((box) => { box.open = true; }));
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'it scrolls sideways');
      if (process.env.SCREENSHOTS) {
        await page.screenshot({ path: join(process.env.SCREENSHOTS, `${name.split('/')[0]}-${width}-${colorScheme}.png`), fullPage: true });
      }
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => globalThis.axe.run({ resultTypes: ['violations'] }));
      const serious = violations.filter(({ impact }) => ['serious', 'critical'].includes(impact));
      assert.deepEqual(serious.map(({ id, nodes }) => [id, nodes.map(({ target }) => String(target))]), []);
      assert.deepEqual(page.problems, []);
    });
  }
}
