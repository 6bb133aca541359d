#!/usr/bin/env python3
"""Makes the images and the mesh that the example scenes use. Needs numpy and Pillow."""
import math
import os

import numpy as np
from PIL import Image

HERE = os.path.dirname(os.path.abspath(__file__))


def tileable_noise(height, width, cells, seed):
    """Smooth value noise in [0, 1] that repeats at the edges."""
    grid = np.random.default_rng(seed).random((cells, 2 * cells if width > height else cells))
    y = np.arange(height) * grid.shape[0] / height
    x = np.arange(width) * grid.shape[1] / width
    y0, x0 = y.astype(int), x.astype(int)
    ty, tx = [t * t * (3 - 2 * t) for t in (y - y0, x - x0)]
    y1, x1 = (y0 + 1) % grid.shape[0], (x0 + 1) % grid.shape[1]
    top = grid[np.ix_(y0, x0)] * (1 - tx) + grid[np.ix_(y0, x1)] * tx
    bottom = grid[np.ix_(y1, x0)] * (1 - tx) + grid[np.ix_(y1, x1)] * tx
    return top * (1 - ty[:, None]) + bottom * ty[:, None]


def fractal(height, width, cells, octaves, seed):
    layers = [tileable_noise(height, width, cells << i, seed + i) / 2**i for i in range(octaves)]
    total = sum(layers)
    return (total - total.min()) / (total.max() - total.min())


def mix(a, b, t):
    return np.asarray(a) * (1 - t[..., None]) + np.asarray(b) * t[..., None]


def save(name, picture):
    Image.fromarray(np.clip(picture, 0, 255).astype(np.uint8)).save(
        os.path.join(HERE, 'image', name), optimize=True)


def marble(size=256):
    x = np.arange(size) / size
    veins = 0.5 + 0.5 * np.sin(2 * math.pi * (2 * x[None, :] + 1.4 * fractal(size, size, 4, 5, 1)))
    return mix((250, 246, 238), (150, 142, 140), veins**6)


def floor(size=512):
    """Two by two tiles, light and dark, with joints."""
    grain = fractal(size, size, 8, 5, 7)
    y, x = np.mgrid[0:size, 0:size]
    half = size // 2
    dark = ((x // half + y // half) % 2).astype(bool)
    tiles = np.where(dark[..., None], mix((58, 66, 84), (84, 92, 112), grain),
                     mix((214, 204, 188), (236, 228, 214), grain))
    joint = (np.minimum(x % half, half - x % half) < 3) | (np.minimum(y % half, half - y % half) < 3)
    tiles[joint] = (96, 90, 84)
    return tiles


def planet(height=256, width=512):
    land = fractal(height, width, 3, 6, 21)
    latitude = np.abs(np.linspace(-1, 1, height))[:, None] * np.ones((1, width))
    picture = mix((18, 52, 120), (44, 112, 176), np.clip(land * 2, 0, 1))
    ground = mix((54, 112, 52), (178, 150, 96), np.clip((land - 0.52) * 5, 0, 1))
    picture = np.where((land > 0.52)[..., None], ground, picture)
    ice = np.clip((latitude + 0.25 * (land - 0.5) - 0.82) * 14, 0, 1)
    return mix(picture, (246, 250, 252), ice)


def bricks(size=256):
    """Heights: 255 is the face of a brick, 0 the bottom of a joint."""
    y, x = np.mgrid[0:size, 0:size]
    row, course = size // 8, y // (size // 8)
    column = (x + (course % 2) * size // 8) % (size // 4)
    edge = np.minimum.reduce([y % row, row - 1 - y % row, column, size // 4 - 1 - column])
    return np.clip(edge / 4.0, 0, 1) * 225 + 30 * fractal(size, size, 16, 3, 5)


def knot(path, around=144, across=16, p=2, q=3, tube=0.13):
    """A torus knot as an OBJ with normals and uvs, about one unit across."""
    def center(t):
        r = 0.36 + 0.13 * math.cos(q * t)
        return np.array([r * math.cos(p * t), 0.13 * math.sin(q * t) * 1.5, r * math.sin(p * t)])

    with open(path, 'w', encoding='ascii') as out:
        out.write('# A torus knot\n')
        for i in range(around):
            t = 2 * math.pi * i / around
            here = center(t)
            ahead = center(t + 1e-4) - center(t - 1e-4)
            ahead /= np.linalg.norm(ahead)
            side = np.cross(ahead, (0, 1, 0))
            side /= np.linalg.norm(side)
            above = np.cross(side, ahead)
            for j in range(across):
                a = 2 * math.pi * j / across
                normal = math.cos(a) * side + math.sin(a) * above
                point = here + tube * 0.75 * normal
                out.write('v %.5f %.5f %.5f\n' % tuple(point))
                out.write('vn %.4f %.4f %.4f\n' % tuple(normal))
        for i in range(around + 1):
            for j in range(across + 1):
                out.write('vt %.5f %.5f\n' % (i / around, j / across))
        for i in range(around):
            for j in range(across):
                corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                text = []
                for a, b in corners:
                    vertex = (a % around) * across + b % across + 1
                    text.append('%d/%d/%d' % (vertex, a * (across + 1) + b + 1, vertex))
                out.write('f %s\n' % ' '.join(text))


if __name__ == '__main__':
    save('marble.png', marble())
    save('floor.png', floor())
    save('planet.png', planet())
    save('bricks.png', bricks())
    knot(os.path.join(HERE, 'mesh', 'knot.obj'))
