import os
import pathlib
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("SCENEFILE_PROGRAM") or None

BALL = """<scenefile>
  <globaldata><ambientcoeff v="0.5"/><diffusecoeff v="0.5"/><specularcoeff v="0.5"/></globaldata>
  <cameradata>
    <pos x="3" y="2.2" z="4"/><focus x="0" y="0.3" z="0"/><up x="0" y="1" z="0"/><heightangle v="35"/>
  </cameradata>
  <lightdata><id v="0"/><color r="1" g="1" b="1"/><position x="2" y="5" z="3"/></lightdata>
  <object type="tree" name="root">
    <transblock>
      <translate x="0" y="0.5" z="0"/>
      <object type="primitive" name="sphere"><ambient r="0.4" g="0.4" b="0.4"/><diffuse r="0.9" g="0.3" b="0.2"/></object>
    </transblock>
  </object>
</scenefile>
"""


@pytest.fixture
def scenes():
    return ROOT / "scenes"


@pytest.fixture
def ball(tmp_path):
    path = tmp_path / "ball.xml"
    path.write_text(BALL)
    return path


@pytest.fixture
def program():
    """Runs the program from the same build as the module."""
    if PROGRAM is None:
        pytest.skip("SCENEFILE_PROGRAM does not name the program")

    def run(*arguments, status=0):
        done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
        assert done.returncode == status, done.stderr
        return done.stdout

    return run
