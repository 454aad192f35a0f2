"""What was checked in one file: found deviations beside the tolerance and where that comes from."""
import numpy as np

ROUNDING = 2.0 ** -52


def rounding_of(array):
    """Of arrays that follow from others, which files have in single precision and old ones in double."""
    return 2.0 ** -23 if array.dtype == np.float32 else ROUNDING


class Unverifiable(Exception):
    """The file contradicts itself so early that nothing else can be recomputed."""


class Report:
    """Checks of one file, in the order in which they were made."""

    def __init__(self, name):
        self.name = name
        self.kind = "nothing of this project"
        self.checks = []
        self.notes = []

    def bound(self, name, found, tolerance, because):
        """A deviation that must not exceed a tolerance; NaN does."""
        self.checks.append((name, bool(found <= tolerance), float(found), float(tolerance), because))

    def equal(self, name, stated, found):
        """Integers, flags and lists of them: what the file states and what it holds."""
        good = stated == found
        self.checks.append((name, bool(good), None, None,
                            "" if good else "the file states %s, it has %s" % (stated, found)))

    def true(self, name, holds, otherwise=""):
        """A property without a number."""
        self.checks.append((name, bool(holds), None, None, "" if holds else otherwise))

    def note(self, sentence):
        """Something that is stated in the file and cannot be recomputed from it."""
        self.notes.append(sentence)

    def failures(self):
        return [check for check in self.checks if not check[1]]

    def text(self, everything=True):
        """One line a check; without `everything` those that failed only."""
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
