// Syntax highlighting for XML and JSON. A tokenizer that works line by line is enough for scene
// files, and much smaller than a full parser.

import { StreamLanguage } from '@codemirror/language';

const inMarkup = { '<!--': ['comment', '-->'], '<![CDATA[': ['string', ']]>'], '<?': ['meta', '?>'], '<!': ['meta', '>'] };

function untilEnd(stream, state) {
  const [style, end] = state.until;
  if (stream.skipTo(end)) {
    stream.pos += end.length;
    state.until = null;
  } else {
    stream.skipToEnd();
  }
  return style;
}

function xmlToken(stream, state) {
  if (state.until !== null) {
    return untilEnd(stream, state);
  }
  if (!state.tag) {
    for (const [start, until] of Object.entries(inMarkup)) {
      if (stream.match(start)) {
        state.until = until;
        return untilEnd(stream, state);
      }
    }
    if (stream.match(/^<\/?/)) {
      state.tag = true;
      stream.match(/^[\w:.-]*/);
      return 'tagName';
    }
    stream.next();
    stream.eatWhile(/[^<]/);
    return null;
  }
  if (stream.eatSpace()) {
    return null;
  }
  if (stream.match(/^\/?>/)) {
    state.tag = false;
    return 'tagName';
  }
  const quote = stream.eat(/["']/);
  if (quote) {
    state.until = ['string', quote];
    return untilEnd(stream, state);
  }
  if (stream.match(/^[\w:.-]+/)) {
    return 'attributeName';
  }
  if (stream.peek() === '<') {
    state.tag = false; // the previous tag was never closed
    return null;
  }
  stream.next();
  return null;
}

// Indents one level deeper after an opening tag or bracket, up to the closing one.
function indentAfter(opens, closes) {
  return (state, textAfter, context) => {
    const { doc } = context.state;
    for (let n = doc.lineAt(context.pos).number - 1; n >= 1; --n) {
      const line = doc.line(n).text;
      if (line.trim() !== '') {
        const deeper = opens.test(line) ? context.unit : 0;
        const back = closes.test(textAfter) ? context.unit : 0;
        return Math.max(0, /^\s*/.exec(line)[0].length + deeper - back);
      }
    }
    return 0;
  };
}

export const xml = StreamLanguage.define({
  name: 'xml',
  startState: () => ({ tag: false, until: null }),
  copyState: (state) => ({ ...state }),
  token: xmlToken,
  indent: indentAfter(/<[\w:.-]+(?:[^<>"'/]|"[^"]*"|'[^']*')*>\s*$/, /^\s*<\//),
  languageData: { commentTokens: { block: { open: '<!--', close: '-->' } }, indentOnInput: /^\s*<\/$/ },
});

export const json = StreamLanguage.define({
  name: 'json',
  startState: () => ({}),
  token(stream) {
    if (stream.eatSpace()) {
      return null;
    }
    if (stream.match(/^"(?:[^"\\]|\\.)*"?/)) {
      return stream.match(/^\s*:/, false) ? 'propertyName' : 'string';
    }
    if (stream.match(/^-?\d[\d.eE+-]*/)) {
      return 'number';
    }
    if (stream.match(/^(?:true|false|null)\b/)) {
      return 'bool';
    }
    stream.next();
    return null;
  },
  indent: indentAfter(/[[{]\s*$/, /^\s*[\]}]/),
  languageData: { closeBrackets: { brackets: ['[', '{', '"'] }, indentOnInput: /^\s*[\]}]$/ },
});
