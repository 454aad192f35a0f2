"""Meshes the drawings of docs/drawings and draws the pictures of docs/drawings.md, coloured by side.

    xvfb-run -a pvpython scripts/pictures/drawings.py PROGRAM FOLDER
"""
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import sides  # noqa: E402

program, folder = sys.argv[1:3]
drawings = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "docs", "drawings")
with tempfile.TemporaryDirectory() as work:
    quads = os.path.join(work, "quads.vtu")
    for name, options in (("bracket.dxf", ["--quads", "1500", "--count", "bore:40"]),
                          ("plate.step", ["--quads", "600", "--count", "hole:32"])):
        subprocess.run([program, "quads", os.path.join(drawings, name), "-o", quads, *options], check=True)
        sides.draw(quads, os.path.join(folder, name.split(".")[0] + ".png"))
