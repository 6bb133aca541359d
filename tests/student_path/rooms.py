"""Makes rooms for path tracers: write(folder, kind, seed) returns the path of the scene.

Sizes, places and colors depend on the seed. Kinds: box, glossy, mirror, glass, lamps, mixed.
"""
import math, os, random

KINDS = ["box", "glossy", "mirror", "glass", "lamps", "mixed"]


class Model:
    def __init__(self):
        self.v, self.n, self.lines = [], [], []

    def use(self, material):
        self.lines.append("usemtl " + material)

    def quad(self, a, u, w):  # the front is that of u x w
        first = len(self.v) + 1
        b, d = [p + q for p, q in zip(a, u)], [p + q for p, q in zip(a, w)]
        c = [p + q for p, q in zip(b, w)]
        self.v += [a, b, c, d]
        self.lines += [f"f {first} {first + 1} {first + 2}", f"f {first} {first + 2} {first + 3}"]

    def box(self, center, half, height, angle):
        c, s = math.cos(angle) * half, math.sin(angle) * half
        x, y, z = center
        corner = lambda i, j, h: [x + i * c - j * s, y + h, z + i * s + j * c]
        floor = [corner(1, 1, 0), corner(-1, 1, 0), corner(-1, -1, 0), corner(1, -1, 0)]
        for i in range(4):
            p, q = floor[i], floor[(i + 1) % 4]
            self.quad(p, [0, height, 0], [b - a for a, b in zip(p, q)])
        top = [corner(-1, -1, height), corner(-1, 1, height), corner(1, 1, height), corner(1, -1, height)]
        self.quad(top[0], [b - a for a, b in zip(top[0], top[1])], [b - a for a, b in zip(top[0], top[3])])

    def sphere(self, center, radius, smooth=True):
        rings, around = 16, 32
        first, normal = len(self.v), len(self.n)
        for i in range(rings + 1):
            for j in range(around):
                t, p = math.pi * i / rings, 2 * math.pi * j / around
                d = [math.sin(t) * math.cos(p), math.cos(t), math.sin(t) * math.sin(p)]
                self.v.append([c + radius * e for c, e in zip(center, d)])
                self.n.append(d)
        index = lambda i, j: i * around + j % around
        corner = lambda k: f"{first + k + 1}//{normal + k + 1}" if smooth else str(first + k + 1)
        for i in range(rings):
            for j in range(around):
                a, b, c, d = index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)
                if i > 0:
                    self.lines.append(f"f {corner(a)} {corner(d)} {corner(c)}")
                if i < rings - 1:
                    self.lines.append(f"f {corner(a)} {corner(c)} {corner(b)}")


def write(folder, kind, seed):
    r = random.Random(f"{kind} {seed}")
    u = r.uniform
    os.makedirs(folder, exist_ok=True)
    name = f"{kind}-{seed}"
    gray = u(0.55, 0.75)
    size = u(0.8, 1.25)
    materials = {
        "white": f"Kd {gray} {gray * u(.95, 1):.4} {gray * u(.9, 1):.4}\nillum 2",
        "left": f"Kd {u(.5, .7):.4} {u(.05, .2):.4} {u(.05, .15):.4}\nillum 2",
        "right": f"Kd {u(.08, .2):.4} {u(.35, .55):.4} {u(.08, .2):.4}\nillum 2",
        "lamp": f"Kd 0 0 0\nKe {u(10, 22):.4} {u(9, 18):.4} {u(6, 14):.4}\nillum 2",
        "lamp2": f"Kd 0 0 0\nKe {u(5, 9):.4} {u(7, 14):.4} {u(12, 20):.4}\nillum 2",
        "object": f"Kd {u(.3, .7):.4} {u(.3, .7):.4} {u(.3, .7):.4}\nillum 2",
        "glossy": f"Kd {u(.15, .3):.4} {u(.15, .3):.4} {u(.1, .3):.4}\nKs {u(.35, .55):.4} {u(.35, .55):.4} {u(.3, .5):.4}\n"
                  f"Ns {u(8, 40):.4}\nillum 2",
        "mirror": f"Kd 0 0 0\nKs {u(.7, .9):.4} {u(.7, .9):.4} {u(.65, .9):.4}\nillum 5",
        "glass": f"Kd 0 0 0\nKs 1 1 1\nNi {u(1.4, 1.6):.4}\nillum 7",
    }
    with open(f"{folder}/{name}.mtl", "w") as f:
        for key, text in materials.items():
            f.write(f"newmtl {key}\n{text}\n\n")
    m = Model()
    w, h, d = size, size * u(.85, 1.1), size * u(.9, 1.2)  # half width, half height, half depth
    m.use("white")
    m.quad([-w, -h, -d], [0, 0, 2 * d], [2 * w, 0, 0])  # floor
    m.quad([-w, h, -d], [2 * w, 0, 0], [0, 0, 2 * d])  # ceiling
    m.quad([-w, -h, -d], [2 * w, 0, 0], [0, 2 * h, 0])  # back
    m.use("left")
    m.quad([-w, -h, -d], [0, 2 * h, 0], [0, 0, 2 * d])
    m.use("right")
    m.quad([w, -h, -d], [0, 0, 2 * d], [0, 2 * h, 0])
    s, t = u(.18, .3) * size, u(.15, .3) * size
    x = u(-.15, .15)
    m.use("lamp")
    m.quad([x - s, h - 0.02, -t], [2 * s, 0, 0], [0, 0, 2 * t])
    if kind == "lamps":
        m.use("lamp2")
        y = -h + u(.5, .9) * h
        m.quad([w - .02, y, -.5 * d], [0, 0, u(.2, .4)], [0, u(.2, .4), 0])
    first = {"box": "object", "lamps": "object"}.get(kind, kind if kind != "mixed" else "mirror")
    m.use(first)
    a = u(.25, .33) * size
    m.box([-.42 * w, -h, -.3 * d], a, u(.9, 1.2) * h, u(.1, .5))
    second = {"box": "white", "lamps": "glossy", "mixed": "glass"}.get(kind, kind)
    m.use(second)
    radius = u(.28, .36) * size
    m.sphere([.42 * w, -h + radius + .01, .2 * d], radius)
    if kind == "mixed":
        m.use("glossy")
        m.sphere([-.1 * w, -h + .6 * radius, .6 * d], .6 * radius)
    with open(f"{folder}/{name}.obj", "w") as f:
        f.write(f"mtllib {name}.mtl\n")
        f.writelines("v {:.6f} {:.6f} {:.6f}\n".format(*v) for v in m.v)
        f.writelines("vn {:.6f} {:.6f} {:.6f}\n".format(*n) for n in m.n)
        f.write("\n".join(m.lines) + "\n")
    path = f"{folder}/{name}.xml"
    with open(path, "w") as f:
        f.write(f"""<scenefile>
  <globaldata><ambientcoeff v="1"/><diffusecoeff v="1"/><specularcoeff v="1"/></globaldata>
  <cameradata>
    <pos x="{u(-.1, .1):.4}" y="{u(-.05, .15):.4}" z="{d + u(2.2, 2.8) * size:.4}"/>
    <look x="0" y="0" z="-1"/>
    <up x="0" y="1" z="0"/>
    <heightangle v="{u(36, 44):.4}"/>
  </cameradata>
  <object type="tree" name="root">
    <transblock><object type="primitive" name="mesh" filename="{name}.obj"/></transblock>
  </object>
</scenefile>
""")
    return path


if __name__ == "__main__":
    import sys
    for kind in KINDS:
        print(write(sys.argv[1], kind, int(sys.argv[2]) if len(sys.argv) > 2 else 1))
