"""Checks that the schemas and the reader agree on many files.

    agreement.py {xml|json} FINDINGS-PROGRAM PATH...

PATHs are folders and files. Files are also tested with variants, each with one thing removed,
duplicated, renamed, moved or changed. Without PATHs: the folder in the environment variable
SCENEFILE_CORPUS. seen.tsv lists which findings a schema must detect, and why it cannot detect others;
without_stricter() of each side, what a schema rejects on purpose although the reader accepts it. Only
verdicts are compared, because messages differ between validators. Uses every installed validator. scenefile.xsd must
accept every file that scenefile.rng accepts.
Exit code 77: skipped, because there is no validator or no corpus.
"""

import argparse
import collections
import os
import pathlib
import subprocess
import sys
import tempfile

import json_side
import xml_side

HERE = pathlib.Path(__file__).resolve().parent
READING = ("xml.", "json.", "format.")


def read_table(name):
    lines = (HERE / name).read_text(encoding="utf-8").splitlines()
    return [line.split("\t") for line in lines if line and not line.startswith("#")]


def read_seen():
    rows = read_table("seen.tsv")
    seen = {row[0]: row[1] for row in rows}
    if len(seen) != len(rows) or not set(seen.values()) <= {"always", "sometimes", "never"}:
        sys.exit("seen.tsv: a code occurs twice, or is not seen always, sometimes or never")
    return seen


def how_seen(seen, code):
    return seen.get(code, "always" if code.startswith(READING) else "never")


def find_files(paths, suffix):
    files = []
    for path in map(pathlib.Path, paths):
        if path.is_dir():
            files += sorted(p for p in path.rglob("*" + suffix) if p.is_file())
        elif path.suffix == suffix:
            files.append(path)
    return files


def findings(program, files):
    run = subprocess.run([program], input="".join(f"{f}\n" for f in files), text=True,
                         capture_output=True, check=True)
    result = {}
    for line in run.stdout.splitlines():
        path, codes = line.split("\t")
        result[path] = codes.split()
    return result


def make_variants(side, files, folder):
    made = {}
    tried = set()
    for file in files:
        for what, variant in side.variants(file.read_bytes(), tried):
            path = folder / f"{len(made)}{side.SUFFIX}"
            path.write_bytes(variant)
            made[path] = f"{file}, {what}"
    return made


def missed(seen, codes):
    """The findings that the schema must detect."""
    return [c for c in codes if how_seen(seen, c) == "always"]


def seen_by_reader(seen, codes):
    return any(how_seen(seen, c) != "never" for c in codes)


def still_refused(side, validate, paths, folder):
    """The rejected files that are still rejected without what the schema rejects on
    purpose."""
    changed = {}
    result = set(paths)
    for path in paths:
        data = pathlib.Path(path).read_bytes()
        if (other := side.without_stricter(data)) is not None:
            file = folder / f"changed{len(changed)}{side.SUFFIX}"
            file.write_bytes(other)
            changed[str(file)] = path
    if changed:
        refused = side.refusals(list(changed), validate)
        result -= {path for file, path in changed.items() if file not in refused}
    return result


def disagreements(side, seen, validate, codes, folder):
    """Disagreements by path, and all files that the validator rejects."""
    refused = side.refusals(list(codes), validate)
    wrong = {path: f"the schema misses {' '.join(missed(seen, found))}"
             for path, found in codes.items() if path not in refused and missed(seen, found)}
    alone = [p for p in refused if not seen_by_reader(seen, codes[p])]
    for path in still_refused(side, validate, alone, folder):
        wrong[path] = (f"only the schema rejects it: {refused[path]}; "
                       f"found: {' '.join(codes[path]) or 'nothing'}")
    return wrong, refused


def print_table(seen, codes, refused):
    rows = collections.Counter()
    for path, found in codes.items():
        schema = "refused" if path in refused else "accepted"
        only_unseen = found and all(how_seen(seen, c) == "never" for c in found)
        rows[schema, "only what schemas do not see" if only_unseen else
             "findings" if found else "clean"] += 1
    for (schema, reader), count in sorted(rows.items()):
        print(f"schema {schema:<8}  reader: {reader:<28}  {count:5}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("format", choices=("xml", "json"))
    parser.add_argument("program")
    parser.add_argument("paths", nargs="*")
    arguments = parser.parse_args()
    corpus = os.environ.get("SCENEFILE_CORPUS")
    if not arguments.paths and not corpus:
        print("skipped: SCENEFILE_CORPUS names no folder")
        return 77

    side = {"xml": xml_side, "json": json_side}[arguments.format]
    if not (validators := side.validators()):
        print(f"skipped: {side.WANTED} is not installed")
        return 77
    seen = read_seen()
    files = find_files(arguments.paths or [corpus], side.SUFFIX)
    if not files:
        sys.exit("no files to try")
    failed = False
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        named = [f for f in map(pathlib.Path, arguments.paths) if f in files]
        variants = make_variants(side, named, folder)
        codes = findings(arguments.program, [str(f) for f in [*files, *variants]])
        for validator, validate in validators.items():
            wrong, refused = disagreements(side, seen, validate, codes, folder)
            for path, problem in sorted(wrong.items()):
                print(f"{variants.get(pathlib.Path(path), path)}: {problem}")
            if not arguments.paths:
                print_table(seen, codes, refused)
            print(f"{validator}: {len(files)} files, {len(variants)} variants, {len(refused)} refused, "
                  f"{len(wrong)} disagreements")
            failed |= bool(wrong)
        if "xmllint" in validators:
            accepted = [path for path in codes if path not in refused]
            for path in (refused_too := side.refused_by_xsd(accepted)):
                print(f"{variants.get(pathlib.Path(path), path)}: only the XSD refuses it")
            print(f"XSD: {len(accepted)} files, {len(refused_too)} refused")
            failed |= bool(refused_too)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
