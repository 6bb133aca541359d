#!/usr/bin/env node
// The program for Node.js: the same options, output and exit status as the native program.

import { runProgram } from '../lib/program.js';

process.exitCode = await runProgram(process.argv.slice(2));
