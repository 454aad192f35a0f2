"""Checks a written field from its .vtu alone, read with numpy and without VTK."""

import base64
import re
import zlib
import xml.etree.ElementTree as ElementTree

import numpy as np

TYPES = {"Float64": "f8", "Float32": "f4", "Int64": "i8", "Int32": "i4", "UInt8": "u1", "Int8": "i1"}


def _values(array):
    """Returns the numbers of a DataArray of inline binary data, compressed in blocks by zlib."""
    text = re.sub(r"\s", "", array.text or "")
    if not text:
        return np.zeros(0, TYPES[array.get("type")])
    # 32-bit numbers: count of blocks, size of a block, size of the last, compressed size of each.
    count = int(np.frombuffer(base64.b64decode(text[:8])[:4], "u4")[0])
    head = 4 * -(-4 * (3 + count) // 3)
    sizes = np.frombuffer(base64.b64decode(text[:head])[:4 * (3 + count)], "u4")[3:]
    data = base64.b64decode(text[head:])
    ends = np.cumsum(sizes).astype(int)
    parts = [zlib.decompress(data[end - int(size):end]) for end, size in zip(ends, sizes)]
    return np.frombuffer(b"".join(parts), TYPES[array.get("type")])


def read(path):
    """Returns all arrays of numbers by section and name, for example ("CellData",
    "CrossFieldCR")."""
    root = ElementTree.parse(path).getroot()
    assert root.get("compressor") == "vtkZLibDataCompressor" and root.get("header_type") == "UInt32"
    arrays = {}
    for section in ("FieldData", "PointData", "CellData", "Points", "Cells"):
        for array in root.iter(section):
            for item in array.iter("DataArray"):
                if item.get("type") in TYPES:
                    values = _values(item)
                    components = int(item.get("NumberOfComponents", 1))
                    arrays[section, item.get("Name")] = (
                        values.reshape(-1, components) if components > 1 else values)
    return arrays


def _degree(edges, values):
    """Returns the turns of a phase around a closed chain of edges (from, to), in its direction."""
    follow = {int(a): (int(b), value) for (a, b), value in zip(edges, values)}
    here = start = int(edges[0][0])
    phases = []
    while True:
        here, value = follow.pop(here)
        phases.append(np.angle(value))
        if here == start:
            break
    assert not follow, "the edges of a hole are not one closed chain"
    steps = np.diff(np.append(phases, phases[0]))
    steps = (steps + np.pi) % (2.0 * np.pi) - np.pi
    return int(np.rint(steps.sum() / (2.0 * np.pi)))


def verified(path):
    """Returns None if the field is finite and aligned, has the requested degrees and indices with
    the required sum.

    Otherwise returns a sentence. The sum: 4χ = Σ of the holes + Σ of the corners by the smallest
    rotation.
    """
    arrays = read(path)
    for name, values in arrays.items():
        if not np.all(np.isfinite(values)):
            return f"{name} has values that are not finite"
    points = arrays["Points", "Points"]
    ends = arrays["Cells", "offsets"]
    ids = arrays["Cells", "connectivity"]
    lines = np.flatnonzero(arrays["Cells", "types"] == 3)
    kind, loop, quarter = (
        arrays["CellData", name][lines] for name in ("BoundaryKind", "BoundaryId", "QuarterIndex"))
    edges = np.stack([ids[ends[lines] - 2], ids[ends[lines] - 1]], axis=1)
    field = arrays["CellData", "CrossFieldCR"][lines]
    u = field[:, 0] + 1j * field[:, 1]
    along = points[edges[:, 1], :2] - points[edges[:, 0], :2]
    tangent = along[:, 0] + 1j * along[:, 1]
    length = np.abs(tangent)

    aligned = (kind == 1) | (kind == 2)
    off = np.abs(u - (tangent / length) ** 4)[aligned]
    # Rounding of coordinates turns a short edge, and u by four times that angle.
    rounding = 16.0 * np.finfo(float).eps * (1.0 + np.abs(points).max() / length[aligned])
    if np.any(off > rounding):
        return f"an edge is off alignment by {off.max()}"

    # Singularities on the boundary replace corners; in the plane z = 0, sizes about 1.
    boundary = arrays.get(("FieldData", "BoundarySingularities"), np.zeros((0, 4))).reshape(-1, 4)
    given = 0
    for row in np.unique(loop[kind == 3]):
        hole = (kind == 3) & (loop == row)
        degree = -_degree(edges[hole], u[hole])  # the domain is on the left: clockwise
        if degree != quarter[hole][0]:
            return f"hole {row} has degree {degree} instead of {quarter[hole][0]}"
        given += degree

    corners = 0
    for row in np.unique(loop[aligned]):
        on = aligned & (loop == row)
        after = dict(zip(edges[on][:, 0], tangent[on]))
        for (_, here), before in zip(edges[on], tangent[on]):
            turn = np.angle(after[here] / before)
            chosen = [k for x, y, _, k in boundary if np.hypot(*(points[here][:2] - (x, y))) < 1e-6]
            if chosen:
                corners += int(chosen[0])
            elif abs(turn) > np.pi / 6 + 1e-9:
                # The smallest rotation is in (−π/4, π/4].
                corners += int(np.ceil(turn / (0.5 * np.pi) - 0.5 - 1e-9))
    inner = len(np.unique(loop[kind == 2]))
    if given != 4 * (1 - inner) - corners:
        return f"indices add up to {given} and not to {4 * (1 - inner) - corners}"
    return None
