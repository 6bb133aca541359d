// The page: opens, checks, draws, explains and saves scenes, in response to events.

import examples from 'scenefile-examples';
import { afterPause, byId, download, h } from './dom.js';
import { Editor } from './editor.js';
import { Engine } from './engine.js';
import { explanation, lineOfObject } from './explain.js';
import { baseName, fromDrop, fromInput, isMeshName, isModelName, isPictureName, isSceneName, packed, pictureEndings, readAll } from './files.js';
import { linkOf, sceneOf } from './link.js';
import { Picture } from './picture.js';
import * as store from './store.js';

const emptyScene = `<scenefile>
  <cameradata>
    <pos x="3" y="3" z="5"/>
    <focus x="0" y="0" z="0"/>
    <up x="0" y="1" z="0"/>
    <heightangle v="30"/>
  </cameradata>

  <lightdata>
    <id v="0"/>
    <color r="1" g="1" b="1"/>
    <position x="3" y="5" z="4"/>
  </lightdata>

  <object type="tree" name="root">
    <transblock>
      <object type="primitive" name="cube">
        <diffuse r="0.5" g="0.6" b="0.8"/>
        <ambient r="0.2" g="0.2" b="0.25"/>
      </object>
    </transblock>
  </object>
</scenefile>
`;

const featureNames = ['shadows', 'reflect', 'refract', 'texture', 'texture-filter', 'super-sample', 'depthoffield'];
const sizes = [[320, 240], [640, 480], [1024, 768], [1280, 720], [1920, 1080]];

const text = new TextDecoder();
const workers = Math.max(1, Math.min(navigator.hardwareConcurrency || 2, 8));

// What is open in this tab. `files`: all files other than the scene, by path. `stored`: not for links and examples until
// they are edited.
const scene = { id: '', path: 'scene.xml', files: new Map(), filesVersion: 0, version: 0, unsafe: false, filesSaved: true, stored: false };

const checker = new Engine();
let panel = null; // EditPanel, once it has been shown
let marks = null; // Marks, once something has been selected

// What the text consists of and what can be written in it, loaded when it is first needed.
const editEngine = async () => (await import('./edit/scene-text.js')).editEngine();

const editor = new Editor(byId('editor'), {
  engine: editEngine,
  changed: (changes) => {
    scene.version += 1;
    scene.unsafe = false;
    marks?.forget();
    panelFollows(changes);
    checkSoon();
    edited();
  },
  moved: (line) => !panelIsShown() && mark((some) => some.selectAt(editor.offsetOfLine(line))),
});

const setBusy = (busy) => byId('canvas').setAttribute('aria-busy', String(busy));

const picture = new Picture(byId('canvas'), workers, {
  progress(done, what = `${Math.floor(100 * done)} %`) {
    setBusy(done < 1);
    byId('stop').hidden = done >= 1;
    byId('progress').textContent = done >= 1 ? '' : what;
  },
  drawn(seconds, withGl) {
    store.end(scene.id);
    if (!scene.unsafe) {
      clearNotice('stopped');
    }
    setBusy(false);
    byId('stop').hidden = true;
    byId('progress').textContent = `drawn in ${seconds.toFixed(2)} s${withGl ? `, ${withGl.triangles} ${picture.options.draw === 1 ? 'lines' : 'triangles'}` : ''}`;
    byId('left-out').textContent = (withGl && picture.options.profile !== 2 ? withGl.left_out : []).join('; ');
    marks?.show();
    byId('canvas').dataset.drawn = String(Number(byId('canvas').dataset.drawn ?? 0) + 1);
    panel?.viewChanged(panelIsShown());
  },
  failed: stopped,
  compared: showComparison,
  moved() {
    setBusy(true);
    const elsewhere = picture.camera !== null;
    byId('view-reset').disabled = !elsewhere;
    byId('view-write').disabled = !elsewhere;
    byId('cross').hidden = true;
    marks?.moved();
    panel?.viewChanged(panelIsShown());
  },
});

// Notices stay until something replaces or closes them.

function notice(key, message, { kind = '', actions = [] } = {}) {
  clearNotice(key);
  byId('notices').append(
    h('div', { className: `notice ${kind}`, 'data-key': key, role: kind === 'error' ? 'alert' : 'status' },
      h('span', {}, message),
      ...actions.map(([name, act]) => h('button', { type: 'button', onclick: act }, name)),
      h('button', { type: 'button', 'aria-label': 'Close the message', onclick: () => clearNotice(key) }, '×'),
    ),
  );
}

function clearNotice(key) {
  byId('notices').querySelector(`[data-key="${key}"]`)?.remove();
}

// A scene that exceeded the limits of time or memory is only tried again after it has changed.
function stopped(error) {
  store.end(scene.id);
  setBusy(false);
  byId('stop').hidden = true;
  byId('progress').textContent = '';
  if (error.reason === 'time' || error.reason === 'memory') {
    scene.unsafe = true;
    saveSoon();
    notice('stopped', `Stopped: ${error.message}. Change the scene, or try again.`, {
      kind: 'error',
      actions: [['Try again', () => run({ anyway: true })]],
    });
  } else {
    notice('stopped', `The picture cannot be drawn: ${error.message}.`, { kind: 'error' });
  }
}

function failed(error) {
  notice('failed', error.message, { kind: 'error' });
}

// Checks the text, and draws it if it can be drawn.

let checking = false;
let checkAgain = false;

const checkSoon = afterPause(20, () => run());

const sceneNow = () => ({
  path: scene.path,
  text: editor.text,
  files: scene.files,
  filesVersion: scene.filesVersion,
  version: scene.version,
  course: readsLikeCourse(),
  materials: picture.options.mode === 3, // without lights, they are always read
});

// As with the same profile of the program.
const readsLikeCourse = () => byId('course-reading').checked || picture.options.profile !== 1;

async function run({ anyway = false } = {}) {
  if (anyway) {
    scene.unsafe = false;
    clearNotice('stopped');
  }
  if (checking) {
    checkAgain = true;
    return;
  }
  checking = true;
  try {
    do {
      checkAgain = false;
      await checkAndDraw();
    } while (checkAgain);
  } finally {
    checking = false;
  }
}

async function checkAndDraw() {
  const now = sceneNow();
  if (scene.unsafe) {
    return;
  }
  const begun = performance.now();
  let checked;
  try {
    if (checker.generation !== now.filesVersion) {
      await checker.call('files', { files: [...now.files] });
      checker.generation = now.filesVersion;
    }
    await checker.call('text', { path: now.path, text: now.text });
    checked = await checker.call('check', { path: now.path, depth: 0, course: now.course });
    byId('findings').dataset.milliseconds = String(performance.now() - begun);
  } catch (error) {
    stopped(error);
    return;
  }
  if (now.version !== scene.version) {
    checkAgain = true;
    return;
  }
  clearNotice('stopped');
  showMissing(checked.files ?? []);
  if (!checked.usable) {
    showFindings(checked.scene);
    byId('verdict').textContent += picture.hasScene ? '; the picture shows the last version without errors' : '';
    return;
  }
  store.begin(scene.id);
  byId('stop').hidden = true;
  picture.open(now, begun).then(
    (opened) => {
      if (now.version !== scene.version) {
        return;
      }
      if (opened !== null) {
        showOptions(); // the scene may choose the mode
        showFindings(opened.scene);
      }
      if (opened === null || opened.usable) {
        picture.draw();
      } else {
        store.end(scene.id);
      }
    },
    (error) => error.reason !== 'replaced' && stopped(error),
  );
}

function showFindings({ findings, errors, warnings, not_listed: more, error }) {
  editor.showFindings(findings);
  const count = (n, word) => `${n} ${word}${n === 1 ? '' : 's'}`;
  const verdict = byId('verdict');
  verdict.className = errors > 0 || error ? 'errors' : warnings > 0 ? 'warnings' : '';
  verdict.textContent = error ?? (errors + warnings === 0 ? 'no errors, no warnings' : `${count(errors, 'error')}, ${count(warnings, 'warning')}`);
  byId('findings').replaceChildren(
    ...findings.slice(0, 200).map(findingItem),
    ...(more > 0 ? [h('li', {}, `and ${more} more`)] : []),
  );
}

function findingItem(finding) {
  const { code, severity, message, line, column, file, notes = [] } = finding;
  const place = line === undefined ? null : `line ${line}, column ${column}`;
  const correction = file === undefined && line !== undefined ? editor.correctionOf(finding) : null;
  const help = h('p', { className: 'help', hidden: true });
  const explain = async () => {
    help.textContent = help.hidden && help.textContent === '' ? (await checker.call('help', { code })).help : help.textContent;
    help.hidden = !help.hidden;
  };
  return h(
    'li',
    { className: severity },
    h('span', { className: 'severity' }, `${severity}: `),
    file === undefined ? null : `${file}: `,
    message,
    ' ',
    place === null || file !== undefined
      ? place
      : h('button', { className: 'link', type: 'button', onclick: () => (showTab('text'), editor.selectPlace(line, column)) }, place),
    ' ',
    h('button', { className: 'link', type: 'button', onclick: explain, 'aria-label': `What ${code} means` }, 'why?'),
    correction === null ? null : [' ', h('button', { type: 'button', onclick: correction.apply }, correction.title)],
    notes.map((note) => h('div', { className: 'help' }, note)),
    help,
  );
}

function showMissing(files) {
  const missing = files.filter(({ found }) => !found);
  const box = byId('missing');
  box.hidden = missing.length === 0;
  box.replaceChildren(
    `${missing.length === 1 ? 'A file is' : `${missing.length} files are`} missing:`,
    h('ul', {}, missing.slice(0, 50).map(({ name, kind }) => h('li', {}, `${name} (${kind})`))),
    h('button', { type: 'button', onclick: () => byId('file-input').click() }, 'Add files…'), ' ',
    h('button', { type: 'button', onclick: () => byId('folder-input').click() }, 'Add a folder…'),
  );
}

// Opening.

function setDocument({ id = store.newId(), path, content, files = new Map(), options = null, unsafe = false, stored = true, linked = false }) {
  saveAfterPause.now();
  if (!linked) {
    leaveLink();
  }
  store.end(scene.id);
  if (scene.id !== '' && scene.id !== id) {
    store.release(scene.id);
  }
  Object.assign(scene, { id, path, files, unsafe, stored, filesVersion: scene.filesVersion + 1, version: scene.version + 1, filesSaved: false });
  store.setTabDocument(id);
  store.hold(id);
  byId('name').value = baseName(path);
  document.title = `${baseName(path)} – scenefile`;
  for (const key of ['stopped', 'failed', 'scenes', 'opened', 'converted', 'encoding']) {
    clearNotice(key);
  }
  closeComparison();
  byId('explain-result').replaceChildren();
  byId('cross').hidden = true;
  byId('left-out').textContent = '';
  marks?.forget();
  picture.camera = picture.written = null; // until the scene is open
  byId('view-reset').disabled = byId('view-write').disabled = true;
  applyOptions(options);
  byId('findings').replaceChildren();
  byId('verdict').textContent = '';
  editor.open(content);
  panelFollows(null);
  saveSoon();
  if (unsafe) {
    notice('stopped', 'This scene did not finish last time. It is not drawn again until you press the button or change it.', {
      actions: [['Draw it', () => run({ anyway: true })]],
    });
  } else {
    run();
  }
}

async function take(list, forComparison = false) {
  let files;
  try {
    files = await readAll(list);
  } catch (error) {
    failed(error);
    return;
  }
  clearNotice('opened');
  if (files.size === 0) {
    notice('opened', 'There is nothing to open: no files, or only hidden ones.');
    return;
  }
  const scenes = [...files.keys()].filter(isSceneName);
  const [[firstPath, firstBytes]] = files;
  const wanted = new Set([...(await namedFiles())].map((name) => baseName(name.replaceAll('\\', '/')).toLowerCase()));
  const isWanted = (path) => wanted.has(baseName(path).toLowerCase());
  if (forComparison || (files.size === 1 && isPictureName(firstPath) && !isWanted(firstPath))) {
    compareWith(baseName(firstPath), firstBytes);
    return;
  }
  const model = [...files.keys()].find(isModelName);
  // The scene may be waiting for this mesh; glTF files cannot be meshes of a scene.
  if (scenes.length === 0 && model !== undefined && !isWanted(model)) {
    await openModel(files, model);
    return;
  }
  if (scenes.length === 0) {
    addFiles(files, isWanted);
    return;
  }
  openFrom(files, scenes[0]);
}

// Adds files to the scene. Those that no scene can use are not kept.
function addFiles(files, isWanted) {
  const isUsable = (path) => isWanted(path) || isPictureName(path) || isMeshName(path);
  const [usable, others] = [isUsable, (path) => !isUsable(path)].map((which) => [...files.keys()].filter(which));
  const named = (paths) => `${baseName(paths[0])}${paths.length > 1 ? ` and ${paths.length - 1} more` : ''}`;
  const messages = [];
  if (others.length > 0) {
    messages.push(others.length === 1
      ? `${named(others)} is neither a scene, a picture, a mesh nor a zip file.`
      : `${named(others)} are neither scenes, pictures, meshes nor zip files.`);
  }
  if (usable.length > 0 && !usable.some(isWanted)) {
    messages.push(`${named(usable)} ${usable.length === 1 ? 'was' : 'were'} added, but the scene does not name ${usable.length === 1 ? 'it' : 'them'}.`);
  }
  if (messages.length > 0) {
    notice('opened', messages.join(' '));
  }
  if (usable.length === 0) {
    return;
  }
  usable.forEach((path) => scene.files.set(path, files.get(path)));
  scene.filesVersion += 1;
  scene.version += 1;
  scene.filesSaved = false;
  edited();
  run();
}

// Opens a glTF or OBJ file as a new scene.
async function openModel(files, path) {
  try {
    const { files: made, findings } = await picture.importModel(files, path);
    const messages = findings.filter(({ severity }) => severity !== 'note').map(({ message }) => message);
    if (made.size === 0) {
      throw new Error(messages[0] ?? 'it has no contents');
    }
    const [[scenePath, content], ...others] = made;
    setDocument({ path: baseName(path).replace(/\.\w+$/, scenePath.slice(scenePath.lastIndexOf('.'))), content: text.decode(content), files: new Map(others) });
    if (messages.length > 0) {
      notice('converted', messages.slice(0, 5).join('; '));
    }
  } catch (error) {
    failed(new Error(`${baseName(path)} cannot be imported: ${error.message}`));
  }
}

// The text of a scene's bytes, and whether its encoding was guessed. It is saved in UTF-8, so a declaration of another
// encoding becomes one of UTF-8.
function sceneText(bytes) {
  if (bytes.every((byte) => byte < 128)) {
    return [text.decode(bytes), false];
  }
  const declaration = /^(<\?xml[^>]*\sencoding\s*=\s*)(["'])([^"'>]*)\2/;
  const declared = declaration.exec(new TextDecoder('latin1').decode(bytes.subarray(0, 200)))?.[3];
  const mark = (bytes[0] << 8) | bytes[1];
  const encoding = mark === 0xfffe ? 'utf-16le' : mark === 0xfeff ? 'utf-16be' : (declared ?? 'utf-8');
  const decoded = (name) => new TextDecoder(name, { fatal: true }).decode(bytes);
  try {
    return [/^utf-?8$/i.test(encoding) ? decoded('utf-8') : decoded(encoding).replace(declaration, '$1$2UTF-8$2'), false];
  } catch {
    // The encoding is not known, or the bytes are not in it.
  }
  try {
    return [decoded('utf-8'), false];
  } catch {
    return [decoded('windows-1252'), true];
  }
}

// `files`: contents by path; those of scenes that were edited are strings.
function openFrom(files, path, stored = true) {
  const opened = files.get(path);
  const [content, guessed] = typeof opened === 'string' ? [opened, false] : sceneText(opened);
  const others = new Map(files);
  others.delete(path);
  setDocument({ path, content, files: others, stored });
  if (guessed) {
    notice('encoding', `${path} is not in UTF-8; it was read as windows-1252. If letters are wrong, save it as UTF-8 in a text editor, and open it again.`);
  }
  const scenes = [...files.keys()].filter(isSceneName);
  if (scenes.length > 1) {
    notice('scenes', `${scenes.length} scenes were opened; this is ${path}.`, {
      actions: scenes.filter((other) => other !== path).slice(0, 30).map((other) => [other, () => openFrom(allFiles(), other)]),
    });
  }
}

// The files that the scene names, as far as the checker knows.
async function namedFiles() {
  try {
    const { files = [] } = await checker.call('check', { path: scene.path, depth: 0, course: readsLikeCourse() });
    return files.map(({ name }) => name);
  } catch {
    return [];
  }
}

async function openExample({ path, files }) {
  try {
    const contents = new Map(
      await Promise.all(
        [path, ...files].map(async (name) => [name, new Uint8Array(await (await fetch(`examples/${name}`)).arrayBuffer())]),
      ),
    );
    openFrom(contents, path, false);
    store.setTabDocument(path);
  } catch (error) {
    failed(error);
  }
}

// Picture settings.

const realtimeIds = ['parameter-1', 'parameter-2', 'near', 'far', 'filter', 'milestone'];

// Settings of the profile realtime that the controls of the page accept; otherwise null.
function realtimeOf(values) {
  if (!Array.isArray(values) || values.length !== realtimeIds.length || !values.every(Number.isFinite)) {
    return null;
  }
  const fit = realtimeIds.every((id, i) => {
    const { options, min, max, step } = byId(id);
    return options
      ? [...options].some(({ value }) => Number(value) === values[i])
      : values[i] >= Number(min) && (max === '' || values[i] <= Number(max)) && (step === 'any' || Number.isInteger(values[i]));
  });
  const [, , near, far] = values;
  return fit && near > 0 && near < far ? values : null;
}

// The settings that are stored and linked.
function keptOptions() {
  const { profile, mode, features, width, height, draw, realtime } = picture.options;
  const course = byId('course-reading').checked;
  return { profile, mode, features, width, height, ...(draw < 0 ? {} : { draw }), ...(profile === 2 ? { realtime } : {}), ...(course ? { course } : {}) };
}

function applyOptions(options) {
  if (options !== null && typeof options === 'object') {
    const whole = (value, least, most, otherwise) =>
      Number.isInteger(value) && value >= least && value <= most ? value : otherwise;
    picture.options = {
      ...picture.options,
      profile: whole(options.profile, 0, 2, 1),
      mode: whole(options.mode, -1, 3, -1),
      draw: whole(options.draw, 0, 6, -1),
      realtime: realtimeOf(options.realtime) ?? picture.options.realtime,
      features: whole(options.features, -1, 127, -1),
      width: whole(options.width, 1, 4096, 640),
      height: whole(options.height, 1, 4096, 480),
    };
    byId('course-reading').checked = options.course === true;
  }
  showOptions();
}

function showOptions() {
  const { profile, features, width, height, draw, realtime } = picture.options;
  const isRealtime = profile === 2;
  byId('profile').value = String(profile);
  byId('mode-trace').hidden = byId('mode-trace').disabled = isRealtime;
  byId('mode-path').hidden = byId('mode-path').disabled = profile !== 1;
  byId('mode').value = picture.isGl ? `gl${Math.max(0, draw)}` : String(picture.mode);
  byId('features-menu').hidden = isRealtime || picture.isPaths;
  byId('realtime').hidden = !isRealtime;
  realtimeIds.forEach((id, i) => {
    byId(id).value = String(realtime[i]);
    byId(id).removeAttribute('aria-invalid');
  });
  const all = [...sizes];
  if (!all.some(([w, hh]) => w === width && hh === height)) {
    all.push([width, height]);
  }
  byId('size').replaceChildren(...all.map(([w, hh]) => h('option', { value: `${w}x${hh}` }, `${w} × ${hh}`)));
  byId('size').value = `${width}x${height}`;
  const defaults = profile === 1 ? 0b1111111 : 0b1011111;
  const on = features < 0 ? defaults : features;
  byId('features').querySelectorAll('input').forEach((box, i) => (box.checked = ((on >> i) & 1) === 1));
  byId('pixel-x').max = String(width - 1);
  byId('pixel-y').max = String(height - 1);
}

function changeOptions(change) {
  Object.assign(picture.options, change);
  showOptions();
  edited();
  picture.draw();
}

byId('features').append(
  ...featureNames.map((name) => h('label', {}, h('input', { type: 'checkbox', onchange: featuresChanged }), ` ${name}`)),
);
function featuresChanged() {
  const boxes = [...byId('features').querySelectorAll('input')];
  changeOptions({ features: boxes.reduce((bits, box, i) => bits | (box.checked ? 1 << i : 0), 0) });
}
// Profiles read files differently.
byId('profile').addEventListener('change', () => {
  Object.assign(picture.options, { profile: Number(byId('profile').value), features: -1 });
  showOptions();
  edited();
  readAgain();
});
byId('mode').addEventListener('change', () => {
  const { value } = byId('mode');
  const { materials } = sceneNow();
  changeOptions(value.startsWith('gl') ? { draw: Number(value.slice(2)) } : { mode: Number(value), draw: -1 });
  if (materials !== sceneNow().materials) {
    readAgain();
  }
});
for (const id of realtimeIds) {
  byId(id).addEventListener('change', () => {
    const realtime = realtimeOf(realtimeIds.map((other) => (byId(other).value === '' ? NaN : Number(byId(other).value))));
    if (realtime === null) {
      byId(id).setAttribute('aria-invalid', 'true');
    } else {
      changeOptions({ realtime });
    }
  });
}
byId('size').addEventListener('change', () => {
  const [width, height] = byId('size').value.split('x').map(Number);
  changeOptions({ width, height });
});
byId('stop').addEventListener('click', async () => {
  await picture.stop();
  store.end(scene.id);
  byId('progress').textContent = 'stopped';
});
byId('course-reading').addEventListener('change', () => {
  edited();
  readAgain();
});

// The text is read in another way.
function readAgain() {
  scene.version += 1;
  if (panelIsShown()) {
    panel.update();
  }
  run();
}

// Comparing.

async function compareWith(name, bytes) {
  try {
    await picture.compareWith(name, bytes);
  } catch (error) {
    failed(new Error(`${name}: ${error.message}`));
    return;
  }
  const { width, height } = picture.mine;
  byId('compare-panel').open = true;
  byId('compare-close').hidden = false;
  byId('compare-how-label').hidden = false;
  byId('compare-intro').textContent = `${name}, ${width} × ${height}`;
  showTab('picture');
  compareHow();
  changeOptions({ width, height });
}

function closeComparison() {
  picture.compareWith('', null);
  byId('compare-close').hidden = true;
  byId('compare-how-label').hidden = true;
  byId('split-label').hidden = true;
  byId('compare-result').replaceChildren();
  byId('compare-intro').textContent =
    'Open your program’s picture of this scene. The page renders the scene in the same size and names known mistakes.';
}

function compareHow() {
  picture.show = byId('compare-how').value;
  byId('split-label').hidden = picture.show !== 'split';
  picture.paint();
}

function showComparison({ working, otherSize, openGl, paths, answer }) {
  const box = byId('compare-result');
  if (working || otherSize || openGl || paths) {
    box.replaceChildren(working ? 'Comparing…' : otherSize ? 'The pictures have different sizes.' : paths ? 'The program compares path-traced pictures within their noise: scenefile diff.' : 'Choose a mode of ray tracing, or the profile realtime, to compare.');
    return;
  }
  const parts = [];
  if (answer.max_difference === 0) {
    parts.push(h('p', {}, 'The pictures are equal.'));
  } else {
    parts.push(
      h('p', {}, `PSNR ${answer.psnr_db.toFixed(2)} dB, SSIM ${answer.ssim.toFixed(4)}, FLIP ${answer.flip_mean.toFixed(4)}; largest difference ${answer.max_difference}/255`),
    );
    const claims = (title, list = []) =>
      list.length === 0 ? [] : [h('h2', {}, title), h('ul', { className: 'claims' }, list.map(({ what, evidence }) => h('li', {}, what, evidence ? ` (${evidence})` : '')))];
    parts.push(
      ...claims('Your picture differs because', answer.causes),
      ...claims('It may also be that', answer.rivals?.filter(({ said }) => !said)),
      ...claims('This explains a part of the difference', answer.partial),
    );
    const { worst } = answer;
    if (worst) {
      parts.push(
        h('p', {}, 'They differ most around ',
          h('button', { className: 'link', type: 'button', onclick: () => explainAt(worst.x, worst.y) }, `column ${worst.x}, row ${worst.y}`),
          worst.object ? `: ${worst.object}` : ''),
      );
    }
    if (!answer.causes?.length && !answer.partial?.length) {
      parts.push(h('p', {}, 'No known mistake explains the difference. Click a pixel where the pictures differ to see how ours is computed.'));
    }
  }
  box.replaceChildren(...parts);
}

byId('compare-open').addEventListener('click', () => byId('picture-input').click());
byId('compare-close').addEventListener('click', closeComparison);
byId('compare-how').addEventListener('change', compareHow);
byId('split').addEventListener('input', () => {
  picture.split = Number(byId('split').value) / 100;
  picture.paint();
});

// Panels that edit the scene, loaded when they are first shown.

let panelIsChanging = false;

const panelIsShown = () => panel !== null && document.body.dataset.left === 'edit';

async function showPanel() {
  if (panel === null) {
    try {
      const [{ EditPanel }, engine] = await Promise.all([import('./edit/panel.js'), editEngine()]);
      panel ??= new EditPanel({
        model: () => engine.open(editor.text, readsLikeCourse()),
        change(changes) {
          panelIsChanging = true;
          try {
            editor.change(changes);
          } finally {
            panelIsChanging = false;
          }
        },
        files: () => [...scene.files.keys()].filter((path) => !isSceneName(path)),
        view: () => picture.view,
        viewport: () => picture.viewport,
        goTo(line) {
          editor.selectLine(line);
          editor.focus();
        },
        selected(model, item) {
          if (item !== null && item.from >= 0) {
            editor.selectLine(editor.lineAt(item.from));
          }
          mark((some) => some.select(item));
        },
      });
    } catch (error) {
      failed(new Error(`The panels cannot be loaded: ${error.message}`));
      return;
    }
  }
  panel.update(editor.cursor);
}

// Called when something other than the panels changed the text; `changes`: null if it was replaced
// as a whole.
function panelFollows(changes) {
  if (panelIsShown() && !panelIsChanging) {
    panel.update(changes === null ? 0 : changes.mapPos(Math.max(0, Math.min(panel.place, changes.length)), 1));
  }
}

// Marks over the picture, loaded when something is first selected.

async function mark(act) {
  try {
    const [{ Marks }, engine] = await Promise.all([import('./marks.js'), editEngine()]);
    marks ??= new Marks({
      text: () => editor.text,
      model: () => engine.open(editor.text, readsLikeCourse()),
      picture,
      all: () => byId('helpers').checked,
      failed: (error) => byId('helpers').checked && failed(new Error(`Lights and camera cannot be shown: ${error.message}.`)),
    });
    act(marks);
  } catch (error) {
    failed(new Error(`The selection cannot be shown: ${error.message}`));
  }
}
byId('helpers').addEventListener('change', () => mark((some) => some.show()));

// Moving the camera, and explaining pixels.

const canvas = byId('canvas');
const pointers = new Map(); // those that are down: where, by id
let drag = null; // by a single pointer

// How far two fingers are apart.
function spread() {
  const [a, b = a] = pointers.values();
  return Math.max(1, Math.hypot(a[0] - b[0], a[1] - b[1]));
}

canvas.addEventListener('pointerenter', () => picture.warmUp());
canvas.addEventListener('focus', () => picture.warmUp());

canvas.addEventListener('pointerdown', (event) => {
  pointers.set(event.pointerId, [event.clientX, event.clientY]);
  drag = pointers.size > 1 ? null : { x: event.clientX, y: event.clientY, moved: false };
  canvas.setPointerCapture(event.pointerId);
});
canvas.addEventListener('pointermove', (event) => {
  if (picture.view === null || !pointers.has(event.pointerId)) {
    return;
  }
  const before = spread();
  pointers.set(event.pointerId, [event.clientX, event.clientY]);
  if (pointers.size === 2) {
    picture.closer(before / spread());
  }
  if (drag === null) {
    return;
  }
  const [dx, dy] = [event.clientX - drag.x, event.clientY - drag.y];
  if (!drag.moved && Math.hypot(dx, dy) < 4) {
    return;
  }
  drag = { x: event.clientX, y: event.clientY, moved: true };
  const { height } = canvas.getBoundingClientRect();
  const how = event.shiftKey || event.buttons === 4 ? 'pan' : event.ctrlKey ? 'look' : byId('drag').value;
  if (how === 'pan') {
    picture.move(-dx / height, dy / height);
  } else if (how === 'look') {
    picture.turn((-dx / height) * picture.view.fov_y, (dy / height) * picture.view.fov_y);
  } else {
    picture.orbit((dx / height) * Math.PI, (dy / height) * Math.PI);
  }
});
canvas.addEventListener('pointercancel', ({ pointerId }) => {
  pointers.delete(pointerId);
  drag = null;
});
canvas.addEventListener('pointerup', (event) => {
  pointers.delete(event.pointerId);
  const click = drag !== null && !drag.moved;
  drag = null;
  if (click) {
    const box = canvas.getBoundingClientRect();
    const at = (position, start, size, pixels) =>
      Math.max(0, Math.min(pixels - 1, Math.floor(((position - start) / size) * pixels)));
    explainAt(at(event.clientX, box.left, box.width, canvas.width), at(event.clientY, box.top, box.height, canvas.height));
  }
});
canvas.addEventListener('wheel', (event) => {
  if (picture.view !== null) {
    event.preventDefault();
    picture.closer(Math.exp(Math.max(-50, Math.min(50, event.deltaY)) / 250));
  }
}, { passive: false });
// Flying, as in the program's window: keys that are held, and whether it is fast.
const flying = { w: [0, 0, 1], a: [-1, 0, 0], s: [0, 0, -1], d: [1, 0, 0], q: [0, -1, 0], e: [0, 1, 0] };
const held = new Set();
let flown = 0; // when the last step was made

function flyOn(time) {
  if (held.size === 0) {
    flown = 0;
    return;
  }
  const seconds = flown === 0 ? 1 / 60 : Math.min(0.1, (time - flown) / 1000);
  flown = time;
  const speed = held.has('shift') ? 2 : 0.5;
  const by = [0, 1, 2].map((axis) => speed * seconds * [...held].reduce((sum, key) => sum + (flying[key]?.[axis] ?? 0), 0));
  if (picture.view !== null && by.some((x) => x !== 0)) {
    picture.fly(...by);
  }
  requestAnimationFrame(flyOn);
}

canvas.addEventListener('keyup', ({ key }) => {
  held.delete(key.toLowerCase());
  if (held.size === 1) {
    held.delete('shift');
  }
});
canvas.addEventListener('blur', () => held.clear());
canvas.addEventListener('keydown', (event) => {
  const key = event.key.toLowerCase();
  if (picture.view !== null && !event.ctrlKey && !event.metaKey && !event.altKey && key in flying) {
    event.preventDefault();
    const starts = held.size === 0;
    held.add(key);
    if (event.shiftKey) {
      held.add('shift');
    }
    if (starts) {
      requestAnimationFrame(flyOn);
    }
    return;
  }
  const step = Math.PI / 36;
  const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  const arrow = arrows[event.key];
  if (picture.view === null || event.ctrlKey || event.metaKey || event.altKey) {
    return;
  }
  if (arrow && event.shiftKey) {
    picture.move(arrow[0] * 0.03, arrow[1] * 0.03);
  } else if (arrow) {
    picture.orbit(-arrow[0] * step, arrow[1] * step);
  } else if (event.key === '+' || event.key === '=') {
    picture.closer(0.9);
  } else if (event.key === '-') {
    picture.closer(1 / 0.9);
  } else if (event.key === '0') {
    picture.resetView();
  } else if (event.key === 'Enter') {
    explainAt(Number(byId('pixel-x').value), Number(byId('pixel-y').value));
  } else {
    return;
  }
  event.preventDefault();
});

byId('view-reset').addEventListener('click', () => picture.resetView());
byId('view-write').addEventListener('click', () => rewrite((now) => picture.writeView(now), 'The view cannot be saved in the text'));

// Replaces the text by what `work` makes of it. What the user does meanwhile takes precedence.
async function rewrite(work, problem) {
  const now = sceneNow();
  try {
    const changed = await work(now);
    if (now.version !== scene.version) {
      throw new Error('the scene has changed meanwhile; try again');
    }
    editor.replace(changed);
  } catch (error) {
    failed(new Error(`${problem}: ${error.message}`));
  }
}

function selectLine(line) {
  showTab('text');
  editor.selectLine(line);
}

async function explainAt(x, y) {
  if (!picture.hasScene) {
    return;
  }
  byId('pixel-x').value = String(x);
  byId('pixel-y').value = String(y);
  const box = canvas.getBoundingClientRect();
  const stage = byId('stage').getBoundingClientRect();
  const cross = byId('cross');
  cross.style.left = `${box.left - stage.left + ((x + 0.5) / canvas.width) * box.width}px`;
  cross.style.top = `${box.top - stage.top + ((y + 0.5) / canvas.height) * box.height}px`;
  cross.hidden = false;
  byId('explain-panel').open = true;
  try {
    let line;
    if (picture.isGl) {
      const found = await picture.callGl('pick', { x, y });
      line = found.line;
      byId('explain-result').replaceChildren(h('p', {}, found.object === undefined ? 'There is no object at this pixel.' : [`${found.object}, `,
        h('button', { className: 'link', type: 'button', onclick: () => selectLine(line) }, `line ${line}`)]));
    } else {
      const found = await picture.explain(x, y);
      byId('explain-result').replaceChildren(...explanation(found, selectLine));
      line = lineOfObject(found.document);
    }
    if (line === undefined) {
      marks?.select(null);
    } else {
      editor.selectLine(line);
      if (panelIsShown()) {
        panel.selectAt(editor.offsetOfLine(line));
      } else {
        mark((some) => some.selectAt(editor.offsetOfLine(line)));
      }
    }
  } catch (error) {
    byId('explain-result').replaceChildren(`This pixel cannot be explained: ${error.message}.`);
  }
}

byId('explain-form').addEventListener('submit', (event) => {
  event.preventDefault();
  explainAt(Number(byId('pixel-x').value), Number(byId('pixel-y').value));
});
new ResizeObserver(() => {
  byId('cross').hidden = true;
  panel?.viewChanged(panelIsShown());
  marks?.paint();
}).observe(canvas);

// Saving and exporting.

const stem = () => baseName(scene.path).replace(/\.(xml|json)$/i, '');
const allFiles = () => new Map([...scene.files, [scene.path, editor.fileText]]);

const saves = {
  'save-scene': () => download(baseName(scene.path), [editor.fileText], 'text/plain'),
  'save-zip': () => download(`${stem()}.zip`, [packed(allFiles())], 'application/zip'),
  'save-png': async () => {
    if (picture.pixels === null) {
      throw new Error('The picture is not complete yet.');
    }
    download(`${stem()}.png`, [await picture.png()], 'image/png');
  },
};
for (const [id, save] of Object.entries(saves)) {
  byId(id).addEventListener('click', async () => {
    byId('save-menu').open = false;
    try {
      await save();
    } catch (error) {
      failed(error);
    }
  });
}
for (const button of document.querySelectorAll('[data-format]')) {
  button.addEventListener('click', async () => {
    byId('save-menu').open = false;
    const to = button.dataset.format;
    try {
      const { files, findings } = await picture.convert(sceneNow(), to);
      const [[, bytes]] = files;
      if (files.size === 1) {
        download(`${stem()}.${to}`, [bytes]);
      } else {
        download(`${stem()}-${to}.zip`, [packed(files)], 'application/zip');
      }
      const lost = findings.filter(({ severity }) => severity !== 'note' || to !== 'xml');
      clearNotice('converted');
      if (lost.length > 0) {
        notice('converted', lost.slice(0, 5).map(({ message }) => message).join('; '));
      }
    } catch (error) {
      failed(new Error(`The scene cannot be converted: ${error.message}.`));
    }
  });
}

byId('share').addEventListener('click', async () => {
  const link = linkOf({ name: baseName(scene.path), text: editor.fileText, options: keptOptions() });
  const named = [...scene.files].length;
  history.replaceState(null, '', link);
  const words = named > 0 ? ' Textures and meshes are not part of the link; send a zip of the scene and its files instead.' : '';
  try {
    await navigator.clipboard.writeText(location.href);
    notice('shared', `Link copied; it contains the scene (${link.length} characters).${words}`);
  } catch {
    notice('shared', `The link is now in the address bar (${link.length} characters).${words}`);
  }
});

byId('format').addEventListener('click', () => rewrite((now) => picture.format(now), 'The text cannot be formatted'));
byId('undo').addEventListener('click', () => editor.undo());
byId('redo').addEventListener('click', () => editor.redo());

byId('name').addEventListener('change', () => {
  const name = byId('name').value.replace(/[\\/]/g, '').trim() || 'scene.xml';
  scene.path = scene.path.slice(0, scene.path.length - baseName(scene.path).length) + name;
  byId('name').value = name;
  scene.version += 1;
  document.title = `${name} – scenefile`;
  edited();
  run();
});

// Storing the scene in the browser.

let savesAsked = 0;

const inAddress = (key) => new URLSearchParams(location.hash.slice(1)).has(key);

// A link in the address would take precedence when the page is loaded again.
function leaveLink() {
  if (inAddress('s')) {
    history.replaceState(null, '', inAddress('embed') ? '#embed' : location.pathname + location.search);
  }
}

// The user changed the scene or its settings.
function edited() {
  leaveLink();
  if (!scene.stored) {
    scene.stored = true;
    store.setTabDocument(scene.id);
  }
  saveSoon();
}

function saveSoon() {
  if (!scene.stored) {
    return;
  }
  savesAsked += 1;
  delete document.body.dataset.saved;
  saveAfterPause();
}

const saveAfterPause = afterPause(400, async () => {
  const { id, path, unsafe, filesSaved } = scene;
  const asked = savesAsked;
  try {
    const files = filesSaved ? null : scene.files;
    scene.filesSaved = true;
    await store.save({ id, path, text: editor.fileText, options: keptOptions(), unsafe }, files);
    clearNotice('saving');
    if (asked === savesAsked) {
      document.body.dataset.saved = unsafe ? 'unsafe' : 'yes';
    }
  } catch (error) {
    if (id === scene.id) {
      scene.filesSaved = filesSaved;
    }
    notice('saving', `The browser cannot store this scene: ${error.message}`);
  }
});

async function openKept(id) {
  const kept = await store.load(id);
  if (kept === undefined || !(await store.hold(id))) {
    return false;
  }
  setDocument({
    id,
    path: kept.path,
    content: kept.text,
    files: kept.files,
    options: kept.options,
    unsafe: kept.unsafe || store.wasLeft(id),
  });
  return true;
}

// A link takes precedence over the stored scene.
function openLink() {
  let linked;
  try {
    linked = sceneOf(location.hash);
  } catch (error) {
    // The notice stays when a stored scene is opened instead.
    notice('link', `The link cannot be opened: ${error.message}.`, { kind: 'error' });
    return false;
  }
  if (linked === null) {
    return false;
  }
  clearNotice('link');
  setDocument({ path: baseName(linked.name), content: linked.text, options: linked.options ?? null, stored: false, linked: true });
  return true;
}

async function openFirst() {
  if (openLink()) {
    return;
  }
  try {
    const own = store.tabDocument();
    const example = examples.find(({ path }) => path === own);
    if (example !== undefined) {
      openExample(example);
      return;
    }
    if (own !== null && (await openKept(own))) {
      return;
    }
    for (const { id } of (await store.list()).slice(0, 3)) {
      if (await openKept(id)) {
        return;
      }
    }
  } catch {
    // the browser has no storage
  }
  openExample(examples[0]);
}

addEventListener('hashchange', openLink);
addEventListener('visibilitychange', () => document.visibilityState === 'hidden' && saveAfterPause.now());
addEventListener('pagehide', () => {
  saveAfterPause.now();
  store.end(scene.id);
});

// Menus, tabs, theme.

for (const menu of document.querySelectorAll('.menu')) {
  menu.addEventListener('toggle', () => {
    if (menu.open) {
      document.querySelectorAll('.menu[open]').forEach((other) => (other.open = other === menu));
    }
  });
  menu.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && menu.open) {
      menu.open = false;
      menu.querySelector('summary').focus();
    }
  });
}
addEventListener('pointerdown', ({ target }) => {
  document.querySelectorAll('.menu[open]').forEach((menu) => menu.contains(target) || (menu.open = false));
});

// `name`: text, edit or picture. Wide pages show the picture next to the text or the panels.
function showTab(name) {
  document.body.dataset.tab = name;
  for (const other of ['text', 'edit', 'picture']) {
    byId(`tab-${other}`).setAttribute('aria-selected', String(other === name));
  }
  if (name === 'picture') {
    return;
  }
  document.body.dataset.left = name;
  byId('show-text').setAttribute('aria-pressed', String(name === 'text'));
  byId('show-edit').setAttribute('aria-pressed', String(name === 'edit'));
  if (name === 'edit') {
    showPanel();
  } else {
    panel?.viewChanged(false);
  }
}
for (const name of ['text', 'edit', 'picture']) {
  byId(`tab-${name}`).addEventListener('click', () => showTab(name));
}
byId('show-text').addEventListener('click', () => showTab('text'));
byId('show-edit').addEventListener('click', () => showTab('edit'));

const themes = ['system', 'light', 'dark'];
function showTheme(theme) {
  if (theme === 'system') {
    delete document.documentElement.dataset.theme;
  } else {
    document.documentElement.dataset.theme = theme;
  }
  byId('theme').textContent = `Theme: ${theme}`;
}
byId('theme').addEventListener('click', () => {
  const now = document.documentElement.dataset.theme ?? 'system';
  const next = themes[(themes.indexOf(now) + 1) % themes.length];
  store.remember('theme', next);
  showTheme(next);
});

byId('examples').append(
  ...examples.map((example) => h('button', { type: 'button', onclick: () => (closeMenus(), openExample(example)) }, example.title)),
  h('button', { type: 'button', onclick: () => (closeMenus(), setDocument({ path: 'scene.xml', content: emptyScene })) }, 'New scene'),
);
function closeMenus() {
  document.querySelectorAll('.menu[open]').forEach((menu) => (menu.open = false));
}

byId('open-menu').addEventListener('toggle', async () => {
  if (byId('open-menu').open) {
    const kept = await store.list().catch(() => []);
    byId('recent').replaceChildren(
      ...kept.filter(({ id }) => id !== scene.id).slice(0, 8).map(({ id, path, time }) =>
        h('button', {
          type: 'button',
          onclick: async () => {
            closeMenus();
            if (!(await openKept(id))) {
              failed(new Error('That scene is open in another tab.'));
            }
          },
        }, `${baseName(path)}, ${new Date(time).toLocaleString()}`),
      ),
    );
  }
});

const inputs = { 'open-files': 'file-input', 'open-folder': 'folder-input' };
for (const [button, input] of Object.entries(inputs)) {
  byId(button).addEventListener('click', () => {
    closeMenus();
    byId(input).click();
  });
}
byId('picture-input').accept = pictureEndings.join();
for (const id of ['file-input', 'folder-input', 'picture-input']) {
  const input = byId(id);
  input.addEventListener('change', () => {
    take(fromInput(input), id === 'picture-input');
    input.value = '';
  });
}

let dragging = 0;
const hasFiles = (event) => event.dataTransfer?.types.includes('Files');
addEventListener('dragenter', (event) => {
  if (hasFiles(event)) {
    dragging += 1;
    byId('drop').hidden = false;
  }
});
addEventListener('dragleave', () => {
  dragging = Math.max(0, dragging - 1);
  byId('drop').hidden = dragging === 0;
});
addEventListener('dragover', (event) => hasFiles(event) && event.preventDefault());
addEventListener('drop', async (event) => {
  dragging = 0;
  byId('drop').hidden = true;
  if (hasFiles(event)) {
    event.preventDefault();
    take(await fromDrop(event.dataTransfer));
  }
}, { capture: true });

if (inAddress('embed')) {
  document.body.classList.add('embedded');
}
showTab('picture');
showTheme(store.remembered('theme') ?? 'system');
showOptions();
openFirst();
store.tidy().catch(() => {});
if ('serviceWorker' in navigator && location.protocol.startsWith('http')) {
  navigator.serviceWorker.register('service-worker.js').catch(() => {});
}
