"""Choose where the singularities of a cross field on the unit disk are, with VTK alone.

Works as place_singularities.py without ParaView proxies and without a picture: the filters are VTK
classes of the Python package `crossfield`.

Usage:

    PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 place_singularities_vtk.py
        --output field.vtu [--singularities four.csv]

`crossfield --paths` prints the directory for PYTHONPATH. Nothing else is needed: Debian's Python
is /usr/bin/python3 and finds ParaView's VTK (package python3-paraview) or plain VTK (package
python3-vtk9) by itself. Another python3, such as one of pyenv, does not; pvpython does.

Sample run, from the root of the source tree:

    PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 \
        pipelines/pvpython/place_singularities_vtk.py --output field.vtu
"""
import argparse
import sys

import crossfield
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", required=True, help="the .vtu file to write")
    parser.add_argument("--singularities", default="", help="a .csv file; default: the paper's four")
    return parser.parse_args()


def update(*filters):
    """Updates the filters in order. Ends the script at the first failure, because VTK continues
    after an error."""
    for algorithm in filters:
        algorithm.Update()
        if algorithm.GetErrorCode():
            sys.exit("%s failed; the error above says why." % algorithm.GetClassName())


arguments = parse_arguments()

# 1. Create the domain and its singularities. The circle has segments as long as the edges of
#    the mesh: a finer mesh would resolve the corners of a coarse polygon instead of a circle.
edge_length = 0.02
domain = crossfield.vtkPlanarDomainSource()
domain.SetDomainName("disk")
domain.SetEdgeLength(edge_length)
singularities = crossfield.vtkSingularitySource()
singularities.SetFileName(arguments.singularities)

# 2. Make a mesh with a hole at every singularity, and compute the cross field on it.
drill = crossfield.vtkDrillHoles()
drill.SetInputConnection(domain.GetOutputPort())
drill.SetSingularitiesConnection(singularities.GetOutputPort())
drill.SetMeshSize(edge_length)
solver = crossfield.vtkPerforatedCrossField()
solver.SetMethodToConstrained()  # the figure of the paper
solver.SetInputConnection(drill.GetOutputPort())
update(domain, singularities, drill, solver)

# 3. The numbers.
report = solver.GetOutput().GetFieldData()
degrees = report.GetArray("HoleDegree")
print("energy %.4f" % report.GetArray("Energy").GetValue(0))
print("degrees of the holes", *[degrees.GetValue(i) for i in range(degrees.GetNumberOfTuples())])
if not report.GetArray("Converged").GetValue(0):
    sys.exit("The iteration did not converge; make the holes larger or move them.")

# 4. Write the file in inline binary, because Debian's VTK cannot read appended data.
writer = vtkXMLUnstructuredGridWriter()
writer.SetInputConnection(solver.GetOutputPort())
writer.SetFileName(arguments.output)
writer.SetDataModeToBinary()
writer.Write()
if writer.GetErrorCode():
    sys.exit("Cannot write '%s'; the error above says why." % arguments.output)
