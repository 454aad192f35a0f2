"""Runs inputs through every subcommand. Each run must end with a correct result or with an
error."""

import json
import os
import resource
import subprocess

import domain_files
import verify
from program import PROGRAM, ProgramTest, SENTENCE, write_configuration
from verified import verified

SECONDS = 120  # limit of a run; most take a tenth of a second
MEMORY = 3 << 30  # limit of a run in bytes; a gap of 1e-4 needs 1.9 GB with one thread, up to 2.5 GB with two
OLD = "from an earlier run\n"
OUTPUTS = ("mesh.vtu", "field.vtu", "unit.vtu", "h.vtu", "better.csv", "corners.vtp", "all.vtm")

#: Every subcommand that reads a domain.
COMMANDS = {
    # Quads count a very sharp corner as an ordinary one; the fields of the other commands do not.
    "check": ("check", "{domain}", "-s", "{rows}", "--no-cap-corners", "--json", "-"),
    "corners": ("corners", "{domain}", "-o", "corners.vtp"),
    "drill": ("drill", "{domain}", "-s", "{rows}", "-o", "mesh.vtu"),
    "constrained": ("solve", "{domain}", "-s", "{rows}", "-o", "field.vtu", "--json", "-",
                    "--method", "constrained"),
    "unit-norm": ("solve", "{domain}", "-s", "{rows}", "-o", "unit.vtu", "--json", "-",
                  "--method", "unit-norm"),
    "hfield": ("hfield", "{domain}", "-s", "{rows}", "-o", "h.vtu", "--json", "-"),
    "energy": ("energy", "{domain}", "-s", "{rows}", "--json", "-"),
    "optimize": ("optimize", "{domain}", "-s", "{rows}", "-o", "better.csv", "--json", "-"),
    "compare": ("compare", "{domain}", "-s", "{rows}", "-o", "all.vtm", "--json", "-",
                "--methods", "constrained,unit-norm"),
}
SOLVES = ("constrained", "unit-norm")
WRITES_FIELD = {"constrained": "field.vtu", "unit-norm": "unit.vtu", "hfield": "h.vtu"}
DRILLS = ("drill", *SOLVES, "compare")  # the commands that drill holes


def loops(path, *curves):
    """Writes several closed curves as .vtp."""
    points, lines = [], []
    for curve in curves:
        first = len(points)
        points += curve
        lines.append([*range(first, len(points)), first])
    domain_files.write_vtp(path, points, lines)


def box(left, bottom, right, top):
    return [(left, bottom), (right, bottom), (right, top), (left, top)]


class CorpusTest(ProgramTest):
    """Counts inputs and results, and prints the counts at the end of a test."""

    #: Whether tests/verify checks the files. Its tolerances are for triangles of usual shape,
    #: coordinates of : the domain's size and crosses that the triangles resolve: tests at those
    #: limits say False.
    verify_all = True

    def setUp(self):
        super().setUp()
        self.solved = self.refused = self.answered = 0

    def tearDown(self):
        print(f"{self.id().split('.')[-1]}: {self.solved} runs solved and verified, "
              f"{self.refused} refused, {self.answered} with the answer no")
        super().tearDown()

    def run_program(self, *arguments, **options):
        options.setdefault("stdout", subprocess.PIPE)
        result = subprocess.run(
            [PROGRAM, *map(str, arguments)], cwd=self.folder, text=True, errors="replace",
            stderr=subprocess.PIPE, timeout=SECONDS, check=False, **options)
        most = 1024 * resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        self.assertLess(most, MEMORY, f"{arguments} took {most} bytes")
        return result

    def lay_out_old_files(self):
        for name in OUTPUTS:
            (self.folder / name).write_text(OLD)
            os.utime(self.folder / name, (1e9, 1e9))

    def command(self, name, domain, rows, more):
        arguments = [word.format(domain=domain, rows=rows) for word in COMMANDS[name]]
        # `check` and `corners` make no mesh and have no mesh size.
        return arguments + (list(more) if name not in ("check", "corners") else [])

    def configuration(self, rows):
        if isinstance(rows, str):
            return rows
        write_configuration(self.folder / "rows.csv", rows)
        return "rows.csv"

    def refuses(self, domain, rows=(), says=(), commands=tuple(COMMANDS), status=2, more=()):
        """Checks that every command ends with the status and one sentence, and changes no file."""
        rows = self.configuration(rows)
        for name in commands:
            with self.subTest(f"{name} {domain}"):
                self.lay_out_old_files()
                before = self.snapshot()
                result = self.run_program(*self.command(name, domain, rows, more))
                self.assertEqual(result.returncode, status, (result.args, result.stderr))
                self.assertRegex(result.stderr, SENTENCE)
                for part in (says,) if isinstance(says, str) else says:
                    self.assertIn(part, result.stderr)
                self.assertEqual(self.snapshot(), before, "a file was changed")
                self.refused += 1

    def solves(self, domain, rows=(), commands=tuple(COMMANDS), more=(), unwanted=False):
        """Checks that every command succeeds and writes correct files. Returns the reports by
        command."""
        rows = self.configuration(rows)
        reports = {}
        for name in commands:
            with self.subTest(f"{name} {domain}"):
                self.lay_out_old_files()
                result = self.run_program(*self.command(name, domain, rows, more))
                self.assertEqual(result.returncode, 0, (result.args, result.stderr))
                for line in result.stderr.splitlines():  # warning of the method whose field may vanish
                    self.assertRegex(line, "^Warning: The field has [0-9]+ unwanted")
                self.assertNotIn("nan", result.stdout.lower())
                reports[name] = json.loads(result.stdout) if name not in ("corners", "drill") else {}
                if name in SOLVES:
                    self.check_field(name, reports[name], unwanted)
                if name == "optimize":
                    self.check_optimum(domain, reports[name])
                if name in WRITES_FIELD:
                    self.check_agrees(WRITES_FIELD[name], reports[name])
                self.solved += 1
        return reports

    def check_optimum(self, domain, report):
        """Checks that it has converged to an energy not above the first, with the same quarter
        indices and no defect."""
        self.assertTrue(report["converged"], report)
        self.assertLessEqual(report["renormalized_energy_after"], report["renormalized_energy_before"])
        for defect in report["holonomy_defect"]:
            self.assertLess(abs(defect), 1e-3)
        result = self.run_program("check", domain, "-s", "better.csv", "--json", "-")
        self.assertEqual(result.returncode, 0, (result.args, result.stderr))

    def check_agrees(self, field, report):
        """Checks that `check` reports for the file what the run that wrote it reported."""
        result = self.run_program("check", field, "--json", "-")
        found = json.loads(result.stdout)
        for key in ("unwanted_singularities", "hole_degree", "hole_degree_reliable"):
            self.assertEqual(found[key], report[key], f"{key} of {field}")

    def check_field(self, name, report, unwanted):
        self.assertTrue(report["converged"] and report["degrees_reached"], report)
        if name == "unit-norm" and not unwanted:
            self.assertEqual(report["unwanted_singularities"], 0)
        path = self.folder / WRITES_FIELD[name]
        self.assertIsNone(verified(path))
        if self.verify_all:
            report = verify.verify(path)
            self.assertTrue(report.checks)
            self.assertFalse(report.failures(), report.text(everything=False))
