#!/usr/bin/env python3
"""Kills renders, and damages what they stored.

    resume.py PROGRAM SCENE [--kills 5] [--damages 20] [--size 160x120] [--samples 256]

Kills a render with a store at random times until it is done: the picture must equal that of an uninterrupted render
without a store, and no other file may remain. Truncates and modifies bands at random places: each must be drawn again, and the
picture must be the same.
"""
import argparse
import os
import pathlib
import random
import shutil
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


def start(folder, output, store=True):
    words = [args.program, "render", args.scene, "-o", output, "--size", args.size, "--samples", args.samples,
             *(["--store", "store", "--threads", "1"] if store else [])]
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
    """None if there is no such file."""
    try:
        with open(path, "rb") as file:
            return file.read()
    except FileNotFoundError:
        return None


def write(path, data):
    with open(path, "wb") as file:
        file.write(data)


with tempfile.TemporaryDirectory() as folder:
    target, store = os.path.join(folder, "out.png"), os.path.join(folder, "store")
    began = time.monotonic()
    process = start(folder, "good.png", store=False)
    said = process.communicate()[1]
    if process.returncode != 0:
        sys.exit("the uninterrupted render fails: " + said.decode(errors="replace"))
    seconds = time.monotonic() - began
    good = read(os.path.join(folder, "good.png"))

    # SIGTERM and SIGKILL leave the finished bands.
    killed = 0
    while killed < args.kills:
        for number in (signal.SIGTERM, signal.SIGKILL):
            killed += cut_short(folder, seconds * chance.uniform(0.1, 0.9), number) == -signal.SIGKILL
        if start(folder, "out.png").wait() != 0 or read(target) != good:
            failures.append("the picture after kill %d is another" % killed)
        # A temporary file may remain if the kill came while it was written; nothing else.
        for name in os.listdir(folder) + os.listdir(store):
            if name not in ("good.png", "out.png", "store") and not name.endswith((".tmp", ".exr")):
                failures.append("left %s" % name)
        pathlib.Path(target).unlink(missing_ok=True)
        shutil.rmtree(store)

    start(folder, "out.png").wait()
    for i in range(args.damages):
        band = os.path.join(store, chance.choice(os.listdir(store)))
        whole = read(band)
        damaged = bytearray(whole)
        at = chance.randrange(min(len(whole), 200)) if i % 4 == 0 else chance.randrange(len(whole))
        if i % 2 == 0:
            damaged[at] ^= 1 << chance.randrange(8)
        else:
            del damaged[at:]
        write(band, damaged)
        pathlib.Path(target).unlink(missing_ok=True)
        process = start(folder, "out.png")
        said = process.communicate()[1]
        if process.returncode != 0 or read(target) != good or read(band) != whole:
            failures.append("damage %d at %d: status %d, %r" % (i, at, process.returncode, said[:200]))

for failure in failures:
    print(failure)
print("%d kills, %d damaged bands, %d failures" % (killed, args.damages, len(failures)))
sys.exit(1 if failures else 0)
