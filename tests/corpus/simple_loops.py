"""Checks that closed curves bound a domain: no curve meets itself or another, and every curve but
the first lies inside the first and outside of the others."""

import math


def sides(loop):
    return list(zip(loop, loop[1:] + loop[:1]))


def area2(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def cross(p, q):
    """Reports whether two segments without a common end meet."""
    (a, b), (c, d) = p, q
    if max(a[0], b[0]) < min(c[0], d[0]) or max(c[0], d[0]) < min(a[0], b[0]) or \
            max(a[1], b[1]) < min(c[1], d[1]) or max(c[1], d[1]) < min(a[1], b[1]):
        return False
    return area2(a, b, c) * area2(a, b, d) <= 0 and area2(c, d, a) * area2(c, d, b) <= 0


def contains(loop, point):
    x, y = point
    return sum((a[1] > y) != (b[1] > y) and x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
               for a, b in sides(loop)) % 2 == 1


def are_valid(loops):
    """Reports whether the curves bound a connected domain; the first is the outer one."""
    every = sorted((min(a[0], b[0]), a, b) for loop in loops for a, b in sides(loop))
    for i, (_, a, b) in enumerate(every):
        if a == b:
            return False
        right = max(a[0], b[0])
        for left, c, d in every[i + 1:]:
            if left > right:
                break
            if len({a, b, c, d}) < 4:
                if {a, b} == {c, d}:
                    return False
            elif cross((a, b), (c, d)):
                return False
    return all(contains(loops[0], hole[0]) and not any(
        contains(other, hole[0]) for other in loops[1:] if other is not hole) for hole in loops[1:])


def distance(point, side):
    (ax, ay), (bx, by) = side
    dx, dy = bx - ax, by - ay
    t = ((point[0] - ax) * dx + (point[1] - ay) * dy) / (dx * dx + dy * dy)
    t = min(1.0, max(0.0, t))
    return math.hypot(point[0] - ax - t * dx, point[1] - ay - t * dy)


def clearance(loops, hole):
    """Returns the distance of a curve to the others, for curves that do not meet."""
    others = [side for loop in loops for side in sides(loop)]
    own = sides(hole)
    return min(min(distance(p, side) for p in hole for side in others),
               min(distance(a, side) for a, _ in others for side in own))
