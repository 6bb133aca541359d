#!/usr/bin/env python3
"""Pictures that the student's tracer drew with known mistakes, and whether an answer of `diff` names them (ledger.py)."""
import json, os, subprocess, tempfile, threading

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

    def judged(self, scene, mistakes, out, said):
        """Verdict, claims and partial claims of an answer of `diff --json`."""
        found = [c["cause"] for c in said["causes"] if c["cause"] != "rounding"]
        rivals = [c["cause"] for c in said.get("rivals", [])]
        words = [c["what"] for c in said["causes"]]
        wanted = [self.mistakes[m][1] for m in mistakes]
        if any(self.mistakes[m][0] in UNKNOWN for m in mistakes):
            # Some strange pictures are those of another scene.
            found = [f for f in found if not any(f in w for w in wanted)]
            return ("wrong" if found else "right", words, "; ".join(c["what"] for c in said.get("partial", [])))
        # All black pictures are equal, whatever the mistake is.
        if found == ["black"]:
            return ("right", words, "")
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
        return (verdict, words, "; ".join(c["what"] for c in said.get("partial", [])))
