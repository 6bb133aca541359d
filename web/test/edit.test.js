// Edits of the text by the panels: every field of example scenes in several layouts, and random series of
// edits. The core of the npm package judges the results: node --test web/test/edit.test.js

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

import { check, convert, format, read } from '../../build/wasm/package/lib/index.js';
import { fieldsOf } from '../make-fields.js';
import {
  addItem, addTransform, canDuplicate, canWrap, duplicateItem, kindsToAdd, moveInto, moveTransform, neighborOf, removeField, removeItem,
  reorderItem, setPart, targetsFor, whyNotRemoved, wrapItem,
} from '../src/edit/edits.js';
import { fieldsOfItem, itemAt, modelOf } from '../src/edit/model.js';
import { handleOf, moveItem, product, scaleItem, transformed, turnItem, worldOf } from '../src/edit/placing.js';
import { applied, parseXml } from '../src/edit/text.js';

const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));
const schema = (name) => readFileSync(join(root, 'schema', name), 'utf8');
const words = fieldsOf(schema('scenefile.rng'), JSON.parse(schema('scenefile.schema.json')));
const model = (text) => modelOf(text, words);

const own = `<?xml version="1.0"?>
<!-- every kind of thing -->
<scenefile>
\t<globaldata> <ambientcoeff v="0.4"/> <diffusecoeff v="0.6"/> </globaldata> <!-- coefficients -->
\t<cameradata><pos x="1" y="2" z="9"/><look x="0" y="0" z="-1"/><up x="0" y="1" z="0"/><heightangle v="40"/></cameradata>
\t<!-- the sun -->
\t<lightdata>
\t\t<id v="0"/>
\t\t<type v="directional"/>
\t\t<color r="1" g="1" b="0.9"/> <!-- warm -->
\t\t<direction x="-1" y="-2" z="-1"/>
\t</lightdata>

\t<lightdata>
\t\t<id v='3'/>
\t\t<type v="spot"/>
\t\t<color r="1"
\t\t       g="1" b="1"/>
\t\t<function a="1" b="0.1" c="0"/>
\t\t<position x="2" y="2" z="2"/>
\t\t<direction x="-1" y="-1" z="-1"/>
\t\t<angle v="30"/><penumbra v="4"/>
\t</lightdata>
\t<object type="tree" name="leg &amp; foot">
\t\t<transblock><translate x="0" y="1" z="0"/><scale x="0.1" y="2" z="0.1"/><object type="primitive" name="cylinder"/></transblock>
\t</object>
\t<object type="tree" name="root">
\t\t<!-- first -->
\t\t<transblock>
\t\t\t<rotate x="0" y="1" z="0" angle="30"/>
\t\t\t<matrix>
\t\t\t\t<row a="1" b="0" c="0" d="2"/>
\t\t\t\t<row a="0" b="1" c="0" d="0"/>
\t\t\t\t<row a="0" b="0" c="1" d="0"/>
\t\t\t\t<row a="0" b="0" c="0" d="1"/>
\t\t\t</matrix>
\t\t\t<object type="tree" name="table">
\t\t\t\t<transblock>
\t\t\t\t\t<object type="master" name="leg &amp; foot"/>
\t\t\t\t</transblock>
\t\t\t\t<transblock>
\t\t\t\t\t<translate x="1" y="0" z="0"/>
\t\t\t\t\t<object type="tree" name="leg &amp; foot"/>
\t\t\t\t</transblock>
\t\t\t\t<!-- the top -->
\t\t\t\t<transblock>
\t\t\t\t\t<object type="primitive" name="cube">
\t\t\t\t\t\t<diffuse r="0.5" g="0.4" b="0.3"/>   <!-- wood -->
\t\t\t\t\t\t<!-- no highlight -->
\t\t\t\t\t</object>
\t\t\t\t</transblock>
\t\t\t</object>
\t\t</transblock> <!-- end of first -->
\t\t<transblock><object type="primitive" name="sphere"><ambient r="0.1" g="0" b="0"/></object></transblock>
\t</object>
</scenefile>
`;
const oneLine = own.replace(/<!--.*?-->|<\?.*?\?>/g, '').replace(/>\s*\n\s*</g, '><').replace(/\s*\n\s*/g, ' ').trim();
const smallest = '<scenefile><object type="tree" name="root"><transblock><object type="primitive" name="cube"/></transblock></object></scenefile>\n';
const ownJson = `{
  "name": "a \\"scene\\" {[",
  "globalData": {"ambientCoeff": 0.5, "diffuseCoeff": 0.50, "specularCoeff": 5e-1},
  "cameraData": {
    "position": [0, 1, 8], "focus": [ 0.0 , 0 , 0 ],
    "up": [0, 1, 0],
    "heightAngle": 35
  },
  "templateGroups": [
    {"name": "leg", "groups": [{"scale": [0.1, 1, 0.1], "primitives": [{"type": "cylinder"}]}]}
  ],
  "groups": [
    {"translate": [3, 4, 5], "lights": [{"type": "point", "color": [1, 1, 1], "attenuationCoeff": [1, 0, 0]}]},
    {
      "name": "table",
      "rotate": [0, 1, 0, 30],
      "primitives": [
        {"type": "cube", "diffuse": [0.5, 0.4, 0.3]},
        {
          "type": "sphere",
          "ambient": [0.1, 0, 0]
        }
      ],
      "groups": [
        {"translate": [1, 0, 0], "groups": [{"name": "leg"}]},
        {"matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], "groups": [{"name": "leg"}]}
      ]
    }
  ]
}
`;

const file = (...parts) => readFileSync(join(root, ...parts), 'utf8');
const scenes = new Map([
  ['own.xml', own],
  ['one line.xml', oneLine],
  ['smallest.xml', smallest],
  ['own.json', ownJson],
  ['minified.json', JSON.stringify(JSON.parse(ownJson))],
  ['hello.xml', file('scenes/hello.xml')],
  ['showcase.xml', file('scenes/showcase.xml')],
  ...readdirSync(join(root, 'web/examples')).map((name) => [name, file('web/examples', name)]),
]);
for (const name of ['hello.xml', 'showcase.xml', 'lights.xml']) {
  const { bytes } = await convert(scenes.get(name), 'json');
  const json = new TextDecoder().decode(bytes);
  scenes.set(name.replace('xml', 'json'), json);
  scenes.set(`formatted ${name.replace('xml', 'json')}`, await format(json));
}

const isXml = (name) => name.endsWith('.xml');
const findingsOf = async (text) => {
  const { findings, error } = await check(text, { assets: false });
  return [...(error ? [error] : []), ...findings.filter(({ severity }) => severity !== 'note').map(({ code, message }) => `${code}: ${message}`)];
};
const isClean = async (text, what) => assert.deepEqual(await findingsOf(text), [], `${what}\n${text}`);
const commentsOf = (text) => (isXml(text.startsWith('{') ? 'x.json' : 'x.xml') ? parseXml(text).comments.map(({ from, to }) => text.slice(from, to)) : []);

/** The values of all fields of all items. */
const valuesOf = (some) => some.all.map((item) => [item.kind, fieldsOfItem(some, item).map(({ spec, values }) => [spec.name, ...values])]);

const ranged = (part, now) => {
  const number = Number(now ?? 0);
  const low = part.above ?? part.min ?? -Infinity;
  const high = part.below ?? part.max ?? Infinity;
  const wanted = [number + 0.125, number - 0.125, number / 2].find((value) => value > low && value < high && value !== 0);
  return String(wanted);
};

/** A different value that is valid for the part; null if there is no sensible one. */
function otherValue(some, { spec, item, values }, i) {
  const now = values[i];
  switch (spec.kind) {
    case 'choice':
      return spec.values.filter((value) => value !== 'mesh').find((value) => value !== now) ?? null;
    case 'text':
      return item.kind === 'primitive' ? 'some/file "1".obj' : `new <name> & "more" ${i}`;
    case 'image':
      return i === 0 ? 'a & b.png' : '2';
    case 'matrix':
      return i < 12 ? ranged({}, now) : null;
    default:
      return spec.name === 'id' ? '5' : ranged(spec.parts[i], now ?? spec.start?.[i] ?? spec.start);
  }
}

test('the scenes are clean before they are edited', async () => {
  for (const [name, text] of scenes) {
    if (name !== 'smallest.xml') {
      await isClean(text, name);
    }
    assert.equal(model(text).problem, -1, name);
  }
});

// Findings about combinations of values.
const ofValues = new Set([
  'camera.lens-incomplete', 'camera.nothing-in-view', 'global.transparent-default', 'json.matrix-with-others',
  'material.reflective-and-transparent', 'material.specular-without-shininess', 'xml.camera-default',
]);

test('every value of every field can be set; nothing else changes', async () => {
  let count = 0;
  for (const [name, text] of scenes) {
    const before = model(text);
    const known = await findingsOf(text);
    for (let n = 0; n < before.all.length; ++n) {
      const fields = fieldsOfItem(before, before.all[n]);
      for (let f = 0; f < fields.length; ++f) {
        const field = fields[f];
        for (let i = 0; i < field.values.length; ++i) {
          const value = otherValue(before, field, i);
          // Cases to skip: a part of an image without its file, and a name that would make the
          // group an instance.
          if (value === null || (field.spec.kind === 'image' && i > 0 && field.values[0] === null) || (/^(texture|bumpMap)[UV]$/.test(field.spec.name) && field.element === null)) {
            continue;
          }
          const what = `${name}: ${before.all[n].label} ${field.spec.name}[${i}] = ${value}`;
          const { changes } = setPart(before, field, i, value);
          const edited = applied(text, changes);
          const after = model(edited);
          assert.equal(after.problem, -1, what);
          assert.equal(after.all.length, before.all.length, what);
          const found = fieldsOfItem(after, after.all[n]).find(({ spec, movable }, k) => spec.name === field.spec.name && (!movable || k === f));
          assert.equal(found.values[i], value, `${what}\n${edited}`);
          assert.deepEqual(commentsOf(edited), commentsOf(text), what);
          if (field.element !== null && !['type', 'name'].includes(field.spec.name)) {
            assert.ok(changes.length === 1, what);
            const others = (some) => valuesOf(some).map(([kind, list], k) => [kind, k === n ? list.map((entry, j) => (j === f ? entry.filter((_, at) => at !== i + 1) : entry)) : list]);
            assert.deepEqual(others(after), others(before), what);
          }
          if (field.spec.kind !== 'matrix' || i % 5 === 0) {
            count += 1;
            if (count % 16 === 0) {
              const news = (await findingsOf(edited)).filter((finding) => !known.includes(finding));
              assert.deepEqual(news.filter((finding) => !ofValues.has(finding.split(':')[0])), [], `${what}\n${edited}`);
            }
          }
        }
      }
    }
  }
  console.log(`${count} values set`);
  assert.ok(count > 1500);
});

const after = (text, { changes }) => applied(text, changes);

test('removing a field that was set restores the original text', () => {
  let count = 0;
  for (const [name, text] of scenes) {
    const before = model(text);
    before.all.forEach((item, n) => {
      for (const field of fieldsOfItem(before, item)) {
        if (field.element !== null || item.element === null || field.spec.instead !== undefined || field.spec.needs !== undefined) {
          continue;
        }
        const value = otherValue(before, field, 0);
        const edited = after(text, setPart(before, field, 0, value));
        const now = model(edited);
        const same = fieldsOfItem(now, now.all[n]).find(({ spec }) => spec.name === field.spec.name);
        const back = after(edited, removeField(now, same));
        const loose = (some) => some.replace(/\s*\/>|>\s*<\/object>/g, '/>');
        assert.equal(loose(back), loose(text), `${name}: ${item.label} ${field.spec.name}`);
        count += 1;
      }
    });
  }
  assert.ok(count > 300, String(count));
});

test('setting a value back restores the original text', () => {
  for (const [name, text] of scenes) {
    const before = model(text);
    before.all.forEach((item, n) => {
      fieldsOfItem(before, item).forEach((field, f) => {
        field.values.forEach((value, i) => {
          if (value === null || field.spec.kind === 'choice' || (field.own && field.spec.name === 'name') || (!isXml(name) && field.spec.name === 'name')) {
            return;
          }
          const edited = after(text, setPart(before, field, i, otherValue(before, field, i) ?? '1'));
          const now = model(edited);
          assert.equal(after(edited, setPart(now, fieldsOfItem(now, now.all[n])[f], i, value)), text, `${name}: ${item.label} ${field.spec.name}`);
        });
      });
    });
  }
});

test('every light can change to every type, with exactly the fields that the type needs', async () => {
  for (const [name, text] of scenes) {
    const before = model(text);
    for (let n = 0; n < before.lights.length; ++n) {
      const type = fieldsOfItem(before, before.lights[n]).find(({ spec }) => spec.name === 'type');
      for (const value of type.spec.values) {
        const edited = after(text, setPart(before, type, 0, value));
        const findings = (await findingsOf(edited)).filter((finding) => !/^(light\.misses|scene\.unlit)/.test(finding));
        assert.deepEqual(findings, [], `${name}: light ${n} becomes ${value}\n${edited}`);
        assert.equal(model(edited).lights[n].type, value);
        assert.deepEqual(commentsOf(edited), commentsOf(text));
      }
    }
  }
});

test('everything can be added, and removed again', async () => {
  for (const [name, text] of scenes) {
    if (name === 'smallest.xml') {
      continue;
    }
    const before = model(text);
    const places = [null, before.root, before.all.find(({ kind }) => kind === 'group'), before.all.findLast(({ kind }) => kind === 'primitive')].filter((item) => item !== undefined);
    for (const near of places) {
      for (const kind of kindsToAdd(before)) {
        const what = `${name}: ${kind.label} beside ${near?.label}`;
        if (kind.kind === 'instance' && near !== null && before.templates.some((template) => template.from <= near.from && near.from < template.to)) {
          continue;
        }
        const { changes, select } = addItem(before, near, kind);
        const edited = applied(text, changes);
        const now = model(edited);
        const found = itemAt(now, select);
        assert.ok(found.kind === kind.kind || (!isXml(name) && found.kind === 'group' && found.children.length === 1), `${what}: ${found.kind}\n${edited}`);
        assert.deepEqual(commentsOf(edited), commentsOf(text), what);
        const expected = kind.kind === 'group' ? /^(xml|json)\.empty-/ : /^(light\.many|light\.misses|scene\.unlit|xml\.light-id)/;
        const news = (await findingsOf(edited)).filter((finding) => !expected.test(finding));
        assert.deepEqual(news, [], `${what}\n${edited}`);
        const gone = after(edited, removeItem(now, found));
        const dense = (some) => some.replace(/\s+/g, '').replace(',"groups":[]', ''); // a list that was created for it may remain
        assert.equal(dense(gone), dense(text), `${what}\n${edited}\n${gone}`);
      }
    }
  }
});

test('duplicates are removed without a trace; moves there and back change nothing', async () => {
  for (const [name, text] of scenes) {
    const before = model(text);
    const known = await findingsOf(text);
    for (const [n, item] of before.all.entries()) {
      const what = `${name}: ${item.kind} ${item.label} (${n})`;
      if (canDuplicate(before, item)) {
        const { changes, select } = duplicateItem(before, item);
        const edited = applied(text, changes);
        const now = model(edited);
        const copy = itemAt(now, select);
        assert.equal(copy?.kind, item.kind, `${what}\n${edited}`);
        assert.ok(now.all.length > before.all.length, what);
        const news = (await findingsOf(edited)).filter((finding) => !known.includes(finding) && !/^(light\.many|xml\.light-id|scene\.coincident)/.test(finding));
        assert.deepEqual(news, [], `${what}\n${edited}`);
        assert.equal(after(edited, removeItem(now, copy)), text, what);
      }
      for (const step of [-1, 1]) {
        if (neighborOf(before, item, step) === undefined) {
          continue;
        }
        const { changes, select } = reorderItem(before, item, step);
        const edited = applied(text, changes);
        const now = model(edited);
        const moved = itemAt(now, select);
        assert.equal(edited.slice(moved.from, moved.to), text.slice(item.from, item.to), `${what}\n${edited}`);
        assert.deepEqual(commentsOf(edited).sort(), commentsOf(text).sort(), what);
        assert.equal(after(edited, reorderItem(now, moved, -step)), text, `${what} ${step}\n${edited}`);
      }
    }
  }
});

/** What the core reads: all numbers of the scene in a canonical form. */
const countsOf = async (text) => {
  const { nodes, primitives, lights } = await read(text, { name: 'x' });
  return JSON.stringify([primitives, lights]);
};

test('items move to every group that accepts them, and into new groups', async () => {
  for (const [name, text] of scenes) {
    if (name.includes('showcase') || name === 'smallest.xml') {
      continue;
    }
    const before = model(text);
    const kinds = (some) => some.all.filter(({ kind }) => kind !== 'group').map(({ kind, label }) => `${kind} ${label}`).sort();
    for (const item of before.all) {
      const what = `${name}: ${item.kind} ${item.label}`;
      for (const target of targetsFor(before, item)) {
        const { changes, select } = moveInto(before, item, target);
        const edited = applied(text, changes);
        const now = model(edited);
        const where = `${what} into ${target.label}\n${edited}`;
        assert.equal(now.problem, -1, where);
        assert.deepEqual(kinds(now), kinds(before), where);
        const moved = itemAt(now, select);
        assert.equal(moved.label, item.label, where);
        assert.equal(moved.parent.label, target.label, where);
        assert.deepEqual(commentsOf(edited).sort(), commentsOf(text).sort(), where);
        const errors = (await check(edited, { assets: false })).findings.filter(({ severity }) => severity === 'error');
        assert.deepEqual(errors, [], where);
      }
      if (canWrap(before, item)) {
        const edited = after(text, wrapItem(before, item));
        assert.equal(model(edited).problem, -1, `${what}\n${edited}`);
        assert.deepEqual(kinds(model(edited)), kinds(before), `${what}\n${edited}`);
        assert.deepEqual(commentsOf(edited), commentsOf(text), what);
        await isClean(edited, `${what} in a group`);
        if (!name.includes('lights')) {
          assert.equal(await countsOf(edited), await countsOf(text), what);
        }
      }
    }
  }
});

test('transforms are added, reordered and removed', async () => {
  const before = model(own);
  const item = before.all.find(({ kind, label }) => kind === 'group' && label === 'table');
  let text = own;
  for (const name of ['translate', 'rotate', 'scale', 'matrix']) {
    text = after(text, addTransform(model(text), itemAt(model(text), item.from), name));
    await isClean(text, name);
  }
  const names = () => fieldsOfItem(model(text), itemAt(model(text), item.from)).filter(({ movable }) => movable).map(({ spec }) => spec.name);
  assert.deepEqual(names(), ['rotate', 'matrix', 'translate', 'rotate', 'scale', 'matrix']);
  const fieldAt = (i) => fieldsOfItem(model(text), itemAt(model(text), item.from)).filter(({ movable }) => movable)[i];
  text = after(text, moveTransform(model(text), fieldAt(2), -1));
  assert.deepEqual(names(), ['rotate', 'translate', 'matrix', 'rotate', 'scale', 'matrix']);
  assert.equal(moveTransform(model(text), fieldAt(0), -1), null);
  for (const i of [5, 4, 3]) {
    text = after(text, removeField(model(text), fieldAt(i)));
  }
  text = after(text, moveTransform(model(text), fieldAt(2), -1));
  text = after(text, removeField(model(text), fieldAt(2)));
  assert.equal(text, own);
});

test('global data and a camera that the file lacks are written with all required fields', async () => {
  for (const [name, text] of [['smallest.xml', smallest], ['hello.xml', file('scenes/hello.xml').replace(/ *<cameradata>[^]*<\/cameradata>\n/, '')]]) {
    for (const kind of ['globals', 'camera']) {
      const before = model(text);
      const item = before.all.find((some) => some.kind === kind);
      for (const field of fieldsOfItem(before, item)) {
        const edited = after(text, setPart(before, field, 0, ranged(field.spec.parts[0], field.spec.start[0])));
        const errors = (await check(edited, { assets: false })).findings.filter(({ severity, code }) => severity === 'error' || code === 'xml.camera-default');
        assert.deepEqual(errors, [], `${name}: ${field.spec.name}\n${edited}`);
      }
    }
  }
});

test('a template keeps its instances when it is renamed, and is not removed while it has any', () => {
  for (const name of ['own.xml', 'own.json']) {
    const text = scenes.get(name);
    const before = model(text);
    const [template] = before.templates;
    assert.match(whyNotRemoved(before, template), /used 2 times/);
    const field = fieldsOfItem(before, template).find(({ spec }) => spec.name === 'name');
    const now = model(after(text, setPart(before, field, 0, 'a <b>')));
    assert.equal(now.all.filter((item) => item.kind === 'instance' && item.name === 'a <b>').length, 2);
  }
});

test('a long random series of edits leaves a clean scene with all comments', async () => {
  let seed = 12345;
  const random = (n) => {
    seed = (Math.imul(seed, 1103515245) + 12345) >>> 0;
    return Math.floor((seed / 2 ** 32) * n);
  };
  for (const name of ['own.xml', 'own.json', 'minified.json', 'hello.xml', 'one line.xml']) {
    let text = scenes.get(name);
    const done = [];
    for (let i = 0; i < 120; ++i) {
      const now = model(text);
      const item = now.all[random(now.all.length)];
      const actions = [];
      const fields = fieldsOfItem(now, item).filter(({ spec }) => spec.kind !== 'text' && spec.kind !== 'choice' && spec.kind !== 'image');
      if (fields.length > 0) {
        const field = fields[random(fields.length)];
        const part = random(field.values.length);
        const value = otherValue(now, field, part);
        if (value !== null) {
          actions.push(['set', () => setPart(now, field, part, value)]);
        }
      }
      if (now.lights.length < 7) {
        const kinds = kindsToAdd(now).filter(({ kind, name: what }) => kind !== 'instance' && what !== 'mesh');
        actions.push(['add', () => addItem(now, item, kinds[random(kinds.length)])]);
      }
      if (canDuplicate(now, item) && now.all.length < 40 && item.kind !== 'light') {
        actions.push(['duplicate', () => duplicateItem(now, item)]);
      }
      if (whyNotRemoved(now, item) === null && (item.kind === 'light' || now.all.length > 20)) {
        actions.push(['remove', () => removeItem(now, item)]);
      }
      for (const step of [-1, 1]) {
        if (neighborOf(now, item, step) !== undefined && item.kind !== 'template') {
          actions.push([`reorder ${step}`, () => reorderItem(now, item, step)]);
        }
      }
      const targets = targetsFor(now, item);
      if (targets.length > 0) {
        actions.push(['move', () => moveInto(now, item, targets[random(targets.length)])]);
      }
      if (canWrap(now, item)) {
        actions.push(['wrap', () => wrapItem(now, item)]);
      }
      const [action, act] = actions[random(actions.length)];
      const comments = commentsOf(text);
      const edited = after(text, act());
      done.push(`${action} ${item.kind} ${item.label}`);
      const what = `${name}: ${done.slice(-3).join(', ')}\n${text}\n=>\n${edited}`;
      assert.equal(model(edited).problem, -1, what);
      assert.ok(comments.every((comment) => commentsOf(edited).includes(comment)) || action === 'remove' || action === 'duplicate', what);
      if (i % 10 === 9) {
        const errors = (await check(edited, { assets: false })).findings.filter(({ severity }) => severity === 'error');
        assert.deepEqual(errors, [], what);
      }
      text = edited;
    }
  }
});

const near = (a, b, what) => a.forEach((x, i) => assert.ok(Math.abs(x - b[i]) <= 2e-3 * (1 + Math.abs(b[i])), `${what}: ${a} instead of ${b}`));

test('handles move, turn and scale objects in the world as far as they say', async () => {
  let count = 0;
  for (const [name, text] of scenes) {
    const before = model(text);
    for (const [n, item] of before.all.entries()) {
      const handle = handleOf(before, item);
      if (handle === null) {
        continue;
      }
      count += 1;
      const what = `${name}: ${item.kind} ${item.label}`;
      for (const axis of [0, 1, 2]) {
        const delta = [0, 1, 2].map((i) => (i === axis ? 0.625 : 0));
        const edited = after(text, moveItem(before, handle, delta));
        const now = model(edited);
        const moved = handleOf(now, now.all[n]);
        const by = transformed(handle.space, delta, 0);
        near(moved.origin, handle.origin.map((x, i) => x + by[i]), `${what} moved\n${edited}`);
        assert.deepEqual(commentsOf(edited), commentsOf(text), what);
        if (handle.position !== null) {
          continue;
        }
        const old = worldOf(before, handle.item);
        const worldNow = (change) => {
          const again = model(after(text, change));
          return worldOf(again, handleOf(again, again.all[n]).item);
        };
        const linear = (m) => [0, 1, 2, 4, 5, 6, 8, 9, 10].map((i) => m[i]);
        const [c, s] = [Math.cos(Math.PI / 6), Math.sin(Math.PI / 6)];
        const turn = [
          [1, 0, 0, 0, 0, c, -s, 0, 0, s, c, 0, 0, 0, 0, 1],
          [c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1],
          [c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
        ][axis];
        const isTop = handle.item.parent.kind === 'root';
        if (isTop) {
          near(linear(worldNow(turnItem(before, handle, axis, 30))), linear(product(turn, old)), `${what} turned`);
        }
        const own = fieldsOfItem(before, handle.item).filter(({ spec, element }) => ['translate', 'rotate', 'scale', 'matrix'].includes(spec.name) && element !== null);
        if (own.length === 0 || (before.xml && own.at(-1).spec.name === 'scale') || (before.xml && own.every(({ spec }) => spec.name !== 'scale'))) {
          const factors = [0, 1, 2].map((i) => (i === axis ? 1.5 : 1));
          const scale = [factors[0], 0, 0, 0, 0, factors[1], 0, 0, 0, 0, factors[2], 0, 0, 0, 0, 1];
          near(linear(worldNow(scaleItem(before, handle, axis, 1.5))), linear(product(old, scale)), `${what} scaled`);
        }
      }
    }
    for (const change of [moveItem, scaleItem, turnItem]) {
      const item = before.all.find((some) => some.kind === 'primitive' && handleOf(before, some) !== null);
      if (item && name !== 'smallest.xml') {
        const argument = change === moveItem ? [[0.1, 0, 0]] : [1, 1.25];
        const errors = (await findingsOf(after(text, change(before, handleOf(before, item), ...argument)))).filter((finding) => !ofValues.has(finding.split(':')[0]));
        assert.deepEqual(errors, [], `${name} ${change.name}`);
      }
    }
  }
  assert.ok(count > 100, String(count));
});

test('several objects in a transblock are edited one by one, but not copied or moved', () => {
  const text = '<scenefile>\n<object type="tree" name="root">\n<transblock>\n<scale x="1" y="2" z="1"/>\n<object type="primitive" name="cube"/>\n<object type="primitive" name="cone"/>\n</transblock>\n</object>\n</scenefile>\n';
  const before = model(text);
  const [cube, cone] = before.all.filter(({ kind }) => kind === 'primitive');
  for (const item of [cube, cone]) {
    assert.equal(canDuplicate(before, item) || canWrap(before, item) || neighborOf(before, item, 1) !== undefined || targetsFor(before, item).length > 0, false);
  }
  const shape = fieldsOfItem(before, cone).find(({ spec }) => spec.name === 'name');
  assert.equal(after(text, setPart(before, shape, 0, 'sphere')), text.replace('"cone"', '"sphere"'));
  assert.equal(after(text, removeItem(before, cone)), text.replace('<object type="primitive" name="cone"/>\n', ''));
});

test('a template without a name has no instances', () => {
  const text = '{"globalData": {}, "templateGroups": [{"primitives": []}], "groups": [{"primitives": [{"type": "cube"}]}]}';
  assert.deepEqual(model(text).all.map(({ kind }) => kind), ['globals', 'camera', 'template', 'root', 'group', 'primitive']);
});
