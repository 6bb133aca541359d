// Why a pixel has its color, from the document of `scenefile explain --json` (docs/explain.md).

import { h } from './dom.js';

const byte = (x) => Math.round(Math.min(1, Math.max(0, x)) * 255);
const rounded = (x) => (x === null ? '∞' : String(Number(x.toPrecision(4))));
const triple = (v) => v.map(rounded).join('  ');

function swatch(color) {
  const element = h('span', { className: 'swatch' });
  element.style.background = `rgb(${color.map(byte).join(' ')})`;
  return element;
}

const row = (name, ...cells) => h('tr', {}, h('th', { scope: 'row' }, name), h('td', {}, cells));

function lineLink(line, selectLine) {
  return line === undefined ? null : h('button', { className: 'link', type: 'button', onclick: () => selectLine(line) }, `line ${line}`);
}

// `found.object` lists the object after the objects that contain it, outermost first.
function objectPart(found, selectLine) {
  const object = found.object.at(-1);
  return [object.path, ' ', lineLink(object.line, selectLine)];
}

function raysTable(pixel, selectLine) {
  const rows = pixel.rays.slice(0, 40).map((ray, i) => {
    const { surface } = ray;
    return h(
      'tr',
      {},
      h('td', {}, `${i} ${ray.kind}`),
      h('td', {}, surface ? objectPart(surface, selectLine) : 'nothing'),
      h('td', {}, surface ? `t = ${rounded(surface.t)}` : ''),
      h('td', {}, swatch(ray.color), ' ', triple(ray.color)),
    );
  });
  return h(
    'table',
    {},
    h('thead', {}, h('tr', {}, ...['Ray', 'Hits', 'At', 'Color'].map((name) => h('th', { scope: 'col' }, name)))),
    h('tbody', {}, rows),
  );
}

function termsTable(pixel, selectLine) {
  const [ray] = pixel.rays;
  if (!ray?.surface) {
    return null;
  }
  const rows = [row('ambient', swatch(ray.ambient), ' ', triple(ray.ambient))];
  for (const light of ray.lights) {
    const [sample] = light.samples;
    const visible = sample === undefined ? '' : sample.visibility.every((v) => v === 1) ? '' : ', in shadow';
    const blocker = sample?.blockers[0];
    rows.push(
      row(
        `${light.type} light`,
        swatch(light.contribution), ' ', triple(light.contribution), ' ',
        lineLink(light.line, selectLine),
        light.unlit ? ` (${light.unlit.replaceAll('-', ' ')})` : visible,
        blocker ? [' of ', ...objectPart(blocker, selectLine)] : [],
      ),
    );
  }
  for (const name of ['reflected', 'refracted']) {
    const branch = ray[name];
    if (branch && branch.fate !== 'absent') {
      const below = branch.ray === undefined ? null : pixel.rays[branch.ray].color;
      rows.push(row(name, below ? [swatch(below), ' ', `${triple(branch.factor)} × ${triple(below)}`] : branch.fate.replaceAll('-', ' ')));
    }
  }
  return h('table', {}, h('tbody', {}, rows));
}

function yoursPart(yours) {
  if (yours === undefined) {
    return [];
  }
  const value = h('p', {}, 'Your picture: ', swatch(yours.value.map((v) => v / 255)), ` ${yours.value.join(' ')}`);
  if (yours.equal) {
    return [value, h('p', {}, 'It equals ours, up to rounding.')];
  }
  return yours.fits.length === 0
    ? [value, h('p', {}, 'No known mistake in our terms gives this value.')]
    : [value, h('ul', { className: 'claims' }, yours.fits.map((fit) => h('li', {}, `Yours equals ours ${fit.what}.`)))];
}

// A path-traced pixel: the path of one of its samples.
function pathExplanation({ pixel, text }, selectLine) {
  const { color, standard_error: error, samples, path } = pixel;
  const rows = path.vertices.map((vertex, i) =>
    h('tr', {}, h('td', {}, String(i)), h('td', {}, vertex.object ? objectPart(vertex, selectLine).filter((part) => part !== null) : 'nothing'),
      h('td', {}, triple(vertex.throughput)), h('td', {}, triple(vertex.light))));
  return [
    h('p', {}, `${triple(color)} (linear), standard error ${rounded(error)}, from ${samples.length} ${samples.length === 1 ? 'sample' : 'samples'}`),
    h('table', {},
      h('thead', {}, h('tr', {}, ...['', 'The path of a sample', 'Throughput', 'Light'].map((name) => h('th', { scope: 'col' }, name)))),
      h('tbody', {}, rows)),
    h('details', {}, h('summary', {}, 'All steps'), h('pre', { tabIndex: 0 }, text)),
  ];
}

/** The line of the object at the pixel; undefined if there is none. */
export function lineOfObject({ pixel }) {
  return (pixel.path?.vertices[0] ?? pixel.rays?.[0]?.surface)?.object?.at(-1).line;
}

/** Elements that show the answer. `selectLine` is called when a line number is clicked. */
export function explanation({ document, text }, selectLine) {
  const { pixel } = document;
  if (pixel.path !== undefined) {
    return pathExplanation({ pixel, text }, selectLine);
  }
  const [ray] = pixel.rays;
  const remarks = pixel.remarks.map(({ text: words }) => h('li', {}, words));
  return [
    h('p', {}, swatch(pixel.value.map((v) => v / 255)), ` ${pixel.value.join(' ')} `,
      ray?.surface ? ['from ', ...objectPart(ray.surface, selectLine)].filter((part) => part !== null) : 'background: the ray hits no object.'),
    ...yoursPart(pixel.yours),
    remarks.length === 0 ? null : h('ul', { className: 'claims' }, remarks),
    termsTable(pixel, selectLine),
    raysTable(pixel, selectLine),
    h('details', {}, h('summary', {}, 'All steps'), h('pre', { tabIndex: 0 }, text)),
  ].filter((element) => element !== null);
}
