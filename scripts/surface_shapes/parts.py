"""Sheets with holes and parts with sharp edges."""
import math

import numpy as np

from .triangles import circle, cleaned, divided, extruded, surface, trimmed


def lifted(places, height):
    return np.column_stack([places, height(*places.T)])


def panel():
    """Returns a bent plate with three holes."""
    step = 0.02
    holes = [circle(x, y, r, step) for x, y, r in ((0.3, 0.3, 0.1), (0.7, 0.35, 0.14), (0.45, 0.72, 0.12))]
    places, triangles = trimmed(divided([(0, 0), (1, 0), (1, 1), (0, 1)], step), holes, step)
    return surface(lifted(places, lambda x, y: 0.35 * np.sin(2.2 * x) * np.cos(1.8 * y)), triangles)


def window(x, y, width, height, step):
    """Returns a rounded rectangle, with points at equal distances."""
    angles = np.linspace(0, 2 * math.pi, 2001)
    half = [np.sign(part) * np.abs(part) ** 0.55 for part in (np.cos(angles), np.sin(angles))]
    along = np.concatenate([[0], np.cumsum(np.hypot(width / 2 * np.diff(half[0]), height / 2 * np.diff(half[1])))])
    places = np.linspace(0, along[-1], round(along[-1] / step), endpoint=False)
    return [(x + width / 2 * a, y + height / 2 * b) for a, b in zip(*(np.interp(places, along, part) for part in half))]


def car_body():
    """Returns the side of a car: a doubly curved sheet with wheel arches and named holes, two windows and a filler cap."""
    step = 0.035

    def top(x):
        return 0.84 + 0.03 * x - 0.012 * x * x + 0.5 / (1 + math.exp(-(x - 0.55) / 0.13)) / (1 + math.exp((x - 2.95) / 0.2))
    outline = [(0.0, 0.3)]
    for middle in (0.85, 3.35):
        outline += [(middle - 0.36 * math.cos(a), 0.3 + 0.36 * math.sin(a)) for a in (math.pi * k / 32 for k in range(33))]
    outline.append((4.2, 0.3))
    outline += [(x, top(x)) for x in (4.2 * (1 - k / 120) for k in range(121))]
    names = ("rear_window", "front_window", "filler_cap")
    holes = [window(1.33, 1.05, 0.74, 0.3, step), window(2.2, 1.05, 0.78, 0.3, step), circle(0.42, 0.72, 0.09, 0.02)]
    outline = divided(outline, step)
    places, triangles = trimmed(outline, holes, step)
    lines, first = [], len(outline)
    for name, hole in zip(names, holes):
        ids = list(range(first, first + len(hole)))
        lines.append((name, ids + ids[:1]))
        first += len(hole)
    bulge = 0.85 - 0.16 * (places[:, 1] - 0.6) ** 2 / 0.3 - 0.035 * (places[:, 0] - 2.1) ** 2
    return surface(np.column_stack([places[:, 0], -bulge, places[:, 1]]), triangles, lines=lines)


def dome():
    """Returns a dome of steel with a window of glass at its top."""
    step = 0.06
    window_edge = circle(0.2, 0.1, 0.4, step)
    places, triangles = trimmed(circle(0, 0, 1, step), [], step, kept=[window_edge])
    middle = places[triangles].mean(axis=1) - (0.2, 0.1)
    regions = ["glass" if math.hypot(*at) < 0.4 else "steel" for at in middle]
    return surface(lifted(places, lambda x, y: 0.7 * (1 - x * x - y * y)), triangles, regions=regions)


def box():
    """Returns a box with a hole through it."""
    step = 0.15
    return extruded(divided([(0, 0), (3, 0), (3, 2), (0, 2)], step), [circle(1.3, 1, 0.5, step)], step, 1.05)


def can():
    return extruded(circle(0, 0, 1, 0.12), [], 0.12, 2.4)


def gear():
    """Returns a gear wheel with ten teeth and a bore."""
    teeth, outline, step = 10, [], 0.13
    for tooth in range(teeth):
        for part, radius in ((-0.3, 1.5), (-0.16, 2.0), (0.16, 2.0), (0.3, 1.5)):
            angle = 2 * math.pi * (tooth + part) / teeth
            outline.append((radius * math.cos(angle), radius * math.sin(angle)))
    return extruded(divided(outline, step), [circle(0, 0, 0.6, step)], step, 0.78)


def flange():
    """Returns a straight piece of a pipe with a flange: a ring with a step of its radius."""
    step, count = 0.1, 64
    profile = divided([(0.6, 0.0), (1.3, 0.0), (1.3, 0.3), (0.8, 0.3), (0.8, 1.8), (0.6, 1.8)], step)
    angles = 2 * math.pi * np.arange(count) / count
    points = np.concatenate([[(r * math.cos(a), r * math.sin(a), z) for r, z in profile] for a in angles])
    triangles, size = [], len(profile)
    for k in range(count):
        for i in range(size):
            a, b = k * size + i, k * size + (i + 1) % size
            c, d = ((k + 1) % count) * size + (i + 1) % size, ((k + 1) % count) * size + i
            triangles += [(a, d, c), (a, c, b)]
    return cleaned(surface(points, triangles))
