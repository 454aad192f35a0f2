"""Builds triangulated surfaces from grids, levels of fields, and trimmed and extruded plane domains, with VTK and NumPy."""
import math

import numpy as np
import vtk
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray


def surface(points, triangles, regions=None, lines=()):
    """Returns a vtkPolyData; `regions` has a name for each triangle, `lines` are pairs of a name and indices of points."""
    data, places, faces = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkCellArray()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=True))
    rows = np.column_stack([np.full(len(triangles), 3), triangles]).astype(np.int64)
    faces.SetCells(len(triangles), numpy_to_vtkIdTypeArray(rows.ravel(), deep=True))
    data.SetPoints(places)
    data.SetPolys(faces)
    if lines:
        drawn = vtk.vtkCellArray()
        for _, ids in lines:
            drawn.InsertNextCell(len(ids))
            for point in ids:
                drawn.InsertCellPoint(int(point))
        data.SetLines(drawn)  # VTK numbers lines before triangles
        add_strings(data, "Side", [name for name, _ in lines] + [""] * len(triangles))
    if regions is not None:
        add_strings(data, "Region", [""] * len(lines) + list(regions))
    return data


def add_strings(data, name, values):
    array = vtk.vtkStringArray()
    array.SetName(name)
    for value in values:
        array.InsertNextValue(value)
    data.GetCellData().AddArray(array)


def grid(across, along, place, closed_across=False, closed_along=False):
    """Returns the surface place(u, v) over the unit square, with as many squares in each direction; `place` takes and returns arrays."""
    columns, rows = across + (not closed_across), along + (not closed_along)
    u, v = np.meshgrid(np.arange(columns) / across, np.arange(rows) / along)
    i, j = (part.ravel() for part in np.meshgrid(np.arange(across), np.arange(along)))
    a, b = j * columns + i, j * columns + (i + 1) % columns
    above = (j + 1) % rows
    c, d = above * columns + (i + 1) % columns, above * columns + i
    return surface(np.stack(place(u.ravel(), v.ravel()), axis=1), np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)]))


def ball(n, place=lambda points: points):
    """Returns the image of the unit sphere, which is a cube of n × n squares a face, blown up."""
    numbers, triangles = {}, []
    for axis in range(3):
        for end in (0, n):
            for i in range(n):
                for j in range(n):
                    corners = []
                    for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        at = [0, 0, 0]
                        at[axis] = end
                        at[(axis + 1) % 3] = i + (di if end else dj)
                        at[(axis + 2) % 3] = j + (dj if end else di)
                        corners.append(numbers.setdefault(tuple(at), len(numbers)))
                    triangles += [corners[:3], [corners[0], *corners[2:]]]
    cube = np.tan(math.pi / 4 * (2 * np.array(list(numbers)) / n - 1))
    return surface(place(cube / np.linalg.norm(cube, axis=1)[:, None]), triangles)


def level(field, low, high, step):
    """Returns the level 0 of field(x, y, z) in a box, smoothed, because triangles of a grid are slivers."""
    axes = [np.linspace(a, b, max(2, round((b - a) / step) + 1)) for a, b in zip(low, high)]
    image = vtk.vtkImageData()
    image.SetDimensions(*map(len, axes))
    image.SetOrigin(*low)
    image.SetSpacing(*(axis[1] - axis[0] for axis in axes))
    values = field(*np.meshgrid(*axes, indexing="ij"))
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(order="F"), deep=True))
    contour = vtk.vtkFlyingEdges3D()
    contour.SetInputData(image)
    contour.SetValue(0, 0.0)
    contour.ComputeNormalsOff()
    return smoothed(contour)


def smoothed(source):
    """Returns the surface of a filter after smoothing that keeps its volume."""
    smooth = vtk.vtkWindowedSincPolyDataFilter()
    smooth.SetInputConnection(source.GetOutputPort())
    smooth.SetNumberOfIterations(30)
    smooth.SetPassBand(0.02)
    smooth.NormalizeCoordinatesOn()
    smooth.Update()
    return smooth.GetOutput()


def circle(x, y, radius, step):
    count = max(12, round(2 * math.pi * radius / step))
    return [(x + radius * math.cos(2 * math.pi * k / count), y + radius * math.sin(2 * math.pi * k / count)) for k in range(count)]


def divided(loop, step):
    """Returns the loop with points between its corners, at most `step` apart."""
    points = []
    for (a, b), (c, d) in zip(loop, loop[1:] + loop[:1]):
        count = max(1, math.ceil(math.hypot(c - a, d - b) / step - 1e-9))
        points += [(a + (c - a) * k / count, b + (d - b) * k / count) for k in range(count)]
    return points


def inside(loop, places):
    """Returns which places are in a loop."""
    found = np.zeros(len(places), dtype=bool)
    for (a, b), (c, d) in zip(loop, loop[1:] + loop[:1]):
        if b != d:
            found ^= ((b > places[:, 1]) != (d > places[:, 1])) & (
                places[:, 0] < a + (c - a) * (places[:, 1] - b) / (d - b))
    return found


def trimmed(outline, holes, step, kept=()):
    """Returns the points (n, 2) and triangles of a plane domain; the points of the loops come first, in their order.

    Loops of `kept` are edges of triangles, with the domain on both sides.
    """
    loops = [outline, *holes, *kept]
    on_loops = np.array([point for loop in loops for point in loop])
    low, high = on_loops.min(axis=0), on_loops.max(axis=0)
    i, j = (part.ravel() for part in np.meshgrid(np.arange(int((high[0] - low[0]) / step) + 2),
                                                 np.arange(int((high[1] - low[1]) / step * 1.1548) + 2)))
    lattice = np.column_stack([low[0] + step * (i + 0.5 * (j % 2)), low[1] + step * 0.866 * j])
    free = inside(outline, lattice)
    for hole in holes:
        free &= ~inside(hole, lattice)
    for point in on_loops:
        free &= np.hypot(*(lattice - point).T) > 0.75 * step
    places = np.concatenate([on_loops, lattice[free]])
    flat = surface(np.column_stack([places, np.zeros(len(places))]), np.zeros((0, 3), dtype=int))
    delaunay = vtk.vtkDelaunay2D()
    delaunay.SetInputData(flat)
    delaunay.Update()
    cells = delaunay.GetOutput()
    triangles = np.array([[cells.GetCell(c).GetPointId(k) for k in range(3)] for c in range(cells.GetNumberOfCells())])
    middle = places[triangles].mean(axis=1)
    wanted = inside(outline, middle)
    for hole in holes:
        wanted &= ~inside(hole, middle)
    (a, b), (c, d) = ((places[triangles[:, k]] - places[triangles[:, 0]]).T for k in (1, 2))
    turned = a * d - b * c < 0
    triangles[turned] = triangles[turned][:, ::-1]
    return places, triangles[wanted]


def extruded(outline, holes, step, height):
    """Returns the closed surface of a plane domain that is extruded."""
    places, flat = trimmed(outline, holes, step)
    layers, count = max(1, round(height / step)), len(places)
    points = np.concatenate([np.column_stack([places, np.full(count, height * k / layers)]) for k in range(layers + 1)])
    triangles, first = [flat[:, ::-1], flat + layers * count], 0
    for loop in (outline, *holes):
        a = first + np.arange(len(loop))
        b = first + (np.arange(len(loop)) + 1) % len(loop)
        if sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(loop, loop[1:] + loop[:1])) * (1 if loop is outline else -1) < 0:
            a, b = b, a
        for k in range(layers):
            low, high = k * count, (k + 1) * count
            triangles += [np.stack([a + low, b + low, b + high], 1), np.stack([a + low, b + high, a + high], 1)]
        first += len(loop)
    return cleaned(surface(points, np.concatenate(triangles)))


def cleaned(data):
    """Returns the surface without points that no triangle has."""
    clean = vtk.vtkCleanPolyData()
    clean.PointMergingOff()
    clean.SetInputData(data)
    clean.Update()
    return clean.GetOutput()


def write(data, path):
    writer = vtk.vtkXMLPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(data)
    writer.Write()
