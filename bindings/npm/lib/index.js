// The library: the program's commands for scenes in memory. index.d.ts documents the functions.

import { partsOf, run } from './memory.js';
import { decodePng } from './png.js';

export { run };

const text = new TextDecoder();

/** Thrown if a scene cannot be drawn, explained, compared, formatted or converted. */
export class SceneError extends Error {
  constructor(message, status, findings) {
    super(message);
    this.name = 'SceneError';
    this.status = status;
    this.findings = findings;
  }
}

// Within the scene's folder. XML begins with <, JSON does not.
function nameOf(scene, options) {
  if (options.name !== undefined) {
    const parts = partsOf(options.name);
    return /^([a-z]:)?[/\\]/i.test(options.name) ? parts.at(-1) : parts.join('/');
  }
  const start = typeof scene === 'string' ? scene : text.decode(scene.subarray(0, 256));
  return start.trimStart().startsWith('<') ? 'scene.xml' : 'scene.json';
}

function filesOf(name, scene, options) {
  const files = new Map(options.files instanceof Map ? options.files : Object.entries(options.files ?? {}));
  return files.set(name, scene);
}

function commonWords(options) {
  return options.compatCourse ? ['--compat', 'course'] : [];
}

function lastLine(stderr) {
  return stderr.trimEnd().split('\n').at(-1) ?? '';
}

async function answerOf(words, files, roots) {
  const done = await run(words, { files, roots });
  if (done.stdout.length === 0) {
    throw new SceneError(lastLine(done.stderr), done.status, []);
  }
  const answer = JSON.parse(text.decode(done.stdout));
  // Only a run that failed as a whole has no more to say than why.
  if (Object.keys(answer).every((key) => ['scenefile', 'command', 'error'].includes(key))) {
    throw new SceneError(answer.error, done.status, []);
  }
  return { ...done, answer };
}

// Why there is no answer, with the findings of the scene.
async function failure(scene, options, { stderr, status }) {
  const message = stderr.match(/error: (.*)/)?.[1] ?? lastLine(stderr);
  return new SceneError(message, status, (await check(scene, options)).findings);
}

// The answer, unless it only says why there is none.
function usable({ answer, status }) {
  if (answer.error !== undefined) {
    const scenes = [answer.scene, answer.a, answer.b];
    throw new SceneError(answer.error, status, scenes.flatMap((scene) => scene?.findings ?? []));
  }
  return answer;
}

export async function check(scene, options = {}) {
  const name = nameOf(scene, options);
  const words = ['check', name, '--json', ...commonWords(options)];
  if (options.assets === false) {
    words.push('--no-assets');
  }
  if (options.strict) {
    words.push('--strict');
  }
  const { answer } = await answerOf(words, filesOf(name, scene, options), options.roots);
  return answer.scenes[0];
}

export async function read(scene, options = {}) {
  const name = nameOf(scene, options);
  const files = filesOf(name, scene, options);
  const { answer } = await answerOf(['info', name, '--json', '--files', ...commonWords(options)], files);
  return answer;
}

export async function format(scene, options = {}) {
  const name = nameOf(scene, options);
  const done = await run(['format', name], { files: filesOf(name, scene, options) });
  if (done.status !== 0) {
    throw await failure(scene, options, done);
  }
  return text.decode(done.files.get(name));
}

export async function convert(scene, to, options = {}) {
  const name = nameOf(scene, options);
  const out = `converted.${to}`;
  const words = ['convert', name, out, ...commonWords(options)];
  const files = filesOf(name, scene, options);
  const done = await run(words, { files });
  if (!done.files.has(out)) {
    throw await failure(scene, options, done);
  }
  const given = new Set([...files.keys()].map((file) => partsOf(file).join('/')));
  const others = new Map([...done.files].filter(([file]) => file !== out && !given.has(file)));
  return { bytes: done.files.get(out), files: others, messages: done.stderr };
}

function renderWords(options) {
  const words = ['--size', `${options.width ?? 640}x${options.height ?? 480}`];
  const add = (name, value) => value !== undefined && words.push(name, String(value));
  add('--profile', options.profile);
  add('--mode', options.mode);
  add('--features', options.features?.join(','));
  add('--samples', options.samples);
  add('--max-depth', options.maxDepth);
  add('--seed', options.seed);
  add('--crop', options.crop);
  if (options.allowMissing) {
    words.push('--allow-missing');
  }
  return [...words, ...commonWords(options)];
}

export async function render(scene, options = {}) {
  const name = nameOf(scene, options);
  const out = 'picture.png';
  const words = ['render', name, '-o', out, '--json', ...renderWords(options)];
  const { status, files, answer } = await answerOf(words, filesOf(name, scene, options));
  if (!files.has(out)) {
    throw new SceneError(answer.error ?? 'the scene cannot be drawn', status, answer.scene?.findings ?? []);
  }
  const png = files.get(out);
  return { ...decodePng(png), png, report: answer };
}

export async function explain(scene, x, y, options = {}) {
  const name = nameOf(scene, options);
  const words = ['explain', name, '--pixel', `${x},${y}`, '--json', ...renderWords(options)];
  return usable(await answerOf(words, filesOf(name, scene, options)));
}

export async function diff(a, b, options = {}) {
  const [nameA, nameB] = [`a/${nameOf(a, options)}`, `b/${nameOf(b, options)}`];
  const files = new Map([
    [nameA, a],
    [nameB, b],
  ]);
  return usable(await answerOf(['diff', nameA, nameB, '--json', ...commonWords(options)], files));
}
