"""Read, check, explain, render, compare and grade scenes of the courses CS123 and CSCI1230.

    >>> import scenefile
    >>> scene = scenefile.read("chess.xml")
    >>> scene.camera.position += (0, 2, 0)
    >>> scene.render(size=(640, 480)).save("chess.png")

docs/python.md has the manual.
"""

from ._base import SceneError, Vec3
from ._core import (
    Camera,
    Cause,
    Comparison,
    Diagnostic,
    Explanation,
    FaceMaterial,
    Globals,
    Gradebook,
    GradedPicture,
    IgnoredFile,
    Light,
    Material,
    Matrix,
    Node,
    Picture,
    Primitive,
    Report,
    Rotate,
    Scale,
    Scene,
    SceneDifference,
    SceneDifferences,
    Student,
    TextureUse,
    Translate,
    __version__,
    check,
    compare,
    diff,
    grade,
    read,
    read_picture,
    read_text,
)

__all__ = [
    "Camera",
    "Cause",
    "Comparison",
    "Diagnostic",
    "Explanation",
    "FaceMaterial",
    "Globals",
    "Gradebook",
    "GradedPicture",
    "IgnoredFile",
    "Light",
    "Material",
    "Matrix",
    "Node",
    "Picture",
    "Primitive",
    "Report",
    "Rotate",
    "Scale",
    "Scene",
    "SceneDifference",
    "SceneDifferences",
    "SceneError",
    "Student",
    "TextureUse",
    "Translate",
    "Vec3",
    "__version__",
    "check",
    "compare",
    "diff",
    "grade",
    "read",
    "read_picture",
    "read_text",
]
