#!/usr/bin/env python3
"""Checks the pages: links lead somewhere, and the commands that are shown run.

    pages.py links                  every link of every page leads to an existing page and heading; first pages are short
    pages.py commands PROGRAM       every line that begins with `scenefile` runs, on files with the names it uses

A command ends with status 0, or 1 for findings and differences. Commands of the window draw one picture on a virtual screen, if there is
xvfb-run; otherwise they are counted as skipped.
"""
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")])
SCENE = """<scenefile>
  <globaldata><ambientcoeff v="0.5"/><diffusecoeff v="0.5"/><specularcoeff v="0.5"/></globaldata>
  <cameradata><pos x="3" y="2.2" z="4"/><focus x="0" y="0.3" z="0"/><up x="0" y="1" z="0"/><heightangle v="35"/></cameradata>
  <lightdata><id v="0"/><type v="directional"/><direction x="-1" y="-2" z="-1"/><color r="1" g="1" b="1"/></lightdata>
  <object type="tree" name="root"><transblock><translate x="0" y="0.5" z="0"/>
    <object type="primitive" name="sphere"><diffuse r="0.9" g="0.3" b="0.2"/></object></transblock></object>
</scenefile>
"""


def without_code(text):
    """The lines outside of code, and without `code` in them."""
    lines, fenced = [], False
    for line in text.splitlines():
        if line.lstrip().startswith("```"):
            fenced = not fenced
        elif not fenced and not line.startswith("    "):
            lines.append(re.sub(r"`[^`]*`", "", line))
    return "\n".join(lines)


def anchors(page):
    """The anchors of headings and ids."""
    text, fenced, names = page.read_text(), False, set()
    for line in text.splitlines():
        if line.lstrip().startswith("```"):
            fenced = not fenced
        heading = re.match(r"#+\s+(.*)", line)
        if heading and not fenced:
            words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading[1])
            names.add(re.sub(r"[-\s]+", "-", re.sub(r"[^\w\s-]", "", words).strip().lower()))
    return names | set(re.findall(r'(?:id|name)="([^"]+)"', text))


def too_long():
    """Pages that are to be read at once, with more lines than that allows."""
    most = {"README.md": 120, "CONTRIBUTING.md": 120, "ARCHITECTURE.md": 150}
    most |= {f"docs/{name}.md": 120 for name in ("index", "install", "student", "grader", "author", "builder")}
    sizes = {name: len((ROOT / name).read_text().splitlines()) for name in most}
    return [f"{name}: {sizes[name]} lines, and {limit} are the most" for name, limit in most.items() if sizes[name] > limit]


def dead_links():
    dead, count = [], 0
    for page in PAGES:
        for link in re.findall(r"\]\(([^)\s]+)\)", without_code(page.read_text())):
            if re.match(r"[a-z]+:", link):
                continue
            count += 1
            name, _, anchor = link.partition("#")
            target = (page.parent / name).resolve() if name else page
            if not target.exists():
                dead.append(f"{page.relative_to(ROOT)}: {link}: no such file")
            elif page.is_relative_to(ROOT / "docs") and not target.is_relative_to(ROOT / "docs"):
                dead.append(f"{page.relative_to(ROOT)}: {link}: not on the site, which has only the files of docs/")
            elif anchor and target.suffix == ".md" and anchor not in anchors(target):
                dead.append(f"{page.relative_to(ROOT)}: {link}: no such heading")
    return dead, count


SCENE_OF_PATH = SCENE[:SCENE.index("<lightdata>")] + SCENE[SCENE.rindex("</lightdata>") + len("</lightdata>"):]
SCENE_OF_PATH = re.sub(r'<object type="primitive".*?</object>',
                       '<object type="primitive" name="mesh" filename="box.obj"/>', SCENE_OF_PATH, flags=re.S)
BOX = """mtllib box.mtl
v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1
v -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1
usemtl wall\nf 1 2 3 4\nusemtl lamp\nf 5 6 7 8
"""


def commands():
    """Page, line number and text of each command shown."""
    for page in PAGES:
        if page.name in ("CHANGELOG.md", "library-reference.md"):  # the latter shows layouts of files
            continue
        code, open_line = False, ""
        for number, line in enumerate(page.read_text().splitlines(), 1):
            if line.lstrip().startswith("```"):
                code = not code
                continue
            if not code and not line.startswith("    "):
                continue
            line = re.sub(r"^\$ ", "", line.strip())
            if not open_line and not line.startswith("scenefile "):
                continue
            line = open_line + line
            open_line = line[:-1] if line.endswith("\\") else ""
            if not open_line:
                yield page.relative_to(ROOT), number, re.sub(r"\s+#.*$", "", line)


def make_files(folder, program):
    """Creates files with the names that the pages use."""

    def run(*words):
        subprocess.run([program, *words], cwd=folder, check=True, stderr=subprocess.DEVNULL)

    for name in ("chess", "ball", "scene", "old", "new", "a", "b"):
        (folder / f"{name}.xml").write_text(SCENE.replace('v="35"', 'v="40"') if name in ("new", "b") else SCENE)
    run("convert", "scene.xml", "scene.json")
    run("convert", "scene.xml", "model.glb")
    # The pages explain the pixels 320,240 and 512,384.
    run("render", "scene.xml", "-o", "reference.png", "--size", "528x396", "--profile", "course")
    run("render", "new.xml", "-o", "mine.png", "--size", "528x396", "--profile", "course")
    (folder / "scenes").mkdir()
    for name in ("chess", "hello", "showcase", "studio"):
        (folder / "scenes" / f"{name}.xml").write_text(SCENE)
    for place in ("references", "pictures", "right"):
        (folder / place).mkdir()
        shutil.copy(folder / "reference.png", folder / place / "chess.png")
    (folder / "cameras.json").write_text('{"views": [{"position": [3, 2, 4], "focus": [0, 0, 0]}, {"time": 4, "position": [4, 2, 3]}]}')
    for name in ("CornellBox", "box"):
        (folder / f"{name}.xml").write_text(SCENE_OF_PATH)
    (folder / "box.obj").write_text(BOX)
    (folder / "box.mtl").write_text("newmtl lamp\nKe 5 5 5\nnewmtl wall\nKd .8 .8 .8\n")
    for name in ("reference", "mine"):
        run("render", "box.xml", "-o", f"{name}.pfm", "--size", "64x48", "--samples", "16")
    for place in ("submissions", "handed-in", "class"):
        (folder / place / "ada").mkdir(parents=True)
        shutil.copy(folder / "mine.png", folder / place / "ada" / "chess.png")
    (folder / "inis").mkdir()
    (folder / "inis/box.ini").write_text("[IO]\nscene = box.xml\noutput = out/box.png\n[Settings]\nimageWidth = 64\n"
                                         "imageHeight = 48\nsamplesPerPixel = 16\npathContinuationProb = 0.9\n")
    shutil.copy(folder / "mine.pfm", folder / "submissions" / "ada" / "box.pfm")


def is_window(command):
    return re.match(r"scenefile view\b", command) is not None


def run_command(command, template, folder, environment, screen):
    """What is wrong; empty: it ran."""
    line = command
    if is_window(command):
        line = f"{screen} -a {command}" + ("" if "--screenshot" in command else " --screenshot shot.png")
    elif re.search(r"\| (fish|source|man)\b|\| source", command):
        line = command.split("|")[0]
    elif command.startswith("scenefile frames "):
        line = re.sub(r" --video \S+", "" if " -o " in command else " -o frame%04d.png", command) + " --size 32x24"
    line = re.sub(r"--(samples|time) \d+", r"--\1 2", line)  # they only change time and noise
    shutil.copytree(template, folder)
    try:
        run = subprocess.run(["bash", "-c", line], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                             capture_output=True, text=True, timeout=300)
    except subprocess.TimeoutExpired:
        return "it took more than 5 minutes"
    finally:
        shutil.rmtree(folder)
    return "" if run.returncode in (0, 1) else f"status {run.returncode}: {run.stderr.strip()[:300]}"


def run_commands(program):
    screen = shutil.which("xvfb-run")
    unique = {}
    for page, number, command in commands():
        unique.setdefault(command, f"{page}:{number}: {command}")
    shown = [command for command in unique if screen or not is_window(command)]
    with tempfile.TemporaryDirectory() as top:
        top = pathlib.Path(top)
        (top / "bin").mkdir()
        for name in ("scenefile", "projects_ray"):
            (top / "bin" / name).symlink_to(program)
        template = top / "template"
        template.mkdir()
        make_files(template, program)
        environment = dict(os.environ, PATH=f"{top}/bin:{os.environ['PATH']}", HOME=str(top))

        def run(index):
            return run_command(shown[index], template, top / f"work{index}", environment, screen)

        # Windows one after another: two xvfb-run at once may choose the same screen.
        windows = [i for i, command in enumerate(shown) if is_window(command)]
        others = [i for i in range(len(shown)) if i not in windows]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            answers = dict(zip(others, pool.map(run, others)))
        answers |= {i: run(i) for i in windows}
    wrong = [f"{unique[shown[i]]}\n    {answer}" for i, answer in sorted(answers.items()) if answer]
    return wrong, len(shown), len(unique) - len(shown)


def main():
    if sys.argv[1:] == ["links"]:
        wrong, count = dead_links()
        print(*wrong, f"{count} links, {len(wrong)} dead", sep="\n")
        wrong += (long := too_long())
        print(*long, sep="\n", end="\n" if long else "")
    elif len(sys.argv) == 3 and sys.argv[1] == "commands":
        wrong, count, left_out = run_commands(pathlib.Path(sys.argv[2]).resolve())
        print(*wrong, f"{count} commands ran, {len(wrong)} wrong, {left_out} skipped because there is no screen", sep="\n")
    else:
        sys.exit(__doc__)
    return 1 if wrong or count == 0 else 0


sys.exit(main())
