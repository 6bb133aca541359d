// Completion and hover: what can be written at a place of a scene file, and what a word there
// means, for the language server and the page. Works on text that is being typed, so it never needs
// a whole file. `vocabulary` is vocabulary.json, which is made from the schemas.

/** XML begins with <, JSON does not. */
export function isXml(text) {
  return text.trimStart().startsWith('<');
}

/** Whether the text contains a name of the scene format, unlike XML and JSON files of other programs. */
export function mayBeScene(text) {
  return isXml(text)
    ? /<(?:scenefile|globaldata|cameradata|lightdata|transblock)\b/i.test(text)
    : /"(?:globalData|cameraData|groups|templateGroups)"/.test(text);
}

const skipped = [
  ['<!--', '-->'],
  ['<?', '?>'],
  ['<![CDATA[', ']]>'],
  ['<!', '>'],
];

// The context of `offset`: the enclosing elements, and the tag that contains it, if any.
function xmlContext(text, offset) {
  const open = [];
  let at = 0;
  for (;;) {
    at = text.indexOf('<', at);
    if (at < 0 || at >= offset) {
      return { open, tag: null };
    }
    const other = skipped.find(([start]) => text.startsWith(start, at));
    if (other !== undefined) {
      const end = text.indexOf(other[1], at + other[0].length);
      if (end < 0 || end + other[1].length > offset) {
        return null; // in a comment
      }
      at = end + other[1].length;
      continue;
    }
    const tag = { start: at, closing: text[at + 1] === '/', quote: '', attributes: [], value: -1 };
    tag.nameStart = at + (tag.closing ? 2 : 1);
    let i = tag.nameStart;
    while (i < text.length && /[\w:.-]/.test(text[i])) {
      ++i;
    }
    tag.name = text.slice(tag.nameStart, i);
    tag.nameEnd = i;
    let word = '';
    for (; i < text.length; ++i) {
      const c = text[i];
      if (i >= offset || (c === '<' && tag.quote === '')) {
        break;
      }
      if (tag.quote !== '') {
        if (c === tag.quote) {
          tag.quote = '';
        }
      } else if (c === '"' || c === "'") {
        tag.quote = c;
        tag.value = i + 1;
      } else if (c === '>') {
        break;
      } else if (/[\w:.-]/.test(c)) {
        word = /[\w:.-]/.test(text[i - 1]) && i > tag.nameEnd ? word + c : c;
      } else if (c === '=') {
        tag.attributes.push(word);
      }
    }
    if (i >= offset || text[i] !== '>') {
      if (i >= offset) {
        return { open, tag };
      }
      at = i; // a tag that was never closed
      continue;
    }
    if (tag.closing) {
      const last = open.lastIndexOf(tag.name);
      open.length = last < 0 ? open.length : last;
    } else if (text[i - 1] !== '/') {
      open.push(tag.name);
    }
    at = i + 1;
  }
}

function insertedTag(name, element) {
  const required = Object.entries(element.attributes).filter(([, attribute]) => attribute.required);
  const words = required.map(([key]) => ` ${key}=""`).join('');
  const container = element.children.length > 0 && name !== 'object';
  return container ? `${name}${words}></${name}>` : `${name}${words}/>`;
}

const sorted = (names) => [...new Set(names)];

function completeXml(text, offset, vocabulary) {
  const context = xmlContext(text, offset);
  if (context === null) {
    return null;
  }
  const { open, tag } = context;
  const words = vocabulary.xml;
  const parent = open.at(-1);
  if (tag === null) {
    return null;
  }
  if (tag.closing) {
    return parent === undefined
      ? null
      : { from: tag.nameStart, items: [{ label: parent, kind: 'element', about: '', insert: `${parent}>` }] };
  }
  if (offset <= tag.nameEnd) {
    const names = parent === undefined ? ['scenefile'] : (words[parent]?.children ?? []);
    const items = sorted(names).map((name) => ({
      label: name,
      kind: 'element',
      about: words[name].about,
      insert: insertedTag(name, words[name]),
    }));
    if (parent !== undefined && tag.nameStart === offset) {
      items.push({ label: `/${parent}`, kind: 'element', about: '', insert: `/${parent}>` });
    }
    return { from: tag.nameStart, items };
  }
  const element = words[tag.name];
  if (element === undefined) {
    return null;
  }
  if (tag.quote !== '') {
    const values = element.attributes[tag.attributes.at(-1)]?.values ?? [];
    const items = values.map((value) => ({ label: value, kind: 'value', about: '', insert: value }));
    return items.length === 0 ? null : { from: tag.value, items };
  }
  const before = /[\w:.-]*$/.exec(text.slice(tag.nameEnd, offset))[0];
  const items = Object.entries(element.attributes)
    .filter(([name]) => !tag.attributes.includes(name))
    .map(([name, { about }]) => ({ label: name, kind: 'attribute', about, insert: `${name}=""` }));
  return { from: offset - before.length, items };
}

// The definitions around `offset`, and whether a key or a value is written there.
function jsonContext(text, offset, vocabulary) {
  const stack = [{ kind: 'top', definition: '', key: null, wantsKey: false }];
  let string = null;
  for (let i = 0; i < offset; ++i) {
    const c = text[i];
    const here = stack.at(-1);
    if (string !== null) {
      if (c === '\\') {
        ++i;
      } else if (c === '"') {
        if (here.kind === 'object' && here.wantsKey) {
          here.key = text.slice(string + 1, i);
          here.keys.push(here.key);
        }
        string = null;
      }
      continue;
    }
    if (c === '"') {
      string = i;
    } else if (c === ':') {
      here.wantsKey = false;
    } else if (c === ',') {
      here.wantsKey = here.kind === 'object';
    } else if (c === '{' || c === '[') {
      const below =
        here.kind === 'object' ? vocabulary.json[here.definition]?.[here.key]?.in : here.definition;
      stack.push({ kind: c === '{' ? 'object' : 'array', definition: below, key: null, keys: [], wantsKey: c === '{' });
    } else if ((c === '}' || c === ']') && stack.length > 1) {
      stack.pop();
    }
  }
  return { here: stack.at(-1), string };
}

function completeJson(text, offset, vocabulary) {
  const { here, string } = jsonContext(text, offset, vocabulary);
  const keys = vocabulary.json[here.definition];
  if (here.kind !== 'object' || keys === undefined) {
    return null;
  }
  const from = string === null ? offset - /\w*$/.exec(text.slice(0, offset))[0].length : string;
  const closing = string !== null && text[offset] === '"' ? 1 : 0;
  if (here.wantsKey) {
    const items = Object.entries(keys)
      .filter(([key]) => !here.keys.includes(key))
      .map(([key, { about, example }]) => ({
        label: `"${key}"`,
        kind: 'attribute',
        about,
        insert: text.slice(offset + closing).trimStart().startsWith(':')
          ? `"${key}"`
          : `"${key}": ${example ?? ''}`,
      }));
    return { from, to: offset + closing, items };
  }
  const values = keys[here.key]?.values ?? [];
  const items = values.map((value) => ({
    label: JSON.stringify(value),
    kind: 'value',
    about: '',
    insert: JSON.stringify(value),
  }));
  return items.length === 0 ? null : { from, to: offset + closing, items };
}

/**
 * What can be written at `offset`: `from` and `to` of the word that it replaces, and the words,
 * each with its kind (`kind`), description (`about`) and text (`insert`). Null if nothing is known
 * there.
 */
export function complete(text, offset, vocabulary) {
  const found = text.trim() === '' || isXml(text) ? completeXml(text, offset, vocabulary) : completeJson(text, offset, vocabulary);
  return found === null || found.items.length === 0 ? null : { to: offset, ...found };
}

/** What the name at `offset` means: its range and a sentence. Null if it is not a name of the format. */
export function describe(text, offset, vocabulary) {
  const word = /[\w:.-]/;
  let from = offset;
  let to = offset;
  while (from > 0 && word.test(text[from - 1])) {
    --from;
  }
  while (to < text.length && word.test(text[to])) {
    ++to;
  }
  const name = text.slice(from, to);
  const found = isXml(text) ? aboutXml(text, from, name, vocabulary) : aboutJson(text, from, to, name, vocabulary);
  return name === '' || !found ? null : { from, to, name, about: found };
}

function aboutXml(text, from, name, vocabulary) {
  const context = xmlContext(text, from);
  const tag = context?.tag;
  if (!tag || tag.quote !== '') {
    return null;
  }
  return from === tag.nameStart ? vocabulary.xml[name]?.about : vocabulary.xml[tag.name]?.attributes[name]?.about;
}

function aboutJson(text, from, to, name, vocabulary) {
  if (text[from - 1] !== '"' || !/^"\s*:/.test(text.slice(to, to + 20))) {
    return null;
  }
  const { here } = jsonContext(text, from - 1, vocabulary);
  return vocabulary.json[here.definition]?.[name]?.about;
}

/**
 * The correction that a finding proposes: `title`, and `changes` with the places to replace. Null if
 * it proposes none.
 */
export function correct(text, { correction }) {
  if (!correction?.changes) {
    return null;
  }
  const { written, instead, changes } = correction;
  return {
    title: instead === '' ? `Remove ${written}` : `Change ${written} to ${changes[0].text}`,
    changes: changes.map((change) => ({
      from: offsetOf(text, change.line, change.column),
      to: offsetOf(text, change.end_line, change.end_column),
      insert: change.text,
    })),
  };
}

/** The offset of a finding: lines count from 1, columns from 1 in code points. */
export function offsetOf(text, line, column) {
  let at = 0;
  for (let n = 1; n < (line ?? 1); ++n) {
    const next = /\r\n|\r|\n/g;
    next.lastIndex = at;
    const found = next.exec(text);
    if (found === null) {
      break;
    }
    at = next.lastIndex;
  }
  for (let n = 1; n < (column ?? 1) && at < text.length && text[at] !== '\n' && text[at] !== '\r'; ++n) {
    at += text.codePointAt(at) > 0xffff ? 2 : 1;
  }
  return at;
}

/** The end of the name or value at `offset`. */
export function wordEnd(text, offset) {
  const word = /^<?\/?[\w.:-]+|^"[^"\n]*"?|^\S/.exec(text.slice(offset, offset + 400));
  return offset + (word?.[0].length ?? 0);
}

// Declarations of templates: `<object type="tree" name="X">`, or a template group in JSON.
function* templatesOf(text, vocabulary) {
  if (isXml(text)) {
    for (const found of text.matchAll(/<object\b(?:[^<>"']|"[^"]*"|'[^']*')*>/g)) {
      const name = /\bname\s*=\s*(["'])(.*?)\1/.exec(found[0]);
      if (name !== null && /\btype\s*=\s*["']tree["']/.test(found[0])) {
        const from = found.index + name.index + name[0].indexOf(name[1]) + 1;
        yield { name: name[2], from, to: from + name[2].length };
      }
    }
    return;
  }
  for (const found of text.matchAll(/"name"\s*:\s*"((?:[^"\\]|\\.)*)"/g)) {
    if (jsonContext(text, found.index, vocabulary).here.definition === 'templateGroup') {
      const to = found.index + found[0].length - 1;
      yield { name: found[1], from: to - found[1].length, to };
    }
  }
}

/** Where the template is declared whose name is at `offset`; null if there is none. */
export function declarationOf(text, offset, vocabulary) {
  const from = Math.max(text.lastIndexOf('"', offset - 1), text.lastIndexOf("'", offset - 1)) + 1;
  const rest = /^[^"'\r\n]*/.exec(text.slice(from))[0];
  if (from === 0 || from + rest.length < offset || rest === '') {
    return null;
  }
  for (const template of templatesOf(text, vocabulary)) {
    if (template.name === rest) {
      return template;
    }
  }
  return null;
}
