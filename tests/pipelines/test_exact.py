"""docs/exact.md is what scripts/exact.py makes of this program, and errors fall with the mesh size."""

import importlib.util
import pathlib
import re

from program import PROGRAM, ProgramTest

ROOT = pathlib.Path(__file__).resolve().parents[2]
NUMBER = re.compile(r"-?[0-9]+\.[0-9]+")


def script():
    spec = importlib.util.spec_from_file_location("exact", ROOT / "scripts/exact.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Exact(ProgramTest):
    def test_the_page_and_the_errors(self):
        exact = script()
        table = exact.table(PROGRAM)
        page = exact.PAGE + "\n".join("| %s | %s | %s |" % entry[:3] for entry in table) + "\n"
        written = (ROOT / "docs/exact.md").read_text(encoding="utf-8")
        self.assertEqual(NUMBER.sub("", page), NUMBER.sub("", written))
        for new, old in zip(NUMBER.findall(page), NUMBER.findall(written)):
            self.assertAlmostEqual(float(new), float(old), delta=1e-3)  # other kernels of BLAS round otherwise
        for what, _, _, errors in table:
            if "scales" in what or len(errors) == 1:
                self.assertLess(max(errors), 0.01)
            else:  # of second order, but for what is exact at once
                self.assertLess(errors[-1], max(0.4 * errors[0], 2e-4), what)
