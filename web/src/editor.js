// The editor: CodeMirror with the checker's findings and completion for the format. It is in a
// shadow root, because there CodeMirror's styles need no exception in the content security policy.

import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from '@codemirror/autocomplete';
import { defaultKeymap, history, historyKeymap, indentWithTab, redo, undo } from '@codemirror/commands';
import { bracketMatching, HighlightStyle, indentOnInput, syntaxHighlighting } from '@codemirror/language';
import { lintGutter, lintKeymap, setDiagnostics } from '@codemirror/lint';
import { highlightSelectionMatches, searchKeymap } from '@codemirror/search';
import { Compartment, EditorSelection, EditorState } from '@codemirror/state';
import {
  drawSelection, EditorView, highlightActiveLine, highlightActiveLineGutter, hoverTooltip, keymap, lineNumbers,
} from '@codemirror/view';
import { tags } from '@lezer/highlight';

import { h } from './dom.js';
import { json, xml } from './languages.js';
import { correct, isXml, offsetOf, wordEnd } from './places.js';

const highlighting = HighlightStyle.define([
  { tag: [tags.tagName, tags.propertyName], color: 'var(--tag)' },
  { tag: [tags.attributeName, tags.bool, tags.null], color: 'var(--attribute)' },
  { tag: [tags.attributeValue, tags.string, tags.number], color: 'var(--value)' },
  { tag: [tags.comment, tags.meta], color: 'var(--comment)', fontStyle: 'italic' },
]);

const look = EditorView.theme({
  '&': { height: '100%', color: 'var(--text)', backgroundColor: 'var(--back)', fontSize: '13px' },
  '.cm-scroller': { fontFamily: 'var(--mono)', lineHeight: '1.5' },
  '.cm-content': { caretColor: 'var(--text)' },
  '.cm-cursor': { borderLeftColor: 'var(--text)' },
  '&.cm-focused': { outline: '2px solid var(--accent)', outlineOffset: '-2px' },
  '.cm-gutters': { backgroundColor: 'var(--raised)', color: 'var(--quiet)', border: 'none' },
  '.cm-activeLine, .cm-activeLineGutter': { backgroundColor: 'color-mix(in srgb, var(--selected) 35%, transparent)' },
  '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground': {
    backgroundColor: 'var(--selected)',
  },
  '.cm-tooltip': { backgroundColor: 'var(--raised)', color: 'var(--text)', border: '1px solid var(--line)', maxWidth: '420px' },
  '.cm-tooltip.cm-tooltip-autocomplete > ul > li[aria-selected]': { backgroundColor: 'var(--accent)', color: 'var(--on-accent)' },
  '.cm-completionInfo': { maxWidth: '300px' },
  '.about': { padding: '4px 8px' },
  '.cm-panels': { backgroundColor: 'var(--raised)', color: 'var(--text)' },
  '.cm-panel input, .cm-panel button': { color: 'inherit', backgroundColor: 'var(--back)', backgroundImage: 'none' },
  '.cm-diagnosticText': { whiteSpace: 'pre-wrap' },
});

// Only the beginning of the text matters, and files may be large.
const languageOf = (text) => (isXml(text.slice(0, 2000)) ? xml : json);

export class Editor {
  #view;
  #language = new Compartment();
  #isXml = false;
  #hasCarriageReturns = false;
  #extensions;

  /** `engine`: resolves to the EditEngine. */
  constructor(parent, { engine, changed, moved }) {
    const root = parent.attachShadow({ mode: 'open' });
    const box = h('div');
    box.style.height = '100%';
    root.append(box);
    const source = async (context) => {
      const text = context.state.doc.toString();
      if (!context.explicit && !/[\w<"/]/.test(text[context.pos - 1] ?? '')) {
        return null;
      }
      const found = (await engine()).complete(text, context.pos);
      return found.items.length === 0 ? null : {
        from: found.from,
        to: found.to,
        options: found.items.map(({ label, kind, about, insert }) => ({
          label,
          type: { element: 'type', attribute: 'property', value: 'constant' }[kind],
          info: about === '' ? undefined : about,
          // Moves the cursor to the first empty value.
          apply: (view, completion, from, to) => {
            const empty = insert.indexOf('""');
            const between = insert.indexOf('></');
            const at = empty >= 0 ? empty + 1 : between >= 0 ? between + 1 : insert.length;
            view.dispatch({
              changes: { from, to, insert },
              selection: EditorSelection.cursor(from + at),
              userEvent: 'input.complete',
            });
          },
        })),
        validFor: /^[\w:."/-]*$/,
      };
    };
    const hover = hoverTooltip(async (view, pos) => {
      const text = view.state.doc.toString();
      const found = (await engine()).describe(text, pos);
      return found === null
        ? null
        : {
            pos: found.from,
            end: found.to,
            create: () => ({ dom: h('div', { className: 'about' }, h('strong', {}, text.slice(found.from, found.to)), ' ', found.about) }),
          };
    });
    this.#extensions = [
        lineNumbers(), lintGutter(), history(), drawSelection(), indentOnInput(), bracketMatching(), closeBrackets(),
        highlightActiveLine(), highlightActiveLineGutter(), highlightSelectionMatches(),
        syntaxHighlighting(highlighting), look, hover,
        autocompletion({ override: [source] }),
        EditorView.contentAttributes.of({ 'aria-label': 'Text of the scene', tabindex: '0' }),
        EditorView.updateListener.of((update) => {
          if (update.docChanged) {
            this.#chooseLanguage();
            changed(update.changes);
          }
          if (update.selectionSet && update.transactions.some((t) => t.isUserEvent('select'))) {
            moved?.(update.state.doc.lineAt(update.state.selection.main.head).number);
          }
        }),
        // After Escape, Tab leaves the editor, as usual in CodeMirror.
        keymap.of([
          ...closeBracketsKeymap, ...defaultKeymap, ...searchKeymap, ...historyKeymap, ...completionKeymap,
          ...lintKeymap, indentWithTab,
        ]),
    ];
    this.#view = new EditorView({ root, parent: box, state: this.#stateOf('') });
  }

  #stateOf(doc) {
    return EditorState.create({ doc, extensions: [this.#extensions, this.#language.of(languageOf(doc))] });
  }

  #chooseLanguage() {
    const start = this.#view.state.doc.sliceString(0, 2000);
    if (isXml(start) !== this.#isXml) {
      this.#isXml = !this.#isXml;
      this.#view.dispatch({ effects: this.#language.reconfigure(languageOf(start)) });
    }
  }

  get text() {
    return this.#view.state.doc.toString();
  }

  /** The text with the file's line endings, which are uniform. */
  get fileText() {
    return this.#hasCarriageReturns ? this.text.replaceAll('\n', '\r\n') : this.text;
  }

  /** Opens another document, with an empty undo history. */
  open(text) {
    this.#isXml = isXml(text.slice(0, 2000));
    this.#hasCarriageReturns = text.includes('\r\n') && !/[^\r]\n|^\n/.test(text);
    this.#view.setState(this.#stateOf(text));
  }

  /** Changes the document as one step that can be undone; replaces only what differs. */
  replace(text) {
    const old = this.text;
    let from = 0;
    while (from < old.length && from < text.length && old[from] === text[from]) {
      ++from;
    }
    let end = 0;
    while (end < Math.min(old.length, text.length) - from && old.at(-1 - end) === text.at(-1 - end)) {
      ++end;
    }
    this.#view.dispatch({
      changes: { from, to: old.length - end, insert: text.slice(from, text.length - end) },
      userEvent: 'input',
    });
  }

  /** Replaces places of the text as one step that can be undone. */
  change(changes) {
    this.#view.dispatch({ changes, userEvent: 'input.panel' });
  }

  get cursor() {
    return this.#view.state.selection.main.head;
  }

  /** The offset at which the text of a line begins. */
  offsetOfLine(number) {
    const { doc } = this.#view.state;
    const line = doc.line(Math.max(1, Math.min(number, doc.lines)));
    return line.from + /^\s*/.exec(line.text)[0].length;
  }

  lineAt(offset) {
    const { doc } = this.#view.state;
    return doc.lineAt(Math.max(0, Math.min(offset, doc.length))).number;
  }

  undo() {
    undo(this.#view);
  }
  redo() {
    redo(this.#view);
  }

  selectLine(number) {
    const { doc } = this.#view.state;
    const line = doc.line(Math.max(1, Math.min(number, doc.lines)));
    const selection = EditorSelection.single(line.from, line.to);
    this.#view.dispatch({ selection, effects: EditorView.scrollIntoView(line.from, { y: 'center' }) });
  }

  /** Selects the place of a finding. */
  selectPlace(line, column) {
    const at = offsetOf(this.text, line, column);
    this.#view.dispatch({
      selection: EditorSelection.single(at, wordEnd(this.text, at)),
      effects: EditorView.scrollIntoView(at, { y: 'center' }),
    });
    this.#view.focus();
  }

  focus() {
    this.#view.focus();
  }

  /** The correction that a finding proposes, with a function that applies it unless the text has changed; null if there is none. */
  correctionOf(finding) {
    const { doc } = this.#view.state;
    const found = correct(this.text, finding);
    const apply = () => doc === this.#view.state.doc && this.#view.dispatch({ changes: found.changes, userEvent: 'input' });
    return found && { title: found.title, apply };
  }

  showFindings(findings) {
    const text = this.text;
    const shown = findings
      .filter(({ file, line }) => file === undefined && line !== undefined)
      .map((finding) => {
        const from = Math.min(offsetOf(text, finding.line, finding.column), text.length);
        const correction = this.correctionOf(finding);
        return {
          from,
          to: Math.max(from, Math.min(wordEnd(text, from), text.length)),
          severity: finding.severity === 'note' ? 'info' : finding.severity,
          source: finding.code,
          message: finding.message,
          actions: correction === null ? [] : [{ name: correction.title, apply: correction.apply }],
        };
      });
    this.#view.dispatch(setDiagnostics(this.#view.state, shown));
  }
}
