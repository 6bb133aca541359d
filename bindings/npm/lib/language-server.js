// The language server: findings while a scene is edited, formatting, quick fixes for misspelled names, and
// explanations of findings. Source of the protocol: "Language Server Protocol", version 3.17.

import { existsSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { check, format, run } from './index.js';

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
        codeActionProvider: { codeActionKinds: ['quickfix'] },
      },
      serverInfo: { name: 'scenefile' },
    }),
    shutdown: () => {
      stopped = true;
      return null;
    },
    'textDocument/formatting': ({ textDocument }) => edits(documents.get(textDocument.uri)),
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

async function findingsOf({ uri, text }) {
  const { findings, error } = await check(text, { name: nameOf(uri), roots: rootsOf(uri) });
  return error === undefined ? findings : [{ code: 'unreadable', severity: 'error', message: error }];
}

// The program counts columns in code points from 1, the protocol in UTF-16 units from 0.
function positionOf(finding, lines) {
  if (finding.line === undefined) {
    return { line: 0, character: 0 };
  }
  const line = Math.min(finding.line - 1, lines.length - 1);
  const before = [...lines[line]].slice(0, (finding.column ?? 1) - 1);
  return { line, character: before.join('').length };
}

// The range of the name or value at the place of a finding.
function rangeOf(finding, text) {
  const lines = text.split(/\r\n|\r|\n/);
  const start = positionOf(finding, lines);
  const word = /^<?\/?[\w.:-]+|^"[^"]*"?|^\S/.exec(lines[start.line].slice(start.character));
  return { start, end: { line: start.line, character: start.character + (word?.[0].length ?? 0) } };
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

async function hover(document, position) {
  const finding = document?.findings.find((f) => f.line !== undefined && holds(rangeOf(f, document.text), position));
  if (finding === undefined) {
    return null;
  }
  const help = new TextDecoder().decode((await run(['help', finding.code])).stdout);
  return { contents: { kind: 'plaintext', value: help }, range: rangeOf(finding, document.text) };
}

// `unknown element <difuse> in <object>; did you mean <diffuse>?`, `<transblok> was read as <transblock>`
function correction({ message }) {
  const words =
    /(?:<([^<>]+)>|"([^"]+)")[^;]*; did you mean (?:<([^<>]+)>|"?([\w.-]+)"?)\?/.exec(message) ??
    /<([^<>]+)>() was read as <([^<>]+)>/.exec(message);
  return words === null ? null : { wrong: words[1] ?? words[2], right: words[3] ?? words[4] };
}

function positionAt(text, offset) {
  const before = text.slice(0, offset).split(/\r\n|\r|\n/);
  return { line: before.length - 1, character: before.at(-1).length };
}

function offsetAt(text, position) {
  const ends = /\r\n|\r|\n/g;
  for (let line = 0; line < position.line; ++line) {
    ends.exec(text);
  }
  return ends.lastIndex + position.character;
}

// The ranges of the name in the start tag and, if there is one, in the end tag.
function placesOf(wrong, start, text) {
  const at = text.indexOf(wrong, offsetAt(text, start));
  const close = text.indexOf(`</${wrong}>`, at);
  const places = text[at - 1] === '<' && close >= 0 ? [at, close + 2] : [at];
  return at < 0 ? [] : places;
}

function corrections(document, range) {
  const actions = [];
  for (const finding of document?.findings ?? []) {
    const found = correction(finding);
    const diagnostic = diagnosticOf(finding, document.text);
    const { start } = diagnostic.range;
    if (found === null || finding.line === undefined || range.end.line < start.line || start.line < range.start.line) {
      continue;
    }
    const changes = placesOf(found.wrong, start, document.text).map((at) => ({
      range: { start: positionAt(document.text, at), end: positionAt(document.text, at + found.wrong.length) },
      newText: found.right,
    }));
    if (changes.length === 0 || changes[0].range.start.line !== start.line) {
      continue;
    }
    actions.push({
      title: `Change ${found.wrong} to ${found.right}`,
      kind: 'quickfix',
      diagnostics: [diagnostic],
      isPreferred: true,
      edit: { changes: { [document.uri]: changes } },
    });
  }
  return actions;
}
