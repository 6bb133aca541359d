// Reads dropped and opened files: single files, folders and zip archives.

import { strToU8, unzipSync, zipSync } from 'fflate';

const maxFiles = 10_000;
const maxBytes = 512 * 1024 * 1024;

export const isSceneName = (path) => /\.(xml|json)$/i.test(path);
export const pictureEndings = ['.png', '.jpg', '.jpeg', '.gif', '.bmp', '.tga', '.ppm', '.pgm', '.pnm', '.pfm', '.exr'];
export const isPictureName = (path) => pictureEndings.some((ending) => path.toLowerCase().endsWith(ending));
export const isModelName = (path) => /\.(glb|gltf|obj)$/i.test(path);
export const isMeshName = (path) => /\.(obj|mtl)$/i.test(path);
export const baseName = (path) => path.slice(path.lastIndexOf('/') + 1);

// Files that archivers and operating systems add.
const isLeftBehind = (path) => path.split('/').some((part) => part === '__MACOSX' || part.startsWith('.'));

/** The normalized path; null if it leaves the folder or is not a file of the user. */
export function cleanPath(path) {
  const parts = [];
  for (const part of path.replaceAll('\\', '/').split('/')) {
    if (part === '..') {
      if (parts.pop() === undefined) {
        return null;
      }
    } else if (part !== '' && part !== '.') {
      parts.push(part);
    }
  }
  return parts.length === 0 || isLeftBehind(parts.join('/')) ? null : parts.join('/');
}

function unpacked(bytes, name) {
  let count = 0;
  let size = 0;
  const filter = ({ name: path, originalSize }) => {
    count += 1;
    size += originalSize;
    return count <= maxFiles && size <= maxBytes && !path.endsWith('/') && cleanPath(path) !== null;
  };
  let files;
  try {
    files = unzipSync(bytes, { filter });
  } catch (error) {
    throw new Error(`${name} cannot be unpacked: ${error.message}`);
  }
  if (count > maxFiles || size > maxBytes) {
    throw new Error(`${name} is larger than a page can handle`);
  }
  return Object.entries(files).map(([path, content]) => [cleanPath(path), content]);
}

/** The contents by path; zip archives are unpacked. `list`: [path, File] pairs. */
export async function readAll(list) {
  const files = new Map();
  let size = 0;
  for (const [path, file] of list.slice(0, maxFiles)) {
    size += file.size;
    if (size > maxBytes) {
      throw new Error('these files are larger than a page can handle');
    }
    const bytes = new Uint8Array(await file.arrayBuffer());
    if (bytes[0] === 0x50 && bytes[1] === 0x4b && bytes[2] === 3) {
      for (const [inside, content] of unpacked(bytes, file.name)) {
        files.set(inside, content);
      }
    } else {
      const clean = cleanPath(path);
      if (clean !== null) {
        files.set(clean, bytes);
      }
    }
  }
  return files;
}

export const fromInput = (input) => [...input.files].map((file) => [file.webkitRelativePath || file.name, file]);

async function belowEntry(entry, list) {
  if (entry.isFile) {
    const file = await new Promise((resolve, reject) => entry.file(resolve, reject));
    list.push([entry.fullPath.slice(1), file]);
    return;
  }
  const reader = entry.createReader();
  for (;;) {
    const entries = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
    if (entries.length === 0 || list.length > maxFiles) {
      return;
    }
    for (const below of entries) {
      await belowEntry(below, list);
    }
  }
}

export async function fromDrop(transfer) {
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.()).filter(Boolean);
  if (entries.length === 0) {
    return [...transfer.files].map((file) => [file.name, file]);
  }
  const list = [];
  for (const entry of entries) {
    await belowEntry(entry, list);
  }
  return list;
}

/** A zip archive of these files. */
export function packed(files) {
  return zipSync(
    Object.fromEntries([...files].map(([path, content]) => [path, typeof content === 'string' ? strToU8(content) : content])),
  );
}
