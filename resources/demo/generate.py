#!/usr/bin/env python3
"""Makes the models and textures of the demo scene. Needs nothing but Python; the same files come out every time."""

import math
import random
import struct
import zlib
from pathlib import Path

FOLDER = Path(__file__).resolve().parent


def write_png(name, size, pixel):
    """`pixel(x, y)` gives red, green and blue from 0 to 255."""
    rows = bytearray()
    for y in range(size):
        rows.append(0)
        for x in range(size):
            rows.extend(max(0, min(255, round(c))) for c in pixel(x, y))

    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    header = struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0)
    (FOLDER / name).write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
                                + chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))


class Noise:
    """Smooth noise that repeats after `period` cells in both directions."""

    def __init__(self, period, seed):
        source = random.Random(seed)
        self.period = period
        self.cells = [[source.random() for _ in range(period)] for _ in range(period)]

    def __call__(self, x, y):
        ix, iy = math.floor(x), math.floor(y)
        fx, fy = x - ix, y - iy
        fx, fy = fx * fx * (3 - 2 * fx), fy * fy * (3 - 2 * fy)
        n = self.period
        a, b = self.cells[iy % n], self.cells[(iy + 1) % n]
        top = a[ix % n] * (1 - fx) + a[(ix + 1) % n] * fx
        bottom = b[ix % n] * (1 - fx) + b[(ix + 1) % n] * fx
        return top * (1 - fy) + bottom * fy


class Model:
    def __init__(self, name, comment):
        self.name = name
        self.lines = [f"# {comment}", f"mtllib {name}.mtl"]
        self.materials = []
        self.count = 0

    def material(self, name, *lines):
        self.materials.append("\n".join([f"newmtl {name}", *lines]))
        self.lines.append(f"usemtl {name}")

    def vertex(self, position, normal=None, uv=None):
        self.lines.append("v " + " ".join(f"{c:.5f}" for c in position))
        if uv:
            self.lines.append("vt " + " ".join(f"{c:.5f}" for c in uv))
        if normal:
            length = math.sqrt(sum(c * c for c in normal)) or 1.0
            self.lines.append("vn " + " ".join(f"{c / length:.5f}" for c in normal))
        self.count += 1
        return self.count

    def face(self, corners, uv=False, normal=False):
        pattern = {(False, False): "{0}", (True, False): "{0}/{0}", (False, True): "{0}//{0}",
                   (True, True): "{0}/{0}/{0}"}[uv, normal]
        self.lines.append("f " + " ".join(pattern.format(c) for c in corners))

    def grid(self, columns, rows, point, close_columns=False, close_rows=False, uv=False, normal=False):
        """`point(i, j)` gives the arguments of `vertex`; counter-clockwise quads seen with i to the right, j up."""
        across = columns if close_columns else columns + 1
        up = rows if close_rows else rows + 1
        ids = [[self.vertex(*point(i, j)) for i in range(across)] for j in range(up)]
        for j in range(rows):
            for i in range(columns):
                ring, above = ids[j], ids[(j + 1) % up]
                self.face([ring[i], ring[(i + 1) % across], above[(i + 1) % across], above[i]], uv, normal)

    def box(self, low, high, place=lambda p: p):
        corners = [place([(low, high)[i >> k & 1][k] for k in range(3)]) for i in range(8)]
        ids = [self.vertex(c) for c in corners]
        for quad in ([0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]):
            self.face([ids[q] for q in quad])

    def save(self):
        (FOLDER / f"{self.name}.obj").write_text("\n".join(self.lines) + "\n", encoding="utf-8")
        (FOLDER / f"{self.name}.mtl").write_text("\n\n".join(self.materials) + "\n", encoding="utf-8")


def make_tiles():
    """Eight by eight stone tiles in two warm tones, each with its own shade and veins, and dark joints."""
    size, tiles = 512, 8
    coarse, fine, veins = Noise(16, 1), Noise(128, 2), Noise(8, 3)
    source = random.Random(4)
    shade = [[source.uniform(-9, 9) for _ in range(tiles)] for _ in range(tiles)]
    shift = [[source.uniform(0, 8) for _ in range(tiles)] for _ in range(tiles)]
    cell = size // tiles

    def pixel(x, y):
        i, j = x // cell, y // cell
        if min(x % cell, y % cell) < 1:
            return 66, 60, 56
        light = (i + j) % 2 == 0
        base = (206, 194, 174) if light else (128, 116, 106)
        s = shift[j][i]
        vein = abs(veins(x / 64 + s, y / 64 - s) + 0.35 * coarse(x / 32 + s, y / 32) - 0.68)
        change = shade[j][i] + 16 * (coarse(x / 32, y / 32) - 0.5) + 9 * (fine(x / 4, y / 4) - 0.5)
        change -= 26 * max(0.0, 1 - vein / 0.05)
        return [4 * round((c + change) / 4) for c in base]

    write_png("tiles.png", size, pixel)


def make_shell_texture():
    """Growth bands from cream to chestnut; x runs round the tube, y along the spiral."""
    size = 256
    ripple = Noise(8, 5)

    def pixel(x, y):
        wave = math.sin(2 * math.pi * (y / size * 8 + 0.35 * ripple(x / 32, y / 32)))
        t = max(0.0, wave) ** 0.7
        cream, chestnut = (238, 214, 180), (150, 84, 48)
        return [4 * round((a * (1 - t) + b * t) / 4) for a, b in zip(cream, chestnut)]

    write_png("shell.png", size, pixel)


def make_floor():
    model = Model("floor", "A tiled floor that bends up into a plain backdrop.")
    model.material("tiles", "Kd 1 1 1", "Ks 0.15 0.15 0.15", "Ns 60", "illum 2", "map_Kd tiles.png")
    half, back = 8.0, -3.6
    corners = [(-half, half), (half, half), (half, back), (-half, back)]
    model.face([model.vertex((x, 0, z), None, (x / 2.4, -z / 2.4)) for x, z in corners], uv=True)
    model.material("backdrop", "Kd 0.36 0.43 0.5", "Ks 0 0 0", "illum 1")
    radius, height, steps = 1.4, 6.0, 24

    def sweep(i, j):
        x = -half if i == 0 else half
        if j <= steps:
            a = 0.5 * math.pi * j / steps
            return (x, radius * (1 - math.cos(a)), back - radius * math.sin(a)),
        return (x, height, back - radius),

    model.grid(1, steps + 1, sweep)
    model.save()


def make_mirror():
    """A tall mirror with a frame and a foot; it stands on the origin, faces +Z and leans back."""
    model = Model("mirror", "A standing mirror.")
    lean = math.radians(1.5)

    def place(p):
        x, y, z = p
        return x, y * math.cos(lean) + z * math.sin(lean), z * math.cos(lean) - y * math.sin(lean)

    model.material("frame", "Kd 0.2 0.085 0.04", "Ks 0.4 0.4 0.4", "Ns 90", "illum 2")
    width, height, bar, depth = 0.62, 2.05, 0.075, 0.045
    model.box((-width - bar, 0.0, -depth), (-width, height + bar, depth), place)
    model.box((width, 0.0, -depth), (width + bar, height + bar, depth), place)
    model.box((-width, height, -depth), (width, height + bar, depth), place)
    model.box((-width, 0.12, -depth), (width, 0.12 + bar, depth), place)
    model.box((-width, 0.12 + bar, -depth), (width, height, -depth + 0.02), place)
    model.box((-width - bar - 0.02, 0.0, -0.3), (-width + 0.02, 0.05, 0.22))
    model.box((width - 0.02, 0.0, -0.3), (width + bar + 0.02, 0.05, 0.22))
    model.material("silver", "Kd 0 0 0", "Ks 0.95 0.95 0.95", "Ns 1000", "illum 3")
    glass = [(-width, 0.12 + bar), (width, 0.12 + bar), (width, height), (-width, height)]
    model.face([model.vertex(place((x, y, -depth + 0.035))) for x, y in glass])
    model.save()


def make_knot():
    """A trefoil knot, standing."""
    model = Model("knot", "A torus knot.")
    model.material("lacquer", "Kd 0.6 0.05 0.035", "Ks 0.9 0.9 0.9", "Ns 160", "illum 2")
    steps, sides, tube = 320, 28, 0.105

    def centre(t):
        r = 0.3 * (2 + math.cos(3 * t)) / 2.2
        return (r * math.cos(2 * t) * 1.25, r * math.sin(2 * t) * 1.25, 0.16 * math.sin(3 * t))

    def sub(a, b):
        return [p - q for p, q in zip(a, b)]

    def cross(a, b):
        return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

    def unit(a):
        length = math.sqrt(sum(c * c for c in a))
        return [c / length for c in a]

    def point(i, j):
        t = 2 * math.pi * j / steps
        c = centre(t)
        along = unit(sub(centre(t + 1e-3), centre(t - 1e-3)))
        side = unit(cross(along, c))
        out = cross(side, along)
        a = 2 * math.pi * i / sides
        normal = [math.cos(a) * o + math.sin(a) * s for o, s in zip(out, side)]
        return [p + tube * n for p, n in zip(c, normal)], normal

    model.grid(sides, steps, point, close_columns=True, close_rows=True, normal=True)
    model.save()


def make_drop():
    """A solid drop of glass that stands on its round end."""
    model = Model("drop", "A drop, turned on a lathe.")
    model.material("glass", "Kd 1 1 1", "Ks 1 1 1", "Ns 1000", "Ni 1.5", "illum 7")
    sides, rings, radius, height = 96, 72, 0.47, 0.95

    def profile(j):
        t = math.pi * j / rings
        r = radius * math.sin(t) * math.cos(t / 2) ** 0.9
        return r, 0.5 * height * (1 - math.cos(t))

    def point(i, j):
        a = 2 * math.pi * i / sides
        r, y = profile(j)
        (r0, y0), (r1, y1) = profile(j - 0.01), profile(j + 0.01)
        n, up = y1 - y0, r0 - r1
        return (r * math.cos(a), y, -r * math.sin(a)), (n * math.cos(a), up, -n * math.sin(a))

    bottom = model.vertex((0, 0, 0), (0, -1, 0))
    top = model.vertex((0, height, 0), (0, 1, 0))
    ids = [[model.vertex(*point(i, j)) for i in range(sides)] for j in range(1, rings)]
    for i in range(sides):
        k = (i + 1) % sides
        model.face([bottom, ids[0][k], ids[0][i]], normal=True)
        model.face([top, ids[-1][i], ids[-1][k]], normal=True)
        for ring, above in zip(ids, ids[1:]):
            model.face([ring[i], ring[k], above[k], above[i]], normal=True)
    model.save()


def make_prism():
    """What the program is named after: an equal-sided glass prism, lying along X."""
    model = Model("prism", "A glass prism.")
    model.material("crystal", "Kd 1 1 1", "Ks 1 1 1", "Ns 1000", "Ni 1.6", "illum 7")
    side, half = 0.46, 0.5
    triangle = [(side / 2, 0.0), (-side / 2, 0.0), (0.0, side * math.sqrt(3) / 2)]  # z, y
    left = [model.vertex((-half, y, z)) for z, y in triangle]
    right = [model.vertex((half, y, z)) for z, y in triangle]
    model.face([left[0], left[2], left[1]])
    model.face(right)
    for i in range(3):
        k = (i + 1) % 3
        model.face([left[i], left[k], right[k], right[i]])
    model.save()


def make_shell():
    """A sea shell: a tube that grows along a falling spiral (Raup, 1966)."""
    model = Model("shell", "A sea shell.")
    model.material("shell", "Kd 1 1 1", "Ks 0.5 0.5 0.5", "Ns 50", "illum 2", "map_Kd shell.png")
    sides, steps, turns, growth = 36, 260, 7.0, 0.085

    def point(i, j):
        t = 2 * math.pi * turns * (j / steps - 1)
        a = 2 * math.pi * i / sides
        size = 0.24 * math.exp(growth * t)
        size *= 1 + 0.018 * math.sin(15 * t)
        tube = 1.02
        out = 1.0 + tube * math.cos(a)
        y = 2.5 * (0.24 - size) + size * tube * 1.15 * math.sin(a)
        return ((size * out * math.cos(t), y, size * out * math.sin(t)), None,
                (i / sides, 8 * j / steps))

    model.grid(sides, steps, point, uv=True)
    model.save()


if __name__ == "__main__":
    make_tiles()
    make_shell_texture()
    make_floor()
    make_mirror()
    make_knot()
    make_drop()
    make_prism()
    make_shell()
