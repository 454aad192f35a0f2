"""Domains and singularities in planes other than z = const."""

import json
import math
import unittest

import domain_files
from program import ProgramTest, write_configuration


class Planes(ProgramTest):
    """Domains and singularities in other planes than z = const, as .csv with a column z."""

    TURNS = {"yz": lambda x, y, z: (z, x, y), "xz": lambda x, y, z: (x, -z, y)}
    SQUARE = [(0.0, 0.0, 0.0), (2.0, 0.0, 0.0), (2.0, 2.0, 0.0), (0.0, 2.0, 0.0)]
    PAIR = [(1.5, 1.0, 0.0, 1, 0.1), (0.42, 1.0, 0.0, -1, 0.1)]

    def write(self, turn=lambda *place: place):
        rows = [",".join(map(repr, turn(*place))) for place in self.SQUARE]
        (self.folder / "square.csv").write_text("\n".join(["x,y,z"] + rows) + "\n")
        rows = [",".join(map(repr, (*turn(*row[:3]), *row[3:]))) for row in self.PAIR]
        (self.folder / "pair.csv").write_text(
            "\n".join(["x,y,z,quarter_index,radius"] + rows) + "\n")

    def test_the_same_numbers_in_every_coordinate_plane(self):
        self.write()
        flat = self.solve("square.csv", singularities="pair.csv")
        for name, turn in self.TURNS.items():
            with self.subTest(name):
                self.write(turn)
                report = self.solve("square.csv", singularities="pair.csv")
                self.assertEqual(report["triangles"], flat["triangles"])
                self.assertLess(abs(report["energy"] / flat["energy"] - 1.0), 1e-12)

    def test_positions_are_printed_with_z(self):
        self.write(self.TURNS["yz"])
        for subcommand in ("check", "corners"):
            report = json.loads(self.succeed(subcommand, "square.csv", "--json", "-"))
            places = {(corner["x"], corner["y"], corner["z"]) for corner in report["corners"]}
            self.assertEqual(places, {self.TURNS["yz"](*place) for place in self.SQUARE})
        self.assertIn("\n0 2 2 1.5708 ", self.succeed("corners", "square.csv"))
        self.assertNotIn("z", self.succeed("corners", "builtin:square"))

    def test_a_proposal_is_in_the_plane(self):
        circle = [(math.cos(i * math.pi / 32), math.sin(i * math.pi / 32)) for i in range(64)]
        for turn in self.TURNS.values():
            rows = [",".join(map(repr, turn(*place, 0.0))) for place in circle]
            (self.folder / "disk.csv").write_text("\n".join(["x,y,z"] + rows) + "\n")
            self.succeed("check", "disk.csv", "--propose", "start.csv")
            self.assertTrue((self.folder / "start.csv").read_text().startswith("x,y,z,quarter"))
            report = self.solve("disk.csv", singularities="start.csv")
            self.assertEqual(report["hole_degree"], [1, 1, 1, 1])

    def test_the_optimised_configuration_is_in_the_plane(self):
        self.write()
        self.run_program("optimize", "square.csv", "-s", "pair.csv", "-o", "flat.csv",
                         "--iterations", "1")
        rows = (self.folder / "flat.csv").read_text().split()
        self.assertEqual(rows[0], "x,y,quarter_index,radius")
        for turn in self.TURNS.values():
            self.write(turn)
            self.run_program("optimize", "square.csv", "-s", "pair.csv", "-o", "moved.csv",
                             "--iterations", "1")
            header, *turned = (self.folder / "moved.csv").read_text().split()
            self.assertEqual(header, "x,y,z,quarter_index,radius")
            for row, old in zip(turned, rows[1:], strict=True):
                x, y, quarter, _ = map(float, old.split(","))
                found = list(map(float, row.split(",")))
                self.assertEqual(found[3], quarter)
                for value, expected in zip(found[:3], turn(x, y, 0.0)):
                    self.assertAlmostEqual(value, expected, 9)
            self.succeed("check", "square.csv", "-s", "moved.csv")

    def test_points_without_cells_are_ignored(self):
        self.write()
        corners = [place[:2] for place in self.SQUARE]
        stray = (9.0, -7.0, 5.0)
        for name, more in (("plain", []), ("stray", [stray])):
            domain_files.write_vtp(self.folder / f"{name}.vtp", corners + more, [(0, 1, 2, 3, 0)])
            domain_files.write_vtu(
                self.folder / f"{name}.vtu", corners + more, [(0, 1, 2), (0, 2, 3)])
        for command in (("check", "-s", "pair.csv", "--json", "-"), ("corners", "--json", "-"),
                        ("energy", "-s", "pair.csv", "--json", "-"), ("corners",),
                        ("check", "--propose", "proposed.csv")):
            for ending in ("vtp", "vtu"):
                with self.subTest(f"{command} {ending}"):
                    plain, found = (
                        self.succeed(command[0], f"{name}.{ending}", *command[1:])
                        for name in ("plain", "stray"))
                    self.assertEqual(found, plain)
        for subcommand in ("drill", "solve", "hfield", "compare"):
            for ending in ("vtp", "vtu"):
                with self.subTest(f"{subcommand} {ending}"):
                    output = "out.vtm" if subcommand == "compare" else "out.vtu"
                    written = []
                    for name in ("plain", "stray"):
                        self.succeed(subcommand, f"{name}.{ending}", "-s", "pair.csv",
                                     "-o", output, *(["--methods", "penalty"]
                                                     if subcommand == "compare" else []))
                        written.append(self.digest(
                            "out/penalty.vtu" if subcommand == "compare" else output))
                    self.assertEqual(written[1], written[0])

    def test_every_format_in_a_tilted_plane(self):
        normal = (0.36, 0.48, 0.8)

        def tilt(x, y, z):  # the shortest rotation that takes z to the normal
            a, b, c = normal
            across = (a * x + b * y) / (1 + c)
            return (x - a * across + a * z, y - b * across + b * z, c * z - a * x - b * y)

        self.write()
        flat = self.solve("square.csv", singularities="pair.csv")["energy"]
        self.write(tilt)
        corners = [tilt(*place) for place in self.SQUARE]
        points = corners + [tilt(0.75, 1.25, 0.0)]
        triangles = [(i, (i + 1) % 4, 4) for i in range(4)]
        domain_files.write_loop(self.folder / "square.vtp", corners)
        # Single precision decides ties in the mesh of a square, so the mesh may differ.
        tolerance = {"csv": 1e-12, "vtp": 1e-12, "vtu": 1e-12, "vtk": 1e-12, "stl": 1e-3,
                     "obj": 1e-3, "ply": 1e-3}
        for ending, allowed in tolerance.items():
            with self.subTest(ending):
                if ending not in ("csv", "vtp"):
                    getattr(domain_files, f"write_{ending}")(
                        self.folder / f"square.{ending}", points, triangles)
                energy = self.solve(f"square.{ending}", singularities="pair.csv")["energy"]
                self.assertLess(abs(energy / flat - 1.0), allowed)

    def test_singularities_off_the_plane(self):
        self.write(self.TURNS["xz"])
        write_configuration(self.folder / "flat.csv", [(1.5, 1.0, 1, 0.1), (0.5, 1.0, -1, 0.1)])
        self.refuse_solve("square.csv", singularities="flat.csv",
                          says=["off the plane", "column z"])


if __name__ == "__main__":
    unittest.main()
