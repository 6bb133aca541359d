#!/usr/bin/env python3
"""results.py STATUS GRADED MESSAGES: converts the output of `scenefile grade --json` to Gradescope's results."""
import json
import pathlib
import sys


def words_of(picture):
    lines = [picture["verdict"]]
    if "psnr_db" in picture:
        lines[0] += f", {picture['psnr_db']:.1f} dB"
    lines += picture.get("reasons", [])
    lines += [f"{cause['what']} ({cause['cause']})" for cause in picture.get("causes", [])]
    return "\n".join(lines)


status, graded, messages = int(sys.argv[1]), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
if status not in (0, 1):
    print(json.dumps({"score": 0, "output": f"Nothing could be graded:\n{messages.read_text()}"}))
    sys.exit()
pictures = [picture for student in json.loads(graded.read_text())["students"] for picture in student["pictures"]]
print(json.dumps({"tests": [{"name": picture["name"], "score": int(picture["verdict"] == "passed"), "max_score": 1,
                             "output": words_of(picture)} for picture in pictures]}, indent=1))
