#!/usr/bin/env python3
"""Tries the language server in editors without a window, with the lines that docs/editors.md says to paste.

    tests/editors/try.py PROGRAM...      # `scenefile`, with arguments before `lsp` if it has any
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = ROOT / "tests/editors"
SCENE = (HERE / "scene.xml").read_text()


def line_for(editor):
    """The setting of an editor in the second table of the page."""
    page = (ROOT / "docs/editors.md").read_text().split("## With the language server")[1]
    row = re.search(rf"^\| {re.escape(editor)} \|(.*)\|$", page, re.M).group(1)
    return max(re.findall(r"`([^`]+)`", row), key=len)


def run(name, command, folder, env):
    done = subprocess.run(command, cwd=folder, env=env, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          timeout=120, check=False)
    said = [line for line in (done.stdout + done.stderr).splitlines() if "tried:" in line]
    if done.returncode != 0 or len(said) != 1:
        sys.exit(f"{name}: {done.stdout}{done.stderr}")
    print(f"{name}: {said[0].split('tried: ')[1]}")


def main():
    words = sys.argv[1:] or sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        program = folder / "bin/scenefile"
        program.parent.mkdir()
        program.write_text("#!/bin/sh\nexec " + " ".join(f"'{word}'" for word in words) + ' "$@"\n')
        program.chmod(0o755)
        env = {**os.environ, "PATH": f"{program.parent}:{os.environ['PATH']}", "HOME": name, "XDG_CONFIG_HOME": name,
               "LC_ALL": "C.UTF-8"}
        (folder / "scene.xml").write_text(SCENE)
        (folder / "init.lua").write_text(line_for("Neovim 0.7") + f"\ndofile('{HERE}/neovim.lua')\n")
        run("Neovim", ["nvim", "--headless", "-u", "init.lua", "scene.xml"], folder, env)
        (folder / "scene.xml").write_text(SCENE)
        (folder / "init.el").write_text(line_for("Emacs with Eglot"))
        run("Emacs", ["emacs", "--batch", "--eval", "(package-initialize)", "-l", "init.el", "-l", HERE / "emacs.el"], folder, env)
        run("VS Code's client library", ["node", HERE / "vscode.cjs"], folder, env)


main()
