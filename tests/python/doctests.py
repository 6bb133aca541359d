"""Runs the examples of docs/python.md in an empty folder with the scene that they use."""

import doctest
import os
import pathlib
import sys
import tempfile

from conftest import BALL

page = pathlib.Path(__file__).resolve().parents[2] / "docs" / "python.md"
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    pathlib.Path("ball.xml").write_text(BALL)
    failed, tried = doctest.testfile(str(page), module_relative=False)
    os.chdir("/")
print(f"{tried} examples, {failed} failed")
sys.exit(1 if failed or tried == 0 else 0)
