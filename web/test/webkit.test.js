// The page in WebKitGTK, if its WebDriver is installed: its pictures are those of the npm package.
// node --test web/test/webkit.test.js; WEBKIT: the browser, default MiniBrowser.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import test, { after, before } from 'node:test';
import { fileURLToPath } from 'node:url';

import { render } from '../../build/wasm/package/lib/index.js';
import { serverOf } from '../serve.js';
import { linkOf } from '../src/link.js';

const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));
const driverPath = '/usr/bin/WebKitWebDriver';
const patience = 120_000;

// Debian has MiniBrowser in a folder named after the architecture and the version.
function miniBrowser() {
  return readdirSync('/usr/lib', { withFileTypes: true })
    .filter((entry) => entry.isDirectory())
    .flatMap(({ name }) => ['4.1', '4.0'].map((version) => `/usr/lib/${name}/webkit2gtk-${version}/MiniBrowser`))
    .find(existsSync);
}
const program = process.env.WEBKIT ?? miniBrowser();
const skip = !(existsSync(driverPath) && program && existsSync('/usr/bin/Xvfb')) && 'webkit2gtk-driver or Xvfb is not installed';

const sleep = (time) => new Promise((resolve) => setTimeout(resolve, time));

let server;
let origin;
let screen;
let driver;
let port;
let session = '';
const home = mkdtempSync(join(tmpdir(), 'scenefile-webkit-'));

async function call(method, path, body) {
  const response = await fetch(`http://127.0.0.1:${port}${path}`, { method, body: body && JSON.stringify(body) });
  const { value } = await response.json();
  assert.ok(response.ok, JSON.stringify(value));
  return value;
}

const run = (script, ...args) => call('POST', `${session}/execute/sync`, { script, args });

async function until(test, ...args) {
  const end = Date.now() + patience;
  while (!(await run(`return ${test}`, ...args))) {
    assert.ok(Date.now() < end, `not within ${patience / 1000} s: ${test}`);
    await sleep(100);
  }
}

async function freePort() {
  const some = createServer();
  await new Promise((resolve) => some.listen(0, '127.0.0.1', resolve));
  const { port: free } = some.address();
  await new Promise((resolve) => some.close(resolve));
  return free;
}

before(async () => {
  if (skip) {
    return;
  }
  server = serverOf(process.env.PAGE ?? join(root, 'out/page'));
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  origin = `http://127.0.0.1:${server.address().port}`;
  screen = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1280x900x24', '-nolisten', 'tcp'], { stdio: ['ignore', 'ignore', 'ignore', 'pipe'] });
  const display = await new Promise((resolve) => screen.stdio[3].once('data', (data) => resolve(String(data).trim())));
  port = await freePort();
  driver = spawn(driverPath, [`--port=${port}`], {
    stdio: 'ignore',
    env: { ...process.env, DISPLAY: `:${display}`, HOME: home, WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: '1' },
  });
  const end = Date.now() + patience;
  for (;;) {
    try {
      await call('GET', '/status');
      break;
    } catch (error) {
      assert.ok(Date.now() < end && driver.exitCode === null, `the driver does not start: ${error.message}`);
      await sleep(100);
    }
  }
  const { sessionId } = await call('POST', '/session', {
    capabilities: { alwaysMatch: { 'webkitgtk:browserOptions': { binary: program, args: ['--automation'] } } },
  });
  session = `/session/${sessionId}`;
});

after(async () => {
  if (!skip) {
    await call('DELETE', session).catch(() => {});
    driver?.kill();
    screen?.kill();
    server.close();
    await sleep(300);
  }
  rmSync(home, { recursive: true, force: true, maxRetries: 10 });
});

// FNV-1a
const hashOf = (data) => data.reduce((hash, value) => Math.imul(hash ^ value, 0x01000193), 0x811c9dc5);

for (const path of ['scenes/hello.xml', 'web/examples/lights.xml', 'web/examples/templates.json']) {
  for (const profile of ['course', 'fine']) {
    const name = path.slice(path.lastIndexOf('/') + 1);
    test(`WebKitGTK draws ${name} like the npm package, profile ${profile}`, { skip }, async () => {
      const text = readFileSync(join(root, path), 'utf8');
      const [width, height] = [160, 120];
      const options = { profile: profile === 'fine' ? 1 : 0, mode: 0, features: -1, width, height };
      await call('POST', `${session}/url`, { url: 'about:blank' });
      await call('POST', `${session}/url`, { url: `${origin}/${linkOf({ name, text, options })}` });
      await until('document.getElementById("name")?.value === arguments[0] && Number(document.getElementById("canvas").dataset.drawn ?? 0) >= 1', name);
      const hash = await run(`
        const canvas = document.getElementById('canvas');
        const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        let hash = 0x811c9dc5;
        for (const value of data) {
          hash = Math.imul(hash ^ value, 0x01000193);
        }
        return [canvas.width, canvas.height, hash];`);
      const { data } = await render(text, { width, height, profile });
      assert.deepEqual(hash, [width, height, hashOf(data)]);
    });
  }
}
