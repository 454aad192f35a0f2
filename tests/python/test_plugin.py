"""The cross field in ParaView: pvpython test_plugin.py PLUGIN

The default chain gives the field it should, bad input gives an empty output, a changed input gives
another result, and no filter changes its input.
"""
import math
import os
import tempfile

from paraview import servermanager
from vtkmodules.vtkCommonDataModel import VTK_TRIANGLE

from checks import check, check_default_field, check_equal, fingerprint, value, values
from loaded_plugin import *


def test_default_chain():
    field = field_of(SingularitySource())
    data = fetch(field)
    check_default_field(data)
    crosses = fetch(CrossGlyphs(Input=field, Spacing=0))
    triangles = [data.GetCellType(cell) for cell in range(data.GetNumberOfCells())].count(VTK_TRIANGLE)
    check_equal(crosses.GetNumberOfLines(), 2 * triangles, "the number of lines")
    # By default 40 crosses of two lines across: pi / 4 of their square, less those at the holes.
    first = fetch(CrossGlyphs(Input=field)).GetNumberOfLines()
    check(0.8 * 2 * math.pi / 4 * 40**2 < first < 2.2 * math.pi / 4 * 40**2, "%d lines at first" % first)
    thinned = fetch(CrossGlyphs(Input=field, Spacing=0.1, ScaleByNorm=1))
    check(0 < thinned.GetNumberOfLines() <= 2 * 20 * 20, "the spacing does not thin out")


def write(name, text):
    with open(name, "w", encoding="utf-8") as file:
        file.write(text)
    return name


def readers_of(name):
    """Returns the readers that File, Open offers for a file."""
    factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
    found = factory.GetReaders(name, servermanager.ActiveConnection.Session)
    return [found.GetString(i + 1) for i in range(0, found.GetLength(), 3)]


def test_domain_files():
    with tempfile.TemporaryDirectory(prefix="crossfield-") as folder:
        square = "0%s0\n2%s0\n2%s1\n0%s1\n"
        table = write(os.path.join(folder, "square.csv"), "x,y\n" + square % (4 * (",",)))
        profile = write(os.path.join(folder, "square.dat"), "a name\n" + square % (4 * (" ",)))
        other = write(os.path.join(folder, "other.csv"), "time,value\n0,1\n")
        for name in (table, profile):
            check("PlanarDomainReader" in readers_of(name), "%s is opened as a domain" % name)
            check(len(readers_of(name)) > 1, "one is asked which reader opens %s" % name)
            data = fetch(PlanarDomainReader(FileName=name))
            check_equal((data.GetNumberOfCells(), data.GetNumberOfPoints()), (1, 4), "cells and points")
        check("PlanarDomainReader" not in readers_of(other), "a table without x and y is no domain")
        # A table written by ParaView itself.
        exported = os.path.join(folder, "exported.csv")
        SaveData(exported, proxy=PlanarDomainReader(FileName=table))
        data = fetch(PlanarDomainReader(FileName=exported))
        check_equal(data.GetBounds(), (0, 2, 0, 1, 0, 0), "the bounds of what ParaView exports")
        singularities = SingularitySource()
        exported = os.path.join(folder, "singularities.csv")
        SaveData(exported, proxy=singularities, Precision=17)
        check(fingerprint(fetch(SingularitySource(FileName=exported))) == fingerprint(fetch(singularities)),
              "the singularities that ParaView exports are read as they were")
        refused = PlanarDomainReader(FileName=write(table, "x,y\n0,zero\n"))
        check_equal(fetch(refused).GetNumberOfCells(), 0, "the number of cells of a bad table")


def test_other_domains():
    """Domains that need other quarter indices, or none."""
    for rows, domain in (([], dict(DomainName="ring")),
                         ([], dict(DomainName="square")),
                         ([], dict(DomainName="rectangle", Width=3, Height=0.5)),
                         ([0.5, 0.4, 1, 0.1], dict(DomainName="quarter-disk")),
                         ([-0.7, 0, 1, 0.1, 0.7, 0, 1, 0.1, 0, -0.3, 1, 0.1, 0, 0.3, 1, 0.1],
                          dict(DomainName="ellipse"))):
        field = fetch(field_of(SingularitySource(Singularities=rows), **domain))
        check_equal(value(field, "Consistent"), 1, "Consistent of %s" % domain)
        check_equal(values(field, "HoleDegree"), rows[2::4], "HoleDegree of %s" % domain)


def test_unit_norm():
    """One hole of quarter index 4 in the middle of the disk: the energy is 16 π log(1 / radius)."""
    field = field_of(SingularitySource(Singularities=[0, 0, 4, 0.1]))
    field.Method = "Unit Norm"
    data = fetch(field)
    check_equal(value(data, "Converged"), 1, "Converged")
    check_equal(values(data, "HoleDegree"), [4], "HoleDegree")
    check_equal(value(data, "UnwantedSingularities"), 0, "UnwantedSingularities")
    exact = 16 * math.pi * math.log(10)
    check(abs(value(data, "Energy") - exact) < 0.02 * exact, "the energy is not %g" % exact)


def test_bad_input():
    four = [0.4, 0.4, 1, 0.1, -0.4, 0.4, 1, 0.1, -0.4, -0.4, 1, 0.1]
    bad = {
        "a hole outside the domain": dict(Singularities=four + [2, 0, 1, 0.1]),
        "a hole that cuts the boundary": dict(Singularities=four + [0.95, 0, 1, 0.1]),
        "overlapping holes": dict(Singularities=four + [0.45, 0.4, 1, 0.1]),
        "a negative radius": dict(Singularities=four + [0.4, -0.4, 1, -0.1]),
        "a quarter index that is not an integer": dict(Singularities=four + [0.4, -0.4, 0.5, 0.1]),
        "a file that is missing": dict(FileName="/no/such/file.csv"),
        "quarter indices of the wrong sum": dict(Singularities=four),
    }
    for what, rows in bad.items():
        field = field_of(SingularitySource(**rows))
        check_equal(fetch(field).GetNumberOfCells(), 0, "%s: the number of cells" % what)
        check(fetch(field).GetFieldData().GetArray("Energy") is None, "%s: there is an energy" % what)

    # On a ring a field without singularities exists, so a missing file must not count as none.
    field = field_of(SingularitySource(FileName="/no/such/file.csv"), DomainName="ring")
    field.UpdatePipeline()
    check_equal(fetch(field).GetNumberOfCells(), 0, "a ring, no file: the number of cells")
    field = field_of(SingularitySource(), DomainName="ring", InnerRadius=2)
    check_equal(fetch(field).GetNumberOfCells(), 0, "a ring inside out: the number of cells")


def test_changed_input():
    singularities = SingularitySource()
    field = field_of(singularities)
    first = value(fetch(field), "Energy")
    rows = list(singularities.Singularities)
    singularities.Singularities = [0.5, 0, 1, 0.1, 0, 0.5, 1, 0.1, -0.5, 0, 1, 0.1, 0, -0.5, 1, 0.15]
    check_equal(values(fetch(field), "HoleDegree"), [1, 1, 1, 1], "HoleDegree")
    check(abs(value(fetch(field), "Energy") - first) > 0.1, "the energy has not changed")
    singularities.Singularities = [0, 0, 0.5, 0.2]
    check_equal(fetch(field).GetNumberOfCells(), 0, "the number of cells after an error")
    singularities.Singularities = rows
    check_equal(value(fetch(field), "Energy"), first, "the energy of the first input again")


def test_topology():
    domain = PlanarDomainSource(DomainName="angular-hole")
    proposal = ConfigurationProposal(Input=domain, CancelFlatCorners=1)
    poincare_check = PoincareHopfCheck(Input=domain, Singularities=proposal)
    data = fetch(poincare_check)
    check_equal(value(data, "RequiredInteriorQuarters"), -2, "RequiredInteriorQuarters")
    check_equal(value(data, "GivenInteriorQuarters"), -2, "GivenInteriorQuarters")
    check_equal(value(data, "Consistent"), 1, "Consistent")
    check_equal(len(values(data, "HolonomyDefect")), 1, "the number of holonomy defects")
    corners = servermanager.Fetch(poincare_check, idx=2)
    check_equal(corners.GetNumberOfPoints(), 6, "the number of corners")
    poincare_check = PoincareHopfCheck(Input=domain)
    check_equal(value(fetch(poincare_check), "Consistent"), 0, "Consistent without singularities")
    sentence = fetch(poincare_check).GetFieldData().GetAbstractArray("Reason").GetValue(0)
    check("total -2" in sentence, "'%s' does not say what to add" % sentence)

    domain = PlanarDomainSource(DomainName="angular-negative")
    classifier = BoundaryCornerClassifier(Input=domain)
    check_equal(fetch(classifier).GetNumberOfPoints(), 6, "the number of corners")
    pair = SingularitySource(Singularities=[-0.5, 0, 1, 0.05, 0.5, 0, -1, 0.05])
    drilled = DrillHoles(Input=domain, Singularities=pair)
    refused = PerforatedCrossField(Input=drilled)
    check_equal(fetch(refused).GetNumberOfCells(), 0, "the number of cells without corners")
    solved = PerforatedCrossField(Input=drilled, Corners=classifier, Method=1)
    check_equal(value(fetch(solved), "UnwantedSingularities"), 0, "UnwantedSingularities")
    first = value(fetch(classifier), "Energy")
    classifier.Overrides = [-1, 0, 0]
    check(value(fetch(classifier), "Energy") > first, "an override does not raise the energy")
    classifier.Overrides = []
    check_equal(value(fetch(classifier), "Energy"), first, "the energy without overrides")


def test_handles():
    """Dragging a handle moves its singularity; dragging back from a bad position restores the
    field."""
    singularities = SingularitySource()
    field = field_of(singularities)
    first = value(fetch(field), "Energy")
    singularities.UseHandles = 1
    check_equal(value(fetch(field), "Energy"), first, "the energy with the handles as they are")
    handles = list(singularities.Handles)
    singularities.Handles = [0.5, 0.0, 0.0] + handles[3:]
    check(abs(value(fetch(field), "Energy") - first) > 0.1, "the handle moves nothing")
    singularities.Handles = [5.0, 0.0, 0.0] + handles[3:]
    check_equal(fetch(field).GetNumberOfCells(), 0, "a handle outside: the number of cells")
    singularities.Handles = handles
    check_equal(value(fetch(field), "Energy"), first, "the energy after dragging back")


def test_handles_of_a_proposal():
    proposal = ConfigurationProposal(Input=PlanarDomainSource())
    handles = SingularityHandles(Input=proposal)
    for _ in range(2):
        wanted = fetch(proposal)
        found = fetch(handles)
        check_equal([found.GetPoint(i) for i in range(found.GetNumberOfPoints())],
                    [wanted.GetPoint(i) for i in range(wanted.GetNumberOfPoints())], "the singularities to start from")
        handles.UpdatePropertyInformation()
        rows = list(handles.GetPropertyValue("OutputRows"))
        check_equal(len(rows), 16, "values of the rows")
        handles.Singularities = [0.125, 0.25] + rows[2:]
        check_equal(fetch(handles).GetPoint(0), (0.125, 0.25, 0), "the handle that was dragged")
        handles.Singularities = []  # the input is used again


def test_summary_of_the_check():
    singularities = SingularitySource()
    poincare_check = PoincareHopfCheck(Input=PlanarDomainSource(), Singularities=singularities)
    for rows, beginning in ((list(singularities.Singularities), "Consistent\n"),
                            ([0, 0, 1, 0.1], "Inconsistent\n")):
        singularities.Singularities = rows
        poincare_check.UpdatePipeline()
        text = servermanager.Fetch(poincare_check, idx=3).GetValueByName(0, "Summary").ToString()
        check(text.startswith(beginning), "the summary is '%s'" % text)


def server_data(proxy):
    """Returns the data object of the server itself; a fetched one may be a copy."""
    return proxy.GetClientSideObject().GetOutputDataObject(0)


def test_input_untouched():
    domain, singularities = PlanarDomainSource(), SingularitySource()
    drilled = DrillHoles(Input=domain, Singularities=singularities)
    field = PerforatedCrossField(Input=drilled)
    crosses = CrossGlyphs(Input=field)
    crosses.UpdatePipeline()
    for proxy, name, other, inputs in ((drilled, "MeshSize", 0.08, [domain, singularities]),
                                       (field, "Tolerance", 1e-9, [drilled]),
                                       (crosses, "Scale", 0.5, [field])):
        crosses.UpdatePipeline()
        before = [fingerprint(server_data(source)) for source in inputs]
        time = server_data(proxy).GetMTime()
        setattr(proxy, name, other)
        proxy.UpdatePipeline()
        check(server_data(proxy).GetMTime() > time, "%s did not run" % proxy.GetXMLName())
        after = [fingerprint(server_data(source)) for source in inputs]
        check(after == before, "%s has changed its input" % proxy.GetXMLName())


run_tests(test_default_chain, test_domain_files, test_other_domains, test_unit_norm, test_bad_input, test_topology,
          test_handles, test_handles_of_a_proposal, test_summary_of_the_check, test_changed_input,
          test_input_untouched)
