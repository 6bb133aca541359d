// Places in the text of a scene.

/** XML begins with <, JSON does not. */
export function isXml(text) {
  return text.trimStart().startsWith('<');
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
