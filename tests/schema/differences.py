"""The output of diff --json conforms to schema/diff.schema.json, which describes no more than that.

    differences.py SCENEFILE SCENES PICTURES

SCENES: a folder with hello.xml and studio.xml. PICTURES: one with rgb.png and rgb.jpg. Exit code 77: skipped, because
the Python package jsonschema is missing.
"""

import pathlib
import subprocess
import sys
import tempfile

from answer_schemas import answer, changed, complaints


class Asked:
    """Answers about files in a folder."""

    def __init__(self, program, scenes, pictures, folder):
        self.program = program
        self.scene = scenes / "hello.xml"
        self.lamps = scenes / "studio.xml"
        self.pictures = pictures
        self.folder = folder

    def draw(self, name, *options, scene=None, size="200x150"):
        path = self.folder / name
        subprocess.run([self.program, "render", "-q", scene or self.scene, "-o", path, "--size", size, *options],
                       check=True)
        return path

    def course(self, name, features, *options, **more):
        return self.draw(name, "--profile", "course", "--features", features, *options, **more)

    def other(self, old, new):
        """The scene with another text."""
        path = self.folder / "other.xml"
        path.write_text(self.scene.read_text(encoding="utf-8").replace(old, new), encoding="utf-8")
        return path

    def diff(self, *words):
        return answer(self.program, "diff", *words)

    def balls(self, name, color):
        """A scene with more balls than differences are listed."""
        r, g, b = color.split()
        ball = ('<transblock><object type="primitive" name="sphere">'
                f'<diffuse r="{r}" g="{g}" b="{b}"/></object></transblock>')
        path = self.folder / name
        path.write_text(f"""<scenefile><cameradata><pos x="0" y="0" z="5"/><look x="0" y="0" z="-1"/>
          <up x="0" y="1" z="0"/><heightangle v="45"/></cameradata>
          <object type="tree" name="root">{ball * 10_001}</object></scenefile>""", encoding="utf-8")
        return path

    def of_pictures(self):
        right, dark = self.course("right.png", "all"), self.course("dark.png", "none")
        scene = ("--scene", self.scene)
        yield "mistake", self.diff(right, dark, *scene)
        yield "without a scene", self.diff(right, dark)
        yield "equal", self.diff(right, right, *scene)
        yield "thresholds", self.diff(right, dark, "--min-psnr", "5")
        near = self.course("near.png", "all", scene=self.other('v="35"', 'v="30"'))
        yield "exchanged", self.diff(near, right, *scene)
        yield "another scene", self.diff(right, dark, "--scene", self.lamps, "--profile", "course")
        yield "another way", self.diff(right, dark, *scene, "--profile", "course", "--features", "intersect")
        yield "drawn larger", self.diff(right, self.course("large.png", "all", size="300x225"), *scene)
        yield "part", self.diff(right, self.course("part.png", "all", "--crop", "20,16,180,140"), *scene)
        yield "other size", self.diff(right, self.course("wide.png", "none", size="200x50"))
        yield "floats", self.diff(self.draw("a.pfm"), self.draw("b.exr", "--mode", "normals"))
        yield "JPEG", self.diff(self.pictures / "rgb.png", self.pictures / "rgb.jpg", *scene)

    def of_scenes(self):
        yield "equal scenes", self.diff(self.scene, self.scene)
        converted = self.folder / "hello.json"
        subprocess.run([self.program, "convert", "-q", self.scene, converted], check=True)
        yield "converted", self.diff(self.scene, converted)
        for what, old, new in (("changed", 'v="35"', 'v="30"'), ("added", "<up ", '<aperture v="0.1"/><up '),
                               ("assumed", '<heightangle v="35"/>', ""), ("with errors", "<diffuse ", "<difuse ")):
            yield what, self.diff(self.scene, self.other(old, new))
        many = self.diff(self.balls("red.xml", "1 0 0"), self.balls("blue.xml", "0 0 1"))
        del many["differences"][1:10_000]  # all would take long to validate
        yield "very many", many

    def of_paths(self):
        path = ("--mode", "path", "--samples", "4")
        right = self.draw("right.pfm", *path, scene=self.lamps, size="32x24")
        short = self.draw("short.png", *path, "--max-depth", "1", scene=self.lamps, size="32x24")
        tiny = self.draw("tiny.pfm", *path, scene=self.lamps, size="8x8")
        truth = ("--scene", self.lamps, "--time", "0.5")
        yield "path", self.diff(right, *truth)
        yield "path with a reference", self.diff(right, short, *truth, "--min-psnr", "60")
        yield "path, too small", self.diff(tiny, *truth)
        yield "path, other size", self.diff(right, tiny, *truth)

    def of_failures(self):
        right = self.folder / "right.png"
        yield "missing file", self.diff(right, "no such file.png")
        yield "scene and picture", self.diff(right, self.scene)
        yield "missing scene", self.diff(right, right, "--scene", "no such file.xml")
        yield "missing scenes", self.diff("no such file.xml", self.scene)
        yield "one missing file", self.diff("no such file.png", "--scene", self.lamps, "--mode", "path")
        yield "one name", self.diff(right)
        yield "wrong option", self.diff("--no-such-option", right, right)
        yield "unwritable", self.diff(right, self.folder / "dark.png", "--heatmap", self.folder / "no" / "such.png")

    def all(self):
        return dict([*self.of_pictures(), *self.of_scenes(), *self.of_paths(), *self.of_failures()])


# What tells the answers apart, so that all kinds are tried.
EXPECTED = {
    "mistake": lambda d: d["causes"] and d["worst"]["object"] and d["share_scene_unlike"] < 0.1,
    "without a scene": lambda d: not d["same"] and "scene" not in d and "object" not in d["worst"],
    "equal": lambda d: d["same"] and "worst" not in d and "share_scene_unlike" not in d,
    "thresholds": lambda d: d["same"] and d["max_difference"] > 0,
    "exchanged": lambda d: d["exchanged"],
    "another scene": lambda d: d["share_scene_unlike"] > 0.1 and "object" not in d["worst"],
    "another way": lambda d: d["given_way_contradicted"],
    "drawn larger": lambda d: d["reference_redrawn"] and d["right_at_other_size"],
    "part": lambda d: d["place"]["x"] == -20 and d["right_at_other_size"],
    "other size": lambda d: not d["same_size"] and d["psnr_db"] == 0,
    "floats": lambda d: d["linear"] and isinstance(d["max_difference"], float),
    "JPEG": lambda d: d["b"]["jpeg"] and not d["a"]["jpeg"],
    "equal scenes": lambda d: d["equal"] and d["same_meaning"],
    "converted": lambda d: d["same_meaning"] and not d["differences"],
    "changed": lambda d: d["differences"][0]["a"]["line"] == d["differences"][0]["b"]["line"],
    "added": lambda d: "a" not in d["differences"][0],
    "assumed": lambda d: d["differences"],
    "with errors": lambda d: d["b"]["verdict"] == "errors" and "equal" not in d,
    "very many": lambda d: len(d["differences"]) == 1 and d["differences_left_out"] == 1,
    "path": lambda d: "a" not in d and "reference_path" not in d,
    "path with a reference": lambda d: d["broken"] and d["reference_path"],
    "path, too small": lambda d: d["path"]["blocks"] == 0 and d["path"]["notes"],
    "path, other size": lambda d: d["error"],
    "missing file": lambda d: d["b"]["error"] and "error" not in d["a"],
    "scene and picture": lambda d: d["b"]["error"],
    "missing scene": lambda d: d["scene"]["verdict"] == "unreadable" and "same" not in d,
    "missing scenes": lambda d: d["a"]["verdict"] == "unreadable" and "equal" not in d,
    "one missing file": lambda d: d["b"]["error"] and "path" not in d,
    "one name": lambda d: d["error"],
    "wrong option": lambda d: d["error"],
    "unwritable": lambda d: d["error"],
}


OPTIONAL = {"scene", "worst", "worst/line", "place", "differences/[]/a", "differences/[]/b", "differences_left_out",
            "scene/findings/[]/file", "scene/findings/[]/path", "b/findings/[]/correction",
            "b/findings/[]/correction/changes"}


def broken(answers):
    """Changes that the schema must reject, beside missing members and those of another type."""
    def of(name, edit):
        return changed(answers[name], edit)
    yield of("mistake", lambda d: d["broken"].clear())
    yield of("mistake", lambda d: d.update(error="none"))
    yield of("mistake", lambda d: d.update(notes=["other samples"]))
    yield of("mistake", lambda d: d["a"].update(error="none"))
    yield of("mistake", lambda d: d["causes"][0].update(cause="Shadows"))
    yield of("mistake", lambda d: d["worst"].update(x=-1))
    yield of("mistake", lambda d: d.update(share_scene_unlike=1.5))
    yield of("equal", lambda d: d["broken"].append("the pictures are not equal"))
    yield of("changed", lambda d: d.update(equal=True))
    yield of("changed", lambda d: d.update(same_meaning=True))
    yield of("added", lambda d: d["differences"][0].pop("b"))
    yield of("mistake", lambda d: d.update(a=d["scene"]))
    yield of("changed", lambda d: d.update(b=answers["mistake"]["b"]))
    yield of("path", lambda d: d.update(b=d["scene"]))
    yield of("mistake", lambda d: d.pop("scene"))
    yield of("missing scene", lambda d: d.pop("scene"))
    yield of("path", lambda d: d.pop("scene"))
    yield of("path", lambda d: d.update(same=True))
    yield of("path, too small", lambda d: d["path"]["largest_at"].pop())


def main(program, scenes, pictures):
    with tempfile.TemporaryDirectory() as folder:
        answers = Asked(program, pathlib.Path(scenes), pathlib.Path(pictures), pathlib.Path(folder)).all()
    unlike = []
    for name, document in answers.items():
        try:
            if not EXPECTED[name](document):
                unlike.append(f"{name}: another answer than expected")
        except (KeyError, IndexError) as error:
            unlike.append(f"{name}: {error!r} is missing")
    found = unlike or complaints("diff", answers.values(), broken(answers), OPTIONAL)
    print("\n".join(found) or f"{len(answers)} answers")
    return 1 if found else 0


sys.exit(main(*sys.argv[1:]))
