// What the workers share: an instance of the core, which handles one call at a time. Messages are
// { id, call, args }; answers are { id, value } or { id, error }, with `fatal` if the instance can no
// longer be used, and `lost` if only another worker can draw.

import { instanceOf } from './instance.js';

export let core = null;
export const text = new TextDecoder();

const toBytes = (content) => (typeof content === 'string' ? new TextEncoder().encode(content) : content);

function makeFolder(path) {
  core.FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
}

function remove(path) {
  const { FS } = core;
  if (FS.isDir(FS.stat(path).mode)) {
    for (const name of FS.readdir(path)) {
      if (name !== '.' && name !== '..') {
        remove(`${path}/${name}`);
      }
    }
    FS.rmdir(path);
  } else {
    FS.unlink(path);
  }
}

export function answerOf(pointer) {
  const bytes = core.HEAPU8.subarray(pointer, pointer + core._page_answer_size());
  return text.decode(bytes);
}

/** Calls `work` with functions that put strings and arrays on the module's stack. */
export function withStack(work) {
  const stack = core.stackSave();
  const string = (value) => {
    const bytes = toBytes(value);
    const at = core.stackAlloc(bytes.length + 1);
    core.HEAPU8.set(bytes, at);
    core.HEAPU8[at + bytes.length] = 0;
    return at;
  };
  const doubles = (values) => {
    const at = (core.stackAlloc(8 * values.length + 8) + 7) & ~7;
    core.HEAPF64.set(values, at / 8);
    return at;
  };
  try {
    return work(string, doubles);
  } finally {
    core.stackRestore(stack);
  }
}

function buffersIn(value) {
  if (value instanceof Uint8Array) {
    return [value.buffer];
  }
  if (value instanceof ImageBitmap) {
    return [value];
  }
  return value !== null && typeof value === 'object' && !(value instanceof Map)
    ? Object.values(value).flatMap(buffersIn)
    : [];
}

/** `prefix`: what to leave out at the start of an error. */
export function json(pointer, prefix = '') {
  const answer = JSON.parse(answerOf(pointer));
  if (answer.error !== undefined) {
    throw new Error(answer.error.replace(prefix, ''));
  }
  return answer;
}

/** A picture, or the reason why there is none, which is then in the last answer. */
export function pixelsOf(pointer, size) {
  if (pointer === 0) {
    json(lastAnswer());
  }
  return core.HEAPU8.slice(pointer, pointer + size);
}
export const lastAnswer = () => core._page_answer();

/** The arguments of a picture that most functions of the core share. Realtime reads models as the profile fine does. */
export const words = (o) => [o.profile === 0 ? 0 : 1, o.mode, o.features, o.width, o.height, o.samples, o.maxDepth];

const common = {
  /** All files that a scene may use, by path. */
  files({ files }) {
    remove('/files');
    core.FS.mkdirTree('/files');
    for (const [path, bytes] of files) {
      makeFolder(`/files/${path}`);
      core.FS.writeFile(`/files/${path}`, toBytes(bytes));
    }
  },
  text({ path, text: content }) {
    makeFolder(`/files/${path}`);
    core.FS.writeFile(`/files/${path}`, toBytes(content));
  },
  check: ({ path, depth, course }) =>
    withStack((string) => json(core._page_check(string(`/files/${path}`), depth, course ? 1 : 0))),
  open: ({ path, course, materials }) =>
    withStack((string) => json(core._page_open(string(`/files/${path}`), course ? 1 : 0, materials ? 1 : 0))),
  look: ({ camera }) => withStack((string, doubles) => core._page_look(camera === null ? 0 : doubles(camera))),
  help: ({ code }) => withStack((string) => json(core._page_help(string(code)))),
};

async function handle(createScenefile, calls, { id, call, args }) {
  try {
    if (call === 'init') {
      core = await instanceOf(createScenefile, args.module);
      core.FS.mkdirTree('/files');
      core.FS.mkdirTree('/out');
      calls.begin?.();
      postMessage({ id });
      return;
    }
    const value = calls[call](args);
    postMessage({ id, value }, buffersIn(value));
  } catch (error) {
    // Traps (the stack or the memory is exhausted) and uncaught C++ exceptions end the instance.
    const fatal = error instanceof WebAssembly.RuntimeError || error instanceof WebAssembly.Exception;
    const message = error instanceof RangeError ? 'out of memory' : error.message;
    postMessage({ id, error: message ?? String(error), fatal, lost: error.lost });
  }
}

/** Answers messages. `own`: the calls of this worker, and begin(), which is called once. */
export function serve(createScenefile, own) {
  const calls = { ...common, ...own };
  // Calls run one at a time, in order.
  let last = Promise.resolve();
  addEventListener('message', ({ data }) => {
    last = last.then(() => handle(createScenefile, calls, data));
  });
}
