"""Values and the exception, which are simpler in Python than in C++. The extension module imports this file."""

from __future__ import annotations


class Vec3(tuple):
    """Three numbers: a point, a direction or a color. A tuple that can be added and scaled.

    It cannot be changed in place; assign a new one: ``camera.position += (0, 2, 0)``.
    """

    __slots__ = ()

    def __new__(cls, x, y, z):
        return tuple.__new__(cls, (float(x), float(y), float(z)))

    @property
    def x(self):
        return self[0]

    @property
    def y(self):
        return self[1]

    @property
    def z(self):
        return self[2]

    def __getnewargs__(self):
        return tuple(self)

    def __add__(self, other):
        x, y, z = other
        return Vec3(self[0] + x, self[1] + y, self[2] + z)

    __radd__ = __add__

    def __sub__(self, other):
        x, y, z = other
        return Vec3(self[0] - x, self[1] - y, self[2] - z)

    def __rsub__(self, other):
        x, y, z = other
        return Vec3(x - self[0], y - self[1], z - self[2])

    def __mul__(self, factor):
        return Vec3(self[0] * factor, self[1] * factor, self[2] * factor)

    __rmul__ = __mul__

    def __truediv__(self, divisor):
        return Vec3(self[0] / divisor, self[1] / divisor, self[2] / divisor)

    def __neg__(self):
        return Vec3(-self[0], -self[1], -self[2])

    def __repr__(self):
        return "Vec3({:g}, {:g}, {:g})".format(*self)


class SceneError(ValueError):
    """A scene cannot be used. The text is what ``scenefile check`` prints; `diagnostics` are the findings."""

    def __init__(self, text, diagnostics=()):
        super().__init__(text)
        self.diagnostics = tuple(diagnostics)
