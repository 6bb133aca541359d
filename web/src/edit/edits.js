// Edits of a scene as changes of its text: { changes, select }. `select`: the offset, in the new
// text, of the item to select afterwards. Everything else in the text stays byte for byte.

import { fieldsOfItem, topOf, xmlParts } from './model.js';
import {
  exchanged, insertChildren, insertEntry, memberOf, pieceAt, placeAfter, removeElement, removeEntry, setAttribute, textOfValue,
  withRemarks, Written,
} from './text.js';

/** A number in a form that both dialects accept; null if the text is not a number. */
export function numberText(text) {
  const number = text.trim() === '' ? NaN : Number(text);
  return Number.isFinite(number) ? String(number) : null;
}

const edit = (changes, change = null, offset = 0) => ({
  changes,
  select: change === null ? null : placeAfter(changes, change, offset),
});

// Descriptions of new elements and values.

const written = (value) =>
  Array.isArray(value) ? value.map(written) : typeof value === 'number' ? new Written(String(value)) : value;

function newXmlField(spec, values = spec.start) {
  if (spec.kind === 'matrix') {
    const rows = Array.from({ length: 4 }, (_, i) => spec.row.map((part, j) => [part.names[0], String((values.flat())[4 * i + j])]));
    return { name: spec.name, children: rows.map((attributes) => ({ name: 'row', attributes })) };
  }
  const given = spec.parts.map((part, i) => [part, values[i] ?? spec.start[i]]);
  return { name: spec.name, attributes: given.filter(([part], i) => !part.optional || values[i] !== undefined).map(([part, value]) => [part.names[0], String(value)]) };
}

const isText = (spec) => spec.kind === 'text' || spec.kind === 'choice';

function newJsonField(spec, values = null) {
  if (values === null) {
    return written(spec.start ?? '');
  }
  if (isText(spec)) {
    return values[0];
  }
  const parts = [spec.start].flat(2).map((start, i) => new Written(String(values[i] ?? start)));
  if (spec.kind === 'matrix') {
    return [0, 4, 8, 12].map((i) => parts.slice(i, i + 4));
  }
  return Array.isArray(spec.start) ? parts : parts[0];
}

const specsOf = (model, item) => model.words.fields[model.xml && item.kind === 'primitive' ? 'primitive' : item.fields];
const specOf = (model, item, name) => specsOf(model, item).find((spec) => spec.name === name);

// One value.

/** Sets part `index` of a field to a text: a number from numberText(), a name or a file. */
export function setPart(model, field, index, value) {
  return setParts(model, field, field.values.map((_, i) => (i === index ? value : null)));
}

/** The same for several parts; null leaves a part unchanged. */
export function setParts(model, field, values) {
  if (field.item.kind === 'template' && field.spec.name === 'name') {
    return renameTemplate(model, field, values[0]);
  }
  if (field.item.kind === 'light' && field.spec.name === 'type') {
    return changeType(model, field, values[0]);
  }
  const changes = valueChanges(model, field, values);
  const { item } = field;
  if (item.kind === 'primitive' && field.spec.name === (model.xml ? 'name' : 'type') && values[0] !== item.name) {
    changes.push(...meshFileChanges(model, field, values[0]));
  }
  return edit(changes);
}

function valueChanges(model, field, values) {
  return model.xml ? xmlChanges(model, field, values) : jsonChanges(model, field, values);
}

function xmlChanges(model, field, values) {
  const { spec, item, element, own } = field;
  const { text } = model;
  if (own) {
    return [setAttribute(text, item.element, spec.name, values[0], spec.name === 'name' ? ['type'] : ['type', 'name'])];
  }
  if (element === null) {
    return insertField(model, item, spec, values);
  }
  if (spec.kind === 'matrix') {
    const rows = element.children;
    return values.flatMap((value, i) => {
      const row = rows[Math.floor(i / 4)];
      return value === null || row === undefined ? [] : [partChange(text, row, spec.row, i % 4, value)];
    });
  }
  return values.flatMap((value, i) => (value === null ? [] : [partChange(text, element, spec.parts, i, value)]));
}

function partChange(text, element, parts, i, value) {
  const found = xmlParts(element, parts);
  const used = Math.max(0, parts[0].names.findIndex((_, form) => found.some((part, k) => part?.name === parts[k].names[form])));
  const name = (k) => found[k]?.name ?? parts[k].names[used];
  return setAttribute(text, element, name(i), value, parts.slice(0, i).map((_, k) => name(k)));
}

// Adds a field that is not in the file, as a new element or entry, in the order of the format.
function insertField(model, item, spec, values) {
  const { text } = model;
  const given = spec.parts.map((_, i) => values[i] ?? undefined);
  const needed = (spec.needs ?? []).filter((name) => fieldsOfItem(model, item).find((field) => field.spec.name === name)?.element === null);
  if (model.xml) {
    const fresh = [newXmlField(spec, given), ...needed.map((name) => newXmlField(specOf(model, item, name), ['1']))];
    if (item.element === null) {
      return [newContainer(model, item, spec, given)];
    }
    const other = item.element.children.findLast(({ name }) => name === spec.instead);
    if (other !== undefined) {
      const change = insertChildren(text, item.element, other, fresh.map((xml) => ({ xml })));
      const removal = { from: other.from, to: other.to, insert: change.insert.slice(change.select) };
      return [removal];
    }
    const order = specsOf(model, item).map(({ name }) => name);
    const before = item.element.children.findLast(({ name }) => order.includes(name) && order.indexOf(name) < order.indexOf(spec.name));
    return [insertChildren(text, item.element, before ?? null, fresh.map((xml) => ({ xml })))];
  }
  if (item.element === null) {
    return [newContainer(model, item, spec, given)];
  }
  const value = newJsonField(spec, given);
  const other = memberOf(item.element, spec.instead);
  if (other !== undefined) {
    const change = insertEntry(text, item.element, item.element.entries.indexOf(other) + 1, { json: value }, spec.name);
    return [{ from: other.from, to: other.to, insert: change.insert.slice(change.select) }];
  }
  const pairs = [[spec.name, value], ...needed.map((name) => [name, new Written('1')])];
  const { entries } = item.element;
  const order = specsOf(model, item).map(({ name }) => name);
  const before = entries.findLastIndex(({ key }) => order.includes(key) && order.indexOf(key) < order.indexOf(spec.name));
  return joinedInserts(text, item.element, before < 0 && entries.length > 0 ? 0 : before + 1, pairs);
}

// Several entries inserted at one place, as one change.
function joinedInserts(text, object, index, pairs) {
  if (object.entries.length === 0) {
    const [[key, value], ...others] = pairs;
    const first = insertEntry(text, object, 0, { json: value }, key);
    return others.length === 0 ? [first] : [{ ...first, insert: first.insert.trimEnd() + others.map(([name, other]) => `, ${JSON.stringify(name)}: ${other.text ?? JSON.stringify(other)}`).join('') }];
  }
  const changes = pairs.map(([key, value]) => insertEntry(text, object, index, { json: value }, key));
  const [{ from, to, select }] = changes;
  return [{ from, to, insert: changes.map(({ insert }) => insert).join(''), select }];
}

// Adds global data or a camera that the file lacks, with all required fields.
function newContainer(model, item, spec, given) {
  const { text, scene } = model;
  const specs = specsOf(model, item).filter((some) => some === spec || some.required || (some.name === 'look' && spec.instead !== 'look' ));
  if (model.xml) {
    const xml = { name: item.fields, children: specs.map((some) => newXmlField(some, some === spec ? given : some.start)) };
    const globals = scene.children.findLast(({ name }) => name === 'globaldata');
    return insertChildren(text, scene, item.kind === 'camera' ? (globals ?? null) : null, [{ xml }]);
  }
  const json = Object.fromEntries(specs.map((some) => [some.name, newJsonField(some, some === spec ? given : null)]));
  const wrong = scene.entries.findIndex(({ key }) => key === item.fields);
  const index = item.kind === 'camera' ? scene.entries.findIndex(({ key }) => key === 'globalData') + 1 : 0;
  const change = insertEntry(text, scene, index, { json }, item.fields);
  return wrong < 0 ? change : { from: scene.entries[wrong].value.from, to: scene.entries[wrong].value.to, insert: change.insert.slice(change.insert.indexOf('{'), change.insert.lastIndexOf('}') + 1) };
}

function jsonChanges(model, field, values) {
  const { spec, item, element } = field;
  const { text } = model;
  if (element === null) {
    return insertField(model, item, spec, values);
  }
  const { value } = element;
  if (isText(spec)) {
    return [{ from: value.from, to: value.to, insert: JSON.stringify(values[0]) }];
  }
  if (!Array.isArray(spec.start)) {
    return [{ from: value.from, to: value.to, insert: values[0] }];
  }
  const parts = value.entries.flatMap((entry) => (spec.kind === 'matrix' ? entry.entries : [entry]));
  if (value.type === 'array' && parts.length === spec.parts.length) {
    return values.flatMap((part, i) => (part === null ? [] : [{ from: parts[i].from, to: parts[i].to, insert: part }]));
  }
  const known = values.map((part, i) => part ?? (parts[i] === undefined ? undefined : textOfValue(text, parts[i])));
  const whole = newJsonField(spec, known);
  const json = (some) => (Array.isArray(some) ? `[${some.map(json).join(', ')}]` : some.text);
  return [{ from: value.from, to: value.to, insert: json(whole) }];
}

/** Removes a field from the file. */
export function removeField(model, { spec, item, element, own }) {
  if (own) {
    const { from, to } = item.element.attributes.find(({ name }) => name === spec.name);
    const blanks = /\s*$/.exec(model.text.slice(0, from))[0].length;
    return edit([{ from: from - blanks, to, insert: '' }]);
  }
  return edit([model.xml ? removeElement(model.text, element) : removeEntry(item.element, item.element.entries.indexOf(element))]);
}

// Changes the type of a light: adds the fields that the type requires, and removes those without
// effect.
function changeType(model, field, type) {
  const { item } = field;
  const uses = model.words.lights[type];
  const changes = valueChanges(model, field, [type]);
  if (uses === undefined) {
    return edit(changes);
  }
  const specs = specsOf(model, item);
  const present = (spec) => fieldsIn(model, item, spec.name);
  const unused = specs.filter((spec) => spec !== field.spec && present(spec) && !uses.used.includes(spec.name));
  const missing = specs.filter((spec) => spec.name !== 'type' && !present(spec) && uses.required.includes(spec.name));
  const fresh = missing.map((spec) => [spec, spec.name === 'id' ? [String(freeId(model))] : undefined]);
  if (model.xml) {
    changes.push(...unused.map((spec) => removeElement(model.text, present(spec))));
    if (fresh.length > 0) {
      const last = item.element.children.findLast((child) => !unused.some((spec) => present(spec) === child));
      changes.push(insertChildren(model.text, item.element, last ?? null, fresh.map(([spec, values]) => ({ xml: newXmlField(spec, values) }))));
    }
    return edit(mergedAtPlace(changes));
  }
  // Removals of neighboring entries overlap, so replace entries one after another where possible.
  const { entries } = item.element;
  const gone = unused.map((spec) => entries.indexOf(present(spec)));
  const added = fresh.map(([spec]) => [spec.name, newJsonField(spec)]);
  while (gone.length > 0 && added.length > 0) {
    const { from, to } = entries[gone.shift()];
    const [name, value] = added.shift();
    changes.push({ from, to, insert: `${JSON.stringify(name)}: ${plainJson(value)}` });
  }
  changes.push(...removalsOf(item.element, gone));
  if (added.length > 0) {
    const at = entries.findIndex(({ key }) => key === 'type') + 1 || entries.length;
    changes.push(...joinedInserts(model.text, item.element, at, added));
  }
  return edit(mergedAtPlace(changes));
}

// Removes several entries of a list; at least one must stay.
function removalsOf(list, indexes) {
  const { entries } = list;
  const stays = entries.map((_, i) => !indexes.includes(i));
  const first = stays.indexOf(true);
  return indexes.map((i) =>
    i < first ? { from: entries[i].from, to: entries[i + 1].from, insert: '' } : { from: entries[i - 1].to, to: entries[i].to, insert: '' },
  );
}

const plainJson = (value) =>
  value instanceof Written ? value.text : Array.isArray(value) ? `[${value.map(plainJson).join(', ')}]` : JSON.stringify(value);

const fieldsIn = (model, item, name) =>
  model.xml ? item.element.children.findLast((child) => child.name.toLowerCase() === name) : memberOf(item.element, name);

// An insertion and a removal at the same offset become one change, so that their order is defined.
function mergedAtPlace(changes) {
  const result = [];
  for (const change of [...changes].sort((a, b) => a.from - b.from || a.to - b.to)) {
    const last = result.at(-1);
    if (last !== undefined && change.from === last.to && last.from !== last.to) {
      last.insert += change.insert;
      last.to = change.to;
    } else {
      result.push({ ...change });
    }
  }
  return result;
}

function meshFileChanges(model, field, shape) {
  const { item } = field;
  const key = model.xml ? 'filename' : 'meshFile';
  const spec = model.shapes.primitive.find(({ name }) => name === 'meshFile');
  if (model.xml) {
    const known = item.element.attributes.find(({ name }) => name === key || name === 'meshfile');
    if (shape === 'mesh') {
      return known ? [] : [setAttribute(model.text, item.element, key, spec.start, ['type', 'name'])];
    }
    return known ? [{ from: known.from - 1, to: known.to, insert: '' }] : [];
  }
  const known = memberOf(item.element, key);
  if (shape === 'mesh') {
    return known ? [] : joinedInserts(model.text, item.element, item.element.entries.indexOf(field.element) + 1, [[key, spec.start]]);
  }
  return known ? [removeEntry(item.element, item.element.entries.indexOf(known))] : [];
}

function renameTemplate(model, field, name) {
  const instances = model.all.filter((item) => item.kind === 'instance' && item.name === field.item.name);
  return edit([field, ...instances.map((item) => fieldsOfItem(model, item)[0])].flatMap((some) => valueChanges(model, some, [name])));
}

// Transforms in XML: any number, in any order.

/** Adds a transform to an object; `before`: after how many others, -1: after all. */
export function addTransform(model, item, name, values, before = -1) {
  const spec = model.words.fields.transblock.find((some) => some.name === name);
  const { children } = item.block;
  const object = children.findIndex((child) => child.name.toLowerCase() === 'object');
  const index = before < 0 ? object : Math.min(before, object);
  return edit([insertChildren(model.text, item.block, children[index - 1] ?? null, [{ xml: newXmlField(spec, values) }])]);
}

/** Swaps a transform with the one before it (-1) or after it (+1); null if there is none. */
export function moveTransform(model, field, step) {
  const fields = fieldsOfItem(model, field.item).filter(({ movable }) => movable);
  const at = fields.findIndex(({ element }) => element === field.element);
  const other = fields[at + step];
  return other === undefined ? null : edit(exchanged(model.text, place(field.element), place(other.element)));
}

const place = ({ from, to }) => ({ from, to });

// Items.

const siblingsOf = (model, item) => {
  if (!model.xml) {
    return model.all.filter(({ list }) => list !== null && list === item.list);
  }
  switch (item.kind) {
    case 'light':
      return model.lights;
    case 'template':
      return model.templates;
    default:
      return item.parent?.children ?? [];
  }
};

const ownPlace = (model, item) => (model.xml ? withRemarks(model.text, item, item.block?.parent.tagEnd ?? model.scene.tagEnd) : place(item));

const isFixed = ({ kind }) => kind === 'globals' || kind === 'camera' || kind === 'root';

const usersOf = (model, item) => model.all.filter(({ kind, name }) => kind === 'instance' && name === item.name).length;

/** Why an item cannot be removed; null if it can. */
export function whyNotRemoved(model, item) {
  if (isFixed(item)) {
    return 'every scene needs it';
  }
  const users = item.kind === 'template' ? usersOf(model, item) : 0;
  return users > 0 ? `it is used ${users === 1 ? 'once' : `${users} times`}` : null;
}

export function removeItem(model, item) {
  const siblings = siblingsOf(model, item);
  const at = siblings.indexOf(item);
  const next = siblings[at + 1] ?? siblings[at - 1] ?? item.parent;
  // The offset of the next item after the removal.
  const changes = removalOf(model, item);
  const [{ from, to }] = changes;
  const select = next ? (next.from > from ? next.from - (to - from) : next.from) : null;
  return { changes, select };
}

function removalOf(model, item) {
  if (model.xml) {
    // An unnamed group must not become empty.
    return [removeElement(model.text, item)];
  }
  return [removeEntry(item.list, item.list.entries.indexOf(item.element))];
}

const freeName = (wanted, taken) => {
  const base = wanted.replace(/-\d+$/, '');
  let name = wanted;
  for (let n = 2; taken.has(name); ++n) {
    name = `${base}-${n}`;
  }
  return name;
};

const templateNames = (model) => new Set(['root', ...model.templates.map(({ name }) => name)]);

function freeId(model) {
  const taken = new Set(model.lights.map((light) => Number(fieldsOfItem(model, light).find(({ spec }) => spec.name === 'id')?.values[0])));
  let id = 0;
  while (taken.has(id)) {
    ++id;
  }
  return id;
}

export const canDuplicate = (model, item) => !isFixed(item) && !item.shared;

/** Inserts a copy after the item; a copied light gets a new id, a copied template a new name. */
export function duplicateItem(model, item) {
  const piece = pieceAt(model.text, item);
  const renamed = (name, value) => {
    const field = fieldsOfItem(model, item).find(({ spec }) => spec.name === name);
    if (field === undefined || field.element === null) {
      return;
    }
    const [{ from, to, insert }] = valueChanges(model, field, [value]);
    piece.moved = piece.moved.slice(0, from - item.from) + insert + piece.moved.slice(to - item.from);
  };
  if (item.kind === 'light' && model.xml) {
    renamed('id', String(freeId(model)));
  }
  if (item.kind === 'template') {
    renamed('name', freeName(item.name, templateNames(model)));
  }
  return inserted(model, item, piece);
}

// A piece after an item.
function inserted(model, item, piece) {
  const change = model.xml
    ? insertChildren(model.text, item.kind === 'light' || item.kind === 'template' ? model.scene : item.block.parent, item.block ?? item.element, [piece])
    : insertEntry(model.text, item.list, item.list.entries.indexOf(item.element) + 1, piece);
  return edit([change], change, change.select);
}

/** The item to swap places with; undefined if there is none. */
export function neighborOf(model, item, step) {
  if (isFixed(item) || item.shared) {
    return undefined;
  }
  const siblings = siblingsOf(model, item);
  const other = siblings[siblings.indexOf(item) + step];
  return other?.shared ? undefined : other;
}

/** Moves an item before (-1) or after (+1) its neighbor, with the comments directly above it. */
export function reorderItem(model, item, step) {
  const other = neighborOf(model, item, step);
  const [a, b] = step < 0 ? [other, item] : [item, other];
  const [first, second] = [ownPlace(model, a), ownPlace(model, b)];
  const changes = exchanged(model.text, first, second);
  const lead = item.from - (step < 0 ? second : first).from;
  return edit(changes, step < 0 ? changes[0] : changes[1], lead);
}

// Groups.

const isGroup = ({ kind }) => kind === 'group' || kind === 'template' || kind === 'root';

/** The group that receives a new sibling of an item. */
export const groupFor = (model, item) => (item === null ? model.root : isGroup(item) ? item : (item.parent ?? model.root));

const holds = (item, other) => other !== null && (item === other || holds(item, other.parent));

// Templates that an item uses, and those that these use.
function templatesIn(model, item) {
  const found = new Set();
  const look = (at) => {
    if (at.kind === 'instance' && !found.has(at.name)) {
      found.add(at.name);
      model.templates.filter(({ name }) => name === at.name).forEach(look);
    }
    at.children.forEach(look);
  };
  look(item);
  return found;
}

/** The groups that an item can be moved to. */
export function targetsFor(model, item) {
  if (isFixed(item) || item.kind === 'template' || item.shared || (model.xml && item.kind === 'light')) {
    return [];
  }
  const used = templatesIn(model, item);
  // A template is declared before its first use.
  const first = Math.max(-1, ...[...used].map((name) => model.templates.findIndex((template) => template.name === name)));
  return model.all.filter((target) => {
    const top = topOf(target);
    const isLater = top.kind !== 'template' || model.templates.indexOf(top) > first;
    const fits = model.xml || item.kind === 'group' || item.kind === 'instance' || target.kind !== 'root';
    return isGroup(target) && target !== item.parent && !holds(item, target) && isLater && fits;
  });
}

const listOf = { light: 'lights', primitive: 'primitives', group: 'groups', instance: 'groups' };

// Appends a piece to a group.
function appended(model, group, piece, list = 'groups') {
  const { text } = model;
  if (model.xml) {
    return insertChildren(text, group.element, group.element.children.at(-1) ?? null, [piece]);
  }
  const member = memberOf(group.element, list);
  if (member?.value.type === 'array') {
    return insertEntry(text, member.value, member.value.entries.length, piece);
  }
  // A new list that contains only the piece, directly after its bracket.
  const entries = group.element.entries.length;
  const wrapped = piece.moved === undefined ? { json: [piece.json] } : { moved: `[${piece.moved}]`, indent: piece.indent };
  const change = insertEntry(text, group.element, entries, wrapped, list);
  return { ...change, select: change.insert.indexOf('{', change.insert.indexOf('[')) };
}

/** Moves an item to another group; its transforms do not change. */
export function moveInto(model, item, target) {
  const change = appended(model, target, pieceAt(model.text, item), listOf[item.kind]);
  return edit([...removalOf(model, item), change], change, change.select);
}

export const canWrap = (model, item) =>
  ['group', 'primitive', 'instance'].includes(item.kind) ? !item.shared : item.kind === 'light' && !model.xml;

/** Wraps an item in a new group, at the same place. */
export function wrapItem(model, item) {
  const { text } = model;
  const piece = pieceAt(text, item);
  if (model.xml) {
    const parent = item.block.parent;
    const index = parent.children.indexOf(item.block);
    const shell = { xml: { name: 'transblock', children: [{ name: 'object', attributes: [['type', 'tree']], children: [{ name: 'x' }] }] } };
    const change = insertChildren(text, parent, parent.children[index], [shell]);
    const lines = change.insert.slice(change.select);
    const at = lines.indexOf('<x/>');
    const indent = /[ \t]*$/.exec(lines.slice(0, at))[0];
    const moved = piece.moved.split('\n').map((line, i) => (i > 0 && line.startsWith(piece.indent) ? indent + line.slice(piece.indent.length) : line)).join('\n');
    const whole = { from: item.from, to: item.to, insert: lines.slice(0, at) + moved + lines.slice(at + 4) };
    return edit([whole], whole, 0);
  }
  if (listOf[item.kind] === 'groups') {
    const indent = piece.indent;
    const broad = piece.moved.includes('\n');
    const unit = broad ? (/\n([ \t]+)/.exec(piece.moved)?.[1].slice(indent.length) || '  ') : '';
    const deeper = broad ? piece.moved.replaceAll(`\n${indent}`, `\n${indent}${unit}${unit}`) : piece.moved;
    const insert = broad ? `{\n${indent}${unit}"groups": [\n${indent}${unit}${unit}${deeper}\n${indent}${unit}]\n${indent}}` : `{"groups": [${deeper}]}`;
    const whole = { from: item.from, to: item.to, insert };
    return edit([whole], whole, 0);
  }
  const key = listOf[item.kind];
  const shell = { moved: `{${JSON.stringify(key)}: [${piece.moved}]}`, indent: piece.indent };
  const change = appended(model, item.parent, shell);
  return edit(mergedAtPlace([...removalOf(model, item), change]), null);
}

// New items.

/** What can be added. */
export const kindsToAdd = (model) => [
  ...Object.keys(model.words.lights).map((type) => ({ kind: 'light', name: type, label: `${type[0].toUpperCase()}${type.slice(1)} light` })),
  ...model.shapes.primitive[0].values.map((name) => ({ kind: 'primitive', name, label: name[0].toUpperCase() + name.slice(1) })),
  { kind: 'group', name: '', label: 'Group' },
  ...model.templates.map(({ name }) => ({ kind: 'instance', name, label: `Instance of ${name}` })),
];

/** Adds something to the group of an item; in XML, lights are not in groups. */
export function addItem(model, near, { kind, name }) {
  const group = model.root === null ? null : groupFor(model, near);
  return model.xml ? addXml(model, group, kind, name) : addJson(model, group, kind, name);
}

function addXml(model, group, kind, name) {
  const { text, scene } = model;
  const { fields, lights } = model.words;
  const put = (parent, previous, xml) => {
    const change = insertChildren(text, parent, previous, [{ xml }]);
    return edit([change], change, change.select);
  };
  const block = (object) => ({ name: 'transblock', children: [object] });
  const { required } = lights[name] ?? {};
  const inGroup = (object) => {
    if (group !== null) {
      return put(group.element, group.element.children.at(-1) ?? null, block(object));
    }
    return put(scene, scene.children.at(-1) ?? null, { name: 'object', attributes: [['type', 'tree'], ['name', 'root']], children: [block(object)] });
  };
  switch (kind) {
    case 'light': {
      const children = fields.lightdata.filter((spec) => required.includes(spec.name)).map((spec) => {
        const values = { id: [String(freeId(model))], type: [name] }[spec.name];
        return newXmlField(spec, values);
      });
      const before = scene.children.findLast((child) => ['globaldata', 'cameradata', 'lightdata'].includes(child.name.toLowerCase()));
      return put(scene, before ?? null, { name: 'lightdata', children });
    }
    case 'primitive': {
      const mesh = name === 'mesh' ? [['filename', model.shapes.primitive.find((spec) => spec.name === 'meshFile').start]] : [];
      const diffuse = fields.primitive.find((spec) => spec.name === 'diffuse');
      return inGroup({ name: 'object', attributes: [['type', 'primitive'], ['name', name], ...mesh], children: [newXmlField(diffuse)] });
    }
    case 'group':
      return inGroup({ name: 'object', attributes: [['type', 'tree'], ['name', freeName('group', templateNames(model))]] });
    default:
      return inGroup({ name: 'object', attributes: [['type', 'master'], ['name', name]] });
  }
}

function addJson(model, group, kind, name) {
  const { fields, lights } = model.words;
  const put = (json) => {
    const change = appended(model, group, { json });
    return edit([change], change, change.select);
  };
  const some = (definition, keys) =>
    Object.fromEntries(fields[definition].filter((spec) => keys.includes(spec.name)).map((spec) => [spec.name, newJsonField(spec)]));
  switch (kind) {
    case 'light': {
      const light = { ...some('light', lights[name].required), type: name };
      const above = name === 'directional' ? {} : { translate: written([2, 5, 3]) };
      return put({ ...above, lights: [light] });
    }
    case 'primitive':
      return put({ primitives: [{ ...some('primitive', name === 'mesh' ? ['type', 'meshFile', 'diffuse'] : ['type', 'diffuse']), type: name }] });
    case 'group':
      return put({ groups: [] }); // a group with only a name would be an instance
    default:
      return put({ translate: written([0, 0, 0]), groups: [{ name }] });
  }
}
