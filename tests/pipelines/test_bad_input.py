"""Bad input: the program reports one sentence and changes no file."""

import os
import resource
import unittest

import domain_files
from program import FOUR, SENTENCE, ProgramTest, write_configuration

SQUARE = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]


class Domains(ProgramTest):
    def refuse_domain(self, name, *says):
        write_configuration(self.folder / "none.csv", [])
        self.refuse_solve(name, singularities="none.csv", says=says)
        self.refuse("drill", name, "-s", "none.csv", "-o", "mesh.vtu", says=says)

    def refuse_text(self, name, text, *says):
        (self.folder / name).write_text(text)
        self.refuse_domain(name, *says)

    def refuse_loop(self, points, *says):
        domain_files.write_loop(self.folder / "loop.vtp", points)
        self.refuse_domain("loop.vtp", *says)
        domain_files.write_csv(self.folder / "loop.csv", points)
        self.refuse_domain("loop.csv", *says)

    def test_missing_file(self):
        self.refuse_domain("no.vtp", "'no.vtp'")
        self.refuse_domain(".", "'.'")

    def test_unknown_ending(self):
        self.refuse_text("square.txt", "0 0\n", "'square.txt'", ".vtp")
        self.refuse_text("square", "0 0\n", "'square'")

    def test_unknown_builtin_domain(self):
        self.refuse_domain("builtin:triangle", "'triangle'", "disk")
        self.refuse_domain("builtin:", "''")
        self.refuse("domain", "triangle", "-o", "t.vtp", says=["'triangle'"])

    def test_open_curve(self):
        domain_files.write_vtp(self.folder / "open.vtp", SQUARE, [[0, 1, 2, 3]])
        self.refuse_domain("open.vtp", "open curve")

    def test_branching_curve(self):
        domain_files.write_vtp(self.folder / "branch.vtp", SQUARE, [[0, 1, 2, 3, 0], [0, 2]])
        self.refuse_domain("branch.vtp", "branches")

    def test_self_crossing_loop(self):
        self.refuse_loop([(0.0, 0.0), (4.0, 4.0), (4.0, 0.0), (0.0, 5.0)], "crosses or touches itself near (2.222, 2.222)")

    def test_loop_without_area(self):
        self.refuse_loop([(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)])
        self.refuse_loop([(0.0, 0.0), (1.0, 0.0)])

    def test_several_outer_loops(self):
        points = SQUARE + [(x + 5.0, y) for x, y in SQUARE]
        domain_files.write_vtp(self.folder / "two.vtp", points, [[0, 1, 2, 3, 0], [4, 5, 6, 7, 4]])
        self.refuse_domain("two.vtp", "several outer loops")

    def test_numbers_that_are_not_finite(self):
        # 12345 marks the number to replace; the writers use it for nothing else.
        points = [(-1.0, -1.0), (1.0, -1.0), (1.0, 12345.0), (-1.0, 1.0)]
        for ending in ("vtu", "vtk", "stl", "obj", "ply"):
            writer = getattr(domain_files, f"write_{ending}")
            writer(self.folder / f"good.{ending}", points, [(0, 1, 2), (0, 2, 3)])
        domain_files.write_loop(self.folder / "good.vtp", points)
        domain_files.write_csv(self.folder / "good.csv", points)
        for good in sorted(self.folder.glob("good.*")):
            for bad in ("nan", "inf", "-inf", "1e999"):
                with self.subTest(f"{bad} in {good.suffix}"):
                    self.assertIn("12345.0", good.read_text())
                    text = good.read_text().replace("12345.0", bad)
                    self.refuse_text(f"bad{good.suffix}", text)

    def test_malformed_vtu(self):
        domain_files.write_vtu(self.folder / "good.vtu", SQUARE, [(0, 1, 2), (0, 2, 3)])
        good = (self.folder / "good.vtu").read_text()
        for name, text in (("empty", ""), ("words", "this is no mesh\n"),
                           ("cut", good[:len(good) // 2]), ("end", good[:-20]),
                           ("tag", good.replace("</Points>", "</Pints>")),
                           ("few", good.replace('NumberOfPoints="4"', 'NumberOfPoints="5"'))):
            with self.subTest(name):
                self.assertNotEqual(text, good)
                self.refuse_text(f"{name}.vtu", text)

    def test_cells_with_points_that_do_not_exist(self):
        domain_files.write_vtu(self.folder / "good.vtu", SQUARE, [(0, 1, 2), (0, 2, 3)])
        good = (self.folder / "good.vtu").read_text()
        for far in ("9", "-1", "123456789012"):
            with self.subTest(far):
                text = good.replace("0 1 2 0 2 3", f"0 1 2 0 2 {far}")
                self.assertNotEqual(text, good)
                self.refuse_text("far.vtu", text)

    def test_files_of_another_kind_than_their_ending_says(self):
        domain_files.write_loop(self.folder / "good.vtp", SQUARE)
        domain_files.write_vtu(self.folder / "good.vtu", SQUARE, [(0, 1, 2), (0, 2, 3)])
        self.refuse_text("loop.vtu", (self.folder / "good.vtp").read_text())
        self.refuse_text("mesh.vtp", (self.folder / "good.vtu").read_text())
        for ending in ("vtp", "vtk", "stl", "obj", "ply", "csv"):
            for text in ("", "this is no mesh\n"):
                with self.subTest(f"{text!r} as .{ending}"):
                    self.refuse_text(f"words.{ending}", text)

    def test_malformed_csv(self):
        self.refuse_text("loop.csv", "a,b\n0,0\n1,0\n1,1\n", "x and y")
        self.refuse_text("loop.csv", "x,y\n0,0\n1,zero\n1,1\n", "Row 2")
        self.refuse_text("loop.csv", "x,y\n0,0\n1\n1,1\n", "Row 2")
        self.refuse_text("loop.csv", "x,y\n")

    def test_gmsh(self):
        (self.folder / "plate.msh").write_text("$MeshFormat\n")
        self.refuse_solve("plate.msh", says=["'plate.msh'", "ends too early"])

    def test_3d_cells(self):
        self.refuse_text(
            "cube.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
            "POINTS 4 double\n0 0 0\n1 0 0\n0 1 0\n0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n",
            "vtkTetra")

    def test_domain_out_of_the_plane(self):
        self.refuse_text("bent.obj", "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nf 1 2 3\nf 1 3 4\n",
                         "not planar")


class Singularities(ProgramTest):
    def refuse_rows(self, rows, *says):
        write_configuration(self.folder / "bad.csv", rows)
        self.refuse_solve("builtin:disk", singularities="bad.csv", says=says)
        self.refuse("drill", "builtin:disk", "-s", "bad.csv", "-o", "mesh.vtu", says=says)

    def refuse_text(self, text, *says):
        (self.folder / "bad.csv").write_text(text)
        self.refuse_solve("builtin:disk", singularities="bad.csv", says=says)

    def test_missing_file(self):
        self.refuse_solve("builtin:disk", singularities="no.csv", says=["'no.csv'"])

    def test_malformed_file(self):
        self.refuse_text("", "no column 'x'")
        self.refuse_text("0.5,0.5,1\n", "no column 'x'")
        self.refuse_text("x,y\n0,0\n", "no column 'quarter_index'")
        self.refuse_text("x,y,quarter_index\n0,zero,1\n", "Row 1", "'y'")
        self.refuse_text("x,y,quarter_index\n0,0\n", "Row 1", "'quarter_index'")

    def test_hole_outside(self):
        self.refuse_rows(FOUR[:3] + [(3.0, 0.0, 1, 0.1)], "singularity 4", "outside")

    def test_hole_cuts_the_boundary(self):
        self.refuse_rows(FOUR[:3] + [(0.95, 0.0, 1, 0.1)], "singularity 4", "cuts the boundary")

    def test_overlapping_holes(self):
        self.refuse_rows(FOUR[:3] + [(0.42, 0.42, 1, 0.1)], "singularity 1", "singularity 4",
                         "overlap")

    def test_radius_that_is_not_positive(self):
        for bad in ("-0.1", "0"):
            with self.subTest(bad):
                self.refuse_rows(FOUR[:3] + [(0.42, -0.42, 1, bad)], "not positive")

    def test_radius_below_the_rounding_of_the_coordinates(self):
        # The points of such a hole nearly coincide.
        for tiny in ("1e-17", "1e-320"):
            with self.subTest(tiny):
                write_configuration(self.folder / "tiny.csv", [(0.1, 0.3, 4, tiny)])
                self.refuse_solve("builtin:disk", singularities="tiny.csv", says=["radius"])

    def test_numbers_that_are_not_finite(self):
        for bad in ("nan", "inf", "-inf", "1e999"):
            for column in range(4):
                with self.subTest(f"{bad} in column {column}"):
                    row = [0.42, -0.42, 1, 0.1]
                    row[column] = bad
                    self.refuse_rows(FOUR[:3] + [row])

    def test_quarter_index_that_is_not_an_integer(self):
        self.refuse_rows(FOUR[:3] + [(0.42, -0.42, 0.25, 0.1)], "singularity 4", "not an integer")

    def test_inconsistent_configuration(self):
        write_configuration(self.folder / "three.csv", FOUR[:3])
        self.refuse_solve("builtin:disk", singularities="three.csv", status=1,
                          says=["add up to 3", "requires 4"])
        # Such a configuration can still be meshed.
        self.succeed("drill", "builtin:disk", "-s", "three.csv", "-o", "mesh.vtu")


class Usage(ProgramTest):
    def test_unknown_words(self):
        self.refuse()
        self.refuse("sovle", "builtin:disk", says=["sovle"])
        self.refuse("--colour", says=["--colour"])
        self.refuse_solve("builtin:disk", "--colour", says=["--colour"])
        self.refuse_solve("builtin:disk", "more.vtp", says=["more.vtp"])
        self.refuse_solve("builtin:disk", "--method", "magic", says=["magic"])
        self.refuse("quads", "builtin:disk", "-o", "a.vtu", "--merge", "all", says=["give none, clean or coarse instead of 'all'"])

    def test_missing_arguments(self):
        for command in ("domain", "drill", "solve"):
            with self.subTest(command):
                self.refuse(command)
        self.refuse("domain", "disk", says=["-o"])
        self.refuse("drill", "builtin:disk", "-s", "four.csv", says=["-o"])
        self.refuse("solve", "builtin:disk", "-s", says=["-s"])
        self.refuse("solve", "builtin:disk", "-s", "four.csv", "-o", says=["-o"])

    def test_size_that_is_not_a_length(self):
        for bad in ("-0.1", "nan", "inf", "small", ""):
            with self.subTest(bad):
                self.refuse_solve("builtin:disk", f"--size={bad}",
                                  says=("--size", *((f"positive number instead of '{bad}'",) if bad else ())))
                self.refuse("domain", "disk", f"--size={bad}", "-o", "disk.vtp")

    def test_size_below_the_rounding_of_the_coordinates(self):
        for tiny in ("1e-12", "1e-300"):
            with self.subTest(tiny):
                self.refuse("domain", "disk", "--size", tiny, "-o", "disk.vtp")

    def test_lengths_of_the_domain(self):
        for option, domain in (("--radius", "disk"), ("--inner-radius", "ring"),
                               ("--width", "square"), ("--height", "rectangle")):
            for bad in ("-1", "0", "nan", "inf", "wide"):
                with self.subTest(f"{option} {bad}"):
                    self.refuse("domain", domain, f"{option}={bad}", "-o", "domain.vtp")
        self.refuse("domain", "ring", "--inner-radius", "1.5", "-o", "ring.vtp", says=["smaller"])


class Outputs(ProgramTest):
    SOLVE = ("solve", "builtin:disk", "-s", "four.csv")

    def test_missing_folder(self):
        self.refuse(*self.SOLVE, "-o", "no/field.vtu", says=["/no'"])
        self.refuse(*self.SOLVE, "-o", "field.vtu", "--json", "no/report.json", says=["/no'"])
        self.refuse("drill", "builtin:disk", "-s", "four.csv", "-o", "no/mesh.vtu", says=["/no'"])
        self.refuse("domain", "disk", "-o", "no/disk.vtp", says=["/no'"])

    def test_wrong_ending(self):
        for name in ("field.vtp", "field", "field.vtu.gz", ".vtu/"):
            with self.subTest(name):
                self.refuse(*self.SOLVE, "-o", name, says=[".vtu"])
        self.refuse("drill", "builtin:disk", "-s", "four.csv", "-o", "mesh.vtk", says=[".vtu"])
        self.refuse("domain", "disk", "-o", "disk.vtu", says=[".vtp"])

    def test_a_folder_in_the_place_of_an_output(self):
        (self.folder / "taken.vtu").mkdir()
        self.refuse(*self.SOLVE, "-o", "taken.vtu", says=["taken.vtu"])
        # If one output cannot be written, none is.
        self.refuse(*self.SOLVE, "-o", "field.vtu", "--json", "taken.vtu", says=["taken.vtu"])

    def test_one_file_for_both_outputs(self):
        self.refuse(*self.SOLVE, "-o", "both.vtu", "--json", "both.vtu",
                    says=["Two outputs cannot both go to 'both.vtu'; give two names."])

    def test_a_report_that_cannot_be_printed(self):
        with open("/dev/full", "w") as full:
            result = self.run_program(*self.SOLVE, "--json", "-", stdout=full)
        self.assertEqual(result.returncode, 2, result)
        self.assertRegex(result.stderr, SENTENCE)

    def test_a_full_disk(self):
        # Simulated by a limit on file size, which is an error if its signal is ignored.
        for name in ("field.vtu", "report.json"):
            (self.folder / name).write_text("from an earlier run\n")
            os.utime(self.folder / name, (1e9, 1e9))
        before = self.snapshot()
        result = self.run_program(
            *self.SOLVE, "-o", "field.vtu", "--json", "report.json", "--size", "0.02",
            restore_signals=False,  # Python ignores the signal, and the program inherits this
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (65536, 65536)))
        self.assertEqual(result.returncode, 2, result)
        self.assertRegex(result.stderr, SENTENCE)
        self.assertEqual(self.snapshot(), before)


if __name__ == "__main__":
    unittest.main()
