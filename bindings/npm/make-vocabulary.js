// Writes the words of the format with their documentation, for completion and hover, from the schemas:
// node make-vocabulary.js SCHEMA_FOLDER OUTPUT.json

import { readFileSync, writeFileSync } from 'node:fs';

// The schema's own XML: as generated, so a full parser is not needed.
export function parseXml(text) {
  const top = { name: '', attributes: {}, children: [], text: '' };
  const open = [top];
  for (const [, comment, end, name, attributes, empty, words] of text.matchAll(
    /(<!--[^]*?-->|<\?[^]*?\?>)|<(\/?)([\w:.-]+)((?:\s+[\w:.-]+="[^"]*")*)\s*(\/?)>|([^<]+)/g,
  )) {
    if (comment !== undefined) {
      continue;
    }
    if (words !== undefined) {
      open.at(-1).text += words.replaceAll('&lt;', '<').replaceAll('&gt;', '>').replaceAll('&amp;', '&');
    } else if (end === '/') {
      open.pop();
    } else {
      const node = { name, attributes: {}, children: [], text: '' };
      for (const [, key, value] of attributes.matchAll(/([\w:.-]+)="([^"]*)"/g)) {
        node.attributes[key] = value;
      }
      open.at(-1).children.push(node);
      if (empty === '') {
        open.push(node);
      }
    }
  }
  return top;
}

export const unwrapped = (text) => text.replace(/\s+/g, ' ').trim();
export const documentationOf = (node) =>
  unwrapped(node.children.find((child) => child.name === 'a:documentation')?.text ?? '');

/** Elements by name: their description, content and attributes. */
export function xmlVocabulary(rng) {
  const grammar = parseXml(rng).children.find((node) => node.name === 'grammar');
  const defines = new Map(
    grammar.children.filter((node) => node.name === 'define').map((node) => [node.attributes.name, node]),
  );
  const elements = {};

  // `required`: whether the children of this node are required.
  const collect = (node, element, required) => {
    switch (node.name) {
      case 'ref':
        defines.get(node.attributes.name).children.forEach((child) => collect(child, element, required));
        break;
      case 'element':
        addElement(node);
        if (!element.children.includes(node.attributes.name)) {
          element.children.push(node.attributes.name);
        }
        break;
      case 'attribute':
        if (node.attributes.name !== undefined) {
          addAttribute(node, element, required);
        }
        break;
      case 'choice':
        node.children.forEach((child, i) => collect(child, element, required && i === 0));
        break;
      case 'optional':
      case 'zeroOrMore':
        node.children.forEach((child) => collect(child, element, false));
        break;
      default:
        node.children.forEach((child) => collect(child, element, required));
    }
  };

  const valuesBelow = (node) =>
    node.name === 'value' ? [node.text] : node.children.flatMap((child) => valuesBelow(child));

  const addAttribute = (node, element, required) => {
    const name = node.attributes.name;
    const known = (element.attributes[name] ??= { about: documentationOf(node), values: [], required });
    for (const value of valuesBelow(node)) {
      if (value !== '' && !known.values.includes(value)) {
        known.values.push(value);
      }
    }
  };

  const visited = new Set();
  const addElement = (node) => {
    if (visited.has(node)) {
      return;
    }
    visited.add(node);
    const name = node.attributes.name;
    elements[name] ??= { about: documentationOf(node), children: [], attributes: [] };
    const { children, attributes } = elements[name];
    const inThis = { children, attributes: {} };
    attributes.push(inThis.attributes);
    node.children.forEach((child) => collect(child, inThis, true));
  };

  collect({ name: 'ref', attributes: { name: 'scenefile' }, children: [] }, { children: [], attributes: {} }, true);
  for (const element of Object.values(elements)) {
    element.attributes = merged(element.attributes);
  }
  return elements;
}

// An element may be defined several times, such as a light of each type. Required is what all need.
function merged(definitions) {
  const all = {};
  for (const [name, attribute] of definitions.flatMap(Object.entries)) {
    all[name] ??= { ...attribute, required: definitions.every((some) => some[name]?.required) };
    all[name].values = [...new Set([...all[name].values, ...attribute.values])];
  }
  return all;
}

/** Objects by the name of their definition: the keys, their descriptions, and the definitions of their values. */
export function jsonVocabulary(schema) {
  const definitionOf = (value) => {
    const reference = value.$ref ?? value.allOf?.[0].$ref ?? value.items?.$ref;
    return reference?.replace('#/definitions/', '');
  };
  const shape = (value) => {
    const kind = value.type ?? schema.definitions[definitionOf(value)]?.type;
    const example = value.examples?.[0] ?? value.default ?? { object: {}, array: [] }[kind];
    return {
      about: unwrapped(value.description ?? ''),
      values: value.enum ?? [],
      in: definitionOf(value),
      example: example === undefined ? undefined : JSON.stringify(example),
    };
  };
  const objects = {};
  for (const [name, definition] of [['', schema], ...Object.entries(schema.definitions)]) {
    const parts = [definition, ...(definition.oneOf ?? []), ...(definition.anyOf ?? []), ...(definition.allOf ?? [])];
    const keys = {};
    for (const part of parts) {
      for (const [key, value] of Object.entries(part.properties ?? {})) {
        const known = (keys[key] ??= shape(value));
        known.values = [...new Set([...known.values, ...(value.enum ?? []), ...(value.const ? [value.const] : [])])];
      }
    }
    if (Object.keys(keys).length > 0) {
      objects[name] = keys;
    }
  }
  return objects;
}

const [, program, schemas, output] = process.argv;
if (program?.endsWith('make-vocabulary.js')) {
  const vocabulary = {
    xml: xmlVocabulary(readFileSync(`${schemas}/scenefile.rng`, 'utf8')),
    json: jsonVocabulary(JSON.parse(readFileSync(`${schemas}/scenefile.schema.json`, 'utf8'))),
  };
  writeFileSync(output, JSON.stringify(vocabulary));
}
