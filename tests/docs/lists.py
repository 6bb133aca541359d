#!/usr/bin/env python3
"""Texts, the page and the types of npm that list features, files or modes list those of the program.

    lists.py PROGRAM
"""
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]


def answer(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=True).stdout


def text_of(path):
    return (ROOT / path).read_text(encoding="utf-8")


def listed(text, before, after):
    """The words between two texts, separated by commas; quotes do not matter."""
    found = re.search(re.escape(before) + "([^;.]*?)" + re.escape(after), " ".join(text.split()))
    assert found, f"no list between {before!r} and {after!r}"
    return re.sub("[`'\"]", "", found[1]).split(", ")


def check_features():
    fish = answer("help", "--completion", "fish")
    words = re.search(r'-l features .*? " " "([^"]+)"', fish)[1].split()
    assert len(words) > 5, words
    option = next(o for o in json.loads(answer("help", "render", "--json"))["options"]
                  if o["name"] == "--features")
    config = json.loads(answer("help", "config.unknown-key", "--json"))["help"]
    copies = {"help render": listed(option["help"], "commas: ", "; or all"),
              "help config.unknown-key": listed(config, "in [Feature] ", "; parallel"),
              "web/src/main.js": listed(text_of("web/src/main.js"), "featureNames = [", "]")}
    for where, copy in copies.items():  # the page sends them by their places
        assert copy == words, f"{where} lists {copy}, not {words}"


def check_modes():
    fish = answer("help", "--completion", "fish")
    types = text_of("bindings/npm/lib/index.d.ts")
    for option in ("profile", "mode"):
        known = set(re.search(rf"explain' -l {option} -x -a '([^']+)'", fish)[1].split())
        typed = set(re.findall(r"'(\w+)'", re.search(rf"{option}\?: ([^;]+);", types)[1]))
        assert typed == known, f"index.d.ts lists {sorted(typed)} for {option}, not {sorted(known)}"


def check_folders():
    folders = listed(text_of("docs/assets.md"), "in its parent folder, the folders ", " (the course's layouts)")
    source = listed(text_of("src/scenefile/io/asset_roots.cpp"), "sibling_folders{", "}")
    assert source == folders, f"asset_roots.cpp lists {source}, docs/assets.md {folders}"


def check_pictures():
    sources = "\n".join(path.read_text(encoding="utf-8") for path in (ROOT / "src/scenefile/asset").glob("*.cpp"))
    endings = {word for words in re.findall(r'_codec\{\{"\w+", "([^"]+)"', sources) for word in words.split()}
    assert len(endings) > 8, endings
    page = re.search(r"pictureEndings = \[([^]]*)\]", text_of("web/src/files.js"))[1]
    assert set(re.findall(r"'([^']+)'", page)) == endings, f"web/src/files.js lists {page}, not {sorted(endings)}"


check_features()
check_modes()
check_folders()
check_pictures()
