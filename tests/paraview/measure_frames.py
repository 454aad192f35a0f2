"""Measures frames while a handle is dragged in ParaView's client; started by run_client.py.

Prints a table for docs/speed.md: the median time from a mouse move to the picture, and the median
processor time of all threads of the client. SCENE=design in the environment measures one scene. Not a
test: the times depend on the machine.
"""
import os
import statistics
import time

import numpy as np
from paraview.simple import *

from gui_driver import gui, messages, new_view, picture, pixel, run, wait

MOVES = int(os.environ.get("MOVES", 60))
STATES = os.environ["STATES"]
PLATE = os.path.join(STATES, "..", "..", "tests", "data", "parts", "plate3.vtp")


def frames(view, start, reach):
    """Drags from a point around a circle of a radius; returns wall and processor times."""
    angles = 2 * np.pi * np.arange(MOVES + 1) / MOVES
    path = [np.add(start, [reach * (np.cos(a) - 1), reach * np.sin(a)]) for a in angles]
    path = [tuple(map(int, np.rint(pixel(view, *place)))) for place in path]
    gui.gui_press(*path[0])
    wait()
    walls, processors = [], []
    for place in path[1:]:
        used = time.process_time()
        walls.append(gui.gui_time_of_move(*place))
        processors.append(time.process_time() - used)
    gui.gui_release(*path[-1])
    wait(300)
    return walls, processors


def report(name, times):
    walls, processors = (sorted(1e3 * t for t in column) for column in times)
    print("| %s | %.0f | %.0f | %.0f | %.0f |" % (
        name, statistics.median(walls), walls[len(walls) * 9 // 10], statistics.median(processors),
        processors[len(processors) * 9 // 10]), flush=True)
    print(messages(), end="")


def make(name):
    wait()
    gui.gui_trigger(name.encode())
    wait()
    gui.gui_click(b"Apply")
    wait(500)
    return GetActiveSource()


def rows_of(proxy, name):
    proxy.UpdatePropertyInformation()
    return np.reshape(proxy.GetProperty(name), (-1, 4))


def state(name):
    ResetSession()
    wait(300)
    gui.gui_load_state(os.path.join(STATES, name).encode())
    wait(500)
    return GetActiveView(), GetActiveSource()


def frames_handles():
    view = new_view()
    source = make("Singularity Source")
    ResetCamera(view)
    report("handles alone", frames(view, source.Singularities[:2], 0.1))


def designer_on_disk(quads):
    view = new_view()
    make("Planar Domain Source")
    designer = make("Layout Designer")
    designer.Quads = quads
    designer.Singularities = [0.7, 0.07, 1, 0.05, 0.29, 0.64, 1, 0.05, -0.41, 0.57, 1, 0.05, -0.7, -0.07, 1, 0.05,
                              -0.29, -0.64, 1, 0.05, 0.41, -0.57, 1, 0.05, 0.2, 0.02, -1, 0.05, -0.2, -0.02, -1, 0.05]
    designer.QuadCount = 600
    Render()
    wait(500)
    picture("designer_%s.png" % quads.lower())
    return view, designer


def frames_lines():
    view, designer = designer_on_disk("None")
    report("Layout Designer, separatrices", frames(view, designer.Singularities[:2], 0.1))


def frames_quads():
    view, designer = designer_on_disk("Smooth")
    report("Layout Designer, draft quads", frames(view, designer.Singularities[:2], 0.1))


def frames_design():
    view, designer = state("design.py")
    report("design.py", frames(view, designer.Singularities[:2], 0.1))


def frames_plate():
    """Twelve singularities on the plate with three holes, as chosen."""
    view, designer = state("design.py")
    plate = OpenDataFile(PLATE)
    SetProperties(designer, Input=plate, Singularities=[])
    Render()
    ResetCamera(view)
    SetActiveSource(designer)
    wait(1000)
    rows = rows_of(designer, "Rows")
    size = np.ptp(rows[:, 0])
    report("design.py, %d singularities on plate3" % len(rows), frames(view, rows[0, :2], 0.03 * size))
    picture("plate.png")


print("| scene | elapsed, median | 90 % | processor, median | 90 % |")
run("frames_" + os.environ.get("SCENE", ""), globals(), lambda measure: measure(), (1200, 900, 300))
