// The page in Firefox, if it is installed: its pictures are those of the npm package, and the panels work.
// node --test web/test/firefox.test.js; FIREFOX: the program. Speaks Firefox's own protocol (Marionette),
// so it needs no driver. Without a display it has no WebGL, so it runs under Xvfb.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { connect } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after, before } from 'node:test';

import { linkOf } from '../src/link.js';
import {
  drawnCount, haveScreen, nativePicture, patience, psnrOfCanvas, root, servePage, skipNative, sleep, startScreen, testPictures,
} from '../testing.js';

const program = [process.env.FIREFOX, '/usr/bin/firefox-esr', '/usr/bin/firefox'].find((path) => path && existsSync(path));
const skip = program === undefined && 'Firefox is not installed';

/** A connection to Firefox. Messages are `LENGTH:[0, id, command, parameters]`, answers `LENGTH:[1, id, error, result]`. */
class Firefox {
  #socket;
  #waiting = new Map();
  #next = 1;

  constructor(socket) {
    this.#socket = socket;
    let received = Buffer.alloc(0);
    socket.on('data', (data) => {
      received = Buffer.concat([received, data]);
      for (;;) {
        const colon = received.indexOf(':');
        const length = Number(received.subarray(0, colon));
        if (colon < 0 || received.length < colon + 1 + length) {
          return;
        }
        const message = JSON.parse(received.subarray(colon + 1, colon + 1 + length));
        received = received.subarray(colon + 1 + length);
        if (Array.isArray(message)) {
          const [, id, error, result] = message;
          const { resolve, reject } = this.#waiting.get(id);
          this.#waiting.delete(id);
          error ? reject(new Error(`${error.error}: ${error.message}`)) : resolve(result);
        }
      }
    });
  }

  call(command, parameters = {}) {
    const id = this.#next++;
    const message = JSON.stringify([0, id, command, parameters]);
    this.#socket.write(`${Buffer.byteLength(message)}:${message}`);
    return new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject }));
  }

  async run(script, ...args) {
    return (await this.call('WebDriver:ExecuteScript', { script, args })).value;
  }

  async until(script, ...args) {
    const end = Date.now() + patience;
    while (!(await this.run(`return (${script})`, ...args))) {
      assert.ok(Date.now() < end, `not within ${patience / 1000} s: ${script}`);
      await sleep(50);
    }
  }

  async element(selector) {
    const { value } = await this.call('WebDriver:FindElement', { using: 'css selector', value: selector });
    return Object.values(value)[0];
  }

  async click(selector) {
    await this.call('WebDriver:ElementClick', { id: await this.element(selector) });
  }

  /** Replaces the text of a field with the keyboard, and leaves it with Tab. */
  async type(selector, text) {
    await this.run('const field = document.querySelector(arguments[0]); field.focus(); field.select()', selector);
    const actions = [...text, '\uE004'].flatMap((value) => [{ type: 'keyDown', value }, { type: 'keyUp', value }]);
    await this.call('WebDriver:PerformActions', { actions: [{ type: 'key', id: 'keyboard', actions }] });
  }

  close() {
    this.#socket.end();
  }
}

let page;
let screen;
let child;
let firefox;
const profile = mkdtempSync(join(tmpdir(), 'scenefile-firefox-'));

before(async () => {
  if (skip) {
    return;
  }
  page = await servePage();
  writeFileSync(join(profile, 'user.js'), 'user_pref("marionette.port", 0);\nuser_pref("app.update.enabled", false);\n');
  screen = haveScreen ? await startScreen() : undefined;
  const args = [...(screen ? [] : ['--headless']), '--no-remote', '--marionette', '--profile', profile];
  child = spawn(program, args, { stdio: 'ignore', env: { ...process.env, ...screen?.env, HOME: profile } });
  const portFile = join(profile, 'MarionetteActivePort');
  const end = Date.now() + patience;
  while (!existsSync(portFile) || readFileSync(portFile, 'utf8').trim() === '') {
    assert.ok(Date.now() < end && child.exitCode === null, 'Firefox does not start');
    await sleep(100);
  }
  const socket = connect(Number(readFileSync(portFile, 'utf8')), '127.0.0.1');
  await new Promise((resolve, reject) => socket.once('connect', resolve).once('error', reject));
  firefox = new Firefox(socket);
  await firefox.call('WebDriver:NewSession', { capabilities: { alwaysMatch: { timeouts: { script: patience, pageLoad: patience, implicit: 0 } } } });
});

after(async () => {
  if (!skip) {
    await firefox?.call('Marionette:Quit', { flags: ['eForceQuit'] }).catch(() => {});
    firefox?.close();
    child.kill();
    screen?.close();
    page.close();
    await sleep(300);
  }
  rmSync(profile, { recursive: true, force: true, maxRetries: 10 });
});

async function open(link, name) {
  await firefox.call('WebDriver:Navigate', { url: 'about:blank' });
  await firefox.call('WebDriver:Navigate', { url: `${page.origin}/${link}` });
  await firefox.until(`document.getElementById("name")?.value === arguments[0] && ${drawnCount} >= 1`, name);
}

testPictures('Firefox', { skip, size: [320, 240], open, run: (script) => firefox.run(script) });

const skipOpenGL = skip || (!haveScreen && 'Xvfb is not installed') || skipNative;

for (const path of ['scenes/hello.xml', 'web/examples/lights.xml']) {
  test(`OpenGL in Firefox draws ${path} like the native program`, { skip: skipOpenGL }, async () => {
    const text = readFileSync(join(root, path), 'utf8');
    const options = { profile: 1, mode: 0, features: -1, width: 320, height: 240, draw: 0 };
    await open(linkOf({ name: 'gl.xml', text, options }), 'gl.xml');
    const picture = nativePicture(join(root, path), '--size', '320x240', '--engine', 'gl');
    const { value } = await firefox.call('WebDriver:ExecuteAsyncScript', {
      script: `(${psnrOfCanvas})(arguments[0]).then(arguments[1])`, args: [picture],
    });
    assert.ok(value > 40, `${value} dB`);
  });
}

test('the panels work in Firefox', { skip }, async () => {
  const text = readFileSync(join(root, 'scenes/hello.xml'), 'utf8');
  const options = { profile: 0, mode: 0, features: -1, width: 320, height: 240 };
  await open(linkOf({ name: 'panels.xml', text, options }), 'panels.xml');
  await firefox.click('#show-edit');
  await firefox.until('document.querySelectorAll("#edit-tree [role=treeitem]").length === 6');
  await firefox.run('document.querySelectorAll("#edit-tree [role=treeitem]")[1].click()');
  await firefox.type('[aria-label="Height angle"]', '50');
  await firefox.until(`${drawnCount} >= 2`);
  await firefox.until('document.getElementById("editor").shadowRoot.textContent.includes(\'<heightangle v="50"/>\')');
  assert.equal(await firefox.run('return document.getElementById("verdict").textContent'), 'no errors, no warnings');
  assert.equal(await firefox.run('return document.activeElement.getAttribute("aria-label")'), 'Aperture');
});
