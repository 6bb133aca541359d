// Fails unless two modules import and export the same: node same-interface.js A.wasm B.wasm

import { readFileSync } from 'node:fs';

const interfaceOf = (path) => {
  const module = new WebAssembly.Module(readFileSync(path));
  const lines = [
    ...WebAssembly.Module.imports(module).map(({ module: from, name, kind }) => `import ${from}.${name} ${kind}`),
    ...WebAssembly.Module.exports(module).map(({ name, kind }) => `export ${name} ${kind}`),
  ];
  return lines.sort().join('\n');
};

const [a, b] = process.argv.slice(2);
if (interfaceOf(a) !== interfaceOf(b)) {
  console.error(`${a} and ${b} do not import and export the same`);
  process.exit(1);
}
