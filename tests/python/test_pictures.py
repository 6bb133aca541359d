"""Rendering, explaining, comparing and grading."""

import json
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import scenefile


@pytest.mark.parametrize("options", [
    (),
    ("--profile", "course", "--features", "shadows,reflect"),
    ("--samples", "4", "--seed", "7", "--crop", "10,5,50,40"),
    ("--samples", "4", "--min-samples", "4"),
    ("--mode", "normals"),
    ("--features", "intersect"),
    ("--features", "illuminate"),
])
def test_the_bytes_are_the_programs(scenes, tmp_path, program, options):
    theirs, ours = tmp_path / "theirs.png", tmp_path / "ours.png"
    program("render", scenes / "hello.xml", "--size", "64x48", "-o", theirs, *options)
    given = dict(zip(options[::2], options[1::2]))
    keywords = {key[2:].replace("-", "_"): value for key, value in given.items()}
    for key in ("samples", "min_samples", "seed"):
        if key in keywords:
            keywords[key] = int(keywords[key])
    if "crop" in keywords:
        keywords["crop"] = tuple(map(int, keywords["crop"].split(",")))
    picture = scenefile.read(scenes / "hello.xml").render(size=(64, 48), **keywords)
    picture.save(ours)
    assert ours.read_bytes() == theirs.read_bytes()
    assert picture._repr_png_() == theirs.read_bytes()
    assert np.array_equal(scenefile.read_picture(theirs), picture.quantized)


def test_layers_are_the_programs(scenes, tmp_path, program):
    theirs, ours = tmp_path / "theirs.exr", tmp_path / "ours.exr"
    program("render", scenes / "hello.xml", "--size", "48x36", "--aov", "depth,normal,object-id", "-o", theirs)
    picture = scenefile.read(scenes / "hello.xml").render(size=(48, 36), layers=["depth", "normal", "object-id"])
    picture.save(ours)
    assert ours.read_bytes() == theirs.read_bytes()
    assert {name: layer.shape for name, layer in picture.layers.items()} == {
        "depth": (36, 48), "normal": (36, 48, 3), "object-id": (36, 48)}
    picture.save(tmp_path / "ours.png")
    program("render", scenes / "hello.xml", "--size", "48x36", "--aov", "depth,normal,object-id",
            "-o", tmp_path / "theirs.png")
    for name in ("", ".depth", ".normal", ".object-id"):
        assert (tmp_path / f"ours{name}.png").read_bytes() == (tmp_path / f"theirs{name}.png").read_bytes()


def test_pixels_are_floats_that_share_the_pictures_memory(ball):
    picture = scenefile.read(ball).render(size=(32, 24))
    pixels = picture.pixels
    assert pixels.shape == (24, 32, 3) and pixels.dtype == np.float32
    assert pixels.max() > 0.3
    pixels[:] = 0
    assert picture.pixels.max() == 0
    del picture
    assert pixels.max() == 0  # still there


def test_an_edit_changes_the_picture(ball):
    scene = scenefile.read(ball)
    before = scene.render(size=(32, 24)).pixels
    scene.primitives[0].material.diffuse = (0, 0, 1)
    after = scene.render(size=(32, 24)).pixels
    assert before[..., 0].max() > before[..., 2].max()
    assert after[..., 2].max() > after[..., 0].max()


@pytest.mark.parametrize("options, error, words", [
    ({"sizes": (1, 1)}, TypeError, "no option sizes"),
    ({"size": (0, 5)}, ValueError, "size"),
    ({"size": 5}, TypeError, "size"),
    ({"profile": "best"}, ValueError, "not one of course, fine"),
    ({"features": "shadow"}, ValueError, '"shadow" is not one of'),
    ({"layers": ["deep"]}, ValueError, '"deep" is not one of'),
    ({"layers": ["light-9"]}, ValueError, "no light-9"),
    ({"crop": (0, 0, 9999, 1)}, ValueError, "crop"),
    ({"profile": "course", "samples": 4}, ValueError, "profile fine"),
])
def test_options_that_make_no_sense(ball, options, error, words):
    scene = scenefile.read(ball)
    with pytest.raises(error, match=words):
        scene.render(**options)


@pytest.fixture
def box(tmp_path):
    """A closed box of which two triangles shine."""
    (tmp_path / "box.mtl").write_text("newmtl lamp\nKe 6 5 4\nnewmtl wall\nKd .7 .6 .5\nKs .1 .1 .1\nNs 20\nillum 2\n")
    (tmp_path / "box.obj").write_text(
        "mtllib box.mtl\nusemtl wall\n"
        "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
        "f 1 2 3 4\nf 1 5 6 2\nf 1 4 8 5\nf 2 6 7 3\nusemtl lamp\nf 4 3 7 8\n")
    (tmp_path / "box.xml").write_text(
        '<scenefile><cameradata><pos x="0" y="0" z="3"/><focus x="0" y="0" z="0"/><up x="0" y="1" z="0"/>'
        '<heightangle v="45"/></cameradata><object type="tree" name="root"><transblock>'
        '<object type="primitive" name="mesh" filename="box.obj"/></transblock></object></scenefile>')
    return tmp_path / "box.xml"


@pytest.mark.parametrize("keywords, words", [
    ({}, ()),
    ({"samples": 5, "seed": 3, "continuation": 0.7, "clamp": 2.5, "light_samples": 2, "exposure": 1.5},
     ("--mode", "path", "--samples", "5", "--seed", "3", "--continue", "0.7", "--clamp", "2.5", "--light-samples", "2", "--exposure", "1.5")),
    ({"samples": 4, "mis": False, "direct_only": True, "convention": "course", "tone": "none", "denoise": True},
     ("--mode", "path", "--samples", "4", "--no-mis", "--direct-only", "--convention", "course", "--tone", "none", "--denoise")),
    ({"samples": 4, "layers": ["direct", "bounce-1", "variance", "normal"], "crop": (4, 4, 20, 16)},
     ("--mode", "path", "--samples", "4", "--aov", "direct,bounce-1,variance,normal", "--crop", "4,4,20,16")),
])
def test_paths_are_the_programs(box, tmp_path, program, keywords, words):
    picture = scenefile.read(box).render(size=(32, 24), **keywords)
    assert picture.mode == "path" and picture.samples == keywords.get("samples", 64)
    for extension in ("png", "exr"):
        theirs, ours = tmp_path / f"theirs.{extension}", tmp_path / f"ours.{extension}"
        program("render", box, "--size", "32x24", "-o", theirs, *words)
        picture.save(ours)
        for name in ("", *(f".{layer}" for layer in picture.layers if extension == "png")):
            assert (tmp_path / f"ours{name}.{extension}").read_bytes() == (tmp_path / f"theirs{name}.{extension}").read_bytes()
    assert np.array_equal(scenefile.read_picture(tmp_path / "theirs.png"), picture.quantized)
    assert picture.quantized.max() > 100


def test_mode_path_of_a_scene_with_lights(box, ball, tmp_path, program):
    scene = scenefile.read(box)
    scene.root.add_light("point").color = (0.5, 0.5, 0.5)
    assert scene.render(size=(8, 6)).mode == "ray"
    picture = scene.render(size=(32, 24), mode="path", samples=4)
    assert picture.layers == {} and picture.pixels.max() > 1  # the lamp, whose material was read
    scene.save(tmp_path / "lit.xml")
    program("render", tmp_path / "lit.xml", "--mode", "path", "--samples", "4", "--size", "32x24", "-o", tmp_path / "a.pfm")
    picture.save(tmp_path / "b.pfm")
    assert (tmp_path / "a.pfm").read_bytes() == (tmp_path / "b.pfm").read_bytes()
    assert scenefile.read(ball).render(size=(8, 6), mode="path", samples=2).pixels.max() > 0.1


def test_the_mode_is_chosen_as_by_the_program(box):
    scene = scenefile.read(box)
    for options in ({"mode": "ray"}, {"profile": "course"}, {"features": "shadows"}, {"layers": "depth"}):
        assert scene.render(size=(8, 6), **options).mode == options.get("mode", "ray")
    limited = scene.render(size=(8, 6), time=0.05)
    assert 1 <= limited.samples <= 65536
    again = scene.render(size=(8, 6), samples=limited.samples)
    assert np.array_equal(limited.pixels, again.pixels)
    assert scene.render(size=(8, 6), time=30, samples=3).samples == 3


def test_a_path_is_explained(box, program):
    explanation = scenefile.read(box).explain(16, 12, size=(32, 24), samples=8)
    text = program("explain", box, "--pixel", "16,12", "--size", "32x24", "--samples", "8")
    assert explanation.text.strip() == text.strip()
    assert explanation.data["mode"] == "path" and explanation.data["samples"] == 8


def test_face_materials(box):
    scene = scenefile.read(box)
    materials = scene.face_materials["box.obj"]
    assert [(m.name, m.triangles) for m in materials] == [("wall", 8), ("lamp", 2)]
    assert materials[0].diffuse == (0.7, 0.6, 0.5) and materials[1].emission == (6, 5, 4)
    assert (materials[0].shininess, materials[0].illum, materials[1].ior) == (20, 2, 1)
    scene.root.add_light("point")
    assert len(scene.face_materials["box.obj"]) == 2


@pytest.mark.parametrize("options, words", [
    ({"layers": "direct"}, "layer of path tracing"),
    ({"mode": "ray", "layers": ["bounce-1"]}, "layer of path tracing"),
    ({"mode": "path", "layers": "depth"}, "mode path has no depth"),
    ({"clamp": 2}, "clamp is for path tracing"),
    ({"tone": "none"}, "tone is for path tracing"),
    ({"mode": "path", "tone": "film"}, "not one of course, none"),
    ({"mode": "path", "features": "shadows"}, "features has no effect in mode path"),
    ({"mode": "path", "fresnel": True}, "fresnel has no effect"),
    ({"mode": "path", "profile": "course"}, "mode: path is for the profile fine"),
    ({"mode": "path", "continuation": 2}, "not between 0.01 and 0.99"),
    ({"mode": "path", "exposure": float("nan")}, "exposure"),
    ({"mode": "path", "time": 0}, "time"),
    ({"mode": "path", "light_samples": -1}, "light_samples"),
    ({"mode": "path", "convention": "art"}, "not one of physics, course"),
])
def test_options_of_paths_that_make_no_sense(ball, options, words):
    with pytest.raises(ValueError, match=words):
        scenefile.read(ball).render(**options)
    with pytest.raises(ValueError, match="mode: path is for render and explain"):
        scenefile.compare(np.zeros((4, 4, 3)), np.zeros((4, 4, 3)), ball, mode="path")


def test_progress_is_told_and_stops(scenes):
    scene = scenefile.read(scenes / "showcase.xml")
    told = []
    scene.render(size=(160, 120), samples=2, progress=told.append)
    assert told == sorted(told) and told[-1] == 1

    def stop(done):
        raise RuntimeError("enough")

    start = time.monotonic()
    with pytest.raises(RuntimeError, match="enough"):
        scene.render(size=(2000, 1500), progress=stop)
    assert time.monotonic() - start < 20


def test_ctrl_c_stops(scenes):
    code = ("import scenefile, sys\n"
            f"scene = scenefile.read({str(scenes / 'showcase.xml')!r})\n"
            "try:\n"
            "    print('ready', flush=True)\n"
            "    scene.render(size=(4000, 3000), samples=64)\n"
            "except KeyboardInterrupt:\n"
            "    print('stopped')\n")
    child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True, env=os.environ)
    assert child.stdout.readline() == "ready\n"
    time.sleep(0.5)
    child.send_signal(signal.SIGINT)
    out, _ = child.communicate(timeout=60)
    assert out == "stopped\n"


def test_a_daemon_thread_that_draws_does_not_keep_python_from_ending(scenes):
    code = ("import scenefile, threading, time\n"
            f"scene = scenefile.read({str(scenes / 'showcase.xml')!r})\n"
            "threading.Thread(target=scene.render, kwargs={'size': (4000, 3000), 'samples': 64}, daemon=True).start()\n"
            "time.sleep(0.3)\n")
    subprocess.run([sys.executable, "-c", code], check=True, env=os.environ, timeout=60)


def test_other_threads_run_meanwhile(scenes):
    scene = scenefile.read(scenes / "showcase.xml")
    counted = 0
    done = threading.Event()

    def count():
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    scene.render(size=(160, 120), samples=2)
    done.set()
    thread.join()
    assert counted > 10


def test_threads_render_the_same_scene(ball):
    scene = scenefile.read(ball)
    expected = scene.render(size=(40, 30)).pixels.copy()
    pictures = []
    threads = [threading.Thread(target=lambda: pictures.append(scene.render(size=(40, 30)))) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(pictures) == 4
    assert all(np.array_equal(p.pixels, expected) for p in pictures)


def test_explain_says_what_the_program_says(scenes, program):
    explanation = scenefile.read(scenes / "hello.xml").explain(32, 24, size=(64, 48), profile="course")
    theirs = program("explain", scenes / "hello.xml", "--pixel", "32,24", "--size", "64x48", "--profile", "course")
    assert explanation.text.strip() in theirs
    assert explanation.data == json.loads(program("explain", scenes / "hello.xml", "--pixel", "32,24", "--size", "64x48",
                                                  "--profile", "course", "--json"))


def test_compare_names_the_mistake(ball):
    reference = scenefile.read(ball).render(size=(96, 72), profile="course")
    assert scenefile.compare(reference, reference).same
    upside_down = reference.quantized[::-1]
    comparison = scenefile.compare(reference, upside_down, ball)
    assert not comparison.same
    assert [cause.name for cause in comparison.causes] == ["vertical-flip"]
    assert "upside down" in str(comparison)
    assert comparison.heat_map.shape == (72, 96, 3)
    assert comparison.flip_map.shape == (72, 96)
    assert comparison._repr_png_().startswith(b"\x89PNG")
    as_floats = scenefile.compare(reference, upside_down / np.float32(255), ball)
    assert as_floats.psnr_db == comparison.psnr_db
    assert scenefile.compare(reference, upside_down, min_psnr=1).same
    assert not scenefile.compare(reference, upside_down, max_share=0.02).same
    with pytest.raises(ValueError, match="0.02 is 2 %"):
        scenefile.compare(reference, upside_down, max_share=2)


def test_compare_finds_the_scene_in_a_screenshot(scenes):
    reference = scenefile.read(scenes / "hello.xml").render(size=(320, 240), profile="course")
    screenshot = np.full((300, 360, 3), 200, np.uint8)
    screenshot[40:280, 20:340] = reference.quantized
    comparison = scenefile.compare(reference, screenshot, scenes / "hello.xml")
    assert comparison.place == (20, 40, 320, 240)
    assert comparison.notes == comparison.causes == ()
    assert scenefile.compare(reference, reference).place is None


def test_compare_refuses_what_is_no_picture(ball):
    with pytest.raises(TypeError):
        scenefile.compare(3, ball)
    with pytest.raises(ValueError, match="height x width"):
        scenefile.compare(np.zeros((2, 2, 2), np.uint8), np.zeros((2, 2, 2), np.uint8))
    with pytest.raises(ValueError, match="is a scene, not a picture"):
        scenefile.compare(ball, ball)


def test_grade(ball, tmp_path, program):
    scene = scenefile.read(ball)
    (tmp_path / "right").mkdir()
    right = scene.render(size=(96, 72), profile="course")
    right.save(tmp_path / "right" / "ball.png")
    (tmp_path / "scenes").mkdir()
    (tmp_path / "scenes" / "ball.xml").write_bytes(ball.read_bytes())
    for student in ("ada", "bob", "eve"):
        (tmp_path / "class" / student).mkdir(parents=True)
    right.save(tmp_path / "class" / "ada" / "ball.png")
    scene.globals.ambient = 0
    scene.render(size=(96, 72), profile="course").save(tmp_path / "class" / "bob" / "ball.png")
    book = scenefile.grade(tmp_path / "class", tmp_path / "right", tmp_path / "scenes")
    assert book.notes == ()
    assert [(s.name, s.passed) for s in book.students] == [("ada", 1), ("bob", 0), ("eve", 0)]
    assert [s.pictures[0].verdict for s in book.students] == ["passed", "differs", "missing"]
    assert "ambient" in [c.name for c in book.students[1].pictures[0].causes]
    assert not book.passed
    assert book.data["students"][0]["name"] == "ada"
    assert book.html("Class").startswith("<!")
    text = program("grade", tmp_path / "class", "--references", tmp_path / "right", "--scenes",
                   tmp_path / "scenes", status=1)
    assert str(book) == text
    with pytest.raises(OSError, match="not a readable folder"):
        scenefile.grade(tmp_path / "class", tmp_path / "nothing")


def test_notebooks(ball):
    assert scenefile.read(ball)._repr_png_().startswith(b"\x89PNG")


def test_a_thousand_renders_leave_nothing_behind(ball):
    code = ("import scenefile\n"
            f"scene = scenefile.read({str(ball)!r})\n"
            "def memory():\n"
            "    return int(open('/proc/self/statm').read().split()[1]) * 4096\n"
            "def some(count):\n"
            "    for i in range(count):\n"
            "        scene.camera.position += (0, 1e-5, 0)\n"
            "        scene.render(size=(16, 12), samples=1, threads=2).pixels.sum()\n"
            "some(200)\n"
            "before = memory()\n"
            "some(1000)\n"
            "print(memory() - before)\n")
    environment = dict(os.environ, MALLOC_ARENA_MAX="2")
    grown = int(subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True,
                               env=environment).stdout)
    assert grown < 2_000_000, f"{grown} bytes in 1,000 renders"


def test_import_is_light():
    code = ("import sys\n"
            "before = set(sys.modules)\n"
            "import scenefile\n"
            "print(*(set(sys.modules) - before))\n")
    loaded = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout.split()
    assert "numpy" not in loaded
    assert len(loaded) <= 8, loaded
