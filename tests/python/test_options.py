"""Checks that docs/options.md is what scripts/options.py makes from the code, and that the script finds options without a row.

    python3 test_options.py PROGRAM
"""
import copy
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
import options  # noqa: E402

PROGRAM = sys.argv.pop(1)
HELP = """\
Positionals:
  DOMAIN TEXT REQUIRED        domain: a file

Options:
  -h,--help                   Print this help message and exit
  --size FLOAT:POSITIVE Excludes: --quads
                              mean side length, positive; default: from --quads
  --merge WORD:{none,clean} Excludes: --coarse
                              separatrices that
                              nearly meet; default: none
  --cap,--no-cap{false}       treat very sharp corners; default: on
  --curve NAME:KIND ...       curve of a side; repeatable
"""


class Options(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.panel, cls.options, cls.package = options.read(PROGRAM)

    def test_the_page(self):
        made = options.page(self.panel, self.options, self.package)
        self.assertEqual((ROOT / "docs" / "options.md").read_text(encoding="utf-8"), made,
                         "run scripts/options.py %s" % PROGRAM)

    def test_reads_the_help(self):
        self.assertEqual(options.options_of(HELP), {
            "DOMAIN": ("DOMAIN", "Domain: a file.", ""),
            "--size": ("--size FLOAT", "Mean side length, positive.", "from --quads"),
            "--merge": ("--merge none|clean", "Separatrices that nearly meet.", "none"),
            "--cap": ("--cap, --no-cap", "Treat very sharp corners.", "on"),
            "--curve": ("--curve NAME:KIND", "Curve of a side.", "")})

    def test_reads_groups_of_the_panel(self):
        self.assertEqual(list(self.panel.groups), ["Size", "Sides and layers", "Singularities", "Corners", "Other"])
        self.assertEqual((self.panel.group("Sides.Count"), self.panel.group("Input")), ("Sides and layers", "Other"))

    def refused(self, panel, found, package, sentence):
        with self.assertRaises(SystemExit) as raised:
            options.page(panel, found, package)
        self.assertIn(sentence, str(raised.exception))

    def test_finds_an_option_without_a_row(self):
        self.refused(self.panel, dict(self.options, **{"--new": ("--new", "New.", "")}), self.package, "No row has --new")

    def test_finds_an_argument_without_a_row(self):
        package = copy.deepcopy(self.package)
        package.names["quads"].append("new")
        self.refused(self.panel, self.options, package, "No row has argument new")

    def test_finds_an_option_that_is_no_longer_there(self):
        found = {name: option for name, option in self.options.items() if name != "--split"}
        self.refused(self.panel, found, self.package, "The program has no option --split")

    def test_finds_a_function_that_is_called_without_an_option(self):
        found = {name: option for name, option in self.options.items() if name != "--pairs"}
        self.refused(self.panel, found, self.package, "Pairs: pipelines/QuadsCommand.cxx does call SetPairs")

    def test_finds_a_wrong_default(self):
        panel = copy.deepcopy(self.panel)
        panel.property("Growth")[1].set("default_values", "1.3")
        self.refused(panel, self.options, self.package, "gives the default '1.25', but it is 1.3")


if __name__ == "__main__":
    unittest.main()
