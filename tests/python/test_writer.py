"""The program compresses on all cores before VTK writes; the file must be the one VTK alone writes.

    python3 test_writer.py PROGRAM
"""
import os
import subprocess
import sys
import tempfile

from vtkmodules.vtkIOCore import vtkZLibDataCompressor
from vtkmodules.vtkIOXML import (vtkXMLPolyDataReader, vtkXMLPolyDataWriter,
                                 vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter)

from checks import check, check_equal

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "verify"))
import kept  # noqa: E402


def contents(name):
    with open(os.path.join(directory, name), "rb") as file:
        return file.read()


def check_file(name, reader, writer):
    reader.SetFileName(os.path.join(directory, name))
    reader.Update()
    check_equal(reader.GetErrorCode(), 0, "the error code of the reader")
    compressor = vtkZLibDataCompressor()
    compressor.SetCompressionLevel(1)
    writer.SetCompressor(compressor)
    writer.SetDataModeToBinary()
    writer.SetInputDataObject(reader.GetOutput())
    writer.SetFileName(os.path.join(directory, "rewritten"))
    writer.Write()
    check(len(contents(name)) > 1000, "the file is not empty")
    check_equal(contents(name), contents("rewritten"), "the bytes of " + name)


def run(*arguments):
    subprocess.run([sys.argv[1], *arguments], cwd=directory, check=True,
                   stdout=subprocess.DEVNULL, timeout=60)


with tempfile.TemporaryDirectory(prefix="crossfield-") as directory:
    run("domain", "disk", "-o", "disk.vtp")
    check_file("disk.vtp", vtkXMLPolyDataReader(), vtkXMLPolyDataWriter())
    with open(os.path.join(directory, "four.csv"), "w", encoding="utf-8") as csv:
        csv.write("x,y,quarter_index\n0.6,0,1\n0,0.6,1\n-0.6,0,1\n0,-0.6,1\n")
    # More than one block of 32 kB in every array.
    run("solve", "disk.vtp", "-s", "four.csv", "--size", "0.03", "-o", "field.vtu")
    check_file("field.vtu", vtkXMLUnstructuredGridReader(), vtkXMLUnstructuredGridWriter())
    kept.keep_folder(directory)
