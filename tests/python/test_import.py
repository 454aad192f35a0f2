"""The Python package without ParaView: python3 test_import.py

The same chain as in test_plugin.py with the classes of `crossfield` alone; errors are read from
ErrorCode and from the error event.
"""
import os
import tempfile

import crossfield
from vtkmodules.vtkCommonDataModel import VTK_TRIANGLE

from checks import (MESH_CELL_ARRAYS, check, check_arrays, check_default_field, check_equal,
                    fingerprint, value, values)

NO_ERROR = 0


class Chain:
    """Pipeline of domain, singularities, drilled mesh, field and crosses, with the errors that it
    reports."""

    def __init__(self):
        self.errors = []
        self.domain = self.watched(crossfield.vtkPlanarDomainSource())
        self.singularities = self.watched(crossfield.vtkSingularitySource())
        self.drill = self.watched(crossfield.vtkDrillHoles())
        self.drill.SetInputConnection(self.domain.GetOutputPort())
        self.drill.SetSingularitiesConnection(self.singularities.GetOutputPort())
        self.solver = self.watched(crossfield.vtkPerforatedCrossField())
        self.solver.SetInputConnection(self.drill.GetOutputPort())
        self.crosses = self.watched(crossfield.vtkCrossGlyphs())
        self.crosses.SetInputConnection(self.solver.GetOutputPort())

    def watched(self, algorithm):
        algorithm.AddObserver("ErrorEvent", self.remember)
        # After an error of a filter its executive reports that the filter failed.
        algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        return algorithm

    def remember(self, caller, event, text):
        self.errors.append(text)

    remember.CallDataType = "string0"

    def set_rows(self, *rows):
        self.singularities.RemoveAllSingularities()
        for row in rows:
            self.singularities.AddSingularity(*row)

    def field(self):
        self.solver.Update()
        return self.solver.GetOutput()


def test_default_chain():
    chain = Chain()
    field = chain.field()
    check_equal(chain.errors, [], "the list of errors")
    check_default_field(field)
    mesh = chain.drill.GetOutput()
    check_arrays(mesh.GetCellData(), MESH_CELL_ARRAYS, mesh.GetNumberOfCells(), "the drilled mesh")
    triangles = [mesh.GetCellType(cell) for cell in range(mesh.GetNumberOfCells())]
    chain.crosses.Update()
    check_equal(chain.crosses.GetOutput().GetNumberOfLines(), 2 * triangles.count(VTK_TRIANGLE),
                "the number of lines")


def test_bad_input():
    """Returns filters, bad inputs, and a word that each error must contain."""
    cases = (
        ("drill", lambda c: c.singularities.AddSingularity(2, 0, 1, 0.1), "outside"),
        ("drill", lambda c: c.singularities.AddSingularity(0.95, 0, 1, 0.1), "cuts the boundary"),
        ("drill", lambda c: c.singularities.AddSingularity(0.45, 0.4, 1, 0.1), "overlap"),
        ("drill", lambda c: c.singularities.AddSingularity(0, 0, 1, -0.1), "not positive"),
        ("singularities", lambda c: c.singularities.AddSingularity(0, 0, 0.5, 0.1), "not an integer"),
        ("singularities", lambda c: c.singularities.SetFileName("/no/such/file.csv"), "no file"),
        ("domain", lambda c: c.domain.SetDomainName("banana"), "no built-in domain"),
        ("domain", lambda c: c.domain.SetRadius(-1), "positive"),
        ("solver", lambda c: c.set_rows((0, 0, 3, 0.1)), "Poincaré-Hopf"),
    )
    for blamed, spoil, word in cases:
        chain = Chain()
        spoil(chain)
        check_equal(chain.field().GetNumberOfCells(), 0, "%s: the number of cells" % word)
        check(getattr(chain, blamed).GetErrorCode() != NO_ERROR, "%s: no error code" % word)
        check_equal(len(chain.errors), 1, "%s: the number of errors" % word)
        check(word in chain.errors[0], "'%s' does not say '%s'" % (chain.errors[0], word))


def test_file():
    with tempfile.TemporaryDirectory() as directory:
        name = os.path.join(directory, "rows.csv")
        chain = Chain()
        chain.singularities.SetFileName(name)
        for text, radius in (("x,y,quarter_index,radius\n0,0,1,0.1\n0.5,0,3,0.2\n", 0.2),
                             ("quarter_index,y,x\n1,0,0\n3,0,0.5\n", None)):
            with open(name, "w", encoding="utf-8") as file:
                file.write(text)
            chain.singularities.Modified()
            chain.singularities.Update()
            points = chain.singularities.GetOutput()
            quarters = points.GetPointData().GetArray("QuarterIndex")
            check_equal([quarters.GetValue(0), quarters.GetValue(1)], [1, 3], "QuarterIndex")
            check_equal(points.GetPoint(1), (0.5, 0.0, 0.0), "the second point")
            radii = points.GetPointData().GetArray("Radius")
            check_equal(radii and radii.GetValue(1), radius, "the second radius")
        with open(name, "w", encoding="utf-8") as file:
            file.write("x,y,quarter_index\n0,zero,1\n")
        chain.singularities.Modified()
        check_equal(chain.field().GetNumberOfCells(), 0, "no number: the number of cells")
        check("'y'" in chain.errors[0], "'%s' does not name the column" % chain.errors[0])


def test_changed_input():
    chain = Chain()
    first = value(chain.field(), "Energy")
    chain.domain.SetDomainName("quarter-disk")
    chain.set_rows((0.5, 0.4, 1, 0.1))
    check_equal(values(chain.field(), "HoleDegree"), [1], "HoleDegree")
    check(abs(value(chain.field(), "Energy") - first) > 0.1, "the energy has not changed")
    chain.domain.SetDomainName("disk")
    check_equal(chain.field().GetNumberOfCells(), 0, "the number of cells after an error")
    chain.singularities = Chain().singularities
    chain.drill.SetSingularitiesConnection(chain.singularities.GetOutputPort())
    check_equal(value(chain.field(), "Energy"), first, "the energy of the first input again")


def test_topology():
    domain = crossfield.vtkPlanarDomainSource()
    domain.SetDomainName("angular-hole")
    proposal = crossfield.vtkConfigurationProposal()
    proposal.SetInputConnection(domain.GetOutputPort())
    checked = crossfield.vtkPoincareHopfCheck()
    checked.SetInputConnection(domain.GetOutputPort())
    checked.Update()
    check_equal(value(checked.GetOutput(), "Consistent"), 0, "Consistent without singularities")
    check_equal(value(checked.GetOutput(), "RequiredInteriorQuarters"), -2, "the required sum")
    checked.SetSingularitiesConnection(proposal.GetOutputPort())
    checked.Update()
    check_equal(value(checked.GetOutput(), "Consistent"), 1, "Consistent")
    check_equal(checked.GetOutputDataObject(1).GetNumberOfRows(), 2, "the number of loops")
    check_equal(checked.GetOutputDataObject(2).GetNumberOfPoints(), 6, "the number of corners")

    classifier = crossfield.vtkBoundaryCornerClassifier()
    classifier.SetInputConnection(domain.GetOutputPort())
    classifier.Update()
    check_equal(classifier.GetOutputDataObject(1).GetNumberOfRows(), 3, "the number of scenarios")
    first = value(classifier.GetOutput(), "Energy")
    classifier.AddOverride(-1, 0, -1)
    classifier.Update()
    check(value(classifier.GetOutput(), "Energy") > first, "an override costs nothing")


def test_input_untouched():
    chain = Chain()
    chain.crosses.Update()
    for algorithm, inputs in ((chain.drill, [chain.domain, chain.singularities]),
                              (chain.solver, [chain.drill]), (chain.crosses, [chain.solver])):
        before = [fingerprint(source.GetOutput()) for source in inputs]
        time = algorithm.GetOutput().GetMTime()
        algorithm.Modified()
        algorithm.Update()
        check(algorithm.GetOutput().GetMTime() > time, "%s did not run" % algorithm.GetClassName())
        after = [fingerprint(source.GetOutput()) for source in inputs]
        check(after == before, "%s has changed its input" % algorithm.GetClassName())


for test in (test_default_chain, test_bad_input, test_file, test_changed_input, test_topology,
             test_input_untouched):
    test()
    print(test.__name__, "passed")
