"""Meshes of hexahedra that are swept from quads."""
from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Mapping, Optional, Sequence, Union

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkUnstructuredGrid

from . import names
from ._results import places, write_grid
from ._run import Error, Pipeline
from .vtkCrossFieldFilters import vtkExtrudeQuads, vtkQuadMeshWriter

_AXES = {"x": vtkExtrudeQuads.AxisX, "y": vtkExtrudeQuads.AxisY}
Axis = Union[str, Sequence[Sequence[float]]]


@dataclass(frozen=True, repr=False)
class SolidMesh:
    """Hexahedra, and prisms on the axis of a revolution, with the names of their sides.

    points      (n, 3) float
    cells       list of (nodes) int, the nodes of each cell in VTK's order, layer by layer
    faces       list of (nodes) int, the nodes of each face of the boundary
    face_side   (f,) str: name of the side that each face belongs to
    block       (c,) int, the block of each cell
    layer       (c,) int, the layer of each cell, from 0
    blocks      list of (i, j, k, 3) float, the points of each block, right-handed
    grid, block_data
                all of it as a vtkUnstructuredGrid and a vtkMultiBlockDataSet
    """

    points: np.ndarray
    cells: list[np.ndarray]
    faces: list[np.ndarray]
    face_side: np.ndarray
    block: np.ndarray
    layer: np.ndarray
    blocks: list[np.ndarray]
    grid: vtkUnstructuredGrid
    block_data: vtkMultiBlockDataSet

    def __repr__(self) -> str:
        return "<SolidMesh: %d cells in %d blocks>" % (len(self.cells), len(self.blocks))

    @property
    def sides(self) -> list[str]:
        """The names of the sides, in the order of their first faces."""
        return list(dict.fromkeys(self.face_side.tolist()))

    def write(self, path: Union[str, "os.PathLike[str]"], patch_types: Optional[Mapping[str, str]] = None) -> None:
        """Writes `grid` to a .vtu file, or to a file of a solver by its ending. `patch_types` has the types of patches
        of OpenFOAM by names of sides, such as {"cylinder": "wall"}."""
        if not write_mesh(self.grid, path, patch_types):
            raise unknown_ending(path)


def write_mesh(grid: vtkUnstructuredGrid, path: Union[str, "os.PathLike[str]"],
               patch_types: Optional[Mapping[str, str]] = None) -> bool:
    """Writes a mesh in the format of the file's ending; returns False if its ending is of no such format."""
    if os.path.splitext(os.fspath(path))[1].lower() == ".vtu":
        write_grid(grid, path)
        return True
    if not vtkQuadMeshWriter.CanWrite(os.fspath(path)):
        return False
    writer = vtkQuadMeshWriter()
    writer.SetInputData(grid)
    writer.SetFileName(os.fspath(path))
    writer.SetPatchTypes("".join("%s:%s;" % entry for entry in (patch_types or {}).items()))
    Pipeline().update_one(writer)
    return True


def unknown_ending(path: Union[str, "os.PathLike[str]"], others: Sequence[str] = ()) -> Error:
    """Returns the error that lists all endings, including those of meshio."""
    endings = [".vtu", *(ending for ending in vtkQuadMeshWriter.GetEndings().split() if ending != "/")]
    sentence = "The ending of the file '%s' is unknown; give %s, or a folder with / at its end" % (path, ", ".join(endings))
    return Error(sentence + (", or one of %s, which meshio writes." % ", ".join(others) if others else "."))


def _points_of_block(grid: Any) -> np.ndarray:
    size = [0, 0, 0]
    grid.GetDimensions(size)
    return places(grid).reshape(*reversed(size), 3).transpose(2, 1, 0, 3).copy()


def _set_axis(extruder: vtkExtrudeQuads, axis: Axis) -> None:
    if isinstance(axis, str):
        if axis not in _AXES:
            raise Error("There is no axis '%s'; give 'x', 'y', or two points ((x, y), (x, y))." % axis)
        extruder.SetAxis(_AXES[axis])
        return
    line = np.asarray(axis, dtype=float)
    if line.shape != (2, 2):
        raise Error("The axis must be 'x', 'y', or two points ((x, y), (x, y)).")
    extruder.SetAxis(vtkExtrudeQuads.AxisLine)
    extruder.SetAxisPoint1(*line[0])
    extruder.SetAxisPoint2(*line[1])


def swept(grid: vtkUnstructuredGrid, layers: int, *, height: Optional[float] = None, ratio: float = 1.0,
          angle: Optional[float] = None, axis: Axis = "x") -> SolidMesh:
    """Returns the hexahedra of an extrusion by `height`, or of a revolution by `angle`."""
    extruder = vtkExtrudeQuads()
    extruder.SetInputData(grid)
    extruder.SetLayers(layers)
    _set_axis(extruder, axis)
    if height is not None:
        extruder.SetHeight(height)
        extruder.SetRatio(ratio)
    if angle is not None:
        extruder.SetMotionToRevolution()
        extruder.SetAngle(angle)
    Pipeline().update_one(extruder)
    output, blocks = extruder.GetOutput(), extruder.GetOutputDataObject(1)
    ids = vtk_to_numpy(output.GetCells().GetConnectivityArray())
    starts = vtk_to_numpy(output.GetCells().GetOffsetsArray())
    nodes = np.split(ids, starts[1:-1])
    level = vtk_to_numpy(output.GetCellData().GetArray(names.K))
    count = int((level >= 0).sum())
    sides = output.GetCellData().GetAbstractArray(names.Side)
    return SolidMesh(
        points=places(output), cells=nodes[:count], faces=nodes[count:],
        face_side=np.array([sides.GetValue(i) for i in range(count, len(nodes))], dtype=str),
        block=vtk_to_numpy(output.GetCellData().GetArray(names.BlockId))[:count], layer=level[:count],
        blocks=[_points_of_block(blocks.GetBlock(i)) for i in range(blocks.GetNumberOfBlocks())],
        grid=output, block_data=blocks)
