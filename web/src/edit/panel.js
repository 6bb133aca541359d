// The panel that edits a scene without typing text: the parts of the scene as a tree, buttons for
// actions, and the fields of the selected part. Every action is an edit of the text (scene-text.js),
// which is the only state: after each change the panel is made from the text again.

import { byId, h } from '../dom.js';
import { Gizmo } from './gizmo.js';

const maxRows = 400;

const partNames = {
  color: ['red', 'green', 'blue'],
  coefficients: ['constant', 'linear', 'quadratic'],
  rotation: ['x', 'y', 'z', 'degrees'],
  vector: ['x', 'y', 'z'],
  image: ['file', 'repeats along u', 'repeats along v'],
};

const partName = (kind, i) => (kind === 'matrix' ? `row ${Math.floor(i / 4) + 1}, column ${(i % 4) + 1}` : partNames[kind][i]);

const hexOf = (values) =>
  `#${values.map((value) => Math.round(255 * Math.min(1, Math.max(0, Number(value)))).toString(16).padStart(2, '0')).join('')}`;
const fromHex = (hex) => [1, 3, 5].map((i) => String(Number((parseInt(hex.slice(i, i + 2), 16) / 255).toFixed(3))));

// The attributes of an object in XML; they are shown before its transforms.
const attributes = ['name', 'filename', 'meshfile'];

export class EditPanel {
  #host;
  #model = null; // SceneText
  #item = null;
  #place = 0; // where it begins, or did before the text had errors
  #choices = null; // what can be done with it
  #toggled = new Map();
  #tree = byId('edit-tree');
  #form = byId('edit-fields');
  #gizmo;

  /** `host`: model() of the scene's text, change(changes), files() other than the scene, goTo(line), selected(model, item), view() and viewport() of the picture. */
  constructor(host) {
    this.#host = host;
    this.#gizmo = new Gizmo({ view: host.view, viewport: host.viewport, apply: (edit) => this.#apply(edit) });
    this.#tree.addEventListener('keydown', (event) => this.#treeKey(event));
    this.#form.addEventListener('submit', (event) => event.preventDefault());
    const actions = {
      'edit-duplicate': () => this.#apply(this.#model.duplicate(this.#item), 'duplicated'),
      'edit-delete': () => this.#remove(),
      'edit-up': () => this.#reorder(-1),
      'edit-down': () => this.#reorder(1),
      'edit-wrap': () => this.#apply(this.#model.wrap(this.#item), 'put into a group'),
    };
    for (const [id, act] of Object.entries(actions)) {
      byId(id).addEventListener('click', act);
    }
  }

  /** Where the selected item begins in the text. */
  get place() {
    return this.#place;
  }

  /** The text changed or was replaced: selects the item at an offset. */
  update(offset = this.#place) {
    this.#model = this.#host.model();
    this.#place = offset;
    this.#select(this.#model.itemAt(offset) ?? this.#sameKind() ?? this.#model.root ?? this.#model.all[0] ?? null);
  }

  // Global data and camera may be absent from the file; then they have no offset.
  #sameKind() {
    const kind = this.#item?.from === -1 ? this.#item.kind : '';
    return this.#model.all.find((item) => item.kind === kind);
  }

  /** Selects the item at an offset of the text. */
  selectAt(offset) {
    this.#select(this.#model.itemAt(offset) ?? this.#item);
  }

  #select(item) {
    this.#item = item;
    this.#place = item?.from ?? this.#place;
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
    this.update(select ?? this.#place);
    byId('edit-status').textContent = done ? `${label}: ${done}` : '';
  }

  // After the event of a field, when the focus is where it goes: the fields are rebuilt, and
  // Firefox would lose the focus.
  #later(field, edit) {
    const { item } = field;
    setTimeout(() => {
      if (this.#item?.kind !== item.kind || this.#item.from !== item.from) {
        return;
      }
      const same = this.#model.fields(this.#item)[field.id];
      if (same?.name === field.name) {
        this.#apply(edit(same));
      }
    });
  }

  #remove() {
    if (this.#item !== null && this.#choices.not_removed === undefined) {
      this.#apply(this.#model.remove(this.#item), 'deleted');
      this.#focusRow();
    }
  }

  #reorder(step) {
    if (this.#item !== null && this.#choices[step < 0 ? 'before' : 'after']) {
      this.#apply(this.#model.reorder(this.#item, step), step < 0 ? 'moved up' : 'moved down');
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
    const usable = model.problem === null;
    this.#choices = usable ? model.choices(item) : { add: [], targets: [] };
    const choices = this.#choices;
    const off = (id, why) => {
      byId(id).disabled = why !== undefined;
      byId(id).title = why ?? '';
    };
    const none = usable && item !== null ? undefined : 'the text has errors';
    off('edit-duplicate', none ?? choices.not_duplicated);
    off('edit-delete', none ?? choices.not_removed);
    off('edit-up', none ?? (choices.before ? undefined : 'it is the first'));
    off('edit-down', none ?? (choices.after ? undefined : 'it is the last'));
    off('edit-wrap', none ?? choices.not_wrapped);
    byId('edit-add-menu').hidden = !usable;
    const close = (menu) => (byId(menu).open = false);
    byId('edit-add').replaceChildren(
      ...choices.add.slice(0, 100).map((kind) =>
        h('button', { type: 'button', onclick: () => (close('edit-add-menu'), this.#apply(model.add(item, kind), `${kind.label} added`), this.#focusRow()) }, kind.label),
      ),
    );
    const targets = choices.targets.slice(0, 100);
    byId('edit-move-menu').hidden = targets.length === 0;
    byId('edit-move').replaceChildren(
      ...targets.map((target) =>
        h('button', { type: 'button', onclick: () => (close('edit-move-menu'), this.#apply(model.moveInto(item, target), `moved to ${target.label}`), this.#focusRow()) },
          [...pathLabels(target)].join(' / ')),
      ),
    );
  }

  // Fields.

  #showFields() {
    const [model, item] = [this.#model, this.#item];
    byId('edit-title').textContent = item?.label ?? (model.problem === null ? 'The text has no scene' : 'The text has an error');
    if (item === null) {
      const line = /^line (\d+)/.exec(model.problem ?? '')?.[1];
      this.#form.replaceChildren(
        ...(model.problem === null ? [] : [h('p', { className: 'help', role: 'alert' }, `${model.problem}.`)]),
        ...(line === undefined ? [] : [h('button', { type: 'button', onclick: () => this.#host.goTo(Number(line)) }, `Go to line ${line}`)]),
      );
      return;
    }
    const list = model.fields(item);
    const transforms = list.filter(({ transform }) => transform);
    const seen = new Map();
    const rows = list.map((field) => {
      const count = seen.get(field.name) ?? 0;
      seen.set(field.name, count + 1);
      return this.#fieldRow(field, `${field.name}-${count}`, transforms);
    });
    const placing = model.xml && ['group', 'primitive', 'instance'].includes(item.kind) ? [this.#transformButtons(item)] : [];
    const focused = document.activeElement?.dataset?.field;
    const datalist = h('datalist', { id: 'edit-files' }, this.#host.files().slice(0, 200).map((name) => h('option', { value: name })));
    const at = list.findLastIndex(({ name, transform }) => transform || attributes.includes(name)) + 1;
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
      h('button', { type: 'button', 'data-field': `add-${name}`, onclick: () => this.#apply(this.#model.addTransform(item, name), `${title} added`) }, `+ ${title}`)));
  }

  #fieldRow(field, id, transforms) {
    const { title, about, kind, parts } = field;
    const label = h('span', { className: 'field-title', title: about, id: `edit-${id}` }, title);
    const remark = h('div', { className: 'remark', role: 'alert' });
    const inputs = parts.map((_, i) => this.#input(field, i, `${id}-${i}`, remark));
    const picker = kind === 'color'
      ? [h('input', { type: 'color', value: hexOf(parts.map(({ value }) => value)), 'data-field': `${id}-color`, 'aria-label': `${title}: choose`,
          onchange: ({ target }) => this.#later(field, (same) => this.#model.set(same, fromHex(target.value))) })]
      : [];
    const button = (name, text, does, act, disabled = false) =>
      h('button', { type: 'button', className: 'small', 'aria-label': `${title}: ${does}`, title: does, 'data-field': `${id}-${name}`, disabled, onclick: act }, text);
    const buttons = [];
    if (this.#model.xml && field.transform) {
      for (const [step, text, does] of [[-1, '↑', 'move up'], [1, '↓', 'move down']]) {
        const isLast = transforms.at(step < 0 ? 0 : -1) === field;
        buttons.push(button(does, text, does, () => this.#apply(this.#model.moveTransform(field, step)), isLast));
      }
    }
    if (field.written && !field.needed) {
      buttons.push(button('remove', '×', 'remove', () => this.#apply(this.#model.unset(field), `${title} removed`)));
    }
    const group = parts.length > 1 ? { role: 'group', 'aria-labelledby': `edit-${id}` } : {};
    return h('div', { className: `field${field.written ? '' : ' unset'}`, ...group },
      label, h('div', { className: `inputs ${kind}` }, picker, inputs), h('div', { className: 'buttons' }, buttons),
      field.effective ? null : h('div', { className: 'remark' }, `has no effect on a ${field.item.label}`), remark);
  }

  #input(field, i, id, remark) {
    const { title, about, kind, parts, choices } = field;
    const { value, written, number } = parts[i];
    const now = written ? value.trim() : '';
    const common = { 'data-field': id, 'aria-label': parts.length === 1 ? title : `${title}: ${partName(kind, i)}`, title: about };
    // What is refused is said below the field.
    const set = (target) => {
      const values = parts.map((_, k) => (k === i ? target.value : undefined));
      try {
        this.#model.set(field, values);
      } catch (error) {
        target.setAttribute('aria-invalid', 'true');
        remark.textContent = error.message;
        return;
      }
      this.#later(field, (same) => this.#model.set(same, values));
    };
    const setIfGiven = ({ target }) => (target.value === '' ? (target.value = now) : set(target));
    if (kind === 'choice') {
      return h('select', { ...common, onchange: ({ target }) => set(target) },
        [...new Set([now, ...choices])].map((choice) => h('option', { value: choice, selected: choice === now }, choice || 'not given')));
    }
    if (!number) {
      const input = h('input', { ...common, type: 'text', value: now, placeholder: written ? '' : 'not given', spellcheck: false, onchange: setIfGiven });
      if (kind === 'image' || kind === 'file') {
        input.setAttribute('list', 'edit-files');
      }
      return input;
    }
    return h('input', { ...common, type: 'number', step: 'any', value: now, placeholder: value, onchange: setIfGiven });
  }
}

function* pathLabels(item) {
  if (item.parent !== null) {
    yield* pathLabels(item.parent);
  }
  yield item.label;
}
