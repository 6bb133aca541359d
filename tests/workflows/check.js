// Checks the workflows and the action for GitHub, as far as possible without it:
//
//     node tests/workflows/check.js
//
// Each file follows GitHub's schema. A step of our own workflows runs only commands that also run elsewhere: targets of the
// Makefile and scripts of this repository, apart from those in `plain`. Actions have the number of a major version. Each
// value of a matrix that a job uses exists.

import { validateAction, validateWorkflow } from '@action-validator/core';
import { accessSync, constants, readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parse } from 'yaml';

const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));
const read = (path) => readFileSync(join(root, path), 'utf8');
const plain = ['apt-get', 'docker', 'gh']; // what only makes sense there
const targets = new Set([...read('Makefile').matchAll(/^([a-z][a-z -]*):/gm)].flatMap(([, names]) => names.split(' ')));
const workflows = readdirSync(join(root, '.github/workflows')).map((name) => `.github/workflows/${name}`);

const problems = [];
const report = (path, text) => problems.push(`${path}: ${text}`);

/** What follows GitHub's schema wrongly, down to the innermost places. */
function checkSchema(path, validate) {
  const told = ({ path: place = '', title, detail = title, states = [] }) =>
    states.length > 0 ? states.flatMap(({ errors }) => errors.flatMap(told)) : [`${place}: ${detail}`];
  for (const text of new Set(validate(read(path)).errors.flatMap(told))) {
    report(path, text);
  }
}

/** The values of the matrix of a job, by name. */
function matrixOf({ strategy: { matrix = {} } = {} }) {
  const { include = [], ...lists } = matrix;
  const values = { ...lists };
  for (const [name, value] of include.flatMap(Object.entries)) {
    values[name] = [...(values[name] ?? []), value];
  }
  return values;
}

function checkCommand(path, command) {
  const [program, ...words] = command.split(/\s+/);
  if (program === 'make') {
    const unknown = words.filter((word) => !/^[A-Z]+=/.test(word) && !targets.has(word));
    unknown.forEach((word) => report(path, `the Makefile has no target ${word}`));
  } else if (program.includes('/')) {
    try {
      accessSync(join(root, program), constants.X_OK);
    } catch {
      report(path, `${program} cannot be run`);
    }
  } else if (!plain.includes(program)) {
    report(path, `"${command}" is neither a target of the Makefile nor a script; it would only run there`);
  }
}

for (const path of workflows) {
  checkSchema(path, validateWorkflow);
  for (const [name, job] of Object.entries(parse(read(path)).jobs)) {
    const place = `${path}: ${name}`;
    const matrix = matrixOf(job);
    for (const [, used] of JSON.stringify(job).matchAll(/\bmatrix\.(\w+)/g)) {
      if (!(used in matrix)) report(place, `its matrix has no ${used}`);
    }
    const variants = (text) =>
      Object.entries(matrix).reduce((some, [key, values]) => {
        const use = new RegExp(`\\$\\{\\{ *matrix\\.${key} *\\}\\}`, 'g');
        return some.flatMap((one) => [...new Set(values.map((value) => one.replace(use, value)))]);
      }, [text]);
    for (const { uses, run = '' } of job.steps) {
      if (uses !== undefined && !/^(\.\/|[\w.-]+\/[\w./-]+@v\d+$)/.test(uses)) report(place, `${uses} has no major version`);
      run.split(/&&|\n/).map((line) => line.trim()).filter(Boolean).flatMap(variants).forEach((line) => checkCommand(place, line));
    }
  }
}
checkSchema('docs/examples/github-classroom/classroom.yml', validateWorkflow);
checkSchema('action.yml', validateAction);

console.log([...problems, `${workflows.length + 2} files, ${problems.length} problems`].join('\n'));
process.exit(problems.length === 0 && workflows.length > 0 ? 0 : 1);
