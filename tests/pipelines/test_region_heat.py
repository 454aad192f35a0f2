"""Steady heat conduction in two rings of different conductivity: orders of the L2 error of quads with four and nine nodes."""
import json
import math
import unittest

from program import ProgramTest

try:
    import meshio
    import numpy as np
    import scipy.sparse
    import scipy.sparse.linalg
except ImportError:
    meshio = None

RADII = (1.0, 1.5, 2.0)  # inside, interface, outside
CONDUCTIVITIES = {"core": 1.0, "shell": 10.0}  # inner and outer ring
SIZES = (0.2, 0.1, 0.05)
POINTS = 24  # of the polygon of each circle
QUAD_TYPES = {1: "quad", 2: "quad9"}
LINE_TYPES = {1: "line", 2: "line3"}
# Corners, middles of the sides and the centre, as indices of a lattice.
LATTICE = {1: ((0, 0), (1, 0), (1, 1), (0, 1)), 2: ((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1), (1, 1))}


def rings():
    """Returns both rings as a .vtp file with two polygons each, because a polygon has no holes."""
    points = [(radius * math.cos(2 * math.pi * i / POINTS), radius * math.sin(2 * math.pi * i / POINTS))
              for radius in RADII for i in range(POINTS)]
    cells, letters = [], []
    for ring, material in enumerate(CONDUCTIVITIES):
        for first in (0, POINTS // 2):
            half = [i % POINTS for i in range(first, first + POINTS // 2 + 1)]
            cells.append([(ring + 1) * POINTS + i for i in half] + [ring * POINTS + i for i in reversed(half)])
            letters += [*material.encode(), 0]
    ends = [sum(map(len, cells[:i + 1])) for i in range(len(cells))]
    return """<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64"><PolyData>
<Piece NumberOfPoints="%d" NumberOfPolys="%d">
<CellData><Array type="String" Name="Material" NumberOfTuples="%d" format="ascii">%s</Array></CellData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">%s</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">%s</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">%s</DataArray></Polys></Piece></PolyData></VTKFile>
""" % (len(points), len(cells), len(cells), " ".join(map(str, letters)), " ".join("%.17g %.17g 0" % point for point in points),
       " ".join(str(i) for cell in cells for i in cell), " ".join(map(str, ends)))


def exact(radius):
    """Returns the temperature, 1 inside and 0 outside: its logarithms have the same flux on both sides of the interface."""
    inner, outer = CONDUCTIVITIES.values()
    flux = 1 / (math.log(RADII[1] / RADII[0]) / inner + math.log(RADII[2] / RADII[1]) / outer)
    return np.where(radius < RADII[1], 1 - flux / inner * np.log(radius / RADII[0]), flux / outer * np.log(RADII[2] / radius))


class Mesh:
    """Quads of a .msh file, their conductivities and the nodes of its groups of lines."""

    def __init__(self, file, order):
        data = meshio.read(file)
        self.order, self.points = order, data.points[:, :2]
        self.quads = data.cells_dict[QUAD_TYPES[order]]
        groups = {name: int(group) for name, (group, _) in data.field_data.items()}
        of_quads = data.cell_data_dict["gmsh:physical"][QUAD_TYPES[order]]
        self.conductivity = np.zeros(len(self.quads))
        for material, value in CONDUCTIVITIES.items():
            self.conductivity[of_quads == groups[material]] = value
        of_lines = data.cell_data_dict["gmsh:physical"][LINE_TYPES[order]]
        self.sides = {name: np.unique(data.cells_dict[LINE_TYPES[order]][of_lines == group])
                      for name, group in groups.items() if name not in CONDUCTIVITIES}

    def temperature_error(self):
        """Solves div(k grad u) = 0 and returns the L2 error of u, both with 3 x 3 Gauss points."""
        place, weight = np.polynomial.legendre.leggauss(3)
        place, weight = (place + 1) / 2, weight / 2
        steps = np.arange(self.order + 1) / self.order
        basis = [np.polynomial.Polynomial.fromroots(np.delete(steps, i)) for i in range(self.order + 1)]
        basis = [one / one(step) for one, step in zip(basis, steps)]
        value, slope = (np.array([one(place) for one in ones]) for ones in (basis, [one.deriv() for one in basis]))
        u_value = np.array([np.outer(value[i], value[j]).ravel() for i, j in LATTICE[self.order]])  # node, Gauss point
        u_slope = np.array([[np.outer(slope[i], value[j]).ravel(), np.outer(value[i], slope[j]).ravel()] for i, j in LATTICE[self.order]])
        corners = self.points[self.quads]
        jacobian = np.einsum("eni,nag->egia", corners, u_slope)
        area = np.linalg.det(jacobian) * np.outer(weight, weight).ravel()
        if area.min() <= 0:
            raise ValueError("a quad is inverted")
        gradient = np.einsum("egai,nag->engi", np.linalg.inv(jacobian), u_slope)
        stiffness = np.einsum("engi,emgi,eg,e->enm", gradient, gradient, area, self.conductivity)
        nodes, count = self.quads.shape[1], len(self.points)
        rows, columns = np.repeat(self.quads, nodes, axis=1), np.tile(self.quads, nodes)
        matrix = scipy.sparse.coo_matrix((stiffness.ravel(), (rows.ravel(), columns.ravel())), (count, count)).tocsr()
        u, free = np.zeros(count), np.zeros(count, bool)
        free[self.quads] = True  # the file may have points that no quad uses
        for side, boundary_value in (("hole0", 1.0), ("outer0", 0.0)):
            u[self.sides[side]], free[self.sides[side]] = boundary_value, False
        u[free] = scipy.sparse.linalg.spsolve(matrix[free][:, free].tocsc(), -(matrix @ u)[free])
        radius = np.linalg.norm(np.einsum("eni,ng->egi", corners, u_value), axis=-1)
        difference = np.einsum("en,ng->eg", u[self.quads], u_value) - exact(radius)
        return math.sqrt(np.sum(difference**2 * area))


@unittest.skipUnless(meshio, "meshio or scipy is not installed")
class RegionHeat(ProgramTest):
    def meshes(self, order, *arguments):
        """Returns meshes of both rings, each of half the size of the one before."""
        (self.folder / "rings.vtp").write_text(rings())
        meshes = []
        for size in SIZES:
            report = json.loads(self.succeed("quads", "rings.vtp", "-o", "rings.msh", "--size", str(size), "--order", str(order),
                                             *arguments, "--json", "-"))
            mesh = Mesh(self.folder / "rings.msh", order)
            self.assertEqual(len(mesh.quads), report["quads"])
            self.assertEqual({region["name"]: region["quads"] for region in report["regions"]},
                             {name: np.sum(mesh.conductivity == value) for name, value in CONDUCTIVITIES.items()})
            meshes.append(mesh)
        return meshes

    def rate(self, meshes):
        """Returns the lower one of both rates at which the error decreases with the length of the edges."""
        errors = [mesh.temperature_error() for mesh in meshes]
        lengths = [1 / math.sqrt(len(mesh.quads)) for mesh in meshes]
        rates = [math.log(errors[i] / errors[i + 1]) / math.log(lengths[i] / lengths[i + 1]) for i in range(len(meshes) - 1)]
        print("order %d: %s quads, L2 errors %s, rates %s" % (
            meshes[0].order, [len(mesh.quads) for mesh in meshes], ["%.2e" % error for error in errors], ["%.2f" % rate for rate in rates]))
        return min(rates)

    def check_order(self, order):
        meshes = self.meshes(order, "--curves", "auto")
        for mesh in meshes:
            for side, radius in zip(("hole0", "core+shell", "outer0"), RADII):
                distances = np.linalg.norm(mesh.points[mesh.sides[side]], axis=1) - radius
                self.assertLess(np.abs(distances).max(), 1e-12, side)
        self.assertGreaterEqual(self.rate(meshes), order + 0.9)

    def test_bilinear_quads_have_order_2(self):
        self.check_order(1)

    def test_biquadratic_quads_have_order_3(self):
        self.check_order(2)

    def test_polygons_do_not_have_order_3(self):
        """Nodes on the polygons instead of the circles limit the error, so the other tests depend on the true circles."""
        self.assertLess(self.rate(self.meshes(2)), 2)


if __name__ == "__main__":
    unittest.main()
