"""Base of the tests of the program: they run it as a user does, each in its own folder."""

import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "verify"))
import kept

PROGRAM = os.environ["CROSSFIELD_PROGRAM"]
SECONDS = int(os.environ.get("CROSSFIELD_SECONDS", "100"))  # limit for one run

FOUR = [(x, y, 1, 0.1) for x, y in ((0.42, 0.42), (-0.42, 0.42), (-0.42, -0.42), (0.42, -0.42))]

# One line that begins with the name of the program and ends with a full stop.
SENTENCE = re.compile(r"\Acrossfield: [^\n]+\.\n\Z")


def write_configuration(path, rows=FOUR):
    """Writes rows of x, y, quarter index and radius; texts are written unchanged."""
    lines = ["x,y,quarter_index,radius"] + [",".join(str(value) for value in row) for row in rows]
    pathlib.Path(path).write_text("\n".join(lines) + "\n")


class ProgramTest(unittest.TestCase):
    """Test in a folder that holds only four.csv, a configuration for the unit disk."""

    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="crossfield-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        write_configuration(self.folder / "four.csv")
        kept.ran()

    def run_program(self, *arguments, stdout=subprocess.PIPE, **options):
        begin = time.time()
        result = subprocess.run(
            [PROGRAM, *map(str, arguments)], cwd=self.folder, text=True, stdout=stdout,
            stderr=subprocess.PIPE, timeout=SECONDS, check=False, **options)
        if result.returncode in (0, 1) and set(arguments) & {"-o", "--output"}:
            kept.keep_folder(self.folder, since=begin)
        return result

    def snapshot(self):
        """Returns name, time and hash of everything in the folder."""
        return {
            str(path.relative_to(self.folder)): (
                path.stat().st_mtime_ns, self.digest(path) if path.is_file() else "folder")
            for path in sorted(self.folder.rglob("*"))}

    def digest(self, name):
        return hashlib.sha256((self.folder / name).read_bytes()).hexdigest()

    def succeed(self, *arguments):
        """Runs the program, which must be silent on standard error; returns its output."""
        result = self.run_program(*arguments)
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.args)
        return result.stdout

    def solve(self, domain, *arguments, singularities="four.csv"):
        """Returns the report of `solve` as a dictionary."""
        command = ("solve", domain, "-s", singularities, "--json", "-", *arguments)
        return json.loads(self.succeed(*self.with_output(command)))

    def with_output(self, arguments):
        """Adds an output, for the verifier, to a run that only reports."""
        if not kept.WRITTEN or {"-o", "--output"} & set(arguments):
            return arguments
        folder = tempfile.TemporaryDirectory(prefix="crossfield-")
        self.addCleanup(folder.cleanup)
        self.addCleanup(kept.keep_folder, folder.name)
        return (*arguments, "-o", pathlib.Path(folder.name) / "kept.vtu")

    def refuse(self, *arguments, says=(), status=2):
        """Runs the program, which must change nothing in the folder and report the cause in one
        sentence."""
        before = self.snapshot()
        result = self.run_program(*arguments)
        self.assertEqual(result.returncode, status, (result.args, result.stdout, result.stderr))
        self.assertRegex(result.stderr, SENTENCE)
        self.assertEqual(result.stdout, "")
        for part in says:
            self.assertIn(part, result.stderr)
        after = self.snapshot()
        self.assertEqual(list(after), list(before), "a file was added or removed")
        for name in before:
            self.assertEqual(after[name], before[name], f"{name} was touched")
        return result.stderr

    def refuse_solve(self, domain, *arguments, singularities="four.csv", **options):
        """Expects `solve` to refuse and to keep field.vtu and report.json of an earlier run."""
        for name in ("field.vtu", "report.json"):
            (self.folder / name).write_text("from an earlier run\n")
            os.utime(self.folder / name, (1e9, 1e9))
        return self.refuse("solve", domain, "-s", singularities, "-o", "field.vtu",
                           "--json", "report.json", *arguments, **options)
