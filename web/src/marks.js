// Marks over the picture: the outline of the selected part of the text, and lines that show where
// lights and camera are. Both come from the worker that draws with WebGL2.

import { byId, h } from './dom.js';
import { along, depthOf, projection } from './projection.js';

const colors = { selected: '#ff991a', light: '#ffe080', camera: '#d0d0d0' };
const outlined = ['primitive', 'group', 'instance', 'template'];

// Line and column of an offset, in the units of the core: columns count code points.
function placeOf(text, offset) {
  const before = text.slice(0, offset);
  const start = before.lastIndexOf('\n') + 1;
  return [before.split('\n').length, [...before.slice(start)].length + 1];
}

const isBefore = (a, b) => a[0] < b[0] || (a[0] === b[0] && a[1] < b[1]);

export class Marks {
  #host;
  #canvas = h('canvas', { id: 'marks', 'aria-hidden': 'true' });
  #range = null; // [from, to) of the selected item, as lines and columns
  #kind = '';
  #outline = null; // ImageBitmap of the selected item
  #helpers = null; // of the open scene
  #job = 0;

  /** `host`: text(), model() of the text, picture, all() whether all lights are shown, failed(error). */
  constructor(host) {
    this.#host = host;
    byId('stage').append(this.#canvas);
  }

  /** Selects the innermost item at an offset of the text. */
  selectAt(offset) {
    this.select(this.#host.model().itemAt(offset));
  }

  /** Selects an item of the text; null: none. */
  select(item) {
    const text = this.#host.text();
    this.#kind = item?.kind ?? '';
    this.#range = item === null || item.from < 0 ? null : [placeOf(text, item.from), placeOf(text, item.to)];
    this.#outline = null;
    this.show();
  }

  /** The text changed: what was selected may be elsewhere. */
  forget() {
    this.#range = null;
    this.#kind = '';
    this.#outline = null;
    this.#helpers = null;
    this.#job += 1;
    this.paint();
  }

  /** The camera moves: the outline is obsolete. */
  moved() {
    this.#outline = null;
    this.#job += 1;
    this.paint();
  }

  /** Brings outline and lines up to date with the picture. */
  async show() {
    this.#job += 1;
    const job = this.#job;
    const { picture } = this.#host;
    const wantsLines = this.#host.all() || this.#kind === 'light' || this.#kind === 'camera';
    this.paint();
    if (!picture.hasScene) {
      return;
    }
    try {
      const { width, height } = picture.options;
      if (wantsLines && this.#helpers === null) {
        const helpers = await picture.callGl('helpers', { aspect: width / height });
        if (job !== this.#job) {
          return;
        }
        this.#helpers = helpers;
      }
      if (outlined.includes(this.#kind)) {
        const [from, to] = this.#range;
        const rgba = await picture.callGl('outline', { from, to });
        const bitmap = rgba && (await createImageBitmap(new ImageData(new Uint8ClampedArray(rgba.buffer), width, height)));
        if (job !== this.#job) {
          return;
        }
        this.#outline = bitmap;
      }
      this.paint();
    } catch (error) {
      if (job === this.#job && error.reason !== 'replaced') {
        this.#host.failed(error);
      }
    }
  }

  paint() {
    const { picture } = this.#host;
    const shown = byId('canvas');
    const { width, height } = shown;
    const box = shown.getBoundingClientRect();
    const stage = byId('stage').getBoundingClientRect();
    const canvas = this.#canvas;
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width;
      canvas.height = height;
    }
    Object.assign(canvas.style, { left: `${box.left - stage.left}px`, top: `${box.top - stage.top}px`, width: `${box.width}px`, height: `${box.height}px` });
    const context = canvas.getContext('2d');
    context.clearRect(0, 0, width, height);
    if (this.#outline !== null && this.#outline.width === width) {
      context.drawImage(this.#outline, 0, 0);
    }
    if (picture.view !== null) {
      this.#paintLines(context, picture, (1.5 * width) / Math.max(1, box.width));
    }
    canvas.dataset.outline = String(this.#outline !== null);
  }

  #paintLines(context, picture, lineWidth) {
    const { view } = picture;
    const project = projection(view, context.canvas.width, context.canvas.height, picture.viewport);
    let count = 0;
    for (const { kind, line, column, lines } of this.#helpers ?? []) {
      const isSelected = this.#kind === kind && line !== undefined && this.#range !== null &&
        !isBefore([line, column], this.#range[0]) && isBefore([line, column], this.#range[1]);
      // The camera is only visible from elsewhere.
      if ((!this.#host.all() && !isSelected) || (kind === 'camera' && picture.camera === null)) {
        continue;
      }
      context.strokeStyle = isSelected ? colors.selected : colors[kind];
      context.lineWidth = lineWidth;
      context.beginPath();
      for (const ends of lines) {
        const [a, b] = clipped(view, ...ends).map(project);
        if (a && b) {
          context.moveTo(...a);
          context.lineTo(...b);
          count += 1;
        }
      }
      context.stroke();
    }
    context.canvas.dataset.lines = String(count);
  }
}

// The part of a line in front of the camera.
function clipped(view, a, b) {
  const near = 1e-3;
  const [from, to] = [depthOf(view, a), depthOf(view, b)];
  const cut = () => along(a, along(b, a, -1), (near - from) / (to - from));
  return from < near && to >= near ? [cut(), b] : to < near && from >= near ? [a, cut()] : [a, b];
}
