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

/** Runs `scenefile ...words`; resolves to its exit status. `lsp` goes on until its client is gone. */
export async function runProgram(words) {
  const module = await load();
  const status = module.callMain(words.map(withSlashes));
  return module._lsp_serves() ? serveEditor(module) : status;
}

async function load() {
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
  return module;
}

// The language server is a function of messages and time; input, output and timer are here.
function serveEditor(module) {
  return new Promise((resolve) => {
    let timer;
    const take = (bytes) => {
      clearTimeout(timer);
      const at = module._malloc(bytes.length);
      module.HEAPU8.set(bytes, at);
      const answer = module._lsp_take(at, bytes.length);
      module._free(at);
      process.stdout.write(module.HEAPU8.slice(answer, answer + module._lsp_answer_size()));
      if (!module._lsp_serves()) {
        process.stdin.destroy();
        resolve(module._lsp_status());
        return;
      }
      const wait = module._lsp_wait();
      if (wait >= 0) {
        timer = setTimeout(take, Math.ceil(wait), new Uint8Array());
      }
    };
    process.stdin.on('data', take);
    process.stdin.on('end', () => {
      clearTimeout(timer);
      resolve(module._lsp_status());
    });
  });
}
