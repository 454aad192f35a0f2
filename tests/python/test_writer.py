"""Files of the program, compressed on all cores by libdeflate, have the same elements and values as
files of VTK.

    python3 test_writer.py PROGRAM
"""
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

from vtkmodules.vtkIOXML import (vtkXMLPolyDataReader, vtkXMLPolyDataWriter,
                                 vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter)

from checks import check, check_equal

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "verify"))
import kept  # noqa: E402

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "corpus"))
import verified  # noqa: E402


def elements(name):
    """Returns tags and attributes without ranges and their description, which readers do not
    need."""
    root = ElementTree.parse(os.path.join(directory, name)).getroot()
    return [(item.tag, {key: text for key, text in item.attrib.items() if not key.startswith("Range")
                         and (key, item.get("NumberOfTuples")) != ("format", "0")})
            for item in root.iter() if item.tag not in ("InformationKey", "Value")]


def check_file(name, reader, writer, fewest):
    """Checks that a file read without VTK equals its copy that VTK has read and written."""
    reader.SetFileName(os.path.join(directory, name))
    reader.Update()
    check_equal(reader.GetErrorCode(), 0, "the error code of the reader")
    writer.SetDataModeToBinary()
    writer.SetInputDataObject(reader.GetOutput())
    writer.SetFileName(os.path.join(directory, "rewritten"))
    writer.Write()
    check_equal(elements(name), elements("rewritten"), "what the file has")
    found = verified.read(os.path.join(directory, name))
    expected = verified.read(os.path.join(directory, "rewritten"))
    check(len(found) >= fewest, "there are arrays")
    for key, values in expected.items():
        check_equal(found[key].dtype, values.dtype, "the type of %s of %s" % key)
        check(found[key].shape == values.shape and (found[key] == values).all(), "%s of %s" % key)


def check_meshio(name):
    try:
        import meshio
    except ImportError:
        return
    found = verified.read(os.path.join(directory, name))
    mesh = meshio.read(os.path.join(directory, name))
    check((mesh.points == found["Points", "Points"].reshape(-1, 3)).all(), "points as meshio reads them")
    exact = [mesh.cell_data["CrossFieldCR"][i] for i, block in enumerate(mesh.cells) if block.type == "triangle"]
    triangles = found["Cells", "types"] == 5
    check((exact[0] == found["CellData", "CrossFieldCR"][triangles]).all(), "the field as meshio reads it")


def run(*arguments):
    subprocess.run([sys.argv[1], *arguments], cwd=directory, check=True,
                   stdout=subprocess.DEVNULL, timeout=60)


with tempfile.TemporaryDirectory(prefix="crossfield-") as directory:
    run("domain", "disk", "-o", "disk.vtp")
    check_file("disk.vtp", vtkXMLPolyDataReader(), vtkXMLPolyDataWriter(), 1)
    with open(os.path.join(directory, "four.csv"), "w", encoding="utf-8") as csv:
        csv.write("x,y,quarter_index\n0.6,0,1\n0,0.6,1\n-0.6,0,1\n0,-0.6,1\n")
    # Arrays of one block, and of several blocks with a shorter last one.
    run("solve", "disk.vtp", "-s", "four.csv", "--size", "0.02", "-o", "field.vtu")
    check_file("field.vtu", vtkXMLUnstructuredGridReader(), vtkXMLUnstructuredGridWriter(), 25)
    check_meshio("field.vtu")
    run("hfield", "disk.vtp", "-s", "four.csv", "--size", "0.5", "--arrays", "exact", "-o", "h.vtu")
    check_file("h.vtu", vtkXMLUnstructuredGridReader(), vtkXMLUnstructuredGridWriter(), 20)
    kept.keep_folder(directory)
