// World-space placement of objects, and edits that move, rotate and scale them.

import { addTransform, setPart, setParts } from './edits.js';
import { fieldsOfItem, topOf } from './model.js';

// Matrices: 16 numbers, row by row.

export const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

export const product = (a, b) =>
  a.map((_, i) => [0, 1, 2, 3].reduce((sum, k) => sum + a[4 * Math.floor(i / 4) + k] * b[4 * k + (i % 4)], 0));

/** `w`: 1 for a point, 0 for a direction. */
export const transformed = (m, [x, y, z], w = 1) => [0, 4, 8].map((i) => m[i] * x + m[i + 1] * y + m[i + 2] * z + m[i + 3] * w);

// A rotation as a quaternion [w, x, y, z], from an axis of any length and degrees.
function quaternion([x, y, z, degrees]) {
  const length = Math.hypot(x, y, z) || 1;
  const half = (degrees * Math.PI) / 360;
  return [Math.cos(half), ...[x, y, z].map((part) => (Math.sin(half) * part) / length)];
}

const after = ([aw, ax, ay, az], [bw, bx, by, bz]) => [
  aw * bw - ax * bx - ay * by - az * bz,
  aw * bx + ax * bw + ay * bz - az * by,
  aw * by - ax * bz + ay * bw + az * bx,
  aw * bz + ax * by - ay * bx + az * bw,
];

function axisAngle([w, x, y, z]) {
  const length = Math.hypot(x, y, z);
  if (length < 1e-9) {
    return [0, 1, 0, 0];
  }
  const degrees = (2 * Math.atan2(length, w) * 180) / Math.PI;
  const [sign, angle] = degrees > 180 ? [-1, 360 - degrees] : [1, degrees];
  return [...[x, y, z].map((part) => (sign * part) / length), angle];
}

function rotation(values) {
  const [w, x, y, z] = quaternion(values);
  return [
    1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 0,
    2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x), 0,
    2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y), 0,
    0, 0, 0, 1,
  ];
}

function matrixOf({ spec, values }) {
  const n = values.map(Number);
  switch (spec.name) {
    case 'translate':
      return [1, 0, 0, n[0], 0, 1, 0, n[1], 0, 0, 1, n[2], 0, 0, 0, 1];
    case 'scale':
      return [n[0], 0, 0, 0, 0, n[1], 0, 0, 0, 0, n[2], 0, 0, 0, 0, 1];
    case 'rotate':
      return rotation(n);
    default:
      return [...n.slice(0, 12), 0, 0, 0, 1];
  }
}

const order = ['translate', 'rotate', 'scale', 'matrix'];
const isPlacing = ({ spec }) => order.includes(spec.name);

/** The transforms of an item in the file, outermost first. */
function transformsOf(model, item) {
  const fields = fieldsOfItem(model, item).filter((field) => isPlacing(field) && field.element !== null);
  return model.xml ? fields : fields.sort((a, b) => order.indexOf(a.spec.name) - order.indexOf(b.spec.name));
}

/** The transform from an item's object space to world space. */
export function worldOf(model, item) {
  const own = ['group', 'primitive', 'instance', 'template'].includes(item.kind) ? transformsOf(model, item).map(matrixOf) : [];
  return own.reduce(product, item.parent === null ? identity : worldOf(model, item.parent));
}

/**
 * The handle to move an item: { item, space, origin }. In JSON, an object is moved by the
 * transforms of its group. `space`: the transform to world space from the space in which it is
 * moved. Null if it cannot be moved, or has several instances.
 */
export function handleOf(model, item) {
  if (item === null || model.problem >= 0 || topOf(item).kind === 'template') {
    return null;
  }
  if (model.xml && item.kind === 'light') {
    const position = fieldsOfItem(model, item).find(({ spec, unused }) => spec.name === 'position' && !unused);
    return position?.element ? known({ item, position, space: identity, origin: position.values.map(Number) }) : null;
  }
  const placed = model.xml ? (item.block ? item : null) : item.kind === 'group' ? item : ['primitive', 'light', 'instance'].includes(item.kind) ? item.parent : null;
  if (placed === null || placed.kind === 'root') {
    return null;
  }
  return known({ item: placed, position: null, space: worldOf(model, placed.parent), origin: transformed(worldOf(model, placed), [0, 0, 0]) });
}

const known = (handle) => ([...handle.space, ...handle.origin].every(Number.isFinite) ? handle : null);

/** A number with few digits. */
export const tidy = (number) => String(Number(number.toPrecision(6)));

const fieldOf = (model, item, name) => fieldsOfItem(model, item).find(({ spec }) => spec.name === name);

// Adds a transform in XML with these values, after `before` others; -1: after all.
function withNew(model, item, name, values, before) {
  const spec = model.words.fields.transblock.find((some) => some.name === name);
  return addTransform(model, item, name, values ?? spec.start, before);
}

/** Moves by `delta` in the space of the handle; rounds values to multiples of `step`. */
export function moveItem(model, handle, delta, step = 1e-6) {
  const rounded = (number) => tidy(Math.round(number / step) * step);
  const changed = (field) =>
    setParts(model, field, delta.map((by, i) => (by === 0 && field.element !== null ? null : rounded(Number(field.values[i] ?? 0) + by))));
  const { item, position } = handle;
  if (position !== null) {
    return changed(position);
  }
  const field = model.xml ? transformsOf(model, item)[0] : fieldOf(model, item, 'translate');
  return field?.spec.name === 'translate' ? changed(field) : withNew(model, item, 'translate', delta.map(rounded), 0);
}

/** Scales along an axis of the item's own space. */
export function scaleItem(model, handle, axis, factor) {
  const { item } = handle;
  const field = model.xml ? transformsOf(model, item).findLast(({ spec }) => spec.name === 'scale') : fieldOf(model, item, 'scale');
  const scaled = (value) => tidy(Number((Number(value ?? 1) * factor).toFixed(4)) || 0.0001);
  if (field === undefined) {
    return withNew(model, item, 'scale', [0, 1, 2].map((i) => (i === axis ? scaled(1) : '1')), -1);
  }
  return setPart(model, field, axis, scaled(field.values[axis]));
}

/** Rotates about an axis of the parent's space, through the position given by the leading translations. */
export function turnItem(model, handle, axis, degrees) {
  const { item } = handle;
  const turn = [0, 1, 2].map((i) => (i === axis ? 1 : 0)).concat(degrees);
  const fields = transformsOf(model, item);
  const lead = fields.findIndex(({ spec }) => spec.name !== 'translate');
  const field = model.xml ? fields[lead] : fieldOf(model, item, 'rotate');
  if (field?.spec.name !== 'rotate') {
    return withNew(model, item, 'rotate', turn.map(tidy), lead < 0 ? fields.length : lead);
  }
  const now = field.values.map((value, i) => Number(value ?? field.spec.start[i]));
  // The same axis keeps its length and sign.
  const along = now.slice(0, 3).every((part, i) => (i === axis ? part !== 0 : part === 0));
  if (along && field.element !== null) {
    return setPart(model, field, 3, tidy(Number((now[3] + Math.sign(now[axis]) * degrees).toFixed(2))));
  }
  const together = axisAngle(after(quaternion(turn), quaternion(now)));
  return setParts(model, field, together.map((part, i) => tidy(Number(part.toFixed(i < 3 ? 5 : 2)))));
}
