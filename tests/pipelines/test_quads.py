"""crossfield quads: the mesh, its blocks and layout, their numbers and refusals."""
import json
import math
import pathlib
import re
import struct
import time
import unittest

from domain_files import write_vtp
from program import ProgramTest, write_configuration

PARTS = pathlib.Path(__file__).resolve().parents[1] / "data" / "parts"


class Quads(ProgramTest):
    def report(self, domain, *arguments):
        return json.loads(self.succeed("quads", domain, "-o", "quads.vtu", "--json", "-",
                                       *arguments))

    def test_the_report_has_its_numbers(self):
        report = self.report("builtin:disk", "-s", "four.csv", "--size", "0.1", "--blocks",
                             "blocks.vtm", "--layout", "layout.vtp")
        # docs/method.md §14.11
        self.assertEqual(report["quads"], 297)
        self.assertEqual(report["irregular"], {"3": 4})
        self.assertEqual(report["asked"], {"3": 4})
        self.assertEqual(report["blocks"], 5)
        self.assertGreater(report["scaled_jacobian"]["min"], 0.85)
        self.assertLessEqual(report["scaled_jacobian"]["min"], report["scaled_jacobian"]["bound"])
        self.assertTrue(report["integers"]["optimal"])
        self.assertEqual(report["inverted"], 0)
        self.assertEqual(set(report["seconds"]),
                         {"mesh", "map", "trace", "integers", "layout", "smooth", "choose",
                          "clean"})
        self.assertEqual(report["seconds"]["choose"], 0)
        self.assertEqual(report["seconds"]["clean"], 0)
        self.assertEqual(report["blocks_by_merge"], {"none": 5})
        self.assertNotIn("events", report)
        for name in ("quads.vtu", "layout.vtp", "blocks.vtm", "blocks/block0.vts",
                     "blocks/block4.vts"):
            self.assertTrue((self.folder / name).is_file(), name)

    def test_several_configurations_are_meshed(self):
        """A disk with three holes: ten singularities with the symmetries of the part, or eight."""
        def circle(x, y, radius, count):
            return [(x + radius * math.cos(2 * math.pi * i / count), y + radius * math.sin(2 * math.pi * i / count))
                    for i in range(count)]
        loops = [circle(0, 0, 1, 180)]
        for turn in (0, 1, 2):
            angle = 2 * math.pi * turn / 3
            loops.append(circle(0.6 * math.cos(angle), 0.6 * math.sin(angle), 0.1, 36))
        text = {"type": "Polygon", "coordinates": [loop + [loop[0]] for loop in loops]}
        (self.folder / "disk.geojson").write_text(json.dumps(text))
        report = self.report("disk.geojson", "--quads", "1500")
        self.assertEqual((len(report["singularities"]), report["blocks"], report["symmetries"]), (10, 27, 6))
        alternatives = report["alternatives"]
        self.assertEqual(alternatives[0], {"nodes": 10, "blocks": 27, "size_variation": report["size_variation"],
                                           "scaled_jacobian": report["scaled_jacobian"]["min"]})
        self.assertEqual(min(one["nodes"] for one in alternatives), 8)
        nodes = self.report("disk.geojson", "--quads", "1500", "--prefer", "nodes")
        even = self.report("disk.geojson", "--quads", "1500", "--prefer", "uniform")
        self.assertLessEqual(even["size_variation"], nodes["size_variation"])
        same = [sorted(map(str, one["alternatives"])) for one in (report, nodes, even)]
        self.assertEqual(same[1:], same[:2])
        second = self.report("disk.geojson", "--quads", "1500", "--alternative", "1")
        self.assertEqual(second["scaled_jacobian"]["min"], alternatives[1]["scaled_jacobian"])
        self.assertEqual(sum(second["irregular"].values()), alternatives[1]["nodes"])
        self.refuse("quads", "disk.geojson", "-o", "a.vtu", "--prefer", "all", says=["nodes", "blocks", "uniform"])

    def test_the_text_is_two_lines_unless_it_is_verbose(self):
        """The events are in the report in any case; warnings are on standard error."""
        arguments = ("quads", "builtin:disk", "-o", "quads.vtu", "--blocks", "blocks.vtm", "--quads", "300")
        made, written = self.succeed(*arguments).splitlines()
        self.assertRegex(made, r"^\d+ quads in 5 blocks, irregular nodes by valence \{\"3\":4\}, minimum scaled Jacobian 0\.\d+ ")
        self.assertEqual(written, "Written to quads.vtu, blocks.vtm")
        verbose = self.succeed(*arguments, "--verbose").splitlines()
        events = json.loads(self.succeed(*arguments, "--json", "-"))["events"]
        self.assertEqual(verbose[:len(events)], events)
        self.assertEqual(verbose[-3:], [made, verbose[-2], written])
        self.assertRegex(verbose[-2], r"^sides: outer0 \d+ edges$")
        self.assertEqual(self.succeed(*arguments, "--json", "report.json"), "")
        result = self.run_program("quads", "builtin:rectangle", "-o", "a.vtu", "--count", "outer0:400")
        self.assertEqual((result.stdout.count("\n"), result.stderr[:8]), (2, "Warning:"))

    def test_impossible_numbers_of_quads_are_refused_before_any_work(self):
        begin = time.time()
        for arguments, says in ((("--count", "outer0:100000000"), ("along side 'outer0'", "fewer edges")),
                                (("--count", "outer0:1e8"), ("maximum of 5e+07",)),
                                (("--quads", "2e9"), ("fewer quads",)), (("--size", "1e-6"), ("larger size",))):
            self.refuse("quads", "builtin:square", "-o", "quads.vtu", *arguments, says=says)
        self.assertLess(time.time() - begin, 10)

    def test_corners_on_the_threshold_are_smooth(self):
        """An octagonal ring in single precision, as ParaView's Disk: every corner turns by 45 degrees up to rounding."""
        single = [struct.unpack("f", struct.pack("f", radius * part))[0] for radius in (0.5, 0.25)
                  for i in range(8) for part in (math.cos(i * math.pi / 4), math.sin(i * math.pi / 4))]
        points = list(zip(single[::2], single[1::2]))
        write_vtp(self.folder / "ring.vtp", points, [[*range(8), 0], [*range(8, 16), 8]])
        report = self.report("ring.vtp")
        self.assertEqual((report["irregular"], report["blocks"], report["ambiguous_corners"]), ({}, 1, 16))
        self.assertIn("16 corners turn by 45 or 135", self.succeed("quads", "ring.vtp", "-o", "quads.vtu", "--verbose"))
        for command in ("check", "corners"):
            found = json.loads(self.succeed(command, "ring.vtp", "--json", "-"))
            self.assertEqual([corner["quarter_index"] for corner in found["corners"]], 16 * [0], command)
            self.assertEqual(found["ambiguous_corners"], 16)
            self.assertIn("16 corners turn by 45 or 135", self.succeed(command, "ring.vtp"))
            self.assertNotIn("ambiguous_corners", json.loads(self.succeed(command, "builtin:square", "--json", "-")))

    def test_domains_of_several_materials_are_meshed_with_a_warning(self):
        points = [(x, y) for y in range(3) for x in range(3)]
        cells = [(a, a + 1, a + 4) for a in (0, 1, 3, 4)] + [(a, a + 4, a + 3) for a in (0, 1, 3, 4)]
        text = ('<VTKFile type="PolyData" version="1.0"><PolyData><Piece NumberOfPoints="9" NumberOfPolys="8"><Points>'
                '<DataArray type="Float64" NumberOfComponents="3" format="ascii">%s</DataArray></Points><Polys>'
                '<DataArray type="Int64" Name="connectivity" format="ascii">%s</DataArray>'
                '<DataArray type="Int64" Name="offsets" format="ascii">%s</DataArray></Polys><CellData>'
                '<DataArray type="Int32" Name="%s" format="ascii">%s</DataArray></CellData></Piece></PolyData></VTKFile>')
        for name, values, warns in (("MaterialIds", (7, 7, 8, 8, 7, 7, 8, 8), True), ("MaterialIds", 8 * (3,), False),
                                    ("BlockId", (7, 7, 8, 8, 7, 7, 8, 8), False), ("Number", range(8), False)):
            (self.folder / "domain.vtp").write_text(text % (
                " ".join("%d %d 0" % point for point in points), " ".join("%d %d %d" % cell for cell in cells),
                " ".join(str(3 * i) for i in range(1, 9)), name, " ".join(map(str, values))))
            result = self.run_program("quads", "domain.vtp", "-o", "quads.vtu", "--quads", "100")
            self.assertEqual(result.returncode, 0, result.stderr)
            expected = "Warning: The cells of the domain have 2 values in the array 'MaterialIds'" if warns else ""
            self.assertEqual((result.stderr[:len(expected)], result.stderr.count("\n")), (expected, int(warns)))

    def test_singularities_are_those_used(self):
        """After the repair of the holonomy; the same mesh is made of them again."""
        for domain, arguments in (("builtin:disk", ("--quads", "300")),
                                  (str(PARTS / "bracket.vtp"), ("--quads", "300", "--repair-holonomy"))):
            arguments += ("--sizing", "conformal")  # other sizes move the nodes
            report = self.report(domain, *arguments, "--save-singularities", "used.csv")
            self.assertGreater(report["seconds"]["choose"], 0)
            self.assertTrue(report["events"])
            rows = [line.split(",") for line in (self.folder / "used.csv").read_text().split()[1:]]
            self.assertEqual([[float(x), float(y), int(k)] for x, y, k in rows],
                             [[s["x"], s["y"], s["quarter_index"]] for s in report["singularities"]])
            again = self.report(domain, "-s", "used.csv", *(a for a in arguments if a != "--repair-holonomy"))
            for name in ("quads", "irregular", "blocks", "scaled_jacobian", "singularities"):
                self.assertEqual(again[name], report[name])

    def test_positions_are_those_of_the_nodes(self):
        """Uniform sizes move the nodes; every move by more than a tenth of a quad is an event."""
        chosen = self.report("builtin:l-shape", "--quads", "300", "--save-singularities", "used.csv")
        self.assertEqual(chosen["moved"], 0)
        write_configuration(self.folder / "pair.csv", [(0.25, 0.3, 1, 0.02), (0.6, 0.2, -1, 0.02)])
        report = self.report("builtin:l-shape", "-s", "pair.csv", "--quads", "300", "--sizing", "uniform",
                             "--save-singularities", "used.csv")
        moves = [re.fullmatch(r"Singularity ([12]) moved by (\S+), \S+ quads, from \((.+), (.+)\) to its node at "
                              r"\((.+), (.+)\)\.", event) for event in report["events"]]
        self.assertTrue(moves and all(moves), report["events"])
        for move in moves:
            row = report["singularities"][int(move[1]) - 1]
            self.assertAlmostEqual(float(move[5]), row["x"], delta=0.51e-4)  # four digits
            self.assertAlmostEqual(float(move[6]), row["y"], delta=0.51e-4)
        self.assertAlmostEqual(max(float(move[2]) for move in moves), report["moved"], delta=1e-2 * report["moved"])
        rows = [line.split(",") for line in (self.folder / "used.csv").read_text().split()[1:]]
        self.assertEqual([(float(x), float(y)) for x, y, *_ in rows],
                         [(s["x"], s["y"]) for s in report["singularities"]])

    def test_large_indices_are_split_on_request(self):
        rows = [(0.2, 0.1, -2, 0.02)] + [(0.6 * math.cos(a), 0.6 * math.sin(a), 1, 0.02) for a in range(6)]
        write_configuration(self.folder / "six.csv", rows)
        self.assertEqual(self.report("builtin:disk", "-s", "six.csv")["irregular"], {"3": 6, "6": 1})
        self.assertEqual(self.report("builtin:disk", "-s", "six.csv", "--split")["irregular"], {"3": 6, "5": 2})
        write_configuration(self.folder / "three.csv", [(0.2, 0.1, 3, 0.02), (-0.5, 0, 1, 0.02)])
        self.refuse("quads", "builtin:disk", "-s", "three.csv", "-o", "quads.vtu", says=("index 3", "(0.2, 0.1)", "--split"))
        self.assertEqual(self.report("builtin:disk", "-s", "three.csv", "--split")["irregular"], {"3": 4})

    def test_nothing_is_said_about_holonomy_without_holes(self):
        printed = self.succeed("quads", "builtin:disk", "-s", "four.csv", "-o", "quads.vtu", "--repair-holonomy")
        self.assertNotIn("holonomy", printed)

    def test_clean_layouts_have_fewer_blocks(self):
        bracket = str(PARTS / "bracket.vtp")
        conformal = ("--sizing", "conformal")  # other sizes move the nodes
        separate = self.report(bracket, *conformal)
        report = self.report(bracket, *conformal, "--merge", "clean", "--save-singularities", "used.csv")
        self.assertEqual(report["blocks_by_merge"], {"none": separate["blocks"], "clean": report["blocks"]})
        self.assertLessEqual(report["blocks"], 28)  # of 39
        self.assertGreater(report["scaled_jacobian"]["min"], separate["scaled_jacobian"]["min"] - 0.02)
        self.assertGreater(report["seconds"]["clean"], 0)
        self.assertIn("so that separatrices meet", report["events"][-1])
        # The singularities that were used give the same mesh without merging.
        again = self.report(bracket, "-s", "used.csv")
        for name in ("quads", "irregular", "blocks", "scaled_jacobian"):
            self.assertEqual(again[name], report[name])
        # --coarse is short for --merge coarse.
        coarse = self.report(bracket, *conformal, "--merge", "coarse")
        counts = coarse["blocks_by_merge"]
        self.assertEqual([counts["none"], counts["coarse"]], [separate["blocks"], coarse["blocks"]])
        self.assertLessEqual(counts["coarse"], counts["clean"])
        self.assertEqual(self.report(bracket, *conformal, "--coarse")["blocks"], coarse["blocks"])
        self.refuse("quads", bracket, "-o", "quads.vtu", "--coarse", "--merge", "clean", says=("--merge",))
        self.refuse("quads", bracket, "-o", "quads.vtu", "--merge", "some", says=("--merge",))

    def test_positions_are_those_after_repair(self):
        rows = [(r * math.cos(t + n * math.pi / 2), r * math.sin(t + n * math.pi / 2), k, 0.02)
                for r, t, k in ((0.8, 0.25, 1), (0.55, 0.1, -1)) for n in range(4)]
        write_configuration(self.folder / "eight.csv", rows)
        report = self.report("builtin:ring", "-s", "eight.csv", "--size", "0.1", "--repair-holonomy")
        moves = [math.hypot(s["x"] - x, s["y"] - y) for s, (x, y, *_) in zip(report["singularities"], rows)]
        self.assertAlmostEqual(max(moves), report["repair"]["distance"], places=12)
        self.assertGreater(max(moves), 0.01)
        self.assertIn("to repair the holonomy.", self.succeed(
            "quads", "builtin:ring", "-s", "eight.csv", "-o", "quads.vtu", "--size", "0.1", "--repair-holonomy", "--verbose"))

    def test_corners_alone(self):
        report = self.report("builtin:l-shape", "--quads", "300")
        self.assertEqual((report["quads"], report["irregular"], report["blocks"]), (300, {}, 3))
        self.assertAlmostEqual(report["scaled_jacobian"]["min"], 1.0, places=6)

    def test_corners_without_an_angle_are_capped(self):
        """Five corners of index 2 get index 1: Σ k = 4 - 5 - (5 of -1) = 4 inside, and 2 - k quads
        at each corner."""
        report = self.report("builtin:star", "--quads", "1000")
        self.assertEqual(report["irregular"], report["asked"])
        self.assertEqual(sum((4 - int(v)) * n for v, n in report["irregular"].items()), 4)
        self.assertEqual(report["inverted"], 0)
        self.refuse("quads", "builtin:star", "-o", "quads.vtu", "--no-cap-corners",
                    says=("quarter index 2", "cap corners"))

    def test_pairs_make_sizes_more_uniform(self):
        """A trapezium whose small end is a quarter as long as the other: no irregular node is
        needed."""
        (self.folder / "wedge.csv").write_text("x,y\n0,0\n4,1.5\n4,2.5\n0,4\n")
        needed = self.report("wedge.csv")
        self.assertEqual(needed["irregular"], {})
        self.assertTrue(any("pairs of singularities (Pairs, --pairs) may make them more uniform" in event
                            for event in needed["events"]))
        more = self.report("wedge.csv", "--pairs", "1")
        self.assertEqual(more["irregular"], {"3": 1, "5": 1})
        self.assertLess(more["size_variation"], 0.5 * needed["size_variation"])
        self.refuse("quads", "wedge.csv", "-o", "quads.vtu", "--pairs", "101", says=("--pairs",))

    def test_a_degenerate_quad_is_reported_with_its_place(self):
        """Two quads share the angle of 360° at a node of valence 2."""
        (self.folder / "two.csv").write_text(
            "x,y,quarter_index\n-0.4,0.1,2\n0.3,0.4,1\n0.4,-0.4,1\n")
        result = self.run_program("quads", "builtin:disk", "-s", "two.csv", "-o", "quads.vtu",
                                  "--json", "-")
        worst = [text for text in json.loads(result.stdout)["warnings"] if "valence 2" in text]
        self.assertEqual(len(worst), 1)
        self.assertIn("at (-0.4", worst[0])
        self.assertIn(worst[0], result.stderr)
        report = self.report("builtin:disk", "-s", "four.csv")
        self.assertNotIn("warnings", report)
        self.assertEqual([attempt["what"] for attempt in report["attempts"]], ["With the given singularities"])
        self.assertTrue(report["attempts"][0]["outcome"].startswith("%d quads in " % report["quads"]))

    def test_a_count_is_reached(self):
        for count in (1000, 4000):
            report = self.report("builtin:disk", "-s", "four.csv", "--quads", str(count))
            self.assertLess(abs(report["quads"] - count), 0.05 * count)

    STRIP = """# vtk DataFile Version 3.0
strip
ASCII
DATASET POLYDATA
POINTS 4 double
0 0 0  3 0 0  3 0.3 0  0 0.3 0
LINES 1 6
5 0 1 2 3 0
POINT_DATA 4
SCALARS Length double
LOOKUP_TABLE default
0.1 0.2 0.2 0.1
"""

    def test_sizes_follow_an_array_of_the_domain(self):
        (self.folder / "strip.vtk").write_text(self.STRIP)
        write_configuration(self.folder / "none.csv", [])
        given = ("strip.vtk", "-s", "none.csv", "--sizing", "field", "Length")
        # Linear on the segments: 30 log 2 = 20.8 columns, in two rows or three.
        quads = self.report(*given)["quads"]
        self.assertIn(quads, (40, 42, 60, 63))
        self.assertLess(abs(self.report(*given, "--quads", "200")["quads"] - 200), 10)
        common = ("quads", "strip.vtk", "-s", "none.csv", "-o", "quads.vtu", "--sizing")
        self.refuse(*common, "field", "Other", says=("no point array 'Other'", "name one"))
        self.refuse(*common, "field", says=("--sizing: give", "name of a point array"))
        self.refuse(*common, "uniform", "Length", says=("--sizing: give",))
        self.refuse(*common, "even", says=("no 'even'", "conformal"))
        self.refuse(*common, "field", "Length", "--size", "0.1", says=("leave --size out",))

    def test_the_optimiser_follows_the_same_array(self):
        (self.folder / "channel.vtk").write_text(
            self.STRIP.replace("3 0 0  3 0.3 0  0 0.3 0", "3 0 0  3 0.8 0  0 0.8 0"))
        write_configuration(self.folder / "none.csv", [])
        common = ("optimize", "channel.vtk", "-s", "none.csv", "--sizing")

        def optimized(*options):
            return json.loads(self.succeed(*common, *options, "--json", "-"))

        report = optimized( "field", "Length", "--even", "--pairs", "1")
        # Linear between 0.1 and 0.2, whose logarithm has this standard deviation, half by area and half by quads;
        # H of a channel is 0.
        self.assertAlmostEqual(report["size_spread_before"], 0.2015, delta=0.002)
        self.assertLess(report["size_spread_after"], 0.6 * report["size_spread_before"])
        self.assertEqual(sorted(s["quarter_index"] for s in report["singularities"]), [-1, 1])
        self.assertLess(optimized("uniform", "--even")["size_spread_before"], 1e-9)
        self.assertIn("log size over target size",
                      self.succeed(*common, "field", "Length", "--even"))
        self.refuse(*common, "field", "Length", says=("give it with --even or --pairs",))
        self.refuse(*common, "field", "--even", says=("--sizing: give", "name of a point array"))
        self.refuse(*common, "conformal", "--even", says=("no 'conformal'", "uniform or field"))
        self.refuse(*common, "field", "Width", "--even", says=("no point array 'Width'",))

    def test_thin_domains(self):
        """Rectangles of aspect ratios 40 and 1000 need no irregular node and have square quads."""
        for length in (40, 1000):
            (self.folder / "strip.csv").write_text(f"x,y\n0,0\n{length},0\n{length},1\n0,1\n")
            report = self.report("strip.csv", "--size", "0.5")
            self.assertEqual((report["quads"], report["irregular"]), (4 * length, {}))
            self.assertAlmostEqual(report["scaled_jacobian"]["min"], 1.0, places=6)

    def test_a_comb_is_divided_at_its_corners(self):
        teeth = 12
        points = ["0,0", f"{2 * teeth},0"]
        for tooth in reversed(range(teeth)):
            x = 2 * tooth
            points += [f"{x + 2},0.3", f"{x + 1.5},0.3", f"{x + 1.5},5", f"{x + 1},5", f"{x + 1},0.3"]
        (self.folder / "comb.csv").write_text("\n".join(["x,y", *points, "0,0.3", ""]))
        report = self.report("comb.csv", "--size", "0.25")
        self.assertEqual(report["irregular"], {})
        self.assertAlmostEqual(report["scaled_jacobian"]["min"], 1.0, delta=0.01)

    def test_merged_corners_are_reported(self):
        """The blunt tail of a profile, shorter than the length of thinning, becomes sharp."""
        points = ["-3,-2", "3,-2", "3,2", "-3,2"]
        tail = ["1,-0.0005", "0,-0.1", "-1,0", "0,0.1", "1,0.0005"]
        (self.folder / "tail.csv").write_text("\n".join(
            ["x,y,loop", *(point + ",0" for point in points), *(point + ",1" for point in tail), ""]))
        printed = self.succeed("check", "tail.csv")
        self.assertIn("2 corners of the boundary, the first at (1, ", printed)
        self.assertIn("--thin-boundary 0 retains all corners", printed)
        report = json.loads(self.succeed("check", "tail.csv", "--json", "-"))
        self.assertEqual(sorted(report["boundary"]["removed_corners"]), [[1, -0.0005, 0], [1, 0.0005, 0]])
        report = json.loads(self.succeed("check", "tail.csv", "--thin-boundary", "0", "--json", "-"))
        self.assertNotIn("boundary", report)
        self.assertNotIn("corners of the boundary",
                         self.succeed("check", "tail.csv", "--thin-boundary", "0"))

    def test_numbers_of_the_command_line(self):
        self.assertEqual(self.report("builtin:square", "--quads", "1e2")["quads"],
                         self.report("builtin:square", "--quads", "100")["quads"])
        common = ("quads", "builtin:disk", "-s", "four.csv", "-o", "quads.vtu")
        for size in ("nan", "0", "-1", "inf", "1e400", "small"):
            self.refuse(*common, f"--size={size}", says=("--size: give a positive number", size))
        for count in ("1.5", "0", "-3", "1e10", "nan", "many"):
            self.refuse(*common, f"--quads={count}",
                        says=("--quads: give a whole number from 1 to 2,147,483,647", count))
        self.refuse(*common, "--pairs", "101", says=("a whole number from 0 to 100", "'101'"))

    def test_sizes_with_more_quads_than_can_be_numbered(self):
        for size in ("1e-05", "1e-07", "1e-09", "1e-100", "1e-300"):
            begin = time.monotonic()
            self.refuse("quads", "builtin:disk", "-o", "quads.vtu", "--size", size,
                        says=("quads of size " + size, "use a larger size"))
            self.assertLess(time.monotonic() - begin, 5.0)

    def test_the_same_bytes_twice(self):
        for name in ("first", "second"):
            self.succeed("quads", "builtin:disk", "-s", "four.csv", "-o", f"{name}.vtu")
        self.assertEqual(self.digest("first.vtu"), self.digest("second.vtu"))

    def test_what_cannot_be_meshed_is_refused(self):
        write_configuration(self.folder / "three.csv", [(0.4, 0.1, 3, 0.1), (-0.4, 0.1, 1, 0.1)])
        self.refuse("quads", "builtin:disk", "-s", "three.csv", "-o", "quads.vtu",
                    says=("quarter index 3", "split it"))
        self.refuse("quads", "builtin:disk", "-s", "four.csv", "-o", "quads.vtp", says=(".vtu",))
        self.refuse("quads", "builtin:disk", "-s", "four.csv", "-o", "quads.vtu", "--size", "-1",
                    says=("--size",))


if __name__ == "__main__":
    unittest.main()
