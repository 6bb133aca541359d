#!/usr/bin/env python3
"""Asks `scenefile diff --scene` for the causes of pictures that the student's tracer made with known
mistakes, and counts the answers that are right, wrong, and none.

  mistakes.py --build build/release                 every visible mistake over our own scenes
  mistakes.py --build build/release --combinations 40
  CORPUS=DIR mistakes.py ...                        and those of the course (references.tsv)
  mistakes.py --per-mistake 2 --only light          a sample, some mistakes
"""
import argparse, collections, json, os, random, subprocess, sys, tempfile, time, zlib
from concurrent.futures import ThreadPoolExecutor

HERE = os.path.dirname(os.path.abspath(__file__))


def run(words):
    return subprocess.run(words, capture_output=True, text=True)


def pixels(path):
    """Rows of an 8-bit RGB picture."""
    data = open(path, "rb").read()
    at, body, width, height = 8, b"", 0, 0
    while at < len(data):
        size = int.from_bytes(data[at:at + 4], "big")
        kind, chunk = data[at + 4:at + 8], data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height = int.from_bytes(chunk[:4], "big"), int.from_bytes(chunk[4:8], "big")
        elif kind == b"IDAT":
            body += chunk
        at += 12 + size
    raw, rows, last = zlib.decompress(body), [], bytes(3 * width)
    for y in range(height):
        line = raw[y * (3 * width + 1):(y + 1) * (3 * width + 1)]
        row = bytearray(line[1:])
        if line[0] == 1:
            for i in range(3, len(row)):
                row[i] = (row[i] + row[i - 3]) & 255
        elif line[0] == 2:
            row = bytearray((a + b) & 255 for a, b in zip(row, last))
        elif line[0] == 3:
            for i in range(len(row)):
                row[i] = (row[i] + ((row[i - 3] if i >= 3 else 0) + last[i]) // 2) & 255
        elif line[0] == 4:
            for i in range(len(row)):
                a, b, c = (row[i - 3] if i >= 3 else 0), last[i], (last[i - 3] if i >= 3 else 0)
                p = a + b - c
                pa, pb, pc = abs(p - a), abs(p - b), abs(p - c)
                row[i] = (row[i] + (a if pa <= pb and pa <= pc else b if pb <= pc else c)) & 255
        last = bytes(row)
        rows.append(last)
    return rows


def share_off(a, b):
    off = count = 0
    for p, q in zip(a, b):
        for i in range(0, len(p), 3):
            count += 1
            off += abs(p[i] - q[i]) > 8 or abs(p[i + 1] - q[i + 1]) > 8 or abs(p[i + 2] - q[i + 2]) > 8
    return off / max(1, count)


class Bench:
    def __init__(self, options):
        self.options = options
        self.student = os.path.join(options.build, "tests/student/scenefile_student")
        self.program = options.program or os.path.join(options.build, "scenefile")
        self.folder = tempfile.mkdtemp()
        rows = [line.split("\t") for line in run([self.student]).stdout.splitlines()]
        self.mistakes = {name: (family, set(causes.split("|"))) for name, family, causes in rows}
        self.scenes = []
        for name in sorted(os.listdir(os.path.join(HERE, "scenes"))):
            if name.endswith(".xml"):
                path = os.path.join(HERE, "scenes", name)
                reference = os.path.join(self.folder, name + ".reference.png")
                run([self.program, "render", "-q", path, "-o", reference, "--profile", "course", "--size",
                     options.size, "--features", "shadows,reflect,refract,texture"])
                self.scenes.append((name, path, reference, "all", options.size))
        corpus = os.environ.get("CORPUS")
        if corpus:
            self.add_corpus(corpus)
        self.clean = {}

    def add_corpus(self, corpus):
        for line in open(os.path.join(corpus, "references.tsv")).read().splitlines()[1:]:
            scene, reference, mode, features = (line + "\t\t\t").split("\t")[:4]
            if "grading_illuminate" not in reference and "grading_intersect" not in reference:
                continue
            size = open(os.path.join(corpus, reference), "rb").read(24)
            size = "%dx%d" % (int.from_bytes(size[16:20], "big"), int.from_bytes(size[20:24], "big"))
            self.scenes.append((reference, os.path.join(corpus, scene), os.path.join(corpus, reference),
                                "intersect" if mode == "intersect" else features or "none", size))

    def draw(self, scene, mistakes):
        out = os.path.join(self.folder, "%s.%s.png" % (scene[0].replace("/", "_"), "+".join(mistakes) or "clean"))
        drawn = run([self.student, scene[1], out, scene[4], scene[3]] + list(mistakes))
        return out if drawn.returncode == 0 else None

    def clean_rows(self, scene):
        if scene[0] not in self.clean:
            out = self.draw(scene, ())
            rows = pixels(out) if out else None
            # A scene that the student's tracer cannot draw (meshes, area lights) tells nothing.
            good = out and share_off(pixels(scene[2]), rows) < 0.02
            self.clean[scene[0]] = rows if good else None
        return self.clean[scene[0]]

    def visible(self, scene, mistakes):
        """The picture with the mistakes, where each of them changes it."""
        clean = self.clean_rows(scene)
        if clean is None:
            return None
        out = self.draw(scene, mistakes)
        if out is None:
            return None
        rows = pixels(out)
        if share_off(rows, clean) < self.options.visible:
            return None
        for one in mistakes if len(mistakes) > 1 else ():
            without = self.draw(scene, tuple(m for m in mistakes if m != one))
            if without is None or share_off(rows, pixels(without)) < 2 * self.options.visible:
                return None
        return out

    def ask(self, scene, mistakes, out):
        start = time.time()
        answer = run([self.program, "diff", scene[2], out, "--scene", scene[1], "--json"])
        seconds = time.time() - start
        try:
            said = json.loads(answer.stdout)
        except ValueError:
            return ("error", [], seconds, answer.stderr)
        found = [c["cause"] for c in said["causes"] if c["cause"] != "rounding"]
        words = [c["what"] for c in said["causes"]]
        wanted = [self.mistakes[m][1] for m in mistakes]
        if found == ["black"] and max(max(row) for row in pixels(out)) <= 2:
            return ("right", words, seconds, "")
        named = [any(f in w for f in found) for w in wanted]
        strange = [f for f in found if not any(f in w for w in wanted)]
        if any(c["cause"] == "rounding" for c in said["causes"]):
            strange.append("rounding")
        if strange and not any(f for f in found if any(f in w for w in wanted)):
            verdict = "wrong"
        elif strange:
            verdict = "wrong"
        elif all(named):
            verdict = "right"
        else:
            verdict = "part" if any(named) else "silent"
        return (verdict, words, seconds, "; ".join(c["what"] for c in said.get("partial", [])))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", default="build/release")
    parser.add_argument("--program", help="another scenefile than that of the build")
    parser.add_argument("--size", default="320x240")
    parser.add_argument("--only", default="")
    parser.add_argument("--scene", default="")
    parser.add_argument("--per-mistake", type=int, default=0, help="scenes a mistake, 0: all")
    parser.add_argument("--combinations", type=int, default=0)
    parser.add_argument("--visible", type=float, default=0.005, help="share of pixels that must change")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    bench = Bench(options)
    scenes = [s for s in bench.scenes if options.scene in s[0]]
    for scene in scenes:
        bench.clean_rows(scene)
    tasks = []
    chance = random.Random(7)
    if options.combinations:
        names = [m for m in bench.mistakes if m != "output-black" and m != "camera-corners"]
        while len(tasks) < 40 * options.combinations:
            count = 2 if chance.random() < 0.7 else 3
            chosen = tuple(sorted(chance.sample(names, count)))
            if len({bench.mistakes[m][0] for m in chosen}) == count:
                tasks.append((chance.choice(scenes), chosen))
    else:
        for index, name in enumerate(m for m in bench.mistakes if options.only in m):
            order = scenes[index % len(scenes):] + scenes[:index % len(scenes)]
            tasks.append((order, (name,)))
    results = []

    def judge(task):
        places, mistakes = task
        answers = []
        for scene in places if isinstance(places, list) else [places]:
            if options.combinations and len(results) >= options.combinations:
                break
            out = bench.visible(scene, mistakes)
            if out is None:
                continue
            verdict, words, seconds, more = bench.ask(scene, mistakes, out)
            answers.append((scene[0], mistakes, verdict, words, seconds, more))
            if options.combinations:
                results.append(answers[-1])
            if options.per_mistake and len(answers) >= options.per_mistake:
                break
        return answers

    # Black pictures are black pictures, whatever the mistake; they are read where they are asked for.
    with ThreadPoolExecutor(options.jobs) as pool:
        answers = [a for list_ in pool.map(judge, tasks) for a in list_]
    if options.combinations:
        answers = answers[:options.combinations]
    table = collections.defaultdict(collections.Counter)
    for scene, mistakes, verdict, words, seconds, more in answers:
        family = "combinations" if len(mistakes) > 1 else bench.mistakes[mistakes[0]][0]
        table[family][verdict] += 1
        table["all"][verdict] += 1
        if verdict != "right" or options.verbose:
            print("%-7s %-22s %-40s %5.1f s  %s%s" % (verdict, scene[-22:], "+".join(mistakes), seconds, " | ".join(words),
                                                  "  [in part: %s]" % more if more else ""))
    print("\n%-14s %6s %6s %6s %6s %6s" % ("family", "right", "part", "wrong", "silent", "error"))
    for family in sorted(table, key=lambda f: (f == "all", f)):
        c = table[family]
        print("%-14s %6d %6d %6d %6d %6d" % (family, c["right"], c["part"], c["wrong"], c["silent"], c["error"]))
    if answers:
        print("slowest %.1f s" % max(a[4] for a in answers))


main()
