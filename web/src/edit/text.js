// Parses a scene's text with the offsets of everything, and makes pieces of text that follow the
// layout around the place of insertion. An edit is a list of changes { from, to, insert }:
// everything else in the text, such as comments, stays as it is.

// XML.

const spans = [
  ['<!--', '-->'],
  ['<![CDATA[', ']]>'],
  ['<?', '?>'],
  ['<!', '>'],
];

/**
 * The elements of the text: { name, from, to, tagEnd, closeFrom, empty, attributes, children,
 * parent }; `problem`: where the text is not well-formed, or -1; `comments`: the ranges of
 * comments, CDATA sections and the like.
 */
export function parseXml(text) {
  const top = { name: '', from: 0, to: text.length, tagEnd: 0, closeFrom: text.length, empty: false, attributes: [], children: [], parent: null };
  const comments = [];
  let problem = -1;
  const broken = (at) => (problem = problem < 0 ? at : problem);
  let open = top;
  let at = 0;
  const tag = /<(\/?)([^\s<>/="']+)/y;
  const attribute = /\s*([^\s<>/="']+)\s*=\s*("[^"<]*"|'[^'<]*')/y;
  const end = /\s*(\/?)>/y;
  while ((at = text.indexOf('<', at)) >= 0) {
    const span = spans.find(([start]) => text.startsWith(start, at));
    if (span !== undefined) {
      const close = text.indexOf(span[1], at + span[0].length);
      if (close < 0) {
        broken(at);
        break;
      }
      comments.push({ from: at, to: close + span[1].length });
      at = close + span[1].length;
      continue;
    }
    tag.lastIndex = at;
    const start = tag.exec(text);
    if (start === null) {
      broken(at);
      at += 1;
      continue;
    }
    const element = { name: start[2], from: at, to: -1, tagEnd: -1, closeFrom: -1, empty: false, nameEnd: tag.lastIndex, attributes: [], children: [], parent: open };
    let next = tag.lastIndex;
    for (;;) {
      attribute.lastIndex = next;
      const found = attribute.exec(text);
      if (found === null) {
        break;
      }
      next = attribute.lastIndex;
      const from = next - found[0].trimStart().length;
      element.attributes.push({ name: found[1], from, to: next, valueFrom: next - found[2].length + 1, valueTo: next - 1, value: unescapedXml(found[2].slice(1, -1)) });
    }
    end.lastIndex = next;
    const close = end.exec(text);
    if (close === null) {
      broken(next);
      at = next;
      continue;
    }
    at = end.lastIndex;
    if (start[1] === '/') {
      if (open.name !== element.name || open === top) {
        broken(element.from);
        continue;
      }
      open.closeFrom = element.from;
      open.to = at;
      open = open.parent;
      continue;
    }
    open.children.push(element);
    element.tagEnd = at;
    if (close[1] === '/') {
      element.empty = true;
      element.to = at;
    } else {
      open = element;
    }
  }
  for (; open !== top; open = open.parent) {
    broken(open.from);
    open.to = text.length;
    open.closeFrom = text.length;
  }
  return { top, comments, problem };
}

const entities = { amp: '&', lt: '<', gt: '>', quot: '"', apos: "'" };

function unescapedXml(text) {
  return text.replace(/&(#x[\da-f]+|#\d+|\w+);/gi, (whole, name) => {
    if (name[0] !== '#') {
      return entities[name] ?? whole;
    }
    const code = Number(name[1] === 'x' || name[1] === 'X' ? `0${name.slice(1)}` : name.slice(1));
    return code <= 0x10ffff ? String.fromCodePoint(code) : whole;
  });
}

const escapedXml = (text) =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;').replaceAll("'", '&apos;');

// JSON.

const deepest = 1100; // more than the reader accepts

/**
 * The values of the text: { type, from, to, entries, parent }. Entries of an array are values, entries of an
 * object { key, from, keyTo, to, value }. `problem`: where the text is not JSON, or -1.
 */
export function parseJson(text) {
  const token = /[\s\ufeff]*(?:([[\]{},:])|("(?:[^"\\\n]|\\.)*")|(-?\d[\d.eE+-]*|true|false|null))/y;
  let at = 0;
  const fail = () => {
    throw { problem: at };
  };
  const next = () => {
    token.lastIndex = at;
    const found = token.exec(text);
    if (found === null) {
      fail();
    }
    at = token.lastIndex;
    return found[1] ?? found[2] ?? found[3];
  };
  const peek = (mark) => {
    const before = at;
    const same = next() === mark;
    at = same ? at : before;
    return same;
  };
  const value = (parent, depth) => {
    const word = next();
    const node = { type: 'number', from: at - word.length, to: at, entries: [], parent };
    if (depth > deepest) {
      fail();
    }
    if (word === '{' || word === '[') {
      const isObject = word === '{';
      node.type = isObject ? 'object' : 'array';
      const close = isObject ? '}' : ']';
      if (!peek(close)) {
        do {
          if (isObject) {
            const key = next();
            const from = at - key.length;
            const keyTo = at;
            if (key[0] !== '"' || !peek(':')) {
              fail();
            }
            const below = value(node, depth + 1);
            node.entries.push({ key: stringOf(key), from, keyTo, to: below.to, value: below });
          } else {
            node.entries.push(value(node, depth + 1));
          }
        } while (peek(','));
        if (!peek(close)) {
          fail();
        }
      }
    } else if (word[0] === '"') {
      node.type = 'string';
    } else if (/^[tfn]/.test(word)) {
      node.type = 'word';
    } else if (/^[,:\]}]/.test(word)) {
      fail();
    }
    node.to = at;
    return node;
  };
  try {
    const top = value(null, 0);
    if (text.slice(at).trim() !== '') {
      fail();
    }
    return { top, problem: -1 };
  } catch (error) {
    if (error.problem === undefined) {
      throw error;
    }
    return { top: null, problem: error.problem };
  }
}

function stringOf(text) {
  try {
    return JSON.parse(text);
  } catch {
    return text.slice(1, -1);
  }
}

/** The entry of a key; undefined if there is none, and the last one if there are several. */
export const memberOf = (object, key) =>
  object?.type === 'object' ? object.entries.findLast((entry) => entry.key === key) : undefined;

/** The content of a string; any other value as written. */
export const textOfValue = (text, value) =>
  value.type === 'string' ? stringOf(text.slice(value.from, value.to)) : text.slice(value.from, value.to);

// Layout.

const lineStart = (text, at) => text.lastIndexOf('\n', at - 1) + 1;
const blanksAt = (text, at) => /^[ \t]*/.exec(text.slice(at, at + 400))[0];
const indentAt = (text, at) => blanksAt(text, lineStart(text, at));
const startsLine = (text, at) => text.slice(lineStart(text, at), at).trim() === '';

/** The end of the line at `at` if only spaces and comments follow, otherwise `at`. */
function afterRemarks(text, at) {
  const rest = /^(?:[ \t]*<!--(?:(?!-->)[^\n])*-->)*[ \t]*(?=\r?\n|$)/.exec(text.slice(at, at + 2000));
  return rest === null ? at : at + rest[0].trimEnd().length;
}

function unitOf(text) {
  let before = 0;
  for (const [blanks] of text.slice(0, 20_000).matchAll(/^[ \t]*(?=\S)/gm)) {
    if (blanks.length > before) {
      return blanks.slice(before);
    }
    before = blanks.length;
  }
  return '  ';
}

/** `child`: { name, attributes: [[name, value]], children }. Its text without the indentation of its first line. */
function xmlText({ name, attributes = [], children = [] }, indent, unit, broad) {
  const words = attributes.map(([key, value]) => ` ${key}="${escapedXml(value)}"`).join('');
  if (children.length === 0) {
    return `<${name}${words}/>`;
  }
  const below = children.map((child) => (broad ? `\n${indent}${unit}` : '') + xmlText(child, indent + unit, unit, broad));
  return `<${name}${words}>${below.join('')}${broad ? `\n${indent}` : ''}</${name}>`;
}

/** Numbers are passed as text, so that they are written unchanged. */
export class Written {
  constructor(text) {
    this.text = text;
  }
}

function jsonText(value, indent, unit, broad) {
  if (value instanceof Written) {
    return value.text;
  }
  if (Array.isArray(value)) {
    const parts = value.map((part) => jsonText(part, indent + unit, unit, broad));
    return broad && value.some((part) => !Array.isArray(part) && !(part instanceof Written) && typeof part === 'object')
      ? `[${parts.map((part) => `\n${indent}${unit}${part}`).join(',')}\n${indent}]`
      : `[${parts.join(', ')}]`;
  }
  if (value !== null && typeof value === 'object') {
    const parts = Object.entries(value).map(([key, part]) => `${JSON.stringify(key)}: ${jsonText(part, indent + unit, unit, broad)}`);
    return broad ? `{${parts.map((part) => `\n${indent}${unit}${part}`).join(',')}\n${indent}}` : `{${parts.join(', ')}}`;
  }
  return JSON.stringify(value);
}

// The text of something to insert: made from a description, or moved from elsewhere with its lines
// indented again.
function pieceText(piece, indent, unit, broad) {
  if (piece.moved !== undefined) {
    const [first, ...rest] = piece.moved.split('\n');
    return [first, ...rest.map((line) => (line.startsWith(piece.indent) ? indent + line.slice(piece.indent.length) : line))].join('\n');
  }
  return piece.xml !== undefined ? xmlText(piece.xml, indent, unit, broad) : jsonText(piece.json, indent, unit, broad);
}

/** The text of a range, to be inserted elsewhere. */
export const pieceAt = (text, { from, to }) => ({ moved: text.slice(from, to), indent: indentAt(text, from) });

// Changes of XML.

/** Sets an attribute; `after`: the attributes that come before it. */
export function setAttribute(text, element, name, value, after = []) {
  const found = element.attributes.find((attribute) => attribute.name === name);
  if (found !== undefined) {
    return { from: found.valueFrom, to: found.valueTo, insert: escapedXml(value) };
  }
  const before = element.attributes.findLast((attribute) => after.includes(attribute.name)) ?? element.attributes.at(-1);
  const at = before?.to ?? element.nameEnd;
  return { from: at, to: at, insert: ` ${name}="${escapedXml(value)}"` };
}

/** Inserts pieces into an element, one after another, after its child `previous`; null: as the first child. `select`: where the first piece begins. */
export function insertChildren(text, element, previous, pieces) {
  const unit = unitOf(text);
  const next = element.children[previous === null ? 0 : element.children.indexOf(previous) + 1];
  const isOneLine = !text.includes('\n');
  const own = indentAt(text, element.from);
  const textsAt = (indent) => pieces.map((piece) => pieceText(piece, indent, unit, !isOneLine));
  if (element.empty) {
    const from = text.lastIndexOf('/', element.tagEnd);
    const blanks = text.slice(0, from).length - text.slice(0, from).trimEnd().length;
    const indent = own + unit;
    const broad = !isOneLine && startsLine(text, element.from);
    const lead = broad ? `>\n${indent}` : '>';
    const between = broad ? `\n${indent}` : '';
    const close = `${broad ? `\n${own}` : ''}</${element.name}>`;
    return { from: from - blanks, to: element.tagEnd, insert: lead + textsAt(indent).join(between) + close, select: lead.length };
  }
  if (previous !== null && startsLine(text, previous.from)) {
    const indent = indentAt(text, previous.from);
    const at = afterRemarks(text, previous.to);
    const lead = `\n${indent}`;
    return { from: at, to: at, insert: textsAt(indent).map((piece) => lead + piece).join(''), select: lead.length };
  }
  if (previous !== null) {
    const before = element.children[element.children.indexOf(previous) - 1]?.to ?? element.tagEnd;
    const gap = /^[ \t]*$/.test(text.slice(before, previous.from)) ? text.slice(before, previous.from) : '';
    const inline = pieces.map((piece) => gap + pieceText(piece, own, unit, false)).join('');
    return { from: previous.to, to: previous.to, insert: inline, select: gap.length };
  }
  if (next !== undefined && startsLine(text, next.from)) {
    const at = withRemarks(text, next, element.tagEnd).from;
    const indent = indentAt(text, next.from);
    return { from: at, to: at, insert: textsAt(indent).map((piece) => `${piece}\n${indent}`).join(''), select: 0 };
  }
  if (next !== undefined) {
    return { from: next.from, to: next.from, insert: pieces.map((piece) => pieceText(piece, own, unit, false)).join(''), select: 0 };
  }
  const indent = own + unit;
  if (startsLine(text, element.closeFrom)) {
    const at = lineStart(text, element.closeFrom);
    return { from: at, to: at, insert: textsAt(indent).map((piece) => `${indent}${piece}\n`).join(''), select: indent.length };
  }
  const broad = !isOneLine && startsLine(text, element.from);
  const lead = broad ? `\n${indent}` : '';
  return {
    from: element.closeFrom,
    to: element.closeFrom,
    insert: textsAt(indent).map((piece) => lead + piece).join('') + (broad ? `\n${own}` : ''),
    select: lead.length,
  };
}

/** Removes an element, and its whole line if nothing else is on it. */
export function removeElement(text, { from, to }) {
  const end = /^[ \t]*(\r?\n|$)/.exec(text.slice(to, to + 400));
  if (startsLine(text, from) && end !== null) {
    return { from: lineStart(text, from), to: to + end[0].length, insert: '' };
  }
  const blanks = startsLine(text, from) ? 0 : /[ \t]*$/.exec(text.slice(Math.max(0, from - 400), from))[0].length;
  return { from: from - blanks, to, insert: '' };
}

/**
 * The range of an element with the comments that belong to it: on its last line, and on the lines
 * directly above it, but not before `limit`.
 */
export function withRemarks(text, { from, to }, limit) {
  let start = from;
  for (;;) {
    const above = text.slice(limit, start);
    const comment = /<!--(?:(?!-->)[^])*-->[ \t]*\r?\n[ \t]*$/.exec(above.slice(Math.max(0, above.length - 5000)));
    const at = comment === null ? -1 : start - comment[0].length;
    if (at < 0 || !startsLine(text, at) || at <= limit) {
      break;
    }
    start = at;
  }
  return { from: start, to: afterRemarks(text, to) };
}

// Changes of JSON.

const gapBefore = (text, list, i) => {
  const { from } = list.entries[i];
  const before = i === 0 ? list.from + 1 : text.indexOf(',', list.entries[i - 1].to) + 1;
  return text.slice(before, from);
};

/** Inserts a piece at the given index of an array, or, with a key, of an object. */
export function insertEntry(text, list, index, piece, key = null) {
  const unit = unitOf(text);
  const isOneLine = !text.trim().includes('\n');
  const own = indentAt(text, list.from);
  const name = key === null ? '' : JSON.stringify(key) + colonOf(text, list);
  const { entries } = list;
  if (entries.length === 0) {
    const broad = !isOneLine && (piece.moved?.includes('\n') || typeof piece.json === 'object' && !Array.isArray(piece.json));
    const indent = broad ? own + unit : own;
    const lead = broad ? `\n${indent}` : '';
    const insert = lead + name + pieceText(piece, indent, unit, !isOneLine) + (broad ? `\n${own}` : '');
    return { from: list.from + 1, to: list.to - 1, insert, select: lead.length };
  }
  const near = index > 0 ? index - 1 : 0;
  const gap = gapBefore(text, list, near === 0 && entries.length > 1 && index > 0 ? 1 : near);
  const broadGap = gap.includes('\n');
  const indent = broadGap ? indentAt(text, entries[near].from) : own;
  const neighbor = text.slice(entries[near].from, entries[near].to);
  const broad = !isOneLine && broadGap && (key !== null || neighbor.includes('\n') || neighbor.length < 3);
  const insert = name + pieceText(piece, indent, unit, broad);
  if (index > 0) {
    const at = entries[near].to;
    const lead = `,${broadGap ? `\n${indent}` : gap === '' && !isMinified(text) ? ' ' : gap}`;
    return { from: at, to: at, insert: lead + insert, select: lead.length };
  }
  const at = entries[0].from;
  const trail = `,${broadGap ? `\n${indent}` : isMinified(text) ? '' : ' '}`;
  return { from: at, to: at, insert: insert + trail, select: 0 };
}

const isMinified = (text) => !/[,:]\s/.test(text.slice(0, 20_000));

function colonOf(text, object) {
  const [first] = object.entries;
  return first === undefined ? (isMinified(text) ? ':' : ': ') : text.slice(first.keyTo, first.value.from);
}

/** Removes an entry and its comma. */
export function removeEntry(list, index) {
  const { entries } = list;
  const { from, to } = entries[index];
  if (index > 0) {
    return { from: entries[index - 1].to, to, insert: '' };
  }
  if (entries.length > 1) {
    return { from, to: entries[1].from, insert: '' };
  }
  return { from: list.from + 1, to: list.to - 1, insert: '' };
}

// Edits.

const byPlace = (a, b) => a.from - b.from || a.to - b.to;

/** The text after the changes. */
export function applied(text, changes) {
  let result = '';
  let at = 0;
  for (const { from, to, insert } of [...changes].sort(byPlace)) {
    result += text.slice(at, from) + insert;
    at = to;
  }
  return result + text.slice(at);
}

/** The offset, in the new text, of a place in the text that one of the changes inserts. */
export function placeAfter(changes, change, offset) {
  const before = [...changes].sort(byPlace);
  return before
    .slice(0, before.indexOf(change))
    .reduce((place, { from, to, insert }) => place + insert.length - (to - from), change.from + offset);
}

/** Swaps two ranges. */
export const exchanged = (text, a, b) => [
  { ...a, insert: text.slice(b.from, b.to) },
  { ...b, insert: text.slice(a.from, a.to) },
];
