"""Runs compare_methods.py and draw_fields.py as a user does.

    python3 test_compare.py SCRIPTS PLUGIN -- COMMAND...

SCRIPTS is the folder pipelines/pvpython; COMMAND runs a script, for example
`xvfb-run -a pvpython`.
"""
import os
import subprocess
import sys
import tempfile

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataReader

from checks import check, check_equal, value, values

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "verify"))
import kept  # noqa: E402

METHODS = ["constrained", "unit-holes", "penalty", "ginzburg-landau"]


def run(script, *options):
    done = subprocess.run(
        command + [os.path.join(scripts, script), "--plugin", plugin, *options], cwd=directory,
        text=True, check=False, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    print(script, *options, "->", done.returncode, done.stdout, done.stderr)
    return done


def written(name):
    return os.path.join(directory, name)


def shares_of(picture):
    """Returns the fractions of white, black and red pixels of a picture, and its size."""
    reader = vtkPNGReader()
    reader.SetFileName(written(picture))
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)
    red, green, blue = pixels.T
    return {"white": (pixels > 250).all(axis=1).mean(), "black": (pixels < 60).all(axis=1).mean(),
            "red": ((red > 180) & (green < 80) & (blue < 80)).mean(),
            "size": reader.GetOutput().GetDimensions()[:2]}


def test_table_file_and_picture():
    done = run("compare_methods.py", "--output", "all.vtm", "--picture", "all.png", "--size", "0.1",
               "--methods", ",".join(METHODS))
    check_equal(done.returncode, 0, "the exit status")
    table = [line.split() for line in done.stdout.splitlines() if line.split()[0] in METHODS]
    check_equal([row[0] for row in table], METHODS, "the methods in the table")

    reader = vtkXMLMultiBlockDataReader()
    reader.SetFileName(written("all.vtm"))
    reader.Update()
    group = reader.GetOutput()
    check_equal(group.GetNumberOfBlocks(), len(METHODS), "the number of blocks")
    right = -10.0
    for number, row in enumerate(table):
        block = group.GetBlock(number)
        check_equal(group.GetMetaData(number).Get(group.NAME()), row[0], "the name of a block")
        check(abs(value(block, "Energy") - float(row[1])) < 1e-3, "the energy of %s" % row[0])
        check_equal(value(block, "Converged"), 1, "Converged")
        check_equal(value(block, "UnwantedSingularities"), 0, "UnwantedSingularities")
        check(block.GetBounds()[0] > right, "the fields overlap")
        right = block.GetBounds()[1]
    check_equal(values(group.GetBlock(0), "HoleDegree"), [1, 1, 1, 1], "HoleDegree")
    for name in os.listdir(written("all")):
        with open(os.path.join(written("all"), name), "rb") as file:
            data = file.read()
        check(b'format="appended"' not in data, "%s has appended data" % name)
        check(b"vtkZLibDataCompressor" in data, "%s is not compressed" % name)
    shares = shares_of("all.png")
    check_equal(shares["size"], (500 * len(METHODS), 560), "the size of the picture")
    for what, least in (("white", 0.3), ("black", 0.01), ("red", 0.001)):
        check(shares[what] > least, "the picture has too little %s: %s" % (what, shares))


def test_drawing_of_files():
    files = [os.path.join("all", name) for name in sorted(os.listdir(written("all")))[:2]]
    done = run("draw_fields.py", "--picture", "two.png", "--width", "300", "--columns", "1", *files)
    check_equal(done.returncode, 0, "the exit status")
    shares = shares_of("two.png")
    check_equal(shares["size"][0], 300, "the width of the picture")
    check(shares["size"][1] > 500, "the fields are not below each other")
    for what, least in (("white", 0.1), ("black", 0.01), ("red", 0.001)):
        check(shares[what] > least, "the picture has too little %s: %s" % (what, shares))


def test_refusals():
    for options, says in ((("--methods", "guess"), "no method 'guess'"),
                          (("--domain", "ring", "--methods", "constrained"), "gave no cross field")):
        done = run("compare_methods.py", "--output", "refused.vtm", *options)
        check_equal(done.returncode, 1, "the exit status with %s" % (options,))
        check(says in done.stderr, "no sentence on standard error with %s" % (options,))
        check(not os.path.exists(written("refused.vtm")), "a file was written")


scripts, plugin = sys.argv[1:3]
command = sys.argv[4:]
with tempfile.TemporaryDirectory() as directory:
    for test in (test_table_file_and_picture, test_drawing_of_files, test_refusals):
        test()
        kept.keep_folder(directory)
        print(test.__name__, "passed")
