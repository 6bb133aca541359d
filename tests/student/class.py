#!/usr/bin/env python3
"""Generates a class and grades it: students' pictures with known mistakes, in the course's folder layout.

  class.py --build build/release --students 150 --pictures 31 --size 320x240 --out DIR

Prints how long `scenefile grade` takes and the sizes of its outputs. The pictures of a mistake are drawn once
and handed in by several students.
"""
import argparse, os, random, resource, shutil, subprocess, sys, time

HERE = os.path.dirname(os.path.abspath(__file__))
SETS = {"illuminate": ("shadows,reflect,texture", "shadows,reflect,texture"), "plain": ("none", "none"),
        "intersect": ("intersect", "intersect")}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", default="build/release")
    parser.add_argument("--students", type=int, default=150)
    parser.add_argument("--pictures", type=int, default=31)
    parser.add_argument("--kinds", type=int, default=8, help="different pictures with mistakes for each reference")
    parser.add_argument("--size", default="320x240")
    parser.add_argument("--out", required=True)
    options = parser.parse_args()
    program = os.path.join(options.build, "scenefile")
    student = os.path.join(options.build, "tests/student/scenefile_student")
    chance = random.Random(11)
    rows = [line.split("\t") for line in subprocess.run([student], capture_output=True, text=True).stdout.splitlines()]
    mistakes = [name for name, family, _ in rows if family not in ("habits", "strange")]
    scenes = sorted(n for n in os.listdir(os.path.join(HERE, "scenes")) if n.endswith(".xml"))
    drawn = os.path.join(options.out, "drawn")
    references = []
    for name, (features, word) in SETS.items():
        for scene in scenes:
            if len(references) < options.pictures:
                references.append((name, scene, features, word))
    kinds = {}
    for name, scene, features, word in references:
        folder = os.path.join(options.out, "references", name)
        os.makedirs(folder, exist_ok=True)
        os.makedirs(os.path.join(drawn, name), exist_ok=True)
        shutil.copy(os.path.join(HERE, "scenes", scene), folder)
        if os.path.isdir(os.path.join(HERE, "scenes", "image")):
            shutil.copytree(os.path.join(HERE, "scenes", "image"), os.path.join(folder, "image"), dirs_exist_ok=True)
        path = os.path.join(folder, scene)
        subprocess.run([program, "render", "-q", path, "-o", path[:-4] + ".png", "--profile", "course", "--size",
                        options.size, "--features", features], check=True)
        for kind, chosen in enumerate([()] + [(chance.choice(mistakes),) for _ in range(options.kinds)]):
            out = os.path.join(drawn, name, "%s-%d.png" % (scene[:-4], kind))
            subprocess.run([student, path, out, options.size, word] + list(chosen), check=True)
            kinds.setdefault((name, scene), []).append(out)
    for i in range(options.students):
        for (name, scene), pictures in kinds.items():
            folder = os.path.join(options.out, "handed-in", "student-%03d" % (i + 1), "student_outputs", name, "required")
            os.makedirs(folder, exist_ok=True)
            right = chance.random() < 0.6
            shutil.copy(pictures[0] if right else chance.choice(pictures[1:]), os.path.join(folder, scene[:-4] + ".png"))
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.time()
    subprocess.run([program, "grade", os.path.join(options.out, "handed-in"), "--references",
                    os.path.join(options.out, "references"), "--report", os.path.join(options.out, "report.html"), "--csv",
                    os.path.join(options.out, "grades.csv"), "-q"])
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    beside = os.path.join(options.out, "report-pictures")
    pictures = sum(os.path.getsize(os.path.join(beside, f)) for f in os.listdir(beside)) if os.path.isdir(beside) else 0
    print("%d students, %d pictures each, %s: %.1f s, %.1f CPU s; report %.2f MB, %.1f MB of pictures next to it" % (
        options.students, len(references), options.size, time.time() - start,
        after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime,
        os.path.getsize(os.path.join(options.out, "report.html")) / 1e6, pictures / 1e6))


main()
