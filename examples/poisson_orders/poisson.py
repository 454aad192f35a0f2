"""Poisson's equation on quads of order 1 to 3, with dolfinx.

    python3 poisson.py [--program CROSSFIELD]

Meshes a disk and a ring given by polygons with 16 points per circle, writes .msh files with nodes on the circles, solves
−Δu = f with u = 0 on the circles and prints the L2 errors and their rates. Needs the Debian packages
python3-dolfinx and python3-gmsh.
"""
import argparse
import json
import logging
import math
import pathlib
import subprocess
import tempfile

import gmsh
import numpy as np
import ufl
from dolfinx import fem
from dolfinx.io import gmshio
from mpi4py import MPI
from petsc4py import PETSc

OUTER, INNER = 1.0, 0.4
COUNTS = {1: (300, 1200, 4800), 2: (300, 1200, 4800), 3: (100, 400, 1600)}


def write_domain(path, radii, points=16):
    """Writes circles as polygons, one after the other, to a .csv file."""
    rows = ["x,y,loop"]
    for loop, radius in enumerate(radii):
        rows += ["%r,%r,%d" % (radius * math.cos(a), radius * math.sin(a), loop)
                 for a in np.linspace(0, 2 * math.pi, points, endpoint=False)]
    path.write_text("\n".join(rows))


def solve(file, order, is_ring):
    """Returns the L2 error of quads of an order in a .msh file."""
    gmsh.open(str(file))  # gmshio.read_from_msh of dolfinx 0.5.2 raises an error for every file
    mesh, _, sides = gmshio.model_to_mesh(gmsh.model, MPI.COMM_SELF, 0, gdim=2)
    gmsh.clear()
    x = ufl.SpatialCoordinate(mesh)
    square = x[0]**2 + x[1]**2
    # 0 on both circles, and not a polynomial that the elements contain
    exact = ufl.sin(math.pi * (square - INNER**2) / (1 - INNER**2)) if is_ring else ufl.sin(math.pi * square)
    exact = exact * (1 + x[0] / 2)
    space = fem.FunctionSpace(mesh, ("Lagrange", order))
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    dx = ufl.Measure("dx", domain=mesh, metadata={"quadrature_degree": 2 * order + 4})
    left = fem.form(ufl.inner(ufl.grad(u), ufl.grad(v)) * dx)
    right = fem.form(-ufl.div(ufl.grad(exact)) * v * dx)
    fixed = fem.dirichletbc(  # sides.indices: the edges of all sides, which are the circles
        PETSc.ScalarType(0), fem.locate_dofs_topological(space, 1, sides.indices), space)
    matrix = fem.petsc.assemble_matrix(left, bcs=[fixed])
    matrix.assemble()
    vector = fem.petsc.assemble_vector(right)
    fem.petsc.apply_lifting(vector, [left], [[fixed]])
    fem.petsc.set_bc(vector, [fixed])
    solver = PETSc.KSP().create(MPI.COMM_SELF)
    solver.setOperators(matrix)
    solver.setType("preonly")
    solver.getPC().setType("lu")
    solution = fem.Function(space)
    solver.solve(vector, solution.vector)
    difference = solution - exact
    return math.sqrt(fem.assemble_scalar(fem.form(difference**2 * dx)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", default="crossfield")
    options = parser.parse_args()
    logging.disable(logging.INFO)  # of the compiler of forms
    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 2)
    print("domain order quads error rate")
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        for name, radii in (("disk", [OUTER]), ("ring", [OUTER, INNER])):
            write_domain(folder / "domain.csv", radii)
            for order, counts in COUNTS.items():
                before = None
                for count in counts:
                    subprocess.run([options.program, "quads", folder / "domain.csv", "-o", folder / "quads.msh", "--quads",
                                    str(count), "--curves", "auto", "--order", str(order), "--json", folder / "report.json"],
                                   check=True, stdout=subprocess.DEVNULL)
                    quads = json.loads((folder / "report.json").read_text())["quads"]
                    error = solve(folder / "quads.msh", order, len(radii) == 2)
                    rate = "" if before is None else "%.2f" % (
                        2 * math.log(before[1] / error) / math.log(quads / before[0]))
                    print(f"{name} {order} {quads} {error:.2e} {rate}", flush=True)
                    before = quads, error


if __name__ == "__main__":
    main()
