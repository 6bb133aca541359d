// The panel that edits a scene without typing text: the parts of the scene as a tree, buttons for
// actions, and the fields of the selected part. Every action is an edit of the text (edits.js),
// which is the only state: after each change the panel is made from the text again.

import fields from 'scenefile-fields';
import { byId, h } from '../dom.js';
import {
  addItem, addTransform, canDuplicate, canWrap, duplicateItem, kindsToAdd, moveInto, moveTransform, neighborOf, numberText,
  removeField, removeItem, reorderItem, setPart, setParts, targetsFor, whyNotRemoved, wrapItem,
} from './edits.js';
import { Gizmo } from './gizmo.js';
import { fieldsOfItem, itemAt, modelOf } from './model.js';

const maxRows = 400;

const partNames = {
  attenuationCoeff: ['constant', 'linear', 'quadratic'],
  function: ['constant', 'linear', 'quadratic'],
  rotate: ['x', 'y', 'z', 'degrees'],
};
const colorParts = ['red', 'green', 'blue'];

function partName(spec, i) {
  if (spec.kind === 'matrix') {
    return `row ${Math.floor(i / 4) + 1}, column ${(i % 4) + 1}`;
  }
  const names = partNames[spec.name] ?? (spec.kind === 'color' ? colorParts : spec.kind === 'image' ? ['file', 'repeats along u', 'repeats along v'] : ['x', 'y', 'z']);
  return names[i];
}

const hexOf = (values) =>
  `#${values.map((value) => Math.round(255 * Math.min(1, Math.max(0, Number(value)))).toString(16).padStart(2, '0')).join('')}`;
const fromHex = (hex) => [1, 3, 5].map((i) => String(Number((parseInt(hex.slice(i, i + 2), 16) / 255).toFixed(3))));

// A description of the range if the number is outside it; otherwise an empty text.
function outside({ min, max, above, below } = {}, number) {
  const low = min ?? above;
  const high = max ?? below;
  const wrong = number < min || number > max || number <= above || number >= below;
  const bound = (word, exclusive) => (exclusive === undefined ? word : `${word}, exclusive,`);
  return !wrong ? '' : low === undefined ? `at most ${high}` : high === undefined ? `${bound('at least', above)} ${low}` : `from ${low} to ${high}${above === undefined && below === undefined ? '' : ', exclusive'}`;
}

export class EditPanel {
  #host;
  #model = null;
  #item = null;
  #toggled = new Map();
  #tree = byId('edit-tree');
  #form = byId('edit-fields');
  #gizmo;

  /** `host`: text() of the scene, change(changes), files() other than the scene, selected(model, item), view() and viewport() of the picture. */
  constructor(host) {
    this.#host = host;
    this.#gizmo = new Gizmo({ view: host.view, viewport: host.viewport, apply: (edit) => this.#apply(edit) });
    this.#tree.addEventListener('keydown', (event) => this.#treeKey(event));
    this.#form.addEventListener('submit', (event) => event.preventDefault());
    const actions = {
      'edit-duplicate': () => this.#apply(duplicateItem(this.#model, this.#item), 'duplicated'),
      'edit-delete': () => this.#remove(),
      'edit-up': () => this.#reorder(-1),
      'edit-down': () => this.#reorder(1),
      'edit-wrap': () => this.#apply(wrapItem(this.#model, this.#item), 'put into a group'),
    };
    for (const [id, act] of Object.entries(actions)) {
      byId(id).addEventListener('click', act);
    }
  }

  get model() {
    return this.#model;
  }
  get item() {
    return this.#item;
  }

  /** The text changed or was replaced: selects the item at an offset. */
  update(offset = this.#item?.from ?? 0) {
    this.#model = modelOf(this.#host.text(), fields);
    this.#select(itemAt(this.#model, offset) ?? this.#sameKind() ?? this.#model.root ?? this.#model.all[0] ?? null);
  }

  // Global data and camera may be absent from the file; then they have no offset.
  #sameKind() {
    const kind = this.#item?.from === -1 ? this.#item.kind : '';
    return this.#model.all.find((item) => item.kind === kind);
  }

  /** Selects the item at an offset of the text. */
  selectAt(offset) {
    this.#select(itemAt(this.#model, offset) ?? this.#item);
  }

  #select(item) {
    this.#item = item;
    for (let above = item?.parent; above; above = above.parent) {
      this.#toggled.set(above.path, true);
    }
    this.#showTree();
    this.#showActions();
    this.#showFields();
    this.#gizmo.select(this.#model, item);
    this.#host.selected(this.#model, item);
  }

  /** The picture is seen from elsewhere, or has another size; `shown`: whether the panels are. */
  viewChanged(shown) {
    shown ? this.#gizmo.show() : this.#gizmo.hide();
  }

  #apply({ changes, select }, done) {
    const label = this.#item?.label ?? '';
    this.#host.change(changes);
    this.update(select ?? this.#item?.from ?? 0);
    byId('edit-status').textContent = done ? `${label}: ${done}` : '';
  }

  // After the event of a field, when the focus is where it goes: the fields are rebuilt, and
  // Firefox would lose the focus.
  #later(field, edit) {
    const item = this.#item;
    const at = fieldsOfItem(this.#model, item).findIndex(({ spec, element }) => spec.name === field.spec.name && element === field.element);
    setTimeout(() => {
      const same = this.#item && fieldsOfItem(this.#model, this.#item)[at];
      if (same?.spec.name === field.spec.name && this.#item.kind === item.kind && this.#item.from === item.from) {
        this.#apply(edit(same));
      }
    });
  }

  #remove() {
    if (this.#item !== null && whyNotRemoved(this.#model, this.#item) === null) {
      this.#apply(removeItem(this.#model, this.#item), 'deleted');
      this.#focusRow();
    }
  }

  #reorder(step) {
    if (this.#item !== null && neighborOf(this.#model, this.#item, step) !== undefined) {
      this.#apply(reorderItem(this.#model, this.#item, step), step < 0 ? 'moved up' : 'moved down');
    }
  }

  // The tree.

  #isOpen(item) {
    return this.#toggled.get(item.path) ?? (item.kind === 'root' || (item.kind === 'group' && item.children.length < 20 && this.#model.all.length < 200));
  }

  #visibleRows() {
    const rows = [];
    const visit = (item, level) => {
      rows.push({ item, level });
      if (item.children.length > 0 && this.#isOpen(item)) {
        item.children.forEach((child) => visit(child, level + 1));
      }
    };
    this.#model.items.forEach((item) => visit(item, 1));
    return rows;
  }

  #showTree() {
    const hadFocus = this.#tree.contains(document.activeElement);
    const rows = this.#visibleRows();
    const at = rows.findIndex(({ item }) => item === this.#item);
    const first = Math.max(0, Math.min(at - maxRows / 2, rows.length - maxRows));
    const shown = rows.slice(first, first + maxRows);
    this.#tree.replaceChildren(
      ...shown.map(({ item, level }) => {
        const isSelected = item === this.#item;
        const row = h('div', {
          role: 'treeitem',
          className: 'row',
          tabIndex: isSelected ? 0 : -1,
          'aria-level': String(level),
          'aria-selected': String(isSelected),
          onclick: () => {
            this.#select(item);
            this.#focusRow();
          },
          ondblclick: () => this.#toggle(item),
        }, item.children.length === 0 ? '' : this.#isOpen(item) ? '▾ ' : '▸ ', h('span', {}, item.label), h('span', { className: 'kind' }, item.kind === 'primitive' || item.label.toLowerCase().includes(item.kind) || item.from < 0 && item.kind !== 'root' ? '' : ` ${item.kind === 'root' ? '' : item.kind}`));
        row.style.paddingLeft = `${level * 14 - 6}px`;
        if (item.children.length > 0) {
          row.setAttribute('aria-expanded', String(this.#isOpen(item)));
        }
        return row;
      }),
      ...(rows.length > shown.length ? [h('div', { className: 'help' }, `${rows.length - shown.length} more rows; close groups to see them`)] : []),
    );
    const selected = this.#tree.querySelector('[aria-selected="true"]');
    selected?.scrollIntoView({ block: 'nearest' });
    if (hadFocus) {
      selected?.focus({ preventScroll: true });
    }
  }

  #focusRow() {
    this.#tree.querySelector('[aria-selected="true"]')?.focus();
  }

  #toggle(item, open = !this.#isOpen(item)) {
    this.#toggled.set(item.path, open);
    this.#showTree();
  }

  #treeKey(event) {
    const rows = this.#visibleRows().map(({ item }) => item);
    const at = rows.indexOf(this.#item);
    const go = (item) => item && (this.#select(item), this.#focusRow());
    const { key } = event;
    if (at < 0 || event.ctrlKey || event.metaKey) {
      return;
    }
    if (event.altKey && (key === 'ArrowUp' || key === 'ArrowDown')) {
      this.#reorder(key === 'ArrowUp' ? -1 : 1);
    } else if (event.altKey) {
      return;
    } else if (key === 'ArrowDown' || key === 'ArrowUp') {
      go(rows[at + (key === 'ArrowDown' ? 1 : -1)]);
    } else if (key === 'Home' || key === 'End') {
      go(rows.at(key === 'Home' ? 0 : -1));
    } else if (key === 'ArrowRight') {
      if (this.#item.children.length > 0 && !this.#isOpen(this.#item)) {
        this.#toggle(this.#item, true);
      } else {
        go(this.#item.children[0]);
      }
    } else if (key === 'ArrowLeft') {
      if (this.#item.children.length > 0 && this.#isOpen(this.#item)) {
        this.#toggle(this.#item, false);
      } else {
        go(this.#item.parent);
      }
    } else if (key === 'Delete') {
      this.#remove();
    } else if (key === 'Enter') {
      this.#form.querySelector('input, select')?.focus();
    } else {
      return;
    }
    event.preventDefault();
  }

  // Actions.

  #showActions() {
    const [model, item] = [this.#model, this.#item];
    const usable = model.problem < 0;
    byId('edit-broken').hidden = usable;
    const off = (id, why) => {
      byId(id).disabled = why !== null;
      byId(id).title = why ?? '';
    };
    const none = !usable || item === null ? 'the text has errors' : null;
    off('edit-duplicate', none ?? (canDuplicate(model, item) ? null : item.shared ? 'its transblock has several objects' : 'every scene has one'));
    off('edit-delete', none ?? whyNotRemoved(model, item));
    off('edit-up', none ?? (neighborOf(model, item, -1) === undefined ? 'it is the first' : null));
    off('edit-down', none ?? (neighborOf(model, item, 1) === undefined ? 'it is the last' : null));
    off('edit-wrap', none ?? (canWrap(model, item) ? null : 'it cannot be in a group'));
    byId('edit-add-menu').hidden = !usable;
    const close = (menu) => (byId(menu).open = false);
    byId('edit-add').replaceChildren(
      ...(usable ? kindsToAdd(model) : []).slice(0, 100).map((kind) =>
        h('button', { type: 'button', onclick: () => (close('edit-add-menu'), this.#apply(addItem(model, item, kind), `${kind.label} added`), this.#focusRow()) }, kind.label),
      ),
    );
    const targets = none === null ? targetsFor(model, item).slice(0, 100) : [];
    byId('edit-move-menu').hidden = targets.length === 0;
    byId('edit-move').replaceChildren(
      ...targets.map((target) =>
        h('button', { type: 'button', onclick: () => (close('edit-move-menu'), this.#apply(moveInto(model, item, target), `moved to ${target.label}`), this.#focusRow()) },
          [...pathLabels(target)].join(' / ')),
      ),
    );
  }

  // Fields.

  #showFields() {
    const [model, item] = [this.#model, this.#item];
    byId('edit-title').textContent = item === null ? 'The text has no scene' : item.label;
    if (item === null || model.problem >= 0) {
      this.#form.replaceChildren();
      return;
    }
    const list = fieldsOfItem(model, item);
    const seen = new Map();
    const rows = list.map((field) => {
      const count = seen.get(field.spec.name) ?? 0;
      seen.set(field.spec.name, count + 1);
      return this.#fieldRow(field, `${field.spec.name}-${count}`);
    });
    const placing = model.xml && item.block !== null ? [this.#transformButtons(item)] : [];
    const focused = document.activeElement?.dataset?.field;
    const datalist = h('datalist', { id: 'edit-files' }, this.#host.files().slice(0, 200).map((name) => h('option', { value: name })));
    const lastPlacing = list.findLastIndex(({ movable }) => movable);
    const at = lastPlacing >= 0 ? lastPlacing + 1 : list.filter(({ own }) => own).length;
    this.#form.replaceChildren(...rows.slice(0, at), ...placing, ...rows.slice(at), datalist,
      ...(rows.length + placing.length === 0 ? [h('p', { className: 'help' }, 'Add lights, shapes and groups here.')] : []));
    if (focused !== undefined) {
      const same = this.#form.querySelector(`[data-field="${CSS.escape(focused)}"]`);
      same?.focus({ preventScroll: true });
      same?.select?.(); // as after Tab
    }
  }

  #transformButtons(item) {
    const names = { translate: 'translation', rotate: 'rotation', scale: 'scale', matrix: 'matrix' };
    return h('div', { className: 'bar' }, Object.entries(names).map(([name, title]) =>
      h('button', { type: 'button', 'data-field': `add-${name}`, onclick: () => this.#apply(addTransform(this.#model, item, name), `${title} added`) }, `+ ${title}`)));
  }

  #fieldRow(field, id) {
    const { spec, values, element, unused, movable } = field;
    const label = h('span', { className: 'field-title', title: spec.about, id: `edit-${id}` }, spec.title ?? spec.name);
    const remark = h('div', { className: 'remark', role: 'alert' });
    const count = values.length;
    const inputs = values.map((value, i) => this.#input(field, i, `${id}-${i}`, count, remark));
    const isColor = spec.kind === 'color';
    const known = values.map((value, i) => value ?? [spec.start].flat(2)[i] ?? 0);
    const picker = isColor
      ? [h('input', { type: 'color', value: hexOf(known), 'data-field': `${id}-color`, 'aria-label': `${spec.title}: choose`,
          onchange: ({ target }) => this.#later(field, (same) => setParts(this.#model, same, fromHex(target.value))) })]
      : [];
    const button = (name, text, about, act, disabled = false) =>
      h('button', { type: 'button', className: 'small', 'aria-label': `${spec.title}: ${about}`, title: about, 'data-field': `${id}-${name}`, disabled, onclick: act }, text);
    const buttons = [];
    if (movable) {
      for (const [step, text, about] of [[-1, '↑', 'move up'], [1, '↓', 'move down']]) {
        const moved = moveTransform(this.#model, field, step);
        buttons.push(button(about, text, about, () => this.#apply(moved), moved === null));
      }
    }
    if (element !== null && !field.required && !spec.required && spec.instead === undefined && !(field.own && spec.kind === 'choice')) {
      buttons.push(button('remove', '×', 'remove', () => this.#apply(removeField(this.#model, field), `${spec.title} removed`)));
    }
    const group = count > 1 ? { role: 'group', 'aria-labelledby': `edit-${id}` } : {};
    return h('div', { className: `field${element === null ? ' unset' : ''}`, ...group },
      label, h('div', { className: `inputs ${spec.kind}` }, picker, inputs), h('div', { className: 'buttons' }, buttons),
      unused ? h('div', { className: 'remark' }, `has no effect on a ${field.item.type} light`) : null, remark);
  }

  #input(field, i, id, count, remark) {
    const { spec, values } = field;
    const part = spec.kind === 'matrix' ? {} : spec.parts[i];
    const name = count === 1 ? spec.title : `${spec.title}: ${partName(spec, i)}`;
    const set = (value) => this.#later(field, (same) => setPart(this.#model, same, i, value));
    const common = { 'data-field': id, 'aria-label': name, title: part.about || spec.about };
    if (spec.kind === 'choice') {
      const now = values[i] ?? '';
      const known = [...new Set([...(spec.values.includes(now) ? [] : [now]), ...spec.values])];
      return h('select', { ...common, onchange: ({ target }) => set(target.value) },
        known.map((value) => h('option', { value, selected: value === now }, value || 'not given')));
    }
    const start = [spec.start].flat(2)[i];
    if (spec.kind === 'text' || part.text) {
      const isFile = spec.kind === 'image' || /file/i.test(spec.name);
      const input = h('input', { ...common, type: 'text', value: values[i] ?? '', placeholder: values[i] === null ? 'not given' : '', spellcheck: false,
        onchange: ({ target }) => (target.value === '' ? (target.value = values[i] ?? '') : set(target.value)) });
      if (isFile) {
        input.setAttribute('list', 'edit-files');
      }
      return input;
    }
    return h('input', { ...common, type: 'number', step: 'any', value: values[i]?.trim() ?? '', placeholder: String(start ?? ''),
      onchange: ({ target }) => {
        const text = numberText(target.value);
        if (text === null) {
          target.value = values[i]?.trim() ?? '';
          return;
        }
        const wrong = outside(part, Number(text));
        target.setAttribute('aria-invalid', String(wrong !== ''));
        remark.textContent = wrong === '' ? '' : `${text} is out of range: it must be ${wrong}`;
        if (wrong === '') {
          set(text);
        }
      } });
  }
}

function* pathLabels(item) {
  if (item.parent !== null) {
    yield* pathLabels(item.parent);
  }
  yield item.label;
}
