"""Typical engineering domains as lists of closed curves."""

import math
import random


def circle(x, y, radius, count=48):
    return [(x + radius * math.cos(2 * math.pi * i / count),
             y + radius * math.sin(2 * math.pi * i / count)) for i in range(count)]


def arc(x, y, radius, begin, end, count=8):
    """Returns points of an arc; angles in degrees, both ends included."""
    return [(x + radius * math.cos(math.radians(begin + (end - begin) * i / count)),
             y + radius * math.sin(math.radians(begin + (end - begin) * i / count)))
            for i in range(count + 1)]


def box(left, bottom, right, top):
    return [(left, bottom), (right, bottom), (right, top), (left, top)]


def profile(thickness=0.12, count=60, blunt=False, place=(0.0, 0.0), chord=1.0, turn=0.0):
    """Returns a symmetric NACA profile of four digits; `blunt` keeps its open trailing edge; `turn`
    in degrees."""
    last = -0.1015 if blunt else -0.1036

    def half(s):
        return 5 * thickness * (0.2969 * math.sqrt(s) - 0.126 * s - 0.3516 * s ** 2
                                + 0.2843 * s ** 3 + last * s ** 4)
    stations = [0.5 * (1 - math.cos(math.pi * i / count)) for i in range(count + 1)]
    upper = [(s, half(s)) for s in reversed(stations)]
    lower = [(s, -half(s)) for s in stations[1:]]
    curve = upper + (lower if blunt else lower[:-1])
    c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    return [(place[0] + chord * (c * x - s * y), place[1] + chord * (s * x + c * y))
            for x, y in curve]


def bolts():
    """Returns a round flange with five bolt holes."""
    holes = [circle(0.65 * math.cos(2 * math.pi * i / 5), 0.65 * math.sin(2 * math.pi * i / 5), 0.1, 32)
             for i in range(5)]
    return [circle(0, 0, 1, 128), *holes]


def fillet_t():
    """Returns a T-junction with rounded inner corners and square ends."""
    return [[(-2, 0), (2, 0), (2, 1), *arc(0.9, 1.4, 0.4, 270, 180), (0.5, 3), (-0.5, 3),
             *arc(-0.9, 1.4, 0.4, 0, -90), (-2, 1)]]


def coast(count=2000, seed=3):
    """Returns a ragged coast around a bay: a closed curve with details of many scales."""
    chance = random.Random(seed)
    waves = [(k, chance.gauss(0, 0.35 / k ** 1.5), chance.uniform(0, 2 * math.pi))
             for k in range(2, 60)]
    curve = []
    for i in range(count):
        angle = 2 * math.pi * i / count
        radius = 1 + sum(a * math.cos(k * angle + phase) for k, a, phase in waves)
        curve.append((radius * math.cos(angle), 0.7 * radius * math.sin(angle)))
    return [curve]


def gear(teeth=12):
    """Returns a gear with straight teeth and a bore."""
    curve = []
    for i in range(teeth):
        for part, radius in ((0.0, 0.8), (0.2, 0.8), (0.3, 1.0), (0.7, 1.0), (0.8, 0.8)):
            angle = 2 * math.pi * (i + part) / teeth
            curve.append((radius * math.cos(angle), radius * math.sin(angle)))
    return [curve, circle(0, 0, 0.3)]


def solid_gear(teeth=12):
    return [gear(teeth)[0]]


def blade_passage():
    """Returns the passage between two blades of a cascade, with inlet and outlet."""
    def camber(x):
        return 0.35 * math.sin(math.pi * min(max(x, 0.0), 1.0)) - 0.25 * x
    stations = [-0.5 + 2.0 * i / 80 for i in range(81)]

    def thickness(x):
        return 0.12 * math.sqrt(max(x * (1 - x), 0.0)) if 0 <= x <= 1 else 0.0
    lower = [(x, camber(x) + thickness(x)) for x in stations]
    upper = [(x, camber(x) + 0.7 - thickness(x)) for x in reversed(stations)]
    return [lower + upper]


def naca_in_rectangle():
    return [box(-1, -1, 3, 1), profile()]


def sharp_profile_in_circle():
    return [circle(0.5, 0, 3, 96), profile(turn=-5)]


def three_elements():
    """Returns a wing with slat and flap."""
    return [box(-1.5, -1.5, 2.5, 1.5), profile(0.12, 40, place=(0, 0)),
            profile(0.1, 30, place=(-0.25, -0.12), chord=0.2, turn=25),
            profile(0.1, 30, place=(1.03, -0.06), chord=0.35, turn=-25)]


def twenty_holes():
    holes = [circle(x + 0.5, y + 0.5, 0.2, 24) for x in range(5) for y in range(4)]
    return [box(0, 0, 5, 4), *holes]


def slotted_link():
    """Returns a link with rounded ends and a slot between two pins."""
    return [[*arc(3, 0, 1, -90, 90, 24), *arc(0, 0, 1, 90, 270, 24)], circle(0, 0, 0.4),
            circle(3, 0, 0.4), [*arc(2, 0, 0.2, -90, 90), *arc(1, 0, 0.2, 90, 270)]]


DOMAINS = {function.__name__: function for function in (
    bolts, fillet_t, coast, gear, solid_gear, blade_passage, naca_in_rectangle,
    sharp_profile_in_circle, three_elements, twenty_holes, slotted_link)}
