#!/usr/bin/env python3
"""Creates the pictures of docs/mistakes.md: pictures.py BUILD OUT_FOLDER.

For each cause: the correct picture, and next to it one with a mistake of that kind.
"""
import os, subprocess, sys

HERE = os.path.dirname(os.path.abspath(__file__))
PICTURES = {
    "vertical-flip": ("still-life", "output-upside-down"),
    "horizontal-flip": ("still-life", "output-mirrored"),
    "gamma": ("still-life", "output-gamma"),
    "swapped-channels": ("still-life", "output-bgr"),
    "half-pixel-shift": ("heap", "camera-corners"),
    "ambient": ("mixed", "ambient-missing"),
    "diffuse": ("mixed", "diffuse-missing"),
    "specular": ("mixed", "specular-missing"),
    "blinn": ("mirrors", "specular-blinn"),
    "attenuation": ("many-lights", "attenuation-none"),
    "normals": ("scaled", "normal-by-matrix"),
    "shadows": ("mixed", "shadow-none"),
    "acne": ("mixed", "shadow-acne"),
    "texture": ("textures", "texture-flip-v"),
    "recursion-depth": ("mirrors", "mirror-depth-one"),
    "spot-falloff": ("spots", "spot-no-penumbra"),
    "camera": ("still-life", "camera-aspect-ignored"),
    "transforms": ("robot", "transform-rotation-sign"),
    "shapes": ("still-life", "shape-no-cylinder-caps"),
    "nearest-hit": ("heap", "hit-last"),
    "lights": ("many-lights", "light-only-first"),
    "reflection": ("mirrors", "mirror-color-ignored"),
    "refraction": ("glass", "glass-eta-inverted"),
    "overflow": ("bright", "output-wraps"),
    "background": ("still-life", "output-background"),
    "brightness": ("still-life", "output-half"),
    "black": ("still-life", "output-black"),
    "features": ("still-life", "output-normals"),
    "samples": ("heap", "output-misses-black"),
    "scene-edited": ("still-life", "scene-moved-object"),
}

build, out = sys.argv[1:]
os.makedirs(out, exist_ok=True)
for cause, (scene, mistake) in PICTURES.items():
    subprocess.run([os.path.join(build, "tests/student/scenefile_student"), "--pair",
                    os.path.join(HERE, "scenes", scene + ".xml"), os.path.join(out, cause + ".png"), "144x108", "all",
                    mistake], check=True)
