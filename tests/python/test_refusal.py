"""ParaView after an error: pvpython test_refusal.py PLUGIN, on a screen

The view shows no earlier result, the error is one sentence, and after the input is fixed the
picture is the same as before.
"""
import os
import sys
import tempfile

from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkIOImage import vtkPNGReader

from checks import check, check_equal

LoadPlugin(sys.argv[1], ns=globals())
domain = PlanarDomainSource()
singularities = SingularitySource()
good = list(singularities.Singularities)
drilled = DrillHoles(Input=domain, Singularities=singularities, MeshSize=0.1)
field = PerforatedCrossField(Input=drilled)
crosses = CrossGlyphs(Input=field)
poincare_check = PoincareHopfCheck(Input=domain, Singularities=singularities)
view = CreateRenderView(ViewSize=[400, 300], UseColorPaletteForBackground=0, Background=[1, 1, 1],
                        OrientationAxesVisibility=0)
surface = Show(field, view)
ColorBy(surface, ("POINTS", "CrossNorm"))
Show(crosses, view)
text = Show(OutputPort(poincare_check, 3), view)
text.Color = [1, 1, 1]  # updated but not visible
ResetCamera(view)


def draw():
    """Returns the pixels of the view, and the messages that were printed."""
    said, before = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(said)
    Render(view)
    vtkOutputWindow.SetInstance(before)
    with tempfile.TemporaryDirectory(prefix="crossfield-") as folder:
        name = os.path.join(folder, "view.png")
        SaveScreenshot(name, view)
        reader = vtkPNGReader()
        reader.SetFileName(name)
        reader.Update()
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)
    # Two further lines name the line of the source.
    return pixels, [line for line in said.GetOutput().splitlines() if line and "ERROR: In" not in line]


first, sentences = draw()
check_equal(sentences, [], "what is said of a good configuration")
check((first.min(axis=1) < 250).mean() > 0.2, "there is a field")
for rows, word in (([2, 0, 1, 0.1] + good[4:], "outside"), ([0.4, 0.4, 0.5, 0.1] + good[4:], "not an integer"),
                   (good[4:], "Poincaré-Hopf")):
    singularities.Singularities = rows
    pixels, sentences = draw()
    check((pixels.min(axis=1) > 250).all(), "%s: something stays in the view" % word)
    check(all("): " in line for line in sentences), "%s: noise:\n%s" % (word, "\n".join(sentences)))
    blamed = {line.split("): ", 1)[-1] for line in sentences}
    check(any(word in line for line in blamed), "%s: it is said" % word)
    check(not any("returned failure" in line for line in sentences), "%s: the executive repeats it" % word)
    print(word, "->", *sentences, sep="\n  ")
    check(field.GetDataInformation().GetNumberOfCells() == 0, "%s: the field is not empty" % word)
singularities.Singularities = good
last, sentences = draw()
check_equal(sentences, [], "what is said of the good configuration again")
check((first == last).all(), "the picture is the one before")
