#!/usr/bin/env python3
"""Asks `scenefile diff --scene` for the causes of pictures that the student's tracer drew with known
mistakes, and counts right, wrong and missing answers.

  mistakes.py --build build/release                 every visible mistake over our own scenes
  mistakes.py --build build/release --combinations 40
  mistakes.py --build build/release --clean 120     pairs from correct programs: no mistake may be named
  mistakes.py --build build/release --strange       pictures with mistakes of no known family: no mistake may be named
  CORPUS=DIR mistakes.py ...                        and those of the course (references.tsv)
  mistakes.py --per-mistake 2 --only light          a sample, some mistakes
  mistakes.py --habit habit-four-samples            every picture also has this harmless difference
  mistakes.py --seed 8 --folder DIR                 other scenes and combinations; keeps the pictures
"""
import argparse, collections, json, os, random, subprocess, tempfile, threading, time
from concurrent.futures import ThreadPoolExecutor

HERE = os.path.dirname(os.path.abspath(__file__))


UNKNOWN = ("habits", "strange")  # families for which no mistake may be named


def run(words, seconds=None):
    try:
        return subprocess.run(words, capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return subprocess.CompletedProcess(words, 1, "", "too slow")


class Bench:
    def __init__(self, options):
        self.options = options
        self.student = getattr(options, "tracer", None) or os.path.join(options.build, "tests/student/scenefile_student")
        self.program = options.program or os.path.join(options.build, "scenefile")
        self.folder = options.folder or tempfile.mkdtemp()
        os.makedirs(self.folder, exist_ok=True)
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
            path, picture = os.path.join(corpus, scene), os.path.join(corpus, reference)
            features = features.replace(",super-sample", "").replace("super-sample", "")
            if self.options.corpus_size == "own":
                size = open(picture, "rb").read(24)
                size = "%dx%d" % (int.from_bytes(size[16:20], "big"), int.from_bytes(size[20:24], "big"))
            else:
                # A smaller size, drawn as the reference program does.
                size = self.options.corpus_size
                picture = os.path.join(self.folder, reference.replace("/", "_"))
                run([self.program, "render", "-q", path, "-o", picture, "--profile", "course", "--size", size] +
                    (["--mode", "intersect"] if mode == "intersect" else ["--features", features or "none"]))
            self.scenes.append((reference, path, picture, "intersect" if mode == "intersect" else features or "none",
                                size))

    def draw(self, scene, mistakes):
        """The picture; reuses the file of an earlier run in the same folder."""
        if self.options.habit:
            mistakes = tuple(mistakes) + (self.options.habit,)
        out = os.path.join(self.folder, "%s.%s.%s.png" % (scene[0].replace("/", "_"), "+".join(mistakes) or "clean",
                                                          scene[4]))
        if os.path.exists(out):
            return out
        # Another thread may draw the same picture.
        part = "%s.%d.png" % (out[:-4], threading.get_ident())
        drawn = run([self.student, scene[1], part, scene[4], scene[3]] + list(mistakes), self.options.patience)
        if drawn.returncode != 0:
            return None
        os.replace(part, out)
        return out

    def share_off(self, a, b):
        """Share of the pixels that are off by more than 8/255."""
        return json.loads(run([self.program, "diff", a, b, "--json", "--max-share", "1"]).stdout)["share_over"]

    def clean_picture(self, scene):
        if scene[0] not in self.clean:
            out = self.draw(scene, ())
            # A scene that the student's tracer cannot draw (meshes, area lights) is skipped.
            good = out and self.share_off(scene[2], out) < 0.02
            self.clean[scene[0]] = out if good else None
        return self.clean[scene[0]]

    def visible(self, scene, mistakes):
        """The picture with the mistakes, if each of them changes it."""
        clean = self.clean_picture(scene)
        if clean is None:
            return None
        out = self.draw(scene, mistakes)
        if out is None:
            return None
        if all(self.mistakes[m][0] == "habits" for m in mistakes):
            return out
        if self.share_off(out, clean) < self.options.visible:
            return None
        for one in mistakes if len(mistakes) > 1 else ():
            without = self.draw(scene, tuple(m for m in mistakes if m != one))
            if without is None or self.share_off(out, without) < 2 * self.options.visible:
                return None
        return out

    def draws_same(self, scene, mistakes, found, out):
        """Whether a claimed mistake, in place of the mistakes that are not named, draws the same picture."""
        kept = tuple(m for m in mistakes if any(f in self.mistakes[m][1] for f in found))
        strange = {f for f in found if not any(f in self.mistakes[m][1] for m in mistakes)}
        others = [m for m in self.mistakes if self.mistakes[m][0] not in UNKNOWN and self.mistakes[m][1] & strange]
        replaces = len(strange) == 1 and len(kept) < len(mistakes)
        samples = ("habit-four-samples",)
        pictures = (self.draw(scene, kept + (m,) + habit) for m in others if replaces for habit in ((), samples))
        return any(p and self.share_off(out, p) < 0.002 for p in pictures)

    def ask(self, scene, mistakes, out):
        start = time.time()
        answer = run([self.program, "diff", scene[2], out, "--scene", scene[1], "--json"])
        seconds = time.time() - start
        try:
            said = json.loads(answer.stdout)
        except ValueError:
            return ("error", [], seconds, answer.stderr)
        return self.judged(scene, mistakes, out, said, seconds)

    def judged(self, scene, mistakes, out, said, seconds):
        """Verdict, claims, seconds and partial claims of an answer of `diff --json`."""
        found = [c["cause"] for c in said["causes"] if c["cause"] != "rounding"]
        rivals = [c["cause"] for c in said.get("rivals", [])]
        words = [c["what"] for c in said["causes"]]
        wanted = [self.mistakes[m][1] for m in mistakes]
        if any(self.mistakes[m][0] in UNKNOWN for m in mistakes):
            # Some strange pictures are those of another scene.
            found = [f for f in found if not any(f in w for w in wanted)]
            return ("wrong" if found else "right", words, seconds, "; ".join(c["what"] for c in said.get("partial", [])))
        # All black pictures are equal, whatever the mistake is.
        if found == ["black"]:
            return ("right", words, seconds, "")
        # Features of the reference that are not drawn are notes beside claims.
        noted = found + [c["cause"] for c in said.get("notes", [])]
        named = [any(f in w for f in noted) for w in wanted]
        strange = [f for f in found if not any(f in w for w in wanted)]
        if any(c["cause"] == "rounding" for c in said["causes"]):
            strange.append("rounding")
        if strange and len(found) <= len(wanted) and all(any(f in w for f in found + rivals) for w in wanted):
            verdict = "tie"  # the pictures are the same, and the claim names both mistakes
        elif strange:
            verdict = "tie" if self.draws_same(scene, mistakes, found, out) else "wrong"
        elif all(named):
            verdict = "right"
        else:
            verdict = "part" if any(named) else "silent"
        return (verdict, words, seconds, "; ".join(c["what"] for c in said.get("partial", [])))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", default="build/release")
    parser.add_argument("--program", help="a scenefile other than the build's")
    parser.add_argument("--size", default="240x180")
    parser.add_argument("--only", default="", help="parts of names, with commas")
    parser.add_argument("--scene", default="")
    parser.add_argument("--per-mistake", type=int, default=0, help="scenes per mistake; 0: all")
    parser.add_argument("--combinations", type=int, default=0)
    parser.add_argument("--clean", type=int, default=0, help="number of pairs from correct programs")
    parser.add_argument("--strange", action="store_true", help="mistakes of no known family")
    parser.add_argument("--corpus-size", default="240x180", help="of the course's scenes; own: that of the references")
    parser.add_argument("--patience", type=float, default=20, help="seconds for one picture of the student's tracer")
    parser.add_argument("--visible", type=float, default=0.005, help="share of pixels that must change")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--verbose", action="store_true")
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--habit", default="", help="a harmless difference that the student's program has in addition")
    parser.add_argument("--folder", help="folder in which to keep the pictures")
    options = parser.parse_args()
    bench = Bench(options)
    scenes = [s for s in bench.scenes if options.scene in s[0]]
    for scene in scenes:
        bench.clean_picture(scene)
    tasks = []
    chance = random.Random(options.seed)
    scenes = [s for s in scenes if bench.clean[s[0]] is not None]
    habits = [m for m in bench.mistakes if bench.mistakes[m][0] == "habits"]
    if options.clean:
        choices = [(s, (h,)) for s in scenes for h in habits]
        choices += [(s, (a, b)) for s in scenes for a in habits for b in habits if a < b]
        chance.shuffle(choices)
        tasks = choices[:options.clean]
    elif options.combinations:
        names = [m for m in bench.mistakes if bench.mistakes[m][0] not in UNKNOWN and
                 m not in ("output-black", "output-half-drawn", "camera-corners", "output-misses-black")]
        while len(tasks) < 40 * options.combinations:
            count = 2 if chance.random() < 0.7 else 3
            chosen = tuple(sorted(chance.sample(names, count)))
            if len({bench.mistakes[m][0] for m in chosen}) == count:
                tasks.append((chance.choice(scenes), chosen))
    else:
        for index, name in enumerate(m for m in bench.mistakes if any(w in m for w in options.only.split(",")) and
                                     (bench.mistakes[m][0] == "strange" if options.strange
                                      else bench.mistakes[m][0] not in UNKNOWN)):
            first = (index + options.seed) % len(scenes)
            order = scenes[first:] + scenes[:first]
            tasks.append((order, (name,)))
    results = []

    def judge(task):
        places, mistakes = task
        answers = []
        for scene in places if isinstance(places, list) else [places]:
            if options.combinations and not options.clean and len(results) >= options.combinations:
                break
            out = bench.visible(scene, mistakes)
            if out is None:
                continue
            verdict, words, seconds, more = bench.ask(scene, mistakes, out)
            answers.append((scene[0], mistakes, verdict, words, seconds, more))
            if verdict != "right" or options.verbose:
                print("%-7s %-22s %-40s %5.1f s  %s%s" % (verdict, scene[0][-22:], "+".join(mistakes), seconds,
                                                      " | ".join(words), "  [in part: %s]" % more if more else ""),
                      flush=True)
            if options.combinations:
                results.append(answers[-1])
            if options.per_mistake and len(answers) >= options.per_mistake:
                break
        return answers

    with ThreadPoolExecutor(options.jobs) as pool:
        answers = [a for list_ in pool.map(judge, tasks) for a in list_]
    if options.combinations:
        answers = answers[:options.combinations]
    table = collections.defaultdict(collections.Counter)
    for scene, mistakes, verdict, words, seconds, more in answers:
        family = "clean" if options.clean else "combinations" if len(mistakes) > 1 else bench.mistakes[mistakes[0]][0]
        table[family][verdict] += 1
        table["all"][verdict] += 1
    print("\n%-14s %6s %6s %6s %6s %6s %6s" % ("family", "right", "tie", "part", "wrong", "silent", "error"))
    for family in sorted(table, key=lambda f: (f == "all", f)):
        c = table[family]
        print("%-14s %6d %6d %6d %6d %6d %6d" % (family, c["right"], c["tie"], c["part"], c["wrong"], c["silent"],
                                             c["error"]))
    if answers:
        print("slowest %.1f s" % max(a[4] for a in answers))


if __name__ == "__main__":
    main()
