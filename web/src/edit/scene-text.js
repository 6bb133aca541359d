// The text of a scene as an author sees it: its items, their fields, and edits. They come from the
// core's engine (bindings/web/page_edit.cpp), a module that is loaded when it is first needed.

import createScenefile from 'scenefile-page-edit';

import { moduleOf } from '../engine.js';
import { instanceOf } from '../instance.js';

const decoder = new TextDecoder();
const encoder = new TextEncoder();

class EditEngine {
  #core;
  #open = null; // the SceneText that the core has open

  constructor(core) {
    this.#core = core;
  }

  /** The answer of a function of the core. Strings are passed as bytes with their number, { word } ends with a zero byte. */
  call(name, ...args) {
    const core = this.#core;
    const pointers = [];
    const passed = args.flatMap((arg) => {
      if (typeof arg === 'number') {
        return [arg];
      }
      const isWord = typeof arg !== 'string';
      const bytes = encoder.encode(isWord ? `${arg.word}\0` : arg);
      const at = core._malloc(bytes.length + 1);
      pointers.push(at);
      core.HEAPU8.set(bytes, at);
      return isWord ? [at] : [at, bytes.length];
    });
    let answer;
    try {
      const at = core[`_page_edit_${name}`](...passed);
      answer = JSON.parse(decoder.decode(core.HEAPU8.subarray(at, at + core._page_edit_answer_size())));
      pointers.forEach((pointer) => core._free(pointer));
    } catch (error) {
      loading = null; // after a trap, the instance cannot be used again
      throw error;
    }
    if (answer.error !== undefined) {
      throw new Error(answer.error);
    }
    return answer;
  }

  /** `course`: whether the text is read as the course's programs do. */
  open(text, course) {
    if (this.#open?.text !== text || this.#open.course !== course) {
      this.#open = new SceneText(this, text, course);
    }
    return this.#open;
  }

  /** What can be written at an offset: { from, to, items }, each with label, kind, about and insert. */
  complete(text, offset) {
    return this.call('complete', text, offset);
  }

  /** What the word at an offset means: { from, to, about }; null if it is not a word of the format. */
  describe(text, offset) {
    const found = this.call('describe', text, offset);
    return found.about === undefined ? null : found;
  }
}

let loading = null;

/** The engine. */
export function editEngine() {
  loading ??= load();
  loading.catch(() => (loading = null));
  return loading;
}

async function load() {
  return new EditEngine(await instanceOf(createScenefile, await moduleOf('scenefile-edit.wasm')));
}

const capital = (word) => `${word.slice(0, 1).toUpperCase()}${word.slice(1)}`;
const labels = {
  globals: () => 'Global data',
  camera: () => 'Camera',
  light: (name) => `${name || 'point'} light`,
  root: () => 'Scene',
};
const kinds = {
  globals: labels.globals,
  camera: labels.camera,
  light: (name) => `${capital(name)} light`,
  primitive: capital,
  group: () => 'Group',
  instance: (name) => `Instance of ${name}`,
};

/**
 * A text that does not change. Items: { id, kind, label, name, from, to, children, parent, path };
 * `from` is -1 if the file has no such global data or camera. `problem`: why there are none, or null.
 */
class SceneText {
  #engine;
  problem = null;
  xml = true;
  /** All items, each before its contents; and those that are in no other. */
  all = [];
  items = [];

  constructor(engine, text, course) {
    this.#engine = engine;
    this.text = text;
    this.course = course;
    try {
      const { xml, items } = engine.call('open', text, course ? 1 : 0);
      this.xml = xml;
      this.all = items.map(({ kind, name, written, from, to }, id) => ({
        id, kind, name, label: (labels[kind] ?? (() => name))(name) || kind, from: written ? from : -1, to: written ? to : -1, children: [], parent: null,
      }));
      items.forEach(({ parent }, id) => {
        const item = this.all[id];
        item.parent = this.all[parent] ?? null;
        const siblings = item.parent?.children ?? this.items;
        item.path = `${item.parent?.path ?? ''}/${siblings.length}`;
        siblings.push(item);
      });
    } catch (error) {
      this.problem = error.message;
    }
  }

  get root() {
    return this.all.find(({ kind }) => kind === 'root') ?? null;
  }

  /** The innermost item at an offset; null if there is none. */
  itemAt(offset) {
    return this.problem === null ? (this.all[this.#engine.call('at', offset).item] ?? null) : null;
  }

  /** The fields of an item: { id, item, name, title, about, kind, parts, choices, written, needed, effective, transform }. */
  fields(item) {
    return this.#engine.call('fields', item.id).fields.map((field, id) => ({ id, item, ...field }));
  }

  /** What can be done with an item; null: without one. */
  choices(item) {
    const { add, targets, ...others } = this.#engine.call('choices', item?.id ?? -1);
    return {
      add: add.map(({ kind, name }, id) => ({ id, label: kinds[kind](name) })),
      targets: targets.map((id) => this.all[id]),
      ...others,
    };
  }

  /** How an item can be moved: { light, space, world, origin }, with matrices row by row; null if it cannot. */
  handle(item) {
    const found = this.#engine.call('handle', item.id);
    return found.world === undefined || ![...found.space, ...found.world].every(Number.isFinite)
      ? null
      : { ...found, item, origin: [3, 7, 11].map((i) => found.world[i]) };
  }

  // Edits: { changes, select }. `select`: where the item to select begins in the new text. What is
  // not possible throws an Error.

  /** Sets parts of a field; undefined leaves one as it is. */
  set(field, values) {
    return this.#engine.call('set', field.item.id, field.id, values.map((value) => (value === undefined ? '\0' : `=${value}\0`)).join(''));
  }
  unset(field) {
    return this.#engine.call('unset', field.item.id, field.id);
  }
  addTransform(item, name) {
    return this.#engine.call('add_transform', item.id, { word: name });
  }
  moveTransform(field, step) {
    return this.#engine.call('move_transform', field.item.id, field.id, step);
  }
  /** `kind`: one of choices(near).add. */
  add(near, kind) {
    return this.#engine.call('add', near?.id ?? -1, kind.id);
  }
  remove(item) {
    return this.#engine.call('remove', item.id);
  }
  duplicate(item) {
    return this.#engine.call('duplicate', item.id);
  }
  wrap(item) {
    return this.#engine.call('wrap', item.id);
  }
  reorder(item, step) {
    return this.#engine.call('reorder', item.id, step);
  }
  moveInto(item, group) {
    return this.#engine.call('move_into', item.id, group.id);
  }
  /** By `delta` in the space of the handle; coordinates become multiples of `step`. */
  move(item, delta, step) {
    return this.#engine.call('move', item.id, ...delta, step);
  }
  turn(item, axis, degrees) {
    return this.#engine.call('turn', item.id, axis, degrees);
  }
  scale(item, axis, factor) {
    return this.#engine.call('scale', item.id, axis, factor);
  }
}
