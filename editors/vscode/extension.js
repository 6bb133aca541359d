// Starts `scenefile lsp` and connects it with the editor. The server does the work.

const { workspace, window, commands } = require('vscode');
const { LanguageClient } = require('vscode-languageclient/node');

let client = null;

async function start() {
  const settings = workspace.getConfiguration('scenefile');
  const command = settings.get('command');
  client = new LanguageClient(
    'scenefile',
    'Scene files',
    // On Windows, npm installs programs as .cmd files, which only a shell can start.
    { command, args: ['lsp'], options: { shell: process.platform === 'win32' } },
    {
      documentSelector: settings
        .get('files')
        .flatMap((pattern) => ['file', 'untitled'].map((scheme) => ({ scheme, pattern }))),
    },
  );
  try {
    await client.start();
  } catch (error) {
    client = null;
    window.showErrorMessage(
      `cannot start ${command} lsp: ${error.message}. Install scenefile, or set scenefile.command.`,
    );
  }
}

async function stop() {
  const ended = client;
  client = null;
  await ended?.stop();
}

async function restart() {
  await stop();
  await start();
}

exports.activate = async (context) => {
  context.subscriptions.push(
    commands.registerCommand('scenefile.restart', restart),
    workspace.onDidChangeConfiguration((change) => change.affectsConfiguration('scenefile') && restart()),
  );
  await start();
};
exports.deactivate = stop;
