"""Meshes and draws the pictures of docs/surfaces.md.

    xvfb-run -a -s -noreset pvpython scripts/pictures/surfaces.py PROGRAM FOLDER
"""
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from surface_shapes.bodies import frame_of_potentials
from surface_shapes.parts import panel
from surface_shapes.triangles import write
from surface_view import add_quads, new_window, save

SIDE = 420  # of a panel, in pixels


def draw(program, inputs, path):
    """Meshes surfaces, given with a number of quads and a direction of view, and draws them beside each other."""
    window = new_window(SIDE * len(inputs), SIDE)
    with tempfile.TemporaryDirectory() as work:
        for column, (surface, count, direction) in enumerate(inputs):
            quads = os.path.join(work, "quads.vtu")
            subprocess.run([program, "quads", surface, "--quads", str(count), "-o", quads], check=True)
            add_quads(quads, window, (column / len(inputs), 0, (column + 1) / len(inputs), 1), direction)
    save(window, path)


def main(program, folder):
    docs = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../docs/surfaces/")
    with tempfile.TemporaryDirectory() as work:
        ring, plate = os.path.join(work, "ring.vtp"), os.path.join(work, "panel.vtp")
        write(frame_of_potentials(), ring)
        write(panel(), plate)
        draw(program, ((docs + "ellipsoid.off", 1200, (2, -3, 1.6)), (ring, 2500, (0.5, -2, 3)),
                       (plate, 1200, (0.4, -1.4, 3))), os.path.join(folder, "chosen.png"))
    draw(program, ((docs + "bracket.off", 1500, (2, -3, 3)), (docs + "bracket.off", 1500, (-2, 3, -3))),
         os.path.join(folder, "bracket.png"))


main(*sys.argv[1:])
