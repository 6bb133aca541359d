// A worker: one instance of the core, which handles one call at a time. Messages are
// { id, call, args }; answers are { id, value } or { id, error }, with `fatal` if the instance can no
// longer be used.

import createScenefile from 'scenefile-page-tools';

let core = null;
const text = new TextDecoder();

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

function answerOf(pointer) {
  const bytes = core.HEAPU8.subarray(pointer, pointer + core._page_answer_size());
  return text.decode(bytes);
}

// The module's own strings and arrays, on its stack.
function withStack(work) {
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

function withBytes(bytes, work) {
  const at = core._malloc(bytes.length);
  if (at === 0) {
    throw new Error('out of memory');
  }
  core.HEAPU8.set(bytes, at);
  try {
    return work(at);
  } finally {
    core._free(at);
  }
}

function json(pointer) {
  const answer = JSON.parse(answerOf(pointer));
  if (answer.error !== undefined) {
    throw new Error(answer.error);
  }
  return answer;
}

// A picture, or the reason why there is none, which is then in the last answer.
function pixelsOf(pointer, size) {
  if (pointer === 0) {
    json(lastAnswer());
  }
  return core.HEAPU8.slice(pointer, pointer + size);
}
const lastAnswer = () => core._page_answer();

const words = (o) => [o.profile, o.mode, o.features, o.width, o.height, o.samples, o.maxDepth];

function written(answer) {
  return new Map(answer.files.map((name) => [name, core.FS.readFile(`/out/${name}`)]));
}

const calls = {
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
  open: ({ path, course }) => withStack((string) => json(core._page_open(string(`/files/${path}`), course ? 1 : 0))),
  look: ({ camera }) => withStack((string, doubles) => core._page_look(camera === null ? 0 : doubles(camera))),
  render({ options, x0, y0, x1, y1 }) {
    const pixels = core._page_render(...words(options), x0, y0, x1, y1);
    return pixelsOf(pixels, 4 * (x1 - x0) * (y1 - y0));
  },
  explain: ({ options, x, y, mine }) =>
    json(core._page_explain(...words(options), x, y, ...(mine ?? [-1, -1, -1]))),
  explainText: ({ options, x, y }) => answerOf(core._page_explain_text(...words(options), x, y)),
  compare({ reference, test, options, anyProfile }) {
    const answer = withBytes(reference.data, (a) =>
      withBytes(test.data, (b) =>
        json(
          core._page_compare(a, reference.width, reference.height, b, test.width, test.height,
            anyProfile ? -1 : options.profile, options.mode, options.features),
        ),
      ),
    );
    const map = (which) => {
      const at = core._page_map(which);
      return at === 0 ? null : core.HEAPU8.slice(at, at + 4 * reference.width * reference.height);
    };
    return { answer, heat: map(0), flip: map(1) };
  },
  decode({ bytes }) {
    core.FS.mkdirTree('/out');
    core.FS.writeFile('/out/picture', bytes);
    const pointer = withStack((string) => core._page_decode(string('/out/picture')));
    const { width, height } = json(lastAnswer());
    return { width, height, data: pixelsOf(pointer, 4 * width * height) };
  },
  png: ({ data, width, height }) =>
    withBytes(data, (at) => written(json(core._page_png(at, width, height))).get('picture.png')),
  convert({ path, to, options, course }) {
    const answer = withStack((string) =>
      json(core._page_convert(string(`/files/${path}`), string(to), options.profile, options.features, course ? 1 : 0)),
    );
    return { files: written(answer), findings: answer.scene.findings };
  },
  format: ({ path }) =>
    withStack((string) => text.decode(written(json(core._page_format(string(`/files/${path}`)))).get('scene'))),
  editCamera: ({ path, values }) =>
    withStack((string, doubles) =>
      text.decode(
        written(json(core._page_edit_camera(string(`/files/${path}`), doubles(values)))).get('scene'),
      ),
    ),
  help: ({ code }) => withStack((string) => json(core._page_help(string(code)))),
};

function buffersIn(value) {
  if (value instanceof Uint8Array) {
    return [value.buffer];
  }
  return value !== null && typeof value === 'object' && !(value instanceof Map)
    ? Object.values(value).flatMap(buffersIn)
    : [];
}

async function handle({ id, call, args }) {
  try {
    if (call === 'init') {
      core = await createScenefile({
        instantiateWasm(imports, done) {
          WebAssembly.instantiate(args.module, imports).then((instance) => done(instance));
          return {};
        },
        print: () => {},
        printErr: () => {},
      });
      core.FS.mkdirTree('/files');
      core.FS.mkdirTree('/out');
      postMessage({ id });
      return;
    }
    const value = calls[call](args);
    postMessage({ id, value }, buffersIn(value));
  } catch (error) {
    // Traps (the stack or the memory is exhausted) and uncaught C++ exceptions end the instance.
    const fatal = error instanceof WebAssembly.RuntimeError || error instanceof WebAssembly.Exception;
    const message = error instanceof RangeError ? 'out of memory' : error.message;
    postMessage({ id, error: message ?? String(error), fatal });
  }
}

// Calls run one at a time, in order.
let last = Promise.resolve();
addEventListener('message', ({ data }) => {
  last = last.then(() => handle(data));
});
