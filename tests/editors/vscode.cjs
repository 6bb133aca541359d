// The extension of editors/vscode, with VS Code's client library, vscode-languageclient, and a scene in an
// editor: what the extension offers is asked for as VS Code asks for it. VS Code itself cannot be had as a
// package, so its interface is what stands in vscode-api.cjs. Run by try.py in a folder with scene.xml.

const assert = require('node:assert/strict');
const Module = require('node:module');
const { readFileSync } = require('node:fs');
const { pathToFileURL } = require('node:url');

const api = require('./vscode-api.cjs');

const load = Module._load;
Module._load = (name, ...rest) => (name === 'vscode' ? api.vscode : load(name, ...rest));
const extension = require('../../editors/vscode/extension.js');

const scene = readFileSync('scene.xml', 'utf8');

(async () => {
  const editor = api.start({ 'scenefile.command': 'scenefile', 'scenefile.files': ['**/*.xml', '**/*.json'] });
  const context = { subscriptions: [] };
  await extension.activate(context);
  assert.deepEqual(editor.messages, []);

  const document = editor.open(pathToFileURL('a b.xml').href, 'xml', scene);
  const at = (text, from = 0) => document.positionAt(document.getText().indexOf(text, from));
  const ask = (provider, method, ...rest) => editor.ask(provider, method, document, ...rest);

  const [finding, ...others] = await editor.findings(document);
  assert.deepEqual(others, []);
  assert.equal(finding.code, 'xml.misspelled-element');
  assert.equal(document.getText(finding.range), '<difuse');

  const completions = await ask('CompletionItem', 'provideCompletionItems', at('id v='), editor.token, { triggerKind: 0 });
  assert.deepEqual(completions.slice(0, 3).map(({ label }) => label), ['id', 'type', 'color']);
  const { contents } = await ask('Hover', 'provideHover', at('position'));
  assert.match(contents.value, /\w+ \w+/);
  const outline = await ask('DocumentSymbol', 'provideDocumentSymbols');
  assert.deepEqual(outline.map(({ name }) => name), ['lightdata', 'leg', 'root']);
  assert.equal(outline[2].children.length, 2);
  const use = at('leg', scene.indexOf('master'));
  const place = await ask('Definition', 'provideDefinition', use);
  assert.equal(place.range.start.line, 2);
  assert.equal((await ask('Reference', 'provideReferences', use, { includeDeclaration: true })).length, 2);
  assert.equal((await ask('DocumentHighlight', 'provideDocumentHighlights', use)).length, 2);
  const [color] = await ask('Color', 'provideDocumentColors');
  assert.deepEqual([color.color.red, color.color.green, color.color.blue], [1, 0.5, 0]);
  const tokens = await editor.askTokens(document);
  assert.ok(tokens.includes('class leg') && tokens.includes('number 0.5') && tokens.includes('enumMember sphere'));

  // Each change is applied, so that the next request is about the new text.
  const renamed = await ask('Rename', 'provideRenameEdits', use, 'foot');
  await editor.apply(renamed);
  assert.equal(document.getText(), scene.replaceAll('"leg"', '"foot"'));
  const [again] = await editor.findings(document);
  const [fix] = await ask('CodeActions', 'provideCodeActions', again.range, { diagnostics: [again] });
  assert.equal(fix.isPreferred, true);
  await editor.apply(fix.edit);
  assert.ok(document.getText().includes('<diffuse r="1"'));
  assert.deepEqual(await editor.findings(document), []);
  const formatted = await ask('DocumentFormattingEdit', 'provideDocumentFormattingEdits', { tabSize: 2 });
  await editor.apply(api.editOf(document, formatted));
  assert.match(document.getText(), /^ {2}<lightdata>\n {4}<id v="0"\/>$/m);

  editor.change(document, at('<diffuse').translate(0, 1), at('<diffuse').translate(0, 2), '');
  const [typed] = await editor.findings(document);
  assert.equal(typed.code, 'xml.misspelled-element');

  await editor.run('scenefile.restart');
  assert.equal((await editor.findings(document)).length, 1);

  // From a key to its finding, in 100 KB.
  const block = '<transblock><translate x="1" y="2" z="3"/><object type="primitive" name="cube"/></transblock>\n';
  const part = '<object type="tree" name="root">\n';
  const large = editor.open(pathToFileURL('large.xml').href, 'xml', scene.replace(part, part + block.repeat(100_000 / block.length)));
  await editor.findings(large);
  const times = [];
  for (let i = 0; i < 11; ++i) {
    const key = performance.now();
    editor.change(large, large.positionAt(large.text.indexOf('translate')), large.positionAt(large.text.indexOf('translate')), 'x');
    await editor.findings(large);
    times.push(performance.now() - key);
  }
  times.sort((a, b) => a - b);

  await extension.deactivate();
  context.subscriptions.forEach((subscription) => subscription.dispose());
  console.log(`tried: right; from a key to its findings in 100 KB ${times[5].toFixed()} ms (median of 11)`);
})().catch((error) => {
  console.error(error);
  process.exit(1);
});
