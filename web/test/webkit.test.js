// The page in WebKitGTK, if its WebDriver is installed: its pictures are those of the npm package.
// node --test web/test/webkit.test.js; WEBKIT: the browser, default MiniBrowser.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before } from 'node:test';

import { drawnCount, haveScreen, patience, servePage, sleep, startScreen, testPictures } from '../testing.js';

const driverPath = '/usr/bin/WebKitWebDriver';

// Debian has MiniBrowser in a folder named after the architecture and the version.
function miniBrowser() {
  return readdirSync('/usr/lib', { withFileTypes: true })
    .filter((entry) => entry.isDirectory())
    .flatMap(({ name }) => ['4.1', '4.0'].map((version) => `/usr/lib/${name}/webkit2gtk-${version}/MiniBrowser`))
    .find(existsSync);
}
const program = process.env.WEBKIT ?? miniBrowser();
const skip = !(existsSync(driverPath) && program && haveScreen) && 'webkit2gtk-driver or Xvfb is not installed';

let page;
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
  page = await servePage();
  screen = await startScreen();
  port = await freePort();
  driver = spawn(driverPath, [`--port=${port}`], {
    stdio: 'ignore',
    env: { ...process.env, ...screen.env, HOME: home, WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: '1' },
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
    screen?.close();
    page.close();
    await sleep(300);
  }
  rmSync(home, { recursive: true, force: true, maxRetries: 10 });
});

async function open(link, name) {
  await call('POST', `${session}/url`, { url: 'about:blank' });
  await call('POST', `${session}/url`, { url: `${page.origin}/${link}` });
  await until(`document.getElementById("name")?.value === arguments[0] && ${drawnCount} >= 1`, name);
}

testPictures('WebKitGTK', { skip, size: [160, 120], open, run });
