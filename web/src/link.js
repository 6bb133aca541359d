// Links that contain the scene in the fragment (after #), which is never sent to a server.

import { deflateSync, Inflate, strFromU8, strToU8 } from 'fflate';

const maxText = 64 * 1024 * 1024;
const piece = 16 * 1024;

// In pieces, so that a small link cannot expand to fill the memory.
function inflated(bytes) {
  const parts = [];
  let size = 0;
  const inflate = new Inflate((part) => {
    size += part.length;
    parts.push(part);
  });
  for (let at = 0; at < bytes.length; at += piece) {
    inflate.push(bytes.subarray(at, at + piece), at + piece >= bytes.length);
    if (size > maxText) {
      throw new Error('too large');
    }
  }
  const all = new Uint8Array(size);
  parts.reduce((at, part) => (all.set(part, at), at + part.length), 0);
  return all;
}

function toBase64Url(bytes) {
  let text = '';
  for (let i = 0; i < bytes.length; i += 0x8000) {
    text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  }
  return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

function fromBase64Url(text) {
  const plain = atob(text.replaceAll('-', '+').replaceAll('_', '/'));
  return Uint8Array.from(plain, (c) => c.charCodeAt(0));
}

/** `scene`: { name, text, options }. */
export function linkOf(scene) {
  return `#s=${toBase64Url(deflateSync(strToU8(JSON.stringify(scene)), { level: 9 }))}`;
}

/** The scene in a fragment; null if there is none. Throws if it is damaged. */
export function sceneOf(fragment) {
  const packed = new URLSearchParams(fragment.replace(/^#/, '')).get('s');
  if (packed === null) {
    return null;
  }
  let scene;
  try {
    scene = JSON.parse(strFromU8(inflated(fromBase64Url(packed))));
  } catch {
    throw new Error('the link is damaged or was cut off');
  }
  if (typeof scene?.text !== 'string') {
    throw new Error('the link does not contain a scene');
  }
  return { name: typeof scene.name === 'string' ? scene.name : 'scene.xml', text: scene.text, options: scene.options };
}
