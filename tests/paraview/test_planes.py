"""Handles on domains in planes other than z = 0; started by run_client.py.

Rows are coordinates in the plane, handles are placed in it, and a dragged handle stays in it.
"""
import numpy as np
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

from gui_driver import check, check_equal, drag, gui, messages, picture, pixel, run, wait

# Rotation in degrees as in Transform, centre of the disk, and camera position.
PLANES = {"raised": ([0, 0, 0], [0, 0, 2], [3, -4, 6]), "tilted": ([50, 0, 20], [0.3, 0, 1], [2.5, -4, 5.5]),
          "upright": ([90, 0, 0], [0, 1, 0], [2, -4, 2])}
DRAG_ENDS = (0.02, 0.1), (0.1, -0.3)


class Plane:
    """A disk in a plane of space, in an oblique perspective view of its own."""

    def __init__(self, name):
        rotation, middle, eye = PLANES[name]
        self.view = CreateView("RenderView")
        AssignViewToLayout(view=self.view, layout=CreateLayout(name))
        SetActiveView(self.view)
        SetProperties(self.view, UseColorPaletteForBackground=0, Background=[1, 1, 1])
        disk = PlanarDomainSource(registrationName="Disk " + name)
        self.domain = Transform(registrationName="Moved " + name, Input=disk)
        SetProperties(self.domain.Transform, Rotate=rotation, Translate=middle)
        SetProperties(Show(self.domain, self.view), LineWidth=3, AmbientColor=[0, 0, 0], DiffuseColor=[0, 0, 0], ColorArrayName=["POINTS", ""])
        Render()
        SetProperties(self.view, CameraPosition=eye, CameraFocalPoint=middle, CameraViewUp=[0, 0, 1])
        self.view.ResetCamera()
        wait()
        points = self.points(self.domain)
        axes = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2]
        self.middle, self.normal = np.array(middle), axes[2]

    @staticmethod
    def points(proxy, port=0):
        """Returns the points that are now in the pipeline."""
        return vtk_to_numpy(proxy.GetClientSideObject().GetOutputDataObject(port).GetPoints().GetData()).astype(float)

    def check_in_plane(self, points):
        check(abs((points - self.middle) @ self.normal).max() < 1e-6, "points are off the plane")

    def choose(self, proxy):
        SetActiveSource(proxy)
        wait(300)

    def drag_first(self, source, port, end):
        """Drags the handle of the first row to an offset from the centre in the plane, and checks
        its position."""
        start = self.points(source, port)[0]
        side = np.cross(self.normal, [0, 0, 1] if abs(self.normal[2]) < 0.9 else [0, 1, 0])
        side /= np.linalg.norm(side)
        target = self.middle + end[0] * side + end[1] * np.cross(self.normal, side)
        before = self.points(source, port)[1:]
        for _ in drag(self.view, [start + (target - start) * i / 5 for i in range(6)]):
            self.check_in_plane(self.points(source, port))
        wait(300)
        found = self.points(source, port)
        self.check_in_plane(found)
        # The size of a pixel in the oblique view.
        size = 4 * np.linalg.norm(np.array(self.view.CameraPosition) - self.middle) * np.tan(np.radians(15)) / self.view.ViewSize[1]
        check(np.linalg.norm(found[0] - target) < 3 * size, "the final position: %s, not %s" % (found[0], target))
        check(abs(found[1:] - before).max() < 1e-9, "other singularities have moved")
        check_equal(messages(), "", "messages")


def test_designer(plane, name):
    plane.choose(plane.domain)
    check(gui.gui_trigger(b"Layout Designer"), "no Layout Designer in the menu")
    check(gui.gui_click(b"Apply"), "no Apply")
    wait(300)
    designer = GetActiveSource()
    Hide(plane.domain, plane.view)
    check_equal(gui.gui_rows(), 4, "rows of the table")
    plane.drag_first(designer, 2, DRAG_ENDS[0])
    check_equal(designer.GetClientSideObject().GetOutputDataObject(0).GetFieldData().GetArray("Stale").GetValue(0), 0,
                "whether the layout is stale")
    picture(name + "_designer.png", is_whole_window=False)
    gui.gui_click(b"Add pair")
    wait(300)
    check_equal(len(plane.points(designer, 2)), 6, "singularities with a pair")
    plane.check_in_plane(plane.points(designer, 2))
    # Beside the selected one, not elsewhere on the line of sight.
    check(np.linalg.norm(plane.points(designer, 2)[4:] - plane.points(designer, 2)[0], axis=1).max() < 1, "a pair far away")
    gui.gui_undo()
    wait(300)
    check_equal(len(plane.points(designer, 2)), 4, "singularities after undo")
    Delete(designer)


def test_proposal_with_handles(plane, name):
    proposal = ConfigurationProposal(registrationName="Proposal " + name, Input=plane.domain, Automatic=1)
    handles = SingularityHandles(registrationName="Handles " + name, Input=proposal)
    lines = Separatrices(registrationName="Lines " + name, Input=CrossFieldMap(Input=plane.domain, Singularities=handles))
    Show(lines, plane.view)
    Render()
    plane.choose(handles)
    check_equal(gui.gui_rows(), 4, "rows of the table")
    before = plane.points(lines)
    plane.drag_first(handles, 0, DRAG_ENDS[0])
    check(plane.points(lines).shape != before.shape or abs(plane.points(lines) - before).max() > 0.01, "the separatrices have not moved")
    plane.check_in_plane(plane.points(lines))
    for proxy in lines, lines.Input, handles, proposal:
        Delete(proxy)


def test_source(plane, name):
    Show(plane.domain, plane.view)
    SetActiveSource(None)
    wait()
    check(gui.gui_trigger(b"Singularity Source"), "no Singularity Source in the menu")
    check(gui.gui_select_choice(b"Domain", ("Moved " + name).encode()), "no choice of the domain")
    check(gui.gui_click(b"Apply"), "no Apply")
    wait(300)
    source = GetActiveSource()
    check_equal(gui.gui_rows(), 4, "rows of the table")
    check_equal(GetRepresentation(plane.domain, plane.view).Visibility, 1, "the domain beside its singularities")
    # The default rows are around the origin of the plane, not around the disk.
    source.UpdatePropertyInformation()
    origin, *axes = np.reshape(source.GetProperty("Plane"), (3, 3))
    source.Singularities = [number for x, y in ((4, 4), (-4, 4), (-4, -4), (4, -4))
                            for number in (*np.dot(axes, plane.middle - origin) + [x / 10, y / 10], 1, 0.1)]
    wait(300)
    plane.check_in_plane(plane.points(source))
    plane.drag_first(source, 0, DRAG_ENDS[1])
    picture(name + "_source.png", is_whole_window=False)
    # The domain accepts it.
    drilled = DrillHoles(Input=plane.domain, Singularities=source, MeshSize=0.2)
    drilled.UpdatePipeline()
    check_equal(messages(), "", "messages")
    check(drilled.GetDataInformation().GetNumberOfCells() > 100, "no mesh of them")
    Delete(drilled)
    Delete(source)


def on_every_plane(test):
    for name in PLANES:
        if name not in planes:
            planes[name] = Plane(name)
        SetActiveView(planes[name].view)
        test(planes[name], name)


planes = {}
run("test_", globals(), on_every_plane, (960, 800, 370))
