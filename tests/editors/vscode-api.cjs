// As much of VS Code's interface for extensions as vscode-languageclient and our extension use, over texts in
// memory. What the library does not use is missing on purpose: it would be our own opinion of VS Code.

const { EventEmitter: NodeEmitter } = require('node:events');
const { fileURLToPath, pathToFileURL } = require('node:url');

class Emitter {
  #node = new NodeEmitter();
  event = (listener, self) => {
    const call = (value) => listener.call(self, value);
    this.#node.on('event', call);
    return new Disposable(() => this.#node.off('event', call));
  };
  fire(value) {
    this.#node.emit('event', value);
  }
  dispose() {
    this.#node.removeAllListeners();
  }
}

class Disposable {
  constructor(dispose) {
    this.dispose = dispose;
  }
  static from(...all) {
    return new Disposable(() => all.forEach((one) => one.dispose()));
  }
}

class Position {
  constructor(line, character) {
    Object.assign(this, { line, character });
  }
  translate(lines, characters) {
    return new Position(this.line + lines, this.character + characters);
  }
}

class Range {
  constructor(a, b, c, d) {
    [this.start, this.end] = c === undefined ? [a, b] : [new Position(a, b), new Position(c, d)];
  }
}

class Uri {
  constructor(text) {
    Object.assign(this, { text, scheme: new URL(text).protocol.slice(0, -1) });
  }
  static parse = (text) => new Uri(text);
  static file = (path) => new Uri(pathToFileURL(path).href);
  get fsPath() {
    return fileURLToPath(this.text);
  }
  toString() {
    return this.text;
  }
}

class WorkspaceEdit {
  edits = new Map();
  set(uri, edits) {
    this.edits.set(uri.toString(), edits);
  }
}

class CancellationTokenSource {
  #canceled = new Emitter();
  token = { isCancellationRequested: false, onCancellationRequested: this.#canceled.event };
  cancel() {
    this.token.isCancellationRequested = true;
    this.#canceled.fire();
  }
  dispose() {}
}

class MarkdownString {
  value = '';
  appendText(text) {
    this.value += text;
  }
}

// Classes that only keep what they are made of.
const record = (...names) =>
  class {
    constructor(...values) {
      names.forEach((name, i) => (this[name] = values[i]));
    }
  };
const records = {
  Location: ['uri', 'range'], Diagnostic: ['range', 'message', 'severity'], TextEdit: ['range', 'newText'],
  CompletionItem: ['label'], Hover: ['contents', 'range'], DocumentHighlight: ['range', 'kind'],
  DocumentSymbol: ['name', 'detail', 'kind', 'range', 'selectionRange'], CodeAction: ['title', 'kind'],
  Color: ['red', 'green', 'blue', 'alpha'], ColorInformation: ['range', 'color'], ColorPresentation: ['label'],
  SemanticTokensLegend: ['tokenTypes', 'tokenModifiers'], SemanticTokens: ['data', 'resultId'], RelativePattern: ['base', 'pattern'],
  // Bases of the library's own classes:
  CallHierarchyItem: [], CodeLens: [], DocumentLink: [], InlayHint: [], TypeHierarchyItem: [], SymbolInformation: [],
};
const enumeration = (...names) => Object.fromEntries(names.map((name, i) => [name, i]));
class CodeActionKind {
  constructor(value) {
    this.value = value;
  }
  append(part) {
    return new CodeActionKind(this.value ? `${this.value}.${part}` : part);
  }
  static Empty = new CodeActionKind('');
  static QuickFix = new CodeActionKind('quickfix');
  static Source = new CodeActionKind('source');
}

class Document {
  version = 1;
  isDirty = false;
  isClosed = false;
  constructor(uri, languageId, text) {
    Object.assign(this, { uri, languageId, text, fileName: uri.fsPath });
  }
  getText(range) {
    return range ? this.text.slice(this.offsetAt(range.start), this.offsetAt(range.end)) : this.text;
  }
  positionAt(offset) {
    const lines = this.text.slice(0, offset).split('\n');
    return new Position(lines.length - 1, lines.at(-1).length);
  }
  offsetAt({ line, character }) {
    const lines = this.text.split('\n');
    return lines.length <= line ? this.text.length
      : lines.slice(0, line).reduce((sum, one) => sum + one.length + 1, 0) + Math.min(character, lines[line].length);
  }
}

const never = () => new Disposable(() => {});
const openings = new Emitter();
const changes = new Emitter();
const state = {};

const languages = {
  match: () => 10,
  createDiagnosticCollection: () => ({
    set: (uri, found) => {
      state.found = [uri.toString(), found];
      state.waiting?.();
    },
    delete() {}, clear() {}, dispose() {},
  }),
};
for (const kind of ['SignatureHelp', 'WorkspaceSymbol', 'TypeHierarchy', 'TypeDefinition', 'SelectionRange', 'Rename',
  'Reference', 'OnTypeFormattingEdit', 'InlineValues', 'InlayHints', 'Implementation', 'Hover', 'FoldingRange',
  'DocumentSymbol', 'DocumentRangeFormattingEdit', 'DocumentLink', 'DocumentHighlight', 'DocumentFormattingEdit',
  'Definition', 'Declaration', 'CompletionItem', 'Color', 'CodeLens', 'CodeActions', 'CallHierarchy',
  'DocumentSemanticTokens', 'DocumentRangeSemanticTokens']) {
  languages[`register${kind}Provider`] = (selector, provider, legend) => {
    state.providers[kind] = { provider, legend };
    return new Disposable(() => delete state.providers[kind]);
  };
}

const vscode = {
  version: '1.91.0', env: { language: 'en', appName: 'test' },
  EventEmitter: Emitter, Disposable, Position, Range, Uri, WorkspaceEdit, CancellationTokenSource, CodeActionKind, MarkdownString,
  CancellationError: class extends Error {},
  ...Object.fromEntries(Object.entries(records).map(([name, parts]) => [name, record(...parts)])),
  DiagnosticSeverity: enumeration('Error', 'Warning', 'Information', 'Hint'),
  CompletionTriggerKind: enumeration('Invoke', 'TriggerCharacter', 'TriggerForIncompleteCompletions'),
  CodeActionTriggerKind: { Invoke: 1, Automatic: 2 },
  DocumentHighlightKind: enumeration('Text', 'Read', 'Write'),
  SymbolKind: { Variable: 12, TypeParameter: 25 },
  CompletionItemKind: { Text: 0, TypeParameter: 24 },
  ProgressLocation: { Window: 10 },
  languages,
  commands: {
    registerCommand: (name, run) => {
      state.commands[name] = run;
      return new Disposable(() => delete state.commands[name]);
    },
  },
  window: {
    createOutputChannel: () => ({ appendLine() {}, append() {}, show() {}, dispose() {} }),
    tabGroups: { all: [], onDidChangeTabs: never },
    onDidChangeActiveTextEditor: never,
  },
  workspace: {
    getConfiguration: (section) => ({ get: (key, start) => state.settings[`${section}.${key}`] ?? start }),
    get textDocuments() {
      return state.documents;
    },
    onDidOpenTextDocument: openings.event, onDidChangeTextDocument: changes.event,
  },
};
for (const show of ['showErrorMessage', 'showWarningMessage', 'showInformationMessage']) {
  vscode.window[show] = async (text) => void state.messages.push(text);
}
for (const event of ['onDidChangeConfiguration', 'onWillSaveTextDocument', 'onDidSaveTextDocument',
  'onDidCloseTextDocument', 'onDidChangeWorkspaceFolders', 'onDidCreateFiles', 'onDidRenameFiles', 'onDidDeleteFiles',
  'onWillCreateFiles', 'onWillRenameFiles', 'onWillDeleteFiles', 'onDidOpenNotebookDocument', 'onDidCloseNotebookDocument',
  'onDidChangeNotebookDocument', 'onDidSaveNotebookDocument']) {
  vscode.workspace[event] = never;
}

// The editor, as someone sees it.
class Editor {
  token = new CancellationTokenSource().token;

  get messages() {
    return state.messages;
  }

  open(uri, language, text) {
    const document = new Document(Uri.parse(uri), language, text);
    state.documents.push(document);
    openings.fire(document);
    return document;
  }

  change(document, start, end, text) {
    const rangeOffset = document.offsetAt(start);
    const rangeLength = document.offsetAt(end) - rangeOffset;
    document.text = document.text.slice(0, rangeOffset) + text + document.text.slice(rangeOffset + rangeLength);
    document.version += 1;
    state.found = null;
    changes.fire({ document, contentChanges: [{ range: new Range(start, end), rangeOffset, rangeLength, text }] });
  }

  // The next findings that the client shows for a document.
  async findings(document) {
    while (state.found?.[0] !== document.uri.toString()) {
      await new Promise((resolve) => (state.waiting = resolve));
    }
    const [, found] = state.found;
    state.found = null;
    return found;
  }

  ask(kind, method, ...what) {
    return state.providers[kind].provider[method](...what, this.token);
  }

  // "class leg", "number 0.5", ...
  async askTokens(document) {
    const { provider, legend } = state.providers.DocumentSemanticTokens;
    const { data } = await provider.provideDocumentSemanticTokens(document, this.token);
    const tokens = [];
    for (let i = 0, line = 0, from = 0; i < data.length; i += 5) {
      from = data[i] === 0 ? from + data[i + 1] : data[i + 1];
      line += data[i];
      tokens.push(`${legend.tokenTypes[data[i + 3]]} ${document.getText(new Range(line, from, line, from + data[i + 2]))}`);
    }
    return tokens;
  }

  async apply(edit) {
    for (const document of state.documents) {
      const edits = edit.edits.get(document.uri.toString()) ?? [];
      edits.sort((a, b) => document.offsetAt(b.range.start) - document.offsetAt(a.range.start));
      edits.forEach(({ range, newText }) => this.change(document, range.start, range.end, newText));
    }
  }

  run(command) {
    return state.commands[command]();
  }
}

exports.vscode = vscode;
exports.start = (settings) => {
  Object.assign(state, { settings, documents: [], providers: {}, commands: {}, messages: [], found: null });
  return new Editor();
};
exports.editOf = (document, edits) => {
  const edit = new WorkspaceEdit();
  edit.set(document.uri, edits);
  return edit;
};
