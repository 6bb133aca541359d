#!/usr/bin/env python3
"""Counts what `scenefile diff` says about path-traced pictures with planted mistakes.

mistakes.py --build BUILD [--folder DIR] [--size 128] [--samples 256] [--seeds 1] [--first-seed 1]
            [--clean N] [--only WORDS] [--format pfm|png] [--seconds S] [--jobs N]

Draws rooms (rooms.py) with the student's path tracer, each with one mistake, asks, and prints a table: right (the
mistake is named), in part (a true place or number, no name), silent, wrong. --clean N draws N pictures by right
programs with other conventions instead; any cause is wrong there. Fails if more than 2 % of the answers are wrong.
"""
import argparse, concurrent.futures, json, os, random, re, subprocess, sys
import rooms

MOST_WRONG = 0.02
ALL = "box glossy mirror glass lamps mixed"
# word: (rooms that show it, names that are right)
MISTAKES = {
    "no-direct-cosine": ("box glossy lamps", "surface-cosine"),
    "no-indirect-cosine": ("box lamps", "surface-cosine"),
    "no-cosine": ("box mirror", "surface-cosine"),
    "cosine-twice": ("box lamps", "surface-cosine"),
    "indirect-cosine-twice": ("box", "surface-cosine"),
    "no-lamp-cosine": ("box mirror lamps", "lamp-cosine"),
    "falloff-d": ("box glass lamps", "distance"),
    "no-falloff": ("box mixed", "distance"),
    "falloff-d3": ("box", "distance"),
    "no-area": ("box lamps", "lamp-area lamp-sampling"),
    "area-inverse": ("box", "lamp-area lamp-sampling"),
    "area-twice": ("box", "direct-twice lamp-sampling lamp-area"),
    "no-choice-pdf": ("box lamps", "lamp-sampling"),
    "first-lamp-only": ("lamps", "lamp-choice"),
    "no-ke": ("box lamps", "lamp-color"),
    "lights-summed lights=4": ("box", "lamp-sampling"),
    "lights-divided-twice lights=4": ("box", "lamp-sampling"),
    "no-pi": ("box lamps", "pi"),
    "no-pi-direct": ("box mirror", "pi"),
    "no-pi-indirect": ("box", "pi"),
    "pi-twice": ("box", "pi"),
    "pi-twice-direct": ("box", "pi"),
    "no-direction-pdf": ("box lamps", "direction-density"),
    "cosine-uniform-pdf": ("box glossy", "direction-density"),
    "uniform-cosine-pdf": ("box lamps", "direction-density"),
    "whole-sphere": ("box", "direction-density scattered-factor"),
    "no-roulette-weight p=0.7": ("box mirror glass", "roulette"),
    "roulette-twice p=0.8": ("box", "roulette"),
    "roulette-1-p p=0.7": ("box lamps", "roulette"),
    "depth=1": ("box glossy", "depth"),
    "depth=2": ("box mixed", "depth"),
    "depth=3": ("box", "depth"),
    "depth=0": ("box", "no-reflected-light"),
    "direct-twice": ("box lamps", "direct-twice"),
    "emission-always": ("box glossy", "direct-twice"),
    "no-emission-after-mirror": ("mirror mixed", "emission-after-specular"),
    "no-emission-after-glass": ("glass mixed", "emission-after-specular"),
    "no-emission-after-specular": ("mirror glass", "emission-after-specular"),
    "no-visibility": ("box mixed lamps", "visibility"),
    "shadow-self": ("box", "self-shadow"),
    "shadow-lamp": ("box", "no-reflected-light"),
    "eta-inverted": ("glass mixed", "refraction"),
    "eta-always-in": ("glass", "refraction"),
    "no-total-reflection": ("glass", "total-reflection"),
    "total-reflection-nan": ("glass", "total-reflection not-finite"),
    "fresnel-twice": ("glass mixed", "fresnel"),
    "no-fresnel": ("glass", "fresnel"),
    "fresnel-half": ("glass", "fresnel"),
    "glass-half": ("glass", "glass-factor"),
    "triangle-corner": ("box lamps", "lamp-points"),
    "triangle-normalized": ("box", "lamp-points"),
    "lamp-center": ("box", "lamp-points"),
    "parallelogram": ("box lamps", "lamp-points"),
    "gray-throughput": ("box lamps", "gray-throughput"),
    "mean-throughput": ("glossy", "gray-throughput"),
    "throughput-replaced": ("box lamps", "throughput-replaced"),
    "angle=1.15": ("box", "view-angle"),
    "angle=0.9": ("mixed", "view-angle"),
    "angle-whole": ("lamps", "view-angle"),
    "emission-twice": ("box", "brightness"),
    "emission-half": ("mirror", "brightness"),
    "divide-less": ("box", "brightness"),
    "kd-twice": ("box lamps", "diffuse-color"),
    "kd-twice-direct": ("box", "diffuse-color"),
    "kd-twice-indirect": ("box", "diffuse-color"),
    "kd-missing-direct": ("box", "diffuse-color"),
    "kd-missing-indirect": ("lamps", "diffuse-color"),
    "no-glossy": ("glossy", "glossy"),
    "no-phong-scale": ("glossy", "glossy"),
    "blinn": ("glossy", "glossy"),
    "mirror-cosine": ("mirror", "mirror-cosine"),
    "mirror-black": ("mirror mixed", "mirror"),
    "flat-normals": ("box glass", "flat-normals"),
    "same-random-number": ("box", "directions"),
    "polar-uniform": ("box", "directions direction-density"),
    "same-seed": ("box", "same-numbers"),
    "indirect-half": ("box", "scattered-factor"),
    "bgr": ("box", "swapped-channels"),
    "gamma-twice": ("box", "gamma"),
    "clamp=1": ("box", "clamped"),
}
CONVENTIONS = ["", "cosine", "stratified", "corners", "centers", "jitter-corner", "by-area", "all-lamps",
               "p-albedo", "p=0.6", "p=0.95", "lights=4", "two-sided", "schlick", "mirror-no-ks", "lobe-alone",
               "bsdf-only", "cosine p-albedo", "cosine by-area stratified", "stop-at-lamps"]


def cases(options):
    """(key, room, room seed, words, names that are right; empty: none is wrong)"""
    chooser = random.Random(options.first_seed)
    if options.clean:
        for i in range(options.clean):
            convention = CONVENTIONS[i % len(CONVENTIONS)]
            kind = rooms.KINDS[(i // len(CONVENTIONS) + i) % len(rooms.KINDS)]
            yield f"right-{i}", kind, options.first_seed + i % options.seeds, convention.split(), ""
        return
    for words, (kinds, names) in MISTAKES.items():
        if options.only and not any(w in words for w in options.only.split(",")):
            continue
        for kind in kinds.split():
            for seed in range(options.first_seed, options.first_seed + options.seeds):
                usual = chooser.choice([[], ["cosine"], ["p-albedo"], ["by-area"]])
                if any(w in words for w in ("pdf", "roulette", "first-lamp", "choice", "pi-indirect", "whole", "number",
                                            "axis", "polar")) or words in ("no-pi", "pi-twice", "no-indirect-cosine", "no-cosine"):
                    usual = []
                yield f"{words.replace(' ', '_')}", kind, seed, words.split() + usual, names


def judge(answer, names):
    """right, in part, silent or wrong; and what was said"""
    said = [(c["name"], c["what"]) for c in answer["causes"]]
    part = [(c["name"], c["what"]) for c in answer["partial"]]
    if not names:
        return ("wrong" if said or part else "silent"), said or part
    right = set(names.split())
    if said:
        return ("right" if any(n in right for n, _ in said) else "wrong"), said
    if part:
        return "in part", part
    return "silent", []


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", required=True)
    parser.add_argument("--folder", default="out/path-mistakes")
    parser.add_argument("--size", default="128")
    parser.add_argument("--samples", type=int, default=256)
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--first-seed", type=int, default=1)
    parser.add_argument("--clean", type=int, default=0)
    parser.add_argument("--only", default="")
    parser.add_argument("--format", default="pfm")
    parser.add_argument("--tone", default="course")
    parser.add_argument("--seconds", default="10")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--draw-only", action="store_true")
    options = parser.parse_args()
    student = os.path.join(options.build, "tests/student_path/scenefile_student_path")
    ask = os.path.join(options.build, "tests/student_path/scenefile_ask_path")
    by_scene = {}

    def draw(case):
        key, kind, seed, words, _ = case
        scene = rooms.write(options.folder, kind, seed)
        out = f"{scene[:-4]}-{key}-{options.size}-{options.samples}.{options.format}"
        if not os.path.exists(out):
            extra = [] if options.format == "pfm" else ["tone=" + options.tone]
            subprocess.run([student, scene, out, f"{options.size}x{options.size}", str(options.samples),
                            str(seed * 1000 + sum(map(ord, key)))] + words + extra, check=True)
        return scene, out

    listed = list(cases(options))
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for case, (scene, out) in zip(listed, pool.map(draw, listed)):
            by_scene.setdefault(scene, []).append((case, out))
    if options.draw_only:
        return 0
    counts, rows = {}, []

    def ask_about(item):
        scene, pictures = item
        done = subprocess.run([ask, scene, options.seconds] + [out for _, out in pictures], check=True,
                              capture_output=True, text=True)
        return [json.loads(line) for line in done.stdout.splitlines()]

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for (scene, pictures), answers in zip(by_scene.items(), pool.map(ask_about, by_scene.items())):
            for (case, out), answer in zip(pictures, answers):
                verdict, said = judge(answer, case[4])
                also = [c["name"] for c in answer["conventions"]] + [c["name"] for c in answer["notes"]]
                if answer["right"]:
                    also.append("right")
                if answer["too_noisy"]:
                    also.append("too noisy")
                counts[verdict] = counts.get(verdict, 0) + 1
                rows.append((verdict, " ".join(case[3]) or "-", os.path.basename(scene), "; ".join(w for _, w in said), " ".join(also)))
    for row in sorted(rows):
        print("\t".join(row))
    print(", ".join(f"{n} {v}" for v, n in sorted(counts.items())), "of", len(rows))
    return 1 if not rows or counts.get("wrong", 0) > MOST_WRONG * len(rows) else 0


sys.exit(main())
