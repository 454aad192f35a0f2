"""Help, examples in the help and reports of successful runs."""

import json
import math
import os
import pathlib
import pty
import re
import subprocess
import unittest

import domain_files
from program import PROGRAM, ProgramTest, write_configuration

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


if __name__ == "__main__":
    unittest.main()
