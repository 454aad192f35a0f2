"""Results of the functions: numpy arrays, and the VTK data that they were copied from."""
from __future__ import annotations

import contextlib
import json
import math
import os
import shutil
from dataclasses import dataclass
from typing import Any, Optional, Sequence, Union

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

from . import names
from ._run import Error, Pipeline
from .vtkCrossFieldFilters import vtkCrossFieldReport, vtkCrossFieldSingularities


def copied(attributes: Any, name: str) -> np.ndarray:
    """Returns a copy of an array."""
    return vtk_to_numpy(attributes.GetArray(name)).copy()


def places(data: Any) -> np.ndarray:
    """Returns a copy of the points, (n, 3)."""
    if data.GetNumberOfPoints() == 0:
        return np.empty((0, 3))
    return vtk_to_numpy(data.GetPoints().GetData()).copy()


def report_of(name: str, data: Any, seconds: Sequence[float] = (), **others: Any) -> dict[str, Any]:
    """Returns the report of this name on `data`; `others` are further sources of vtkCrossFieldReport, or None. Numbers
    that do not exist are NaN."""
    report = vtkCrossFieldReport()
    for source, given in {"data": data, **others}.items():
        report.SetSource(source, given)
    report.SetSeconds(seconds)
    return without_null(json.loads(report.Write(name)))


def without_null(value: Any) -> Any:
    """Returns a value of JSON with NaN in the place of null."""
    if isinstance(value, dict):
        return {key: without_null(entry) for key, entry in value.items()}
    if isinstance(value, list):
        return [without_null(entry) for entry in value]
    return math.nan if value is None else value


def write_grid(grid: vtkUnstructuredGrid, path: Union[str, "os.PathLike[str]"]) -> None:
    """Writes a .vtu file, in a form that Debian's VTK can read back; devices and pipes have any name."""
    if os.path.splitext(os.fspath(path))[1].lower() != ".vtu" and (os.path.isfile(path) or not os.path.exists(path)):
        raise Error("The file '%s' must end in .vtu." % path)
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputData(grid)
    writer.SetDataModeToBinary()
    writer.WriteToOutputStringOn()
    Pipeline().update_one(writer)
    replace_file(writer.GetOutputString(), path)


def replace_file(text: str, path: Union[str, "os.PathLike[str]"]) -> None:
    """Writes a file under a temporary name and renames it when complete, as the program does."""
    place = os.path.realpath(path)
    is_file = os.path.isfile(place)
    if os.path.exists(place) and not is_file:  # a device or a pipe, which cannot be replaced
        with open(place, "w", encoding="utf-8") as file:
            file.write(text)
        return
    part = "%s.part%d" % (place, os.getpid())
    try:
        with open(part, "w", encoding="utf-8") as file:
            file.write(text)
        if is_file:
            shutil.copymode(place, part)
        os.replace(part, place)
    except BaseException:  # also Ctrl-C
        with contextlib.suppress(OSError):
            os.remove(part)
        raise


@dataclass(frozen=True, repr=False)
class Mesh:
    """A triangle mesh with a hole at every singularity.

    points         (n, 3) float; in the plane of the domain
    triangles      (t, 3) int, rows of `points`, counter-clockwise
    edges          (b, 2) int, of the boundary, with the domain on the left
    boundary_kind  (b,) int: 1 outer loop, 2 inner loop, 3 hole
    boundary_id    (b,) int: number of the loop, or row of the singularity
    quarter_index  (b,) int: quarter index of the hole, 0 elsewhere
    grid           the mesh as a vtkUnstructuredGrid
    """

    points: np.ndarray
    triangles: np.ndarray
    edges: np.ndarray
    boundary_kind: np.ndarray
    boundary_id: np.ndarray
    quarter_index: np.ndarray
    grid: vtkUnstructuredGrid

    def __repr__(self) -> str:
        return "<%s: %d triangles, %d points>" % (type(self).__name__, len(self.triangles), len(self.points))

    def write(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes `grid` to a .vtu file, in a form that Debian's VTK can read back."""
        write_grid(self.grid, path)


@dataclass(frozen=True, repr=False)
class CrossField(Mesh):
    """A cross field on a mesh. A cross at angle θ is u = exp(4iθ), |u| its norm.

    u              (t, 3) complex, at the midpoints of p0p1, p1p2, p2p0 of each triangle: the exact
                   discrete field
    angle          (t,) float, angle of a branch at the centre of each triangle, in (-π/4, π/4], radians
    norm           (t,) float, |u| at the centre of each triangle
    cross          (t, 3) float, the branch at that angle as a unit vector of space
    point_angle    (n,) float, the angle at each point
    point_norm     (n,) float, |u| at each point
    point_cross    (n, 3) float, the branch at each point
    hole_degrees   (h,) int, quarter turns that the field makes around each hole
    report         numbers of the solver, with the keys of `crossfield solve --json`
    grid           the field as a vtkUnstructuredGrid

    u and the angles refer to the frame of the plane: (x, y) if z is constant, (y, z) if x is, (x,
    z) if y is; in any other plane to the nearest of these three, turned into the plane by the
    shortest rotation. Crosses and values at points are the arrays of `grid`, in single precision.
    They are None if the choice of `arrays` leaves them out: crosses and norms with "exact", the
    angles at points also with "display".
    """

    u: np.ndarray
    angle: np.ndarray
    norm: np.ndarray
    cross: Optional[np.ndarray]
    point_angle: Optional[np.ndarray]
    point_norm: Optional[np.ndarray]
    point_cross: Optional[np.ndarray]
    hole_degrees: np.ndarray
    report: dict[str, Any]

    def singularities(self) -> tuple[np.ndarray, np.ndarray]:
        """Points (m, 3) and quarter indices (m,) of the singularities that are not in holes."""
        finder = vtkCrossFieldSingularities()
        finder.SetInputData(self.grid)
        found = Pipeline().update_one(finder).GetOutput()
        return places(found), copied(found.GetPointData(), names.QuarterIndex)


@dataclass(frozen=True, repr=False)
class HField(CrossField):
    """A cross field of norm one with singularities as points, its size field H and its size map.

    h              (n,) float, at each point
    size_map       (n,) float, e^H: local size of quads up to a factor, larger where the lines spread
    """

    h: np.ndarray
    size_map: np.ndarray


@dataclass(frozen=True, repr=False)
class Configuration:
    """Singularities that were proposed or optimised; every function accepts it as `singularities`.

    points         (m, 3) float
    quarter_index  (m,) int
    radius         (m,) float, radii of their holes, or None
    events         decisions that were made, a sentence each
    report         numbers of the optimiser, with the keys of `crossfield optimize --json`
    data           the points as vtkPolyData
    corners        the corners whose quarter index was chosen, as vtkPolyData, or None
    """

    points: np.ndarray
    quarter_index: np.ndarray
    radius: Optional[np.ndarray]
    events: list[str]
    report: dict[str, Any]
    data: vtkPolyData
    corners: Optional[vtkPolyData]

    def __repr__(self) -> str:
        return "<Configuration: quarter indices %s>" % self.quarter_index.tolist()


def configuration_of(algorithm: Any, port: int = 0) -> Configuration:
    """Returns the singularities in an output of a filter, and the corners in the next one, if
    any."""
    data = algorithm.GetOutputDataObject(port)
    events = data.GetFieldData().GetAbstractArray(names.Events)
    has_radii = bool(data.GetPointData().HasArray(names.Radius))
    corners = algorithm.GetOutputDataObject(port + 1)
    return Configuration(
        points=places(data), quarter_index=copied(data.GetPointData(), names.QuarterIndex),
        radius=copied(data.GetPointData(), names.Radius) if has_radii else None,
        events=[events.GetValue(i) for i in range(events.GetNumberOfValues())] if events else [],
        report=report_of("optimize", data), data=data,
        corners=corners if isinstance(corners, vtkPolyData) else None)


def _mesh_arrays(grid: vtkUnstructuredGrid) -> dict[str, Any]:
    kinds = vtk_to_numpy(grid.GetCellData().GetArray(names.BoundaryKind))
    ids = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    starts = vtk_to_numpy(grid.GetCells().GetOffsetsArray())[:-1]
    triangles, lines = kinds == 0, kinds != 0

    def corners(wanted: np.ndarray, count: int) -> np.ndarray:
        return ids[starts[wanted][:, None] + np.arange(count)]

    def of_lines(name: str) -> np.ndarray:
        return vtk_to_numpy(grid.GetCellData().GetArray(name))[lines]

    return {"points": places(grid), "triangles": corners(triangles, 3),
            "edges": corners(lines, 2), "boundary_kind": kinds[lines],
            "boundary_id": of_lines(names.BoundaryId),
            "quarter_index": of_lines(names.QuarterIndex), "grid": grid}


def mesh_of(grid: vtkUnstructuredGrid) -> Mesh:
    """Returns a drilled mesh."""
    return Mesh(**_mesh_arrays(grid))


def _field_arrays(grid: vtkUnstructuredGrid, chosen: Optional[Configuration]) -> dict[str, Any]:
    mesh = _mesh_arrays(grid)
    triangles = vtk_to_numpy(grid.GetCellData().GetArray(names.BoundaryKind)) == 0

    def shown(attributes: Any, name: str, wanted: Any = slice(None)) -> Optional[np.ndarray]:
        if not attributes.HasArray(name):
            return None
        return vtk_to_numpy(attributes.GetArray(name))[wanted].astype(float)

    exact = vtk_to_numpy(grid.GetCellData().GetArray(names.CrossFieldCR))[triangles]
    u = exact[:, 0::2] + 1j * exact[:, 1::2]
    centre = u.mean(axis=1)
    at_points = shown(grid.GetPointData(), names.Representation)
    return {
        **mesh, "u": u,
        "angle": np.angle(centre) / 4, "norm": np.abs(centre),
        "point_angle": None if at_points is None else np.arctan2(at_points[:, 1], at_points[:, 0]) / 4,
        "point_norm": shown(grid.GetPointData(), names.CrossNorm),
        "cross": shown(grid.GetCellData(), names.Cross, triangles),
        "point_cross": shown(grid.GetPointData(), names.Cross),
        "hole_degrees": copied(grid.GetFieldData(), names.HoleDegree),
        "report": report_of("field", grid, singularities=chosen and chosen.data)}


def field_of(grid: vtkUnstructuredGrid, chosen: Optional[Configuration] = None) -> CrossField:
    """Returns a field; its report lists the singularities if they were chosen."""
    return CrossField(**_field_arrays(grid, chosen))


def h_field_of(grid: vtkUnstructuredGrid, chosen: Optional[Configuration] = None) -> HField:
    """Returns a field with its size field H, as field_of does."""
    return HField(**_field_arrays(grid, chosen), h=copied(grid.GetPointData(), names.H),
                  size_map=np.exp(copied(grid.GetPointData(), names.H)))


@dataclass(frozen=True)
class ConsistencyCheck:
    """Whether singularities can exist on a domain, and why.

    consistent         whether the quarter indices have the sum that the domain requires
    reason             one sentence
    corner_points      (c, 3) float
    corner_angles      (c,) float, inside the domain, radians
    corner_quarters    (c,) int, quarter index of each corner
    cancellable        (c,) bool, whether interior singularities can make the corner a regular point
    report             numbers with the keys of `crossfield check --json`
    """

    consistent: bool
    reason: str
    corner_points: np.ndarray
    corner_angles: np.ndarray
    corner_quarters: np.ndarray
    cancellable: np.ndarray
    report: dict[str, Any]


@dataclass(frozen=True)
class Corners:
    """The corners of a domain with their quarter indices.

    points             (c, 3) float
    angle              (c,) float, inside the domain, radians
    quarter_index      (c,) int, quarter indices of minimum energy
    scarce, balanced, excess, conventional
                       (c,) int, quarter indices in the scenarios of the paper, and by the smallest rotation
    corner_energy      (c,) float
    cancellable, tied  (c,) bool
    scenario           name of the scenario of minimum energy
    energy             energy of all corners and of the interior singularities that they require
    interior_quarters  sum of the quarter indices in the interior
    scenarios          name: {"sum", "energy", "feasible"}
    data               the points as vtkPolyData; functions accept it, or this object, as `corners`
    """

    points: np.ndarray
    angle: np.ndarray
    quarter_index: np.ndarray
    scarce: np.ndarray
    balanced: np.ndarray
    excess: np.ndarray
    conventional: np.ndarray
    corner_energy: np.ndarray
    cancellable: np.ndarray
    tied: np.ndarray
    scenario: str
    energy: float
    interior_quarters: int
    scenarios: dict[str, dict[str, Any]]
    data: vtkPolyData


@dataclass(frozen=True, repr=False)
class Separatrices:
    """Separatrices, the lines that leave the singularities of a cross field, and the rectangles
    between them.

    lines          list of (n, 3) float, a polyline each; streamlines from seeds at the end
    singularity    (l,) int, row of the singularity where a line starts; -1 for corners and streamlines
    seed           (l,) int, row of the seed of a streamline, else -1
    ends_at        (l,) int: 1 the side of another line, 2 the boundary, 3 head-on, 0 too long
    length         (l,) float, length in the map
    faces          list of (n, 3) float, a polygon each, counter-clockwise
    face_sizes     (f, 2) float, sides of the rectangles in the map, whose area is that of the domain
    report         numbers with the keys of `crossfield separatrices --json`
    line_data, face_data, map
                   the lines and faces as vtkPolyData, and the map as a vtkUnstructuredGrid
    """

    lines: list[np.ndarray]
    singularity: np.ndarray
    seed: np.ndarray
    ends_at: np.ndarray
    length: np.ndarray
    faces: list[np.ndarray]
    face_sizes: np.ndarray
    report: dict[str, Any]
    line_data: vtkPolyData
    face_data: vtkPolyData
    map: vtkUnstructuredGrid

    def __repr__(self) -> str:
        return "<Separatrices: %d lines, %d faces>" % (len(self.lines), len(self.faces))


def chains(points: np.ndarray, cells: Any) -> list[np.ndarray]:
    """Returns the points of each polyline or polygon."""
    ids = vtk_to_numpy(cells.GetConnectivityArray())
    starts = vtk_to_numpy(cells.GetOffsetsArray())
    return [points[ids[first:last]] for first, last in zip(starts[:-1], starts[1:])]


def separatrices_of(lines: vtkPolyData, faces: vtkPolyData, map: vtkUnstructuredGrid,
                    chosen: Optional[Configuration]) -> Separatrices:
    """Returns lines, faces and their map; the report lists the singularities if they were
    chosen."""
    data, sizes = lines.GetCellData(), faces.GetCellData()
    outline = copied(faces.GetPointData(), names.FaceId)  # points are ordered by face
    return Separatrices(
        lines=chains(places(lines), lines.GetLines()),
        singularity=copied(data, names.Singularity), seed=copied(data, names.Seed),
        ends_at=copied(data, names.EndsAt), length=copied(data, names.Length),
        faces=np.split(places(faces), np.flatnonzero(np.diff(outline)) + 1) if len(outline) else [],
        face_sizes=np.column_stack(
            [copied(sizes, name)[np.unique(copied(sizes, names.FaceId), return_index=True)[1]]
             for name in (names.USize, names.VSize)]),
        report=report_of("separatrices", lines, map=map, singularities=chosen and chosen.data),
        line_data=lines, face_data=faces, map=map)
