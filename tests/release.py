#!/usr/bin/env python3
"""Tests scripts/release-notes and scripts/make-release on a small project."""
import pathlib
import shutil
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
CHANGELOG = """# Changelog

## Unreleased

- Not yet.

## 1.2.0 (1 May 2030)

### Render

- Faster.

## 1.1.0

- First.
"""


def run(project, script, *words):
    return subprocess.run([project / "scripts" / script, *words], cwd=project, capture_output=True, text=True)


def fails(done, text):
    assert done.returncode != 0 and text in done.stderr, done


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def make_project(project, version):
    (project / "scripts").mkdir(parents=True)
    for script in ("release-notes", "make-release"):
        shutil.copy(ROOT / "scripts" / script, project / "scripts")
    write(project / "CMakeLists.txt", f"project(scenefile VERSION {version} LANGUAGES CXX)\n")
    for folder in ("bindings/npm", "editors/vscode"):
        write(project / folder / "package.json", f'{{"version": "{version}"}}')
    write(project / "CHANGELOG.md", CHANGELOG)


def make_artifacts(folder):
    for system, python in (("debian-12", "311"), ("debian-13", "313")):
        for name in ("scenefile_1.2.0_amd64.deb", "libscenefile-dev_1.2.0_amd64.deb", "scenefile-1.2.0-x86_64.tar.gz",
                     f"scenefile-1.2.0-cp{python}.whl", "showcase.png"):
            write(folder / system / name, system)
    write(folder / "npm" / "scenefile-1.2.0.tgz", "npm")
    write(folder / "page" / "index.html", "page")


def try_notes(project):
    assert run(project, "release-notes", "v1.2.0").stdout == "### Render\n\n- Faster.\n"
    fails(run(project, "release-notes", "v1.3.0"), "CMakeLists.txt has version 1.2.0, not 1.3.0")
    write(project / "editors/vscode/package.json", '{"version": "1.1.0"}')
    fails(run(project, "release-notes", "v1.2.0"), "editors/vscode/package.json has version 1.1.0")
    write(project / "editors/vscode/package.json", '{"version": "1.2.0"}')
    for text in (CHANGELOG.replace("## 1.2.0 (1 May 2030)", "## 1.2.01"), CHANGELOG.replace("### Render\n\n- Faster.\n", "")):
        write(project / "CHANGELOG.md", text)
        fails(run(project, "release-notes", "1.2.0"), "CHANGELOG.md has no text")
    write(project / "CHANGELOG.md", CHANGELOG)


def try_release(project):
    make_artifacts(project / "artifacts")
    out = project / "out" / "release"
    for _ in range(2):  # the second replaces the first
        done = run(project, "make-release", "v1.2.0", "artifacts", "out/release")
        assert done.returncode == 0, done
    names = {"SHA256SUMS", "scenefile-1.2.0.tgz", "scenefile-page-1.2.0.tar.gz", "scenefile-1.2.0-cp311.whl", "scenefile-1.2.0-cp313.whl"}
    for system in ("debian-12", "debian-13"):
        names |= {f"scenefile_1.2.0_{system}_amd64.deb", f"libscenefile-dev_1.2.0_{system}_amd64.deb", f"scenefile-1.2.0-x86_64-{system}.tar.gz"}
    assert {path.name for path in out.iterdir()} == names, sorted(out.iterdir())
    assert (out / "scenefile_1.2.0_debian-13_amd64.deb").read_text() == "debian-13"
    assert (project / "out" / "release-notes.md").read_text() == "### Render\n\n- Faster.\n"
    checked = subprocess.run(["sha256sum", "--check", "--strict", "SHA256SUMS"], cwd=out, capture_output=True, text=True)
    assert checked.returncode == 0 and checked.stdout.count(": OK\n") == len(names) - 1, checked
    shutil.copy(project / "artifacts/debian-12/scenefile-1.2.0-cp311.whl", project / "artifacts/debian-13")
    fails(run(project, "make-release", "v1.2.0", "artifacts", "out/release"), "two systems have scenefile-1.2.0-cp311.whl")
    (project / "artifacts/debian-13/scenefile-1.2.0-cp311.whl").unlink()
    for part, text in (("page", "scenefile-page-1.2.0.tar.gz"), ("npm", "scenefile-1.2.0.tgz")):
        shutil.rmtree(project / "artifacts" / part)
        fails(run(project, "make-release", "v1.2.0", "artifacts", "out/release"), text)


with tempfile.TemporaryDirectory() as folder:
    make_project(pathlib.Path(folder) / "project", "1.2.0")
    try_notes(pathlib.Path(folder) / "project")
    try_release(pathlib.Path(folder) / "project")
