#!/usr/bin/env python3
"""Kills renders, and damages checkpoints.

    resume.py PROGRAM SCENE [--kills 5] [--damages 20] [--size 160x120] [--samples 256]

Kills a render at random times with SIGKILL until it is done: the picture must equal that of an
uninterrupted render, and no other file may remain. Truncates and modifies a checkpoint at random
places: each must be rejected with status 1 and a message, without a picture.
"""
import argparse
import os
import random
import signal
import subprocess
import sys
import tempfile
import time

parser = argparse.ArgumentParser()
parser.add_argument("program")
parser.add_argument("scene")
parser.add_argument("--kills", type=int, default=5)
parser.add_argument("--damages", type=int, default=20)
parser.add_argument("--size", default="160x120")
parser.add_argument("--samples", default="256")
parser.add_argument("--seed", type=int, default=1)
args = parser.parse_args()
args.program, args.scene = os.path.abspath(args.program), os.path.abspath(args.scene)
chance = random.Random(args.seed)
failures = []


def start(folder, output):
    words = [args.program, "render", args.scene, "-o", output, "--size", args.size, "--samples", args.samples,
             "--checkpoint", "work.checkpoint"]
    return subprocess.Popen(words, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)


def cut_short(folder, seconds, number):
    """The status of a render that receives the signal after this time."""
    process = start(folder, "out.png")
    try:
        process.communicate(timeout=seconds)
    except subprocess.TimeoutExpired:
        process.send_signal(number)
        process.communicate()
    return process.returncode


def read(path):
    with open(path, "rb") as file:
        return file.read()


def write(path, data):
    with open(path, "wb") as file:
        file.write(data)


with tempfile.TemporaryDirectory() as folder:
    target = os.path.join(folder, "out.png")
    kept = os.path.join(folder, "work.checkpoint")
    began = time.monotonic()
    process = start(folder, "good.png")
    said = process.communicate()[1]
    if process.returncode != 0:
        sys.exit("the uninterrupted render fails: " + said.decode(errors="replace"))
    seconds = time.monotonic() - began
    good = read(os.path.join(folder, "good.png"))

    # SIGTERM saves the state, SIGKILL leaves the last saved state; both must lead to the same
    # bytes.
    killed = 0
    while killed < args.kills:
        for number in (signal.SIGTERM, signal.SIGKILL):
            killed += cut_short(folder, seconds * chance.uniform(0.1, 0.7), number) == -signal.SIGKILL
        if start(folder, "out.png").wait() != 0 or read(target) != good:
            failures.append("the picture after kill %d is another" % killed)
        left = sorted(os.listdir(folder))
        if left != ["good.png", "out.png"]:
            # A temporary file may remain if the kill came while it was written; nothing else.
            failures += ["left %s" % name for name in left if name not in ("good.png", "out.png") and not name.endswith(".tmp")]
        for name in os.listdir(folder):
            if name != "good.png":
                os.unlink(os.path.join(folder, name))

    while not os.path.exists(kept):
        cut_short(folder, seconds * 0.4, signal.SIGTERM)
    whole = read(kept)
    for i in range(args.damages):
        damaged = bytearray(whole)
        at = chance.randrange(min(len(whole), 200)) if i % 4 == 0 else chance.randrange(len(whole))
        if i % 2 == 0:
            damaged[at] ^= 1 << chance.randrange(8)
        else:
            del damaged[at:]
        write(kept, damaged)
        process = start(folder, "damaged.png")
        said = process.communicate()[1]
        if process.returncode != 1 or b"work.checkpoint" not in said or os.path.exists(os.path.join(folder, "damaged.png")):
            failures.append("damage %d at %d: status %d, %r" % (i, at, process.returncode, said[:200]))

for failure in failures:
    print(failure)
print("%d kills, %d damaged checkpoints, %d failures" % (killed, args.damages, len(failures)))
sys.exit(1 if failures else 0)
