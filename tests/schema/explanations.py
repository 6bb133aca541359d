"""The output of explain --json conforms to schema/explain.schema.json.

    explanations.py SCENEFILE SCENE...

Exit code 77: skipped, because the Python package jsonschema is missing.
"""

import copy
import json
import pathlib
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    sys.exit(77)

FOLDER = pathlib.Path(__file__).resolve().parent.parent.parent / "schema"
WAYS = ([], ["--profile", "course", "--features", "all"], ["--mode", "normals"], ["--mode", "intersect"], ["--mode", "path", "--samples", "3"],
        ["--profile", "realtime"], ["--profile", "realtime", "--milestone", "action", "--filter", "blur"])
PIXELS = ("0,0", "20,24", "32,20", "33,30", "45,28", "60,40")


def answer(program, arguments, size=("--size", "64x48")):
    run = subprocess.run([program, "explain", "--json", *size, *arguments], capture_output=True, check=False)
    return json.loads(run.stdout)


def compared(program, scene):
    """Without shadows and reflections, where `diff` finds a cause."""
    with tempfile.TemporaryDirectory() as folder:
        for name, features in (("right", "all"), ("mine", "none")):
            subprocess.run([program, "render", "-q", scene, "-o", f"{folder}/{name}.png", "--size", "64x48", "--profile",
                            "course", "--features", features], check=True)
        return answer(program, [scene, "--pixel", "32,30", "--reference", f"{folder}/right.png", "--mine",
                                f"{folder}/mine.png"], ())


def answers(program, scenes):
    yield answer(program, ["no such file.xml", "--pixel", "1,1"])
    yield answer(program, ["no such file.ini", "--pixel", "1,1"])
    yield answer(program, [scenes[0]])
    yield answer(program, [scenes[0], "--pixel", "1,1", "--mine", "no such file.png"])
    yield answer(program, [scenes[0], "--pixel", "1,1", "--reference", "no such file.png", "--mine", "a.png"], ())
    for scene in scenes:
        yield compared(program, scene)
        for i, way in enumerate(WAYS):
            for pixel in PIXELS if i < 2 else PIXELS[1:3]:
                yield answer(program, [scene, "--pixel", pixel, *way])


def broken(document):
    """Changes that the schema must reject."""
    def change(edit):
        other = copy.deepcopy(document)
        edit(other)
        return other
    def lit(d):
        return next(r for r in d["pixel"]["rays"] if r.get("lights"))
    if "yours" in document["pixel"]:
        yield change(lambda d: d["pixel"]["yours"]["compared"].pop("causes"))
        return
    yield change(lambda d: d.pop("pixel"))
    yield change(lambda d: d.pop("scene"))
    yield change(lambda d: d.update(error="none"))
    yield change(lambda d: d.update(profile="realtime"))
    yield change(lambda d: d["pixel"]["value"].append(0))
    yield change(lambda d: d["pixel"].update(rays=[]))
    yield change(lambda d: lit(d).pop("local"))
    yield change(lambda d: lit(d)["surface"].update(shape="torus"))
    yield change(lambda d: lit(d)["surface"].update(object=[]))
    yield change(lambda d: lit(d)["lights"][0].update(contribution=0))
    yield change(lambda d: lit(d)["reflected"].update(fate="lost"))


def main(program, scenes):
    schemas = {(FOLDER / name).as_uri(): json.loads((FOLDER / name).read_text(encoding="utf-8"))
               for name in ("explain.schema.json", "check.schema.json", "grade.schema.json")}
    own = (FOLDER / "explain.schema.json").as_uri()
    schema = schemas[own]
    jsonschema.Draft7Validator.check_schema(schema)
    resolver = jsonschema.RefResolver(own, schema, store=schemas)
    validator = jsonschema.Draft7Validator(schema, resolver=resolver)
    documents = list(answers(program, scenes))
    complaints = [f"{'/'.join(map(str, e.path))}: {e.message[:200]}"
                  for d in documents for e in validator.iter_errors(d)]
    lit = next(d for d in documents if d.get("pixel") and d["pixel"]["rays"][0].get("lights") and
               "yours" not in d["pixel"])
    mine = next(d for d in documents if d.get("pixel") and "terms" in d["pixel"].get("yours", {}).get("compared", {}))
    complaints += [f"broken answer {i} is accepted" for i, d in enumerate([*broken(lit), *broken(mine)])
                   if validator.is_valid(d)]
    print("\n".join(complaints) or f"{len(documents)} answers")
    return 1 if complaints else 0


sys.exit(main(sys.argv[1], sys.argv[2:]))
