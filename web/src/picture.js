// The picture: drawn by several workers in strips, a coarse one first; from other viewpoints by
// orbiting, with quick previews; and compared with the user's own picture.

import { Engine, Stopped } from './engine.js';

const stripTime = 200; // milliseconds that a strip should take
const minRows = 8; // of a strip: each also traces rows around it
const frameTime = 45; // milliseconds for a preview
const patience = 120; // milliseconds for canceled work to finish, before its worker is terminated

const sleep = (time) => new Promise((resolve) => setTimeout(resolve, time));

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const plus = (a, b, factor = 1) => a.map((x, i) => x + factor * b[i]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

// Rodrigues' rotation about a unit axis.
function rotated(v, axis, angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return plus(plus(v.map((x) => x * c), cross(axis, v), s), axis, dot(axis, v) * (1 - c));
}

export class Picture {
  #engines;
  #tools = new Engine('scenefile-tools.wasm');
  #canvas;
  #ours = document.createElement('canvas');
  #mineCanvas = document.createElement('canvas');
  #maps = { difference: null, flip: null };
  #job = 0;
  #previewing = false;
  #settled = 0;
  #scene = null; // { path, text, files, filesVersion, version, course }
  #lookVersion = 0;
  #told;
  #scale = 4;

  options = { profile: 1, mode: 0, features: -1, width: 640, height: 480, samples: 0, maxDepth: -1 };
  pixels = null; // RGBA of the finished picture
  written = null; // the camera of the file
  camera = null; // after orbiting; null: that of the file
  mine = null; // { name, width, height, data }
  show = 'split';
  split = 0.5;

  constructor(canvas, count, told) {
    this.#canvas = canvas;
    this.#told = told; // progress, drawn, failed, compared, moved
    this.#engines = Array.from({ length: count }, () => new Engine());
    this.#resize();
  }

  get hasScene() {
    return this.#scene !== null;
  }

  // Sends files, scene and camera to a worker that lacks them.
  async #prepared(engine) {
    const scene = this.#scene;
    let opened = null;
    if (engine.generation !== scene.filesVersion) {
      await engine.call('files', { files: [...scene.files] });
      engine.generation = scene.filesVersion;
      engine.opened = -1;
    }
    if (engine.opened !== scene.version) {
      await engine.call('text', { path: scene.path, text: scene.text });
      opened = await engine.call('open', { path: scene.path, course: scene.course });
      engine.opened = scene.version;
      engine.looked = 0;
    }
    if (engine.looked !== this.#lookVersion) {
      await engine.call('look', { camera: this.camera && flat(this.camera) });
      engine.looked = this.#lookVersion;
    }
    return opened;
  }

  async #endOldWork() {
    this.#job += 1;
    const job = this.#job;
    if (this.#engines.some((engine) => engine.busy)) {
      await sleep(patience);
      if (job === this.#job) {
        this.#engines.filter((engine) => engine.busy).forEach((engine) => engine.stop());
      }
    }
    if (this.#tools.busy) {
      this.#tools.stop();
    }
    return job;
  }

  /** Opens another scene, or the same one after a change. Resolves to the core's answer about it. */
  async open(scene) {
    const job = await this.#endOldWork();
    if (job !== this.#job) {
      throw new Stopped('it was replaced', 'replaced');
    }
    this.#scene = scene;
    const opened = await this.#prepared(this.#engines[0]);
    if (opened !== null && opened.usable) {
      if (JSON.stringify(this.written) !== JSON.stringify(opened.camera)) {
        this.written = opened.camera;
        this.camera = null;
        this.#lookVersion += 1;
        this.#told.moved();
      }
    }
    return opened;
  }

  #resize() {
    const { width, height } = this.options;
    for (const canvas of [this.#canvas, this.#ours]) {
      if (canvas.width !== width || canvas.height !== height) {
        canvas.width = width;
        canvas.height = height;
      }
    }
    this.#canvas.classList.toggle('large', width < 320);
  }

  #putOurs({ data, width, height }, x = 0, y = 0) {
    const image = new ImageData(new Uint8ClampedArray(data.buffer, data.byteOffset, data.length), width, height);
    this.#ours.getContext('2d').putImageData(image, x, y);
  }

  #putScaled({ data, width, height }) {
    const small = document.createElement('canvas');
    small.width = width;
    small.height = height;
    small.getContext('2d').putImageData(new ImageData(new Uint8ClampedArray(data.buffer), width, height), 0, 0);
    this.#ours.getContext('2d').drawImage(small, 0, 0, this.#ours.width, this.#ours.height);
  }

  #paintAsked = false;
  /** Repaints at the next animation frame. */
  paint() {
    if (!this.#paintAsked) {
      this.#paintAsked = true;
      requestAnimationFrame(() => {
        this.#paintAsked = false;
        this.#paintNow();
      });
    }
  }

  #paintNow() {
    const context = this.#canvas.getContext('2d');
    const { width, height } = this.#canvas;
    const show = this.mine === null || this.camera !== null ? 'ours' : this.show;
    const map = this.#maps[show];
    if (map) {
      context.putImageData(new ImageData(new Uint8ClampedArray(map), width, height), 0, 0);
      return;
    }
    context.drawImage(this.#ours, 0, 0);
    if (show === 'mine') {
      context.drawImage(this.#mineCanvas, 0, 0, width, height);
    } else if (show === 'split') {
      const at = Math.round(this.split * width);
      context.drawImage(this.#mineCanvas, at, 0, width - at, height, at, 0, width - at, height);
      context.fillStyle = '#fff';
      context.fillRect(at - 1, 0, 2, height);
      context.fillStyle = '#000';
      context.fillRect(at + 1, 0, 1, height);
    }
  }

  /** Draws the picture; cancels a drawing in progress. */
  async draw() {
    if (this.#scene === null) {
      return;
    }
    const job = await this.#endOldWork();
    if (job !== this.#job) {
      return;
    }
    this.pixels = null;
    this.#maps = { difference: null, flip: null };
    this.#resize();
    const start = performance.now();
    const { width, height } = this.options;
    const pixels = new Uint8Array(4 * width * height);
    this.#told.progress(0);
    try {
      const small = { ...this.options, width: Math.ceil(width / 8), height: Math.ceil(height / 8), samples: 1 };
      await this.#prepared(this.#engines[0]);
      const coarse = await this.#renderWith(this.#engines[0], small, 0, small.height);
      if (job !== this.#job) {
        return;
      }
      this.#putScaled({ ...small, data: coarse });
      this.paint();
      await this.#drawStrips(job, pixels);
      if (job !== this.#job) {
        return;
      }
      this.pixels = pixels;
      this.paint();
      this.#told.drawn((performance.now() - start) / 1000);
      await this.#compare(job);
    } catch (error) {
      if (job === this.#job && error.reason !== 'replaced') {
        this.#job += 1;
        this.#engines.filter((engine) => engine.busy).forEach((engine) => engine.stop());
        this.#told.failed(error);
      }
    }
  }

  #renderWith(engine, options, y0, y1) {
    return engine.call('render', { options, x0: 0, x1: options.width, y0, y1 });
  }

  async #drawStrips(job, pixels) {
    const { options } = this;
    const { width, height } = options;
    let next = 0;
    let done = 0;
    let perRow = 0; // milliseconds that the previous strip took
    const most = Math.ceil(height / (2 * this.#engines.length));
    const work = async (engine) => {
      await this.#prepared(engine);
      while (job === this.#job && next < height) {
        const rows = perRow === 0 ? minRows : Math.max(minRows, Math.min(most, Math.round(stripTime / perRow)));
        const y0 = next;
        const y1 = Math.min(height, y0 + rows);
        next = y1;
        const begun = performance.now();
        const strip = await this.#renderWith(engine, options, y0, y1);
        if (job !== this.#job) {
          return;
        }
        perRow = (performance.now() - begun) / (y1 - y0);
        pixels.set(strip, 4 * width * y0);
        this.#putOurs({ data: strip, width, height: y1 - y0 }, 0, y0);
        this.paint();
        done += y1 - y0;
        this.#told.progress(done / height);
      }
    };
    await Promise.all(this.#engines.map(work));
  }

  /** Cancels the drawing in progress. */
  async stop() {
    await this.#endOldWork();
    this.#told.progress(1);
  }

  /** The current camera. */
  get view() {
    return this.camera ?? this.written;
  }

  #moveTo(camera) {
    this.camera = camera;
    this.#lookVersion += 1;
    this.#told.moved();
    clearTimeout(this.#settled);
    this.#settled = setTimeout(() => this.draw(), 300);
    this.#preview();
  }

  #distance() {
    const { position, w } = this.view;
    const toOrigin = dot(position, w);
    return toOrigin > 0.01 ? toOrigin : Math.max(1, Math.hypot(...position));
  }

  orbit(right, up) {
    const { position, u, v, w, fov_y } = this.view;
    const pivot = plus(position, w, -this.#distance());
    const vertical = Math.abs(this.written.v[1]) > 0.05 ? [0, Math.sign(this.written.v[1]), 0] : this.written.v;
    const turn = (x) => rotated(rotated(x, u, -up), vertical, -right);
    this.#moveTo({ position: plus(pivot, turn(plus(position, pivot, -1))), u: turn(u), v: turn(v), w: turn(w), fov_y });
  }

  move(right, up) {
    const { position, u, v, fov_y } = this.view;
    const size = 2 * Math.tan(fov_y / 2) * this.#distance();
    this.#moveTo({ ...this.view, position: plus(plus(position, u, right * size), v, up * size) });
  }

  closer(factor) {
    const { position, w } = this.view;
    this.#moveTo({ ...this.view, position: plus(position, w, (factor - 1) * this.#distance()) });
  }

  resetView() {
    this.camera = null;
    this.#lookVersion += 1;
    this.#told.moved();
    this.draw();
  }

  // Previews while the camera moves, as small as needed to be quick.
  async #preview() {
    if (this.#previewing || this.#scene === null) {
      return;
    }
    this.#previewing = true;
    this.#job += 1;
    const job = this.#job;
    try {
      let drawn = -1;
      while (drawn !== this.#lookVersion && job === this.#job) {
        drawn = this.#lookVersion;
        const begun = performance.now();
        const width = Math.max(16, Math.round(this.options.width / this.#scale));
        const height = Math.max(12, Math.round(this.options.height / this.#scale));
        const options = { ...this.options, width, height, samples: 1 };
        const count = this.#engines.length;
        const bands = await Promise.all(
          this.#engines.map(async (engine, i) => {
            await this.#prepared(engine);
            const y0 = Math.floor((height * i) / count);
            return this.#renderWith(engine, options, y0, Math.floor((height * (i + 1)) / count));
          }),
        );
        if (job !== this.#job) {
          return;
        }
        const data = new Uint8Array(4 * width * height);
        bands.reduce((at, band) => (data.set(band, at), at + band.length), 0);
        this.#putScaled({ data, width, height });
        this.paint();
        const factor = Math.sqrt((performance.now() - begun) / frameTime);
        this.#scale = Math.max(1, Math.min(12, this.#scale * Math.max(0.7, Math.min(1.6, factor))));
      }
    } catch (error) {
      if (error.reason !== 'replaced') {
        this.#told.failed(error);
      }
    } finally {
      this.#previewing = false;
    }
  }

  /** Explains a pixel: the document of `scenefile explain --json`, and its text. */
  async explain(x, y) {
    const [engine] = this.#engines;
    await this.#prepared(engine);
    const request = { options: this.options, x, y, mine: this.camera === null ? this.mineAt(x, y) : null };
    const document = await engine.call('explain', request);
    return { document, text: await engine.call('explainText', request) };
  }

  mineAt(x, y) {
    if (this.mine === null || x >= this.mine.width || y >= this.mine.height) {
      return null;
    }
    const at = 4 * (y * this.mine.width + x);
    return [...this.mine.data.subarray(at, at + 3)];
  }

  /** Sets the picture to compare with, as the bytes of its file; null for none. */
  async compareWith(name, bytes) {
    if (bytes === null) {
      this.mine = null;
      this.#maps = { difference: null, flip: null };
      this.paint();
      return;
    }
    const picture = await this.call('decode', { bytes });
    this.mine = { name, ...picture };
    const { width, height, data } = picture;
    this.#mineCanvas.width = width;
    this.#mineCanvas.height = height;
    this.#mineCanvas.getContext('2d').putImageData(new ImageData(new Uint8ClampedArray(data), width, height), 0, 0);
  }

  async #compare(job) {
    const { mine, options } = this;
    if (mine === null || this.camera !== null) {
      return;
    }
    if (mine.width !== options.width || mine.height !== options.height) {
      this.#told.compared({ otherSize: true });
      return;
    }
    this.#told.compared({ working: true });
    const reference = { width: options.width, height: options.height, data: this.pixels };
    await this.#prepared(this.#tools);
    const found = await this.#tools.call(
      'compare',
      { reference, test: mine, options, anyProfile: false },
      { timeout: 120_000 },
    );
    if (job === this.#job) {
      this.#maps = { difference: found.heat, flip: found.flip };
      this.#told.compared(found);
      this.paint();
    }
  }

  /** Any other call of the core, in the first worker. */
  async call(call, args, options) {
    const [engine] = this.#engines;
    if (this.#scene !== null) {
      await this.#prepared(engine);
    }
    return engine.call(call, args, options);
  }

  /** The scene as files of another format. */
  convert(scene, to) {
    return this.#tool('convert', scene, { to, options: this.options, course: scene.course });
  }

  /** The text, formatted. */
  format(scene) {
    return this.#tool('format', scene, {});
  }

  /** The text with the current camera. */
  writeView(scene) {
    const { position, v, w, fov_y } = this.view;
    const values = [...position, ...w.map((x) => -x), ...v, (fov_y * 180) / Math.PI];
    return this.#tool('editCamera', scene, { values });
  }

  async #tool(call, scene, args) {
    await this.#tools.call('files', { files: [...scene.files, [scene.path, scene.text]] });
    this.#tools.generation = -1; // no scene is open
    return this.#tools.call(call, { path: scene.path, ...args }, { timeout: 60_000 });
  }

  png() {
    const { width, height } = this.options;
    return this.#tools.call('png', { data: this.pixels, width, height });
  }
}

function flat({ position, u, v, w, fov_y }) {
  return [...position, ...u, ...v, ...w, fov_y];
}
