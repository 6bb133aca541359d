// Serves a folder on this machine: node web/serve.js FOLDER [PORT]. Any static web host works as
// well.

import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, resolve, sep } from 'node:path';
import { pathToFileURL } from 'node:url';

const types = {
  '.css': 'text/css',
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.json': 'application/json',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
  '.xml': 'application/xml',
};

/** A server for the folder; not listening yet. */
export function serverOf(folder) {
  const root = resolve(folder);
  return createServer((request, response) => {
    let path;
    try {
      path = join(root, decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
    } catch {
      path = root;
    }
    if (path.endsWith(sep)) {
      path = join(path, 'index.html');
    }
    const found = path.startsWith(root + sep) && statSync(path, { throwIfNoEntry: false })?.isFile();
    if (!found || !['GET', 'HEAD'].includes(request.method)) {
      response.writeHead(found ? 405 : 404).end();
      return;
    }
    response.writeHead(200, { 'Content-Type': types[extname(path)] ?? 'application/octet-stream', 'Cache-Control': 'no-cache' });
    createReadStream(path).pipe(response);
  });
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [folder, port = '8123'] = process.argv.slice(2);
  serverOf(folder).listen(Number(port), '127.0.0.1', () => console.log(`http://localhost:${port} (stop with Ctrl-C)`));
}
