"""The output of check --json conforms to schema/check.schema.json.

    answers.py SCENEFILE PATH...

PATHs are scenes and folders of scenes; a missing file is tested too. Exit code 77: skipped, because
the Python package jsonschema is missing.
"""

import pathlib
import sys

from answer_schemas import answer, changed, complaints


def scenes(paths):
    for path in map(pathlib.Path, paths):
        inside = sorted(path.rglob("*")) if path.is_dir() else [path]
        yield from (str(p) for p in inside if p.suffix in (".xml", ".json", ".obj"))
    yield "no such file.xml"


def failures(program):
    """Answers of runs that fail as a whole."""
    yield answer(program, "check")
    yield answer(program, "check", "--no-such-option", "scene.xml")


def broken(document):
    """Changes that the schema must reject."""
    def change(edit):
        return changed(document, edit)
    finding = next(f for s in document["scenes"] for f in s["findings"] if "line" in f)
    scene = next(i for i, s in enumerate(document["scenes"]) if finding in s["findings"])
    def first(d):
        return d["scenes"][scene]["findings"][document["scenes"][scene]["findings"].index(finding)]
    yield change(lambda d: d.pop("scenefile"))
    yield change(lambda d: d.pop("scenes"))
    yield change(lambda d: d.update(error="none"))
    yield change(lambda d: d["scenes"][scene].update(verdict="good"))
    yield change(lambda d: d["scenes"][scene].update(verdict="unreadable"))
    yield change(lambda d: d["scenes"][scene].update(errors=-1))
    yield change(lambda d: first(d).pop("column"))
    yield change(lambda d: first(d).update(severity="fatal"))
    yield change(lambda d: first(d).update(line=0))


def main(program, paths):
    document = answer(program, "check", *scenes(paths))
    found = complaints("check", [document, *failures(program)], broken(document))
    verdicts = {s["verdict"] for s in document["scenes"]}
    if verdicts != {"fine", "warnings", "errors", "unreadable"}:
        found.append(f"only {verdicts} were tried")
    print("\n".join(found) or f"{len(document['scenes'])} scenes")
    return 1 if found else 0


sys.exit(main(sys.argv[1], sys.argv[2:]))
