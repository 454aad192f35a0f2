"""Stores copies of the files that a test writes in the folder CROSSFIELD_WRITTEN, for
Verify.Everything.

Without this variable nothing is stored. The name of a copy contains the name of the test and a
fingerprint of the contents; equal files of several tests are stored once.

    python3 kept.py FOLDER -- COMMAND...    runs a command and stores the files that it wrote into the folder
"""
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

WRITTEN = os.environ.get("CROSSFIELD_WRITTEN", "")
TEST = os.environ.get("CROSSFIELD_TEST", pathlib.Path(sys.argv[0]).stem)


def keep(contents, stem, beside=()):
    """Stores the bytes of a .vtu and the files that belong to it."""
    fingerprint = hashlib.sha256(contents).hexdigest()[:16]
    folder = pathlib.Path(WRITTEN)
    if any(folder.glob("*.%s.vtu" % fingerprint)):
        return
    name = re.sub(r"[^\w.-]+", "_", "%s.%s" % (TEST, stem))
    part = folder / ("%s.%d.part" % (fingerprint, os.getpid()))
    part.write_bytes(contents)
    kept = folder / ("%s.%s.vtu" % (name, fingerprint))
    for path in beside:
        kept.with_suffix("".join(path.suffixes[-2:])).write_bytes(path.read_bytes())
    part.rename(kept)


def keep_folder(folder, since=0.0):
    """Stores every .vtu in a folder and its subfolders; with `since`, those written after that
    time. NAME.lines.vtp and NAME.faces.vtp belong to the map NAME.vtu."""
    if WRITTEN:
        for path in sorted(pathlib.Path(folder).rglob("*.vtu")):
            if path.is_file() and path.stat().st_mtime >= since:
                keep(path.read_bytes(), path.stem, [
                    path.with_suffix(".%s.vtp" % part) for part in ("lines", "faces")
                    if path.with_suffix(".%s.vtp" % part).exists()])


def keep_data(data):
    """Stores a data object of VTK if it is a drilled mesh or has a field."""
    if (not WRITTEN or not data.IsA("vtkUnstructuredGrid") or
            not data.GetCellData().HasArray("BoundaryKind")):
        return
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

    with tempfile.TemporaryDirectory(prefix="crossfield-") as folder:
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetFileName(os.path.join(folder, "data.vtu"))
        writer.SetInputDataObject(data)
        writer.SetDataModeToBinary()
        writer.Write()
        keep_folder(folder)


def keep_sources():
    """Stores, in pvpython, the output of every source and filter of this project."""
    if not WRITTEN:
        return
    from paraview import servermanager, simple

    for source in simple.GetSources().values():
        # Outputs of ParaView's own filters are not stored.
        if source.GetXMLName() in ("DrillHoles", "PerforatedCrossField", "GinzburgLandauCrossField",
                                   "HField", "QuadMesher"):
            keep_data(servermanager.Fetch(source))


def ran():
    """Records that the test ran, even if it writes nothing."""
    if WRITTEN:
        (pathlib.Path(WRITTEN) / (TEST + ".ran")).touch()


if __name__ == "__main__":
    split = sys.argv.index("--")
    begin = time.time() - 1.0  # file systems round times
    status = subprocess.run(sys.argv[split + 1:], check=False).returncode
    keep_folder(sys.argv[1], since=begin)
    sys.exit(status)
