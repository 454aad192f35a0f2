"""Pages whose numbers scripts compute with the program: docs/exact.md, docs/quads.md, and the memory in
docs/limits.md."""

import importlib.util
import pathlib
import re
import subprocess
import sys

from program import PROGRAM, ProgramTest

ROOT = pathlib.Path(__file__).resolve().parents[2]
NUMBER = re.compile(r"-?[0-9]+\.[0-9]+")


def script(name):
    spec = importlib.util.spec_from_file_location(name, ROOT / f"scripts/{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Exact(ProgramTest):
    def test_the_page_and_the_errors(self):
        exact = script("exact")
        table = exact.table(PROGRAM)
        page = exact.PAGE + "\n".join("| %s | %s | %s |" % entry[:3] for entry in table) + "\n"
        written = (ROOT / "docs/exact.md").read_text(encoding="utf-8")
        self.assertEqual(NUMBER.sub("", page), NUMBER.sub("", written))
        for new, old in zip(NUMBER.findall(page), NUMBER.findall(written)):
            self.assertAlmostEqual(float(new), float(old), delta=1e-3)  # kernels of BLAS round differently
        for what, _, _, errors in table:
            if "scales" in what or len(errors) == 1:
                self.assertLess(max(errors), 0.01)
            else:  # second order, except values that are exact on every mesh
                self.assertLess(errors[-1], max(0.4 * errors[0], 2e-4), what)


class WholeRuns(ProgramTest):
    def test_the_memory_is_what_the_page_says(self):
        limits = script("limits")
        page = (ROOT / "docs/limits.md").read_text(encoding="utf-8")
        self.assertIn(limits.HEAD, page)
        row, = limits.table(PROGRAM, [100000])
        name = row.split(" | ", maxsplit=1)[0]
        written, = (line for line in page.partition(limits.HEAD)[2].splitlines() if line.startswith(name + " | "))
        # Seconds depend on the machine.
        memory = re.compile(r"([0-9.]+) GiB")
        self.assertEqual(len(memory.findall(row)), len(limits.COMMANDS))
        for found, old in zip(map(float, memory.findall(row)), map(float, memory.findall(written))):
            # The libraries of Debian 13's ParaView take 0.05 GiB more than those of Debian 12's, for which the page is.
            self.assertAlmostEqual(found, old, delta=0.25 * old + 0.05)


class Gallery(ProgramTest):
    def compare(self, page, maker):
        """Compares a page of docs with what a script in scripts writes."""
        subprocess.run([sys.executable, str(ROOT / "scripts" / maker), PROGRAM, str(self.folder)], check=True,
                       stdout=subprocess.DEVNULL)
        made = (self.folder / page).read_text(encoding="utf-8").splitlines()
        written = (ROOT / "docs" / page).read_text(encoding="utf-8").splitlines()
        self.assertEqual(len(made), len(written))
        rows = [pair for pair in zip(made, written) if pair[0].startswith("| ") and pair[0] != pair[1]]
        self.assertEqual([pair for pair in zip(made, written) if pair[0] != pair[1] and pair not in rows], [])
        number = re.compile(r"-?[0-9]+(?:\.[0-9]+)?")
        changed = []
        for new, old in rows:
            # The last cell is seconds. Kernels of BLAS round differently, which may add a block to a few.
            cells = [line.rstrip(" |").rpartition("|")[0] for line in (new, old)]
            values = [list(map(float, number.findall(cell))) for cell in cells]
            if number.sub("", cells[0]) != number.sub("", cells[1]) or any(
                    abs(a - b) > max(0.05 * abs(b), 1.0 if b == int(b) else 1e-3) for a, b in zip(*values)):
                changed.append((new, old))
        self.assertEqual(changed, [], "%s writes the page" % maker)


class GalleryOfQuads(Gallery):
    def test_the_page_has_the_numbers_of_the_program(self):
        self.compare("quads.md", "quads_gallery.py")


class GalleryOfRegions(Gallery):
    def test_the_page_has_the_numbers_of_the_program(self):
        self.compare("regions_gallery.md", "regions_gallery.py")
