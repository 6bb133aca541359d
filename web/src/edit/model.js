// The content of a scene's text, as the panels show it: global data, camera, lights and the tree of
// objects, each with its offsets and its fields. Accepts at least what the format's readers accept,
// because it only needs to know where values are; reporting errors is the checker's task.

import { isXml } from '../../../bindings/npm/lib/words.js';
import { memberOf, parseJson, parseXml, textOfValue } from './text.js';

// Other names of elements that readers accept.
const aliases = { heightangle: 'angle', id: 'number', reflective: 'reflect', shininess: 'shine' };
const transforms = ['translate', 'rotate', 'scale', 'matrix'];

const called = (name) => (element) => element.name.toLowerCase() === name;
const attributeOf = (element, name) =>
  element.attributes.find((attribute) => attribute.name === name) ??
  element.attributes.find((attribute) => attribute.name.toLowerCase() === name);
const wordOf = (element, name) => attributeOf(element, name)?.value ?? '';

/**
 * The model of a text. `words`: the result of fieldsOf() in make-fields.js. Items: { kind, label,
 * from, to, children, parent }, in XML with `element`, whose fields they have, and the `block` that
 * places them; in JSON with `element`, the object, and the `list` that it is in.
 */
export function modelOf(text, words) {
  const xml = text.trim() === '' || isXml(text);
  const model = { text, xml, words: xml ? words.xml : words.json, shapes: words.json.fields, items: [], lights: [], templates: [], all: [], root: null, problem: -1 };
  (xml ? readXml : readJson)(model);
  model.items.forEach((item, i) => collect(model, item, i));
  return model;
}

// All items in the order of the text; `path`: where each is in the tree.
function collect(model, item, index) {
  item.path = `/${index}`;
  const open = [item];
  while (open.length > 0) {
    const next = open.pop();
    model.all.push(next);
    for (let i = next.children.length - 1; i >= 0; --i) {
      next.children[i].path = `${next.path}/${i}`;
      open.push(next.children[i]);
    }
  }
}

function itemOf(kind, label, place, rest) {
  return { kind, label, from: place?.from ?? -1, to: place?.to ?? -1, children: [], parent: null, block: null, list: null, ...rest };
}

function readXml(model) {
  const { top, problem } = parseXml(model.text);
  model.problem = problem;
  const scene = top.children[0];
  if (scene === undefined) {
    model.problem = Math.max(problem, 0);
    return;
  }
  model.scene = scene;
  const last = (name) => scene.children.findLast(called(name));
  const add = (item) => model.items.push(item);
  for (const [kind, label, name] of [['globals', 'Global data', 'globaldata'], ['camera', 'Camera', 'cameradata']]) {
    add(itemOf(kind, label, last(name), { element: last(name) ?? null, fields: name }));
  }
  for (const element of scene.children.filter(called('lightdata'))) {
    const type = element.children.findLast(called('type'));
    const item = itemOf('light', '', element, { element, fields: 'lightdata', type: ((type && type.attributes[0]?.value) || wordOf(element, 'type') || 'point').toLowerCase() });
    item.label = `${item.type} light`;
    model.lights.push(item);
    add(item);
  }
  const trees = scene.children.filter(called('object'));
  const names = new Set(trees.map((element) => wordOf(element, 'name')).filter((name) => name !== 'root' && name !== ''));
  for (const element of trees) {
    const name = wordOf(element, 'name');
    const isRoot = name === 'root';
    const item = itemOf(isRoot ? 'root' : 'template', isRoot ? 'Scene' : name, element, { element, name });
    (isRoot ? (model.root = item) : model.templates.push(item)) && add(item);
    readXmlTree(item, names);
  }
}

function readXmlTree(tree, names) {
  const open = [tree];
  while (open.length > 0) {
    const item = open.pop();
    for (const block of item.element.children.filter(called('transblock'))) {
      const objects = block.children.filter(called('object'));
      objects.forEach((element, i) => {
        const type = wordOf(element, 'type').toLowerCase();
        const name = wordOf(element, 'name');
        const isTree = type === 'tree' && (element.children.length > 0 || !names.has(name));
        const kind = type === 'primitive' ? 'primitive' : isTree ? 'group' : 'instance';
        const place = objects.length === 1 ? block : element;
        const below = itemOf(kind, name || 'group', place, { element, name, parent: item, block: i === 0 ? block : null, shared: objects.length > 1 });
        item.children.push(below);
        if (kind === 'group') {
          open.push(below);
        }
      });
    }
  }
}

function readJson(model) {
  const { top, problem } = parseJson(model.text);
  model.problem = top?.type === 'object' ? problem : Math.max(problem, 0);
  if (model.problem >= 0) {
    return;
  }
  model.scene = top;
  const { text } = model;
  const entriesOf = (object, key) => {
    const value = memberOf(object, key)?.value;
    return value?.type === 'array' ? value.entries.filter(({ type }) => type === 'object') : [];
  };
  const wordIn = (object, key) => {
    const value = memberOf(object, key)?.value;
    return value?.type === 'string' ? textOfValue(text, value) : '';
  };
  for (const [kind, label, key] of [['globals', 'Global data', 'globalData'], ['camera', 'Camera', 'cameraData']]) {
    const value = memberOf(top, key)?.value;
    const element = value?.type === 'object' ? value : null;
    model.items.push(itemOf(kind, label, element, { element, fields: key }));
  }
  const templates = entriesOf(top, 'templateGroups');
  const names = new Set(templates.map((object) => wordIn(object, 'name')).filter((name) => name !== ''));
  const open = [];
  const listed = (object, kind, label, rest) => itemOf(kind, label, object, { element: object, list: object.parent, ...rest });
  for (const object of templates) {
    const name = wordIn(object, 'name');
    const item = listed(object, 'template', name, { fields: 'templateGroup', name });
    model.templates.push(item);
    model.items.push(item);
    open.push(item);
  }
  const root = itemOf('root', 'Scene', memberOf(top, 'groups')?.value ?? top, { element: top });
  model.root = root;
  model.items.push(root);
  open.push(root);
  while (open.length > 0) {
    const item = open.pop();
    const add = (object, kind, label, rest) => item.children.push(listed(object, kind, label, { parent: item, ...rest }));
    if (item !== root) {
      for (const object of entriesOf(item.element, 'lights')) {
        const type = wordIn(object, 'type');
        add(object, 'light', `${wordIn(object, 'name') || type} light`, { fields: 'light', type });
        model.lights.push(item.children.at(-1));
      }
      for (const object of entriesOf(item.element, 'primitives')) {
        add(object, 'primitive', wordIn(object, 'type'), { fields: 'primitive', name: wordIn(object, 'type') });
      }
    }
    for (const object of entriesOf(item.element, 'groups')) {
      const name = wordIn(object, 'name');
      const isInstance = names.has(name);
      add(object, isInstance ? 'instance' : 'group', name || 'group', { fields: 'group', name });
      if (!isInstance) {
        open.push(item.children.at(-1));
      }
    }
  }
}

/** The innermost item at an offset of the text; null if there is none. */
export function itemAt(model, offset) {
  let found = null;
  for (const item of model.all) {
    if (item.from <= offset && offset < item.to && (found === null || item.to - item.from <= found.to - found.from)) {
      found = item;
    }
  }
  return found;
}

/** The template that an item is in, or the scene. */
export const topOf = (item) => (item.parent === null ? item : topOf(item.parent));

// A template is declared before its first use.
function templatesFor(model, item) {
  const at = model.templates.indexOf(topOf(item));
  return (at < 0 ? model.templates : model.templates.slice(0, at)).map(({ name }) => name);
}

const withOwn = (spec, name, more = {}) => ({ ...spec, name, parts: [{ names: [name], text: spec.kind === 'text' }], ...more });

/**
 * The fields of an item: { spec, item, element, own, values, movable }. `values`: one text for each part, null where the file
 * does not give it; `element`: where they are, null if the field is not in the file.
 */
export function fieldsOfItem(model, item) {
  return model.xml ? xmlFieldsOf(model, item) : jsonFieldsOf(model, item);
}

/** Whether a field has an effect on its light, and whether the light needs it. */
function usesOf(model, item, name) {
  const uses = item.kind === 'light' ? model.words.lights[item.type] : undefined;
  return uses === undefined ? {} : { unused: !uses.used.includes(name), required: uses.required.includes(name) };
}

/** The attributes of the parts, found by name, otherwise by order. */
export function xmlParts(element, parts) {
  const byName = parts.map(({ names }) => element.attributes.find(({ name }) => names.includes(name)));
  const others = element.attributes.filter((attribute) => !byName.includes(attribute));
  const missing = byName.filter((part) => part === undefined).length;
  return others.length === missing && element.attributes.length === parts.length ? byName.map((part) => part ?? others.shift()) : byName;
}

function xmlFieldsOf(model, item) {
  const { fields } = model.words;
  const inXml = (spec) => {
    const names = [spec.name, aliases[spec.name]];
    const element = item.element?.children.findLast(({ name }) => names.includes(name.toLowerCase())) ?? null;
    const uses = usesOf(model, item, spec.name);
    const values = element === null ? spec.parts.map(() => null) : xmlParts(element, spec.parts).map((part) => part?.value ?? null);
    return { spec, item, element, values, ...uses };
  };
  const own = (spec, name, more) => {
    const attribute = attributeOf(item.element, name);
    return { spec: withOwn(spec, name, more), item, element: attribute === undefined ? null : item.element, own: true, values: [attribute?.value ?? null] };
  };
  const [group, primitive] = [model.shapes.group, model.shapes.primitive];
  const nameOf = (more) => own(group.find(({ name }) => name === 'name'), 'name', more);
  const placing = (item.block?.children ?? []).filter((child) => transforms.includes(child.name.toLowerCase())).map((element) => {
    const spec = fields.transblock.find(({ name }) => name === element.name.toLowerCase());
    const values =
      spec.kind === 'matrix'
        ? element.children.flatMap((row) => xmlParts(row, spec.row).map((part) => part?.value ?? null))
        : xmlParts(element, spec.parts).map((part) => part?.value ?? null);
    return { spec, item, element, values, movable: true };
  });
  switch (item.kind) {
    case 'globals':
    case 'camera':
    case 'light':
      return fields[item.fields].map(inXml).filter(({ unused, element }) => !unused || element !== null);
    case 'root':
      return [];
    case 'template':
      return [nameOf({ about: 'The name that instances refer to; unique among templates.', required: true })];
    case 'group':
      return [nameOf(), ...placing];
    case 'instance':
      return [nameOf({ kind: 'choice', title: 'Template', values: templatesFor(model, item), required: true }), ...placing];
    case 'primitive': {
      const shape = own(primitive.find(({ name }) => name === 'type'), 'name');
      const file = primitive.find(({ name }) => name === 'meshFile');
      const key = attributeOf(item.element, 'meshfile') && !attributeOf(item.element, 'filename') ? 'meshfile' : 'filename';
      const mesh = attributeOf(item.element, key) || item.name === 'mesh' ? [own(file, key, { required: item.name === 'mesh' })] : [];
      return [shape, ...mesh, ...placing, ...fields.primitive.map(inXml)];
    }
  }
  return [];
}

function jsonFieldsOf(model, item) {
  if (item.kind === 'root') {
    return [];
  }
  const { text } = model;
  const inJson = (spec) => {
    const member = memberOf(item.element, spec.name);
    const value = member?.value;
    const uses = usesOf(model, item, spec.name);
    let values = spec.parts.map(() => null);
    if (value !== undefined) {
      const parts = value.type === 'array' ? value.entries.flatMap((entry) => (entry.type === 'array' ? entry.entries : [entry])) : [value];
      values = spec.parts.map((_, i) => (parts[i] === undefined ? null : textOfValue(text, parts[i])));
    }
    return { spec, item, element: member ?? null, values, ...uses };
  };
  const specs = model.words.fields[item.fields];
  if (item.kind === 'instance') {
    const name = specs.find((spec) => spec.name === 'name');
    const others = specs.filter((spec) => spec !== name).map(inJson).filter(({ element }) => element !== null);
    return [inJson({ ...name, kind: 'choice', title: 'Template', values: templatesFor(model, item), required: true }), ...others];
  }
  // Only meshes have a file.
  return specs
    .map(inJson)
    .filter(({ spec, unused, element }) => element !== null || (!unused && (spec.name !== 'meshFile' || item.name === 'mesh')));
}
