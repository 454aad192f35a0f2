"""Draws the pictures of docs/layers.md from the domains in tests/data/layers.

    xvfb-run -a -s -noreset pvpython draw_layers.py PROGRAM FOLDER

Writes cylinder.png, profile.png, step_turn.png and step_leave.png to FOLDER.
"""
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from paraview.simple import (ColorBy, CreateView, GetColorTransferFunction, OpenDataFile, Render, SaveScreenshot,
                             Show)

DATA = pathlib.Path(__file__).resolve().parents[2] / "tests" / "data" / "layers"
COLOURS = ((250, 217, 204), (209, 230, 250), (217, 245, 214), (247, 240, 194), (232, 217, 245))
# Name, domain, options, and the part that is shown: x from, x to, y from, y to.
PICTURES = (
    ("cylinder", "cylinder", ("--quads", "3000", "--sizing", "conformal", "--layers", "cylinder:1e-3"),
     (0.08, 0.42, 0.04, 0.37)),
    ("profile", "profile", ("--quads", "10000", "--sizing", "conformal", "--layers", "profile:1e-4"),
     (-1.0, 2.0, -1.45, 1.45)),
    ("step_turn", "step", ("--quads", "6000", "--layers", "wall:1e-2"), (2.9, 6.1, -0.05, 2.05)),
    ("step_leave", "step", ("--quads", "6000", "--layers", "wall:1e-2", "--corner", "4,1:leave"),
     (2.9, 6.1, -0.05, 2.05)),
)


def draw(mesh, file, part, width=600):
    left, right, lower, upper = part
    quads = OpenDataFile(str(mesh))
    view = CreateView("RenderView")
    view.ViewSize = [width, int(width * (upper - lower) / (right - left))]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    shown = Show(quads, view)
    shown.SetRepresentationType("Surface With Edges")
    shown.EdgeColor = [0.25, 0.25, 0.25]
    ColorBy(shown, ("CELLS", "BlockId"))
    shown.SetScalarBarVisibility(view, False)
    table = GetColorTransferFunction("BlockId")
    points = []
    for block in range(60):
        points += [block, *(np.array(COLOURS[block * 7 % len(COLOURS)]) / 255)]
    table.RGBPoints = points
    Render(view)
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = [(left + right) / 2, (lower + upper) / 2, 0]
    view.CameraPosition = [(left + right) / 2, (lower + upper) / 2, 10]
    view.CameraViewUp = [0, 1, 0]
    view.CameraParallelScale = (upper - lower) / 2
    Render(view)
    SaveScreenshot(str(file), view)


def main(program, folder):
    pathlib.Path(folder).mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as work:
        for name, domain, options, part in PICTURES:
            mesh = pathlib.Path(work) / (name + ".vtu")
            subprocess.run([program, "quads", DATA / (domain + ".vtp"), "-o", mesh, *options], check=True,
                           stdout=subprocess.DEVNULL)
            draw(mesh, pathlib.Path(folder) / (name + ".png"), part)


main(*sys.argv[1:])
