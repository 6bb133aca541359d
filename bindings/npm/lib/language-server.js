// The language server: findings while a scene is edited, completion, formatting, quick fixes for
// misspelled names, and explanations of findings and of the words of the format. Source of the protocol:
// "Language Server Protocol", version 3.17.

import { existsSync, readFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { check, format, run } from './index.js';
import { complete, correct, declarationOf, describe, mayBeScene, offsetOf, wordEnd } from './words.js';

const vocabulary = JSON.parse(readFileSync(new URL('vocabulary.json', import.meta.url), 'utf8'));

const pause = 40; // milliseconds without a change before a scene is checked

// In addition to the scene's own folder (docs/assets.md).
const neighbors = ['image', 'images', 'texture', 'textures', 'mesh', 'meshes', 'model', 'models'];

const severities = { error: 1, warning: 2, note: 3 };

/** Serves one client until it sends exit. */
export function serve(input, output, exit = (status) => process.exit(status)) {
  const documents = new Map();
  let stopped = false;
  let buffer = Buffer.alloc(0);

  const send = (message) => {
    const body = Buffer.from(JSON.stringify({ jsonrpc: '2.0', ...message }));
    output.write(`Content-Length: ${body.length}\r\n\r\n`);
    output.write(body);
  };

  const publish = async (document) => {
    const { uri, version, text } = document;
    const findings = await findingsOf(document);
    if (documents.get(uri)?.version === version) {
      document.findings = findings;
      send({
        method: 'textDocument/publishDiagnostics',
        params: { uri, version, diagnostics: findings.map((finding) => diagnosticOf(finding, text)) },
      });
    }
  };

  const change = (uri, version, text) => {
    clearTimeout(documents.get(uri)?.timer);
    const document = { uri, version, text, findings: [] };
    document.timer = setTimeout(() => publish(document), pause);
    documents.set(uri, document);
  };

  const requests = {
    initialize: () => ({
      capabilities: {
        textDocumentSync: { openClose: true, change: 1, save: true },
        documentFormattingProvider: true,
        hoverProvider: true,
        definitionProvider: true,
        completionProvider: { triggerCharacters: ['<', '"', ' ', '/'] },
        codeActionProvider: { codeActionKinds: ['quickfix'] },
      },
      serverInfo: { name: 'scenefile' },
    }),
    shutdown: () => {
      stopped = true;
      return null;
    },
    'textDocument/formatting': ({ textDocument }) => edits(documents.get(textDocument.uri)),
    'textDocument/completion': ({ textDocument, position }) => completions(documents.get(textDocument.uri), position),
    'textDocument/definition': ({ textDocument, position }) =>
      definition(documents.get(textDocument.uri), position),
    'textDocument/hover': ({ textDocument, position }) => hover(documents.get(textDocument.uri), position),
    'textDocument/codeAction': ({ textDocument, range }) => corrections(documents.get(textDocument.uri), range),
  };

  const notifications = {
    exit: () => exit(stopped ? 0 : 1),
    'textDocument/didOpen': ({ textDocument: d }) => change(d.uri, d.version, d.text),
    'textDocument/didChange': ({ textDocument: d, contentChanges }) =>
      change(d.uri, d.version, contentChanges.at(-1).text),
    // A texture may have been added in the meantime.
    'textDocument/didSave': ({ textDocument: d }) => {
      const document = documents.get(d.uri);
      if (document !== undefined) {
        change(d.uri, document.version, document.text);
      }
    },
    'textDocument/didClose': ({ textDocument: d }) => {
      clearTimeout(documents.get(d.uri)?.timer);
      documents.delete(d.uri);
      send({ method: 'textDocument/publishDiagnostics', params: { uri: d.uri, diagnostics: [] } });
    },
  };

  const handle = async ({ id, method, params }) => {
    if (id === undefined) {
      notifications[method]?.(params);
      return;
    }
    if (requests[method] === undefined) {
      send({ id, error: { code: -32601, message: `unknown method ${method}` } });
      return;
    }
    try {
      send({ id, result: await requests[method](params) });
    } catch (error) {
      send({ id, error: { code: -32603, message: error.message } });
    }
  };

  input.on('data', (chunk) => {
    buffer = Buffer.concat([buffer, chunk]);
    for (;;) {
      const end = buffer.indexOf('\r\n\r\n');
      const length = /content-length: *(\d+)/i.exec(buffer.toString('latin1', 0, Math.max(end, 0)));
      if (end < 0 || length === null || buffer.length < end + 4 + Number(length[1])) {
        return;
      }
      const body = buffer.toString('utf8', end + 4, end + 4 + Number(length[1]));
      buffer = buffer.subarray(end + 4 + Number(length[1]));
      handle(JSON.parse(body));
    }
  });
  input.on('end', () => exit(stopped ? 0 : 1));
}

function rootsOf(uri) {
  if (!uri.startsWith('file:')) {
    return [];
  }
  const folder = dirname(fileURLToPath(uri));
  const parents = neighbors.map((name) => join(dirname(folder), name));
  return [folder, ...parents].filter((path) => existsSync(path));
}

function nameOf(uri) {
  return uri.startsWith('file:') ? basename(fileURLToPath(uri)) : undefined;
}

// Editors ask about every XML and JSON file.
async function findingsOf({ uri, text }) {
  if (!mayBeScene(text)) {
    return [];
  }
  const { findings, error } = await check(text, { name: nameOf(uri), roots: rootsOf(uri) });
  return error === undefined ? findings : [{ code: 'unreadable', severity: 'error', message: error }];
}

// Positions of the protocol count from 0, columns in UTF-16 units.
function positionAt(text, offset) {
  const before = text.slice(0, offset).split(/\r\n|\r|\n/);
  return { line: before.length - 1, character: before.at(-1).length };
}

function offsetAt(text, { line, character }) {
  return offsetOf(text, line + 1, 1) + character;
}

const rangeAt = (text, from, to) => ({ start: positionAt(text, from), end: positionAt(text, to) });

// The range of the name or value at the place of a finding.
function rangeOf(finding, text) {
  const from = finding.line === undefined ? 0 : offsetOf(text, finding.line, finding.column);
  return rangeAt(text, from, wordEnd(text, from));
}

function diagnosticOf(finding, text) {
  return {
    range: rangeOf(finding, text),
    severity: severities[finding.severity],
    code: finding.code,
    source: 'scenefile',
    message: finding.message,
  };
}

async function edits(document) {
  if (document === undefined) {
    return [];
  }
  const newText = await format(document.text, { name: nameOf(document.uri) });
  if (newText === document.text) {
    return [];
  }
  const lines = document.text.split(/\r\n|\r|\n/);
  const end = { line: lines.length - 1, character: lines.at(-1).length };
  return [{ range: { start: { line: 0, character: 0 }, end }, newText }];
}

function holds(range, position) {
  return (
    range.start.line === position.line &&
    range.start.character <= position.character &&
    position.character <= range.end.character
  );
}

// The explanation of a finding at this place, otherwise of the word.
async function hover(document, position) {
  if (document === undefined) {
    return null;
  }
  const { text, findings } = document;
  const finding = findings.find((f) => f.line !== undefined && holds(rangeOf(f, text), position));
  if (finding !== undefined) {
    const help = new TextDecoder().decode((await run(['help', finding.code])).stdout);
    return { contents: { kind: 'plaintext', value: help }, range: rangeOf(finding, text) };
  }
  const found = describe(text, offsetAt(text, position), vocabulary);
  return found && { contents: { kind: 'plaintext', value: found.about }, range: rangeAt(text, found.from, found.to) };
}

function definition(document, position) {
  if (document === undefined) {
    return null;
  }
  const { uri, text } = document;
  const found = declarationOf(text, offsetAt(text, position), vocabulary);
  return found && { uri, range: rangeAt(text, found.from, found.to) };
}

const completionKinds = { element: 7, attribute: 10, value: 12 }; // Class, Property, Value

function completions(document, position) {
  const { text } = document ?? { text: '' };
  const found = complete(text, offsetAt(text, position), vocabulary);
  return (found?.items ?? []).map(({ label, kind, about, insert }) => ({
    label,
    kind: completionKinds[kind],
    documentation: about,
    filterText: insert,
    textEdit: { range: rangeAt(text, found.from, found.to), newText: insert },
  }));
}

function corrections(document, range) {
  const actions = [];
  for (const finding of document?.findings ?? []) {
    const { text, uri } = document;
    const diagnostic = diagnosticOf(finding, text);
    const { start } = diagnostic.range;
    if (finding.line === undefined || range.end.line < start.line || start.line < range.start.line) {
      continue;
    }
    const found = correct(text, finding);
    if (found !== null) {
      const changes = found.changes.map(({ from, to, insert }) => ({ range: rangeAt(text, from, to), newText: insert }));
      actions.push({
        title: found.title,
        kind: 'quickfix',
        diagnostics: [diagnostic],
        isPreferred: true,
        edit: { changes: { [uri]: changes } },
      });
    }
  }
  return actions;
}
