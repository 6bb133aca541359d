// Runs the program with files in memory; the library's functions use this.

import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import process from 'node:process';

const require = createRequire(import.meta.url);
const folder = '/scene';

const text = new TextDecoder();

/** One loaded module. Its memory never shrinks: it keeps the size of its largest job. */
class Instance {
  #module;
  #job = null;

  static async load() {
    const instance = new Instance();
    const create = require('../wasm/scenefile-memory.cjs');
    instance.#module = await create({
      wasmBinary: readFileSync(new URL('../wasm/scenefile.wasm', import.meta.url)),
      preRun: [
        (m) =>
          m.FS.init(
            () => instance.#nextInput(),
            (byte) => byte !== null && instance.#job.stdout.push(byte & 255),
            (byte) => byte !== null && instance.#job.stderr.push(byte & 255),
          ),
      ],
    });
    return instance;
  }

  #nextInput() {
    const job = this.#job;
    return job.read < job.stdin.length ? job.stdin[job.read++] : null;
  }

  run(words, files, stdin, roots) {
    const { FS, callMain, stackSave, stackRestore } = this.#module;
    const mounted = [];
    this.#job = { stdin, read: 0, stdout: [], stderr: [] };
    const exitCode = process.exitCode;
    const stack = stackSave();
    FS.mkdirTree(folder);
    FS.chdir(folder);
    try {
      for (const [name, bytes] of files) {
        const path = inFolder(name);
        FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
        FS.writeFile(path, bytes);
      }
      for (const root of roots) {
        const at = `/root${mounted.length}`;
        FS.mkdirTree(at);
        FS.mount(FS.filesystems.NODEFS, { root }, at);
        mounted.push(at);
      }
      const status = callMain([...words, ...mounted.flatMap((at) => ['--asset-root', at])]);
      return {
        status,
        stdout: Uint8Array.from(this.#job.stdout),
        stderr: text.decode(Uint8Array.from(this.#job.stderr)),
        files: new Map(filesBelow(FS, folder).map((path) => [path.slice(folder.length + 1), FS.readFile(path)])),
      };
    } finally {
      process.exitCode = exitCode;
      stackRestore(stack);
      FS.chdir('/');
      for (const at of mounted) {
        FS.unmount(at);
        FS.rmdir(at);
      }
      removeAll(FS, folder);
    }
  }
}

/** The parts of a name, which cannot leave the folder. */
export function partsOf(name) {
  const parts = [];
  for (const part of name.replaceAll('\\', '/').split('/')) {
    if (part === '..') {
      if (parts.length === 0) {
        throw new RangeError(`${name} is outside the scene's folder`);
      }
      parts.pop();
    } else if (part !== '' && part !== '.') {
      parts.push(part);
    }
  }
  if (parts.length === 0) {
    throw new RangeError('a file needs a name');
  }
  return parts;
}

function inFolder(name) {
  return [folder, ...partsOf(name)].join('/');
}

function entries(FS, path) {
  return FS.readdir(path)
    .filter((name) => name !== '.' && name !== '..')
    .map((name) => `${path}/${name}`);
}

function isFolder(FS, path) {
  return FS.isDir(FS.stat(path).mode);
}

function filesBelow(FS, path) {
  return entries(FS, path).flatMap((entry) => (isFolder(FS, entry) ? filesBelow(FS, entry) : [entry]));
}

function removeAll(FS, path) {
  for (const entry of entries(FS, path)) {
    if (isFolder(FS, entry)) {
      removeAll(FS, entry);
    } else {
      FS.unlink(entry);
    }
  }
  FS.rmdir(path);
}

let loading = null;

function asBytes(content) {
  return typeof content === 'string' ? new TextEncoder().encode(content) : content;
}

/**
 * Runs `scenefile ...words` with access to `files` only. Resolves to its exit status,
 * the contents of both outputs, and all files that exist afterwards. `roots`: folders of this
 * machine that are also searched for textures and meshes.
 */
export async function run(words, { files = {}, stdin = '', roots = [] } = {}) {
  const given = new Map(
    [...(files instanceof Map ? files : Object.entries(files))].map(([name, content]) => [name, asBytes(content)]),
  );
  loading ??= Instance.load();
  try {
    return (await loading).run(words, given, asBytes(stdin), roots);
  } catch (error) {
    if (!(error instanceof RangeError)) {
      loading = null; // an instance that was aborted cannot be used again
    }
    throw error;
  }
}
