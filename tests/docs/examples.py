#!/usr/bin/env python3
"""Tests the action, the hooks and the autograder, as far as possible without their hosts.

    examples.py PROGRAM
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = pathlib.Path(sys.argv[1]).resolve()
GOOD = (ROOT / "scenes" / "hello.xml").read_text()
BAD = GOOD.replace("<diffuse", "<difuse", 1)


def run(command, folder, environment, status=0):
    done = subprocess.run(["bash", "-eo", "pipefail", "-c", command], cwd=folder, capture_output=True, text=True,
                          env=dict(os.environ, PATH=f"{PROGRAM.parent}:{os.environ['PATH']}", **environment))
    assert done.returncode == status, f"{command}\n{done.returncode}: {done.stdout}{done.stderr}"
    return done.stdout


def try_action(folder):
    """Runs the script steps of the action like a workflow."""
    (folder / "scenes").mkdir()
    (folder / "scenes" / "good.xml").write_text(GOOD)
    steps = [step for step in yaml.safe_load((ROOT / "action.yml").read_text())["runs"]["steps"] if "run" in step]
    assert len(steps) == 2
    for name, status in (("good.xml", 0), ("bad.xml", 1)):
        (folder / "scenes" / name).write_text(BAD if status else GOOD)
        files = {variable: str(folder / variable) for variable in ("GITHUB_OUTPUT", "GITHUB_PATH")}
        environment = dict(files, RUNNER_TEMP=str(folder), PROJECT=str(ROOT), SCENES="scenes", OPTIONS="")
        run(steps[0]["run"], folder, environment)
        assert not (folder / "GITHUB_PATH").exists(), "what is there is not built"
        run(steps[1]["run"], folder, environment, status)
        log = json.loads((folder / "scenefile.sarif").read_text())
        errors = [result["ruleId"] for result in log["runs"][0]["results"] if result["level"] == "error"]
        assert errors == (["xml.misspelled-element"] if status else []), errors
        assert f"sarif={folder}/scenefile.sarif" in (folder / "GITHUB_OUTPUT").read_text()


def try_hooks(folder):
    hooks = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text())
    (folder / "good.xml").write_text(GOOD)
    (folder / "bad.xml").write_text(BAD)
    for hook in hooks:
        assert hook["language"] == "system" and {"id", "name", "entry"} <= hook.keys()
        run(f"{hook['entry']} good.xml", folder, {})
        run(f"{hook['entry']} good.xml bad.xml", folder, {}, 1 if hook["id"] == "scenefile-check" else 0)


def try_autograder(folder):
    for name in ("source/references", "source/scenes", "submission"):
        (folder / name).mkdir(parents=True)
    for file in (ROOT / "docs" / "examples" / "gradescope").iterdir():
        shutil.copy(file, folder / "source")
    draw = f"scenefile render {ROOT}/scenes/hello.xml --size 96x72 --profile course -q"
    # A repository, not only pictures.
    run("mkdir submission/src submission/student_outputs; touch submission/src/main.cpp;"
        f"{draw} -o source/references/one.png; {draw} -o source/references/two.png;"
        f"cp source/references/one.png submission/student_outputs;"
        f"{draw} --features none -o submission/student_outputs/two.png", folder, {})
    run("source/run_autograder", folder, {"AUTOGRADER": str(folder)})
    results = json.loads((folder / "results" / "results.json").read_text())
    assert [(test["name"], test["score"]) for test in results["tests"]] == [("one", 1), ("two", 0)], results
    assert "PSNR" in results["tests"][1]["output"]
    shutil.rmtree(folder / "submission")
    (folder / "submission").mkdir()
    run("source/run_autograder", folder, {"AUTOGRADER": str(folder)})
    results = json.loads((folder / "results" / "results.json").read_text())
    assert results["score"] == 0 and "could be graded" in results["output"], results


for attempt in (try_action, try_hooks, try_autograder):
    with tempfile.TemporaryDirectory() as folder:
        attempt(pathlib.Path(folder))
    print(attempt.__name__[4:], "works")
yaml.safe_load((ROOT / "docs" / "examples" / "github-classroom" / "classroom.yml").read_text())
