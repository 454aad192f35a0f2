"""Pictures of quad meshes."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from ._run import Error

if TYPE_CHECKING:
    from ._quads import QuadMesh

# The colours of the plugin for ParaView.
_BLOCKS = np.array([(250, 217, 204), (209, 230, 250), (217, 245, 214), (247, 240, 194), (232, 217, 245)], np.uint8)
_POSITIVE, _NEGATIVE = (217, 26, 26), (26, 51, 217)


def _polygons(points: np.ndarray, cells: np.ndarray, colours: np.ndarray) -> vtkPolyData:
    """Returns cells with equally many points, coloured."""
    data, places, ids = vtkPolyData(), vtkPoints(), vtkCellArray()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points, float), deep=True))
    data.SetPoints(places)
    count = cells.shape[1]
    rows = np.insert(cells, 0, count, axis=1).ravel().astype(np.int64)
    ids.ImportLegacyFormat(numpy_to_vtkIdTypeArray(rows, deep=True))
    data.SetPolys(ids) if count > 1 else data.SetVerts(ids)
    data.GetCellData().SetScalars(numpy_to_vtk(np.ascontiguousarray(colours), deep=True))
    return data


def _irregular(mesh: QuadMesh) -> vtkPolyData:
    inside = np.zeros(len(mesh.points), bool)
    inside[mesh.quads] = True  # not the further nodes of curved quads
    inside[mesh.edges] = False
    nodes = np.flatnonzero(inside & (mesh.valence != 4))
    colours = np.where((mesh.valence[nodes] < 4)[:, None], _POSITIVE, _NEGATIVE).astype(np.uint8)
    return _polygons(mesh.points, nodes[:, None], colours)


def _in_notebook() -> bool:
    try:
        from IPython import get_ipython  # type: ignore[import-not-found, unused-ignore]
    except ImportError:
        return False
    return type(get_ipython()).__name__ == "ZMQInteractiveShell"


def _scene(mesh: QuadMesh, width: int) -> Any:
    """Returns a window with the mesh, seen along the normal of its plane."""
    from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow
    import vtkmodules.vtkInteractionStyle  # noqa: F401  implementations that the classes above look up
    import vtkmodules.vtkRenderingOpenGL2  # noqa: F401

    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    quads = _polygons(mesh.points, mesh.quads, _BLOCKS[mesh.block * 7 % len(_BLOCKS)])
    for data, line in ((quads, 1.0), (mesh.layout_data, 2.5), (_irregular(mesh), 1.0)):
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(data)
        mapper.SetResolveCoincidentTopologyToPolygonOffset()
        actor = vtkActor()
        actor.SetMapper(mapper)
        look = actor.GetProperty()
        look.LightingOff()
        look.SetLineWidth(line)
        look.SetPointSize(0.012 * width)
        look.RenderPointsAsSpheresOn()
        if data is quads:
            look.EdgeVisibilityOn()
            look.SetEdgeColor(0.6, 0.6, 0.6)
        elif data is mesh.layout_data:
            mapper.ScalarVisibilityOff()
            look.SetColor(0, 0, 0)
        renderer.AddActor(actor)
    middle = (mesh.points.min(axis=0) + mesh.points.max(axis=0)) / 2
    right, up, normal = np.linalg.svd(mesh.points - middle, full_matrices=False)[2]
    if abs(normal[2]) > 1 - 1e-9:
        right, up, normal = np.eye(3)
    elif normal[np.abs(normal).argmax()] < 0:
        normal = -normal
    across, high = (np.ptp(mesh.points @ axis) for axis in (np.cross(up, normal), up))
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*middle)
    camera.SetPosition(*(middle + max(across, high) * normal))
    camera.SetViewUp(*up)
    window = vtkRenderWindow()
    window.SetSize(width, max(width // 4, int(width * min(1.0, high / across))))
    camera.SetParallelScale(0.53 * max(high, across * window.GetSize()[1] / width))
    window.AddRenderer(renderer)
    renderer.ResetCameraClippingRange()
    window.SetWindowName("crossfield")
    return window


def plot_quads(mesh: QuadMesh, file: Optional[Union[str, "os.PathLike[str]"]], width: int) -> Any:
    """Shows or writes a picture; see QuadMesh.plot."""
    in_notebook = file is None and _in_notebook()
    if file is not None and not os.fspath(file).lower().endswith(".png"):
        raise Error("The picture '%s' cannot be written; give a name that ends in .png." % file)
    folder = os.path.dirname(os.path.abspath(os.fspath(file or "")))
    if not os.path.isdir(folder):
        raise Error("There is no folder '%s' for the picture; create it." % folder)
    window = _scene(mesh, width)
    if file is None and not in_notebook:
        from vtkmodules.vtkRenderingCore import vtkRenderWindowInteractor

        interactor = vtkRenderWindowInteractor()
        interactor.SetRenderWindow(window)
        window.Render()
        interactor.Start()
        return None
    from vtkmodules.vtkIOImage import vtkPNGWriter
    from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

    window.OffScreenRenderingOn()
    window.SetMultiSamples(8)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    if in_notebook:
        from IPython.display import Image  # type: ignore[import-not-found, unused-ignore]

        writer.WriteToMemoryOn()
        writer.Write()
        return Image(bytes(writer.GetResult()))
    writer.SetFileName(os.fspath(file or ""))
    writer.Write()
    if writer.GetErrorCode() != 0:
        raise Error("The picture '%s' cannot be written; check that its folder can be." % file)
    return None
