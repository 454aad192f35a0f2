"""Writes docs/exact.md, a comparison of computed with exact values:

    python3 scripts/exact.py build/bin/crossfield > docs/exact.md
"""
import cmath
import json
import math
import pathlib
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "tests/corpus"))
import verified  # noqa: E402

PAGE = """# Exact and computed values

This table compares computed values with known ones. Sources: [the method](method.md), §5, §7 and §11, and, for images of the disk,
`tests/numerics/ExactFields.h`. `scripts/exact.py build/bin/crossfield` makes the page; the test `Program.Exact` recomputes it,
compares the values, and checks that the errors decrease with the mesh size.

| quantity | exact | computed for h = 0.1, 0.05, 0.025, unless stated otherwise |
| --- | --- | --- |
"""
SIZES = (0.1, 0.05, 0.025)
OPTIMUM = (3 / 11) ** 0.125


def on(radius, angle, quarter, hole=0.05):
    return (radius * math.cos(angle), radius * math.sin(angle), quarter, hole)


SQUARE = [on(0.6, 0.3 + i * math.pi / 2, 1) for i in range(4)]


def exact_energy(rows):
    """Returns W on the disk (docs/method.md §5.3); points may be on the circle."""
    total = 0.0
    for i, (x, y, k, _) in enumerate(rows):
        for j, (v, w, m, _) in enumerate(rows):
            b, c = complex(x, y), complex(v, w)
            if i != j:
                total -= math.pi * k * m * math.log(abs(b - c))
            if i != j or abs(b) < 1 - 1e-9:
                total -= math.pi * k * m * math.log(abs(1 - b * c.conjugate()))
    return total


def image(place, factor=complex(0.2, 0.1)):
    """Returns z + a z², which is injective on the disk for 2 |a| < 1."""
    return place + factor * place ** 2


def exact_image_energy(rows, factor=complex(0.2, 0.1)):
    """Returns W of the images of `rows` on the image of the disk under z + a z²
    (tests/numerics/ExactFields.h)."""
    total = exact_energy(rows) - 8 * math.pi * math.log(1 - abs(2 * factor) ** 2)
    for x, y, k, _ in rows:
        own = 2 if math.hypot(x, y) > 1 - 1e-9 else 1
        total += math.pi * (own * k * k - 8 * k) * math.log(abs(1 + 2 * factor * complex(x, y)))
    return total


def exact_ring_energy(rows, inner=0.4):
    """Returns W on the ring of outer radius 1, with the field of the holonomy defect
    (docs/method.md §5.3)."""
    powers = [inner ** (2 * n) for n in range(1, 40)]

    def theta(x):
        return math.log(abs(1 - x)) + sum(math.log(abs((1 - q * x) * (1 - q / x))) for q in powers)

    places = [complex(x, y) for x, y, _, _ in rows]
    quarters = [k for _, _, k, _ in rows]
    total = -16 * math.pi * math.log(inner)
    for i, (b, k) in enumerate(zip(places, quarters)):
        regular = (4 - k) * math.log(abs(b)) + 2 * k * sum(math.log(1 - q) for q in powers)
        for j, (c, m) in enumerate(zip(places, quarters)):
            regular += m * (theta(b * c.conjugate()) + (theta(b / c) if i != j else 0))
        total -= 4 * math.pi * k * math.log(abs(b)) + math.pi * k * regular
    defect = math.remainder(sum(k * cmath.phase(b) for b, k in zip(places, quarters)), 2 * math.pi)
    return total - math.pi * defect ** 2 / math.log(inner)


class Run:
    """Runs of the program in a temporary folder."""

    def __init__(self, program, folder):
        self.program = pathlib.Path(program).resolve()
        self.folder = pathlib.Path(folder)

    def __call__(self, command, domain, rows, *more):
        (self.folder / "rows.csv").write_text("x,y,quarter_index,radius\n" + "".join(
            ",".join("%.17g" % value for value in row) + "\n" for row in rows), encoding="utf-8")
        result = subprocess.run(
            [self.program, command, domain, "-s", "rows.csv", "--json", "-", *map(str, more)],
            cwd=self.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=True)
        return json.loads(result.stdout)

    def polygon(self, size, scale=1.0):
        """Writes a polygon of the unit circle with sides of about this length; returns their
        number."""
        count = round(2 * math.pi / size)
        (self.folder / "disk.csv").write_text("x,y\n" + "".join("%.17g,%.17g\n" % (
            scale * math.cos(2 * math.pi * i / count), scale * math.sin(2 * math.pi * i / count))
            for i in range(count)), encoding="utf-8")
        return count

    def loops(self, name, *loops):
        """Writes closed curves of complex numbers as a domain."""
        (self.folder / name).write_text("x,y,loop\n" + "".join(
            "%.17g,%.17g,%d\n" % (place.real, place.imag, i)
            for i, loop in enumerate(loops) for place in loop), encoding="utf-8")

    def error_of_h(self, given, size):
        """Returns the maximum error of H at the vertices of the mesh; H has the area mean 0
        (docs/method.md §11.2)."""
        self("hfield", "builtin:disk", given, "--size", size, "-o", "h.vtu")
        arrays = verified.read(self.folder / "h.vtu")
        largest = 0.0
        for (x, y, _), found in zip(arrays["Points", "Points"], arrays["PointData", "H"]):
            z = complex(x, y)
            exact = sum(k / 4 * (math.log(abs(z - b)) + math.log(abs(1 - b.conjugate() * z))
                                 - (abs(b) ** 2 - 1) / 2)
                        for k, b in ((k, complex(v, w)) for v, w, k, _ in given))
            largest = max(largest, abs(found - exact))
        return largest

    def energy(self, domain, rows, *more):
        return self("energy", domain, rows, *more)["configurations"][0]

    def on_circle(self, size, part, inside, quarters):
        """Returns W and its exact value for points on the polygon: at vertices (0), in the middle
        of sides (1/2)."""
        count = self.polygon(size)
        given, exact = list(inside), list(inside)
        for angle, quarter in quarters:
            first = 2 * math.pi / count * math.floor(angle * count / (2 * math.pi))
            step = 2 * math.pi / count
            ends = [complex(math.cos(t), math.sin(t)) for t in (first, first + step)]
            place = (1 - part) * ends[0] + part * ends[1]
            given.append((place.real, place.imag, quarter, 0.05))
            exact.append(on(1, first + part * step, quarter))
        found = self.energy("disk.csv", given, "--size", size)
        return found, exact_energy(exact)


def row(what, exact, found, digits=4, angle=False):
    """Returns name, exact value and computed values as text, and the errors of the computed
    values."""
    errors = [abs(math.remainder(value - exact, 2 * math.pi) if angle else value - exact)
              for value in found]
    text = ", ".join("%.*f" % (digits, value) for value in found)
    return what, "%.*f" % (digits, exact), text, errors


def circle(radius, size):
    """Returns the vertices of a polygon of a circle with sides of about this length."""
    count = round(2 * math.pi * radius / size)
    return [cmath.rect(radius, 2 * math.pi * i / count) for i in range(count)]


def images(rows):
    """Returns the rows with their positions mapped by `image`."""
    return [(image(complex(x, y)).real, image(complex(x, y)).imag, k, r) for x, y, k, r in rows]


def disk_rows(run):
    """Yields the rows of W and H on the disk."""
    inside = [(0.1, 0.5, 1, 0.05), (-0.5, -0.1, 1, 0.05), (0.3, -0.5, 1, 0.05)]
    values = []
    for size in SIZES:
        run.polygon(size)
        values.append(run.energy("disk.csv", SQUARE, "--size", size)["renormalized_energy"])
    yield row("W, disk, four k = 1 at radius 0.6", exact_energy(SQUARE), values)
    for part, place in ((0.0, "at a vertex"), (0.5, "on a side")):
        # The position depends on the polygon: the exact value is that of the finest; each error
        # uses its own.
        found = [run.on_circle(size, part, inside, [(0.3, 1)]) for size in SIZES]
        exact = found[-1][1]
        yield row("W, disk, one k = 1 on the circle, " + place, exact,
                  [exact + value["renormalized_energy"] - own for value, own in found])
        yield row("its coefficient of log(1/ρ), 5π", 5 * math.pi,
                  [value["logarithm_coefficient"] for value, _ in found], 8)
    # On the same polygon, of 126 sides; the first two are one configuration, turned by half a side.
    polygon = 2 * math.pi / run.polygon(0.05)
    for radius, part, place in ((0.7, 0.0, "at a vertex"), (0.7, 0.5, "on a side"), (0.2, 0.0, "at a vertex")):
        angle = part * polygon
        three = [on(radius, angle + turn * math.pi / 2, 1, 0.02) for turn in (1, 2, 3)]
        found = run.on_circle(0.05, part, three, [(angle, 1)])
        yield row("W, disk, one k = 1 on the circle, %s, three at radius %.1f, h = 0.05" % (place, radius),
                  found[1], [found[0]["renormalized_energy"]])
    mixed = [on(0.5, 1.0, 2), on(0.4, 3.3, -1)]
    quarters = [(0.3, 1), (1.6, -1), (2.5, 1), (4.4, 2)]
    found = [run.on_circle(size, 0.0, mixed, quarters) for size in SIZES]
    yield row("W, disk, k = 2, −1 inside, 1, −1, 1, 2 on the circle", found[-1][1],
              [found[-1][1] + value["renormalized_energy"] - own for value, own in found])
    five = [(0.31, 0.42, 2, 0.05), (-0.52, 0.18, 1, 0.05), (-0.11, -0.61, 1, 0.05), (0.47, -0.33, 1, 0.05),
            (0.08, 0.05, -1, 0.05)]
    yield row("largest error of H at vertices, disk, k = 2, 1, 1, 1, −1 inside, h = 0.08, 0.056, 0.04, 0.028", 0.0,
              [run.error_of_h(five, size) for size in (0.08, 0.056, 0.04, 0.028)], 6)


def image_and_ring_rows(run):
    """Yields the rows of an image of the disk, of the ring and of its image."""
    # Both points on the circle are vertices of all three polygons.
    on_image = [(0.31, 0.42, 3, 0.05), (-0.52, 0.18, -2, 0.05), (-0.11, -0.61, 4, 0.05),
                on(1, math.pi, 1), on(1, 1.5 * math.pi, -2)]
    values = []
    for count in (64, 128, 256):
        run.loops("image.csv", [image(cmath.rect(1, 2 * math.pi * i / count)) for i in range(count)])
        values.append(run.energy("image.csv", images(on_image), "--size", 2 * math.pi / count)["renormalized_energy"])
    yield row("W, image of the disk under z + (0.2 + 0.1 i) z², images of k = 3, −2, 4 inside, 1, −2 on the circle",
              exact_image_energy(on_image), values)
    pair = [(0.75, 0.05, 1, 0.05), (-0.1, 0.65, -1, 0.05)]
    exact = math.remainder(math.atan2(0.05, 0.75) - math.atan2(0.65, -0.1), 2 * math.pi)
    yield row("holonomy defect of a ring, Σ k arg b", exact,
              [run("hfield", "builtin:ring", pair, "--size", size)["holonomy_defect"][0]
               for size in SIZES], 5, True)
    values = []
    for size in SIZES:
        run.loops("ring.csv", *([image(place) for place in circle(radius, size)] for radius in (1, 0.4)))
        values.append(run("hfield", "ring.csv", images(pair), "--size", size)["holonomy_defect"][0])
    yield row("and of the image of a ring under the same", exact, values, 5, True)
    three = [(0.0, 0.8, 2, 0.05), (0.55, 0.1, -1, 0.05), (-0.5, -0.2, -1, 0.05)]
    for given, quarters in ((pair, "1, −1"), (three, "2, −1, −1")):
        yield row("W, ring, k = %s, with the field of the defect" % quarters, exact_ring_energy(given),
                  [run("hfield", "builtin:ring", given, "--size", size)["renormalized_energy"] for size in SIZES])


def optimum_and_scale_rows(run):
    """Yields the rows of the optimal radius and of other scales."""
    values = []
    for size in SIZES:
        run.polygon(size)
        moved = run("optimize", "disk.csv", [on(0.4, t, 1) for t in (0.1, 1.5, 3.4, 4.9)],
                    "--size", size)
        values.append(sum(math.hypot(one["x"], one["y"]) for one in moved["singularities"]) / 4)
    yield row("radius of the four optima, (3/11)^(1/8)", OPTIMUM, values, 5)
    values = []
    for scale in (1e-50, 1e35, 1e50):
        run.polygon(0.04, scale)
        large = [(scale * x, scale * y, k, scale * r) for x, y, k, r in SQUARE]
        found = run("hfield", "disk.csv", large, "--size", 0.04 * scale)["renormalized_energy"]
        values.append(found - 4 * math.pi * math.log(scale))
    yield row("W less 4π log(scale) for scales 1e−50, 1e35, 1e50, h = 0.04", exact_energy(SQUARE), values)


def hole_rows(run):
    """Yields the rows of the energy of holes and of its bounds."""
    centre = [(0.0, 0.0, 4, 0.3)]
    bounds = []
    for size in (0.06, 0.03):
        run.polygon(size)
        bounds.append(run.energy("disk.csv", centre, "--size", size))
    gaps = []
    for size in (0.025, 0.0125, 0.00625):
        found = run.energy("builtin:square", [(0.25, 0.25, 1, 0.1), (0.75, 0.75, -1, 0.1)], "--size", size)
        gaps.append(found["energy_upper_bound"] - found["energy_lower_bound"])
    exact = 16 * math.pi * math.log(1 / 0.3)
    name = "E of a hole ρ = 0.3 of k = 4 in the centre, 16π log(1/ρ), h = 0.06, 0.03"
    yield row(name, exact, [value["energy"] for value in bounds])
    yield row("and the gap between its bounds", 0.0,
              [value["energy_upper_bound"] - value["energy_lower_bound"] for value in bounds])
    yield row("gap of the bounds on a square, k = ±1 of ρ = 0.1, h = 0.025, 0.0125, 0.00625", 0.0, gaps)


def rows(run):
    """Yields all rows of the table, as `row` returns them."""
    for part in (disk_rows, image_and_ring_rows, optimum_and_scale_rows, hole_rows):
        yield from part(run)


def table(program):
    with tempfile.TemporaryDirectory() as folder:
        return list(rows(Run(program, folder)))


if __name__ == "__main__":
    print(PAGE + "\n".join("| %s | %s | %s |" % entry[:3] for entry in table(sys.argv[1])))
