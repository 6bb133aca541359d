"""The output of grade --json conforms to schema/grade.schema.json.

    grades.py SCENEFILE SCENE

SCENE: what the reference shows. Exit code 77: skipped, because the Python package jsonschema is missing.
"""

import pathlib
import subprocess
import sys
import tempfile

from answer_schemas import answer, changed, complaints


def class_answer(program, scene, folder):
    """Grades a class with every verdict, and with ignored files."""
    def draw(name, *more):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        subprocess.run([program, "render", scene, "--size", "32x24", "--quiet", "-o", folder / name, *more],
                       check=True)
    draw("right/ball.png")
    draw("right/glow.exr")
    draw("class/ada/ball.png")
    draw("class/ben/ball.png", "--mode", "normals")
    draw("class/ben/glow.exr", "--mode", "normals")
    draw("class/ben/other.png")
    draw("class/nobody.png")
    draw("class/fay/ball.png", "--size", "16x12")
    (folder / "class/cleo").mkdir()
    (folder / "class/dan").mkdir()
    (folder / "class/dan/ball.png").write_text("no picture")
    (folder / "class/eve.rar").write_text("not read")
    return grade(program, folder / "class", folder / "right")


def path_answer(program, scene, folder):
    """The same for path-traced pictures."""
    (folder / "inis").mkdir()
    (folder / "inis/box.ini").write_text(
        f"[IO]\nscene = {scene}\noutput = out/box.png\n[Settings]\nimageWidth = 32\n"
        "imageHeight = 24\nsamplesPerPixel = 9\npathContinuationProb = 0.9\n")
    for student, size, more in (("ada", "32x24", ()), ("ben", "32x24", ("--max-depth", "1")), ("cleo", "16x12", ())):
        (folder / "paths" / student).mkdir(parents=True)
        subprocess.run([program, "render", scene, "--size", size, "--quiet", "--mode", "path", "--samples", "9", "-o",
                        folder / "paths" / student / "box.pfm", *more], check=True)
    return grade(program, folder / "paths", folder / "inis", "--mode", "path", "--time", "1")


def grade(program, folder, references, *more):
    return answer(program, "grade", folder, "--references", references, *more)


def broken(document):
    """Changes that the schema must reject."""
    def change(edit):
        return changed(document, edit)
    yield change(lambda d: d.pop("ignored"))
    yield change(lambda d: d.update(error="none"))
    yield change(lambda d: d["ignored"][0].pop("reason"))
    yield change(lambda d: d["ignored"][0].update(student=""))
    yield change(lambda d: d["students"][0].pop("unmatched"))
    yield change(lambda d: d["students"][0].update(passed=True))
    yield change(lambda d: d["students"][0]["pictures"][0].update(verdict="good"))
    yield change(lambda d: d["students"][0]["pictures"][0].pop("psnr_db"))
    yield change(lambda d: d["students"][0]["pictures"][0].pop("linear"))
    yield change(lambda d: d["students"][0]["pictures"][0].pop("size"))
    yield change(lambda d: d["students"][0]["pictures"][0].update(verdict="missing"))
    yield change(lambda d: d["students"][0]["pictures"][0].update(linear="no"))


def main(program, scene):
    with tempfile.TemporaryDirectory() as folder:
        document = class_answer(program, scene, pathlib.Path(folder))
        paths = path_answer(program, pathlib.Path(scene).resolve().parent / "studio.xml", pathlib.Path(folder))
        failures = [grade(program, "no such folder", folder), grade(program, folder, "no such folder")]
    found = complaints("grade", [document, paths, *failures], broken(document))
    if [p.get("path_traced") for s in paths.get("students", ()) for p in s["pictures"]] != [True] * 3:
        found.append(f"path-traced pictures: {paths}")
    verdicts = {p["verdict"] for s in document["students"] for p in s["pictures"]}
    if verdicts != {"passed", "differs", "missing", "unreadable"} or len(document["ignored"]) != 3:
        found.append(f"only {verdicts} and {document['ignored']} were tried")
    print("\n".join(found) or f"{len(document['students'])} students")
    return 1 if found else 0


sys.exit(main(sys.argv[1], sys.argv[2]))
