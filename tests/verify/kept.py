"""Keeps what a test writes, for Verify.Everything: copies in the folder of CROSSFIELD_WRITTEN.

Without that variable nothing is kept. A copy has the name of the test and a fingerprint of its
contents in its name; what several tests write alike is kept once.

    python3 kept.py FOLDER -- COMMAND...    runs a command and keeps what it wrote in the folder
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
    """The bytes of a .vtu, and the files that belong to it."""
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
    """Every .vtu in a folder and below; with `since`, those written after that time. NAME.lines.vtp and
    NAME.faces.vtp go with the map NAME.vtu."""
    if WRITTEN:
        for path in sorted(pathlib.Path(folder).rglob("*.vtu")):
            if path.is_file() and path.stat().st_mtime >= since:
                keep(path.read_bytes(), path.stem, [
                    path.with_suffix(".%s.vtp" % part) for part in ("lines", "faces")
                    if path.with_suffix(".%s.vtp" % part).exists()])


def keep_data(data):
    """A data object of VTK, if it is a drilled mesh or has a field."""
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
    """In pvpython: the output of every source and filter of this project that has one."""
    if not WRITTEN:
        return
    from paraview import servermanager, simple

    for source in simple.GetSources().values():
        # Not what ParaView's own filters leave of them.
        if source.GetXMLName() in ("DrillHoles", "PerforatedCrossField", "GinzburgLandauCrossField",
                                   "HField", "QuadMesher"):
            keep_data(servermanager.Fetch(source))


def ran():
    """Notes that the test ran, whether or not it writes anything."""
    if WRITTEN:
        (pathlib.Path(WRITTEN) / (TEST + ".ran")).touch()


if __name__ == "__main__":
    split = sys.argv.index("--")
    begin = time.time() - 1.0  # file systems round times
    status = subprocess.run(sys.argv[split + 1:], check=False).returncode
    keep_folder(sys.argv[1], since=begin)
    sys.exit(status)
