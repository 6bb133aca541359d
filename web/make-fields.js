// Makes the list of fields that the panels show, from the schemas: the name in the file, the title,
// the parts, their ranges and the start values.
//
// A field: { name, title, about, kind, parts: [{ names, about, min, max, ... }], start, ... }. A part of an XML
// field is an attribute, which may have several names. JSON fields have one number for each part, or a
// single value.

import { documentationOf, parseXml, unwrapped } from '../bindings/npm/make-vocabulary.js';

const largest = 1e30; // larger bounds only state the range of the type float

// The schemas' examples of transforms move things; a field that is not in the file must not.
const neutral = { translate: [0, 0, 0], rotate: [0, 1, 0, 0] };

const bounded = (part) =>
  Object.fromEntries(Object.entries(part).filter(([, value]) => value !== undefined && !(Math.abs(value) > largest)));

const rangeOf = ({ minimum, maximum, exclusiveMinimum, exclusiveMaximum }) =>
  bounded({ min: minimum, max: maximum, above: exclusiveMinimum, below: exclusiveMaximum });

// JSON.

function resolved(schema, value) {
  const reference = value.$ref ?? value.allOf?.[0].$ref;
  if (reference === undefined) {
    return value;
  }
  const target = reference.slice(2).split('/').reduce((at, key) => at[key], schema);
  return { ...resolved(schema, target), ...value };
}

function jsonField(schema, name, written) {
  const value = resolved(schema, written);
  const { title, description = '', examples, type } = value;
  const start = neutral[name] ?? value.default ?? examples?.[0];
  const field = { name, title, about: unwrapped(description), start };
  if (value.enum !== undefined) {
    return { ...field, kind: 'choice', values: value.enum, start: value.enum[0], parts: [{}] };
  }
  if (type === 'string') {
    return { ...field, kind: 'text', parts: [{}] };
  }
  if (type === 'number') {
    return { ...field, kind: 'number', parts: [rangeOf(value)] };
  }
  if (Array.isArray(value.items)) {
    return { ...field, kind: 'matrix', parts: Array.from({ length: 16 }, () => ({})) };
  }
  const kind = /^Red, green, blue|: red, green, blue/i.test(description) ? 'color' : 'vector';
  return { ...field, kind, parts: Array.from({ length: value.minItems }, () => rangeOf(value.items)) };
}

/** The fields by the name of their definition; `lights`: which of them each type of light requires and uses. */
export function jsonFields(schema) {
  const fields = {};
  for (const [name, definition] of Object.entries(schema.definitions)) {
    const structure = ['lights', 'primitives', 'groups'];
    const own = Object.entries(definition.properties ?? {}).filter(([key]) => !structure.includes(key));
    if (definition.type !== 'object' || own.length === 0) {
      continue;
    }
    const required = definition.required ?? [];
    const alternatives = (definition.oneOf ?? []).map(({ required: [key] }) => key);
    fields[name] = own.map(([key, value]) => ({
      ...jsonField(schema, key, value),
      required: required.includes(key) || undefined,
      instead: alternatives.includes(key) ? alternatives.find((other) => other !== key) : undefined,
      needs: definition.dependencies?.[key],
    }));
  }
  const always = ['type', 'name', 'color'];
  const lights = {};
  for (const { if: condition, then } of schema.definitions.light.allOf) {
    const required = ['type', 'color', ...then.required];
    lights[condition.properties.type.const] = { required, used: [...new Set([...always, ...required, ...Object.keys(then.properties ?? {})])] };
  }
  return { fields, lights };
}

// XML.

/** The same for XML, by element name. `json`: result of jsonFields(), for titles and start values. */
export function xmlFields(rng, json) {
  const grammar = parseXml(rng).children.find((node) => node.name === 'grammar');
  const defines = new Map(
    grammar.children.filter((node) => node.name === 'define').map((node) => [node.attributes.name, node.children]),
  );
  const isElement = (node) => node.name === 'element' && node.attributes.name !== undefined;
  // The elements, attributes and data directly in a node, and whether they are optional.
  const inside = (node, optional = false) =>
    node.children.flatMap((child) => {
      switch (child.name) {
        case 'ref':
          return inside({ children: defines.get(child.attributes.name) }, optional);
        case 'optional':
        case 'zeroOrMore':
          return inside(child, true);
        case 'element':
        case 'attribute':
        case 'data':
        case 'value':
        case 'text':
          return [{ node: child, optional }];
        case 'choice':
          return inside(child, true);
        default:
          return inside(child, optional);
      }
    });
  const elementsOf = (node) => inside(node).filter((child) => isElement(child.node));
  // The sets of attributes that an element can have.
  const formsOf = (node) => {
    const content = node.children.flatMap((child) => (child.name === 'ref' ? defines.get(child.attributes.name) : [child]));
    const choice = content.find(({ name }) => name === 'choice');
    const forms = choice && !choice.children.some(isElement) ? choice.children.map((form) => inside(form)) : [inside(node)];
    return forms.map((form) => form.filter((child) => child.node.name === 'attribute' && child.node.attributes.name !== undefined));
  };
  const partOf = ({ node, optional }) => {
    const found = inside(node).map((child) => child.node);
    if (found.every(({ name }) => name === 'text')) {
      return null; // an attribute without effect
    }
    const params = {};
    for (const { name, children } of found) {
      if (name === 'data') {
        children.forEach((param) => (params[param.attributes.name] = Number(param.text)));
      }
    }
    const { minInclusive: min, maxInclusive: max, minExclusive: above, maxExclusive: below } = params;
    const isText = found.some(({ name, attributes }) => name === 'data' && attributes.type !== 'double');
    const values = found.filter(({ name }) => name === 'value').map(({ text }) => text);
    return {
      names: [node.attributes.name],
      about: documentationOf(node),
      ...bounded({ min, max, above, below }),
      text: isText || undefined,
      values: values.length > 0 ? values : undefined,
      optional: optional || undefined,
    };
  };
  const partsOf = (node) => {
    const [first, ...others] = formsOf(node).map((form) => form.map(partOf).filter((part) => part !== null));
    others.forEach((form) => form.forEach((part, i) => first[i].names.push(...part.names)));
    return first;
  };

  const otherName = { pos: 'position', function: 'attenuationCoeff', texture: 'textureFile', bumpmap: 'bumpMapFile' };
  const inJson = (name, definition) =>
    json.fields[definition].find((field) => field.name.toLowerCase() === (otherName[name] ?? name).toLowerCase());
  const kindOf = (parts) => {
    const names = parts.map((part) => part.names[0]).join(' ');
    return { 'r g b': 'color', 'file u v': 'image' }[names] ?? (parts[0].values ? 'choice' : parts.length > 1 ? 'vector' : 'number');
  };
  const field = ({ node, optional }, definition) => {
    const { name } = node.attributes;
    const parts = name === 'object' ? [] : partsOf(node);
    if (parts.length === 0) {
      return null;
    }
    const same = inJson(name, definition);
    const start = [same?.start ?? 1].flat(2).map(String);
    const kind = kindOf(parts);
    return {
      name,
      title: same?.title ?? name[0].toUpperCase() + name.slice(1),
      about: documentationOf(node),
      kind,
      parts,
      values: parts[0].values,
      start: kind === 'image' ? [start[0], '1', '1'] : parts.map((_, i) => start[i] ?? start[0]),
      required: optional ? undefined : true,
      instead: same?.instead,
      needs: same?.needs,
    };
  };
  const definitions = [...defines.values()].flat().filter(isElement);
  const named = (name) => definitions.filter((node) => node.attributes.name === name);
  const fieldsIn = (nodes, definition) => {
    const all = new Map();
    for (const child of nodes.flatMap(elementsOf)) {
      const found = field(child, definition);
      if (found === null) {
        continue;
      }
      const known = all.get(found.name);
      all.set(found.name, known ?? found);
      if (known?.values) {
        known.values = [...new Set([...known.values, ...found.values])];
      }
    }
    return [...all.values()];
  };

  const lights = {};
  for (const light of named('lightdata')) {
    const children = elementsOf(light);
    const type = children.find(({ node }) => node.attributes.name === 'type');
    const names = (some) => some.map(({ node }) => node.attributes.name);
    lights[partsOf(type.node)[0].values[0]] = {
      required: [...new Set([...names(children.filter(({ optional }) => !optional)), 'id', 'type'])],
      used: names(children),
    };
  }
  const fields = {
    globaldata: fieldsIn(named('globaldata'), 'globalData'),
    cameradata: fieldsIn(named('cameradata'), 'cameraData'),
    lightdata: fieldsIn(named('lightdata'), 'light'),
    primitive: fieldsIn(named('object').filter((node) => elementsOf(node).some((child) => child.node.attributes.name === 'diffuse')), 'primitive'),
    transblock: fieldsIn(named('transblock'), 'group'),
  };
  // The type comes first, because it determines which other fields apply. In JSON, the position of
  // a light is that of its group.
  const place = fields.lightdata.find(({ name }) => name === 'position');
  place.start = ['2', '5', '3'];
  fields.lightdata.find(({ name }) => name === 'id').start = ['0'];
  fields.lightdata.sort((a, b) => (b.name === 'type') - (a.name === 'type'));
  const row = definitions.find((node) => node.attributes.name === 'row') ?? elementsOf(named('matrix')[0])[0].node;
  fields.transblock.push({ ...inJson('matrix', 'group'), name: 'matrix', about: documentationOf(named('matrix')[0]), kind: 'matrix', parts: [], row: partsOf(row) });
  return { fields, lights };
}

export function fieldsOf(rng, schema) {
  const json = jsonFields(schema);
  return { json, xml: xmlFields(rng, json) };
}
