"""The output of check --json conforms to schema/check.schema.json.

    answers.py SCENEFILE PATH...

PATHs are scenes and folders of scenes; a missing file is tested too. Exit code 77: skipped, because
the Python package jsonschema is missing.
"""

import copy
import json
import pathlib
import subprocess
import sys

try:
    import jsonschema
except ImportError:
    sys.exit(77)

SCHEMA = pathlib.Path(__file__).resolve().parent.parent.parent / "schema" / "check.schema.json"


def scenes(paths):
    for path in map(pathlib.Path, paths):
        inside = sorted(path.rglob("*")) if path.is_dir() else [path]
        yield from (str(p) for p in inside if p.suffix in (".xml", ".json", ".obj"))
    yield "no such file.xml"


def answer(program, arguments):
    run = subprocess.run([program, "check", "--json", *arguments], capture_output=True, check=False)
    return json.loads(run.stdout)


def failures(program):
    """Answers of runs that fail as a whole."""
    yield answer(program, [])
    yield answer(program, ["--no-such-option", "scene.xml"])


def broken(document):
    """Changes that the schema must reject."""
    def change(edit):
        other = copy.deepcopy(document)
        edit(other)
        return other
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
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    document = answer(program, list(scenes(paths)))
    complaints = [f"{'/'.join(map(str, e.path))}: {e.message[:200]}"
                  for d in (document, *failures(program)) for e in validator.iter_errors(d)]
    complaints += [f"broken answer {i} is accepted" for i, d in enumerate(broken(document))
                   if validator.is_valid(d)]
    verdicts = {s["verdict"] for s in document["scenes"]}
    if verdicts != {"fine", "warnings", "errors", "unreadable"}:
        complaints.append(f"only {verdicts} were tried")
    print("\n".join(complaints) or f"{len(document['scenes'])} scenes")
    return 1 if complaints else 0


sys.exit(main(sys.argv[1], sys.argv[2:]))
