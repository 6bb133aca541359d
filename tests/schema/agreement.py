"""Holds the schemas and the reader to the same verdict on many files.

    agreement.py {xml|json} FINDINGS-PROGRAM PATH...

PATHs are folders and files. Of files variants are tried too, each with one thing removed, doubled,
renamed, moved or given another value. Without PATHs: the folder that the environment variable
SCENEFILE_CORPUS names. seen.tsv says which findings a schema must see, and why it cannot see
others; stricter.tsv, what it refuses and the reader does not. Exit code 77: skipped, for lack of a
validator or a corpus.
"""

import argparse
import collections
import os
import pathlib
import re
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
    for file in files:
        for what, variant in side.variants(file.read_bytes()):
            path = folder / f"{len(made)}{side.SUFFIX}"
            path.write_bytes(variant)
            made[path] = f"{file}, {what}"
    return made


def disagreement(seen, stricter, codes, refused):
    """What is wrong with the pair of verdicts; None if they agree."""
    must = [c for c in codes if how_seen(seen, c) == "always"]
    may = [c for c in codes if how_seen(seen, c) != "never"]
    if must and not refused:
        return f"the schema misses {' '.join(must)}"
    if refused and not may and not any(re.search(c, refused) for c, _ in stricter):
        return f"the schema alone refuses it: {refused}; found: {' '.join(codes) or 'nothing'}"
    return None


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
    if (missing := side.missing_validator()) is not None:
        print(f"skipped: {missing}")
        return 77
    seen, stricter = read_seen(), read_table("stricter.tsv")
    files = find_files(arguments.paths or [corpus], side.SUFFIX)
    if not files:
        sys.exit("no files to try")
    with tempfile.TemporaryDirectory() as folder:
        named = [f for f in map(pathlib.Path, arguments.paths) if f in files]
        variants = make_variants(side, named, pathlib.Path(folder))
        tried = [str(f) for f in [*files, *variants]]
        codes = findings(arguments.program, tried)
        refused = side.refusals(tried)
        wrong = [(f"{variants.get(pathlib.Path(path), path)}", problem) for path in tried
                 if (problem := disagreement(seen, stricter, codes[path], refused.get(path)))]
    for path, problem in wrong:
        print(f"{path}: {problem}")
    if not arguments.paths:
        print_table(seen, codes, refused)
    print(f"{len(files)} files, {len(variants)} variants, {len(refused)} refused, "
          f"{len(wrong)} disagreements")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
