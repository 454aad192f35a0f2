"""Checks the arrays and the report of a quad mesh, recomputed from points and cells alone."""
import numpy as np

from plane import Frame
from report import ROUNDING, Unverifiable


def _cross(a, b):
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def check_quads(data, report):
    """Checks conformity, valences, blocks, shapes and counts.

    Files that ParaView saves have the quads alone, without boundary lines and counts.
    """
    frame = Frame(data.points)
    # Damaged planes deviate little; a surface in space has no plane at all.
    is_surface = frame.deviation > 1e-2 * frame.size
    if not is_surface:
        report.bound("points lie in a plane", frame.deviation, 1e-6 * frame.size, "of the domain's size")
    report.true("cells are quads and lines", len(data.triangles) == 0 and data.only_known_cells)
    place = np.unique(data.points, axis=0, return_inverse=True)[1].ravel()
    repeated = np.flatnonzero(np.bincount(place)[place] > 1)
    report.true("no two points are in one place", set(repeated.tolist()) <= _points_of_open_lines(data, place),
                "%d points have %d places" % (len(data.points), place.max() + 1))
    distinct = [len(set(quad)) == 4 for quad in data.quads.tolist()]
    report.true("quads have four points", all(distinct), "%d have not" % (len(distinct) - sum(distinct)))
    has_lines = "BoundaryId" in data.cells
    if has_lines and "Region" in data.quad_cells:
        _check_interfaces(data, report)
    if has_lines:
        _check_features(data, report)
    edges = _check_edges(data, has_lines, report)
    loops = _loops(data)
    characteristic = len(data.points) - len(edges) + len(data.quads)
    without_handles = 2 * _check_parts(data, place, report) - len(loops)
    if is_surface:
        handles = (without_handles - characteristic) / 2
        report.true("the number of handles is whole", handles in range(len(data.quads)), "it is %g" % handles)
    else:
        report.equal("Euler characteristic of a connected mesh in its loops", without_handles, characteristic)
        characteristic = without_handles
    on_loop = np.full(len(data.points), -1)
    for number, loop in loops.items():
        on_loop[loop] = number
    report.true("BoundarySide is the loop of a point", np.array_equal(data.at_points["BoundarySide"], on_loop))
    _check_valences(data, on_loop, characteristic, report)
    _check_blocks(data, report)
    _check_shapes(data, frame, is_surface, report)
    report.note("SizeRatio needs the wanted sizes, zero arcs and integers the layout, SurfaceDistance and "
                "ScaledJacobianBySurface the surface, which the file does not have: not recomputed")


def _points_of_open_lines(data, place):
    """Returns the points of lines of the boundary that lead along another one in the opposite direction, as both
    sides of cracks do."""
    if "BoundaryId" not in data.cells:
        return set()
    ends = place[data.lines]
    lines = set(map(tuple, ends.tolist()))
    return {int(point) for (a, b), line in zip(ends.tolist(), data.lines) if (b, a) in lines for point in line}


def _check_interfaces(data, report):
    """Checks the lines between materials and inside of one, and leaves only those of the boundary in `data`."""
    left = {(quad[i], quad[(i + 1) % 4]): region
            for quad, region in zip(data.quads.tolist(), data.quad_cells["Region"].tolist()) for i in range(4)}
    between = {tuple(sorted(side)) for side, region in left.items() if left.get(side[::-1], region) != region}
    inner = data.cells["BoundaryKind"][1] == 5
    lines = [tuple(sorted(line)) for line in data.lines[inner].tolist()]
    inside = {tuple(sorted(side)) for side in left if side[::-1] in left}
    report.true("the edges between materials have one line, and others are inside",
                between <= set(lines) <= inside and len(lines) == len(set(lines)))
    for name, step in (("RegionLeft", 1), ("RegionRight", -1), ("Region", 1)):
        report.true(name + " is the material beside a line", data.cells[name][1].tolist() == [
            left.get(tuple(line[::step]), -1) for line in data.lines.tolist()])
    _leave(data, ~inner)


def _check_features(data, report):
    """Checks the lines on sharp edges of a surface, and leaves only those of the boundary in `data`."""
    inner = data.cells["BoundaryKind"][1] == 7
    sides = {(quad[i], quad[(i + 1) % 4]) for quad in data.quads.tolist() for i in range(4)}
    lines = data.lines[inner].tolist()
    report.true("the edges on sharp edges are inside, with one line each",
                all((a, b) in sides and (b, a) in sides for a, b in lines) and
                len(lines) == len({frozenset(line) for line in lines}))
    _leave(data, ~inner)


def _leave(data, kept):
    """Leaves some of the lines in `data`."""
    data.lines = data.lines[kept]
    for name, (cells, of_lines) in data.cells.items():
        data.cells[name] = cells, of_lines[kept]


def _components(count, quads):
    """Returns for each quad the smallest of `count` points that quads connect with it."""
    labels = np.arange(count)
    while True:  # every point takes the smallest number of its quads
        smallest = labels.copy()
        np.minimum.at(smallest, quads, labels[quads].min(axis=1)[:, None])
        smallest = smallest[smallest]
        if np.array_equal(smallest, labels):
            return labels[quads[:, 0]]
        labels = smallest


def _check_parts(data, place, report):
    """Checks the numbers of the connected parts, to which both sides of open lines belong, and returns how many there
    are without these."""
    if "Part" in data.quad_cells:  # a designed layout has one part
        of_quad = _components(len(data.points), place[data.quads])
        pairs = {(int(a), int(b)) for a, b in zip(of_quad, data.quad_cells["Part"])}
        parts = len(np.unique(of_quad))
        report.true("Part numbers what is connected",
                    len(pairs) == parts and sorted({b for _, b in pairs}) == list(range(parts)))
    return len(np.unique(_components(len(data.points), data.quads)))


def _check_edges(data, has_lines, report):
    """Checks the edges and returns them without direction; adds lines where the file has none."""
    sides = np.concatenate([data.quads[:, [i, (i + 1) % 4]] for i in range(4)])
    directed, times = np.unique(sides, axis=0, return_counts=True)
    report.true("quads agree in their orientation", bool((times == 1).all()))
    edges, quads = np.unique(np.sort(sides, axis=1), axis=0, return_counts=True)
    report.true("no edge has more than two quads", bool((quads <= 2).all()))
    opposite = set(map(tuple, directed[:, ::-1].tolist()))
    single = {side for side in map(tuple, sides.tolist()) if side not in opposite}
    if not has_lines:
        data.lines = np.array(sorted(single))
        data.cells["BoundaryId"] = None, data.at_points["BoundarySide"][data.lines[:, 0]]
        return edges
    report.true("every boundary edge has one line with the domain on its left, and no other has",
                single == set(map(tuple, data.lines.tolist())) and len(single) == len(data.lines))
    return edges


def _loops(data):
    """Returns the points of each loop by its number."""
    number = data.cells["BoundaryId"][1]
    following = dict(data.lines.tolist())
    loops = {}
    for of in np.unique(number):
        lines = data.lines[number == of]
        start = point = int(lines[0, 0])
        loop = []
        while point not in loop[:1] and len(loop) <= len(lines):
            loop.append(point)
            point = following.get(point, start)
        if len(loop) != len(lines) or set(loop) != set(lines[:, 0].tolist()):
            raise Unverifiable("the lines of loop %d are no closed curve" % of)
        loops[int(of)] = loop
    return loops


def _check_valences(data, on_loop, characteristic, report):
    valence = np.bincount(data.quads.ravel(), minlength=len(data.points))
    report.true("Valence counts the quads", np.array_equal(data.at_points["Valence"], valence))
    index = np.where(on_loop < 0, 4, 2) - valence
    asked = data.at_points["Irregular"]
    wrong = np.flatnonzero(index != asked)
    report.true("quads at a point: 4 - k inside, 2 - k on the boundary", len(wrong) == 0,
                "point %s has %s" % (wrong[:1], valence[wrong[:1]]))
    report.equal("sum of all indices: 4 times the Euler characteristic", int(asked.sum()), 4 * characteristic)
    if "IrregularValence" not in data.field:
        return
    valences = np.atleast_1d(data.field["IrregularValence"]).tolist()
    inside = valence[on_loop < 0]
    found = [int((inside == v).sum()) for v in valences]
    report.equal("IrregularObtained", np.atleast_1d(data.field["IrregularObtained"]).tolist(), found)
    report.equal("irregular nodes as asked", np.atleast_1d(data.field["IrregularRequested"]).tolist(), found)
    report.equal("no other irregular node", int(np.count_nonzero(inside != 4)), sum(found))


def _check_blocks(data, report):
    """Checks that the quads of a block form a full lattice of columns I and rows J, counted from
    its corner."""
    block, column, row = (data.quad_cells[name] for name in ("BlockId", "I", "J"))
    if "Blocks" in data.field:
        report.equal("Blocks", data.value("Blocks"), len(np.unique(block)))
        report.equal("Quads", data.value("Quads"), len(data.quads))
    at = {place: quad for quad, place in enumerate(zip(block.tolist(), column.tolist(), row.tolist()))}
    full = len(at) == len(data.quads)
    for number in np.unique(block):
        own = block == number
        full = full and own.sum() == (column[own].max() + 1) * (row[own].max() + 1)
    report.true("blocks are full lattices", bool(full and column.min() >= 0 and row.min() >= 0))
    joined = True
    for (b, i, j), quad in at.items():
        right, above = at.get((b, i + 1, j)), at.get((b, i, j + 1))
        corners = data.quads[quad]
        joined = joined and (right is None or tuple(data.quads[right][[0, 3]]) == tuple(corners[[1, 2]]))
        joined = joined and (above is None or tuple(data.quads[above][[0, 1]]) == tuple(corners[[3, 2]]))
    report.true("neighbours in a lattice share their side", joined)


def _in_planes_of_diagonals(corners):
    """Returns the corners of quads in space, each projected to the plane of its diagonals."""
    diagonal = corners[:, 2] - corners[:, 0]
    normal = np.cross(diagonal, corners[:, 3] - corners[:, 1])
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    axis = diagonal / np.linalg.norm(diagonal, axis=1)[:, None]
    offset = corners - corners[:, :1]
    return np.stack([np.einsum("qci,qi->qc", offset, axis),
                     np.einsum("qci,qi->qc", offset, np.cross(normal, axis))], axis=2)


def _check_shapes(data, frame, is_surface, report):
    corners = (_in_planes_of_diagonals(data.points[data.quads]) if is_surface and ("Inverted" not in data.field or data.value("Inverted") == 0)
               else frame.coordinates[data.quads])
    following = np.roll(corners, -1, axis=1) - corners
    previous = np.roll(corners, 1, axis=1) - corners
    lengths = np.linalg.norm(following, axis=2) * np.linalg.norm(previous, axis=2)
    sines = _cross(following, previous) / np.where(lengths > 0, lengths, 1.0)
    jacobian = sines.min(axis=1)
    # The rounding of a sine is that of the coordinates, relative to the length of the sides.
    exactness = 64 * (ROUNDING * np.abs(frame.coordinates).max() + frame.exactness) / np.sqrt(
        lengths[lengths > 0].min())
    stated = data.quad_cells["ScaledJacobian"]
    report.bound("ScaledJacobian is the least sine of the angles", np.abs(stated - jacobian).max(), exactness,
                 "rounding of coordinates")
    area = 0.5 * _cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    if not is_surface:
        ends = frame.coordinates[data.lines]
        inside = 0.5 * _cross(ends[:, 0], ends[:, 1]).sum()
        report.bound("quads fill the loops", abs(area.sum() - inside) / inside, exactness, "rounding of areas")
    if "Inverted" not in data.field:
        return
    report.true("no quad is turned over except the reported ones", data.value("Inverted") > 0 or (area > 0).all())
    report.equal("Inverted", data.value("Inverted"), int((jacobian <= 0).sum()))
    report.bound("ScaledJacobianRange", np.abs(
        data.field["ScaledJacobianRange"] - [jacobian.min(), jacobian.mean()]).max(), exactness, "rounding")
    angle = np.arctan2(_cross(following, previous), (following * previous).sum(axis=2)) % (2 * np.pi)
    eta = 1 - 2 / np.pi * np.abs(np.pi / 2 - angle).max(axis=1)
    report.bound("EtaRange", np.abs(data.field["EtaRange"] - [eta.min(), eta.mean()]).max(), exactness,
                 "rounding of angles")
    if "MinimumAngle" in data.field:
        report.bound("MinimumAngle", abs(data.value("MinimumAngle") - np.degrees(angle.min())), 60 * exactness,
                     "rounding of angles, in degrees")
    size = np.sqrt(np.maximum(area, 0.0))
    report.bound("SizeRange: roots of areas", np.abs(
        data.field["SizeRange"] / [size.min(), size.mean(), size.max()] - 1).max(), exactness, "rounding")
