"""crossfield separatrices: lines, faces and maps, their numbers and refusals."""
import json
import unittest

from program import ProgramTest, write_configuration


class Separatrices(ProgramTest):
    def report(self, domain, *arguments):
        return json.loads(self.succeed("separatrices", domain, "--json", "-", *arguments))

    def test_the_report_has_its_numbers(self):
        report = self.report("builtin:disk", "-s", "four.csv", "-o", "lines.vtp", "--faces",
                             "faces.vtp", "--map", "map.vtu")
        self.assertEqual(report["lines"], 12)
        self.assertEqual(report["extra_lines"], 0)
        self.assertEqual(report["flips"], 0)
        self.assertGreater(report["longest"], 0.5)
        self.assertLess(report["mismatch"], 1e-12)
        self.assertEqual(set(report["seconds"]), {"mesh", "map", "trace"})
        for name in ("lines.vtp", "faces.vtp", "map.vtu"):
            self.assertTrue((self.folder / name).is_file(), name)

    def test_counts_of_reference_cases(self):
        # docs/method.md §13.4; corners alone, a pair, and a ring with one extra line.
        write_configuration(self.folder / "pair.csv", [(0.45, 0.55, 1, 0.1), (1.3, 0.5, -1, 0.1)])
        for domain, options, faces, arcs, extra in (
                ("builtin:l-shape", (), 3, 10, 0), ("builtin:ring", (), 1, 3, 1),
                ("builtin:l-shape", ("-s", "pair.csv"), 9, 26, 0)):
            with self.subTest(domain):
                report = self.report(domain, *options)
                self.assertEqual((report["faces"], report["arcs"], report["extra_lines"]),
                                 (faces, arcs, extra))

    def test_the_same_bytes_twice(self):
        for name in ("first", "second"):
            self.succeed("separatrices", "builtin:disk", "-s", "four.csv", "-o", f"{name}.vtp",
                         "--map", f"{name}.vtu")
        self.assertEqual(self.digest("first.vtp"), self.digest("second.vtp"))
        self.assertEqual(self.digest("first.vtu"), self.digest("second.vtu"))

    def test_streamlines_from_seeds(self):
        write_configuration(self.folder / "seeds.csv", [(0.1, 0.2, 1, 0.1)])
        self.succeed("separatrices", "builtin:disk", "-s", "four.csv", "--seeds", "seeds.csv",
                     "-o", "lines.vtp")

    def test_what_cannot_be_mapped_is_refused(self):
        write_configuration(self.folder / "three.csv", [(0.4, 0.1, 3, 0.1), (-0.4, 0.1, 1, 0.1)])
        self.refuse("separatrices", "builtin:disk", "-s", "three.csv", "-o", "lines.vtp",
                    says=("quarter index 3", "split it"))
        self.refuse("separatrices", "builtin:disk", "-s", "four.csv", "-o", "lines.vtu",
                    says=(".vtp",))


if __name__ == "__main__":
    unittest.main()
