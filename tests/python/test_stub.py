"""The stub lists exactly the names of the module."""

import ast

import scenefile
from conftest import ROOT

STUB = ast.parse((ROOT / "python" / "scenefile" / "__init__.pyi").read_text())


def public(names):
    return {name for name in names if not name.startswith("_")}


def names_of(body):
    for entry in body:
        if isinstance(entry, (ast.FunctionDef, ast.ClassDef)):
            yield entry.name
        elif isinstance(entry, ast.AnnAssign):
            yield entry.target.id


def test_the_module():
    assert public(names_of(STUB.body)) == public(scenefile.__all__)
    assert all(hasattr(scenefile, name) for name in scenefile.__all__)


def test_the_classes():
    for entry in STUB.body:
        if isinstance(entry, ast.ClassDef) and not entry.name.startswith("_"):
            there = getattr(scenefile, entry.name)
            if entry.name == "SceneError":
                continue  # its attribute is of the instance
            inherited = dir(tuple) if issubclass(there, tuple) else []
            assert public(names_of(entry.body)) == public(dir(there)) - set(inherited), entry.name
