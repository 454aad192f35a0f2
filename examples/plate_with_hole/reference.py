"""The reference for plate.py: plane stress with quads of order 3 in dolfinx, on finer and finer meshes.

    python3 reference.py [--program CROSSFIELD]

Prints the stress along the tension where the hole meets the axis, over the tension. Needs the Debian packages
python3-dolfinx and python3-gmsh.
"""
import argparse
import logging
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

from plate import RADIUS, TENSION, write_part

ELASTICITY, POISSON = 1.0, 0.3  # the stress does not depend on the first


def solve(file):
    """Returns the number of quads of order 3 in a .msh file and the stress at the end of the hole."""
    gmsh.open(str(file))
    mesh, _, sides = gmshio.model_to_mesh(gmsh.model, MPI.COMM_SELF, 0, gdim=2)
    names = {gmsh.model.getPhysicalName(1, tag): tag for _, tag in gmsh.model.getPhysicalGroups(1)}
    gmsh.clear()
    space = fem.VectorFunctionSpace(mesh, ("Lagrange", 3))
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)

    def strain(w):
        return ufl.sym(ufl.grad(w))

    def stress(w):
        return ELASTICITY / (1 - POISSON**2) * (
            (1 - POISSON) * strain(w) + POISSON * ufl.tr(strain(w)) * ufl.Identity(2))

    edges = ufl.Measure("ds", domain=mesh, subdomain_data=sides)
    left = fem.form(ufl.inner(stress(u), strain(v)) * ufl.dx)
    right = fem.form(TENSION * v[1] * edges(names["top"]))
    fixed = []
    for name, axis in (("bottom", 1), ("left", 0)):
        facets = sides.indices[sides.values == names[name]]
        component = space.sub(axis)
        fixed.append(fem.dirichletbc(
            PETSc.ScalarType(0), fem.locate_dofs_topological(component, 1, facets), component))
    matrix = fem.petsc.assemble_matrix(left, bcs=fixed)
    matrix.assemble()
    vector = fem.petsc.assemble_vector(right)
    fem.petsc.set_bc(vector, fixed)
    solver = PETSc.KSP().create(MPI.COMM_SELF)
    solver.setOperators(matrix)
    solver.setType("preonly")
    solver.getPC().setType("lu")
    solution = fem.Function(space)
    solver.solve(vector, solution.vector)
    # Discontinuous, so that its values are those of the solution's derivatives in the quads.
    values = fem.Function(fem.FunctionSpace(mesh, ("DQ", 3)))
    values.interpolate(fem.Expression(stress(solution)[1, 1], values.function_space.element.interpolation_points()))
    places = values.function_space.tabulate_dof_coordinates()
    nearest = np.argmin(np.hypot(places[:, 0] - RADIUS, places[:, 1]))
    return mesh.topology.index_map(2).size_local, values.x.array[nearest] / TENSION


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", default="crossfield")
    options = parser.parse_args()
    logging.disable(logging.INFO)  # of the compiler of forms
    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 2)
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        write_part(folder / "part.vtp", 64)
        for quads in (250, 1000, 4000, 16000):
            subprocess.run([options.program, "quads", folder / "part.vtp", "-o", folder / "plate.msh", "--quads",
                            str(quads), "--curve", "hole:circle", "--order", "3"], check=True, stdout=subprocess.DEVNULL)
            count, factor = solve(folder / "plate.msh")
            print(f"{count} quads of order 3: Kt {factor:.5f}", flush=True)


if __name__ == "__main__":
    main()
