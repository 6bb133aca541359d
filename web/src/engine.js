// Workers that run the core. A worker that takes too long, or whose instance ended, is terminated
// and replaced at the next request; it then gets the files and the scene again.

const loadTimeout = 60_000; // milliseconds until the module must be loaded

const compiled = new Map();

/** A module, loaded and compiled once. */
export function moduleOf(name) {
  if (!compiled.has(name)) {
    const module = load(name);
    compiled.set(name, module);
    module.catch(() => compiled.delete(name));
  }
  return compiled.get(name);
}

async function load(name) {
  const response = await fetch(name);
  if (!response.ok) {
    throw new Error('the page was not loaded completely; reload it');
  }
  // Some hosts do not send the type application/wasm, which streaming needs.
  return response.headers.get('content-type') === 'application/wasm'
    ? WebAssembly.compileStreaming(response)
    : WebAssembly.compile(await response.arrayBuffer());
}

/** A request that was canceled. */
export class Stopped extends Error {
  constructor(message, reason) {
    super(message);
    this.name = 'Stopped';
    this.reason = reason; // 'time', 'memory' or 'replaced'
  }
}

export class Engine {
  #module;
  #script;
  #worker = null;
  #ready = null;
  #waiting = new Map();
  #timer = 0; // of the request that the worker handles
  #next = 1;
  /** The versions of the files, the scene and the camera that this worker has. */
  generation = -1;
  opened = -1;
  looked = 0;

  /** With scenefile.wasm; scenefile-tools.wasm, which can also compare and convert; or scenefile-view.wasm. */
  constructor(module = 'scenefile.wasm', script = 'worker.js') {
    this.#module = module;
    this.#script = script;
  }

  /**
   * Sends files, scene and camera where the worker lacks them. `scene`: { path, text, files,
   * filesVersion, version, course, materials }; `look`: { version, camera }. Resolves to the core's answer
   * about a scene that it opened, else to null.
   */
  async prepare(scene, look) {
    let opened = null;
    if (this.generation !== scene.filesVersion) {
      await this.call('files', { files: [...scene.files] });
      this.generation = scene.filesVersion;
      this.opened = -1;
    }
    if (this.opened !== scene.version) {
      await this.call('text', { path: scene.path, text: scene.text });
      opened = await this.call('open', { path: scene.path, course: scene.course, materials: scene.materials });
      this.opened = scene.version;
      this.looked = 0;
    }
    if (this.looked !== look.version) {
      await this.call('look', { camera: look.camera });
      this.looked = look.version;
    }
    return opened;
  }

  async #start() {
    const worker = new Worker(this.#script);
    this.#worker = worker;
    this.generation = -1;
    this.opened = -1;
    worker.addEventListener('message', ({ data }) => this.#answer(worker, data));
    worker.addEventListener('error', (event) => {
      event.preventDefault();
      this.stop(new Stopped(event.message || 'a worker failed', 'memory'));
    });
    const module = await moduleOf(this.#module);
    if (worker !== this.#worker) {
      throw new Stopped('it was stopped', 'replaced');
    }
    return this.#post('init', { module }, [], loadTimeout);
  }

  #post(call, args, transfer, timeout) {
    return new Promise((resolve, reject) => {
      const id = this.#next++;
      this.#waiting.set(id, { resolve, reject, timeout });
      this.#worker.postMessage({ id, call, args }, transfer);
      if (this.#waiting.size === 1) {
        this.#restartTimer();
      }
    });
  }

  // The worker handles requests in order, and the time of each begins when the one before is answered.
  #restartTimer() {
    clearTimeout(this.#timer);
    const [first] = this.#waiting.values();
    if (first !== undefined) {
      this.#timer = setTimeout(() => {
        this.stop(new Stopped(`it took longer than ${Math.round(first.timeout / 1000)} seconds`, 'time'));
      }, first.timeout);
    }
  }

  #answer(worker, { id, value, error, fatal, lost }) {
    const request = this.#waiting.get(id);
    if (worker !== this.#worker || request === undefined) {
      return;
    }
    this.#waiting.delete(id);
    this.#restartTimer();
    if (fatal) {
      const stopped = new Stopped('it needs more memory than a page can use', 'memory');
      request.reject(stopped);
      this.stop(stopped);
    } else if (error !== undefined) {
      request.reject(new Error(error));
      if (lost) {
        this.stop();
      }
    } else {
      request.resolve(value);
    }
  }

  /** Terminates the worker; its requests fail with `reason`. */
  stop(reason = new Stopped('it was stopped', 'replaced')) {
    this.#worker?.terminate();
    this.#worker = null;
    this.#ready = null;
    this.generation = -1;
    this.opened = -1;
    clearTimeout(this.#timer);
    for (const { reject } of this.#waiting.values()) {
      reject(reason);
    }
    this.#waiting.clear();
  }

  get isStarted() {
    return this.#ready !== null;
  }

  get busy() {
    return this.#waiting.size > 0;
  }

  async call(call, args = {}, { timeout = 9_000, transfer = [] } = {}) {
    this.#ready ??= this.#start();
    const ready = this.#ready;
    try {
      await ready;
    } catch (error) {
      if (ready === this.#ready) {
        this.stop(error);
      }
      throw error;
    }
    if (ready !== this.#ready) {
      throw new Stopped('it was stopped', 'replaced');
    }
    return this.#post(call, args, transfer, timeout);
  }
}
