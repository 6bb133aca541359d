"""Draws a scene of the assignment Path with Blender's Cycles; bench/path runs it inside Blender:

    blender --background --factory-startup --python path_cycles.py -- JOB.json

JOB.json: the scene as triangles with materials (see bench/path), the camera, the size, and a list of pictures with
their number of samples and seed. Each becomes a file of linear floats, RGB from the bottom up, and a CPU time. Cycles is
set up to compute the same integral: box filter, nothing clamped, all bounces, no adaptive sampling.
"""
import json
import sys
import time

import bpy
import numpy

job = json.load(open(sys.argv[sys.argv.index("--") + 1]))
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene


def material_of(words):
    material = bpy.data.materials.new(words["name"])
    material.use_nodes = True
    nodes, link = material.node_tree.nodes, material.node_tree.links.new
    nodes.clear()
    output = nodes.new("ShaderNodeOutputMaterial")
    kind = words["kind"]
    surface = nodes.new({"diffuse": "ShaderNodeBsdfDiffuse", "mirror": "ShaderNodeBsdfGlossy",
                         "glass": "ShaderNodeBsdfGlass"}[kind])
    surface.inputs["Color"].default_value = (*words["color"], 1)
    if kind != "diffuse":
        surface.distribution = "SHARP"
        surface.inputs["Roughness"].default_value = 0
    if kind == "glass":
        surface.inputs["IOR"].default_value = words["ior"]
    last = surface.outputs[0]
    if any(words["emission"]):
        # Light leaves the front of a face only.
        emission, side, both = (nodes.new("ShaderNode" + name) for name in ("Emission", "NewGeometry", "AddShader"))
        dark, front = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeMixShader")
        emission.inputs["Color"].default_value = (*words["emission"], 1)
        emission.inputs["Strength"].default_value = 1
        dark.inputs["Strength"].default_value = 0
        link(side.outputs["Backfacing"], front.inputs[0])
        link(emission.outputs[0], front.inputs[1])
        link(dark.outputs[0], front.inputs[2])
        link(last, both.inputs[0])
        link(front.outputs[0], both.inputs[1])
        last = both.outputs[0]
    link(last, output.inputs["Surface"])
    return material


points = numpy.fromfile(job["points"], "<f4").reshape(-1, 3)
normals = numpy.fromfile(job["normals"], "<f4").reshape(-1, 3)  # of corners; zero: of the triangle
kinds = numpy.fromfile(job["kinds"], "<i4")
mesh = bpy.data.meshes.new("scene")
mesh.from_pydata(points.tolist(), [], numpy.arange(len(points)).reshape(-1, 3).tolist())
for words in job["materials"]:
    mesh.materials.append(material_of(words))
mesh.polygons.foreach_set("material_index", kinds)
if normals.any():
    mesh.polygons.foreach_set("use_smooth", normals.reshape(-1, 9).any(axis=1))
    mesh.use_auto_smooth = True
    mesh.normals_split_custom_set(normals.tolist())
mesh.update()
scene.collection.objects.link(bpy.data.objects.new("scene", mesh))

camera = bpy.data.cameras.new("camera")
camera.sensor_fit = "VERTICAL"
camera.angle = job["height_angle"]
camera.clip_start = 1e-3
eye = bpy.data.objects.new("camera", camera)
right, up, back = (numpy.array(job[name]) for name in ("right", "up", "back"))
eye.matrix_world = numpy.vstack([numpy.column_stack([right, up, back, job["position"]]), [0, 0, 0, 1]]).T.tolist()
scene.collection.objects.link(eye)
scene.camera = eye

world = bpy.data.worlds.new("world")
world.use_nodes = True
world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0
scene.world = world

render, cycles = scene.render, scene.cycles
render.engine = "CYCLES"
render.threads_mode, render.threads = "FIXED", 1
render.resolution_x, render.resolution_y, render.resolution_percentage = job["width"], job["height"], 100
render.image_settings.file_format = "OPEN_EXR"
render.image_settings.color_depth = "32"
render.image_settings.color_mode = "RGB"
render.use_compositing = render.use_sequencer = False
cycles.device = "CPU"
cycles.use_adaptive_sampling = cycles.use_denoising = False
cycles.pixel_filter_type = "BOX"
cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
cycles.blur_glossy = 0
cycles.light_sampling_threshold = 0
cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = 1024
cycles.caustics_reflective = cycles.caustics_refractive = True

answers = []
for picture in [{"samples": 1, "seed": 0, "file": job["pictures"][0]["file"]}, *job["pictures"]]:  # the first one warms up
    cycles.samples, cycles.seed = picture["samples"], picture["seed"]
    render.filepath = picture["file"] + ".exr"
    start = time.process_time()
    bpy.ops.render.render(write_still=True)
    answers.append(time.process_time() - start)
    image = bpy.data.images.load(render.filepath)
    image.colorspace_settings.name = "Linear"
    pixels = numpy.empty(4 * job["width"] * job["height"], "<f4")
    image.pixels.foreach_get(pixels)
    pixels.reshape(-1, 4)[:, :3].astype("<f4").tofile(picture["file"])
    bpy.data.images.remove(image)
json.dump(answers[1:], open(job["answer"], "w"))
