#!/usr/bin/env python3
"""Writes the meshes of the scenes into meshes/: pin.obj, a bowling pin; surface.off, a wavy surface.

The pin stands on the origin, in inches, its diameters those that the game's rules give by height. Texture coordinates
run around it (s) and from its foot to its head (t).
"""

import math
from pathlib import Path

FOLDER = Path(__file__).resolve().parent / "meshes"

# Heights and radii of the pin, in inches; the head above the last is a part of a sphere.
PIN = [(0, 1.015), (0.75, 1.414), (2.25, 1.953), (3.375, 2.255), (4.5, 2.383), (5.875, 2.2815), (7.25, 1.8515),
       (8.625, 1.236), (9.375, 0.9825), (10, 0.8985), (10.875, 0.935), (11.75, 1.047), (12.625, 1.203), (13.5, 1.2735)]
TOP = 15.0
AROUND, ALONG, CAP = 28, 2, 5  # sides; rings between two of the rules' heights; rings of the head


def slopes(points):
    """Radius over height at each point, by the parabola through it and its neighbours."""
    result = []
    for k in range(len(points)):
        a, b, c = (points[min(max(k + d, 0), len(points) - 1)] for d in (-1, 0, 1))
        before = (b[1] - a[1]) / (b[0] - a[0]) if b != a else None
        after = (c[1] - b[1]) / (c[0] - b[0]) if c != b else None
        if before is None or after is None:
            result.append(before if after is None else after)
        else:
            result.append((before * (c[0] - b[0]) + after * (b[0] - a[0])) / (c[0] - a[0]))
    return result


def profile():
    """(height, radius, slope) from foot to head: cubics between the rules' heights, then a circle."""
    rows, slope = [], slopes(PIN)
    slope[-1] = 0
    for k in range(len(PIN) - 1):
        (y0, r0), (y1, r1) = PIN[k], PIN[k + 1]
        h = y1 - y0
        for j in range(ALONG):
            t = j / ALONG
            r = ((2 * t**3 - 3 * t**2 + 1) * r0 + (t**3 - 2 * t**2 + t) * h * slope[k]
                 + (3 * t**2 - 2 * t**3) * r1 + (t**3 - t**2) * h * slope[k + 1])
            d = ((6 * t**2 - 6 * t) * (r0 - r1) / h + (3 * t**2 - 4 * t + 1) * slope[k] + (3 * t**2 - 2 * t) * slope[k + 1])
            rows.append((y0 + t * h, r, d))
    y0, r0 = PIN[-1]
    for j in range(CAP):
        a = math.pi / 2 * j / CAP
        rows.append((y0 + (TOP - y0) * math.sin(a), r0 * math.cos(a), -math.tan(a) * r0 / (TOP - y0)))
    return rows


def write_pin():
    rows = profile()
    lines = ["# Written by make_meshes.py."]
    normals, texcoords, faces = [], [], []
    for y, r, d in rows:
        length = math.hypot(1, d)
        for k in range(AROUND):
            a = 2 * math.pi * k / AROUND
            lines.append(f"v {r * math.sin(a):.5f} {y:.5f} {r * math.cos(a):.5f}")
            normals.append(f"vn {math.sin(a) / length:.5f} {-d / length:.5f} {math.cos(a) / length:.5f}")
        texcoords += [f"vt {((k / AROUND) + 0.5):.5f} {y / TOP:.5f}" for k in range(AROUND + 1)]
    head = len(rows) * AROUND + 1
    lines.append(f"v 0 {TOP} 0")
    normals.append("vn 0 1 0")
    texcoords.append("vt 0.5 1")

    def corner(row, k):
        n = row * AROUND + k % AROUND + 1
        return f"{n}/{row * (AROUND + 1) + k + 1}/{n}"
    for row in range(len(rows) - 1):
        for k in range(AROUND):
            faces.append("f " + " ".join([corner(row, k), corner(row, k + 1), corner(row + 1, k + 1), corner(row + 1, k)]))
    last = len(rows) - 1
    faces += [f"f {corner(last, k)} {corner(last, k + 1)} {head}/{len(texcoords)}/{head}" for k in range(AROUND)]
    foot = len(normals) + 1
    normals.append("vn 0 -1 0")
    faces.append("f " + " ".join(f"{k + 1}/{k + 1}/{foot}" for k in reversed(range(AROUND))))
    (FOLDER / "pin.obj").write_text("\n".join(lines + texcoords + normals + faces) + "\n")


def write_surface(columns=40, rows=40, size=8.0):
    """z = f(x, y) as triangles, x and y from -size/2 to size/2 and z along the scene's y."""
    def height(x, z):
        r = math.hypot(x, z)
        return 0.55 * math.cos(2.6 * r) / (1 + 0.35 * r * r) + 0.18 * math.sin(1.1 * x) * math.cos(0.9 * z)
    place = lambda k, n: size * (k / n - 0.5)
    vertices = [(place(i, columns), height(place(i, columns), place(j, rows)), place(j, rows))
                for j in range(rows + 1) for i in range(columns + 1)]
    at = lambda i, j: j * (columns + 1) + i
    faces = []
    for j in range(rows):
        for i in range(columns):
            a, b, c, d = at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)
            faces += [(a, b, c), (a, c, d)] if (i + j) % 2 else [(a, b, d), (b, c, d)]
    text = f"OFF\n{len(vertices)} {len(faces)} 0\n"
    text += "".join(f"{x:.5f} {y:.5f} {z:.5f}\n" for x, y, z in vertices)
    text += "".join(f"3 {a} {b} {c}\n" for a, b, c in faces)
    (FOLDER / "surface.off").write_text(text)


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    write_pin()
    write_surface()
