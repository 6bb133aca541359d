// A client of the protocol.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
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
  const params = await client.diagnostics();
  assert.equal(params.version, version);
  return params.diagnostics;
}

test('a missing texture gives a finding, an existing one does not', async () => {
  const [missing, ...others] = await open(scene);
  assert.deepEqual(others, []);
  assert.equal(missing.code, 'texture.missing');
  assert.equal(missing.severity, 2);
  assert.equal(missing.range.start.line, 4);
  mkdirSync(join(folder, 'image'));
  writeFileSync(join(folder, 'image/wall.png'), (await render(scene, { width: 2, height: 2, allowMissing: true })).png);
  assert.deepEqual(await open(`${scene}\n`), []);
});

test('columns count UTF-16 units', async () => {
  const text = scene.replace('<blend', '<!-- \u{1F600} --><blnd');
  const wrong = (await open(text)).find((d) => d.code === 'xml.misspelled-element');
  const line = text.split('\n')[4];
  assert.equal(line.slice(wrong.range.start.character, wrong.range.end.character), '<blnd');
});

for (const [right, wrong, code] of [
  ['transblock', 'transblok', 'xml.misspelled-transblock'],
  ['lightdata', 'lightdat', 'xml.misspelled-element'],
]) {
  test(`a misspelled ${right} has a correction, in both tags`, async () => {
    const text = scene.replaceAll(right, wrong);
    const diagnostic = (await open(text)).find((d) => d.code === code);
    const { result } = await client.request('textDocument/codeAction', {
      textDocument: { uri },
      range: diagnostic.range,
      context: { diagnostics: [diagnostic] },
    });
    assert.equal(result.length, 1);
    const lines = text.split('\n');
    for (const { range, newText } of result[0].edit.changes[uri].reverse()) {
      const old = lines[range.start.line];
      lines[range.start.line] = old.slice(0, range.start.character) + newText + old.slice(range.end.character);
    }
    assert.equal(lines.join('\n'), scene);
    const hover = await client.request('textDocument/hover', {
      textDocument: { uri },
      position: { line: diagnostic.range.start.line, character: diagnostic.range.start.character + 1 },
    });
    assert.ok(hover.result.contents.value.includes(code));
  });
}

const at = (text, mark) => {
  const before = text.slice(0, text.indexOf(mark)).split('\n');
  return { line: before.length - 1, character: before.at(-1).length };
};

test('completes elements, attributes and values', async () => {
  const labels = async (text) => {
    await open(text.replace('|', ''));
    const { result } = await client.request('textDocument/completion', { textDocument: { uri }, position: at(text, '|') });
    return result.map(({ label }) => label);
  };
  assert.deepEqual((await labels(scene.replace('<id ', '<|id '))).slice(0, 3), ['id', 'color', 'function']);
  assert.deepEqual(await labels(scene.replace('"sphere"', '"sphere" |')), ['filename', 'meshfile']);
  assert.deepEqual(await labels(scene.replace('"directional"', '"|"')), ['point', 'directional', 'spot', 'area']);
  assert.deepEqual(await labels('{"groups": [{"primitives": [{"type": "|"}]}]}'), ['"cube"', '"cone"', '"cylinder"', '"sphere"', '"mesh"']);
  assert.ok((await labels('{"cameraData": {"|"}}')).includes('"heightAngle"'));
});

test('explains a word of the format', async () => {
  await open(scene);
  const { result } = await client.request('textDocument/hover', { textDocument: { uri }, position: at(scene, 'transblock') });
  assert.match(result.contents.value, /transform/i);
});

test('finds the template of an instance', async () => {
  const text = scene.replace(
    '  <object type="tree" name="root">',
    '  <object type="tree" name="leg"/>\n  <object type="tree" name="root"><transblock><object type="master" name="leg"/></transblock>',
  );
  await open(text);
  const { result } = await client.request('textDocument/definition', {
    textDocument: { uri },
    position: { ...at(text, 'leg"/></trans'), character: at(text, 'leg"/></trans').character + 1 },
  });
  assert.deepEqual(result.range.start, at(text, 'leg"/>\n'));
});

test('files of other programs get no findings', async () => {
  assert.deepEqual(await open('<project><name>not a scene</name></project>'), []);
  assert.deepEqual(await open('{"name": "package"}'), []);
});

test('formatting replaces the text', async () => {
  await open(scene.replaceAll('\n', ''));
  const { result } = await client.request('textDocument/formatting', { textDocument: { uri }, options: {} });
  assert.ok(result[0].newText.split('\n').length > 4);
});

test('unknown methods are answered with an error', async () => {
  const { error } = await client.request('textDocument/rename', {});
  assert.equal(error.code, -32601);
});
