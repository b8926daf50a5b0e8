#!/usr/bin/env python3
"""Writes letters.png, grass.png and evening.png beside itself. Needs oiiotool.

letters.png: a board of four by four fields with a letter each, A in the upper left corner, so that it shows which way
round it lies. grass.png: repeats without a seam. evening.png: a sphere map (docs/pfman_library.md, Textures) of a sky
after sunset over dunes.
"""

import math
import os
import random
import subprocess
import tempfile

FOLDER = os.path.dirname(os.path.abspath(__file__))

LETTERS = {
    "A": "01110 10001 10001 11111 10001 10001 10001",
    "B": "11110 10001 10001 11110 10001 10001 11110",
    "C": "01110 10001 10000 10000 10000 10001 01110",
    "D": "11110 10001 10001 10001 10001 10001 11110",
    "E": "11111 10000 10000 11110 10000 10000 11111",
    "F": "11111 10000 10000 11110 10000 10000 10000",
    "G": "01110 10001 10000 10111 10001 10001 01110",
    "H": "10001 10001 10001 11111 10001 10001 10001",
    "J": "00111 00010 00010 00010 00010 10010 01100",
    "K": "10001 10010 10100 11000 10100 10010 10001",
    "L": "10000 10000 10000 10000 10000 10000 11111",
    "N": "10001 11001 11001 10101 10011 10011 10001",
    "P": "11110 10001 10001 11110 10000 10000 10000",
    "R": "11110 10001 10001 11110 10100 10010 10001",
    "S": "01111 10000 10000 01110 00001 00001 11110",
    "Z": "11111 00001 00010 00100 01000 10000 11111",
}


def mix(a, b, t):
    t = min(max(t, 0.0), 1.0)
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def smooth(a, b, x):
    t = min(max((x - a) / (b - a), 0.0), 1.0)
    return t * t * (3 - 2 * t)


class Noise:
    """Value noise that repeats after `period` lattice points."""

    def __init__(self, seed, period):
        source = random.Random(seed)
        self.period = period
        self.values = [[source.random() for _ in range(period)] for _ in range(period)]

    def __call__(self, x, y):
        i, j = math.floor(x), math.floor(y)
        u, v = smooth(0, 1, x - i), smooth(0, 1, y - j)
        rows = [self.values[(j + n) % self.period] for n in range(2)]
        ends = [row[i % self.period] + (row[(i + 1) % self.period] - row[i % self.period]) * u for row in rows]
        return ends[0] + (ends[1] - ends[0]) * v


def fractal(noises, x, y):
    """Octaves of noise, each half the weight of the one before; x and y run from 0 to 1."""
    total = sum(0.5**n for n in range(len(noises)))
    return sum(0.5**n * noise(x * noise.period, y * noise.period) for n, noise in enumerate(noises)) / total


def letters(column, row, size):
    field = size // 4
    i, j = column // field, row // field
    light, dark = ((0.93, 0.89, 0.78), (0.16, 0.26, 0.36))
    if (i + j) % 2:
        light, dark = ((0.70, 0.30, 0.20), (0.97, 0.93, 0.84))
    unit = field // 10
    x, y = (column % field - (field - 5 * unit) // 2) // unit, (row % field - (field - 7 * unit) // 2) // unit
    rows = list(LETTERS.values())[4 * j + i].split()
    return dark if 0 <= x < 5 and 0 <= y < 7 and rows[y][x] == "1" else light


def grass(size):
    """Blades are drawn one over another, upwards, over dark ground."""
    source = random.Random(5)
    patches = [Noise(n, 4 << n) for n in range(4)]
    pixels = [[(0.10, 0.13, 0.05)] * size for _ in range(size)]
    blades = 16 * size
    for n in range(blades):
        x, y = source.random() * size, source.random() * size
        lean, length = source.uniform(-0.5, 0.5), source.uniform(0.06, 0.14) * size
        patch = fractal(patches, x / size, y / size)
        shade = 0.6 + 0.7 * n / blades
        tone = mix((0.18, 0.36, 0.08), (0.56, 0.60, 0.22), smooth(0.35, 0.68, patch) + source.uniform(-0.25, 0.25))
        for step in range(int(length)):
            part = step / length
            color = tuple(shade * (0.55 + 0.6 * part) * c for c in tone)
            for side in range(1 if part > 0.5 else 2):
                column = int(x + lean * part * step + side) % size
                pixels[int(y - step) % size][column] = color
    return lambda column, row, _: pixels[row][column]


def sky(x, y, z, clouds, dunes):
    """What is seen in a direction; the sun has set in the direction of -x and -z."""
    towards_sun = (-0.8 * x - 0.6 * z) / math.sqrt(max(1e-9, 1 - min(y * y, 1 - 1e-9)))
    glow = smooth(-0.4, 1.0, towards_sun) * (1 - smooth(0.3, 0.95, y))
    horizon = mix((0.36, 0.33, 0.46), (0.98, 0.55, 0.24), glow)
    color = mix(horizon, (0.09, 0.13, 0.33), smooth(-0.02, 0.65, y))
    if y > 0.01:
        distance = 0.3 / (y + 0.1)
        cover = fractal(clouds, x * distance + 0.5, z * distance + 0.5)
        cloud = mix((0.40, 0.36, 0.48), (1.0, 0.66, 0.42), glow)
        color = mix(color, cloud, 0.8 * smooth(0.5, 0.66, cover) * smooth(0.0, 0.2, y))
    around = (math.atan2(x, z) / (2 * math.pi)) % 1
    ridge = 0.10 * (fractal(dunes, around, 0.25) - 0.3)
    if y < ridge:
        sand = mix((0.30, 0.22, 0.23), (0.72, 0.44, 0.28), smooth(-0.4, 1.0, towards_sun) * smooth(-0.6, 0.05, y))
        color = mix(sand, (0.20, 0.15, 0.16), smooth(0.0, 1.0, -y))
    return color


def evening(size):
    clouds, dunes = [Noise(20 + n, 3 << n) for n in range(5)], [Noise(40 + n, 4 << n) for n in range(3)]

    def color(column, row, _):
        nx, ny = 2 * (column + 0.5) / size - 1, 1 - 2 * (row + 0.5) / size
        nz = math.sqrt(max(0.0, 1 - nx * nx - ny * ny))
        if nz == 0:  # beyond the rim: what lies on it
            length = math.hypot(nx, ny)
            nx, ny = nx / length, ny / length
        return sky(2 * nz * nx, 2 * nz * ny, 2 * nz * nz - 1, clouds, dunes)

    return color


def write(name, size, color):
    with tempfile.TemporaryDirectory() as folder:
        plain = os.path.join(folder, "image.ppm")
        with open(plain, "wb") as file:
            file.write(b"P6 %d %d 255\n" % (size, size))
            for row in range(size):
                for column in range(size):
                    file.write(bytes(int(min(max(c, 0.0), 1.0) * 255 + 0.5) for c in color(column, row, size)))
        subprocess.run(["oiiotool", plain, "--compression", "png:9", "-o", os.path.join(FOLDER, name)], check=True)


write("letters.png", 256, letters)
write("grass.png", 128, grass(128))
write("evening.png", 192, evening(192))
