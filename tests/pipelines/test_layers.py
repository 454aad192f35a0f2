"""crossfield quads --layers and --corner: reports, the page on layers, and refusals."""
import json
import pathlib
import re
import shlex
import unittest

from program import ProgramTest

ROOT = pathlib.Path(__file__).resolve().parents[2]
LAYERS = ROOT / "tests" / "data" / "layers"


class Layers(ProgramTest):
    def report(self, domain, *arguments):
        return json.loads(self.succeed("quads", domain, "-o", "quads.vtu", "--json", "-", *arguments))

    def expect_layer(self, layer, side, first, growth=1.2):
        self.assertEqual(layer["side"], side)
        self.assertEqual(layer["first"], first)
        self.assertGreaterEqual(layer["in_bounds"], 0.95)
        self.assertLessEqual(layer["growth"], growth * (1 + 1e-9))
        self.assertGreater(layer["rows"], layer["replaced"])
        self.assertLessEqual(layer["heights"]["min"], layer["heights"]["max"])
        self.assertGreater(layer["thickness"], layer["rows"] * first)

    def test_profile_has_a_c_grid(self):
        report = self.report(LAYERS / "profile.vtp", "--quads", "10000", "--sizing", "conformal",
                             "--layers", "profile:1e-4", "--blocks", "blocks.vtm")
        layer, = report["layers"]
        self.expect_layer(layer, "profile", 1e-4)
        self.assertEqual(layer["in_bounds"], 1)
        self.assertLessEqual(layer["ratio"], 2)
        self.assertEqual(report["irregular"], {})
        self.assertEqual(report["inverted"], 0)
        self.assertGreaterEqual(report["scaled_jacobian"]["min"], 0.9)
        self.assertLess(abs(report["quads"] - 10000), 500)
        # The layer is a row of blocks of its own.
        self.assertEqual(report["blocks"], 6)
        self.assertTrue((self.folder / "blocks" / "block5.vts").is_file())

    def test_cylinder_and_walls(self):
        report = self.report(LAYERS / "cylinder.vtp", "--quads", "3000", "--sizing", "conformal",
                             "--layers", "cylinder:1e-3")
        self.expect_layer(report["layers"][0], "cylinder", 1e-3)
        self.assertGreaterEqual(report["scaled_jacobian"]["min"], 0.92)
        report = self.report(LAYERS / "cylinder.vtp", "--quads", "12000", "--layers", "cylinder:1e-3", "--layers",
                             "wall:1e-3,1.25")
        self.expect_layer(report["layers"][0], "cylinder", 1e-3)
        self.expect_layer(report["layers"][1], "wall", 1e-3, 1.25)
        self.assertEqual(report["inverted"], 0)

    def test_plate_with_three_holes_and_four_sides(self):
        names = ["outer%d" % i for i in range(4)] + ["hole%d" % i for i in range(3)]
        report = self.report(ROOT / "tests" / "data" / "parts" / "plate3.vtp", "--quads", "8000", "--sizing",
                             "conformal", *(word for name in names for word in ("--layers", name + ":0.1")))
        for layer, name in zip(report["layers"], names):
            self.expect_layer(layer, name, 0.1)
            self.assertLessEqual(layer["ratio"], 2.6)
        self.assertEqual(report["inverted"], 0)
        self.assertGreaterEqual(report["scaled_jacobian"]["min"], 0.88)

    def test_rows_turn_around_a_step_or_leave_it(self):
        arguments = (LAYERS / "step.vtp", "--size", "0.1", "--layers", "wall:1e-3")
        turned = self.report(*arguments)
        left = self.report(*arguments, "--corner", "4,1:leave")
        self.assertEqual(turned["irregular"], {"5": 1})
        self.assertEqual(left["irregular"], {})
        self.assertEqual(self.report(*arguments, "--corner", "200-300:leave")["quads"], left["quads"])
        self.assertEqual(self.report(*arguments, "--corner", "wall:turn")["quads"], turned["quads"])
        for report in (turned, left):
            self.expect_layer(report["layers"][0], "wall", 1e-3)

    def test_number_of_rows(self):
        report = self.report("builtin:square", "--size", "0.1", "--layers", "outer0:1e-3,1.3,20")
        self.assertEqual(report["layers"][0]["rows"], 20)

    def test_layers_are_printed(self):
        self.assertIn("layer of 'outer1': ", self.succeed("quads", "builtin:square", "-o", "quads.vtu", "--size", "0.1",
                                                          "--layers", "outer1:1e-3", "--verbose"))
        self.assertNotIn("layers", self.report("builtin:square", "--size", "0.1"))

    def test_rows_of_equal_height_rows_of_quads_and_all_holes(self):
        equal, = self.report(LAYERS / "step.vtp", "--size", "0.1", "--layers", "wall:0.02,1")["layers"]
        self.assertEqual(equal["in_bounds"], 1)
        self.assertLessEqual(equal["growth"], 1 + 1e-9)
        report = self.report("builtin:ring", "--quads", "1500", "--layers", "holes:,,7", "--count", "holes:48")
        quads, = report["layers"]
        self.assertEqual((quads["side"], quads["first"], quads["replaced"], quads["rows"]), ("hole0", 0, 7, 7))
        self.assertEqual({side["name"]: side["edges"] for side in report["sides"]}["hole0"], 48)
        self.refuse("quads", "builtin:disk", "-o", "quads.vtu", "--layers", "holes:1e-3", says=("no side 'holes'",))

    def test_impossible_prescriptions_are_refused(self):
        step = LAYERS / "step.vtp"
        for arguments, says in (
                (("--layers", "wal:1e-3"), "no side 'wal' for a layer; give 'wall', 'outlet' or 'inlet'"),
                (("--layers", "wall"), "has no colon"),
                (("--layers", "wall:thin"), "The height of the first row 'thin' of side 'wall'"),
                (("--layers", "wall:1e-3,1.2,3,4"), "more than three numbers"),
                (("--layers", "wall:1e-3,1.2,2.5"), "number of rows '2.5' of side 'wall' is not valid"),
                (("--layers", "wall:0"), "first height of 0"),
                (("--layers", "wall:1e-30"), "below the digits of coordinates; give at least"),
                (("--layers", "wall:nan"), "'nan' of side 'wall' is not valid"),
                (("--layers", "wall:1e-3,0.9"), "growth of 0.9; give a number from 1 to 3"),
                (("--layers", "wall:,"), "has no number"),
                (("--layers", "wall:0.5"), "is not below the height"),
                (("--layers", "wall:1e-3,1.2,4"), "but 4 are prescribed"),
                (("--layers", "wall:1e-3", "--layers", "wall:1e-4"), "'wall' has two layers"),
                (("--layers", "wall:1e-3,1.2,20", "--layers", "inlet:1e-3", "--corner", "0,1:turn"), "let them end"),
                (("--corner", "4,1:follow"), "What rows do at '4,1' is 'follow'; give end, turn or leave"),
                (("--corner", "4,1"), "has no colon"),
                (("--corner", "4,1:end"), "an angle of 270°, but rows can end only at less than 170°; let them turn"),
                (("--corner", "4,0:leave"), "an angle of 90°"),
                (("--corner", "5,0:turn"), "no corner at (5, 0)"),
                (("--corner", "lid:turn"), "no corner of a side 'lid'"),
                (("--corner", "300-340:leave"), "no corner with an angle of 300° to 340°"),
                (("--corner", "4,1:turn", "--corner", "4,1:leave"), "treated in two ways"),
                (("--layers", "wall:1e-3", "--count", "inlet:12"),
                 "12 are prescribed; leave out this number or the layer.")):
            with self.subTest(arguments):
                self.refuse("quads", step, "-o", "quads.vtu", "--size", "0.2", *arguments, says=(says,))

    def test_commands_of_the_page(self):
        page = (ROOT / "docs" / "layers.md").read_text()
        commands = re.findall(r"^crossfield (.*)$", page, re.MULTILINE)
        self.assertGreater(len(commands), 5)
        for command in commands:
            arguments = [str(ROOT / word) if word.startswith("tests/") else word
                         for word in shlex.split(command, comments=True)]
            with self.subTest(command):
                said = re.search(r'# exit status 2, "(.*)"', command)
                if said:
                    self.refuse(*arguments, says=(said.group(1),))
                else:
                    self.succeed(*arguments)


if __name__ == "__main__":
    unittest.main()
