"""Writes domains into the file formats that the program reads, as plain text."""

import pathlib


def _xml(kind, piece):
    return (f'<?xml version="1.0"?>\n<VTKFile type="{kind}" version="1.0" '
            f'byte_order="LittleEndian" header_type="UInt64">\n<{kind}>\n{piece}\n</{kind}>\n'
            '</VTKFile>\n')


def _array(kind, name, values, components=1):
    return (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" '
            f'format="ascii">\n{" ".join(map(str, values))}\n</DataArray>')


def _cells(tag, cells, more=""):
    ends = [sum(map(len, cells[:i + 1])) for i in range(len(cells))]
    ids = [i for cell in cells for i in cell]
    return (f"<{tag}>\n{_array('Int64', 'connectivity', ids)}\n{_array('Int64', 'offsets', ends)}"
            f"\n{more}</{tag}>")


def _place(point):
    """Returns x, y and z; z is 0 if there is none."""
    x, y, z = (*point, 0.0)[:3]
    return f"{x!r} {y!r} {z!r}"


def _points(points):
    values = [_place(map(float, point)) for point in points]
    return f"<Points>\n{_array('Float64', 'Points', values, 3)}\n</Points>"


def write_vtp(path, points, lines):
    piece = (f'<Piece NumberOfPoints="{len(points)}" NumberOfLines="{len(lines)}">\n'
             f'{_points(points)}\n{_cells("Lines", lines)}\n</Piece>')
    pathlib.Path(path).write_text(_xml("PolyData", piece))


def write_singularities(path, rows):
    """Writes rows of x, y, quarter index and radius as the points that vtkSingularitySource
    makes."""
    data = "\n".join(["<PointData>", _array("Int32", "QuarterIndex", [row[2] for row in rows]),
                      _array("Float64", "Radius", [row[3] for row in rows]), "</PointData>"])
    piece = (f'<Piece NumberOfPoints="{len(rows)}" NumberOfVerts="{len(rows)}">\n{data}\n'
             f'{_points([row[:2] for row in rows])}\n'
             f'{_cells("Verts", [[i] for i in range(len(rows))])}\n</Piece>')
    pathlib.Path(path).write_text(_xml("PolyData", piece))


def write_vtu(path, points, triangles):
    types = _array("UInt8", "types", [5] * len(triangles)) + "\n"
    piece = (f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(triangles)}">\n'
             f'{_points(points)}\n{_cells("Cells", triangles, types)}\n</Piece>')
    pathlib.Path(path).write_text(_xml("UnstructuredGrid", piece))


def write_vtk(path, points, triangles):
    lines = ["# vtk DataFile Version 3.0", "a domain", "ASCII", "DATASET UNSTRUCTURED_GRID",
             f"POINTS {len(points)} double"]
    lines += [_place(point) for point in points]
    lines += [f"CELLS {len(triangles)} {4 * len(triangles)}"]
    lines += ["3 " + " ".join(map(str, triangle)) for triangle in triangles]
    lines += [f"CELL_TYPES {len(triangles)}"] + ["5"] * len(triangles)
    pathlib.Path(path).write_text("\n".join(lines) + "\n")


def write_stl(path, points, triangles):
    lines = ["solid domain"]
    for triangle in triangles:
        lines += [" facet normal 0 0 1", "  outer loop"]
        lines += [f"   vertex {_place(points[i])}" for i in triangle]
        lines += ["  endloop", " endfacet"]
    pathlib.Path(path).write_text("\n".join(lines + ["endsolid domain"]) + "\n")


def write_obj(path, points, triangles):
    lines = [f"v {_place(point)}" for point in points]
    lines += ["f " + " ".join(str(i + 1) for i in triangle) for triangle in triangles]
    pathlib.Path(path).write_text("\n".join(lines) + "\n")


def write_ply(path, points, triangles):
    lines = ["ply", "format ascii 1.0", f"element vertex {len(points)}", "property float x",
             "property float y", "property float z", f"element face {len(triangles)}",
             "property list uchar int vertex_indices", "end_header"]
    lines += [_place(point) for point in points]
    lines += ["3 " + " ".join(map(str, triangle)) for triangle in triangles]
    pathlib.Path(path).write_text("\n".join(lines) + "\n")


def write_csv(path, points):
    """Returns the points of one loop in their order."""
    lines = ["x,y,z"[:2 * len(points[0]) - 1]] + [",".join(map(repr, point)) for point in points]
    pathlib.Path(path).write_text("\n".join(lines) + "\n")


def write_loop_obj(path, points):
    """Writes one closed line as .obj."""
    lines = [f"v {_place(point)}" for point in points]
    lines += ["l " + " ".join(str(i + 1) for i in (*range(len(points)), 0))]
    pathlib.Path(path).write_text("\n".join(lines) + "\n")


def write_loop_vtk(path, points):
    """Writes one closed polyline as legacy .vtk."""
    ids = (*range(len(points)), 0)
    lines = ["# vtk DataFile Version 3.0", "a loop", "ASCII", "DATASET POLYDATA",
             f"POINTS {len(points)} double"] + [_place(point) for point in points]
    lines += [f"LINES 1 {len(ids) + 1}", f"{len(ids)} " + " ".join(map(str, ids))]
    pathlib.Path(path).write_text("\n".join(lines) + "\n")


def write_loop(path, points):
    """Writes one closed polyline as .vtp."""
    write_vtp(path, points, [[*range(len(points)), 0]])
