"""Checks the arrays of the seamless map in a file, recomputed from the points alone."""
import numpy as np

from report import ROUNDING


def _cross(a, b):
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


#: i to the power of 0 to 3, without rounding.
TURNS = np.array([1, 1j, -1, -1j])


def check_map(data, report):
    """Checks areas, orientation, seams, sides and angles."""
    uv, vertex = data.at_points["UV"], data.at_points["VertexId"]
    corners = uv[data.triangles]
    step = np.roll(corners, -1, axis=1) - corners
    twice = _cross(step[:, 0], -step[:, 2])
    report.true("no triangle is turned over", bool((twice > 0).all()))
    report.equal("Flips", data.value("Flips"), int((twice <= 0).sum()))
    places = data.points[data.triangles]
    normal = np.cross(places[:, 1] - places[:, 0], places[:, 2] - places[:, 0])
    area = np.linalg.norm(normal, axis=1).sum()
    report.bound("the area is that of the domain", abs(twice.sum() - area) / area, 1e-10,
                 "sums of as many rounded areas as there are triangles")
    extent = np.ptp(uv, axis=0).max()

    # Copies of a vertex coincide; across a seam w' = i^r w + t.
    first = {}
    for point, number in enumerate(vertex):
        first.setdefault(number, point)
    same = np.array([first[number] for number in vertex])
    report.true("copies of a vertex are at its place",
                np.array_equal(data.points, data.points[same]))
    w = uv[:, 0] + 1j * uv[:, 1]
    rotation = TURNS[np.atleast_1d(data.field.get("SeamRotation", np.zeros(0, int)))]
    shift = data.field.get("SeamTranslation", np.zeros((0, 2))).reshape(-1, 2)
    shift = shift[:, 0] + 1j * shift[:, 1]
    sides = {}
    seam = data.cells["Seam"][0]
    for t, triangle in enumerate(data.triangles):
        for i in range(3):
            a, b = triangle[i], triangle[(i + 1) % 3]
            sides[vertex[a], vertex[b]] = (a, b, seam[t, i])
    worst, paired = 0.0, True
    for (va, vb), (a, b, code) in sides.items():
        other = sides.get((vb, va))
        if other is None:
            continue
        paired = paired and other[2] == -code
        for mine, theirs in ((a, other[1]), (b, other[0])):
            if code == 0:
                paired = paired and mine == theirs
            elif code > 0:
                carried = rotation[code - 1] * w[mine] + shift[code - 1]
                worst = max(worst, abs(carried - w[theirs]))
    report.true("seams are the same from both sides", bool(paired))
    report.bound("seams close", worst / extent, 0.0, "coordinates are multiples of a power of two")

    lines = w[data.lines]
    along = (lines[:, 1] - lines[:, 0]) * TURNS.conj()[data.cells["Direction"][1]]
    report.true("sides have their directions", bool((along.real > 0).all()))
    report.bound("sides are straight", np.abs(along.imag).max() / extent, 0.0,
                 "coordinates are multiples of a power of two")

    angle = np.zeros(vertex.max() + 1)
    for i in range(3):
        to, back = step[:, i], -step[:, i - 1]
        at = np.arctan2(_cross(to, back), (to * back).sum(axis=1))
        angle += np.bincount(vertex[data.triangles[:, i]], at, len(angle))
    quarters = np.full(len(angle), 4)
    quarters[vertex[data.lines]] = 2
    index = np.zeros(len(angle), int)
    index[vertex] = data.at_points["QuarterIndex"]
    worst = np.abs(angle - (quarters - index) * np.pi / 2).max()
    # The rounding of an angle is that of the coordinates, relative to the shortest side.
    shortest = np.sqrt((step ** 2).sum(axis=2)).min()
    report.bound("angles add up to (4 - k) or (2 - k) quarter turns", worst,
                 1e3 * ROUNDING * extent / shortest, "rounding of coordinates")
