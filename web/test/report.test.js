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
      picture('scenes'), '--report', picture('report.html'), '--pages', picture('pages'), '--title', 'Ray & co', '--quiet'],
    { stdio: 'pipe', env: { ...process.env, SOURCE_DATE_EPOCH: '1795478400' } });
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
  for (const form of ['NFC', 'NFD']) {
    await page.fill('#name', 'müller'.normalize(form));
    assert.deepEqual(await shownStudents(page), [students[1]], form);
  }
  await page.fill('#name', '');
  await page.selectOption('#cause', 'shadows');
  assert.deepEqual(await shownStudents(page), [students[1]]);
  await page.selectOption('#cause', '');
  await page.selectOption('#state', 'passed');
  assert.deepEqual(await shownStudents(page), ['ada']);
  assert.equal(await page.textContent('#shown'), '1 of 4 students');
});

test('it has a title and a date, and counts students first', { skip }, async () => {
  const page = await open('report.html');
  assert.equal(await page.title(), 'Ray & co');
  assert.match(await page.textContent('main'), /Graded on 2026-11-24/);
  assert.match(await page.textContent('.lead'), /^1 of 4 students passed everything; 3 need attention\./);
});

test('it shows the mistakes of a student and the state of each picture', { skip }, async () => {
  const page = await open('report.html');
  const row = (student) => page.locator('tbody tr', { hasText: student });
  assert.match(await row('Müller').locator('td.mistakes').textContent(), /^There are no shadows.* · 3 pictures/);
  const label = (student, column) => row(student).locator('td').nth(column).locator('a').getAttribute('aria-label');
  assert.match(await label('<b>', 2), /^differs: The size is 240x180, expected 320x240/);
  assert.match(await label('<b>', 4), /^missing/);
  assert.match(await label('zoe', 2), /^unreadable/);
  assert.equal(await row('ada').locator('td.passed').count(), 3);
});

test('a mistake of the class filters the table', { skip }, async () => {
  const page = await open('report.html');
  const mistake = page.locator('.common details', { hasText: 'Shadows' });
  await mistake.locator('summary').click();
  assert.match(await mistake.textContent(), /Where to look: The direction, the start and the end of the shadow ray/);
  await mistake.locator('button').click();
  assert.deepEqual(await shownStudents(page), [students[1]]);
});

test('a link of the table opens the details, with the picture', { skip }, async () => {
  const page = await open('report.html');
  assert.equal(await page.locator('img:visible').count(), 0);
  await page.locator('tbody tr', { hasText: '<b>' }).locator('td a').first().click();
  const image = page.locator('details[open] img').first();
  await image.scrollIntoViewIfNeeded();
  await page.waitForFunction(() => document.querySelector('details[open] img').naturalWidth > 0);
  assert.equal(await image.getAttribute('loading'), 'lazy');
  assert.match(await page.textContent('details[open]'), /The size is 240x180, expected 320x240; compared/);
});

test('pictures are enlarged; keys go on, flicker and close', { skip }, async () => {
  const page = await open('report.html');
  await page.locator('.student summary', { hasText: 'Müller' }).click();
  const shots = page.locator('.student[open] .shot');
  assert.equal(await shots.count(), 3);
  await shots.first().focus();
  await page.keyboard.press('Enter');
  const box = page.locator('dialog');
  const place = () => page.textContent('#place');
  const panes = () => box.locator('img').evaluateAll((images) => images.filter((image) => image.checkVisibility()).map((image) =>
    [image.naturalWidth > 0, image.style.objectPosition.split(' ')[0]]));
  assert.equal(await box.locator('h2').textContent(), 'Jörg Müller: green');
  assert.match(await page.textContent('#why'), /^There are no shadows/);
  assert.deepEqual(await panes(), [[true, '0%'], [true, '50%'], [true, '100%']]);
  await page.keyboard.press('f');
  const seen = new Set();
  for (let i = 0; i < 20 && seen.size < 2; ++i) {
    seen.add(JSON.stringify(await panes()));
    await page.waitForTimeout(200);
  }
  assert.deepEqual([...seen].sort(), ['[[true,"0%"]]', '[[true,"50%"]]']);
  await page.keyboard.press('F');
  assert.equal((await panes()).length, 3);
  const first = await place();
  await page.keyboard.press('ArrowRight');
  assert.equal(await box.locator('h2').textContent(), 'Jörg Müller: hello');
  await page.keyboard.press('ArrowLeft');
  assert.equal(await place(), first);
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Escape');
  assert.equal(await box.isVisible(), false);
  assert.ok(await shots.nth(1).evaluate((shot) => shot === document.activeElement), 'the focus is elsewhere');
  assert.deepEqual(page.problems, []);
});

test('without motion, each press of the key swaps the pictures', { skip }, async () => {
  const page = await open('report.html');
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.locator('.student summary', { hasText: 'Müller' }).click();
  await page.locator('.student[open] .shot').first().click();
  const shown = () => page.textContent('dialog figcaption');
  await page.keyboard.press('f');
  assert.equal(await shown(), 'Picture');
  await page.waitForTimeout(1200);
  assert.equal(await shown(), 'Picture');
  await page.keyboard.press('f');
  assert.equal(await shown(), 'Reference');
});

test('pictures that passed are small', { skip }, async () => {
  const page = await open('report.html');
  await page.locator('.student summary', { hasText: 'ada' }).click();
  const image = page.locator('.student[open] .thumbs img');
  assert.equal(await image.count(), 3);
  await page.waitForFunction(() => document.querySelector('.student[open] img').naturalWidth > 0);
  assert.deepEqual(await image.first().evaluate(({ naturalWidth, naturalHeight, width, height }) =>
    [naturalWidth, naturalHeight, width, height]), [3 * 128, 96, 96, 72]);
});

test('on paper everything is open, light and not cut off', { skip }, async () => {
  const page = await open('report.html', { width: 700, colorScheme: 'dark' });
  await page.emulateMedia({ media: 'print' });
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  assert.equal(await page.locator('details:not([open])').count(), 0);
  const [color, cut] = await page.evaluate(() => [getComputedStyle(document.body).backgroundColor,
    document.querySelector('table').getBoundingClientRect().right > innerWidth]);
  assert.deepEqual([color, cut], ['rgb(255, 255, 255)', false]);
  await page.evaluate(() => dispatchEvent(new Event('afterprint')));
  assert.equal(await page.locator('details[open]').count(), 0);
});

test('the header and the names stay in view, with results next to the names', { skip }, async () => {
  const page = await open('report.html', { width: 400 });
  assert.ok(await page.evaluate(() => document.querySelector('td:nth-child(4)').getBoundingClientRect().right < innerWidth));
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

for (const name of ['report.html', 'pages/Jörg_Müller-53fad967.html']) {
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
