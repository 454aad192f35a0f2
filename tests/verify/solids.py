"""Checks hexahedra and prisms that were swept from quads, recomputed from points and cells alone."""
import numpy as np

FACES = {8: ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)),
         6: ((0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0))}  # outward in VTK's order


def check_solids(data, report):
    """Checks that cells are conforming and not turned over, faces those of the boundary, blocks full lattices."""
    layers = data.value("SweepLayers")
    report.true("cells are hexahedra or prisms with their faces", data.only_known_solids)
    report.equal("Hexahedra", data.value("Hexahedra"), len(data.solids))
    level = data.solid_cells["K"]
    report.equal("cells of each layer", np.bincount(level, minlength=layers).tolist(),
                 [len(data.solids) // layers] * layers)
    used = np.concatenate(data.solids)
    report.true("every point is in a cell", len(np.unique(used)) == len(data.points))
    times = {}
    volumes = []
    for cell in data.solids:
        middle = data.points[cell].mean(axis=0)
        volume = 0.0
        for face in FACES[len(cell)]:
            corners = cell[list(face)]
            key = tuple(sorted(corners.tolist()))
            times[key] = times.get(key, 0) + 1
            at = data.points[corners] - middle
            centre = at.mean(axis=0)
            for a, b in zip(at, np.roll(at, -1, axis=0)):
                volume += np.linalg.det([a, b, centre]) / 6
        volumes.append(volume)
    report.true("no face has more than two cells", max(times.values()) <= 2)
    single = sorted(key for key, count in times.items() if count == 1)
    given = sorted(tuple(sorted(face)) for face in data.quads.tolist() + data.triangles.tolist())
    report.true("every face of the boundary is there once, and no other", single == given)
    report.true("no cell is turned over", min(volumes) > 0, "the least volume is %g" % min(volumes))
    places = np.stack([data.solid_cells[name] for name in ("BlockId", "I", "J", "K")], axis=1)
    full = len(np.unique(places, axis=0)) == len(places) and places.min() >= 0
    for number in np.unique(places[:, 0]):
        own = places[places[:, 0] == number]
        full = full and len(own) == np.prod(own[:, 1:].max(axis=0) + 1)
    report.true("blocks are full lattices", bool(full))
    if "SweepHeight" in data.field:
        heights = [np.linalg.norm(data.points[cell[i + 4]] - data.points[cell[i]])
                   for cell in data.solids for i in range(4)]
        wanted = data.value("SweepHeight") / layers
        report.bound("layers have equal heights", max(abs(h / wanted - 1) for h in heights), 1e-6, "rounding")
