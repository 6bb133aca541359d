"""Blender opens the scenes that `scenefile convert` exports as glTF, and what Blender exports is imported again.

    blender --background --factory-startup --python-exit-code 1 --python blender.py -- PROGRAM FILE|FOLDER...

For each scene:

- shapes and camera: rays of Blender's camera through the centers of pixels hit the same pixels as ours (at most 0.2 %
  differ), at the same depth (median relative error at most 1e-3);
- round trip, XML -> GLB -> Blender -> GLB -> XML: as many objects and lights, the same camera, the same pixels covered;
- scenes lit by directional lights alone: Cycles draws the same picture (at least 38 dB). Ambient
  light, highlights, mirrors and glass are only approximate, which the export reports; a scene that differs more is
  compared again without them.

Pictures are small, because this tests the export, not Blender. Needs Debian's blender and python3-openimageio.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy

numpy.bool = bool  # Blender 3.4's importer uses the old name
import bpy
import OpenImageIO

SIZE = (157, 118)  # such that few centers of pixels are exactly on edges of the scenes
COVERAGE, DEPTH, PSNR = 0.002, 1e-3, 38
MOST_OBJECTS = 3000  # Blender needs minutes for more


def run(*words):
    return subprocess.run([str(word) for word in words], check=True, capture_output=True, text=True).stdout


def read_exr(path):
    """Channels by name, as arrays of rows, top row first."""
    file = OpenImageIO.ImageInput.open(str(path))
    names = file.spec().channelnames
    pixels = file.read_image(OpenImageIO.FLOAT)
    file.close()
    return {name: pixels[:, :, index] for index, name in enumerate(names)}


def our_depth(program, scene, folder):
    run(program, "render", scene, "-o", folder / "depth.exr", "--aov", "depth", "--samples", 1, "--quiet",
        "--size", "%dx%d" % SIZE, "--features", "none", "--allow-missing")
    return read_exr(folder / "depth.exr")["depth.Z"]


def open_glb(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=str(path), convert_lighting_mode="COMPAT")  # "Unitless"
    # Blender 3.4 divides by zero for the tint of some gray highlights, and cannot export the result.
    for material in bpy.data.materials:
        for node in material.node_tree.nodes:
            for value in node.inputs:
                if value.name == "Specular Tint" and value.default_value != value.default_value:
                    value.default_value = 0
    scene = bpy.context.scene
    scene.camera = next(thing for thing in scene.objects if thing.type == "CAMERA")
    scene.render.resolution_x, scene.render.resolution_y = SIZE
    scene.render.resolution_percentage = 100
    return scene


def blender_depth(scene):
    """Distances along the view direction, through the centers of pixels."""
    graph = bpy.context.evaluated_depsgraph_get()
    camera = scene.camera.matrix_world
    corners = scene.camera.data.view_frame(scene=scene)  # top right, bottom right, bottom left, top left
    right, left = corners[0].x, corners[2].x
    top, bottom = corners[0].y, corners[2].y
    plane = -corners[0].z
    turn = camera.to_3x3()
    depth = numpy.full((SIZE[1], SIZE[0]), numpy.inf)
    for row in range(SIZE[1]):
        for column in range(SIZE[0]):
            x = (left + (right - left) * (column + 0.5) / SIZE[0]) / plane
            y = (top + (bottom - top) * (row + 0.5) / SIZE[1]) / plane
            ray = turn @ type(corners[0])((x, y, -1))
            hit, place, *_ = scene.ray_cast(graph, camera.translation, ray)
            if hit:
                depth[row, column] = (place - camera.translation).dot(ray) / ray.dot(ray)
    return depth


def compare_depths(ours, theirs):
    """The share of pixels that only one of them covers, and the median relative error of the others."""
    covered, other = numpy.isfinite(ours), numpy.isfinite(theirs)
    both = covered & other
    error = numpy.abs(theirs[both] - ours[both]) / ours[both]
    return float((covered != other).mean()), float(numpy.median(error)) if both.any() else 0.0


def info(program, scene):
    return json.loads(run(program, "info", "--json", scene))


def angle_between(a, b):
    a, b = (numpy.array(v, float) / numpy.linalg.norm(v) for v in (a, b))
    return float(numpy.linalg.norm(a - b))


def compare_infos(before, after, objects):
    """What did not come back. objects: their number before."""
    wrong = []
    one, other = before["summary"], after["summary"]
    if objects != other["virtual_primitives"]:
        wrong.append(f"{objects:g} objects became {other['virtual_primitives']:g}")
    lights = dict(one["lights"])  # of instances, too
    if sum(lights.values()) and one["virtual_lights"] == sum(lights.values()) and lights != other["lights"]:
        wrong.append(f"lights {lights} became {other['lights']}")
    a, b = before["camera"], after["camera"]
    size = 1 + numpy.linalg.norm(a["position"])
    if numpy.linalg.norm(numpy.subtract(a["position"], b["position"])) > 1e-5 * size:
        wrong.append(f"camera at {a['position']} became {b['position']}")
    if angle_between(a["look"], b["look"]) > 1e-5:
        wrong.append(f"camera to {a['look']} became {b['look']}")
    if abs(a["height_angle_deg"] - b["height_angle_deg"]) > 1e-3:
        wrong.append(f"camera of {a['height_angle_deg']} degrees became {b['height_angle_deg']}")
    return wrong


def draw_with_cycles(scene, folder):
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    lights = sum(thing.type == "LIGHT" for thing in scene.objects)  # each sample follows one of them
    cycles.device, cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising = "CPU", 32 * lights, False, False
    cycles.max_bounces, cycles.diffuse_bounces, cycles.light_sampling_threshold = 16, 0, 0
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1
    scene.world = bpy.data.worlds.new("black")
    scene.world.color = (0, 0, 0)
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.filepath = str(folder / "cycles.exr")
    bpy.ops.render.render(write_still=True)
    return read_exr(folder / "cycles.exr")


def matte(program, path, folder):
    """The same scene without ambient light, highlights, mirrors and glass."""
    run(program, "convert", "--quiet", path, folder / "matte.json")
    scene = json.loads((folder / "matte.json").read_text())
    for name in ("ambientCoeff", "specularCoeff", "transparentCoeff"):
        scene["globalData"][name] = 0
    (folder / "matte.json").write_text(json.dumps(scene))
    return folder / "matte.json"


def psnr(ours, theirs):
    channels = ("R", "G", "B")
    a = numpy.clip(numpy.stack([ours[c] for c in channels]), 0, 1)
    b = numpy.clip(numpy.stack([theirs[c] for c in channels]), 0, 1)
    error = float(((a - b) ** 2).mean())
    return -10 * math.log10(error) if error > 0 else math.inf


def light_quality(program, path, assets, folder):
    """PSNR of Cycles's picture in dB, with ours as the reference. assets: the folder of the scene that this one was made from."""
    roots = ["--asset-root", assets, "--asset-root", assets.parent, "--allow-outside"]
    run(program, "convert", "--quiet", path, folder / "light.glb", *roots)
    theirs = draw_with_cycles(open_glb(folder / "light.glb"), folder)
    run(program, "render", path, "-o", folder / "ours.exr", "--size", "%dx%d" % SIZE, "--quiet", *roots)
    return psnr(read_exr(folder / "ours.exr"), theirs)


def try_scene(program, path, folder):
    """A line of results, and whether they are good."""
    before = info(program, path)
    if before["scene"]["verdict"] == "unusable" or before["scene"]["errors"]:
        return None
    if not 0 < before["summary"]["virtual_primitives"] <= MOST_OBJECTS:
        return None
    run(program, "convert", "--quiet", path, folder / "out.glb")
    scene = open_glb(folder / "out.glb")
    # In glTF, each material of a mesh's faces is an object of its own.
    objects = before["summary"]["virtual_primitives"]
    if before.get("face_materials"):
        objects = sum(thing.type == "MESH" for thing in scene.objects)
    depth = our_depth(program, path, folder)
    missed, error = compare_depths(depth, blender_depth(scene))
    wrong = [] if missed <= COVERAGE and error <= DEPTH else ["shapes"]

    bpy.ops.export_scene.gltf(filepath=str(folder / "back.glb"), export_format="GLB", export_cameras=True, export_lights=True,
                              export_extras=True)
    run(program, "convert", "--quiet", folder / "back.glb", folder / "back.xml")
    wrong += compare_infos(before, info(program, folder / "back.xml"), objects)
    again, error_again = compare_depths(depth, our_depth(program, folder / "back.xml", folder))
    if again > COVERAGE or error_again > DEPTH:
        wrong.append("shapes after the round trip")
    line = f"coverage {missed:.3%}, depth {error:.1e}; back {again:.3%}, {error_again:.1e}"

    lights = before["summary"]["lights"]
    if lights["directional"] and sum(lights.values()) == lights["directional"]:
        quality = light_quality(program, path, path.parent, folder)
        line += f"; Cycles {quality:.1f} dB"
        if quality < PSNR:
            quality = light_quality(program, matte(program, path, folder), path.parent, folder)
            line += f", matte {quality:.1f} dB"
        if quality < PSNR:
            wrong.append("light")
    return line, wrong


def main():
    program, *places = map(pathlib.Path, sys.argv[sys.argv.index("--") + 1:])
    program = program.resolve()
    scenes = [path for place in places for path in ([place] if place.is_file() else sorted(place.rglob("*")))
              if path.suffix in (".xml", ".json")]
    tried = failed = 0
    for path in scenes:
        with tempfile.TemporaryDirectory() as folder:
            # The scene's folder stays where it is: textures are found from there.
            try:
                result = try_scene(program, path.resolve(), pathlib.Path(folder))
            except subprocess.CalledProcessError as error:
                result = ("", [error.stderr.strip()])
            except RuntimeError as error:  # of Blender's operators
                result = ("", [str(error).strip()[-200:]])
        if result is None:
            continue
        line, wrong = result
        tried += 1
        failed += bool(wrong)
        print(f"{path.parent.name}/{path.name}: {line}" + (f"  WRONG: {', '.join(wrong)}" if wrong else ""), flush=True)
    print(f"{tried} scenes in Blender {bpy.app.version_string}, {failed} wrong")
    sys.exit(1 if failed or not tried else 0)


main()
