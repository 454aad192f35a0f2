"""crossfield quads --curve, --curves, --order: the report, files of every order, and refusals."""
import base64
import json
import math
import os
import re
import struct
import unittest
import zlib

from program import SENTENCE, ProgramTest
from test_sides import RECTANGLE, circle, write_domain


def read_array(text, name):
    """Returns the numbers of an array of a .vtu file (inline binary, zlib)."""
    element = re.search(r'<DataArray type="(\w+)" Name="%s"[^>]*>\s*(\S+)\s*<' % name, text)
    kind = {"Float64": "d", "Int64": "q", "UInt8": "B", "Int32": "i"}[element.group(1)]
    data = element.group(2)
    size = {"UInt32": 4, "UInt64": 8}[re.search(r'header_type="(\w+)"', text).group(1)]
    code = {4: "I", 8: "Q"}[size]
    blocks = struct.unpack("<" + code, base64.b64decode(data[:12 if size == 8 else 8])[:size])[0]
    header = 4 * math.ceil(size * (3 + blocks) / 3)
    lengths = struct.unpack("<%d%s" % (blocks, code), base64.b64decode(data[:header])[3 * size:size * (3 + blocks)])
    body, raw, at = base64.b64decode(data[header:]), b"", 0
    for length in lengths:
        raw += zlib.decompress(body[at:at + length])
        at += length
    return struct.unpack("<%d%s" % (len(raw) // struct.calcsize(kind), kind), raw)


class Curves(ProgramTest):
    def setUp(self):
        super().setUp()
        write_domain(self.folder / "plate.vtp", [RECTANGLE, circle(12, 0.4, (1.4, 1.0), lambda i: "hole")])

    def report(self, domain, *arguments):
        count = [] if "--size" in arguments else ["--quads", "300"]
        return json.loads(self.succeed("quads", domain, "-o", "quads.vtu", "--json", "-", *count, *arguments))

    def nodes_on_circle(self, centre, radius, order):
        """Returns the largest distance of nodes of curved edges from a circle, and their number."""
        text = (self.folder / "quads.vtu").read_text()
        types, curve = read_array(text, "types"), read_array(text, "Curve")
        ids, ends = read_array(text, "connectivity"), read_array(text, "offsets")
        places = read_array(text, "Points")
        edge = {1: 3, 2: 21, 3: 68}[order]
        nodes = {node for cell, end in enumerate(ends) if curve[cell] >= 0
                 for node in ids[ends[cell - 1]:end] if types[cell] == edge}
        return (max(abs(math.dist(places[3 * n:3 * n + 2], centre) - radius) for n in nodes), len(nodes))

    def test_nodes_of_every_order_are_on_the_declared_circle(self):
        for order in (1, 2, 3):
            report = self.report("plate.vtp", "--curve", "hole:circle", "--order", str(order))
            (curve,) = report["curves"]
            self.assertEqual((curve["kind"], curve["sides"]), ("circle", "hole"))
            self.assertLessEqual(curve["moved"], 0.4 * (1 - math.cos(math.pi / 12)) + 1e-12)
            self.assertGreater(curve["moved"], 0.005)
            distance, count = self.nodes_on_circle((1.4, 1.0), 0.4, order)
            self.assertLess(distance, 1e-12)
            self.assertEqual(count, order * curve["edges"])
            if order == 1:
                self.assertNotIn("higher_order", report)
                continue
            self.assertEqual(report["higher_order"]["order"], order)
            self.assertEqual(report["higher_order"]["inverted"], 0)
            self.assertGreater(report["higher_order"]["jacobian_ratio"], 0.4)
            types = read_array((self.folder / "quads.vtu").read_text(), "types")
            self.assertEqual(set(types), {2: {21, 28}, 3: {68, 70}}[order])

    def test_arcs_are_recognised_on_demand_only(self):
        self.assertNotIn("curves", self.report("plate.vtp"))
        self.assertEqual([curve["sides"] for curve in self.report("plate.vtp", "--curves", "auto")["curves"]], ["hole"])
        report = self.report("plate.vtp", "--curves", "auto", "--curve", "hole:line")
        self.assertNotIn("curves", report)

    def test_curves_are_fitted_before_the_boundary_is_thinned(self):
        """A spline through 2000 points of an ellipse is the ellipse, although few of them remain."""
        ellipse = [(2 * x, y, name) for x, y, name in circle(2000, 1, (0, 0), lambda i: "wall")]
        write_domain(self.folder / "ellipse.vtp", [ellipse])
        report = self.report("ellipse.vtp", "--curve", "wall:spline", "--thin-boundary", "0.03")
        self.assertLess(report["boundary"]["points"], 1000)
        text = (self.folder / "quads.vtu").read_text()
        places, curve = read_array(text, "Points"), read_array(text, "Curve")
        ids, ends = read_array(text, "connectivity"), read_array(text, "offsets")
        for cell, end in enumerate(ends):
            if curve[cell] >= 0:
                for n in ids[ends[cell - 1]:end]:
                    x, y = places[3 * n:3 * n + 2]
                    self.assertAlmostEqual((x / 2) ** 2 + y ** 2, 1, delta=1e-10)

    def test_layers_follow_curves(self):
        report = self.report("plate.vtp", "--curve", "hole:circle", "--layers", "hole:1e-3,1.2", "--order", "2",
                             "--size", "0.09")
        self.assertEqual(report["higher_order"]["inverted"], 0)
        self.assertGreater(report["higher_order"]["curved_rows"], 1)
        self.assertLess(self.nodes_on_circle((1.4, 1.0), 0.4, 2)[0], 1e-12)

    def test_a_mesh_of_the_program_is_a_domain_with_curves(self):
        self.report("plate.vtp", "--curve", "hole:circle")
        (curve,) = self.report("quads.vtu")["curves"]
        self.assertEqual(curve["kind"], "circle")

    def test_a_mesh_of_higher_order_is_a_domain(self):
        for order in ("2", "3"):
            self.report("plate.vtp", "--curve", "hole:circle", "--order", order)
            os.rename(self.folder / "quads.vtu", self.folder / "domain.vtu")
            report = self.report("domain.vtu")
            again = self.report("plate.vtp", "--curve", "hole:circle")
            self.assertEqual(*({side["name"] for side in one["sides"]} for one in (report, again)))
            self.assertLess(self.nodes_on_circle((1.4, 1.0), 0.4, 1)[0], 1e-12)

    def test_the_summary_has_a_line_for_each_curve(self):
        text = self.succeed("quads", "plate.vtp", "-o", "quads.vtu", "--curve", "hole:circle", "--order", "2", "--verbose")
        self.assertRegex(text, r"circle along 'hole': \d+ edges, nodes moved by at most 0\.\d+\n")
        self.assertRegex(text, r"curved quads of order 2: minimum over maximum of det J at least 0\.\d+, 0 inverted\n")

    def test_impossible_curves_are_one_sentence_and_write_nothing(self):
        for arguments, words in (
                ("--curve hole:circel", "'hole:circel' is not of the form NAME:circle"),
                ("--curve hole", "'hole' has no colon"),
                ("--curve hose:circle", "no side 'hose' for a curve; give '"),
                ("--curve bottom:circle", "Side 'bottom' is declared as circle"),
                ("--curve bottom:ellipse", "it needs at least five points"),
                ("--curve hole:circle --curve hole:line", "'hole' has two curves"),
        ):
            with self.subTest(arguments=arguments):
                before = self.snapshot()
                result = self.run_program("quads", "plate.vtp", "-o", "none.vtu", *arguments.split())
                self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
                self.assertRegex(result.stderr, SENTENCE)
                self.assertIn(words, result.stderr)
                self.assertEqual(self.snapshot(), before)
        for arguments in ("--order 4", "--order 0", "--curves all"):
            self.assertEqual(self.run_program("quads", "plate.vtp", "-o", "none.vtu", *arguments.split()).returncode, 2)

    def test_a_side_that_misses_its_circle_names_the_point(self):
        loop = circle(12, 0.4, (1.4, 1.0), lambda i: "hole")
        loop[3] = (1.4, 1.41, "hole")
        write_domain(self.folder / "bad.vtp", [RECTANGLE, loop])
        result = self.run_program("quads", "bad.vtp", "-o", "none.vtu", "--curve", "hole:circle")
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"Side 'hole' is no circle: the nearest one misses the point \(1\.4, 1\.41\) by "
                         r"0\.00\d+, and 3\.6e-06 is the most; declare another curve for it, or spline\.\n")


if __name__ == "__main__":
    unittest.main()
