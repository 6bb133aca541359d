// The program with the files of this machine.

import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import process from 'node:process';
import tty from 'node:tty';

const require = createRequire(import.meta.url);

// The environment variables that the program can read.
const variables = ['CI', 'COLORTERM', 'CS123_DATA', 'NO_COLOR', 'TERM'];

// The core only supports forward slashes.
function withSlashes(word) {
  return process.platform === 'win32' ? word.replaceAll('\\', '/') : word;
}

/** Runs `scenefile ...words`; resolves to its exit status. */
export async function runProgram(words) {
  const create = require('../wasm/scenefile-node.cjs');
  const module = await create({
    wasmBinary: readFileSync(new URL('../wasm/scenefile.wasm', import.meta.url)),
    preRun: [
      (m) => {
        for (const name of variables) {
          if (process.env[name] !== undefined) {
            m.ENV[name] = process.env[name];
          }
        }
      },
    ],
  });
  for (const number of [0, 1, 2]) {
    module.FS.streams[number].tty = tty.isatty(number);
  }
  return module.callMain(words.map(withSlashes));
}
