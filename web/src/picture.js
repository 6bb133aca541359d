// The picture: traced by several workers in strips, a coarse one first, or drawn by one with WebGL2;
// from other viewpoints by orbiting and flying, with quick previews; and compared with the user's own
// picture.

import { Engine, Stopped } from './engine.js';

const stripTime = 200; // milliseconds that a strip should take
const minRows = 8; // of a strip: each also traces rows around it
const frameTime = 45; // milliseconds for a preview
const patience = 50; // milliseconds for canceled work to finish, before its worker is terminated
const glPatience = 1000; // the same for WebGL2, whose worker takes longer to start again
const glTimeout = 30_000; // milliseconds; without a graphics card, the first drawing may take seconds
const coarse = 2; // traced previews are at most this much smaller, if WebGL2 is quicker
const passTime = 1000; // milliseconds between path-traced pictures with more and more samples
const pathSamples = 64; // of a finished one
const paths = 3; // the mode

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
  #gl = new Engine('scenefile-view.wasm', 'view-worker.js');
  #glBegun = 0;
  #glSeconds = Infinity; // that the last drawing with WebGL2 took
  #canvas;
  #ours = document.createElement('canvas');
  #mineCanvas = document.createElement('canvas');
  #maps = { difference: null, flip: null };
  #job = 0;
  #previewing = false;
  #settled = 0;
  #scene = null; // { path, text, files, filesVersion, version, course, materials }
  #opening = 0; // how many scenes are being opened; what is asked to be drawn meanwhile is drawn afterwards
  #litByFaces = false; // only by materials of faces that emit light
  #lookVersion = 0;
  #told;
  #scale = 4;

  // `mode`: -1: paths if only faces emit light, otherwise rays. `draw`: a mode of OpenGL; -1: traced. `realtime`: parameter 1, parameter 2, near, far, filter, milestone.
  options = { profile: 1, mode: -1, features: -1, width: 640, height: 480, samples: 0, maxDepth: -1, draw: -1, realtime: [5, 5, 0.1, 100, 0, 0] };
  pixels = null; // RGBA of the finished picture, or of one that is complete but for more samples
  viewport = [1, 1]; // the part of the picture, at its lower left, that shows what the camera sees
  written = null; // the camera of the file
  camera = null; // after orbiting; null: that of the file
  mine = null; // { name, width, height, data }
  show = 'split';
  split = 0.5;

  constructor(canvas, count, told) {
    this.#canvas = canvas;
    this.#told = told; // progress, drawn (and painted), failed, compared, moved
    this.#engines = Array.from({ length: count }, () => new Engine());
    this.#resize();
  }

  /** Whether WebGL2 draws the picture. */
  get isGl() {
    return this.options.profile === 2 || this.options.draw >= 0;
  }

  /** The mode of tracing. Only the profile fine has paths. */
  get mode() {
    const { mode, profile } = this.options;
    const wanted = mode >= 0 ? mode : this.#litByFaces ? paths : 0;
    return wanted === paths && profile !== 1 ? 0 : wanted;
  }

  get isPaths() {
    return !this.isGl && this.mode === paths;
  }

  // The options as the core gets them.
  get #asked() {
    return { ...this.options, mode: this.mode };
  }

  get hasScene() {
    return this.#scene !== null;
  }

  #prepared(engine) {
    return engine.prepare(this.#scene, { version: this.#lookVersion, camera: this.camera && flat(this.camera) });
  }

  // Ends what is no longer needed, since `canceled`. Resolves to a number that is #job until something else is.
  async #endOldWork(canceled = performance.now()) {
    this.#job += 1;
    const job = this.#job;
    while (job === this.#job && this.#engines.some((engine) => engine.busy)) {
      if (performance.now() - canceled < patience) {
        await sleep(5);
      } else {
        this.#engines.filter((engine) => engine.busy).forEach((engine) => engine.stop());
      }
    }
    if (job !== this.#job) {
      return job;
    }
    if (this.#tools.busy) {
      this.#tools.stop();
    }
    if (this.#gl.busy && performance.now() - this.#glBegun > glPatience) {
      this.#gl.stop();
    }
    return job;
  }

  /** Opens another scene, or the same one after a change at the time `changed`. Resolves to the core's answer about it. */
  async open(scene, changed) {
    this.#opening += 1;
    try {
      return await this.#open(scene, changed);
    } finally {
      this.#opening -= 1;
    }
  }

  async #open(scene, changed) {
    const job = await this.#endOldWork(changed);
    if (job !== this.#job) {
      throw new Stopped('it was replaced', 'replaced');
    }
    this.#scene = scene;
    const opened = await this.#prepared(this.#engines[0]);
    if (opened !== null && opened.usable) {
      this.#litByFaces = opened.lit_by_faces;
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
    if (this.#scene === null || this.#opening > 0) {
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
      if (this.isGl) {
        const drawn = await this.#drawGl(job);
        if (drawn === null) {
          return;
        }
        const { data } = this.#ours.getContext('2d').getImageData(0, 0, width, height);
        this.pixels = new Uint8Array(data.buffer);
        this.#paintNow();
        this.#told.drawn((performance.now() - start) / 1000, drawn);
        await this.#compare(job);
        return;
      }
      if (this.isPaths) {
        await this.#drawPaths(job, start);
        return;
      }
      const small = { ...this.#asked, width: Math.ceil(width / 8), height: Math.ceil(height / 8), samples: 1 };
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
      this.#paintNow();
      this.#told.drawn((performance.now() - start) / 1000);
      await this.#compare(job);
    } catch (error) {
      if (job === this.#job && error.reason !== 'replaced') {
        this.#job += 1;
        if (this.#gl.busy) {
          this.#gl.stop();
        }
        this.#engines.filter((engine) => engine.busy).forEach((engine) => engine.stop());
        this.#told.failed(error);
      }
    }
  }

  // Paints a picture drawn with WebGL2. Resolves to the core's answer, or null if it is obsolete.
  async #drawGl(job) {
    this.#glBegun = performance.now();
    const { bitmap, ...drawn } = await this.callGl('draw');
    this.#glSeconds = (performance.now() - this.#glBegun) / 1000;
    if (job === this.#job) {
      this.#ours.getContext('2d').drawImage(bitmap, 0, 0);
      this.viewport = drawn.viewport;
      this.paint();
    }
    bitmap.close();
    return job === this.#job ? drawn : null;
  }

  /** A call of the worker that draws with WebGL2. */
  async callGl(call, args = {}) {
    await this.#prepared(this.#gl);
    const options = this.#asked;
    const draw = options.profile === 2 ? Math.max(0, options.draw) : options.draw;
    return this.#gl.call(call, { options: { ...options, draw }, ...args }, { timeout: glTimeout });
  }

  /** Draws with WebGL2 once, so that previews can use it. */
  async warmUp() {
    if (this.#scene === null || this.#gl.isStarted) {
      return;
    }
    try {
      await this.callGl('draw');
      const begun = performance.now();
      (await this.callGl('draw')).bitmap.close();
      this.#glSeconds = (performance.now() - begun) / 1000;
    } catch {
      // Previews are traced.
    }
  }

  #renderWith(engine, options, y0, y1) {
    return engine.call('render', { options, x0: 0, x1: options.width, y0, y1 });
  }

  // Path-traced pictures with more and more samples.
  async #drawPaths(job, start) {
    const options = this.#asked;
    const { width, height } = options;
    const small = { ...options, width: Math.ceil(width / 8), height: Math.ceil(height / 8) };
    const first = await this.#pathPass(job, small, 4);
    if (first === null) {
      return;
    }
    this.#putScaled({ ...small, data: first });
    this.paint();
    let time = 0; // milliseconds for one sample of each pixel
    for (let samples = 0; samples < pathSamples;) {
      const begun = performance.now();
      const more = samples === 0 ? 1 : Math.max(1, Math.min(samples, pathSamples - samples, Math.floor(passTime / time)));
      const pixels = await this.#pathPass(job, options, samples + more);
      if (pixels === null) {
        return;
      }
      time = (performance.now() - begun) / more;
      samples += more;
      this.pixels = pixels;
      this.#putOurs({ data: pixels, width, height });
      this.paint();
      this.#told.progress(samples / pathSamples, `${samples} of ${pathSamples} samples`);
    }
    this.#paintNow();
    this.#told.drawn((performance.now() - start) / 1000);
    await this.#compare(job);
  }

  // The picture with that many samples, or null if it is obsolete. Each worker draws a part, and
  // all show the same luminance as white.
  async #pathPass(job, options, samples) {
    const { width, height } = options;
    const engines = this.#engines.slice(0, height);
    const startOf = (i) => Math.floor((height * i) / engines.length);
    const whites = await Promise.all(
      engines.map(async (engine, i) => {
        await this.#prepared(engine);
        while (job === this.#job) {
          const { complete, white } = await engine.call('pathAdd', { options: { ...options, samples }, y0: startOf(i), y1: startOf(i + 1) });
          if (complete) {
            return white;
          }
        }
        return 0;
      }),
    );
    if (job !== this.#job) {
      return null;
    }
    const white = Math.max(...whites);
    const parts = await Promise.all(
      engines.map((engine, i) => engine.call('pathPixels', { white, size: 4 * width * (startOf(i + 1) - startOf(i)) })),
    );
    if (job !== this.#job) {
      return null;
    }
    const pixels = new Uint8Array(4 * width * height);
    parts.forEach((part, i) => pixels.set(part, 4 * width * startOf(i)));
    return pixels;
  }

  async #drawStrips(job, pixels) {
    const options = this.#asked;
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

  #turning(u, right, up) {
    const vertical = Math.abs(this.written.v[1]) > 0.05 ? [0, Math.sign(this.written.v[1]), 0] : this.written.v;
    return (x) => rotated(rotated(x, u, -up), vertical, -right);
  }

  orbit(right, up) {
    const { position, u, v, w, fov_y } = this.view;
    const pivot = plus(position, w, -this.#distance());
    const turn = this.#turning(u, right, up);
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

  /** Turns the view without moving the camera. */
  turn(right, up) {
    const { position, u, v, w, fov_y } = this.view;
    const turn = this.#turning(u, right, up);
    this.#moveTo({ position, u: turn(u), v: turn(v), w: turn(w), fov_y });
  }

  /** Moves along the axes of the view, in multiples of the distance that `+` and `-` change. */
  fly(right, up, ahead) {
    const { position, u, v, w } = this.view;
    const by = Math.min(this.#distance(), 1000);
    this.#moveTo({ ...this.view, position: plus(plus(plus(position, u, right * by), v, up * by), w, -ahead * by) });
  }

  resetView() {
    this.camera = null;
    this.#lookVersion += 1;
    this.#told.moved();
    this.draw();
  }

  // Previews while the camera moves, as small as needed to be quick.
  async #preview() {
    if (this.#previewing || this.#scene === null || this.#opening > 0) {
      return;
    }
    this.#previewing = true;
    const job = await this.#endOldWork();
    try {
      let drawn = -1;
      while (drawn !== this.#lookVersion && job === this.#job) {
        drawn = this.#lookVersion;
        if (this.isGl || (!this.isPaths && this.#scale > coarse && this.#glSeconds < 2 * frameTime / 1000)) {
          await this.#drawGl(job);
          continue;
        }
        const begun = performance.now();
        const width = Math.max(16, Math.round(this.options.width / this.#scale));
        const height = Math.max(12, Math.round(this.options.height / this.#scale));
        const options = { ...this.#asked, width, height, samples: 1 };
        const data = await (this.isPaths ? this.#pathPass(job, options, 1) : this.#bands(job, options));
        if (data === null) {
          return;
        }
        this.#putScaled({ data, width, height });
        this.paint();
        const factor = Math.sqrt((performance.now() - begun) / frameTime);
        this.#scale = Math.max(1, Math.min(12, this.#scale * Math.max(0.7, Math.min(1.6, factor))));
      }
    } catch (error) {
      if (error.reason !== 'replaced') {
        this.#glSeconds = Infinity;
        this.#told.failed(error);
      }
    } finally {
      this.#previewing = false;
    }
  }

  // A whole picture, in one part for each worker; null if it is obsolete.
  async #bands(job, options) {
    const { width, height } = options;
    const count = this.#engines.length;
    const bands = await Promise.all(
      this.#engines.map(async (engine, i) => {
        await this.#prepared(engine);
        const y0 = Math.floor((height * i) / count);
        return this.#renderWith(engine, options, y0, Math.floor((height * (i + 1)) / count));
      }),
    );
    if (job !== this.#job) {
      return null;
    }
    const data = new Uint8Array(4 * width * height);
    bands.reduce((at, band) => (data.set(band, at), at + band.length), 0);
    return data;
  }

  /** Explains a pixel: the document of `scenefile explain --json`, and its text. */
  async explain(x, y) {
    const [engine] = this.#engines;
    await this.#prepared(engine);
    const request = { options: this.#asked, x, y, mine: this.camera === null ? this.mineAt(x, y) : null };
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
    const { mine } = this;
    const options = this.#asked;
    if (mine === null || this.camera !== null) {
      return;
    }
    if (this.isPaths) {
      this.#told.compared({ paths: true });
      return;
    }
    if (options.profile !== 2 && options.draw >= 0) {
      this.#told.compared({ openGl: true });
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
      { reference, test: mine, options },
      { timeout: 120_000 },
    );
    if (job === this.#job) {
      this.#maps = { difference: found.heat, flip: found.flip };
      this.#paintNow();
      this.#told.compared(found);
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

  /** A model of another program as the files of a scene, the scene first. */
  async importModel(files, path) {
    await this.#tools.call('files', { files: [...files] });
    this.#tools.generation = -1; // no scene is open
    return this.#tools.call('importModel', { path }, { timeout: 60_000 });
  }

  /** The scene as files of another format. */
  convert(scene, to) {
    return this.#tool('convert', scene, { to, options: this.#asked, course: scene.course });
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
