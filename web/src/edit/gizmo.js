// Handles over the picture that move, rotate or scale the selected object by dragging. The outline
// follows the pointer; the text changes once, when the pointer is released.

import { byId } from '../dom.js';
import { along, depthOf, dot, projection } from '../projection.js';

const svgName = 'http://www.w3.org/2000/svg';
const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
const size = 0.22; // length of a handle, as a fraction of the picture's height
const circle = Array.from({ length: 49 }, (_, i) => [Math.cos((i * Math.PI) / 24), Math.sin((i * Math.PI) / 24)]);
const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [(i & 1) - 0.5, ((i >> 1) & 1) - 0.5, (i >> 2) - 0.5]);
const edges = [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];

/** `m`: 16 numbers, row by row; `w`: 1 for a point, 0 for a direction. */
const transformed = (m, [x, y, z], w = 1) => [0, 4, 8].map((i) => m[i] * x + m[i + 1] * y + m[i + 2] * z + m[i + 3] * w);

const unit = (v) => v.map((x) => x / (Math.hypot(...v) || 1));

function element(name, attributes, parent) {
  const made = document.createElementNS(svgName, name);
  for (const [key, value] of Object.entries(attributes)) {
    made.setAttribute(key, value);
  }
  parent?.append(made);
  return made;
}

export class Gizmo {
  #host;
  #svg = element('svg', { id: 'gizmo', 'aria-hidden': 'true' });
  #model = null;
  #item = null;
  #drag = null;

  /** `host`: view() and viewport() of the picture, apply(edit). */
  constructor(host) {
    this.#host = host;
    byId('stage').append(this.#svg);
    byId('edit-handles').addEventListener('change', () => this.show());
    this.#svg.addEventListener('pointermove', (event) => this.#move(event));
    this.#svg.addEventListener('pointerup', (event) => this.#end(event));
    this.#svg.addEventListener('pointercancel', () => this.#end(null));
  }

  select(model, item) {
    this.#model = model;
    this.#item = item;
    this.show();
  }

  hide() {
    this.#svg.replaceChildren();
  }

  get #how() {
    return byId('edit-handles').value;
  }

  /** Draws the handles at the current position of the picture. */
  show() {
    if (this.#drag !== null) {
      return;
    }
    this.hide();
    const view = this.#host.view();
    const handle = this.#item && this.#model.handle(this.#item);
    byId('edit-handles').disabled = !handle;
    if (!handle || view === null || this.#how === 'none') {
      return;
    }
    const canvas = byId('canvas');
    const box = canvas.getBoundingClientRect();
    const stage = byId('stage').getBoundingClientRect();
    this.#svg.setAttribute('viewBox', `0 0 ${canvas.width} ${canvas.height}`);
    Object.assign(this.#svg.style, { left: `${box.left - stage.left}px`, top: `${box.top - stage.top}px`, width: `${box.width}px`, height: `${box.height}px` });
    this.#draw(handle, view, canvas);
  }

  #draw(handle, view, canvas) {
    const project = projection(view, canvas.width, canvas.height, this.#host.viewport());
    const { origin } = handle;
    const center = project(origin);
    const outline = element('g', { class: 'outline' }, this.#svg);
    if (this.#item.kind === 'primitive' && this.#item.name !== 'mesh') {
      const places = corners.map((corner) => project(transformed(handle.world, corner)));
      for (const [a, b] of edges) {
        if (places[a] && places[b]) {
          element('line', { x1: places[a][0], y1: places[a][1], x2: places[b][0], y2: places[b][1] }, outline);
        }
      }
    }
    if (center === null || (handle.light && this.#how !== 'move')) {
      return;
    }
    const depth = depthOf(view, origin);
    const length = 2 * size * depth * Math.tan(view.fov_y / 2);
    // Scaling acts along the object's own axes; moving and rotating use the axes of its parent.
    const space = this.#how === 'scale' ? handle.world : handle.space;
    axes.forEach((axis, i) => {
      const world = transformed(space, axis, 0);
      const direction = unit(world);
      const group = element('g', { class: `axis axis-${'xyz'[i]}`, 'data-axis': i }, this.#svg);
      if (this.#how === 'turn') {
        const [a, b] = [unit(transformed(space, axes[(i + 1) % 3], 0)), unit(transformed(space, axes[(i + 2) % 3], 0))];
        const points = circle.map(([c, s]) => project(along(along(origin, a, 0.8 * length * c), b, 0.8 * length * s))).filter((point) => point !== null);
        const text = points.map((point) => point.map((x) => x.toFixed(1)).join(',')).join(' ');
        element('polyline', { class: 'grip', points: text }, group);
        element('polyline', { points: text }, group);
      } else {
        const end = project(along(origin, direction, length));
        if (end === null) {
          return;
        }
        const line = { x1: center[0], y1: center[1], x2: end[0], y2: end[1] };
        element('line', { class: 'grip', ...line }, group);
        element('line', line, group);
        element(this.#how === 'move' ? 'circle' : 'rect', this.#how === 'move' ? { cx: end[0], cy: end[1], r: 7 } : { x: end[0] - 6, y: end[1] - 6, width: 12, height: 12 }, group);
      }
      group.addEventListener('pointerdown', (event) => {
        event.preventDefault();
        this.#svg.setPointerCapture(event.pointerId);
        const near = project(along(origin, direction, length / 100));
        this.#drag = {
          handle, axis: i, center, start: this.#at(event), amount: 0, outline, facing: dot(direction, view.w) > 0 ? 1 : -1,
          perWorld: near === null ? [1, 0] : [(near[0] - center[0]) / (length / 100), (near[1] - center[1]) / (length / 100)],
          worldPerUnit: Math.hypot(...world), length, project, group,
        };
        group.classList.add('dragged');
      });
    });
  }

  #at(event) {
    const box = this.#svg.getBoundingClientRect();
    const canvas = byId('canvas');
    return [((event.clientX - box.left) / box.width) * canvas.width, ((event.clientY - box.top) / box.height) * canvas.height];
  }

  #move(event) {
    const drag = this.#drag;
    if (drag === null) {
      return;
    }
    const at = this.#at(event);
    const by = along(at, drag.start, -1);
    if (this.#how === 'turn') {
      const angle = (point) => Math.atan2(drag.center[1] - point[1], point[0] - drag.center[0]);
      const turned = (drag.facing * (angle(at) - angle(drag.start)) * 180) / Math.PI;
      drag.amount = Math.round(((turned + 540) % 360) - 180);
      this.#preview(`rotate(${-drag.facing * drag.amount} ${drag.center[0]} ${drag.center[1]})`);
      return;
    }
    const along2 = dot(by, drag.perWorld) / Math.max(1e-9, dot(drag.perWorld, drag.perWorld)); // in world units
    if (this.#how === 'move') {
      drag.amount = along2 / drag.worldPerUnit;
      this.#preview(`translate(${drag.perWorld.map((x) => x * along2).join(' ')})`);
    } else {
      drag.amount = Math.max(0.01, 1 + along2 / drag.length);
    }
  }

  #preview(transform) {
    this.#svg.setAttribute('data-dragging', 'true');
    for (const group of this.#svg.querySelectorAll('.outline')) {
      group.setAttribute('transform', transform);
    }
  }

  #end(event) {
    const drag = this.#drag;
    this.#drag = null;
    this.#svg.removeAttribute('data-dragging');
    if (drag === null) {
      return;
    }
    const { handle: { item }, axis, amount } = drag;
    if (event === null || amount === 0) {
      this.show();
      return;
    }
    const pixel = 1 / Math.max(1e-9, Math.hypot(...drag.perWorld)) / drag.worldPerUnit; // in units of the translation
    const step = 10 ** Math.floor(Math.log10(pixel));
    const edits = {
      move: () => this.#model.move(item, axes[axis].map((x) => x * amount), step),
      turn: () => this.#model.turn(item, axis, amount),
      scale: () => this.#model.scale(item, axis, amount),
    };
    this.#host.apply(edits[this.#how]());
  }
}

