// Documents stored by the browser. Each tab has its own document and holds a lock on it, so that
// two tabs never write the same one.

const name = 'scenefile';
const maxRecent = 12;

let database = null;

function result(request) {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}

async function open() {
  database ??= new Promise((resolve, reject) => {
    const request = indexedDB.open(name, 1);
    request.onupgradeneeded = () => {
      request.result.createObjectStore('documents', { keyPath: 'id' });
      request.result.createObjectStore('files');
    };
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
  return database;
}

async function stores(mode) {
  const transaction = (await open()).transaction(['documents', 'files'], mode);
  return { documents: transaction.objectStore('documents'), files: transaction.objectStore('files') };
}

// randomUUID() only exists where the page comes by https, which a frame or a host in a laboratory may lack.
export const newId = () =>
  [...crypto.getRandomValues(new Uint8Array(16))].map((byte) => byte.toString(16).padStart(2, '0')).join('');

/** Locks the document for this tab; false if another tab holds it. */
export function hold(id) {
  if (navigator.locks === undefined) {
    return Promise.resolve(true);
  }
  return new Promise((resolve) => {
    navigator.locks
      .request(`${name}-${id}`, { ifAvailable: true }, (lock) => {
        resolve(lock !== null);
        return lock === null ? undefined : new Promise((release) => releases.set(id, release));
      })
      .catch(() => resolve(true));
  });
}
const releases = new Map();
export function release(id) {
  releases.get(id)?.();
  releases.delete(id);
}

/** The documents of all tabs, the latest first, without their files. */
export async function list() {
  const { documents } = await stores('readonly');
  return (await result(documents.getAll())).sort((a, b) => b.time - a.time);
}

export async function load(id) {
  const { documents, files } = await stores('readonly');
  const [document, contents] = await Promise.all([result(documents.get(id)), result(files.get(id))]);
  return document && { ...document, files: new Map(contents ?? []) };
}

/** `files`: null if they have not changed. */
export async function save({ id, path, text, options, unsafe }, files) {
  const to = await stores('readwrite');
  const requests = [result(to.documents.put({ id, path, text, options, unsafe, time: Date.now() }))];
  if (files !== null) {
    requests.push(result(to.files.put([...files], id)));
  }
  to.documents.transaction.commit(); // now, as the page may be about to end
  await Promise.all(requests);
}

/** Deletes the oldest documents, except those that a tab holds. */
export async function tidy() {
  const old = (await list()).slice(maxRecent);
  const held = new Set(((await navigator.locks?.query())?.held ?? []).map((lock) => lock.name));
  const { documents, files } = await stores('readwrite');
  for (const { id } of old.filter(({ id: some }) => !held.has(`${name}-${some}`))) {
    documents.delete(id);
    files.delete(id);
  }
}

// A scene is marked before it is drawn, and unmarked afterwards: a remaining mark shows that the
// page crashed while drawing.
const mark = (id) => `scenefile-drawing-${id}`;
const quietly = (work) => {
  try {
    return work();
  } catch {
    return null; // storage is switched off
  }
};
export const begin = (id) => quietly(() => localStorage.setItem(mark(id), '1'));
export const end = (id) => quietly(() => localStorage.removeItem(mark(id)));
export const wasLeft = (id) => quietly(() => localStorage.getItem(mark(id))) !== null;

export const remember = (key, value) => quietly(() => localStorage.setItem(`scenefile-${key}`, value));
export const remembered = (key) => quietly(() => localStorage.getItem(`scenefile-${key}`));
export const tabDocument = () => quietly(() => sessionStorage.getItem('document'));
export const setTabDocument = (id) => quietly(() => sessionStorage.setItem('document', id));
