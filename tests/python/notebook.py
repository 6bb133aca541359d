"""Runs the cells of the notebook for teaching assistants on a small class."""

import json
import os
import pathlib
import sys
import tempfile
import types

from conftest import BALL, ROOT

try:
    import matplotlib
except ImportError:
    print("matplotlib is missing: not run")
    sys.exit(77)
import scenefile

matplotlib.use("Agg")
shown = []
# Functions that notebooks provide.
sys.modules["IPython"] = types.ModuleType("IPython")
sys.modules["IPython"].get_ipython = lambda: None
sys.modules["IPython.display"] = types.ModuleType("IPython.display")
sys.modules["IPython.display"].display = lambda thing: shown.append(thing._repr_png_())

cells = json.loads((ROOT / "docs" / "examples" / "grade-a-class.ipynb").read_text())["cells"]
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    for name in ("handed-in/ada", "handed-in/bob", "references", "scenes"):
        pathlib.Path(name).mkdir(parents=True)
    pathlib.Path("scenes/ball.xml").write_text(BALL)
    scene = scenefile.read("scenes/ball.xml")
    right = scene.render(size=(96, 72), profile="course")
    right.save("references/ball.png")
    right.save("handed-in/ada/ball.png")
    scene.globals.ambient = 0
    scene.render(size=(96, 72), profile="course").save("handed-in/bob/ball.png")
    space = {}
    for cell in cells:
        if cell["cell_type"] == "code":
            exec("".join(cell["source"]), space)
    table = pathlib.Path("grades.csv").read_text().split()
    os.chdir("/")
assert table == ["student,passed,ball", "ada,1,passed", "bob,0,differs"], table
assert len(shown) == 1 and shown[0].startswith(b"\x89PNG"), shown
