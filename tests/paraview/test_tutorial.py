"""Steps 2 to 6 of docs/tutorial_paraview.md in ParaView's client, and their pictures; started by run_client.py.

test_recorded_run.py performs step 7.
"""
import os

from paraview.simple import *

from gui_driver import apply, check, check_equal, gui, make, messages, run, wait
from tutorial_texts import tutorial_picture

PAGE = os.path.join(os.environ["STATES"], "..", "..", "docs", "tutorial_paraview.md")


def step_domain():
    with open(PAGE, encoding="utf-8") as page:
        rows = page.read().split("```csv polygon.csv\n")[1].split("```")[0].splitlines()[1:]
    check(gui.gui_trigger(b"Poly Line Source"), "no Poly Line Source in the menu")
    wait()
    domain = GetActiveSource()
    domain.Points = [float(number) for row in rows for number in row.split(",") + ["0"]]
    domain.Closed = 1
    apply()
    GetActiveView().InteractionMode = "2D"
    ResetCamera()
    GetActiveView().CameraParallelScale *= 1.25  # space for the legend of step_field
    tutorial_picture("domain")


def step_singularities():
    points = make("Singularity Source")
    check_equal(gui.gui_rows(), 4, "rows of the table")
    tutorial_picture("singularities")
    rows = list(points.Singularities)
    points.Singularities = rows[:12]
    Render()
    wait()
    SetActiveSource(FindSource("PolyLineSource1"))
    made = make("Poincare Hopf Check", Singularities="SingularitySource1")
    tutorial_picture("check")
    Delete(made)
    points.Singularities = rows
    Render()
    wait(400)


def step_field():
    SetActiveSource(FindSource("PolyLineSource1"))
    # The menu asks for the singularities in a dialog.
    gui.gui_filter(b"DrillHoles", b"Singularities", b"SingularitySource1")
    GetActiveSource().MeshSize = 0.05
    apply()
    make("Perforated Cross Field")
    make("Cross Glyphs")
    check_equal(messages(), "", "messages of the field")
    tutorial_picture("field")


def step_outside():
    points = FindSource("SingularitySource1")
    points.Singularities = [1.6, 0.4] + list(points.Singularities)[2:]
    SetActiveSource(FindSource("PerforatedCrossField1"))
    Render()
    wait(600)
    tutorial_picture("outside")


def run_step(step):
    GetActiveViewOrCreate("RenderView")
    step()


run("step_", globals(), run_step, (960, 800, 370))
