"""Base of the tests of the Python package: a square with two singularities, and checks of output
and errors."""
import contextlib
import functools
import os
import sys
import tempfile

import numpy as np

import crossfield

from checks import check, check_equal

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "verify"))
import kept  # noqa: E402

SQUARE = np.array([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)])
PAIR = np.array([(1.5, 1.0, 1, 0.1), (0.5, 1.0, -1, 0.1)])


def keeping(function):
    """Returns the function, whose results are also kept for the verifier."""
    @functools.wraps(function)
    def kept_function(*arguments, **options):
        result = function(*arguments, **options)
        kept.keep_data(result.grid)
        return result
    return kept_function


crossfield.drill, crossfield.solve = map(keeping, (crossfield.drill, crossfield.solve))


@contextlib.contextmanager
def silence():
    """Fails if Python or VTK print something in this context."""
    with tempfile.TemporaryFile() as file:
        kept = [os.dup(descriptor) for descriptor in (1, 2)]
        for descriptor in (1, 2):
            os.dup2(file.fileno(), descriptor)
        try:
            yield
        finally:
            for descriptor, old in zip((1, 2), kept):
                os.dup2(old, descriptor)
                os.close(old)
        file.seek(0)
        check_equal(file.read().decode(), "", "what was printed")


def write_rows(path, rows):
    with open(path, "w", encoding="utf-8") as file:
        file.write("x,y,quarter_index,radius\n")
        file.writelines(",".join(map(repr, map(float, row))) + "\n" for row in rows)


def expect_error(word, function, *arguments, inconsistent=False, **options):
    with silence():
        try:
            function(*arguments, **options)
        except crossfield.Error as error:
            sentence, found = str(error), error.inconsistent
        else:
            sentence = found = None
    check(sentence is not None, "no error that says '%s'" % word)
    check(word in sentence, "'%s' does not say '%s'" % (sentence, word))
    check("\n" not in sentence and sentence.endswith("."), "'%s' is no sentence" % sentence)
    check_equal(found, inconsistent, "inconsistent of '%s'" % sentence)
