#!/usr/bin/env python3
"""Pictures in stores, made by random workers of which some are killed: the same bytes as one process without a store.

    partitions.py PROGRAM SCENE... [--partitions 200] [--kills 50] [--seed 1] [--most 64]

Each partition takes a scene, a size, a profile, a mode, layers, noise reduction, a crop and a format at random. It draws the picture in
one process, and in a store by workers with shares of different sizes, in random order, sometimes two at a time, with bands that are lost
or damaged in between; then it compares all files. Each kill ends a worker or the last command by SIGKILL at a random time; then the same
commands run again.
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
    elif chance.random() < 0.2 and "--profile" not in words and "--denoise" not in words and "--fresnel" not in words:
        return words + ["--mode", "path", "--exposure", "0.3"], end
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


def share_words(scene, number, count, options):
    return ["render", scene, "--store", "store", "--part", f"{number}/{count}", *options]


def compare(whole, made, what):
    expected, found = files_of(whole), files_of(made)
    if not expected or expected != found:
        failures.append(f"{what}: the bytes differ")


def make_folders(folder):
    paths = [os.path.join(folder, name) for name in ("whole", "made")]
    for path in paths:
        os.mkdir(path)
    return paths


def damage_a_band(made):
    store = os.path.join(made, "store")
    bands = os.listdir(store) if os.path.isdir(store) else []
    if not bands:
        return
    path = os.path.join(store, chance.choice(bands))
    data = bytearray(open(path, "rb").read())
    kind = chance.choice(["lose", "cut", "flip"])
    if kind == "lose":
        os.unlink(path)
        return
    at = chance.randrange(len(data))
    if kind == "cut":
        del data[at:]
    else:
        data[at] ^= 1 << chance.randrange(8)
    with open(path, "wb") as file:
        file.write(data)


def partition(number):
    scene = scenes[number % len(scenes)]
    options, end = some_options()
    last = ["render", scene, "--store", "store", "-o", "picture" + end, *options]
    with tempfile.TemporaryDirectory() as folder:
        whole, made = make_folders(folder)
        if run(["render", scene, "-o", "picture" + end, *options], whole).returncode != 0:
            failures.append(f"{' '.join(options)}: one process failed")
            return
        counts = [chance.randint(1, 6) for _ in range(chance.randint(0, 3))]
        what = f"{os.path.basename(scene)} {' '.join(options)} in shares of {counts}, {end}"
        for count in counts:
            shares = [share_words(scene, index, count, options) for index in range(1, count + 1)]
            chance.shuffle(shares)
            workers = [subprocess.Popen([program, *words], cwd=made, stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
                       for words in shares[:2] + shares[:1]]
            for worker in workers:
                said = worker.communicate()[1]
                if worker.returncode != 0:
                    failures.append(f"{what}: {said}")
                    return
            for words in shares[:chance.randint(0, count)]:
                run(words, made)
            if chance.random() < 0.5:
                damage_a_band(made)
        missing = run([*last, "--missing", "5"], made)
        done = run(last, made)
        if done.returncode != 0 or missing.returncode not in (0, 1) or bool(missing.stdout) != bool(missing.returncode):
            failures.append(f"{what}: {done.stderr}{missing.stderr}")
        if run([*last, "--missing", "5"], made).returncode != 0:
            failures.append(f"{what}: shares are missing at the end")
        compare(whole, made, what)


def killed(number):
    """Draws shares and the picture, killing one process halfway; then repeats everything without a kill."""
    scene = scenes[number % len(scenes)]
    options = ["--size", "160x120", "--samples", "16", "--aov", "depth,normal"]
    count = 4
    with tempfile.TemporaryDirectory() as folder:
        whole, made = make_folders(folder)
        run(["render", scene, "-o", "picture.exr", *options], whole)
        steps = [share_words(scene, i, count, options) for i in range(1, count + 1)] + [
            ["render", scene, "--store", "store", "-o", "picture.exr", *options]]
        victim = chance.choice([chance.randrange(count), count])
        for i, words in enumerate(steps[:victim + 1]):
            process = subprocess.Popen([program, *words], cwd=made, stdin=subprocess.DEVNULL,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            if i == victim:
                time.sleep(chance.random() * (0.05 if i == count else 0.4))
                process.kill()
            process.wait()
        for words in steps:
            done = run(words, made)
            if done.returncode != 0:
                failures.append(f"after a kill: {done.stderr}")
        compare(whole, made, f"{os.path.basename(scene)} after a kill of step {victim}")
        left = [n for n in os.listdir(os.path.join(made, "store")) if not n.endswith(".exr") and not n.endswith(".tmp")]
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
