// Builds the page: node web/build.js MODULE_FOLDER OUTPUT. MODULE_FOLDER has scenefile-page.wasm,
// scenefile-page-tools.wasm and its JavaScript. Fails if the page is larger than its limits.

import { createHash } from 'node:crypto';
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { brotliCompressSync, constants, gzipSync } from 'node:zlib';

import { build } from 'esbuild';

const [modules, output] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const root = dirname(here);
const kilobyte = 1000;

/** The largest sizes in kilobytes of 1000 bytes, as servers send them. */
const limits = { module: 450, script: 160, start: 650, edit: 250 };

const examples = [
  { title: 'Ball on a board', path: 'hello.xml', files: [] },
  {
    title: 'Showcase: textures, mirrors, glass, a mesh',
    path: 'showcase.xml',
    files: ['image/bricks.png', 'image/floor.png', 'image/marble.png', 'image/planet.png', 'mesh/knot.obj'],
  },
  ...readdirSync(join(here, 'examples')).map((path) => ({
    title: /<!-- (.*?)[.:]? -->/.exec(readFileSync(join(here, 'examples', path), 'utf8'))?.[1] ?? path,
    path,
    files: [],
  })),
];

/** Modules that the sources import by name: JavaScript of the core, and generated ones. */
const made = (contents) => ({
  name: 'made',
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /^scenefile-/ }, ({ path }) =>
      path.startsWith('scenefile-page-')
        ? { path: resolve(modules, `${path}.js`) }
        : { path, namespace: 'made' },
    );
    onLoad({ filter: /.*/, namespace: 'made' }, ({ path }) => ({ contents: contents[path](), loader: 'js' }));
  },
});

const contents = {
  'scenefile-examples': () => `export default ${JSON.stringify(examples)}`,
  'scenefile-assets': () => {
    const files = filesBelow(output).sort();
    const hash = createHash('sha256');
    files.forEach((file) => hash.update(file).update(readFileSync(join(output, file))));
    return `export const files = ${JSON.stringify(['./', ...files])}; export const version = '${hash.digest('hex').slice(0, 16)}';`;
  },
};

function filesBelow(folder, base = folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) =>
    entry.isDirectory() ? filesBelow(join(folder, entry.name), base) : [relative(base, join(folder, entry.name))],
  );
}

const bundle = (name, more = { format: 'iife' }) =>
  build({
    entryPoints: [join(here, 'src', `${name}.js`)],
    outdir: output,
    bundle: true,
    minify: true,
    metafile: true,
    ...more,
    target: ['chrome103', 'firefox113', 'safari16.4'],
    legalComments: 'none',
    logLevel: 'warning',
    // The module's code for Node.js is never reached in a page.
    external: ['fs', 'path', 'crypto', 'ws'],
    nodePaths: [join(here, 'node_modules')],
    plugins: [made(contents)],
  });

rmSync(output, { recursive: true, force: true });
mkdirSync(output, { recursive: true });
// What the page rarely needs is in separate files, loaded on demand.
const { metafile } = await bundle('main', { format: 'esm', splitting: true });
await bundle('worker');
await bundle('view-worker');
for (const name of ['index.html', 'style.css', 'icon.svg', 'manifest.webmanifest']) {
  cpSync(join(here, 'src', name), join(output, name));
}
cpSync(join(modules, 'scenefile-page.wasm'), join(output, 'scenefile.wasm'));
for (const name of ['tools', 'view', 'edit']) {
  cpSync(join(modules, `scenefile-page-${name}.wasm`), join(output, `scenefile-${name}.wasm`));
}
for (const { path, files } of examples) {
  for (const name of [path, ...files]) {
    const own = join(here, 'examples', name);
    cpSync(existsSync(own) ? own : join(root, 'scenes', name), join(output, 'examples', name));
  }
}
cpSync(join(root, 'LICENSE'), join(output, 'LICENSE.txt'));
await bundle('service-worker'); // last: it knows all others

const read = (name) => readFileSync(join(output, name));
const brotli = (bytes) => brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_LGWIN]: 22 } }).length;
// The script and its static imports.
const imported = (path) => [
  path,
  ...metafile.outputs[path].imports.filter(({ kind }) => kind === 'import-statement').flatMap((other) => imported(other.path)),
];
const main = Object.keys(metafile.outputs).find((path) => path.endsWith('main.js'));
const sizes = {
  module: brotli(read('scenefile.wasm')),
  script: [...new Set(imported(main))].reduce((sum, path) => sum + gzipSync(readFileSync(path), { level: 9 }).length, 0),
};
sizes.start =
  sizes.module +
  sizes.script +
  ['worker.js', 'index.html', 'style.css', 'icon.svg', `examples/${examples[0].path}`].reduce((sum, name) => sum + gzipSync(read(name)).length, 0);
sizes.edit = brotli(read('scenefile-edit.wasm'));
const all = filesBelow(output).reduce((sum, file) => sum + statSync(join(output, file)).size, 0);
const names = { module: 'module (brotli)', script: 'script of the page (gzip)', start: 'editor and first picture', edit: 'module that edits (brotli)' };
let tooLarge = false;
for (const [key, size] of Object.entries(sizes)) {
  console.log(`${names[key]}: ${Math.ceil(size / kilobyte)} KB of at most ${limits[key]}`);
  tooLarge ||= size > limits[key] * kilobyte;
}
console.log(`${output}: ${Math.ceil(all / kilobyte)} KB in ${filesBelow(output).length} files`);
if (tooLarge) {
  console.error('the page exceeds its size limits');
  process.exitCode = 1;
}
