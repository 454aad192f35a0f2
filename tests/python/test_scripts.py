"""Runs the scripts of pipelines/pvpython as a user does.

    python3 test_scripts.py SCRIPT.py [--plugin PLUGIN] -- COMMAND...

COMMAND runs the script, for example `xvfb-run -a pvpython`. With --plugin the script must also
draw a picture. Files go to a temporary directory.
"""
import argparse
import os
import subprocess
import sys
import tempfile

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

from checks import check, check_default_field, check_equal

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "verify"))
import kept  # noqa: E402

FOUR = "x,y,quarter_index,radius\n" + "".join(
    "%g,%g,1,0.1\n" % place for place in ((0.42, 0.42), (-0.42, 0.42), (-0.42, -0.42), (0.42, -0.42)))


def run(*options):
    """Runs the script; returns its exit status, output and errors."""
    command = arguments.command + [arguments.script] + list(options)
    if arguments.plugin:
        command += ["--plugin", arguments.plugin, "--picture", "field.png"]
    done = subprocess.run(command, cwd=directory, text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    print(*command, "->", done.returncode, done.stdout, done.stderr)
    return done


def written(name):
    return os.path.join(directory, name)


def check_field_file():
    with open(written("field.vtu"), "rb") as file:
        check(b'format="appended"' not in file.read(), "the file has appended data")
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(written("field.vtu"))
    reader.Update()
    check_equal(reader.GetErrorCode(), 0, "the error code of the reader")
    check_default_field(reader.GetOutput(), 20.7)  # of the constrained method


def check_picture():
    reader = vtkPNGReader()
    reader.SetFileName(written("field.png"))
    reader.Update()
    check_equal(reader.GetOutput().GetDimensions(), (1200, 1200, 1), "the size of the picture")
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)
    red, green, blue = pixels.T
    shares = {"white background": (pixels > 250).all(axis=1).mean(),
              "black crosses": (pixels < 60).all(axis=1).mean(),
              "blue domain": (blue > red + 20).mean(),
              "red holes": ((red > 180) & (green < 80) & (blue < 80)).mean()}
    for what, least in (("white background", 0.2), ("black crosses", 0.01), ("blue domain", 0.2),
                        ("red holes", 0.001)):
        check(shares[what] > least, "the picture has too little of: %s (%s)" % (what, shares))


def test_default():
    done = run("--output", "field.vtu")
    check_equal(done.returncode, 0, "the exit status")
    check("energy 20." in done.stdout, "the energy is not printed")
    check_field_file()
    if arguments.plugin:
        check_picture()


def test_file():
    with open(written("four.csv"), "w", encoding="utf-8") as file:
        file.write(FOUR)
    done = run("--output", "field.vtu", "--singularities", "four.csv")
    check_equal(done.returncode, 0, "the exit status with a file")
    check_field_file()


def test_refusal():
    with open(written("outside.csv"), "w", encoding="utf-8") as file:
        file.write(FOUR + "3,0,1,0.1\n")
    for name in ("outside.csv", "missing.csv"):
        done = run("--output", "refused.vtu", "--singularities", name)
        check_equal(done.returncode, 1, "the exit status with %s" % name)
        check("above says why" in done.stderr, "no sentence on standard error with %s" % name)
        check(not os.path.exists(written("refused.vtu")), "a file was written with %s" % name)


parser = argparse.ArgumentParser()
parser.add_argument("script")
parser.add_argument("--plugin", default="")
parser.add_argument("command", nargs="+")
arguments = parser.parse_args()
with tempfile.TemporaryDirectory() as directory:
    for test in (test_default, test_file, test_refusal):
        test()
        kept.keep_folder(directory)
        print(test.__name__, "passed")
