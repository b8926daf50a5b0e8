#!/usr/bin/env python3
"""Writes church.toml: a church of 345 blocks of six polygons each, as many as figure 35's church has.

Usage: make_church.py > church.toml. Metres; the nave runs along x, the tower stands in the west (small x), y is up.
"""

BLOCKS = 345
groups = {}


def block(group, x, y, z, top=None):
    """x, y, z are pairs (from, to); top is the size of the upper face as a part of the lower one."""
    size = [b - a for a, b in (x, y, z)]
    center = [(a + b) / 2 for a, b in (x, y, z)]
    groups.setdefault(group, []).append((center, size, top))


def split(a, b, parts):
    """(a, b) in equal parts."""
    step = (b - a) / parts
    return [(a + k * step, a + (k + 1) * step) for k in range(parts)]


def both(z):
    """The pair, and its mirror image on the other side of the nave."""
    return [z, (-z[1], -z[0])]


def nave():
    for z in both((4.2, 5.0)):
        for x in split(-10, 10, 7):
            for y in split(0, 6, 2):
                block("walls", x, y, z)
    for k in range(8):  # buttresses between the bays, in two steps
        x = -10 + 20 * k / 7
        for z in both((5.0, 6.2)):
            block("trim", (x - 0.35, x + 0.35), (0, 3.2), z)
        for z in both((5.0, 5.7)):
            block("trim", (x - 0.35, x + 0.35), (3.2, 5.4), z, (1, 0.3))
    for k in range(7):  # windows stand out from the wall by a hand
        x = -10 + 20 * (k + 0.5) / 7
        for z in both((5.0, 5.08)):
            block("windows", (x - 0.55, x + 0.55), (1.8, 4.2), z)
            block("windows", (x - 0.55, x + 0.55), (4.2, 4.9), z, (0.2, 1))
    for k, y in enumerate(split(6, 11, 6)):  # roof of stone steps
        half = 5.5 * (1 - k / 6)
        for x in split(-10, 10.2, 3):
            block("roof", x, y, (-half, half), (1, 0.9))
    block("trim", (-10, 10.4), (11, 11.3), (-0.2, 0.2))


def chancel():
    for z in both((3.0, 3.7)):
        for x in split(10, 16, 3):
            for y in split(0, 5, 2):
                block("walls", x, y, z)
    for z in split(-3.7, 3.7, 3):
        for y in split(0, 5, 2):
            block("walls", (16, 16.7), y, z)
    for x in (12.0, 14.0):
        for z in both((3.7, 4.4)):
            block("trim", (x - 0.3, x + 0.3), (0, 4), z, (1, 0.3))
    for x in (11.0, 13.0, 15.0):
        for z in both((3.7, 3.78)):
            block("windows", (x - 0.45, x + 0.45), (1.5, 3.8), z)
    block("windows", (16.7, 16.78), (1.6, 4.4), (-1, 1))
    for k, y in enumerate(split(5, 9, 5)):
        half = 4.1 * (1 - k / 5)
        for x in split(10.2, 17, 2):
            block("roof", x, y, (-half, half), (1, 0.9))


def tower():
    west, east, side = -17.0, -10.0, 3.5
    for y in split(0, 17, 7):
        for z in both((2.6, side)):
            for x in split(west, east, 2):
                block("walls", x, y, z)
        for x in ((west, west + 0.9), (east - 0.9, east)):
            block("walls", x, y, (-2.6, 2.6))
    for x0 in (west - 0.5, east - 0.5):  # corner buttresses, stepped back as they rise
        for k, y in enumerate(split(0, 16, 3)):
            inset = 0.12 * k
            for z in both((side - 0.5 + inset, side + 0.6 - inset)):
                block("trim", (x0 + inset, x0 + 1.0 - inset), y, z, (0.9, 0.9))
    block("trim", (west - 0.3, east + 0.3), (17, 17.5), (-side - 0.3, side + 0.3))
    for x in split(west - 0.3, east + 0.3, 9)[::2]:  # battlements
        for z in both((side - 0.1, side + 0.3)):
            block("trim", x, (17.5, 18.4), z)
    for z in split(-side + 0.4, side - 0.4, 7)[1::2]:
        for x in ((west - 0.3, west + 0.1), (east - 0.1, east + 0.3)):
            block("trim", x, (17.5, 18.4), z)
    for z in both((side, side + 0.08)):  # belfry openings
        for x in (-15.0, -13.5, -12.0):
            block("windows", (x - 0.4, x + 0.4), (12.5, 15.5), z)
    for x in ((west - 0.08, west), (east, east + 0.08)):
        for z in (-1.4, 0.0, 1.4):
            block("windows", x, (12.5, 15.5), (z - 0.4, z + 0.4))
    middle, half = (west + east) / 2, 2.9
    for k, y in enumerate(split(17.5, 29.5, 8)):  # spire
        lower, upper = half * (1 - k / 8) + 0.06, half * (1 - (k + 1) / 8) + 0.06
        block("roof", (middle - lower, middle + lower), y, (-lower, lower), (upper / lower, upper / lower))
    block("trim", (middle - 0.1, middle + 0.1), (29.5, 31.5), (-0.1, 0.1))
    block("trim", (middle - 0.1, middle + 0.1), (30.5, 30.8), (-0.6, -0.1))
    block("trim", (middle - 0.1, middle + 0.1), (30.5, 30.8), (0.1, 0.6))
    block("windows", (west - 0.1, west), (0.6, 4), (-1, 1))  # the door
    for k in range(3):  # and its steps
        block("trim", (west - 1.6 + 0.4 * k, west), (0.2 * k, 0.2 * k + 0.2), (-2 + 0.3 * k, 2 - 0.3 * k))


def wall():
    """Around the churchyard, with a gap before the door."""
    for x in split(-22, 20.5, 17):
        for z in both((20.2, 20.8)):
            block("walls", (x[0], x[1] - 0.15), (0, 1.3), z, (1, 0.7))
    for z in split(-20.2, 20.2, 13):
        block("walls", (20.3, 20.9), (0, 1.3), (z[0] + 0.15, z[1]), (0.7, 1))
        if abs(z[0] + z[1]) > 4:
            block("walls", (-22.6, -22), (0, 1.3), (z[0] + 0.15, z[1]), (0.7, 1))


def churchyard(count):
    """What is left of the blocks becomes gravestones south of the nave, in rows."""
    for k in range(count):
        x, z = -7.5 + 3.1 * (k % 9), 9.2 + 2.3 * (k // 9)
        block("graves", (x - 0.4, x + 0.4), (0, 1.1 + 0.2 * ((k * 7) % 3)), (z - 0.12, z + 0.12), (0.8, 1))


SHADERS = {
    "walls": """{name = "ashlar", file = "shaders/ashlar.pfman"}""",
    "trim": """{name = "ashlar", file = "shaders/ashlar.pfman", parameters = {length = 1.4, height = 0.6, pale = [0.80, 0.70, 0.56], \
deep = [0.58, 0.48, 0.36]}}""",
    "roof": """{name = "ashlar", file = "shaders/ashlar.pfman", parameters = {length = 0.5, height = 0.45, joint = 0.06, \
pale = [0.46, 0.50, 0.58], deep = [0.27, 0.29, 0.36], joint_color = [0.15, 0.16, 0.2], stains = 0.2}}""",
    "windows": """{name = "plastic", parameters = {color = [0.10, 0.12, 0.24], gloss = 0.8, shine = 9}}""",
    "graves": """{name = "flat", parameters = {color = [0.62, 0.64, 0.62]}}"""}

HEAD = """# A church of 345 blocks, six polygons each. Written by make_church.py.
version = 1
size = [512, 512]
background = [0.74, 0.82, 0.90]

[camera]
position = [-49, 21, 61]
target = [-3.2, 11.5, 1.5]
field_of_view = 43
near = 5
far = 500

[[light]]
direction = [0.8, -0.75, -0.5]
color = [1.0, 0.93, 0.80]
intensity = 0.9

[[light]]
kind = "ambient"
color = [0.8, 0.9, 1.0]
intensity = 0.35

[[object]]
name = "ground"
geometry = "shape"
shape = "boxes"
list = [{center = [80, -0.55, -80], size = [400, 1, 400]}]
shader = {name = "meadow", file = "shaders/meadow.pfman", parameters = {haze = 0.002}}

[[object]]
name = "sky"
geometry = "shape"
shape = "plane"
size = [620, 220]
rotate = [90, -39, 0]
translate = [160, 60, -204]
shader = {name = "sky", file = "shaders/sky.pfman", parameters = {horizon = 0.2, clouds = [8, 7]}}
"""


def numbers(values):
    return "[" + ", ".join(f"{round(v, 4):g}" for v in values) + "]"


def main():
    nave()
    chancel()
    tower()
    wall()
    left = BLOCKS - sum(len(blocks) for blocks in groups.values())
    if left < 0:
        raise SystemExit(f"{-left} blocks too many")
    churchyard(left)
    print(HEAD)
    for group, blocks in groups.items():
        print(f'[[object]]\nname = "{group}"\ngeometry = "shape"\nshape = "boxes"')
        print(f'shader = {SHADERS[group]}\nlist = [')
        for center, size, top in blocks:
            tail = f", top = {numbers(top)}" if top else ""
            print(f"  {{center = {numbers(center)}, size = {numbers(size)}{tail}}},")
        print("]\n")


if __name__ == "__main__":
    main()
