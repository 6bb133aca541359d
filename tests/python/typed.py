"""Not run: mypy --strict checks it, to verify that the stubs agree with docs/python.md."""

import numpy as np

import scenefile

scene: scenefile.Scene = scenefile.read("ball.xml")
scene.camera.position += (0, 2, 0)
scene.camera.up = np.array([0, 1, 0])
for light in scene.lights:
    light.color *= 0.5
    light.type = "spot"
node = scene.root.add_child("arm")
node.transforms = [scenefile.Translate((0, 1, 0)), scenefile.Matrix(np.eye(4))]
picture = scene.render(size=(64, 48), profile="course", features=["shadows"], progress=print)
red: float = float(picture.pixels[..., 0].max())
comparison = scenefile.compare(picture, picture.quantized, scene)
names: list[str] = [cause.name for cause in comparison.causes]
book = scenefile.grade("handed-in", "right", min_psnr=40)
passed: dict[str, int] = {student.name: student.passed for student in book.students}
