// Converts scenes to .glb and .gltf and validates the files with the Khronos validator (npm ci installs it).
//
//     node validate.js PROGRAM FILE|FOLDER...
//
// Files of more than 64 MB are only counted: the validator needs gigabytes for them (node --max-old-space-size=12000;
// LARGEST=BYTES raises the limit). The exit status is 0 if no file has an error or a warning, and at least one was
// validated.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import validator from "gltf-validator";

const [program, ...places] = process.argv.slice(2);
const scenes = places
  .flatMap((place) =>
    statSync(place).isDirectory() ? readdirSync(place, { recursive: true }).map((name) => join(place, name)) : [place])
  .filter((name) => /\.(xml|json)$/.test(name))
  .sort();

const largest = Number(process.env.LARGEST ?? 64e6);
const folder = mkdtempSync(join(tmpdir(), "glb-"));
const totals = { files: 0, unusable: 0, large: 0, errors: 0, warnings: 0, infos: 0 };
try {
  for (const scene of scenes) {
    try {
      execFileSync(program, ["check", "--quiet", scene], { stdio: "ignore" });
    } catch (error) {
      if (error.status !== 1) throw error;
      totals.unusable += 1; // a file with errors, or one that is not a scene
      continue;
    }
    for (const ending of ["glb", "gltf"]) {
      const file = join(folder, `scene.${ending}`);
      try {
        execFileSync(program, ["convert", "--quiet", scene, file], { stdio: "ignore" });
      } catch (error) {
        if (error.status !== 4 && error.status !== 1) throw error;
        totals.unusable += 1; // such as a mesh that is missing, or more nodes than the limit
        break;
      }
      if (statSync(file).size > largest) {
        totals.large += 1;
        continue;
      }
      const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), { uri: file, maxIssues: 0 });
      const { numErrors, numWarnings, numInfos } = report.issues;
      totals.files += 1;
      totals.errors += numErrors;
      totals.warnings += numWarnings;
      totals.infos += numInfos;
      if (numErrors + numWarnings > 0) {
        const bad = report.issues.messages.filter((message) => message.severity < 2).slice(0, 3);
        console.log(`${scene} as ${ending}: ${numErrors} errors, ${numWarnings} warnings`);
        bad.forEach((message) => console.log(`  ${message.code} ${message.pointer}: ${message.message}`));
      }
    }
  }
} finally {
  rmSync(folder, { recursive: true });
}
console.log(`${totals.files} files validated: ${totals.errors} errors, ${totals.warnings} warnings, ` +
  `${totals.infos} infos; ${totals.large} files were too large, ${totals.unusable} files are not scenes that can be exported`);
process.exit(totals.files > 0 && totals.errors + totals.warnings === 0 ? 0 : 1);
