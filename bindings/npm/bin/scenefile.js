#!/usr/bin/env node
// The program for Node.js: the same options, output and exit status as the native
// program, and an additional command: `scenefile lsp`, the language server.

import { runProgram } from '../lib/program.js';

const words = process.argv.slice(2);
if (words[0] === 'lsp') {
  const { serve } = await import('../lib/language-server.js');
  serve(process.stdin, process.stdout);
} else {
  process.exitCode = await runProgram(words);
}
