// The worker that draws with WebGL2, on a canvas of its own.

import createScenefile from 'scenefile-page-view';

import { core, json, pixelsOf, serve, withStack, words } from './core.js';

let canvas = null;
let context = null;

// Sets the size of the canvas, and calls `work` with a pointer to the settings of the profile realtime.
function atSize({ width, height, profile, realtime }, work) {
  if (context.isContextLost()) {
    throw Object.assign(new Error('the graphics driver was reset; try again'), { lost: true });
  }
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  return withStack((string, doubles) => work(profile === 2 ? doubles(realtime) : 0));
}

const picture = (options) => words(options).slice(0, 3);

serve(createScenefile, {
  begin() {
    canvas = typeof OffscreenCanvas === 'undefined' ? null : new OffscreenCanvas(1, 1);
    context = canvas?.getContext('webgl2', { alpha: false, antialias: false, depth: false });
    if (!context) {
      throw new Error('this browser has no WebGL2 for workers');
    }
    core.GL.makeContextCurrent(core.GL.registerContext(context, { majorVersion: 2, minorVersion: 0 }));
  },
  /** `options.draw`: a mode of OpenGL, or -1 for that of ray tracing. */
  draw: ({ options }) =>
    atSize(options, (realtime) => {
      const { draw, width, height } = options;
      const answer = json(core._page_view_draw(...picture(options), draw, width, height, realtime));
      return { ...answer, bitmap: canvas.transferToImageBitmap() };
    }),
  pick: ({ options, x, y }) =>
    atSize(options, (realtime) => {
      const { width, height } = options;
      return json(core._page_view_pick(...picture(options), width, height, realtime, x, y));
    }),
  /** The outline of what is in a part of the text, from line and column to line and column. */
  outline: ({ options, from, to }) =>
    atSize(options, (realtime) => {
      const { width, height } = options;
      const [profile] = picture(options);
      const pixels = core._page_view_outline(profile, width, height, realtime, ...from, ...to);
      json(core._page_answer());
      return pixels === 0 ? null : pixelsOf(pixels, 4 * width * height);
    }),
  helpers: ({ aspect }) => json(core._page_view_helpers(aspect)).helpers,
});
