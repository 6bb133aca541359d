// The worker that checks, traces, explains, compares and converts.

import createScenefile from 'scenefile-page-tools';

import { answerOf, core, json, lastAnswer, pixelsOf, serve, text, withStack, words } from './core.js';

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

function written(answer) {
  return new Map(answer.files.map((name) => [name, core.FS.readFile(`/out/${name}`)]));
}

serve(createScenefile, {
  render({ options, x0, y0, x1, y1 }) {
    const pixels = core._page_render(...words(options), x0, y0, x1, y1);
    return pixelsOf(pixels, 4 * (x1 - x0) * (y1 - y0));
  },
  /** Adds samples to rows of a path-traced picture, for a short time. */
  pathAdd: ({ options, y0, y1 }) => json(core._page_path_add(...words(options), 0, y0, options.width, y1, 0.04)),
  /** The rows of the last pathAdd(). */
  pathPixels: ({ white, size }) => pixelsOf(core._page_path_pixels(white), size),
  explain: ({ options, x, y, mine }) =>
    json(core._page_explain(...words(options), x, y, ...(mine ?? [-1, -1, -1]))),
  explainText: ({ options, x, y }) => answerOf(core._page_explain_text(...words(options), x, y)),
  compare({ reference, test, options }) {
    const [profile, mode, features] = words(options);
    const answer = withBytes(reference.data, (a) =>
      withBytes(test.data, (b) =>
        withStack((string, doubles) =>
          json(
            core._page_compare(a, reference.width, reference.height, b, test.width, test.height, profile, mode, features,
              options.profile === 2 ? doubles(options.realtime) : 0),
          ),
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
    const path = '/out/picture';
    core.FS.writeFile(path, bytes);
    const pointer = withStack((string) => core._page_decode(string(path)));
    const { width, height } = json(lastAnswer(), `${path}: `);
    return { width, height, data: pixelsOf(pointer, 4 * width * height) };
  },
  png: ({ data, width, height }) =>
    withBytes(data, (at) => written(json(core._page_png(at, width, height))).get('picture.png')),
  convert({ path, to, options, course }) {
    const answer = withStack((string) =>
      json(core._page_convert(string(`/files/${path}`), string(to), words(options)[0], options.features, course ? 1 : 0)),
    );
    return { files: written(answer), findings: answer.scene.findings };
  },
  importModel({ path }) {
    const answer = withStack((string) => json(core._page_import(string(`/files/${path}`))));
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
});
