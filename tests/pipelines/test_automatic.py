"""From a bare domain to a field of norm one with one command and default options."""

import json
import math
import os
import pathlib
import random
import sys

import domain_files
from program import ProgramTest

TESTS = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(TESTS / "corpus"))
import engineering


def write_loops(path, loops):
    points, lines = [], []
    for loop in loops:
        first = len(points)
        points += loop
        lines.append([*range(first, len(points)), first])
    domain_files.write_vtp(path, points, lines)


def write_aerofoil(path, points):
    """Writes Selig's format: the name, then the points from the trailing edge around the
    profile."""
    lines = [f" {x:.6f}  {y:.6f}" for x, y in points]
    pathlib.Path(path).write_text("\n".join(["NACA 0012", *lines]) + "\n")


class AutomaticTest(ProgramTest):
    def arrives(self, domain):
        """Runs `solve` with the domain as the only input."""
        result = self.run_program(*self.with_output(("solve", domain, "--json", "-")))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        report = json.loads(result.stdout)
        self.assertIs(report["converged"], True)
        self.assertIs(report["degrees_reached"], True)
        self.assertEqual(report["unwanted_singularities"], 0)
        self.assertIs(report["consistent"], True)
        for defect in report.get("holonomy_defect", []):
            # The defect is zero for point singularities; holes and their mesh cause up to a few
            # hundredths.
            self.assertLess(abs(defect), 0.05)
        self.assertGreater(len(report["events"]), 0)

    def loops_arrive(self, name):
        write_loops(self.folder / "domain.vtp", engineering.DOMAINS[name]())
        self.arrives("domain.vtp")


class Engineering(AutomaticTest):
    def test_bolts(self):
        self.loops_arrive("bolts")

    def test_fillet_t(self):
        self.loops_arrive("fillet_t")

    def test_coast(self):
        self.loops_arrive("coast")

    def test_gear(self):
        self.loops_arrive("gear")

    def test_solid_gear(self):
        self.loops_arrive("solid_gear")

    def test_blade_passage(self):
        self.loops_arrive("blade_passage")

    def test_naca_in_rectangle(self):
        self.loops_arrive("naca_in_rectangle")

    def test_sharp_profile_in_circle(self):
        self.loops_arrive("sharp_profile_in_circle")

    def test_three_elements(self):
        self.loops_arrive("three_elements")

    def test_twenty_holes(self):
        self.loops_arrive("twenty_holes")

    def test_slotted_link(self):
        self.loops_arrive("slotted_link")

    def test_sharp_aerofoil(self):
        write_aerofoil(self.folder / "sharp.dat", engineering.profile())
        self.arrives("sharp.dat")

    def test_blunt_aerofoil(self):
        write_aerofoil(self.folder / "blunt.dat", engineering.profile(blunt=True))
        self.arrives("blunt.dat")


class Parts(AutomaticTest):
    def part(self, name):
        self.arrives(TESTS / "data" / "parts" / (name + ".vtp"))

    def test_plate3(self):
        self.part("plate3")

    def test_bracket(self):
        self.part("bracket")

    def test_elbow(self):
        self.part("elbow")

    def test_naca_blunt(self):
        self.part("naca_blunt")

    def test_tjunction(self):
        self.part("tjunction")


class WithoutSingularities(ProgramTest):
    """Without -s, the chosen singularities are reported and written as if they had been given."""

    def chosen(self, *arguments):
        return json.loads(self.succeed(*arguments, "--json", "-"))

    def test_solve_hfield_drill_energy_and_compare_choose_the_same(self):
        report = self.chosen("solve", "builtin:disk", "--save-singularities", "chosen.csv")
        self.assertEqual(len(report["singularities"]), 4)
        for one in report["singularities"]:
            self.assertEqual(one["quarter_index"], 1)
            self.assertAlmostEqual(math.hypot(one["x"], one["y"]), 0.850, delta=2e-3)
        again = self.solve("builtin:disk", singularities="chosen.csv")
        self.assertEqual(again["energy"], report["energy"])
        self.assertEqual(again["singularities"], report["singularities"])
        self.assertNotIn("events", again)
        h = self.chosen("hfield", "builtin:disk")
        self.assertEqual((h["singularities"], h["events"]),
                         (report["singularities"], report["events"]))
        energies = self.chosen("energy", "builtin:disk")
        self.assertEqual(energies["singularities"], report["singularities"])
        self.assertEqual(energies["configurations"][0]["file"], "chosen")
        self.succeed("drill", "builtin:disk", "-o", "drilled.vtu", "--save-singularities",
                     "drilled.csv")
        self.assertEqual(self.digest("drilled.csv"), self.digest("chosen.csv"))
        self.succeed("compare", "builtin:disk", "--methods", "unit-norm", "--save-singularities",
                     "compared.csv")
        self.assertEqual(self.digest("compared.csv"), self.digest("chosen.csv"))
        # The holes of a drilled mesh are its singularities.
        self.assertNotIn("singularities", self.chosen("hfield", "drilled.vtu"))

    def test_the_text_lists_what_was_chosen(self):
        self.assertNotIn("chosen", self.succeed("solve", "builtin:disk"))
        text = self.succeed("solve", "builtin:disk", "--verbose")
        self.assertEqual(text.count("quarter index 1 at "), 4)
        self.assertIn("4 singularities were chosen", text)

    def test_no_singularities_can_be_given(self):
        (self.folder / "none.csv").write_text("x,y,quarter_index\n")
        self.assertEqual(self.solve("builtin:square", singularities="none.csv")["singularities"], [])
        self.assertEqual(self.chosen("solve", "builtin:square")["singularities"], [])

    def test_chosen_corners_are_kept(self):
        (self.folder / "corners.csv").write_text("x,y,quarter_index\n0,0,1\n")
        report = self.chosen("solve", "builtin:quarter-disk", "--corners", "corners.csv")
        self.assertEqual(len(report["singularities"]), 1)


class Streams(ProgramTest):
    def pipe(self, *arguments, text):
        result = self.run_program(*arguments, input=text)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout

    def test_singularities_and_domains_come_through_pipes(self):
        rows = (self.folder / "four.csv").read_text()
        given = self.solve("builtin:disk")
        for name in ("-", "/dev/stdin"):
            report = json.loads(
                self.pipe("solve", "builtin:disk", "-s", name, "--json", "-", text=rows))
            self.assertEqual(report["energy"], given["energy"])
        self.succeed("domain", "square", "-o", "square.vtp")
        self.succeed("drill", "builtin:square", "-o", "square.vtu")
        energies = set()
        for name in ("square.vtp", "square.vtu"):
            text = (self.folder / name).read_text()
            energies.add(json.loads(
                self.pipe("hfield", "-", "--json", "-", text=text))["energy"])
        energies.add(json.loads(self.pipe(
            "hfield", "-", "--json", "-", text="x,y\n0,0\n2,0\n2,2\n0,2\n"))["energy"])
        energies.add(json.loads(self.pipe(
            "hfield", "-", "--json", "-", text="square\n0 0\n2 0\n2 2\n0 2\n"))["energy"])
        self.assertLess(max(energies), 1e-12)
        result = self.run_program("check", "-", input="")
        self.assertEqual((result.returncode, result.stdout), (2, ""))

    def test_outputs_go_through_pipes(self):
        self.succeed("optimize", "builtin:disk", "-o", "better.csv")
        better = self.succeed("optimize", "builtin:disk", "-o", "-")
        self.assertEqual(better, (self.folder / "better.csv").read_text())
        self.succeed("solve", "builtin:disk", "-s", "better.csv", "-o", "field.vtu")
        field = self.succeed("solve", "builtin:disk", "-s", "better.csv", "-o", "-")
        self.assertEqual(field, (self.folder / "field.vtu").read_text())
        self.assertEqual(self.succeed("check", "builtin:disk", "--propose", "-").split("\n")[0][:17],
                         "x,y,quarter_index")
        self.refuse("solve", "builtin:disk", "-o", "-", "--json", "-", says=["two names"])

    def test_names_that_are_not_utf_8(self):
        name = os.fsencode(self.folder) + b"/\xff.csv"
        with open(name, "w") as file:
            file.write((self.folder / "four.csv").read_text())
        result = self.run_program("energy", "builtin:disk", "-s", os.fsdecode(name), "--json", "-")
        self.assertEqual(result.returncode, 0)
        self.assertIn("\ufffd.csv", json.loads(result.stdout)["configurations"][0]["file"])

    def test_a_report_in_a_file_is_all_there_is(self):
        for command in (("solve", "builtin:disk"), ("hfield", "builtin:disk"),
                        ("energy", "builtin:disk"), ("optimize", "builtin:disk"),
                        ("corners", "builtin:square"), ("check", "builtin:square"),
                        ("compare", "builtin:disk", "--methods", "unit-norm")):
            with self.subTest(command[0]):
                self.assertEqual(self.succeed(*command, "--json", "report.json"), "")


class Boundaries(AutomaticTest):
    def test_a_trailing_edge_that_no_triangle_resolves(self):
        """A thousand points that are dense at the ends, and a trailing edge of 1e-5."""
        upper = engineering.profile(count=500)[:501]
        upper = [(x, y + 0.5e-5 * x) for x, y in upper]
        profile = upper + [(x, -y) for x, y in reversed(upper[:-1])]
        write_loops(self.folder / "domain.vtp", [engineering.box(-1, -1, 3, 1), profile])
        report = json.loads(self.succeed("quads", "domain.vtp", "-o", "quads.vtu", "--json", "-",
                                         "--save-singularities", "chosen.csv"))
        self.assertEqual((report["inverted"], report["irregular"]), (0, {}))
        self.assertGreater(report["scaled_jacobian"]["min"], 0.9)
        size = math.hypot(4, 2) / 40
        self.assertEqual(report["boundary"]["points_before"], len(profile) + 4)
        self.assertLess(report["boundary"]["points"], len(profile))
        self.assertGreaterEqual(report["boundary"]["moved"], 0.4e-5)
        self.assertLess(report["boundary"]["moved"], 0.02 * size)
        # The domain is symmetric, and so are the chosen singularities.
        places = sorted((row["x"], row["y"]) for row in report["singularities"])
        mirrored = sorted((x, -y) for x, y in places)
        for place, other in zip(places, mirrored):
            self.assertLess(math.dist(place, other), 1e-9 * math.hypot(4, 2))
        # Given singularities are on the boundary before and after it is simplified.
        report = json.loads(self.succeed("hfield", "domain.vtp", "-s", "chosen.csv", "-o", "field.vtu", "--json", "-"))
        self.assertEqual([name for name in report if name.startswith("boundary")], ["boundary"])
        # If one corner of the trailing edge is given, both become one there.
        edge = upper[0]
        (self.folder / "edge.csv").write_text("x,y,quarter_index\n%.17g,%.17g,-2\n" % edge)
        for options, corners in (((), 5), (("--thin-boundary", "0"), 6)):
            report = json.loads(self.run_program(
                "check", "domain.vtp", "--corners", "edge.csv", "--json", "-", *options).stdout)
            self.assertEqual("boundary" in report, not options)
            self.assertEqual(len(report["corners"]), corners)
            self.assertIn(edge, [(row["x"], row["y"]) for row in report["corners"]])

    def test_a_coast_that_is_smoothed(self):
        chance = random.Random(1)
        ragged = [((1 + r) * x, (1 + r) * y) for x, y in engineering.coast()[0]
                  for r in [chance.uniform(0, 0.005)]]
        write_loops(self.folder / "domain.vtp", [ragged])
        rough = json.loads(self.succeed("corners", "domain.vtp", "--json", "-"))
        result = self.succeed("corners", "domain.vtp", "--smooth-boundary", "0.05")
        self.assertRegex(result, r"The boundary has \d+ of 2000 points and was moved by at most 0\.0\d")
        smooth = json.loads(self.succeed("corners", "domain.vtp", "--smooth-boundary", "0.05", "--json", "-"))
        self.assertEqual(smooth["boundary"]["points_before"], 2000)
        self.assertNotIn("boundary", rough)
        self.assertGreater(len(rough["corners"]), 500)
        self.assertEqual(smooth["corners"], [])
        self.refuse("corners", "domain.vtp", "--smooth-boundary", "-1", says=["--smooth-boundary"])


class Aerofoils(ProgramTest):
    def loop(self, text, name="loop.dat"):
        (self.folder / name).write_text(text)
        return json.loads(self.succeed("check", name, "--no-cap-corners", "--json", "-"))

    def test_open_and_closed_trailing_edges(self):
        closed = "wedge\n1 0\n0.5 0.1\n0 0\n0.5 -0.1\n1 0\n"
        report = self.loop(closed)
        self.assertEqual(self.loop("wedge\n 1.0 0.0 \n\n.5 1e-1\n0 0\n0.5 -0.1\n"), report)
        self.assertNotEqual(self.loop(closed.replace("1 0\n0.5 0.1", "1 0.01\n0.5 0.1")), report)

    def test_tables_of_paraview(self):
        plain = self.loop("x,y\n0,0\n2,0\n2,1\n0,1\n", "loop.csv")
        for header in ("X,Y", '"Points:0","Points:1","Points:2"', "Points_0,Points_1,Points_2",
                       '"Quality","Points:0","Points:1","Points:2"'):
            columns = header.count(",") + 1
            rows = [("0", "0"), ("2", "0"), ("2", "1"), ("0", "1")]
            text = "\n".join(",".join((*(["7"] if "Quality" in header else []), *row,
                                       *(["0"] if columns > 2 else []))) for row in rows)
            self.assertEqual(self.loop(header + "\n" + text + "\n", "loop.csv"), plain, header)

    def test_refusals(self):
        for text, says in (("name\n1 0\n0.5 zero\n", "Line 3"), ("name\n1 0\n0 0\n", "three points"),
                           ("name\n2. 2.\n0 0\n1 0.1\n0 0\n1 -0.1\n", "Lednicer"),
                           ("name\n1 0 0\n0 0 1\n", "Line 2")):
            (self.folder / "loop.dat").write_text(text)
            self.refuse("check", "loop.dat", says=[says])
