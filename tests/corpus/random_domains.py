"""Random domains of 23 kinds. `domain(seed)` returns a name and closed curves, the outer one first.

Seed s makes a domain of the kind number s mod 23, so that consecutive seeds cover all kinds; seeds
that were never used give domains that nothing was tuned on.
"""

import math
import random

from engineering import arc, box, circle, gear, profile
from glyphs import LETTERS, glyph
from simple_loops import are_valid, clearance

TURN = 2 * math.pi


def turned(loop, angle, x=0.0, y=0.0, scale=1.0):
    """Returns the curve scaled, turned by an angle in radians, and shifted."""
    c, s = scale * math.cos(angle), scale * math.sin(angle)
    return [(x + c * px - s * py, y + s * px + c * py) for px, py in loop]


def ellipse(x, y, a, b, angle=0.0, count=64):
    return turned([(a * px, b * py) for px, py in circle(0, 0, 1, count)], angle, x, y)


def stadium(x, y, length, width, angle):
    """Returns a slot with round ends."""
    r, half = width / 2, (length - width) / 2
    return turned([*arc(half, 0, r, -90, 90, 12), *arc(-half, 0, r, 90, 270, 12)], angle, x, y)


def blob(chance, waves=6, amplitude=0.5, count=120):
    """Returns a smooth closed curve around the origin whose radius has random Fourier modes."""
    modes = [(k, chance.gauss(0, amplitude / k ** 1.3), chance.uniform(0, TURN))
             for k in range(2, 2 + waves)]
    curve = []
    for i in range(count):
        t = TURN * i / count
        radius = math.exp(sum(a * math.cos(k * t + phase) for k, a, phase in modes))
        curve.append((radius * math.cos(t), radius * math.sin(t)))
    return curve


def with_holes(chance, outer, count, make, gap):
    """Adds up to `count` holes `make()`, each at least `gap` away from the loops before it."""
    loops = [outer]
    for _ in range(60 * count):
        if len(loops) > count:
            break
        hole = make()
        if are_valid([*loops, hole]) and clearance(loops, hole) > gap:
            loops.append(hole)
    return loops


def place(chance, outer):
    """Returns a random position in the bounding box of a curve."""
    return tuple(chance.uniform(min(p[i] for p in outer), max(p[i] for p in outer)) for i in (0, 1))


def blobs(chance):
    outer = blob(chance, chance.randint(2, 12), chance.uniform(0.2, 0.6))
    holes = chance.choice((0, 0, 1, 2))
    return with_holes(chance, outer, holes, lambda: turned(
        blob(chance, 4, 0.4, 60), 0, *place(chance, outer), chance.uniform(0.08, 0.2)), 0.05)


def rectilinear(chance):
    """Returns the boundary of a union of squares of a grid that grows at random, with its holes."""
    cells, target = {(0, 0)}, chance.randint(3, 14)
    while len(cells) < target:
        x, y = chance.choice(sorted(cells))
        cells.add(chance.choice(((x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1))))
    width = [chance.uniform(0.5, 1.5) for _ in range(64)]
    at = [sum(width[:i]) for i in range(65)]
    after = {}
    for x, y in sorted(cells):
        for beside, a, b in (((0, -1), (0, 0), (1, 0)), ((1, 0), (1, 0), (1, 1)),
                             ((0, 1), (1, 1), (0, 1)), ((-1, 0), (0, 1), (0, 0))):
            if (x + beside[0], y + beside[1]) not in cells:
                after.setdefault((x + a[0], y + a[1]), []).append((x + b[0], y + b[1]))
    if any(len(ends) > 1 for ends in after.values()):
        return []  # two squares touch in a point
    loops = []
    while after:
        here = min(after)
        loop = []
        while here in after:
            loop.append(here)
            here = after.pop(here)[0]
        corners = [q for p, q, r in zip(loop[-1:] + loop[:-1], loop, loop[1:] + loop[:1])
                   if (p[0] == q[0]) != (q[0] == r[0])]
        loops.append([(at[x + 32], at[y + 32]) for x, y in corners])
    return loops


def acute(chance):
    """Returns a star or a wedge with sharp corners."""
    if chance.random() < 0.4:
        angle = math.radians(chance.uniform(6, 40))
        return [[(0, 0), (1, 0), (chance.uniform(0.5, 1.0) * math.cos(angle), math.sin(angle))]]
    points, inner = chance.randint(3, 9), chance.uniform(0.15, 0.7)
    return [[((1 if i % 2 == 0 else inner) * math.cos(TURN * i / (2 * points)),
              (1 if i % 2 == 0 else inner) * math.sin(TURN * i / (2 * points)))
             for i in range(2 * points)]]


def convex(chance):
    """Returns a polygon with corners at random angles of an ellipse."""
    angles = sorted(chance.uniform(0, TURN) for _ in range(chance.randint(3, 12)))
    flat = chance.uniform(0.4, 1.0)
    gaps = [b - a for a, b in zip(angles, angles[1:] + [angles[0] + TURN])]
    if min(gaps) < 0.1 or max(gaps) > 3.0:
        return []
    return [[(math.cos(t), flat * math.sin(t)) for t in angles]]


def rings(chance):
    radius = chance.choice((chance.uniform(0.2, 0.8), chance.uniform(0.8, 0.99)))
    shift = chance.choice((0.0, chance.uniform(0, 0.95))) * (1 - radius)
    return [circle(0, 0, 1, 96), circle(shift, 0, radius, 96)]


def plates(chance):
    """Returns a plate with 2 to 40 circular holes."""
    width, count = chance.uniform(1.0, 2.5), chance.choice((2, 3, 4, 6, 8, 12, 16, 20, 30, 40))
    outer = box(0, 0, width, 1) if chance.random() < 0.7 else circle(width / 2, 0.5, 0.7, 96)
    largest = 0.3 * math.sqrt(width / count)
    return with_holes(chance, outer, count, lambda: circle(
        *place(chance, outer), chance.uniform(0.3, 1.0) * largest, 32), 0.2 * largest)


def ellipses(chance):
    """Returns an ellipse up to 50 : 1, or a square with elliptic holes."""
    if chance.random() < 0.5:
        aspect = 50 ** chance.random()
        return [ellipse(0, 0, aspect, 1, 0, 160)]
    outer = box(0, 0, 1, 1)
    return with_holes(chance, outer, chance.randint(1, 16), lambda: ellipse(
        *place(chance, outer), chance.uniform(0.03, 0.15), chance.uniform(0.02, 0.06),
        chance.uniform(0, TURN), 40), 0.02)


def slots(chance):
    outer = box(0, 0, chance.uniform(1.0, 3.0), 1)
    square = chance.random() < 0.3
    return with_holes(chance, outer, chance.randint(1, 6), lambda: stadium(
        *place(chance, outer), chance.uniform(0.2, 0.7), chance.uniform(0.04, 0.15),
        chance.choice((0.0, TURN / 4)) if square else chance.uniform(0, TURN)), 0.03)


def gears(chance):
    loops = gear(chance.randint(5, 24))
    return loops if chance.random() < 0.7 else loops[:1]


def profiles(chance):
    """Returns a channel with one to three aerofoils, with sharp or blunt trailing edges."""
    count, blunt = chance.randint(1, 3), chance.random() < 0.5
    outer = box(-1.5, -1.5, 3, 1.5) if chance.random() < 0.6 else circle(0.5, 0, 4, 96)
    places = ((0.0, 0.0, 1.0), (-0.3, -0.14, 0.22), (1.04, -0.08, 0.35))
    return [outer, *(profile(chance.uniform(0.08, 0.2), chance.randint(25, 60), blunt, (x, y), size,
                             chance.uniform(-15, 15) if i == 0 else chance.uniform(-25, 25))
                     for i, (x, y, size) in enumerate(places[:count]))]


def lattices(chance):
    """Returns a rectangular grid of bars."""
    nx, ny, bar = chance.randint(2, 6), chance.randint(2, 6), chance.uniform(0.05, 0.4)
    return [box(0, 0, nx + bar, ny + bar),
            *(box(i + bar, j + bar, i + 1, j + 1) for i in range(nx) for j in range(ny))]


def spirals(chance):
    """Returns a strip along a spiral."""
    turns, width = chance.uniform(1.0, 3.0), chance.uniform(0.1, 0.7)
    angles = [TURN * i / 40 for i in range(int(40 * turns) + 1)]
    sides = [[((0.5 + t / TURN + side) * math.cos(t), (0.5 + t / TURN + side) * math.sin(t))
              for t in angles] for side in (width / 2, -width / 2)]
    return [sides[0] + sides[1][::-1]]


def combs(chance):
    teeth, gap, height = chance.randint(2, 16), chance.uniform(0.1, 0.9), chance.uniform(0.5, 4)
    base = chance.uniform(0.2, 1)
    loop = [(0, -base), (teeth - gap, -base)]
    for i in reversed(range(teeth)):
        loop += [(i + 1 - gap, height), (i, height)]
        if i > 0:
            loop += [(i, 0), (i - gap, 0)]
    return [loop]


def keyholes(chance):
    """Returns a plate with a hole whose lower side opens into a slot."""
    radius, width = chance.uniform(0.15, 0.35), chance.uniform(0.03, 0.2)
    depth = chance.uniform(0.45, 0.9)
    half = math.degrees(math.asin(min(0.9, width / 2 / radius)))
    hole = [*arc(0, 0, radius, -90 + half, 270 - half, 40), (-width / 2, -depth),
            (width / 2, -depth)]
    if chance.random() < 0.5:  # the slot ends in the plate
        return [box(-1, -1, 1, 1), hole]
    return [[(1, -1), (1, 1), (-1, 1), (-1, -1), (-width / 2, -1), *hole[-3::-1], (width / 2, -1)]]


def letters(chance):
    loops, lean = glyph(chance.choice(LETTERS)), chance.choice((0.0, chance.uniform(0, 0.3)))
    wide = chance.uniform(0.7, 1.5)
    return [[(wide * x + lean * y, y) for x, y in loop] for loop in loops]


def koch(loop, levels):
    """Replaces the middle third of every side by a bump, `levels` times."""
    for _ in range(levels):
        refined = []
        for (ax, ay), (bx, by) in zip(loop, loop[1:] + loop[:1]):
            dx, dy = (bx - ax) / 3, (by - ay) / 3
            tip = (ax + 1.5 * dx + math.sqrt(0.75) * dy, ay + 1.5 * dy - math.sqrt(0.75) * dx)
            refined += [(ax, ay), (ax + dx, ay + dy), tip, (ax + 2 * dx, ay + 2 * dy)]
        loop = refined
    return loop


def minkowski(loop, levels):
    """Replaces every side by eight sides of a quarter of its length, `levels` times."""
    steps = ((1, 0), (0, 1), (1, 0), (0, -1), (0, -1), (1, 0), (0, 1))
    for _ in range(levels):
        refined = []
        for (ax, ay), (bx, by) in zip(loop, loop[1:] + loop[:1]):
            dx, dy = (bx - ax) / 4, (by - ay) / 4
            refined.append((ax, ay))
            for along, across in steps:
                x, y = refined[-1]
                refined.append((x + along * dx - across * dy, y + along * dy + across * dx))
        loop = refined
    return loop


def carpet(levels):
    """Returns a square with the holes of a Sierpinski carpet."""
    loops = [box(0, 0, 1, 1)]
    for level in range(levels):
        n = 3 ** level
        loops += [box((i + 1 / 3) / n, (j + 1 / 3) / n, (i + 2 / 3) / n, (j + 2 / 3) / n)
                  for i in range(n) for j in range(n) if level == 0 or (i, j) != (1, 1)]
    return loops


def fractals(chance):
    which = chance.randint(0, 2)
    if which == 0:
        return [koch(circle(0, 0, 1, chance.randint(3, 6)), chance.randint(1, 3))]
    if which == 1:
        return [minkowski(circle(0, 0, 1, chance.randint(4, 6)), chance.randint(1, 2))]
    return carpet(chance.randint(1, 2))


def sections(chance):
    """Returns the cross section of a beam."""
    w, h, t = chance.uniform(0.5, 1.5), chance.uniform(0.8, 2), chance.uniform(0.03, 0.2)
    r = chance.uniform(0.5, 1.5) * t
    which = chance.randint(0, 5)
    if which == 0:  # angle with a fillet
        return [[(0, 0), (w, 0), (w, t), *arc(t + r, t + r, r, 270, 180), (t, h), (0, h)]]
    if which == 1:  # I with four fillets
        m = t / 2
        return [[(-w / 2, 0), (w / 2, 0), (w / 2, t), *arc(m + r, t + r, r, 270, 180),
                 *arc(m + r, h - t - r, r, 180, 90), (w / 2, h - t), (w / 2, h), (-w / 2, h),
                 (-w / 2, h - t), *arc(-m - r, h - t - r, r, 90, 0),
                 *arc(-m - r, t + r, r, 0, -90), (-w / 2, t)]]
    if which == 2:  # channel
        return [[(0, 0), (w, 0), (w, t), (t, t), (t, h - t), (w, h - t), (w, h), (0, h)]]
    if which == 3:  # Z
        return [[(0, 0), (w, 0), (w, h - t), (2 * w - t, h - t), (2 * w - t, h), (w - t, h),
                 (w - t, t), (0, t)]]
    if which == 4:  # hollow box with rounded corners
        return [rounded(0, 0, w, h, 0.3 * w), rounded(t, t, w - t, h - t, max(0.3 * w - t, 0.05))]
    return [circle(0, 0, h / 2, 96), box(-w / 4, -h / 5, w / 4, h / 5)]  # shaft with a square bore


def rounded(left, bottom, right, top, r):
    return [*arc(right - r, bottom + r, r, -90, 0), *arc(right - r, top - r, r, 0, 90),
            *arc(left + r, top - r, r, 90, 180), *arc(left + r, bottom + r, r, 180, 270)]


def slits(chance):
    """Returns a square with thin rectangular holes, axis-parallel or turned."""
    outer, straight = box(0, 0, 1, 1), chance.random() < 0.5

    def slit():
        half, width = chance.uniform(0.1, 0.35), 10 ** chance.uniform(-3, -1)
        angle = chance.choice((0.0, TURN / 4)) if straight else chance.uniform(0, TURN)
        return turned(box(-half, -width / 2, half, width / 2), angle, *place(chance, outer))
    return with_holes(chance, outer, chance.randint(1, 3), slit, 0.05)


def aspects(chance):
    """Returns a long domain of aspect ratio 30 to 1000."""
    length = 10 ** chance.uniform(1.5, 3)
    which = chance.randint(0, 3)
    if which == 0:
        return [box(0, 0, length, 1)]
    if which == 1:
        return [[(0, 0), (length, 0), (length, 1), (1, 1), (1, length), (0, length)]]
    if which == 2:
        return [box(0, 0, length, 1), circle(chance.uniform(0.2, 0.8) * length, 0.5, 0.3, 32)]
    return [[(0, 0), (length, 0), (length, chance.uniform(0.3, 1)), (0, 1)]]


def tiny_holes(chance):
    outer = box(0, 0, 1, 1) if chance.random() < 0.5 else circle(0.5, 0.5, 0.5, 96)
    return with_holes(chance, outer, chance.randint(1, 4), lambda: circle(
        *place(chance, outer), 10 ** chance.uniform(-4, -1.5), 24), 0.05)


def near_holes(chance):
    """Returns a plate with two or three holes at small distances from each other or the side."""
    gap, a, b = 10 ** chance.uniform(-3, -1.3), chance.uniform(0.1, 0.2), chance.uniform(0.1, 0.2)
    outer = box(0, 0, 1, 1)
    loops = [outer, circle(a + gap if chance.random() < 0.5 else 0.3, 0.4, a, 48)]
    x = sum(p[0] for p in loops[1]) / 48 + a + b + gap
    return [*loops, circle(x, 0.4, b, 48)]


def valid(kind, chance):
    """Returns the curves of a kind; those that meet are made again."""
    while True:
        loops = kind(chance)
        if loops and are_valid(loops):
            return loops


def offsets(chance):
    """Returns a domain whose distance to the origin is up to 1e6 times its size."""
    far, scale = 10 ** chance.uniform(2, 6), 10 ** chance.uniform(-6, 6)
    angle, simple = chance.uniform(0, TURN), chance.choice((blobs, plates, convex, gears, sections))
    return [turned(loop, angle, scale * far * math.cos(angle), scale * far * math.sin(angle), scale)
            for loop in valid(simple, chance)]


def tilted(chance):
    """Returns a domain in a plane of any direction."""
    a, b = chance.uniform(0, TURN), chance.uniform(0.1, TURN / 2)
    simple = chance.choice((blobs, plates, rectilinear, slots, sections))
    across = (-math.sin(a), math.cos(a), 0.0)
    along = (math.cos(a) * math.cos(b), math.sin(a) * math.cos(b), math.sin(b))
    return [[tuple(x * p + y * q for p, q in zip(across, along)) for x, y in loop]
            for loop in valid(simple, chance)]


KINDS = (blobs, rectilinear, acute, convex, rings, plates, ellipses, slots, gears, profiles,
         lattices, spirals, combs, keyholes, letters, fractals, sections, slits, aspects, tiny_holes,
         near_holes, offsets, tilted)


def domain(seed):
    """Returns the name and the closed curves of one domain; the same for the same seed."""
    kind, chance = KINDS[seed % len(KINDS)], random.Random(seed)
    loops = kind(chance) if kind in (offsets, tilted) else valid(kind, chance)
    return f"{kind.__name__}_{seed}", loops
