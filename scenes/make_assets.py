#!/usr/bin/env python3
"""Makes the images and the meshes that the example scenes use. Needs numpy and Pillow."""
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


class FlatMesh:
    """An OBJ of polygons without normals. Corners are counterclockwise where the face is seen."""

    def __init__(self, library):
        self.lines = ['mtllib ' + library]
        self.vertices = 0

    def polygon(self, material, corners, uvs=None):
        self.lines.append('usemtl ' + material)
        self.lines += ['v %.4g %.4g %.4g' % tuple(corner) for corner in corners]
        self.lines += ['vt %.4g %.4g' % tuple(uv) for uv in uvs or []]
        index = '-%d/-%d' if uvs else '-%d'
        self.lines.append('f ' + ' '.join(index % ((n,) * index.count('%d'))
                                          for n in range(len(corners), 0, -1)))

    def box(self, material, low, high, turn=0, uv=None):
        """Turned around its vertical axis by degrees. `uv`: units of length of the texture."""
        low, high = np.asarray(low, float), np.asarray(high, float)
        middle = (low + high) / 2
        c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
        for axis in range(3):
            a, b = (axis + 1) % 3, (axis + 2) % 3
            for end in (low, high):
                ring = []
                for first, second in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    corner = end.copy()
                    corner[a] = (low, high)[first][a]
                    corner[b] = (low, high)[second][b]
                    ring.append(corner)
                if end is low:
                    ring.reverse()
                uvs = [(p[a] / uv, p[b] / uv) for p in ring] if uv else None
                ring = [middle + (c * x + s * z, y, c * z - s * x) for x, y, z in
                        (p - middle for p in ring)]
                self.polygon(material, ring, uvs)

    def prism(self, material, center, radius, height, sides, ends=None):
        """Upright, `center` is in the middle. `ends`: material of its top and bottom."""
        center = np.asarray(center, float)
        ring = [(radius * math.cos(a), 0, -radius * math.sin(a))
                for a in np.arange(sides) * 2 * math.pi / sides]
        low, high = center - (0, height / 2, 0), center + (0, height / 2, 0)
        for i in range(sides):
            p, q = np.asarray(ring[i]), np.asarray(ring[(i + 1) % sides])
            self.polygon(material, [low + p, low + q, high + q, high + p])
        self.polygon(ends or material, [high + p for p in ring])
        self.polygon(ends or material, [low + p for p in reversed(ring)])

    def save(self, path):
        with open(path, 'w', encoding='ascii') as out:
            out.write('\n'.join(self.lines) + '\n')


def studio(path):
    """A room, 5.2 wide, 3 high and 6.6 deep, with two lamps, a mirror and what stands in it."""
    mesh = FlatMesh('studio.mtl')
    left, right, top, back, front = -2.6, 2.6, 3, -2.2, 4.4
    corners = {(x, y, z): (xs, ys, zs) for x, xs in ((0, left), (1, right))
               for y, ys in ((0, 0), (1, top)) for z, zs in ((0, back), (1, front))}

    def wall(material, names, uvs=None):
        mesh.polygon(material, [corners[tuple(int(n) for n in name)] for name in names.split()], uvs)

    width, depth = right - left, front - back
    wall('tiles', '001 101 100 000', [(0, 0), (width / 1.3, 0), (width / 1.3, depth / 1.3), (0, depth / 1.3)])
    wall('plaster', '010 110 111 011')
    wall('plaster', '000 100 110 010')
    wall('plaster', '101 001 011 111')
    wall('teal', '001 000 010 011')
    wall('coral', '100 101 111 110')

    mesh.polygon('skylight', [(-1.3, 2.995, 0.6), (-1.3, 2.995, -0.3), (0.9, 2.995, -0.3), (0.9, 2.995, 0.6)])
    mesh.prism('lantern', (-2.05, 0.42, -1.5), 0.2, 0.5, 8, 'walnut')
    mesh.prism('walnut', (-2.05, 0.085, -1.5), 0.24, 0.17, 8)
    mesh.prism('walnut', (-2.05, 0.69, -1.5), 0.24, 0.04, 8)

    # The mirror leans against the back wall.
    foot, lean = -1.72, 0.36
    for material, x0, x1, y0, y1, gap in (('walnut', 0.1, 1.86, 0, 2.28, 0), ('mirror', 0.17, 1.79, 0.07, 2.21, 0.02)):
        mesh.polygon(material, [(x, y, foot - lean * y / 2.28 + gap)
                                for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))])

    mesh.box('stone', (-1.25, 0, -0.95), (-0.35, 0.8, -0.05), turn=24, uv=1.2)
    mesh.box('walnut', (1.25, 0, -0.75), (2.05, 0.42, 0.05), turn=-18)
    mesh.save(path)


if __name__ == '__main__':
    save('marble.png', marble())
    save('floor.png', floor())
    save('planet.png', planet())
    save('bricks.png', bricks())
    knot(os.path.join(HERE, 'mesh', 'knot.obj'))
    studio(os.path.join(HERE, 'mesh', 'studio.obj'))
