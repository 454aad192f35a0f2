"""All-quad meshes with exactly the chosen irregular nodes."""
from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Mapping, Optional, Sequence, Union

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkMultiBlockDataSet, vtkPolyData, vtkUnstructuredGrid)

from . import names
from ._arguments import checks_arguments, dictionary, number, whole
from ._configurations import checked, corner_points
from ._input import (
    Domain, Lines, Singularities, as_configuration, as_domain, line_names, material_array, positions, with_lines)
from ._layers import (
    CornerRows, Curves, Layers, Periodic, corner_rows_text, curves_text, layers_text, periodic_text)
from ._plot import plot_quads
from ._results import Configuration, Corners, chains, configuration_of, copied, places, report_of
from ._run import Error, Pipeline
from ._solid import Axis, SolidMesh, swept, unknown_ending, write_mesh
from .vtkCrossFieldFilters import vtkQuadMesher, vtkQuadsToHigherOrder

#: Ratio of the last edge to the first, (first, last) lengths, or either after "both" in a tuple.
Progression = Union[float, tuple[float, float], tuple[str, float], tuple[str, float, float]]

_SIZINGS = {"auto": vtkQuadMesher.SizingAutomatic, "conformal": vtkQuadMesher.SizingConformal,
            "uniform": vtkQuadMesher.SizingUniform, "field": vtkQuadMesher.SizingField}
_PREFERENCES = {"nodes": vtkQuadMesher.PreferNodes, "blocks": vtkQuadMesher.PreferBlocks,
                "uniform": vtkQuadMesher.PreferUniform}
_MERGES = {"none": vtkQuadMesher.MergeNone, "clean": vtkQuadMesher.MergeClean,
           "coarse": vtkQuadMesher.MergeCoarse}


#: Formats of meshio that hold quads and lines; it writes others, such as .stl, without them and without an error.
_MESHIO_ENDINGS = (".avs", ".bdf", ".fem", ".mdpa", ".med", ".mesh", ".meshb", ".nas", ".ply", ".post", ".vol", ".xdmf",
                   ".xmf")


@dataclass(frozen=True, repr=False)
class QuadMesh:
    """An all-quad mesh and the structured blocks that it consists of.

    points           (n, 3) float
    quads            (q, 4) int, rows of `points`, counter-clockwise
    edges            (b, 2) int, of the boundary, with the domain on the left
    quad_nodes       (q, (order + 1)²) int, all nodes of each quad in VTK's order, corners first
    edge_nodes       (b, order + 1) int, all nodes of each edge: both ends, then those between
    boundary_kind    (b,) int: 1 outer loop, 2 inner loop, 5 between two materials
    boundary_id      (b,) int: number of the loop
    edge_side        (b,) str: name of the side of the boundary that each edge belongs to
    valence          (n,) int, quads at each point
    irregular        (n,) int, quarter index of a singularity or corner, else 0
    block            (q,) int, the block of each quad
    region           (q,) int, the material of each quad, its value or number in report["regions"]; zeros without materials
    scaled_jacobian  (q,) float, minimum sine of the angles of each quad, negative where it is inverted
    blocks           list of (i, j, 3) float, the points of each block, right-handed
    layout           list of (m, 3) float, a polyline for each side of a block
    singularities    the singularities used, at the positions of their nodes, with the corners used
    report           the numbers, under the names of `crossfield quads --json`
    grid, block_data, layout_data
                     all of it as a vtkUnstructuredGrid (quads, edges and report), a vtkMultiBlockDataSet and a
                     vtkPolyData
    """

    points: np.ndarray
    quads: np.ndarray
    edges: np.ndarray
    boundary_kind: np.ndarray
    boundary_id: np.ndarray
    edge_side: np.ndarray
    valence: np.ndarray
    irregular: np.ndarray
    block: np.ndarray
    scaled_jacobian: np.ndarray
    blocks: list[np.ndarray]
    layout: list[np.ndarray]
    singularities: Configuration
    report: dict[str, Any]
    grid: vtkUnstructuredGrid
    block_data: vtkMultiBlockDataSet
    layout_data: vtkPolyData
    quad_nodes: np.ndarray
    edge_nodes: np.ndarray
    region: np.ndarray

    def __repr__(self) -> str:
        return "<QuadMesh: %d quads in %d blocks, minimum scaled Jacobian %.2f>" % (
            len(self.quads), len(self.blocks), self.report["scaled_jacobian"]["min"])

    @property
    def order(self) -> int:
        """The order of the quads, 1 to 3."""
        return self.edge_nodes.shape[1] - 1

    @property
    def sides(self) -> list[str]:
        """The names of the sides of the boundary."""
        return [side["name"] for side in self.report["sides"]]

    @checks_arguments
    def side(self, name: str) -> np.ndarray:
        """Returns the rows of `points` on a side, in order with the domain on the left.

        Pieces of the side that are apart follow one another; the first point of a closed loop is not repeated.

        >>> mesh = quads([(0, 0), (2, 0), (2, 1), (0, 1)], size=0.5)
        >>> mesh.sides
        ['outer0', 'outer1', 'outer2', 'outer3']
        >>> mesh.points[mesh.side("outer0")][:, 0]
        array([0. , 0.5, 1. , 1.5, 2. ])
        """
        if name not in self.sides:
            raise Error("The mesh has no side '%s'; its sides are %s." % (name, ", ".join(self.sides)))
        edges = self.edges[self.edge_side == name]
        starts = np.flatnonzero(np.r_[True, edges[1:, 0] != edges[:-1, 1]]) if len(edges) else []
        pieces = np.split(edges, starts[1:]) if len(edges) else []
        if len(pieces) > 1 and pieces[-1][-1, 1] == pieces[0][0, 0]:  # through the first edge of a loop
            pieces = [np.vstack([pieces[-1], pieces[0]]), *pieces[1:-1]]
        chains = [piece[:, 0] if piece[-1, 1] == piece[0, 0] else np.r_[piece[:, 0], piece[-1, 1]]
                  for piece in pieces]
        return np.concatenate(chains) if chains else np.empty(0, int)

    @checks_arguments
    def extrude(self, height: float, layers: int = 1, ratio: float = 1.0) -> SolidMesh:
        """Returns hexahedra between the quads and the quads moved by `height` along their normal, in layers of
        equal height or with a `ratio` of the last height to the first.

        Sides keep their names; the ends are "back" and "front".

        >>> mesh = quads([(0, 0), (2, 0), (2, 1), (0, 1)], size=0.5)
        >>> solid = mesh.extrude(1.0, layers=2)
        >>> len(mesh.quads), len(solid.cells), solid.sides[-2:]
        (8, 16, ['back', 'front'])
        """
        return swept(self.grid, layers, height=height, ratio=ratio)

    @checks_arguments
    def revolve(self, angle: float, layers: int = 1, axis: Axis = "x") -> SolidMesh:
        """Returns hexahedra that the quads pass when they turn by `angle` degrees about the line y = 0 (axis "x"),
        x = 0 ("y"), or the one through two points, ((x, y), (x, y)). Quads with an edge on the axis become prisms, and 360 degrees close the mesh. With one
        layer the quads are in its middle."""
        return swept(self.grid, layers, angle=angle, axis=axis)

    def plot(self, file: Optional[Union[str, "os.PathLike[str]"]] = None, width: int = 900) -> Any:
        """Shows the mesh in a window until it is closed, with pale blocks and irregular nodes in
        red (valence 3) and blue (valence 5).

        In a notebook returns an image instead. With `file`, writes a .png of this width in pixels.
        """
        return plot_quads(self, file, width)

    def write(self, path: Union[str, "os.PathLike[str]"], patch_types: Optional[Mapping[str, str]] = None) -> None:
        """Writes a file in the format of its ending: `grid` as .vtu or .vtk, or quads and names of sides as .msh
        (Gmsh), .inp (Abaqus, CalculiX), .su2, .cgns, .xyz (PLOT3D), .ex2 (Exodus), or .foam and / for
        a case of OpenFOAM. Formats of meshio that hold quads, such as .med, .mesh and .bdf, are written by meshio: quads
        and boundary lines, with the loop of each line. Other endings are an Error. `patch_types` has the types of patches of
        OpenFOAM by names of sides, such as {"cylinder": "wall"}; sides with a boundary layer are walls without it."""
        if write_mesh(self.grid, path, patch_types):
            return
        if os.path.splitext(os.fspath(path))[1].lower() not in _MESHIO_ENDINGS:
            raise unknown_ending(path, _MESHIO_ENDINGS)
        try:
            import meshio
        except ImportError:
            raise Error("The file '%s' is written with the Python package meshio; install it (Debian package "
                        "python3-meshio), or write a .vtu or .msh file." % path) from None
        if self.order > 2:
            raise Error("The file '%s' cannot have quads of order 3; write a .vtu file, or use order 2." % path)
        loops = [np.full(len(self.quads), -1), self.boundary_id]
        types = ("quad", "line") if self.order == 1 else ("quad9", "line3")
        mesh = meshio.Mesh(self.points, list(zip(types, (self.quad_nodes, self.edge_nodes))),
                           cell_data={"BoundaryId": loops})
        try:
            mesh.write(path)
        except (Exception, SystemExit) as error:  # meshio raises errors of many types
            raise Error("The file '%s' cannot be written by meshio (%s); check its ending and its folder."
                        % (path, error)) from None


def _progression_text(side: str, progression: Progression) -> str:
    """Returns the text of vtkQuadMesher::AddSide."""
    values = list(progression) if isinstance(progression, (tuple, list)) and progression else [progression]
    both = "both:" if values[0] == "both" else ""
    return both + ",".join("%.17g" % number(value, "progression of '%s'" % side, "a number, or a tuple of numbers")
                           for value in values[1 if both else 0:])


def _add_size_near(mesher: vtkQuadMesher, row: Sequence[float]) -> None:
    values = [number(value, "argument sizes_near", "rows (x, y, size) or (x, y, size, radius)") for value in row]
    if len(values) not in (3, 4) or not values[2] > 0 or not values[-1] >= 0:
        raise Error("The size near a position %s is no row (x, y, size) or (x, y, size, radius) with a positive size."
                    % (tuple(row),))
    mesher.AddSizeNear(values[0], values[1], 0.0, values[2], values[3] if len(values) == 4 else 0.0)


def _points_of_block(grid: Any) -> np.ndarray:
    size = [0, 0, 0]
    grid.GetDimensions(size)
    columns, rows, _ = size
    return places(grid).reshape(rows, columns, 3).transpose(1, 0, 2).copy()


def _mesh_of(pipeline: Pipeline, mesher: vtkQuadMesher, was_chosen: bool, order: int) -> QuadMesh:
    """Returns the outputs of a mesher; the report lists the singularities if they were chosen or moved."""
    grid = vtkUnstructuredGrid()
    mesher.CopyMesh(grid)
    if order > 1:
        raiser = pipeline.add(vtkQuadsToHigherOrder())
        raiser.SetInputData(grid)
        raiser.SetSurfaceConnection(mesher.GetInputConnection(0, 0))  # of use if it is curved
        raiser.SetOrder(order)
        raiser.SetFeatureAngle(mesher.GetFeatureAngle())
        grid = pipeline.update(raiser).GetOutput()
    blocks, layout = mesher.GetOutputDataObject(1), mesher.GetOutputDataObject(2)
    used = configuration_of(mesher, 3)
    ids = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    starts = vtk_to_numpy(grid.GetCells().GetOffsetsArray())[:-1]
    kinds = vtk_to_numpy(grid.GetCellData().GetArray(names.BoundaryKind))
    quads, lines = kinds == 0, kinds != 0
    quad_nodes = ids[starts[quads][:, None] + np.arange((order + 1) ** 2)]
    edge_nodes = ids[starts[lines][:, None] + np.arange(order + 1)]
    side_names = grid.GetCellData().GetAbstractArray(names.Side)

    def of(cells: np.ndarray, name: str) -> np.ndarray:
        return vtk_to_numpy(grid.GetCellData().GetArray(name))[cells]

    return QuadMesh(
        points=places(grid), quads=quad_nodes[:, :4].copy(), edges=edge_nodes[:, :2].copy(),
        boundary_kind=of(lines, names.BoundaryKind), boundary_id=of(lines, names.BoundaryId),
        edge_side=np.array([side_names.GetValue(line) for line in np.flatnonzero(lines)], dtype=str),
        valence=copied(grid.GetPointData(), names.Valence),
        irregular=copied(grid.GetPointData(), names.Irregular), block=of(quads, names.BlockId),
        scaled_jacobian=of(quads, names.ScaledJacobian),
        blocks=[_points_of_block(blocks.GetBlock(i)) for i in range(blocks.GetNumberOfBlocks())],
        layout=chains(places(layout), layout.GetLines()), singularities=used,
        report=report_of("quads", grid, mesher.GetStageSeconds(),
                         singularities=used.data if was_chosen or used.events else None),
        grid=grid, block_data=blocks, layout_data=layout, quad_nodes=quad_nodes, edge_nodes=edge_nodes,
        region=of(quads, names.Region) if grid.GetCellData().HasArray(names.Region) else np.zeros(len(quad_nodes), int))


@checks_arguments
def quads(domain: Domain, singularities: Singularities = None, *, size: Optional[float] = None,
          count: Optional[int] = None, mesh_size: Optional[float] = None,
          corners: Union[Corners, Singularities, CornerRows] = None, cap_corners: bool = True,
          sizing: str = "auto", size_array: Optional[str] = None, merge: str = "none", hold: bool = False,
          prefer: Optional[str] = None, alternative: int = 0,
          repair_holonomy: bool = False, repair_part: float = 1.0, split: bool = False,
          clearance: Optional[float] = None, pairs: int = 0, names: Optional[str] = None,
          materials: Optional[str] = None, lines: Optional[Lines] = None, open_lines: Sequence[str] = (),
          nodes: Optional[Sequence[Sequence[float]]] = None,
          counts: Optional[Mapping[str, int]] = None, progressions: Optional[Mapping[str, Progression]] = None,
          sizes: Optional[Mapping[str, float]] = None, sizes_inside: Optional[Mapping[str, float]] = None,
          sizes_near: Optional[Sequence[Sequence[float]]] = None, min_size: Optional[float] = None,
          max_size: Optional[float] = None, growth: Optional[float] = None,
          layers: Optional[Layers] = None, curves: Optional[Curves] = None,
          periodic: Optional[Periodic] = None, order: int = 1, feature_angle: float = 35.0,
          chord_error: Optional[float] = None) -> QuadMesh:
    """Computes an all-quad mesh with exactly the chosen irregular nodes.

    domain, singularities, corners
                   as for `solve`, without holes; without singularities they are chosen for the domain, and
                   report["events"] lists the decisions. A domain may also be a surface in space: `configuration`
                   makes its singularities from points (n, 3), and of the arguments below only size, count, sizing,
                   size_array, sizes_near, min_size, max_size, growth, hold, order, feature_angle, chord_error,
                   materials, names and merge ("none" or "coarse") apply.
                   `corners` may also be a dictionary that sets what
                   rows of quads do, as {(1, 0): "leave", "wall": "turn"}: "end" on the next side, "turn" around
                   the corner, or "leave" it along a grid line; keys are positions, names of sides for all of
                   their corners, or ranges of angles in degrees as "200-300"
    size           mean side length of quads
    count          target number of quads, instead of a size; default: as many as prescribed sizes need, 1000
                   without any
    mesh_size      edge length of the triangles on which the map is solved; default: 1/40 of the diagonal
    cap_corners    gives sharp corners of quarter index 2, which have no angle in a seamless map, index 1
    sizing         "conformal": sizes of the field, the best shapes; "uniform": the same everywhere,
                   singularities may move; "field": the lengths in a point array of the domain, or their
                   proportions if `count` is given; with the last two, chosen singularities are moved to where
                   sizes are nearest to these; "auto": conformal if sizes are nearly uniform, or singularities are
                   given and sizes not very different, otherwise uniform as far as the worst quad stays good
    size_array     name of this array
    merge          separatrices that nearly meet: "none" keeps them apart; "clean" moves singularities until they
                   meet, as far as the quads stay as good; "coarse" merges them in place, for the fewest
                   blocks whose worst quad is at least half as good
    prefer         what matters most where several configurations of singularities are chosen and each has quads as
                   good: "nodes" (few irregular ones), "blocks" (few) or "uniform" (sizes); default: low energy and
                   symmetry
    alternative    which of them is used: 0 is the preferred one, and report["alternatives"] lists all
    hold           keeps the nodes of given singularities where these are; otherwise they move where shapes or sizes
                   are poor without this, and report["moves"] lists their moves
    repair_holonomy
                   moves singularities by the smallest distances after which no inner loop has a holonomy defect
    repair_part    part of the way that repair_holonomy moves the singularities, 0 to 1
    split          splits singularities inside of quarter index k, |k| >= 2, into |k| of index 1 or -1, about 1.5
                   quads apart
    clearance      minimum distance of chosen singularities to the boundary and to each other; default: 0.7 of
                   the size of quads
    pairs          maximum number of pairs of quarter indices 1 and -1 that are added to chosen singularities
                   where they make sizes more uniform
    names          name of the cell array of the domain's lines with the names of the boundary's sides; default:
                   "Side" if the domain has it, otherwise "outer0", "outer1", ..., "hole0", ... between corners
    materials      name of the cell array of a mesh with the materials of its cells, strings or integers: quads are made
                   for each material and meet at the nodes between them, sides of the name "steel+copper", and
                   report["regions"] has each region; "curves": every closed curve of a drawing bounds a material,
                   except those whose names begin with "hole"; "none": one material; default: "Material" or "Region" if the
                   domain has it
    lines          lines inside of the domain along which quads are aligned, such as welds: points by names, as
                   {"weld": [(0, 0), (1, 0)]}, or names of lines of the domain or of curves of a drawing
    open_lines     names of lines, or of sides between materials, whose two sides have nodes of their own, such as
                   cracks: sides of the names "crack.left" and "crack.right"
    nodes          positions where the mesh has nodes: the nearest node is moved there, by at most one quad
    counts         number of edges by the name of a side
    progressions   last edge over the first by the name of a side, with the domain on the left; or the lengths
                   (first, last); or ("both", ratio), ("both", first, middle) towards both ends
    sizes          length of edges by the name of a side, met within 20 %, from which sizes grow
    sizes_inside   target size of the quads in what a side encloses, a closed curve, by its name
    sizes_near     target sizes near positions, as rows (x, y, size) or (x, y, size, radius): up to the radius from the
                   position, from where sizes grow; report["size_target"] says how closely sizes are met
    min_size, max_size
                   bounds of target sizes
    growth         largest ratio of target sizes of neighbours, where sizes grow; default: 1.25
    layers         boundary layers, as {"wall": (1e-4, 1.2)}: for each named side the height of the first row,
                   normal to the wall, and optionally the maximum growth from row to row (default: 1.2) and the
                   number of rows, or as the text "wall:1e-4,1.2;hole:1e-3"; report["layers"] has the measures, and
                   `count` includes the rows
    curves         curves that sides stand for, as {"hole": "circle"}: "circle", "ellipse", "spline" (cubic through
                   the points) or "line"; or "auto", which recognises arcs of circles; nodes are then on the curves
    periodic       pairs of sides that are images of each other under a translation or rotation, as {"left": "right"}
                   or a list of pairs: equal numbers of edges and nodes that match; report["periodic"] has the motions
    order          order of the quads, 1 to 3; with 2 and 3, edges of the boundary follow the curves
    feature_angle  of a surface in space: angle in degrees between the normals of two triangles above which quads follow
                   their edge; 180: no edge is sharp
    chord_error    of a surface in space: how far the centres of quads may be from it

    The singularities and corners used are in `singularities` of the result. Inverted quads are a
    RuntimeWarning, and report["inverted"] counts them.

    >>> mesh = quads("builtin:l-shape", size=0.2)
    >>> mesh
    <QuadMesh: 75 quads in 3 blocks, minimum scaled Jacobian 1.00>
    >>> mesh.quads.shape, mesh.report["irregular"], [block.shape for block in mesh.blocks]
    ((75, 4), {}, [(6, 6, 3), (6, 6, 3), (6, 6, 3)])
    >>> plate = [(0, 0), (3, 0), (3, 1), (0, 1)]
    >>> quads(plate, [(1, 0.5, 1), (2, 0.5, -1)], count=300).report["asked"]
    {'3': 1, '5': 1}
    >>> mesh = quads([(0, 0), (1, 0), (1, 1), (0, 1)], size=0.05, layers={"outer0": (1e-3, 1.2)})
    >>> [layer["rows"] for layer in mesh.report["layers"]]
    [23]
    >>> square = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    >>> mesh = quads(square, count=400, lines={"crack": [(-1, 0), (0, 0)]}, open_lines=["crack"])
    >>> [side["edges"] for side in mesh.report["sides"] if side["name"].startswith("crack")]
    [10, 10]
    >>> polygon = [(np.cos(a), np.sin(a)) for a in np.linspace(0, 2 * np.pi, 16, endpoint=False)]
    >>> mesh = quads(polygon, count=100, curves="auto", order=2)
    >>> bool(np.allclose(np.linalg.norm(mesh.points[mesh.edge_nodes], axis=-1), 1, atol=1e-14))
    True
    """
    if size is not None and count is not None:
        raise Error("Both the size of the quads and their number are given; leave one out.")
    if count is not None and not count > 0:
        raise Error("The number %s of quads is not positive; give a number, or None." % count)
    if order not in (1, 2, 3):
        raise Error("There are no quads of order %s; give 1, 2 or 3." % order)
    if sizing not in _SIZINGS:
        raise Error("There is no sizing '%s'; choose %s." % (sizing, ", ".join(_SIZINGS)))
    if merge not in _MERGES:
        raise Error("There is no merge '%s'; choose %s." % (merge, ", ".join(_MERGES)))
    if prefer is not None and prefer not in _PREFERENCES:
        raise Error("There is no preference '%s'; choose %s." % (prefer, ", ".join(_PREFERENCES)))
    if (sizing == "field") != (size_array is not None):
        raise Error("The sizing 'field' and the name size_array go together; give both or none.")
    if sizing == "field" and size is not None:
        raise Error("The sizing 'field' has its sizes in the array; leave size out, or give count.")
    pipeline = Pipeline()
    data = as_domain(domain, mesh_size, materials, line_names(lines) + line_names(open_lines))
    data = with_lines(data, lines, names)
    mesher = pipeline.add(vtkQuadMesher())
    mesher.SetInputData(data)
    mesher.SetQuadSize(checked(size))
    if count is not None:
        mesher.SetQuadCount(count)
    elif sizes or sizes_inside or sizes_near or min_size is not None or max_size is not None or chord_error:
        mesher.SetQuadCount(0)  # as many as the sizes need
    mesher.SetMeshSize(checked(mesh_size))
    mesher.SetCapCorners(cap_corners)
    mesher.SetSizing(_SIZINGS[sizing])
    if size_array is not None:
        mesher.SetSizeArray(size_array)
        mesher.SetQuadSize(1.0 if count is None else 0.0)  # factor of the array's lengths
    mesher.SetSideNameArray(names or "")
    mesher.SetMaterialArray(material_array(materials))
    mesher.SetLines(";".join(line_names(lines)))
    mesher.SetOpenLines(";".join(line_names(open_lines)))
    for place in positions([] if nodes is None else nodes, "positions of nodes"):
        mesher.AddNode(*place)
    for side, edges in dictionary(counts or {}, "argument counts", "{'wall': 40}").items():
        mesher.AddSide(side, str(whole(edges, "count of '%s'" % side)), "", "")
    for side, progression in dictionary(progressions or {}, "argument progressions", "{'wall': 2.0}").items():
        mesher.AddSide(side, "", _progression_text(side, progression), "")
    for side, length in dictionary(sizes or {}, "argument sizes", "{'wall': 0.1}").items():
        mesher.AddSide(side, "", "", "%.17g" % number(length, "size of '%s'" % side, "a length"))
    for side, length in dictionary(sizes_inside or {}, "argument sizes_inside", "{'outer': 0.1}").items():
        mesher.AddSizeInside(side, "%.17g" % number(length, "size inside '%s'" % side, "a length"))
    for row in sizes_near or ():
        _add_size_near(mesher, row)
    if growth is not None:
        mesher.SetGrowth(growth)
    mesher.SetMinimumSize(checked(min_size))
    mesher.SetMaximumSize(checked(max_size))
    mesher.SetMerge(_MERGES[merge])
    if prefer is not None:
        mesher.SetPrefer(_PREFERENCES[prefer])
    mesher.SetAlternative(whole(alternative, "alternative"))
    mesher.SetHoldSingularities(hold)
    mesher.SetFeatureAngle(feature_angle)
    mesher.SetChordError(checked(chord_error))
    mesher.SetRepairHolonomy(repair_holonomy)
    mesher.SetRepairPart(repair_part)
    mesher.SetSplitSingularities(split)
    mesher.SetClearance(checked(clearance))
    mesher.SetPairs(pairs)
    if singularities is not None:
        mesher.SetSingularitiesData(as_configuration(singularities))
    if layers is not None:
        mesher.SetLayers(layers_text(layers))
    if curves is not None:
        mesher.SetCurves(curves_text(curves))
    if periodic is not None:
        mesher.SetPeriodic(periodic_text(periodic))
    if isinstance(corners, Mapping):
        mesher.SetCornerRows(corner_rows_text(corners))
    elif corners is not None:
        mesher.SetCornersData(corner_points(corners))
    return _mesh_of(pipeline, pipeline.update(mesher), singularities is None, order)
