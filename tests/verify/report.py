"""The checks of one file: deviations with their tolerances and the reason for each tolerance."""
import numpy as np

ROUNDING = 2.0 ** -52


def rounding_of(array):
    """Returns the rounding of arrays that follow from others: single precision, in old files double
    precision."""
    return 2.0 ** -23 if array.dtype == np.float32 else ROUNDING


class Unverifiable(Exception):
    """Raised if the file is inconsistent and nothing else can be recomputed."""


class Report:
    """Checks of one file in order."""

    def __init__(self, name):
        self.name = name
        self.kind = "nothing of this project"
        self.checks = []
        self.notes = []

    def bound(self, name, found, tolerance, because):
        """Checks that a deviation does not exceed a tolerance; NaN fails."""
        self.checks.append((name, bool(found <= tolerance), float(found), float(tolerance), because))

    def equal(self, name, stated, found):
        """Checks that integers, flags or lists of them in the file equal the recomputed ones."""
        good = stated == found
        self.checks.append((name, bool(good), None, None,
                            "" if good else "the file states %s, it has %s" % (stated, found)))

    def true(self, name, holds, otherwise=""):
        """Checks a property."""
        self.checks.append((name, bool(holds), None, None, "" if holds else otherwise))

    def note(self, sentence):
        """Adds a statement of the file that cannot be recomputed."""
        self.notes.append(sentence)

    def failures(self):
        return [check for check in self.checks if not check[1]]

    def text(self, everything=True):
        """Returns one line per check; without `everything` only for those that failed."""
        lines = ["%s: %s, %d checks, %d failed" % (
            self.name, self.kind, len(self.checks), len(self.failures()))]
        for name, good, found, tolerance, because in self.checks:
            if good and not everything:
                continue
            numbers = "" if found is None else "%.2e, at most %.2e: " % (found, tolerance)
            lines.append("  %-4s %s  %s%s" % ("ok" if good else "FAIL", name, numbers, because))
        if everything:
            lines += ["  note " + note for note in self.notes]
        return "\n".join(lines)
