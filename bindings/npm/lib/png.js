// Decodes the PNG files that the program writes: 8 bits, RGB, no interlacing, rows without a filter or with
// "Sub". Source: W3C, "Portable Network Graphics (PNG) Specification (Second Edition)".

import { inflateSync } from 'node:zlib';

/** The pixels as RGBA; row 0 is the top row. */
export function decodePng(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const packed = [];
  let width = 0;
  let height = 0;
  for (let at = 8; at < bytes.length; ) {
    const size = view.getUint32(at);
    const kind = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    if (kind === 'IHDR') {
      width = view.getUint32(at + 8);
      height = view.getUint32(at + 12);
    } else if (kind === 'IDAT') {
      packed.push(bytes.subarray(at + 8, at + 8 + size));
    }
    at += 12 + size;
  }
  const rows = inflateSync(Buffer.concat(packed));
  const data = new Uint8ClampedArray(4 * width * height);
  for (let y = 0, from = 0, to = 0; y < height; ++y) {
    const sub = rows[from++] === 1;
    let left = [0, 0, 0];
    for (let x = 0; x < width; ++x, to += 4) {
      for (let c = 0; c < 3; ++c) {
        left[c] = (rows[from++] + (sub ? left[c] : 0)) & 255;
        data[to + c] = left[c];
      }
      data[to + 3] = 255;
    }
  }
  return { width, height, data };
}
