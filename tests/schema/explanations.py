"""The output of explain --json conforms to schema/explain.schema.json.

    explanations.py SCENEFILE SCENE...

Exit code 77: skipped, because the Python package jsonschema is missing.
"""

import pathlib
import subprocess
import sys
import tempfile

from answer_schemas import answer, changed, complaints

SIZE = ("--size", "64x48")
WAYS = ([], ["--profile", "course", "--features", "all"], ["--mode", "normals"], ["--mode", "intersect"], ["--mode", "path", "--samples", "3"],
        ["--profile", "realtime"], ["--profile", "realtime", "--milestone", "action", "--filter", "blur"])
PIXELS = ("0,0", "20,24", "32,20", "33,30", "45,28", "60,40")


def filters(program):
    """As the message about an unknown one lists them."""
    run = subprocess.run([program, "explain", "a.xml", "--pixel", "1,1", "--profile", "realtime", "--filter", "?"],
                         capture_output=True, text=True, check=False)
    return run.stderr.splitlines()[0].split("known: ")[1].split(", ")


def compared(program, scene):
    """Without shadows and reflections, where `diff` finds a cause."""
    with tempfile.TemporaryDirectory() as folder:
        for name, features in (("right", "all"), ("mine", "none")):
            subprocess.run([program, "render", "-q", scene, "-o", f"{folder}/{name}.png", *SIZE, "--profile",
                            "course", "--features", features], check=True)
        return answer(program, "explain", scene, "--pixel", "32,30", "--reference", f"{folder}/right.png", "--mine",
                      f"{folder}/mine.png")


def compared_path(program, scene):
    """With the truth."""
    with tempfile.TemporaryDirectory() as folder:
        mine = f"{folder}/mine.pfm"
        subprocess.run([program, "render", "-q", scene, "-o", mine, "--size", "32x24", "--mode", "path", "--samples",
                        "4"], check=True)
        return answer(program, "explain", scene, "--pixel", "9,9", "--mine", mine, "--time", "0.5")


def answers(program, scenes):
    def explain(*words):
        return answer(program, "explain", *words)
    yield explain("no such file.xml", "--pixel", "1,1", *SIZE)
    yield explain("no such file.ini", "--pixel", "1,1", *SIZE)
    yield explain(scenes[0], *SIZE)
    yield explain(scenes[0], "--pixel", "1,1", "--mine", "no such file.png", *SIZE)
    yield explain(scenes[0], "--pixel", "1,1", "--reference", "no such file.png", "--mine", "a.png")
    for scene in scenes:
        yield compared(program, scene)
        for i, way in enumerate(WAYS):
            for pixel in PIXELS if i < 2 else PIXELS[1:3]:
                yield explain(scene, "--pixel", pixel, *way, *SIZE)
    yield explain(scenes[0], "--pixel", "32,20", "--mode", "path", "--samples", "1", *SIZE)
    for name in filters(program):
        yield explain(scenes[0], "--pixel", "32,20", "--profile", "realtime", "--filter", name, *SIZE)
    yield compared_path(program, pathlib.Path(scenes[0]).resolve().parent / "studio.xml")


def broken(document):
    """Changes that the schema must reject."""
    def change(edit):
        return changed(document, edit)
    def lit(d):
        return next(r for r in d["pixel"]["rays"] if r.get("lights"))
    yours = document["pixel"].get("yours", {})
    if yours:
        yield change(lambda d: d["pixel"]["yours"]["compared" if "compared" in yours else "picture"].pop("causes"))
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
    documents = list(answers(program, scenes))
    lit = next(d for d in documents if d.get("pixel") and d["pixel"]["rays"][0].get("lights") and
               "yours" not in d["pixel"])
    mine = next(d for d in documents if d.get("pixel") and "terms" in d["pixel"].get("yours", {}).get("compared", {}))
    traced = documents[-1]
    found = complaints("explain", documents, [*broken(lit), *broken(mine), *broken(traced)])
    print("\n".join(found) or f"{len(documents)} answers")
    return 1 if found else 0


sys.exit(main(sys.argv[1], sys.argv[2:]))
