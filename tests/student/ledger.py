#!/usr/bin/env python3
"""Writes down what `diff --scene` answers for pictures with known mistakes, and how it found the answers, and
compares two such ledgers. A change of the search is good if no right answer becomes wrong, and the sums of right
and wrong answers do not get worse.

  ledger.py write LEDGER.tsv --build build/release --folder DIR
  ledger.py compare BEFORE.tsv AFTER.tsv

`write` asks about single mistakes, the same pictures as JPEGs, combinations, pictures of correct programs, and mistakes
of no known family, for which no mistake may be named. It fails if more than 2 % of the answers are wrong, or if one
names a mistake of a correct program. The pictures are kept in DIR; remove it when the student's tracer changes.

  --sets NAME,NAME            only these
  --per-mistake 0             each mistake in all scenes, not in one
  --only light                of single mistakes only those with this in their names
  --habit habit-four-samples  every picture also has this harmless difference
  CORPUS=DIR                  also the course's scenes (references.tsv)
"""
import argparse, collections, csv, json, os, random, subprocess, sys, threading
from concurrent.futures import ThreadPoolExecutor

import mistakes

COLUMNS = ["set", "scene", "mistakes", "expected", "verdict", "route", "rays", "seconds", "claims", "partial"]
SETS = ["singles", "jpeg", "combinations", "clean", "strange"]
QUALITY = 90
GOOD = ("right", "tie")
MOST_WRONG = 0.02


def chosen(bench, options):
    """Pairs of a set and a list of (scene, mistakes), of which those with a visible mistake are asked about."""
    scenes = [s for s in bench.scenes if bench.clean_picture(s) is not None]
    families = {name: family for name, (family, _) in bench.mistakes.items()}
    habits = [m for m in families if families[m] == "habits"]
    chance = random.Random(options.seed)
    known = [m for m in families if families[m] not in mistakes.UNKNOWN]
    strange = [m for m in families if families[m] == "strange"]
    for name in options.sets.split(","):
        if name in ("singles", "jpeg", "strange"):
            for index, mistake in enumerate(strange if name == "strange" else known):
                first = (index + options.seed) % len(scenes)
                order = scenes[first:] + scenes[:first]
                if any(part in mistake for part in options.only.split(",")) and (name != "jpeg" or index % 2 == 0):
                    yield name, [(s, (mistake,)) for s in order], options.per_mistake
        elif name == "clean":
            pairs = [(s, (h,)) for s in scenes for h in habits]
            pairs += [(s, (a, b)) for s in scenes for a in habits for b in habits if a < b]
            yield name, chance.sample(pairs, min(len(pairs), options.clean)), 0
        elif name == "combinations":
            several = []
            while len(several) < 40 * options.combinations:
                members = tuple(sorted(chance.sample(known, 2 if chance.random() < 0.7 else 3)))
                if len({families[m] for m in members}) == len(members):
                    several.append((chance.choice(scenes), members))
            yield name, several, options.combinations


def drawn(bench, options):
    """Sets, scenes, mistakes and pictures to ask about: kept in the folder, because drawing takes longer than asking."""
    path = os.path.join(bench.folder, "pictures-%s.json" % "-".join(
        str(w) for w in (options.sets, options.per_mistake, options.combinations, options.clean, options.size, options.seed, options.only,
         options.habit, options.corpus_size, bool(os.environ.get("CORPUS")))))
    if not os.path.exists(path):
        def visible(task):
            name, pictures, count = task
            found = []
            for scene, members in pictures:
                picture = bench.visible(scene, members)
                if picture:
                    found.append((name, scene, members, picture))
                    if len(found) == count:
                        break
            return found

        with ThreadPoolExecutor(options.jobs) as pool:
            found = [one for some in pool.map(visible, chosen(bench, options)) for one in some]
        with open(path, "w") as file:
            json.dump(found, file)
    with open(path) as file:
        return json.load(file)


class Asker:
    """Programs that answer questions, one for each thread."""

    def __init__(self, build):
        self.command = os.path.join(build, "tests/student/scenefile_ask_causes")
        self.local = threading.local()

    def ask(self, *words):
        if not hasattr(self.local, "program"):
            self.local.program = subprocess.Popen([self.command], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        program = self.local.program
        program.stdin.write("\t".join(str(w) for w in words) + "\n")
        program.stdin.flush()
        return json.loads(program.stdout.readline())


def write(options):
    bench = mistakes.Bench(options)
    asker = Asker(options.build)

    def row(name, scene, members, picture):
        said = asker.ask(scene[2], picture, scene[1], QUALITY if name == "jpeg" else 0)
        verdict, claims, partial = bench.judged(scene, members, picture, said)
        return [name, scene[0], "+".join(members), "; ".join("|".join(sorted(bench.mistakes[m][1])) for m in members),
                verdict, said["route"], said["rays"], "%.3f" % said["seconds"], " | ".join(claims), partial]

    with open(options.ledger, "w", newline="") as file, ThreadPoolExecutor(options.jobs) as pool:
        table = csv.writer(file, delimiter="\t", lineterminator="\n")
        table.writerow(COLUMNS)
        for done in pool.map(row, *zip(*drawn(bench, options))):
            table.writerow(done)
            file.flush()
    ledger = read(options.ledger)
    show(ledger)
    wrong = [row for row in ledger.values() if row["verdict"] == "wrong"]
    for row in wrong:
        print("wrong:", row["set"], row["scene"], row["mistakes"], "-", row["claims"])
    return 1 if len(wrong) > MOST_WRONG * len(ledger) or any(row["set"] == "clean" for row in wrong) else 0


def read(path):
    with open(path, newline="") as file:
        return {(r["set"], r["scene"], r["mistakes"]): r for r in csv.DictReader(file, delimiter="\t")}


def totals(ledger):
    sums = collections.defaultdict(collections.Counter)
    for row in ledger.values():
        sums[row["set"]][row["verdict"]] += 1
        sums[row["set"]]["seconds"] += float(row["seconds"])
    return sums


def show(ledger):
    print("%-14s %6s %6s %6s %6s %6s %8s" % ("set", "right", "tie", "part", "wrong", "silent", "seconds"))
    for name, c in totals(ledger).items():
        print("%-14s %6d %6d %6d %6d %6d %8.1f" % (name, c["right"], c["tie"], c["part"], c["wrong"], c["silent"], c["seconds"]))
    routes = collections.defaultdict(collections.Counter)
    for row in ledger.values():
        for step in row["route"].split("+") if row["route"] else ["(none)"]:
            routes[step][row["verdict"]] += 1
    print("\n%-20s %6s %6s %6s %6s %6s" % ("step", "right", "tie", "part", "wrong", "silent"))
    for step, c in sorted(routes.items(), key=lambda item: -sum(item[1].values())):
        print("%-20s %6d %6d %6d %6d %6d" % (step, c["right"], c["tie"], c["part"], c["wrong"], c["silent"]))


def compare(options):
    before, after = read(options.before), read(options.after)
    both = [key for key in before if key in after]
    bad = []
    for key in both:
        a, b = before[key], after[key]
        if a["verdict"] != b["verdict"]:
            print("%s -> %s: %s\n    %s [%s]\n    %s [%s]" % (a["verdict"], b["verdict"], " ".join(key), a["claims"], a["route"],
                                                       b["claims"], b["route"]))
            if a["verdict"] in GOOD and b["verdict"] == "wrong":
                bad.append("a right answer became wrong: " + " ".join(key))
    words = sum(before[k]["claims"] != after[k]["claims"] and before[k]["verdict"] == after[k]["verdict"] for k in both)
    print("%d of %d pictures in both; %d with the same verdict in other words" % (len(both), max(len(before), len(after)), words))
    ours, theirs = totals({k: after[k] for k in both}), totals({k: before[k] for k in both})
    print("%-14s %12s %12s %12s %12s %14s" % ("set", "right", "part", "wrong", "silent", "seconds"))
    for name in theirs:
        a, b = theirs[name], ours[name]
        good = [sum(c[v] for v in GOOD) for c in (a, b)]
        print("%-14s %5d -> %4d %4d -> %4d %4d -> %4d %4d -> %4d  %5.0f (x %.2f)" % (
            name, good[0], good[1], a["part"], b["part"], a["wrong"], b["wrong"], a["silent"], b["silent"], b["seconds"],
            b["seconds"] / max(1e-9, a["seconds"])))
        bad += ["%s: fewer right answers" % name] * (good[1] < good[0])
        bad += ["%s: more wrong answers" % name] * (b["wrong"] > a["wrong"])
    print("\n".join(bad) or "not worse")
    return 1 if bad else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    one = commands.add_parser("write")
    one.add_argument("ledger")
    one.add_argument("--build", default="build/release")
    one.add_argument("--tracer", help="a student's program other than the build's")
    one.add_argument("--folder", help="folder in which to keep the pictures")
    one.add_argument("--sets", default=",".join(SETS))
    one.add_argument("--per-mistake", type=int, default=1, help="scenes per mistake; 0: all")
    one.add_argument("--combinations", type=int, default=40)
    one.add_argument("--clean", type=int, default=40)
    one.add_argument("--size", default="240x180")
    one.add_argument("--seed", type=int, default=7)
    one.add_argument("--only", default="", help="parts of names, with commas")
    one.add_argument("--habit", default="", help="a harmless difference that the student's program has in addition")
    one.add_argument("--corpus-size", default="240x180", help="of the course's scenes; own: that of the references")
    one.add_argument("--patience", type=float, default=20, help="seconds for one picture of the student's tracer")
    one.add_argument("--visible", type=float, default=0.005, help="share of pixels that must change")
    one.add_argument("--jobs", type=int, default=2)
    one.set_defaults(program=None)
    two = commands.add_parser("compare")
    two.add_argument("before")
    two.add_argument("after")
    options = parser.parse_args()
    return write(options) if options.command == "write" else compare(options)


sys.exit(main())
