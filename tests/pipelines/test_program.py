"""Help, examples in the help, reports and files of successful runs."""

import json
import math
import os
import pathlib
import pty
import random
import re
import subprocess
import unittest

import domain_files
from program import FOUR, PROGRAM, ProgramTest, write_configuration

SUBCOMMANDS = re.compile(r"^Subcommands:\n((?:  .*\n)+)", re.MULTILINE)
EXAMPLE = re.compile(r"^Example: (crossfield .+)$", re.MULTILINE)

SOLVE_KEYS = {"energy", "iterations", "residual", "converged", "hole_degree", "hole_norm_range",
              "unwanted_singularities", "triangles", "seconds"}
FIELD_DATA = re.compile(r"<FieldData>(.*)</FieldData>", re.DOTALL)
NAME = re.compile(r'<DataArray [^>]*Name="(\w+)"')


class Help(ProgramTest):
    def subcommands(self):
        listed = SUBCOMMANDS.search(self.succeed("--help")).group(1)
        return re.findall(r"^  (\S+) ", listed, re.MULTILINE)

    def test_examples_run(self):
        subcommands = self.subcommands()
        self.assertLessEqual({"domain", "drill", "solve"}, set(subcommands))
        for subcommand in subcommands:
            with self.subTest(subcommand):
                for flag in ("--help", "-h"):
                    text = self.succeed(subcommand, flag)
                    examples = EXAMPLE.findall(text)
                    self.assertEqual(len(examples), 1, text)
                words = examples[0].split()
                self.assertEqual(words[:2], ["crossfield", subcommand])
                result = self.run_program(*words[1:])
                self.assertEqual(result.returncode, 0, result.stderr)
                # Some figures of the paper have fields with unwanted zeros.
                if subcommand not in ("compare", "figures"):
                    self.assertEqual(result.stderr, "")
                if "-o" in words:
                    output = self.folder / words[words.index("-o") + 1]
                    self.assertGreater(output.stat().st_size, 0)

    def test_paths(self):
        lines = self.succeed("--paths").splitlines()
        paths = dict(line.split(": ", 1) if ": " in line else (line.rstrip(":"), "")
                     for line in lines)
        self.assertEqual(list(paths), ["program", "plugin", "python"])
        self.assertTrue(os.path.samefile(paths["program"], PROGRAM))
        python = os.environ.get("CROSSFIELD_PYTHON")  # set by CMake when it is built
        if python:
            self.assertTrue(os.path.samefile(paths["python"], python))
            self.assertTrue((pathlib.Path(python) / "crossfield" / "__init__.py").is_file())
        else:
            self.assertEqual(paths["python"], "")
        plugin = os.environ.get("CROSSFIELD_PLUGIN")  # set by CMake when it is built
        if plugin:
            self.assertTrue(os.path.samefile(paths["plugin"], plugin))
        else:
            self.assertFalse(paths["plugin"].strip() and os.path.exists(paths["plugin"]))

    def test_version(self):
        self.assertRegex(self.succeed("--version"), r"\A\d+\.\d+\.\d+\n\Z")


class Report(ProgramTest):
    def test_keys_and_types_of_solve(self):
        report = self.solve("builtin:disk", "-o", "field.vtu")
        self.assertLessEqual(SOLVE_KEYS, set(report))
        self.assertIs(report["consistent"], True)
        for key in ("iterations", "unwanted_singularities", "triangles"):
            self.assertIs(type(report[key]), int, key)
        for key in ("energy", "residual"):
            self.assertIs(type(report[key]), float, key)
        self.assertIs(report["converged"], True)
        self.assertEqual(report["hole_degree"], [1, 1, 1, 1])
        self.assertTrue(all(type(degree) is int for degree in report["hole_degree"]))
        self.assertEqual(len(report["hole_norm_range"]), 4)
        for least, largest in report["hole_norm_range"]:
            self.assertTrue(0.0 < least <= largest < 2.0)
        self.assertEqual(set(report["seconds"]), {"mesh", "assemble", "factor", "solve", "write"})
        for stage, seconds in report["seconds"].items():
            self.assertTrue(0.0 < seconds < 60.0, stage)
        self.assertGreater(report["energy"], 0.0)
        self.assertLess(report["residual"], 1e-9)
        self.assertEqual(report["unwanted_singularities"], 0)

    def test_lists_have_one_entry_per_hole_even_if_there_is_one(self):
        write_configuration(self.folder / "one.csv", [(0.0, 0.0, 4, 0.3)])
        report = self.solve("builtin:disk", singularities="one.csv")
        self.assertEqual(report["hole_degree"], [4])
        self.assertEqual(len(report["hole_norm_range"]), 1)
        self.assertEqual(len(report["hole_norm_range"][0]), 2)

    def test_no_holes_at_all(self):
        write_configuration(self.folder / "none.csv", [])
        for method in ("constrained", "unit-norm"):
            report = self.solve("builtin:ring", "--method", method, singularities="none.csv")
            self.assertEqual((report["hole_degree"], report["hole_norm_range"]), ([], []))
            self.assertIs(report["converged"], True)
            self.assertEqual(report["unwanted_singularities"], 0)

    def test_the_report_is_that_of_the_file(self):
        report = self.solve("builtin:disk", "-o", "field.vtu")
        text = (self.folder / "field.vtu").read_text()
        cells = int(re.search(r'NumberOfCells="(\d+)"', text).group(1))
        self.assertLess(report["triangles"], cells)  # the lines are cells as well
        arrays = {"CrossFieldCR", "Cross", "Cross2", "CrossNorm", "Representation", "BoundaryKind",
                  "BoundaryId", "QuarterIndex"}
        self.assertLessEqual(arrays, set(NAME.findall(text)))
        snake_case = {re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower()
                      for name in NAME.findall(FIELD_DATA.search(text).group(1))}
        self.assertEqual(set(report), snake_case | {"triangles", "seconds", "singularities"})
        # Appended data cannot be read back by the VTKs of Debian 12.
        self.assertEqual(set(re.findall(r'format="(\w+)"', text)), {"binary"})
        self.assertNotIn("<AppendedData", text)
        self.assertIn("vtkZLibDataCompressor", text)

    def test_arrays_are_those_chosen(self):
        derived = {"Cross", "Cross2", "CrossNorm", "Representation", "SizeMap"}
        for command in ("solve", "hfield"):
            sizes = []
            for arrays, kept in (("exact", set()), ("display", {"Cross", "CrossNorm"}), ("all", derived)):
                kept = kept | {"SizeMap"} if arrays == "display" else kept
                kept = kept - {"SizeMap"} if command == "solve" else kept
                self.succeed(command, "builtin:disk", "-s", "four.csv", "-o", "field.vtu", "--arrays", arrays)
                text = (self.folder / "field.vtu").read_text()
                self.assertEqual(derived & set(NAME.findall(text)), kept)
                self.assertIn("CrossFieldCR", NAME.findall(text))
                sizes.append(len(text))
                self.succeed("check", "field.vtu")
            self.assertEqual(sizes, sorted(sizes))
        self.assertIn("--arrays", self.refuse("solve", "builtin:disk", "--arrays", "some"))

    def test_a_report_file_holds_what_standard_output_would(self):
        self.assertEqual(self.succeed("solve", "builtin:disk", "-s", "four.csv", "--json",
                                      "report.json"), "")
        report = json.loads((self.folder / "report.json").read_text())
        printed = self.solve("builtin:disk")
        del report["seconds"], printed["seconds"]
        self.assertEqual(report, printed)

    def test_a_summary_without_json(self):
        text = self.succeed("solve", "builtin:disk", "-s", "four.csv", "-o", "field.vtu")
        self.assertRegex(text, r"\Aenergy \d+\.\d+, converged after \d+ iterations .*\n\Z")
        self.assertRegex(self.succeed("drill", "builtin:disk", "-s", "four.csv", "-o", "mesh.vtu"),
                         r"\Amesh\.vtu: \d+ triangles\n\Z")

    def test_a_smaller_size_gives_more_triangles_and_nearly_the_same_energy(self):
        coarse = self.solve("builtin:disk", "--size", "0.1")
        fine = self.solve("builtin:disk", "--size", "0.02")
        self.assertGreater(fine["triangles"], 2 * coarse["triangles"])
        self.assertLess(abs(fine["energy"] / coarse["energy"] - 1.0), 0.02)

    def test_strict_says_no_to_unwanted_singularities(self):
        # The holes are far from the optimal positions, so the field has further singularities.
        corners = [(0.0, 0.0), (6.0, 0.0), (6.0, 4.0), (0.0, 4.0)]
        island = [(4.5 + 0.7 * math.cos(i * math.pi / 20), 2.0 + 0.7 * math.sin(i * math.pi / 20))
                  for i in range(40)]
        domain_files.write_vtp(self.folder / "island.vtp", corners + island,
                               [[0, 1, 2, 3, 0], [*range(4, 44), 4]])
        write_configuration(self.folder / "far.csv", [(1.5, 1.0, -1, 0.2), (1.5, 3.0, -1, 0.1),
                                                      (3.0, 2.0, -2, 0.15)])
        harmonic = ("--method", "constrained", "--start", "harmonic")
        plain = self.run_program("solve", "island.vtp", "-s", "far.csv", "--json", "-", *harmonic)
        self.assertEqual(plain.returncode, 0)
        self.assertGreater(json.loads(plain.stdout)["unwanted_singularities"], 0)
        self.assertRegex(plain.stderr, r"\AWarning: The field has \d+ unwanted singularities")
        result = self.run_program(
            "solve", "island.vtp", "-s", "far.csv", "--json", "-", "--strict", *harmonic)
        self.assertEqual((result.returncode, result.stderr), (1, plain.stderr))
        self.solve("builtin:disk", "--strict")
        # Unit norm, the default, has exactly the requested singularities.
        unit = self.solve("island.vtp", "--strict", singularities="far.csv")
        self.assertEqual(unit["unwanted_singularities"], 0)

    def test_a_square_with_a_pair(self):
        # The cross of the sides fits everywhere, so the field without holes is constant.
        for domain, y in (("builtin:square", 1.0), ("builtin:rectangle", 0.5)):
            with self.subTest(domain):
                write_configuration(self.folder / "pair.csv",
                                    [(1.5, y, 1, 0.1), (0.5, y, -1, 0.1)])
                report = self.solve(domain, singularities="pair.csv")
                self.assertEqual(report["hole_degree"], [1, -1])

    def test_methods(self):
        unit = self.solve("builtin:disk", "--method", "unit-norm")
        self.assertEqual(unit["hole_degree"], [1, 1, 1, 1])
        for least, largest in unit["hole_norm_range"]:
            self.assertAlmostEqual(least, 1.0, 12)
            self.assertAlmostEqual(largest, 1.0, 12)
        constrained = self.solve("builtin:disk", "--method", "constrained")
        # Its admissible set contains the unit circle, so the minimum is lower.
        self.assertLess(constrained["energy"], unit["energy"])
        for start in ("harmonic", "unit-norm", "best"):
            energy = self.solve(
                "builtin:disk", "--method", "constrained", "--start", start)["energy"]
            self.assertLess(abs(energy / constrained["energy"] - 1.0), 1e-6, start)
        holes = self.solve("builtin:disk", "--method", "constrained", "--unit-holes")
        self.assertGreater(holes["energy"], constrained["energy"])
        for least, largest in holes["hole_norm_range"]:
            self.assertAlmostEqual(least, 1.0, 6)
            self.assertAlmostEqual(largest, 1.0, 6)

    def test_progress_on_a_terminal_only(self):
        arguments = ("solve", "builtin:disk", "-s", "four.csv", "-o", "field.vtu")
        self.succeed(*arguments)  # no progress line in a pipe
        try:
            reader, terminal = pty.openpty()
        except OSError as error:  # a chroot without /dev/pts
            self.skipTest(str(error))
        subprocess.run([PROGRAM, *arguments], cwd=self.folder, stderr=terminal, check=True,
                       stdout=subprocess.DEVNULL, timeout=100)
        os.close(terminal)
        text = b""
        try:
            while chunk := os.read(reader, 65536):
                text += chunk
        except OSError:  # Linux reports the end of a terminal as an error
            pass
        os.close(reader)
        self.assertRegex(text.decode(), r"\r\w+ +\d+ %")
        self.assertTrue(text.endswith(b"\r"), "the line is wiped in the end")


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


class Files(ProgramTest):
    SQUARE = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]

    def test_two_runs_write_the_same_bytes(self):
        for name in ("first.vtu", "second.vtu"):
            self.solve("builtin:disk", "-o", name)
        self.assertEqual(self.digest("first.vtu"), self.digest("second.vtu"))
        self.solve("builtin:disk", "-o", "third.vtu", "--size", "0.1")
        self.assertNotEqual(self.digest("first.vtu"), self.digest("third.vtu"))

    def test_the_number_of_threads_changes_no_byte(self):
        for name, limits in (("many.vtu", {}), ("one.vtu", {
                "OMP_THREAD_LIMIT": "1", "OPENBLAS_NUM_THREADS": "1"})):
            result = self.run_program("solve", "builtin:disk", "-s", "four.csv", "--size", "0.03",
                                      "-o", name, env={**os.environ, **limits})
            self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(self.digest("many.vtu"), self.digest("one.vtu"))

    def test_singularities_may_be_a_vtp_file(self):
        domain_files.write_singularities(self.folder / "four.vtp", FOUR)
        for command, ending, *more in (
                ("solve", "vtu"), ("drill", "vtu"), ("hfield", "vtu"), ("optimize", "csv"),
                ("solve", "vtu", "--method", "ginzburg-landau", "--size", "0.2")):
            for source in ("csv", "vtp"):
                self.succeed(command, "builtin:disk", "-s", f"four.{source}", *more,
                             "-o", f"{source}.{ending}")
            with self.subTest(command):
                self.assertEqual(self.digest(f"csv.{ending}"), self.digest(f"vtp.{ending}"))
        for source in ("csv", "vtp"):
            self.succeed("compare", "builtin:disk", "-s", f"four.{source}", "--methods", "unit-norm",
                         "-o", f"{source}.vtm")
        self.assertEqual(self.digest("csv/unit-norm.vtu"), self.digest("vtp/unit-norm.vtu"))

    def test_untidy_segments_write_the_same_bytes(self):
        curves = [[(radius * math.cos(i * math.pi / 32), radius * math.sin(i * math.pi / 32))
                   for i in range(64)] for radius in (1.0, 0.4)]
        points = curves[0] + curves[1]
        domain_files.write_vtp(self.folder / "tidy.vtp", points,
                               [[*range(64), 0], [*range(64, 128), 64]])
        segments = [(curve[i], curve[i - 1]) for curve in curves for i in range(64)]  # clockwise
        random.Random(5).shuffle(segments)
        domain_files.write_vtp(self.folder / "untidy.vtp",
                               [end for pair in segments for end in pair],
                               [[2 * i, 2 * i + 1] for i in range(len(segments))])
        write_configuration(self.folder / "two.csv", [(0.7, 0.0, 1, 0.05), (-0.7, 0.0, -1, 0.05)])
        for name in ("tidy", "untidy"):
            self.solve(f"{name}.vtp", "-o", f"{name}.vtu", singularities="two.csv")
        self.assertEqual(self.digest("tidy.vtu"), self.digest("untidy.vtu"))

    def check_formats(self, corners):
        """Solves on files of one quadrilateral in all formats."""
        points = corners + [(0.75, 1.25)]  # meshes have an inner point
        triangles = [(i, (i + 1) % 4, 4) for i in range(4)]
        for ending in ("vtu", "vtk", "stl", "obj", "ply"):
            writer = getattr(domain_files, f"write_{ending}")
            writer(self.folder / f"domain.{ending}", points, triangles)
        domain_files.write_loop(self.folder / "domain.vtp", corners)
        domain_files.write_csv(self.folder / "domain.csv", corners)
        write_configuration(self.folder / "pair.csv", [(1.5, 1.0, 1, 0.1), (0.5, 1.0, -1, 0.1)])
        expected = self.solve("domain.csv", singularities="pair.csv")
        for ending in ("vtp", "vtu", "vtk", "stl", "obj", "ply"):
            with self.subTest(ending):
                report = self.solve(f"domain.{ending}", singularities="pair.csv")
                self.assertEqual(report["required_interior_quarters"], 0)
                self.assertLess(abs(report["energy"] / expected["energy"] - 1.0), 1e-6)
        return expected["energy"]

    def test_every_format_of_a_square_gives_the_same_field(self):
        energy = self.check_formats(self.SQUARE)
        builtin = self.solve("builtin:square", singularities="pair.csv")["energy"]
        self.assertLess(abs(energy / builtin - 1.0), 1e-6)

    def test_every_format_of_a_trapezium_gives_the_same_field(self):
        # Corners that are exact in single precision, which some formats use.
        self.check_formats([(0.0, 0.0), (2.0, 0.0), (1.75, 2.0), (0.25, 2.0)])

    def test_loops_in_formats_of_meshes(self):
        write_configuration(self.folder / "pair.csv", [(1.5, 1.0, 1, 0.1), (0.5, 1.0, -1, 0.1)])
        expected = self.solve("builtin:square", singularities="pair.csv")["energy"]
        for ending in ("obj", "vtk"):
            name = f"loop.{ending}"
            getattr(domain_files, f"write_loop_{ending}")(self.folder / name, self.SQUARE)
            energy = self.solve(name, singularities="pair.csv")["energy"]
            self.assertLess(abs(energy / expected - 1.0), 1e-6)

    def test_a_csv_loop_may_repeat_its_first_point(self):
        domain_files.write_csv(self.folder / "open.csv", self.SQUARE)
        domain_files.write_csv(self.folder / "closed.csv", self.SQUARE + self.SQUARE[:1])
        write_configuration(self.folder / "none.csv", [])
        for name in ("open", "closed"):
            self.solve(f"{name}.csv", "-o", f"{name}.vtu", singularities="none.csv")
        self.assertEqual(self.digest("open.vtu"), self.digest("closed.vtu"))

    def test_the_program_reads_what_it_writes(self):
        self.succeed("domain", "ring", "-o", "ring.vtp")
        self.succeed("domain", "ring", "-o", "again.vtp")
        self.assertEqual(self.digest("ring.vtp"), self.digest("again.vtp"))
        write_configuration(self.folder / "two.csv", [(0.7, 0.0, 1, 0.05), (-0.7, 0.0, -1, 0.05)])
        fromFile = self.solve("ring.vtp", singularities="two.csv")
        self.assertEqual(fromFile["energy"],
                         self.solve("builtin:ring", singularities="two.csv")["energy"])
        # A drilled mesh is also a domain, whose holes are inner loops.
        self.succeed("drill", "builtin:disk", "-s", "four.csv", "-o", "mesh.vtu")
        write_configuration(self.folder / "none.csv", [])
        result = self.run_program("solve", "mesh.vtu", "-s", "none.csv", "--json", "-")
        self.assertEqual(result.returncode, 1)
        self.assertIn("requires -12", result.stderr)

    def test_options_of_the_domain(self):
        for name in ("disk", "ring", "ellipse", "quarter-disk", "square", "rectangle", "l-shape"):
            self.succeed("domain", name, "-o", f"{name}.vtp")
        self.succeed("domain", "ring", "--inner-radius", "0.6", "--radius", "2", "--size", "0.5",
                     "-o", "other.vtp")
        self.assertNotEqual(self.digest("ring.vtp"), self.digest("other.vtp"))

    def test_an_old_output_is_replaced(self):
        (self.folder / "field.vtu").write_text("old")
        (self.folder / "report.json").write_text("old")
        self.succeed("solve", "builtin:disk", "-s", "four.csv", "-o", "field.vtu", "--json",
                     "report.json")
        self.assertIn("CrossFieldCR", (self.folder / "field.vtu").read_text())
        json.loads((self.folder / "report.json").read_text())
        self.assertEqual(sorted(os.listdir(self.folder)), ["field.vtu", "four.csv", "report.json"])

    def test_radii_are_optional(self):
        rows = [row[:3] for row in FOUR]
        lines = ["x,y,quarter_index"] + [",".join(map(str, row)) for row in rows]
        (self.folder / "bare.csv").write_text("\n".join(lines) + "\n")
        bare = self.solve("builtin:disk", "--size", "0.1", singularities="bare.csv")
        # Without a radius a hole has the size of a triangle.
        self.assertEqual(bare["energy"], self.solve("builtin:disk", "--size", "0.1")["energy"])


if __name__ == "__main__":
    unittest.main()
