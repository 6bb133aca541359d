// A client of the protocol. What the server answers is tested with its room; here, that it can be reached.

import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import test, { after, before } from 'node:test';
import { pathToFileURL } from 'node:url';

import { render } from 'scenefile';

const program = join(dirname(createRequire(import.meta.url).resolve('scenefile/package.json')), 'bin/scenefile.js');
const scene = `<scenefile>
  <lightdata><id v="0"/><type v="directional"/><direction x="0" y="0" z="-1"/><color r="1" g="1" b="1"/></lightdata>
  <object type="tree" name="root">
    <transblock>
      <object type="primitive" name="sphere"><blend v="1"/><texture file="wall.png"/></object>
    </transblock>
  </object>
</scenefile>
`;

class Client {
  #id = 0;
  #buffer = Buffer.alloc(0);
  #answers = new Map();
  #diagnostics = [];
  #waiting = null;

  constructor() {
    this.server = spawn(process.execPath, [program, 'lsp'], { stdio: ['pipe', 'pipe', 'inherit'] });
    this.server.stdout.on('data', (chunk) => this.#take(chunk));
  }

  #take(chunk) {
    this.#buffer = Buffer.concat([this.#buffer, chunk]);
    for (;;) {
      const end = this.#buffer.indexOf('\r\n\r\n');
      if (end < 0) return;
      const length = Number(/Content-Length: (\d+)/.exec(this.#buffer.toString('latin1', 0, end))[1]);
      if (this.#buffer.length < end + 4 + length) return;
      const message = JSON.parse(this.#buffer.toString('utf8', end + 4, end + 4 + length));
      this.#buffer = this.#buffer.subarray(end + 4 + length);
      if (message.id !== undefined) {
        this.#answers.get(message.id)(message);
      } else {
        this.#diagnostics.push(message.params);
        this.#waiting?.();
      }
    }
  }

  #write(message) {
    const body = Buffer.from(JSON.stringify({ jsonrpc: '2.0', ...message }));
    // In two pieces, as pipes may split messages.
    this.server.stdin.write(`Content-Length: ${body.length}\r\n`);
    this.server.stdin.write(Buffer.concat([Buffer.from('\r\n'), body]));
  }

  notify(method, params) {
    this.#write({ method, params });
  }

  request(method, params) {
    const id = ++this.#id;
    return new Promise((resolve) => {
      this.#answers.set(id, resolve);
      this.#write({ id, method, params });
    });
  }

  async diagnostics() {
    while (this.#diagnostics.length === 0) {
      await new Promise((resolve) => (this.#waiting = resolve));
    }
    return this.#diagnostics.shift();
  }
}

let folder;
let client;
let uri;
before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'scenefile-lsp-'));
  uri = pathToFileURL(join(folder, 'scene.xml')).href;
  client = new Client();
  const { result } = await client.request('initialize', { capabilities: {} });
  assert.equal(result.capabilities.documentFormattingProvider, true);
  client.notify('initialized', {});
});
after(async () => {
  await client.request('shutdown');
  client.notify('exit');
  const status = await new Promise((resolve) => client.server.on('exit', resolve));
  rmSync(folder, { recursive: true });
  assert.equal(status, 0);
});

let version = 0;
async function open(text) {
  client.notify(version === 0 ? 'textDocument/didOpen' : 'textDocument/didChange', {
    textDocument: { uri, version: ++version, text },
    contentChanges: [{ text }],
  });
  for (;;) {
    const params = await client.diagnostics();
    if (params.version === version) {
      return params.diagnostics;
    }
    assert(params.version < version);  // those after a save, published before the change arrived
  }
}

test('a missing texture gives a finding, an existing one does not', async () => {
  const [missing, ...others] = await open(scene);
  assert.deepEqual(others, []);
  assert.equal(missing.code, 'texture.missing');
  assert.equal(missing.severity, 2);
  assert.equal(missing.range.start.line, 4);
  mkdirSync(join(folder, 'image'));
  writeFileSync(join(folder, 'image/wall.png'), (await render(scene, { width: 2, height: 2, allowMissing: true })).png);
  client.notify('textDocument/didSave', { textDocument: { uri } }); // files are read again
  assert.deepEqual(await open(`${scene}\n`), []);
});

test('positions count UTF-16 units', async () => {
  const text = scene.replace('<blend', '<!-- \u{1F600} --><blnd');
  const wrong = (await open(text)).find((d) => d.code === 'xml.misspelled-element');
  const line = text.split('\n')[4];
  assert.equal(line.slice(wrong.range.start.character, wrong.range.end.character), '<blnd');
});

test('requests are answered while nothing is due', async () => {
  await open(scene);
  const { result } = await client.request('textDocument/completion', {
    textDocument: { uri },
    position: { line: 1, character: scene.split('\n')[1].indexOf('<id ') + 1 },
  });
  const labels = result.map(({ label }) => label);
  assert.deepEqual(labels.slice(0, 3), ['id', 'type', 'color']);
  const { error } = await client.request('textDocument/nothing', {});
  assert.equal(error.code, -32601);
});

test('a large answer arrives whole', async () => {
  const text = scene.replace('</transblock>', `</transblock>\n${'<transblock><object type="primitive" name="cube"/></transblock>\n'.repeat(5000)}`);
  await open(text);
  const { result } = await client.request('textDocument/documentSymbol', { textDocument: { uri } });
  assert.ok(JSON.stringify(result).length > 1_000_000);
});

test('the program ends with its client, and says what is not a message', () => {
  const lsp = (input, words = []) => spawnSync(process.execPath, [program, 'lsp', ...words], { input, encoding: 'utf8' });
  assert.equal(lsp('').status, 1);
  const wrong = lsp('hello\r\n\r\n');
  assert.equal(wrong.status, 1);
  assert.match(wrong.stderr, /Content-Length/);
  assert.equal(lsp('', ['--help']).status, 0);
  assert.equal(lsp('', ['scene.xml']).status, 2);
});
