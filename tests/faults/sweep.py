#!/usr/bin/env python3
"""Runs each command with each system call and each allocation failing in turn.

    sweep.py PROGRAM SHIM [--points N] [--last N] [--only render,check] [--kinds memory,write] [--seed 1]

SHIM is fail_call.c, built for preloading. A first run counts the calls of a kind; then each of them
(or N of them; or the last N) fails, once by itself and once with all later ones. Every run must end
by itself: with status 0 and correct output, or with status 1 to 4, a message, the previous output,
and no other file. Once the program has started, no exception may end it.
"""
import argparse
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile

parser = argparse.ArgumentParser()
parser.add_argument("program")
parser.add_argument("shim")
parser.add_argument("--points", type=int)
parser.add_argument("--last", type=int)
parser.add_argument("--only")
parser.add_argument("--kinds", default="memory,read,write,open,sync,rename,thread")
parser.add_argument("--seed", type=int, default=1)
args = parser.parse_args()
args.program, args.shim = os.path.abspath(args.program), os.path.abspath(args.shim)

OLD = b"what was there before\n"
LAST_RESORT = b"out of memory while starting or in a thread"  # app/last_resort.cpp
SECONDS = 20
SCENE = """<scenefile>
  <globaldata><ambientcoeff v="0.5"/><diffusecoeff v="0.5"/><specularcoeff v="0.5"/></globaldata>
  <cameradata><pos x="3" y="3" z="3"/><up x="0" y="1" z="0"/><focus x="0" y="0" z="0"/><heightangle v="45"/></cameradata>
  <lightdata><id v="0"/><type v="directional"/><direction x="-1" y="-1" z="-1"/><color r="1" g="1" b="1"/></lightdata>
  <object type="tree" name="twice">
    <transblock><object type="primitive" name="sphere"><diffuse r="1" g="0" b="0"/></object></transblock>
  </object>
  <object type="tree" name="root">
    <transblock><object type="master" name="twice"/></transblock>
    <transblock><translate x="1" y="0" z="0"/><object type="master" name="twice"/></transblock>
    <transblock><object type="primitive" name="cube"><diffuse r="1" g="1" b="1"/><blend v="1"/>
      <texture file="picture.png" u="1" v="1"/></object></transblock>
    <transblock><translate x="0" y="1" z="0"/><object type="primitive" name="cube"><diffuse r="1" g="1" b="1"/><blend v="1"/>
      <texture file="./picture.png" u="1" v="1"/></object></transblock>
    <transblock><object type="primitive" name="mesh" filename="triangle.obj"><diffuse r="1" g="0" b="0"/></object></transblock>
  </object>
</scenefile>
"""
TRIANGLE = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n"

# Name: command line, and the file that it writes.
COMMANDS = {
    "check": ("check scene.xml", None),
    "info": ("info scene.xml --files --tree", None),
    "info-json": ("info scene.xml --json", None),
    "render": ("render scene.xml -o out.png --size 8x8 --threads 2", "out.png"),
    "render-layers": ("render scene.xml -o out.exr --size 8x8 --threads 2 --aov depth,normal", "out.exr"),
    "denoise": ("render scene.xml -o out.pfm --size 8x8 --threads 2 --denoise", "out.pfm"),
    "store": ("render scene.xml -o out.png --size 8x40 --threads 2 --store kept", "out.png"),
    "convert": ("convert scene.xml out.json", "out.json"),
    "convert-pov": ("convert scene.xml out.pov", "out.pov"),
    "convert-glb": ("convert scene.xml out.glb --segments 8", "out.glb"),
    "convert-obj": ("convert scene.xml out.obj --segments 8", "out.obj"),
    "import": ("convert model.obj out.xml", "out.xml"),
    "format": ("format --check scene.xml", None),
    "format-file": ("format out.xml", "out.xml"),
    "diff": ("diff scene.xml other.xml", None),
    "diff-pictures": ("diff picture.png other.png --scene scene.xml --sheet out.png --threads 2", "out.png"),
    "grade": ("grade mine --references right --report out.html --threads 2", "out.html"),
    "grade-store": ("grade mine --references right --report out.html --threads 2 --store kept", "out.html"),
    "explain": ("explain scene.xml --pixel 4,4 --size 8x8", None),
}


def write(path, data):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "wb") as file:
        file.write(data if isinstance(data, bytes) else data.encode())


def read(path):
    try:
        with open(path, "rb") as file:
            return file.read()
    except OSError:
        return None


def run(folder, words, environment):
    """The status (None: it hung), standard output and standard error."""
    try:
        done = subprocess.run([args.program, *words.split()], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True,
                              timeout=SECONDS, env=dict(os.environ, **environment))
        return done.returncode, done.stdout, done.stderr
    except subprocess.TimeoutExpired as late:
        return None, late.stdout, late.stderr or b""


def make_inputs(folder):
    write(folder + "/scene.xml", SCENE)
    write(folder + "/other.xml", SCENE.replace('v="45"', 'v="46"'))
    write(folder + "/triangle.obj", TRIANGLE)
    write(folder + "/model.obj", "mtllib model.mtl\nusemtl red\n" + TRIANGLE)
    write(folder + "/model.mtl", "newmtl red\nKd 1 0 0\n")
    for name, more in (("picture.png", ""), ("other.png", "--features none")):
        subprocess.run([args.program, *("render scene.xml -q --size 8x8 -o %s %s" % (name, more)).split()], cwd=folder, check=True,
                       stderr=subprocess.DEVNULL)
    for place, name in (("right", "picture.png"), ("mine", "other.png")):
        write("%s/%s/scene.png" % (folder, place), read(folder + "/" + name))
        write("%s/%s/scene.xml" % (folder, place), SCENE)
        write("%s/%s/triangle.obj" % (folder, place), TRIANGLE)
        write("%s/%s/picture.png" % (folder, place), read(folder + "/picture.png"))


def is_json(text):
    try:
        return isinstance(json.loads(text), dict)
    except ValueError:
        return False


def old_output(output):
    """The previous contents of the output file; format also reads them."""
    return SCENE.encode() if output == "out.xml" else OLD


def list_files(folder):
    """The names in the folder, and all but complete items in a store, which stay after a failure."""
    names = [name for name in os.listdir(folder) if name != "kept"]
    kept = os.path.join(folder, "kept")
    return sorted(names + [name for name in (os.listdir(kept) if os.path.isdir(kept) else [])
                           if os.path.splitext(name)[1] not in (".exr", ".json")])


def judge(folder, output, good, result, started):
    """What is wrong with a run, if anything. started: main() had begun."""
    status, said, complained = result
    listing = list_files(folder)
    now = read(folder + "/" + output) if output else None
    if status is None:
        return "it hung"
    if status < 0 or status > 4 or status == 2:
        return "status %d" % status
    if b"terminate called" in complained or (started and LAST_RESORT in complained):
        return "terminate called"
    # A texture that cannot be read is a warning, and gives a different picture.
    warned = b"warning" in complained or (said != good["said"] and b"warning" in said)
    if status == good["status"] and not warned and (said != good["said"] or now != good["output"]):
        return "status %d, but another output" % status
    if status != good["status"] and not complained.strip() and not said.strip():
        return "no message"
    if started and good["json"] and not is_json(said):
        return "status %d, but no answer in JSON" % status
    if status >= 3 and output and now != old_output(output):
        return "the output was touched"
    # Without a texture, a model has one file less next to it.
    less = warned and status == good["status"] and set(good["before"]) <= set(listing) <= set(good["listing"])
    if listing != good["listing"] and listing != good["before"] and not less:
        return "left %s" % sorted(set(listing) - set(good["before"]))
    return ""


class Sweep:
    def __init__(self, folder, name):
        self.folder, self.name = folder, name
        self.words, self.output = COMMANDS[name]
        self.failures = self.runs = 0
        self.reset()
        before = list_files(folder)
        status, said, complained = self.run({})
        self.good = {"status": status, "said": said, "output": read(folder + "/" + self.output) if self.output else None,
                     "before": before, "listing": list_files(folder), "json": "--json" in self.words}
        if status not in (0, 1):
            sys.exit("%s fails without a fault: %r" % (name, complained))

    def reset(self):
        for name in os.listdir(self.folder):
            if name == "kept":
                shutil.rmtree(os.path.join(self.folder, name))
            elif name.startswith("out") or name.endswith(".tmp"):
                os.unlink(os.path.join(self.folder, name))
        if self.output:
            write(self.folder + "/" + self.output, old_output(self.output))

    def run(self, environment):
        return run(self.folder, self.words, environment)

    def count(self, kind, words):
        self.reset()
        place = self.folder + ".count"
        run(self.folder, words, {"LD_PRELOAD": args.shim, "FAIL_CALL": kind + ":1", "FAIL_COUNT": place})
        return int(read(place) or 0)

    def fail(self, kind, point, more, started):
        self.reset()
        result = self.run({"LD_PRELOAD": args.shim, "FAIL_CALL": "%s:%d%s" % (kind, point, more)})
        wrong = judge(self.folder, self.output, self.good, result, started)
        self.runs += 1
        if wrong:
            self.failures += 1
            print("%s, %s:%d%s: %s" % (self.name, kind, point, more, wrong), flush=True)

    def sweep(self, kind, chance):
        count = self.count(kind, self.words)
        to_start = self.count(kind, "version")
        points = range(1 if args.last is None else max(1, count - args.last + 1), count + 1)
        if args.points is not None and args.points < len(points):
            points = sorted(chance.sample(points, args.points))
        for point in points:
            for more in ("", "+"):
                self.fail(kind, point, more, point > to_start)
        return count


def main():
    chance = random.Random(args.seed)
    failures = runs = 0
    root = tempfile.mkdtemp()
    try:
        for name in args.only.split(",") if args.only else COMMANDS:
            folder = os.path.join(root, name)
            make_inputs(folder)
            sweep = Sweep(folder, name)
            counts = ["%s %d" % (kind, sweep.sweep(kind, chance)) for kind in args.kinds.split(",")]
            print("%-13s %5d runs, %d failures; calls: %s" % (name, sweep.runs, sweep.failures, ", ".join(counts)), flush=True)
            failures += sweep.failures
            runs += sweep.runs
    finally:
        shutil.rmtree(root, ignore_errors=True)
    print("%d runs, %d failures" % (runs, failures))
    return 1 if failures or runs == 0 else 0


sys.exit(main())
