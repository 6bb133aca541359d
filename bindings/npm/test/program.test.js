// The program with the files of the machine, as a user calls it.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import test, { after, before } from 'node:test';

const installed = dirname(createRequire(import.meta.url).resolve('scenefile/package.json'));
const program = join(installed, 'bin/scenefile.js');
const scene = `<scenefile>
  <object type="tree" name="root">
    <transblock><object type="primitive" name="sphere"/></transblock>
  </object>
</scenefile>
`;

let folder;
before(() => (folder = mkdtempSync(join(tmpdir(), 'scenefile-'))));
after(() => rmSync(folder, { recursive: true }));

function scenefile(words, options = {}) {
  return spawnSync(process.execPath, [program, ...words], { cwd: folder, encoding: 'utf8', ...options });
}

test('version names the lanes', () => {
  const done = scenefile(['version']);
  assert.equal(done.status, 0);
  assert.match(done.stdout, /^scenefile [0-9.]+\n/);
  assert.match(done.stdout, /SIMD128/);
});

test('missing and unknown commands are usage errors', () => {
  assert.equal(scenefile([]).status, 2);
  const done = scenefile(['rendr', 'a.xml']);
  assert.equal(done.status, 2);
  assert.match(done.stderr, /did you mean render/);
});

test('a file that does not exist', () => {
  const done = scenefile(['check', 'nowhere.xml']);
  assert.equal(done.status, 3);
  assert.match(done.stderr, /nowhere\.xml/);
});

test('check reads a file and standard input, without colors in pipes', () => {
  writeFileSync(join(folder, 'bad.xml'), scene.replace('primitive', 'primitiv'));
  const file = scenefile(['check', 'bad.xml']);
  assert.equal(file.status, 1);
  assert.match(file.stderr + file.stdout, /bad\.xml:3:/);
  assert.doesNotMatch(file.stderr + file.stdout, /\x1b/);
  assert.equal(scenefile(['check', '-'], { input: scene }).status, 0);
});

test('render writes the whole picture and no other file', () => {
  writeFileSync(join(folder, 'scene.xml'), scene);
  const done = scenefile(['render', 'scene.xml', '-o', 'picture.png', '--size', '16x12']);
  assert.equal(done.status, 0, done.stderr);
  assert.equal(readFileSync(join(folder, 'picture.png')).toString('latin1', 1, 4), 'PNG');
  assert.deepEqual(readdirSync(folder).filter((name) => name.includes('tmp')), []);
});

test('format rewrites a file in place', () => {
  writeFileSync(join(folder, 'flat.xml'), scene.replaceAll('\n', ''));
  assert.equal(scenefile(['format', 'flat.xml']).status, 0);
  assert.ok(readFileSync(join(folder, 'flat.xml'), 'utf8').split('\n').length > 5);
});

test('a refused write leaves the old file', () => {
  const done = scenefile(['render', 'scene.xml', '-o', 'nowhere/picture.png', '--size', '4x4']);
  assert.equal(done.status, 3);
});
