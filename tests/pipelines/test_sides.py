"""crossfield quads --names, --count, --progression, --size-at: what is prescribed holds, and what cannot hold is
refused in one sentence, without files."""
import json
import math
import pathlib
import re
import shutil
import subprocess
import time
import unittest

from program import SENTENCE, ProgramTest


def write_domain(path, loops, array="Side", numbers=False):
    """Writes loops of (x, y, name of the segment that starts there) as a .vtp file in ASCII."""
    points = [point for loop in loops for point in loop]
    cells, first = [], 0
    for loop in loops:
        cells += [(first + i, first + (i + 1) % len(loop)) for i in range(len(loop))]
        first += len(loop)
    names = [name for _, _, name in points]
    if numbers:
        values = '<DataArray type="Int32" Name="%s" format="ascii">%s</DataArray>' % (array, " ".join(names))
    else:
        codes = " ".join(str(code) for name in names for code in [*name.encode(), 0])
        values = ('<DataArray type="String" Name="%s" NumberOfTuples="%d" format="ascii">%s</DataArray>'
                  % (array, len(names), codes))
    path.write_text("""<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64"><PolyData>
<Piece NumberOfPoints="%d" NumberOfVerts="0" NumberOfLines="%d" NumberOfStrips="0" NumberOfPolys="0">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">%s</DataArray></Points>
<CellData>%s</CellData>
<Lines><DataArray type="Int64" Name="connectivity" format="ascii">%s</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">%s</DataArray></Lines>
</Piece></PolyData></VTKFile>
""" % (len(points), len(cells), " ".join("%.17g %.17g 0" % (x, y) for x, y, _ in points), values,
       " ".join("%d %d" % cell for cell in cells), " ".join(str(2 * i + 2) for i in range(len(cells)))))


def circle(count, radius, centre, names):
    """Returns a polygon; `names` gives the name of segment i."""
    return [(centre[0] + radius * math.cos(2 * math.pi * i / count),
             centre[1] + radius * math.sin(2 * math.pi * i / count), names(i)) for i in range(count)]


def passage(count=40, angle=0.0):
    """Returns the outline of a passage whose sides low and high are wavy translates, or a sector of a ring whose
    sides are rotated by an angle."""
    wave = [(1 + 2 * i / count, 0.1 * math.sin(5 * i / count)) for i in range(count + 1)]
    if angle:
        wave = [(x * math.cos(0.3 + y), x * math.sin(0.3 + y)) for x, y in wave]
        high = [(x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle)) for x, y in wave]
    else:
        high = [(x + 0.2, y + 1) for x, y in wave]
    return ([(x, y, "low" if i < count else "outlet") for i, (x, y) in enumerate(wave)] +
            [(x, y, "high" if i < count else "inlet") for i, (x, y) in enumerate(reversed(high))])


RECTANGLE = [(0, 0, "bottom"), (3, 0, "right"), (3, 2, "top"), (0, 2, "left")]


class Sides(ProgramTest):
    def setUp(self):
        super().setUp()
        write_domain(self.folder / "plate.vtp", [RECTANGLE, circle(64, 0.4, (1.4, 1.0), lambda i: "hole")])
        write_domain(self.folder / "rectangle.vtp", [RECTANGLE])

    def report(self, domain, *arguments):
        return json.loads(self.succeed("quads", domain, "-o", "quads.vtu", "--json", "-", *arguments))

    def edges(self, domain, *arguments):
        return {side["name"]: side["edges"] for side in self.report(domain, *arguments)["sides"]}

    def test_counts_that_contradict_the_other_sides_are_refused_early(self):
        """Smoothing took 20 s, and quads stayed inverted; the remedies in the message work."""
        channel = pathlib.Path(__file__).resolve().parents[1] / "data" / "layers" / "cylinder.vtp"
        begin = time.time()
        says = self.refuse("quads", channel, "-o", "quads.vtu", "--count", "outlet:400", says=["400 edges on side 'outlet'", "more quads"])
        self.assertLess(time.time() - begin, 10)
        nearer = re.search(r"nearer to (\d+)", says)[1]
        for remedy in (("--count", "outlet:" + nearer), ("--count", "outlet:400", "--quads", "20000")):
            self.assertEqual(self.report(channel, *remedy)["inverted"], 0)

    def test_periodic_sides_have_matching_nodes(self):
        # so many points that the program would remove some of them
        write_domain(self.folder / "passage.vtp", [passage(2000), circle(40, 0.15, (2.1, 0.55), lambda i: "hole")])
        write_domain(self.folder / "sector.vtp", [passage(angle=0.7)])
        report = self.report("passage.vtp", "--periodic", "low:high", "--quads", "300")
        [pair] = report["periodic"]
        self.assertEqual([pair[key] for key in ("first", "second", "kind", "angle")], ["low", "high", "translation", 0])
        self.assertLess(math.dist([pair["vector"][axis] for axis in "xyz"], (0.2, 1, 0)), 1e-12)
        self.assertLessEqual(pair["mismatch"], 1e-12)
        sides = {side["name"]: side for side in report["sides"]}
        self.assertEqual([sides["low"]["edges"], sides["high"]["edges"]], [pair["edges"]] * 2)
        self.assertAlmostEqual(sides["low"]["length"], sides["high"]["length"], delta=1e-12)
        arguments = ["--periodic", "high:low", "--quads", "300", "--layers", "inlet:0.005,1.3", "--count", "low:25"]
        [pair] = self.report("sector.vtp", *arguments)["periodic"]
        self.assertEqual([pair["kind"], pair["edges"]], ["rotation", 25])
        self.assertAlmostEqual(pair["angle"], -0.7, delta=1e-13)
        self.assertLess(math.dist([pair["centre"][axis] for axis in "xyz"], (0, 0, 0)), 1e-13)
        self.assertLessEqual(pair["mismatch"], 1e-12)
        text = self.succeed("quads", "sector.vtp", "-o", "a.msh", "--order", "2", "--verbose", *arguments)
        self.assertIn("periodic sides 'high' and 'low': 25 edges, rotation by -40.107", text)
        links = (self.folder / "a.msh").read_text().split("$Periodic\n")[1].split()
        self.assertEqual(int(links[21]), 2 * 25 + 1, "all nodes of the side")
        if shutil.which("gmsh"):
            subprocess.run(["gmsh", "a.msh", "-save", "-o", "b.msh"], cwd=self.folder, check=True, capture_output=True)
            again = (self.folder / "b.msh").read_text().split("$Periodic\n")[1].split()
            self.assertEqual(again[:4] + again[21:22], links[:4] + links[21:22], "as gmsh reads it")

    def test_periodic_sides_with_different_layers_match(self):
        write_domain(self.folder / "passage.vtp", [passage(), circle(40, 0.15, (2.1, 0.55), lambda i: "hole")])
        for layers in (["low:0.01,1.2"], ["low:0.01,1.2", "high:0.02,1.2"]):
            report = self.report("passage.vtp", "--periodic", "low:high", *[x for one in layers for x in ("--layers", one)])
            self.assertLessEqual(report["periodic"][0]["mismatch"], 1e-12)
            self.assertEqual(len(report["layers"]), len(layers))

    def test_sides_that_are_no_images_are_refused(self):
        write_domain(self.folder / "passage.vtp", [passage(), circle(40, 0.15, (2.1, 0.55), lambda i: "hole")])
        for pair, reason in (("low:inlet", "The sides 'low' and 'inlet' are not images of each other"),
                             ("low:wall", "The boundary has no side 'wall' for a periodic pair"),
                             ("low:low", "The side 'low' is paired with itself"),
                             ("low:hole", "The side 'hole' is a closed curve"),
                             ("low", "--periodic: 'low' has no name of a side or no value")):
            self.assertIn(reason, self.refuse("quads", "passage.vtp", "-o", "q.vtu", "--periodic", pair))
        self.assertIn("is in two periodic pairs", self.refuse(
            "quads", "passage.vtp", "-o", "q.vtu", "--periodic", "low:high", "--periodic", "inlet:low"))
        # strips of quads lead from a to both b and the side above it
        step = [(0, 0, "low"), (3, 0, "b"), (3, 2, "step"), (1.5, 1.5, "above"), (1.5, 2.5, "high"), (0, 2, "a")]
        write_domain(self.folder / "step.vtp", [step])
        self.assertIn("The periodic pair a:b fits no mesh of these singularities; leave it out.",
                      self.refuse("quads", "step.vtp", "-o", "q.vtu", "--periodic", "a:b"))
        self.assertIn("have different numbers", self.refuse(
            "quads", "passage.vtp", "-o", "q.vtu", "--periodic", "low:high", "--count", "low:20", "--count", "high:22"))

    def test_sides_have_given_or_generated_names(self):
        report = self.report("plate.vtp")
        sides = {side["name"]: side for side in report["sides"]}
        self.assertEqual(set(sides), {"bottom", "right", "top", "left", "hole"})
        self.assertAlmostEqual(sides["bottom"]["length"], 3)
        self.assertAlmostEqual(sides["left"]["length"], 2)
        self.assertEqual(set(self.edges("builtin:l-shape")), {"outer%d" % i for i in range(6)})
        self.assertEqual(set(self.edges("builtin:disk")), {"outer0"})
        self.assertEqual(set(self.edges("builtin:ring")), {"outer0", "hole0"})

    def test_names_may_be_integers_of_any_array_and_survive_a_round_trip(self):
        write_domain(self.folder / "numbers.vtp", [[(x, y, str(i + 7)) for i, (x, y, _) in enumerate(RECTANGLE)]],
                     "Patch", numbers=True)
        edges = self.edges("numbers.vtp", "--names", "Patch")
        self.assertEqual(set(edges), {"7", "8", "9", "10"})
        self.assertEqual(self.edges("quads.vtu", "--count", "8:11")["8"], 11)

    def test_names_change_on_smooth_curves_and_survive_thinning(self):
        """The default thins 5000 points; the change stays where it is."""
        write_domain(self.folder / "disk.vtp",
                     [circle(5000, 1, (0, 0), lambda i: "a" if i < 613 else "b" if i < 3217 else "c")])
        report = self.report("disk.vtp", "--quads", "400")
        lengths = {side["name"]: side["length"] for side in report["sides"]}
        for name, part in (("a", 613), ("b", 2604), ("c", 1783)):
            # chords are shorter than the arcs
            self.assertAlmostEqual(lengths[name] / (2 * math.pi * part / 5000), 1, delta=0.01)

    def test_counts_hold(self):
        for arguments in (("hole:24",), ("hole:27", "bottom:31"), ("left:9", "right:14"), ("top:40",)):
            options = [word for text in arguments for word in ("--count", text)]
            for more in ((), ("--merge", "coarse"), ("--sizing", "uniform")):
                edges = self.edges("plate.vtp", "--quads", "500", *options, *more)
                for text in arguments:
                    name, count = text.split(":")
                    self.assertEqual(edges[name], int(count), (arguments, more))

    def test_lengths_and_sizes_hold(self):
        edges = self.edges("rectangle.vtp", "--size", "0.2", "--progression", "bottom:0.05,0.3")
        # 1 + ln 6 / ln(2.95 / 2.7)
        self.assertEqual(edges["bottom"], 21)
        edges = self.edges("plate.vtp", "--size", "0.15", "--size-at", "hole:0.05")
        self.assertTrue(0.8 <= 2 * math.pi * 0.4 / edges["hole"] / 0.05 <= 1.2, edges)
        coarse = self.report("rectangle.vtp", "--size", "0.3")["quads"]
        self.assertGreater(self.report("rectangle.vtp", "--size", "0.3", "--max-size", "0.2")["quads"], 2 * coarse)
        self.assertLess(self.report("rectangle.vtp", "--size", "0.1", "--min-size", "0.2")["quads"], 200)
        self.assertEqual(self.edges("rectangle.vtp", "--progression", "top:both:0.2", "--count", "top:20")["top"], 20)

    def test_sizes_near_positions_and_inside_sides(self):
        report = self.report("plate.vtp", "--size", "0.2", "--size-near", "0.3,0.3:0.04,0.1")
        target = report["size_target"]
        self.assertGreaterEqual(target["area_share"], 0.95, target)
        self.assertGreaterEqual(target["quad_share"], 0.9, target)
        self.assertEqual(target["factor"], 1)
        self.assertEqual([side["name"] for side in target["sides"]], ["0.3,0.3"])
        self.assertAlmostEqual(target["sides"][0]["median"], 1, delta=0.25)
        self.assertGreater(target["largest_jump"], 1)
        # a number is met, and where it cannot be with these sizes they are multiplied
        many = self.report("plate.vtp", "--quads", "2000", "--size-at", "hole:0.04")
        self.assertAlmostEqual(many["quads"], 2000, delta=100)
        self.assertEqual(many["size_target"]["factor"], 1)
        few = self.report("plate.vtp", "--quads", "150", "--size-at", "hole:0.03")
        self.assertAlmostEqual(few["quads"], 150, delta=8)
        self.assertGreater(few["size_target"]["factor"], 1.1)
        self.assertGreater(self.report("plate.vtp", "--size-at", "hole:0.03")["quads"], 500)
        inside = self.report("plate.vtp", "--size", "0.3", "--size-in", "hole:0.06")
        self.assertAlmostEqual(inside["size_target"]["sides"][0]["median"], 1, delta=0.25)
        self.assertNotIn("size_target", self.report("plate.vtp", "--size", "0.2"))

    def test_impossible_prescriptions_are_one_sentence_and_write_nothing(self):
        for domain, arguments, words in (
                ("rectangle.vtp", "--count bottom:24 --count top:11",
                 "bottom:24 and top:11 are sides of one strip of quads; give equal numbers or leave one out"),
                ("rectangle.vtp", "--count bottom:24 --count left:7 --count right:8", "left:7 and right:8 are sides"),
                ("plate.vtp", "--count hole:3", "hole:3 fits no mesh of these singularities; give hole:4"),
                ("plate.vtp", "--count bottom:1", "bottom:1 fits no mesh"),
                ("plate.vtp", "--count nowhere:3", "no side 'nowhere'; give 'bottom', 'right', 'top', 'left' or 'hole'"),
                ("plate.vtp", "--count hole:2.5", "'2.5' of side 'hole'"),
                ("plate.vtp", "--count hole:0", "'0' of side 'hole'"),
                ("plate.vtp", "--count hole:-4", "'-4' of side 'hole'"),
                ("plate.vtp", "--count hole:many", "'many' of side 'hole'"),
                ("plate.vtp", "--count hole:20 --count hole:20", "prescribed twice"),
                ("plate.vtp", "--count hole:20 --size-at hole:0.1", "more than one of"),
                ("plate.vtp", "--count bottom:20 --progression bottom:0.1,0.2", "more than one of"),
                ("plate.vtp", "--progression hole:2", "'hole' is a closed curve"),
                ("plate.vtp", "--progression bottom:-2", "'-2' of side 'bottom'"),
                ("plate.vtp", "--progression bottom:0", "'0' of side 'bottom'"),
                ("plate.vtp", "--progression bottom:0.1,x", "'x' of side 'bottom'"),
                ("plate.vtp", "--progression bottom:2.9,0.3", "do not fit on side 'bottom'"),
                ("plate.vtp", "--size-at hole:0", "'0' of side 'hole'"),
                ("plate.vtp", "--size-at hole:nan", "'nan' of side 'hole'"),
                ("plate.vtp", "--size-in bottom:0.1", "'bottom' encloses nothing"),
                ("plate.vtp", "--size-in hole:x", "'x' of side 'hole'"),
                ("plate.vtp", "--size-near 0.3,0.3", "'0.3,0.3' is no position"),
                ("plate.vtp", "--size-near 0.3,0.3:-1", "is no position with a positive size"),
                ("plate.vtp", "--size-near 0.3,0.3:0.1,0.1,0.1", "is no position"),
                ("plate.vtp", "--size-near 9,9:0.1", "(9, 9) of a size is outside of the domain"),
                ("plate.vtp", "--size-near 0.3,0.3:0.1 --growth 1", "above 1"),
                ("plate.vtp", "--count 24", "no name of a side"),
                ("plate.vtp", "--count hole:", "no value"),
                ("plate.vtp", "--names Nothing", "no cell array 'Nothing'"),
                ("plate.vtp", "--min-size 0.2 --max-size 0.1", "minimum size"),
        ):
            with self.subTest(arguments=arguments):
                before = self.snapshot()
                result = self.run_program("quads", domain, "-o", "none.vtu", "--json", "none.json", "--quads", "300",
                                          *arguments.split())
                self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
                self.assertRegex(result.stderr, SENTENCE)
                self.assertIn(words, result.stderr)
                self.assertEqual(self.snapshot(), before)


if __name__ == "__main__":
    unittest.main()
