// The library, used as an importer does.

import assert from 'node:assert/strict';
import test from 'node:test';

import { SceneError, check, convert, diff, explain, format, read, render, run } from 'scenefile';

const scene = `<scenefile>
  <globaldata>
    <ambientcoeff v="0.5"/><diffusecoeff v="0.5"/><specularcoeff v="0.5"/><transparentcoeff v="0"/>
  </globaldata>
  <cameradata>
    <pos x="0" y="0" z="3"/><look x="0" y="0" z="-1"/><up x="0" y="1" z="0"/><heightangle v="45"/>
  </cameradata>
  <lightdata>
    <id v="0"/><type v="directional"/><direction x="0" y="0" z="-1"/><color r="1" g="1" b="1"/>
  </lightdata>
  <object type="tree" name="root">
    <transblock>
      <object type="primitive" name="sphere"><diffuse r="1" g="0" b="0"/></object>
    </transblock>
  </object>
</scenefile>
`;

test('check finds a misspelled name at its place', async () => {
  const result = await check(scene.replace('<diffuse ', '<difuse '));
  assert.equal(result.verdict, 'errors');
  const finding = result.findings.find((f) => f.code === 'xml.misspelled-element');
  assert.match(finding.message, /did you mean <diffuse>/);
  assert.equal(finding.line, 13);
  assert.equal(finding.column, scene.split('\n')[12].indexOf('<diffuse') + 1);
});

test('check only sees the files that it is given', async () => {
  const textured = scene.replace('<diffuse r', '<texture file="wall.png" u="1" v="1"/><blend v="1"/><diffuse r');
  const { png } = await render(scene, { width: 4, height: 4 });
  const without = await check(textured);
  assert.deepEqual(without.findings.map((f) => f.code), ['texture.missing']);
  const given = await check(textured, { files: { 'image/wall.png': png } });
  assert.equal(given.verdict, 'fine');
});

test('render gives the pixels', async () => {
  const { width, height, data, png } = await render(scene, { width: 33, height: 21 });
  assert.deepEqual([width, height, data.length], [33, 21, 33 * 21 * 4]);
  const middle = data.subarray(4 * (10 * 33 + 16), 4 * (10 * 33 + 16) + 4);
  assert.ok(middle[0] > 100 && middle[1] < 10 && middle[3] === 255, `red in the middle, not ${middle}`);
  assert.deepEqual([...data.subarray(0, 4)], [0, 0, 0, 255]);
  assert.deepEqual([...png.subarray(1, 4)], [...'PNG'].map((c) => c.charCodeAt(0)));
});

test('render refuses a scene with errors', async () => {
  await assert.rejects(render(scene.replace('<diffuse ', '<difuse ')), (error) => {
    assert.ok(error instanceof SceneError);
    assert.equal(error.status, 1);
    assert.equal(error.findings[0].code, 'xml.misspelled-element');
    return true;
  });
});

test('explain refuses a pixel outside of the picture', async () => {
  await assert.rejects(explain(scene, 9, 0, { width: 9, height: 9 }), (error) => {
    assert.ok(error instanceof SceneError);
    assert.equal(error.status, 2);
    assert.match(error.message, /9,0 is not in the picture/);
    return true;
  });
});

test('functions throw what is wrong with a scene', async () => {
  const broken = scene.replace('name="sphere"', 'name="spher"');
  const findings = (error) => error instanceof SceneError && error.findings.length > 0;
  await assert.rejects(convert(broken, 'json'), (error) => findings(error) && /spher/.test(error.message));
  await assert.rejects(format('<scenefile>\n<object></scenefile>'), (error) => findings(error) && /object/.test(error.message));
  await assert.rejects(explain(broken, 0, 0), findings);
  await assert.rejects(diff(scene, broken), findings);
});

test('convert and diff agree', async () => {
  const { bytes } = await convert(scene, 'json');
  const json = new TextDecoder().decode(bytes);
  assert.equal(typeof JSON.parse(json), 'object');
  assert.equal((await diff(scene, json)).same_meaning, true);
  const other = await diff(scene, scene.replace('heightangle v="45"', 'heightangle v="30"'));
  assert.equal(other.equal, false);
  assert.equal(other.differences.length, 1);
});

test('format is idempotent', async () => {
  const once = await format(scene.replaceAll('\n', ''));
  assert.ok(once.split('\n').length > 15);
  assert.equal(await format(once), once);
  await assert.rejects(format('<scenefile'), SceneError);
});

test('names may have any form', async () => {
  for (const name of ['./chess.xml', 'a//b.xml', '/home/u/chess.xml', 'C:\\a\\chess.xml']) {
    assert.equal((await check(scene, { name })).verdict, 'fine');
    assert.equal(await format(scene, { name }), await format(scene));
  }
  assert.equal((await convert(scene, 'json', { name: './chess.xml', files: { './x.png': new Uint8Array(1) } })).files.size, 0);
});

test('read counts', async () => {
  assert.equal((await read(scene)).summary.primitives.sphere, 1);
});

test('explain says what a pixel hits', async () => {
  const answer = await explain(scene, 16, 10, { width: 33, height: 21 });
  assert.ok(answer.pixel.value[0] > 100);
});

test('jobs do not see each other\'s files', async () => {
  const one = await run(['check', 'a.xml'], { files: { 'a.xml': scene } });
  assert.deepEqual([...one.files.keys()], ['a.xml']);
  const two = await run(['check', 'a.xml']);
  assert.equal(two.status, 3);
  assert.match(two.stderr, /No such file/);
});

test('names cannot leave the folder', async () => {
  await assert.rejects(check(scene, { files: { '../x.png': new Uint8Array(1) } }), RangeError);
});

test('many jobs in a row do not need more stack or memory', async () => {
  for (let i = 0; i < 300; ++i) {
    assert.equal((await check(scene)).verdict, 'fine');
  }
});
