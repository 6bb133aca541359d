#!/usr/bin/env python3
"""Pictures in random parts, with workers that are killed: merging gives the same bytes as one process.

    partitions.py PROGRAM SCENE... [--partitions 200] [--kills 50] [--seed 1] [--most 64]

Each partition takes a scene, a size, a profile, a mode, layers, noise reduction, a crop and a format at random, draws one
picture in one process and in a random number of parts, in random order, and compares all files. Each kill ends a worker or a
merge by SIGKILL at a random time; then everything is run again: the picture must be complete and the same.
"""
import argparse
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time

parser = argparse.ArgumentParser()
parser.add_argument("program")
parser.add_argument("scenes", nargs="+")
parser.add_argument("--partitions", type=int, default=200)
parser.add_argument("--kills", type=int, default=50)
parser.add_argument("--seed", type=int, default=1)
parser.add_argument("--most", type=int, default=64, help="maximum pixels per side")
args = parser.parse_args()
program = os.path.abspath(args.program)
scenes = [os.path.abspath(scene) for scene in args.scenes]
chance = random.Random(args.seed)
failures = []


def run(words, folder):
    return subprocess.run([program, *words], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, text=True)


def some_options():
    """Options of render, and the extension of the output."""
    width, height = chance.randint(1, args.most), chance.randint(1, args.most)
    words = ["--size", f"{width}x{height}"]
    end = chance.choice([".png", ".exr", ".pfm"])
    if chance.random() < 0.4:
        words += ["--profile", "course"]
        if chance.random() < 0.4:
            words += ["--features", "all"]
    else:
        words += ["--samples", str(chance.choice([1, 4, 16]))]
        if chance.random() < 0.4:
            words += ["--denoise"]
        if chance.random() < 0.3:
            words += ["--fresnel", "--seed", str(chance.randint(0, 99))]
    if chance.random() < 0.3:
        words += ["--mode", chance.choice(["intersect", "normals"])]
    if end != ".pfm" and chance.random() < 0.5:
        names = ["depth", "normal", "uv", "albedo", "object-id", "shadow", "reflection-depth"]
        words += ["--aov", ",".join(chance.sample(names, chance.randint(1, 4)))]
    if chance.random() < 0.3:
        x0, y0 = chance.randint(0, width - 1), chance.randint(0, height - 1)
        words += ["--crop", f"{x0},{y0},{chance.randint(x0 + 1, width)},{chance.randint(y0 + 1, height)}"]
    return words, end


def files_of(folder):
    """All files except hidden temporary files, which a killed program leaves behind."""
    return {name: open(os.path.join(folder, name), "rb").read() for name in sorted(os.listdir(folder))
            if os.path.isfile(os.path.join(folder, name)) and not name.endswith(".tmp")}


def part_words(scene, number, count, options):
    return ["render", scene, "-o", f"parts/{number}.part", "--part", f"{number}/{count}", *options]


def compare(whole, merged, what):
    expected, found = files_of(whole), files_of(merged)
    if not expected or expected != found:
        failures.append(f"{what}: the bytes differ")


def partition(number):
    scene = scenes[number % len(scenes)]
    options, end = some_options()
    count = chance.choice([1, 2, 3, chance.randint(2, 12), chance.randint(2, 40)])
    what = f"{os.path.basename(scene)} {' '.join(options)} in {count} parts, {end}"
    with tempfile.TemporaryDirectory() as folder:
        for name in ("whole", "merged", "merged/parts"):
            os.mkdir(os.path.join(folder, name))
        whole, merged = os.path.join(folder, "whole"), os.path.join(folder, "merged")
        if run(["render", scene, "-o", "picture" + end, *options], whole).returncode != 0:
            failures.append(f"{what}: one process failed")
            return
        order = list(range(1, count + 1))
        chance.shuffle(order)
        for index in order:
            done = run(part_words(scene, index, count, options), merged)
            if done.returncode != 0:
                failures.append(f"{what}: part {index}: {done.stderr}")
                return
        done = run(["merge", "parts", "-o", "picture" + end], merged)
        if done.returncode != 0:
            failures.append(f"{what}: {done.stderr}")
        compare(whole, merged, what)


def killed(number):
    """Draws all parts and merges them, killing one process halfway; then repeats everything without a kill."""
    scene = scenes[number % len(scenes)]
    options = ["--size", "160x120", "--samples", "16", "--aov", "depth,normal"]
    count = 4
    with tempfile.TemporaryDirectory() as folder:
        for name in ("whole", "merged", "merged/parts"):
            os.mkdir(os.path.join(folder, name))
        whole, merged = os.path.join(folder, "whole"), os.path.join(folder, "merged")
        run(["render", scene, "-o", "picture.exr", *options], whole)
        steps = [part_words(scene, i, count, options) for i in range(1, count + 1)] + [
            ["merge", "parts", "-o", "picture.exr"]]
        victim = chance.choice([chance.randrange(count), count])
        for i, words in enumerate(steps):
            process = subprocess.Popen([program, *words], cwd=merged, stdin=subprocess.DEVNULL,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            if i == victim:
                time.sleep(chance.random() * (0.03 if i == count else 0.4))
                process.kill()
            process.wait()
        if victim < count and os.path.exists(os.path.join(merged, "picture.exr")) and run(
                ["merge", "parts", "--missing"], merged).returncode != 0:
            failures.append("a picture was written though parts are missing")
        for words in steps:
            done = run(words, merged)
            if done.returncode != 0:
                failures.append(f"after a kill: {done.stderr}")
        compare(whole, merged, f"{os.path.basename(scene)} after a kill of step {victim}")
        left = [n for n in os.listdir(os.path.join(merged, "parts")) if not n.endswith(".part") and not n.endswith(".tmp")]
        if left:
            failures.append(f"left behind: {left}")


for i in range(args.partitions):
    partition(i)
for i in range(args.kills):
    killed(i)
for failure in failures[:20]:
    print(failure)
print(f"{args.partitions} partitions of {len(scenes)} scenes, {args.kills} kills: {len(failures)} failures")
sys.exit(1 if failures else 0)
