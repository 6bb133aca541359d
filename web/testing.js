// Helpers for the tests of the page in all browsers.

import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

import { render } from '../build/wasm/package/lib/index.js';
import { serverOf } from './serve.js';
import { linkOf } from './src/link.js';

export const root = dirname(dirname(fileURLToPath(import.meta.url)));
export const patience = 120_000; // ms, for busy machines
export const sleep = (time) => new Promise((resolve) => setTimeout(resolve, time));

/** The folder of the page, PAGE, default out/page. */
export const pageFolder = process.env.PAGE ?? join(root, 'out/page');

/** Serves the page, or a copy of it, on a free port. */
export async function servePage(folder = pageFolder) {
  const server = serverOf(folder);
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return { origin: `http://127.0.0.1:${server.address().port}`, close: () => server.close() };
}

export const haveScreen = existsSync('/usr/bin/Xvfb');

/** A screen without a monitor; `env`: variables for the programs that use it. */
export async function startScreen() {
  const child = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1280x900x24', '-nolisten', 'tcp'], { stdio: ['ignore', 'ignore', 'ignore', 'pipe'] });
  const display = await new Promise((resolve) => child.stdio[3].once('data', (data) => resolve(String(data).trim())));
  return { env: { DISPLAY: `:${display}`, GDK_BACKEND: 'x11', WAYLAND_DISPLAY: undefined }, close: () => child.kill() };
}

/** A reason to skip tests that compare with the native program, NATIVE. */
export const skipNative = !process.env.NATIVE && 'NATIVE is not set';

/** A picture of the native program: a PNG file in base64. */
export function nativePicture(path, ...options) {
  const folder = mkdtempSync(join(tmpdir(), 'scenefile-native-'));
  try {
    const file = join(folder, 'native.png');
    execFileSync(process.env.NATIVE, ['render', path, '-o', file, '--quiet', ...options]);
    return readFileSync(file, 'base64');
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** To run in the page: the peak signal-to-noise ratio in dB between the canvas and a PNG file in base64. */
export async function psnrOfCanvas(base64) {
  const picture = await createImageBitmap(new Blob([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))]));
  const { width, height } = picture;
  const context = new OffscreenCanvas(width, height).getContext('2d');
  context.drawImage(picture, 0, 0);
  const canvas = document.getElementById('canvas');
  const [a, b] = [context, canvas.getContext('2d')].map((some) => some.getImageData(0, 0, width, height).data);
  const sum = a.reduce((total, value, i) => total + (value - b[i]) ** 2, 0);
  return canvas.width !== width ? 0 : 10 * Math.log10(255 ** 2 / Math.max(1e-9, sum / ((a.length * 3) / 4)));
}

/** A JavaScript expression: how many pictures the page has drawn. */
export const drawnCount = 'Number(document.getElementById("canvas").dataset.drawn ?? 0)';

// FNV-1a of bytes, here and in the page.
const hashOf = (data) => data.reduce((hash, value) => Math.imul(hash ^ value, 0x01000193), 0x811c9dc5);
const sizeAndHash = `
  const canvas = document.getElementById('canvas');
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  let hash = 0x811c9dc5;
  for (const value of data) {
    hash = Math.imul(hash ^ value, 0x01000193);
  }
  return [canvas.width, canvas.height, hash];`;

/**
 * Tests that a browser draws three scenes, with both profiles, like the npm package. `open` opens an address and waits
 * until the scene of this name is drawn; `run` runs a script in the page.
 */
export function testPictures(browser, { skip, size: [width, height], open, run }) {
  for (const path of ['scenes/hello.xml', 'web/examples/lights.xml', 'web/examples/templates.json']) {
    for (const profile of ['course', 'fine']) {
      const name = path.slice(path.lastIndexOf('/') + 1);
      test(`${browser} draws ${name} like the npm package, profile ${profile}`, { skip }, async () => {
        const text = readFileSync(join(root, path), 'utf8');
        const options = { profile: profile === 'fine' ? 1 : 0, mode: 0, features: -1, width, height };
        await open(linkOf({ name, text, options }), name);
        const { data } = await render(text, { width, height, profile });
        assert.deepEqual(await run(sizeAndHash), [width, height, hashOf(data)]);
      });
    }
  }
}
