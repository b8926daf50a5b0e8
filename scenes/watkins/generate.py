#!/usr/bin/env python3
"""Writes the ten test objects of Watkins's chapter VII.A as scenes: NAME.toml and its mesh NAME.off.

The pictures of the thesis (figures 22 to 31) are lost. These are modern objects that agree with its words and with
rows 1 to 3 of figure 33 (polygons, edges, crossings of edges and scan lines); docs/ten_objects.md says how sure each
is. Sizes and angles given to many digits were chosen so that row 3 comes out.

The world is right-handed, y up, z towards the viewer; faces run counter-clockwise seen from outside. The picture has
510 x 511 pixels because its frame then has the thesis's 512 x 512; under the orthographic camera one unit is one
pixel, and under the perspective one a unit is a pixel in the plane through the origin unless a scene says otherwise.

usage: generate.py [FOLDER]
"""

import math
import struct
import sys
from pathlib import Path

WIDTH, HEIGHT = 510, 511  # of the picture; the frame is two columns wider and one line higher


def rotated(point, x=0.0, y=0.0, z=0.0):
    """`point` turned about the z axis, then y, then x; degrees, right-handed."""
    px, py, pz = point
    c, s = math.cos(math.radians(z)), math.sin(math.radians(z))
    px, py = c * px - s * py, s * px + c * py
    c, s = math.cos(math.radians(y)), math.sin(math.radians(y))
    px, pz = c * px + s * pz, c * pz - s * px
    c, s = math.cos(math.radians(x)), math.sin(math.radians(x))
    py, pz = c * py - s * pz, s * py + c * pz
    return px, py, pz


class Mesh:
    def __init__(self):
        self.points, self.faces = [], []

    def add(self, points, faces):
        """Appends a part; `faces` count from the part's own first point.

        A face's last corner is written first. A frame lists a face clockwise from its first written corner on, so
        that it then takes the corners of `faces` backwards: the order of edges that was measured."""
        base = len(self.points)
        self.points += points
        self.faces += [[base + i for i in [face[-1], *face[:-1]]] for face in faces]

    def moved(self, move):
        self.points = [move(p) for p in self.points]
        return self

    def reversed_faces(self):
        """The same object described from its last polygon to its first. The order in which edges reach the
        processor shows in the counters, and the thesis does not tell it."""
        self.faces.reverse()
        return self

    def off(self):
        # A reader may hold single precision: what is written is what it will hold.
        single = lambda v: struct.unpack("f", struct.pack("f", v))[0]
        lines = ["OFF", f"{len(self.points)} {len(self.faces)} 0"]
        lines += [" ".join(f"{single(v):.9g}" for v in p) for p in self.points]
        lines += [" ".join(map(str, [len(f), *f])) for f in self.faces]
        return "\n".join(lines) + "\n"


# Corner i of a box lies right when bit 2 is set, up when bit 1 is, far from the viewer when bit 0 is. Faces: front,
# back, left, right, bottom, top. In a frame the front face runs from its upper left corner on: then its left edge
# enters before its right one, and one segment block serves each face of cube1.
BOX_FACES = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3)]


def box(centre, half):
    sign = lambda i, bit: 1 if i & bit else -1
    return [(centre[0] + sign(i, 4) * half, centre[1] + sign(i, 2) * half, centre[2] - sign(i, 1) * half)
            for i in range(8)], BOX_FACES


def prism(outline, depth, place):
    """`outline` (x, y pairs, counter-clockwise) from z = place.z back to place.z - depth."""
    n = len(outline)
    points = [(place[0] + x, place[1] + y, place[2] - back) for back in (0.0, depth) for x, y in outline]
    faces = [list(range(n)), list(range(2 * n - 1, n - 1, -1))]
    faces += [[n + i, n + (i + 1) % n, (i + 1) % n, i] for i in range(n)]
    return points, faces


def sphere(radius, slices=16, bands=8, full_bands=10):
    """`bands` bands of 180 / full_bands degrees about the equator, closed by two flat caps."""
    points, faces = [], []
    for j in range(bands + 1):
        latitude = (j - bands / 2) * math.pi / full_bands
        ring = radius * math.cos(latitude)
        for i in range(slices):
            a = 2 * math.pi * (i + 0.5) / slices
            points.append((ring * math.cos(a), radius * math.sin(latitude), -ring * math.sin(a)))
    for j in range(0, bands * slices, slices):
        for i in range(slices):
            k = (i + 1) % slices
            faces.append([j + i, j + k, j + slices + k, j + slices + i])
    faces.append(list(range(slices - 1, -1, -1)))
    faces.append([bands * slices + i for i in range(slices)])
    return points, faces


def tube(length, radius, roll, yaw, tilt, centre, sides=5):
    """A sheet of 1 x `sides` cells rolled up, two triangles a cell. The seam stays open by a hair, because the thesis's
    105 edges are five times 21: the two edges at the seam are not shared."""
    points, faces = [], []
    for k in range(sides + 1):
        a = 2 * math.pi * k / sides - (1e-5 if k == sides else 0)
        for x in (-length / 2, length / 2):
            p = rotated((x, radius * math.cos(a), -radius * math.sin(a)), x=roll)
            p = rotated(rotated(p, y=yaw), z=tilt)
            points.append(tuple(p[i] + centre[i] for i in range(3)))
    for k in range(sides):
        a, b, c, d = 2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2
        faces += [[b, c, a], [c, d, a]]
    return points, faces


# ---------------------------------------------------------------------------------------------------- the objects

# Chosen so that row 3 of figure 33 comes out.
PENETRATION_TILT, PENETRATION_LENGTH = 18.0708, 268.2091
LOW_AREA_TILT, LOW_AREA_LENGTH = 17.9, 139.7
E_S_SIZE = 89.2529296875
CUBE1_RAISE = 0.0021
CUBE2_ROLL, CUBE2_SHIFT = -2.749, (-40.0, -37.3)
SHAPE_LENGTH, SHAPE_STACK, SHAPE_TURN = 277.808, 300.0, 26.56585
SHEET_LENGTH, SHEET_PITCH = 278.582, 57.88
SIMPLE_SIDE = 254.833984375  # of the large cube; the eye is 2.5 sides away
SIMPLE_CUBES = [(0.45, -0.3, -0.1), (0.65, 0.0, -0.35)]


def star_of_tubes(mesh, length, first_tilt, centre=(0, 0, 0)):
    """Five tubes turned by 36 degrees each, every other one yawed the other way. Each stands a quarter of its length off
    the centre, sideways, and a twentieth of it behind the one before."""
    for i in range(5):
        tilt, sign = first_tilt + 36 * i, -1 if i % 2 else 1
        side = math.radians(tilt + 90)
        offset = (sign * 0.25 * math.cos(side), sign * 0.25 * math.sin(side), -0.05 * (i - 2))
        place = tuple(length * (offset[k] + centre[k]) for k in range(3))
        mesh.add(*tube(length, 0.3 * length, math.degrees(-0.3 * i), sign * math.degrees(0.6), tilt, place))


def penetration():
    mesh = Mesh()
    star_of_tubes(mesh, PENETRATION_LENGTH, PENETRATION_TILT)
    return mesh


def low_area():
    """Two Penetrations, smaller, in one another."""
    mesh = Mesh()
    for sign, first_tilt in ((-1, LOW_AREA_TILT), (1, LOW_AREA_TILT + 18)):
        star_of_tubes(mesh, LOW_AREA_LENGTH, first_tilt, (0.35 * sign, 0.35 * sign, -0.15 * sign))
    return mesh


LETTER_E = [(0, 0), (.7, 0), (.7, .2), (.22, .2), (.22, .4), (.6, .4), (.6, .6), (.22, .6), (.22, .8), (.7, .8), (.7, 1),
            (0, 1)]
LETTER_S = [(0, 0), (.7, 0), (.7, .6), (.22, .6), (.22, .8), (.7, .8), (.7, 1), (0, 1), (0, .4), (.48, .4), (.48, .2),
            (0, .2)]


def e_s():
    """Five letters E and five S in three rows of four, dashes between them, two stacked wedges in each lower corner."""
    size, gap, line_gap, depth, dash = E_S_SIZE, 0.5, 0.3, 1.2, 1.3
    mesh = Mesh()

    def letter(outline, x, y, front, thickness):
        mesh.add(*prism([(size * a, size * b) for a, b in outline], size * thickness, (x, y, size * front)))

    column = lambda c: ((c - 1.5) * (0.7 + gap) - 0.35) * size
    row = lambda r: ((1 - r) * (1 + line_gap) - 0.5) * size
    for r in range(3):
        for c in range(4):
            if r == 2 and c in (0, 3):
                for low in (0.1, 0.6):
                    letter([(0, low), (.7, low), (.35, low + 0.4)], column(c), row(r), depth / 2, depth)
            else:
                letter(LETTER_S if (r + c) % 2 else LETTER_E, column(c), row(r), depth / 2, depth)
    half = gap * dash / 2
    for r, c in [(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (2, 1)]:
        letter([(-half, -.1), (half, -.1), (half, .1), (-half, .1)], column(c) + (0.7 + gap / 2) * size,
               row(r) + size / 2, 0.3 * depth, 0.6 * depth)
    return mesh.moved(lambda p: rotated(p, x=34, y=-21))


CUBE_PITCH, CUBE_DISTANCE = 1.5, 1.5 / 0.176  # cubes of side 1 in a row; the eye is this far from the first
CUBE_FOCUS = 358 * CUBE_DISTANCE              # pixels: the first front face measures 358


def row_of_cubes(place):
    mesh = Mesh()
    for i in range(25):
        mesh.add(*box((0, 0, -(i * CUBE_PITCH + 0.5)), 0.5))
    return mesh.moved(place)


def cube1():
    """Seen along the row: only the first cube's front is visible. The row stands a little off the axis, so that the
    faces measure 3,579 scan lines together."""
    return row_of_cubes(lambda p: (p[0], p[1] + CUBE1_RAISE, p[2]))


def cube2():
    """The row points to the upper right: its vanishing point is 310 pixels right of and above the first front face."""
    shift_x, shift_y = CUBE2_SHIFT  # of that face from the middle of the picture, pixels
    yaw, pitch = (math.degrees(math.atan2(310 + shift, CUBE_FOCUS)) for shift in CUBE2_SHIFT)

    def place(p):
        x, y, z = rotated(rotated(p, z=CUBE2_ROLL), x=pitch, y=-yaw)
        return x + shift_x * CUBE_DISTANCE / CUBE_FOCUS, y + shift_y * CUBE_DISTANCE / CUBE_FOCUS, z

    return row_of_cubes(place)


def shape(turn):
    """A ribbon of 50 cells pleated into 25 louvres, turned in the picture plane by `turn` degrees."""
    count, overlap = 25, 1.4
    spacing = SHAPE_STACK / (count - 1 + overlap)
    mesh, points, faces = Mesh(), [], []
    for k in range(2 * count + 1):
        louvre, low = divmod(k, 2)
        y = SHAPE_STACK / 2 - louvre * spacing - (overlap * spacing if low else 0)
        z = 4.0 * louvre - (0 if low else 20)
        points += [rotated((x, y, z), z=turn) for x in (-SHAPE_LENGTH / 2, SHAPE_LENGTH / 2)]
    for k in range(2 * count):
        a, b, c, d = 2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2
        faces += [[c, b, a], [d, c, a]]
    mesh.add(points, faces)
    return mesh.reversed_faces()


def sheet():
    """12 x 8 cells with two waves one way and half a wave the other, looked at from above."""
    width, height, nx, ny = 356, 35, 12, 8
    mesh, points, faces = Mesh(), [], []
    for j in range(ny + 1):
        for i in range(nx + 1):
            u, v = i / nx, j / ny
            wave = height * math.cos(4 * math.pi * u) * math.cos(math.pi * v)
            points.append(rotated(((u - 0.5) * width, wave, (0.5 - v) * SHEET_LENGTH), x=SHEET_PITCH, y=4))
    for j in range(ny):
        for i in range(nx):
            a = j * (nx + 1) + i
            b, c, d = a + 1, a + nx + 2, a + nx + 1
            faces += [[b, d, a], [c, d, b]]
    mesh.add(points, faces)
    return mesh.reversed_faces()


def simple(sphere_radius):
    """A large cube around a sphere, and three small cubes through its front; `sphere_radius` in half sides."""
    half, mesh = SIMPLE_SIDE / 2, Mesh()
    mesh.add(*box((0, 0, 0), half))
    mesh.add(*sphere(sphere_radius * half))
    for x, y, z in SIMPLE_CUBES:
        mesh.add(*box((x * half, y * half, z * half), 0.3 * half))
    return mesh.moved(lambda p: rotated(p, x=-17, y=-40)).reversed_faces()


# ---------------------------------------------------------------------------------------------------- the scenes


def orthographic():
    """One unit is one pixel; the origin is the middle of the picture."""
    return ["[camera]", 'projection = "orthographic"', "position = [0, 0, 1000]", "target = [0, 0, 0]",
            f"height = {HEIGHT}", "near = 1", "far = 2000"]


def perspective(distance, pixels, near, far):
    """The eye `distance` in front of the origin, where one unit measures `pixels`."""
    angle = 2 * math.degrees(math.atan(HEIGHT / 2 / (pixels * distance)))
    return ["[camera]", 'projection = "perspective"', f"position = [0, 0, {distance:.17g}]", "target = [0, 0, 0]",
            f"field_of_view = {angle:.17g}", f"near = {near}", f"far = {far}"]


CUBE_CAMERA = perspective(CUBE_DISTANCE, 358, 6, 60)
SIMPLE_CAMERA = perspective(2.5 * SIMPLE_SIDE, 1, 200, 1200)

SCENES = {
    "penetration": ("Object 1, Penetration: many intersecting planes", penetration, orthographic()),
    "e_s": ("Object 2, E-S: many edges", e_s, orthographic()),
    "low_area": ("Object 3, Low Area: intersections in a small area", low_area, orthographic()),
    "cube1": ("Object 4, Cube1: twenty-five cubes, only the front one visible", cube1, CUBE_CAMERA),
    "cube2": ("Object 5, Cube2: parts of all twenty-five cubes visible", cube2, CUBE_CAMERA),
    "shape1": ("Object 6, Shape1: polygons long in X", lambda: shape(SHAPE_TURN), orthographic()),
    "shape2": ("Object 7, Shape2: polygons long in Y", lambda: shape(SHAPE_TURN + 90), orthographic()),
    "sheet": ("Object 8, Sheet: a wavy object made up of triangles", sheet, orthographic()),
    "simple1": ("Object 9, Simple1: a cube around a sphere, and intersecting cubes", lambda: simple(0.93), SIMPLE_CAMERA),
    "simple2": ("Object 10, Simple2: the sphere intersects the cube", lambda: simple(1.045625), SIMPLE_CAMERA),
}


def scene(name):
    title, _, camera = SCENES[name]
    return "\n".join([
        f"# {title}. Written by generate.py.", "version = 1", f"size = [{WIDTH}, {HEIGHT}]",
        "background = [0.0, 0.0, 0.0]", "", *camera, "",
        "[[light]]", 'kind = "directional"', "direction = [-0.4, -0.6, -1.0]", "intensity = 0.8", "",
        "[[light]]", 'kind = "ambient"', "intensity = 0.2", "",
        "[[object]]", f'name = "{name}"', 'geometry = "mesh"', f'file = "{name}.off"',
        'shader = {name = "flat", parameters = {color = [0.9, 0.85, 0.7]}}', ""])


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    for name, (_, build, _) in SCENES.items():
        (folder / f"{name}.off").write_text(build().off())
        (folder / f"{name}.toml").write_text(scene(name))


if __name__ == "__main__":
    main()
