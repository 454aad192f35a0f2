"""Damaged files of every format: a result or one sentence, never a crash, and no file written."""

import random
import subprocess
import time
import unittest

import domain_files
from program import PROGRAM, SENTENCE, ProgramTest

CIRCLE = [(x, y) for x, y in ((1, 0), (0.7, 0.7), (0, 1), (-0.7, 0.7), (-1, 0), (-0.7, -0.7),
                              (0, -1), (0.7, -0.7))]
FAN = [(0, i, i + 1) for i in range(1, 7)]
# Replacements for a number in a file.
NUMBERS = [b"-1", b"0", b"7", b"255", b"65536", b"2147483648", b"-9223372036854775808",
           b"18446744073709551615", b"1e300"]


def damage(content, random_numbers):
    """Returns a copy that is cut, or has changed bytes, changed numbers, or a part repeated."""
    at = random_numbers.randrange(len(content))
    kind = random_numbers.randrange(4)
    if kind == 0:
        return content[:at]
    if kind == 1:
        return content[:at] + bytes([random_numbers.randrange(256)]) + content[at + 1:]
    if kind == 2:
        end = at + random_numbers.randrange(40)
        return content[:end] + content[at:]
    begin = at
    while begin < len(content) and not content[begin:begin + 1].isdigit():
        begin += 1
    end = begin
    while content[end:end + 1].isdigit():
        end += 1
    return content[:begin] + random_numbers.choice(NUMBERS) + content[end:]


class DamagedFiles(ProgramTest):
    COPIES = 12

    def check(self, name):
        started = time.monotonic()
        before = self.snapshot()
        # `check` writes nothing and reads the file as any other domain.
        result = subprocess.run([PROGRAM, "check", name], cwd=self.folder, capture_output=True,
                                timeout=60, check=False)
        said = result.stderr.decode(errors="replace")
        self.assertIn(result.returncode, (0, 1, 2), (name, result))
        if result.returncode == 2:
            self.assertRegex(said, SENTENCE)
            self.assertEqual(result.stdout, b"")
        self.assertEqual(self.snapshot(), before)
        self.assertLess(time.monotonic() - started, 30.0)

    def damage_all(self, good):
        random_numbers = random.Random(good)
        content = (self.folder / good).read_bytes()
        self.check(good)
        for copy in range(self.COPIES):
            name = f"bad{copy}.{good.split('.')[-1]}"
            (self.folder / name).write_bytes(damage(content, random_numbers))
            with self.subTest(f"{good} {copy}"):
                self.check(name)

    def test_vtp(self):
        domain_files.write_loop(self.folder / "good.vtp", CIRCLE)
        self.damage_all("good.vtp")

    def test_vtu(self):
        domain_files.write_vtu(self.folder / "good.vtu", CIRCLE, FAN)
        self.damage_all("good.vtu")

    def test_vtu_of_the_program(self):
        self.succeed("solve", "builtin:disk", "-s", "four.csv", "--size", "0.4", "-o", "good.vtu")
        self.damage_all("good.vtu")

    def test_vtk(self):
        domain_files.write_vtk(self.folder / "good.vtk", CIRCLE, FAN)
        self.damage_all("good.vtk")

    def test_stl(self):
        domain_files.write_stl(self.folder / "good.stl", CIRCLE, FAN)
        self.damage_all("good.stl")

    def test_obj(self):
        domain_files.write_obj(self.folder / "good.obj", CIRCLE, FAN)
        self.damage_all("good.obj")

    def test_ply(self):
        domain_files.write_ply(self.folder / "good.ply", CIRCLE, FAN)
        self.damage_all("good.ply")

    def test_csv(self):
        domain_files.write_csv(self.folder / "good.csv", CIRCLE)
        self.damage_all("good.csv")

    def refuse_counts(self, good, count):
        """A number that requests terabytes ends in a sentence."""
        text = (self.folder / good).read_text()
        self.assertIn(count, text)
        for many in ("1600000000", "1600000000000"):
            with self.subTest(f"{many} in {good}"):
                digits = "".join(filter(str.isdigit, count))
                bad = f"bad.{good.split('.')[-1]}"
                (self.folder / bad).write_text(text.replace(count, count.replace(digits, many)))
                self.refuse("check", bad, says=[f"'{bad}'", "cannot be read"])

    def test_counts_that_no_memory_holds(self):
        domain_files.write_vtk(self.folder / "good.vtk", CIRCLE, FAN)
        self.refuse_counts("good.vtk", "POINTS 8 double")
        domain_files.write_ply(self.folder / "good.ply", CIRCLE, FAN)
        self.refuse_counts("good.ply", "element vertex 8")
        domain_files.write_vtu(self.folder / "good.vtu", CIRCLE, FAN)
        self.refuse_counts("good.vtu", 'NumberOfPoints="8"')


if __name__ == "__main__":
    unittest.main()
