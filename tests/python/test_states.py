"""The state files of the plugin, loaded from another directory and drawn.

    xvfb-run ... pvpython test_states.py PLUGIN STATE.py
"""
import os
import sys
import tempfile

import paraview.simple as simple
from paraview import servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from checks import check, check_equal

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "verify"))
import kept  # noqa: E402

plugin, state = sys.argv[1:]
simple.LoadPlugin(plugin, ns=vars(simple))  # as ParaView does before it loads a state
with tempfile.TemporaryDirectory(prefix="crossfield-") as directory:
    os.chdir(directory)
    with open(state, encoding="utf-8") as file:
        exec(compile(file.read(), state, "exec"), {"__name__": "state"})
    simple.RenderAllViews()
    kept.keep_sources()
    sources = simple.GetSources()
    check(len(sources) >= 2, "the state has its sources")
    for (name, _), source in sources.items():
        data = servermanager.Fetch(source)
        rows = data.GetNumberOfRows() if data.IsA("vtkTable") else data.GetNumberOfCells()
        check(rows > 0, "%s is not empty" % name)
        check(name != type(source).__name__ + "1", "%s has a name that says what it is" % name)
    for number, layout in enumerate(simple.GetLayouts().values()):
        picture = os.path.join(directory, "%d.png" % number)
        simple.SaveScreenshot(picture, layout, ImageResolution=[600, 400], SaveAllViews=1)
        reader = vtkPNGReader()
        reader.SetFileName(picture)
        reader.Update()
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)
        # A table occupies a part of the layout and is not drawn.
        check_equal(reader.GetOutput().GetDimensions()[0], 600, "the width of the picture")
        check((pixels.min(axis=1) > 250).mean() > 0.1, "there is white background")
        check((pixels.max(axis=1) < 60).mean() > 0.001, "there are black crosses")
        check(((pixels.max(axis=1) - pixels.min(axis=1)) > 15).mean() > 0.05, "there is colour")
