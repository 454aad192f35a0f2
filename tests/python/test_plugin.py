"""The plugin in ParaView: pvpython test_plugin.py PLUGIN

Every proxy exists and is documented, the default chain gives the field it should, bad input gives
an empty output, a changed input gives another result, and no filter changes its input.
"""
import glob
import math
import os
import re
import sys
import tempfile
import xml.dom.minidom

import numpy as np
from paraview import servermanager
from paraview.simple import *
from vtkmodules.vtkCommonDataModel import VTK_TRIANGLE

from checks import check, check_default_field, check_equal, fingerprint, value, values

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "verify"))
import kept  # noqa: E402

PLUGIN = os.path.join(os.path.dirname(__file__), "..", "..", "paraview-plugin")
ICONS = os.path.join(PLUGIN, "icons")

PROXIES = {
    "BoundaryCornerClassifier": (
        "filters", "Input CornerAngle PrintedCoefficient SplitHalves Overrides PointOverrides"),
    "BoundarySimplifier": ("filters", "Input FixedPoints MeshSize ThinningLength SmoothingLength CornerAngle"),
    "PoincareHopfCheck": ("filters", "Input Singularities Corners CornerAngle Holonomy"),
    "ConfigurationProposal": (
        "filters", "Input Singularities Corners CornerAngle CancelFlatCorners CapCorners Alternatives "
        "CoreRadius"),
    "PlanarDomainSource": ("sources", "DomainName Radius InnerRadius Width Height EdgeLength"),
    "PlanarDomainReader": ("sources", "FileName"),
    "SingularitySource": ("sources", "Domain Singularities FileName UseHandles Handles Plane"),
    "SingularityHandles": ("filters", "Input Domain Singularities OutputRows Plane"),
    "DrillHoles": ("filters", "Input Singularities Mode MeshSize MinimumHoleEdges Gradation"),
    "PerforatedCrossField": (
        "filters", "Input Corners Method UnitHoles UnitHoleRows GlobalConstraint Epsilon "
        "MaximumIterations Tolerance"),
    "HField": ("filters", "Input Singularities Corners MeshSize KeepMesh"),
    "LayoutDesigner": ("filters", "Input StartFrom Corners Singularities Rows Plane Propose Optimise Snap AddPair Undo Quads Dragging "
                       "QuadSize QuadCount MeshSize CapCorners"),
    "CrossFieldMap": ("filters", "Input Singularities Corners MeshSize CapCorners RepairHolonomy"),
    "QuadMesher": ("filters", "Input Singularities Corners QuadSize QuadCount MeshSize CapCorners "
                   "RepairHolonomy"),
    "Separatrices": ("filters", "Input Seeds LongestStreamline"),
    "SingularityEnergy": ("filters", "Input Configurations Corners MeshSize CoreRadius KeepMesh"),
    "SingularityOptimizer": (
        "filters", "Input Singularities Corners MeshSize MaximumIterations Tolerance UniformSizes Sizing SizeArray Pairs"),
    "CrossGlyphs": ("filters", "Input Spacing Scale ScaleByNorm"),
}


def properties_of(prototype):
    iterator = prototype.NewPropertyIterator()
    iterator.Begin()
    while not iterator.IsAtEnd():
        yield iterator.GetKey(), iterator.GetProperty()
        iterator.Next()


def check_tooltip(item, name):
    """The tooltip of a parameter states what the parameter does and its default."""
    documentation = item.GetDocumentation()
    text = documentation.GetDescription() if documentation is not None else ""
    check(text, "%s has no documentation" % name)
    is_parameter = item.IsA("vtkSMVectorProperty") and not item.GetInformationOnly()
    hidden = item.GetPanelVisibility() == "never"
    if is_parameter and not item.IsA("vtkSMInputProperty") and not hidden:
        check("Default: " in " ".join(text.split()), "%s states no default" % name)


def test_proxies():
    for name, (group, wanted) in PROXIES.items():
        prototype = servermanager.ProxyManager().GetPrototypeProxy(group, name)
        check(prototype is not None, "there is no proxy %s" % name)
        documentation = prototype.GetDocumentation()
        check(documentation.GetShortHelp() and documentation.GetLongHelp(), "%s has no help" % name)
        for part in ("Example", "glossary"):
            check(part in documentation.GetDescription(), "the help of %s has no %s" % (name, part))
        # Python names come from labels, so a label must be the name with spaces.
        check_equal(prototype.GetXMLLabel(), re.sub("(?<!^)(?=[A-Z])", " ", name), "the label")
        if name != "PlanarDomainReader":  # which File, Open creates
            menu = prototype.GetHints().FindNestedElementByName("ShowInMenu")
            # A category here would come before menus.xml, and in another order.
            check_equal(menu.GetAttribute("category"), None, "the menu of %s" % name)
            icon = re.fullmatch(":/CrossField/(.*)", menu.GetAttribute("icon")).group(1)
            xml.dom.minidom.parse(os.path.join(ICONS, icon))  # raises if it is not valid XML
        found = dict(properties_of(prototype))
        check(set(wanted.split()) <= set(found), "%s lacks a property" % name)
        for key, item in found.items():
            check_tooltip(item, "%s.%s" % (name, key))
            check_equal(item.GetXMLLabel().replace(" ", ""), key, "the label")


def test_menus():
    """The menus, which are in the order of work, list every proxy of the plugin and no abstract one."""
    menus = xml.dom.minidom.parse(os.path.join(PLUGIN, "menus", "menus.xml"))
    listed = [(item.getAttribute("group"), item.getAttribute("name"))
              for item in menus.getElementsByTagName("Proxy")]
    shown = []
    for file_name in glob.glob(os.path.join(PLUGIN, "CrossField*.xml")):
        for menu in xml.dom.minidom.parse(file_name).getElementsByTagName("ShowInMenu"):
            proxy = menu.parentNode.parentNode
            shown.append((proxy.parentNode.getAttribute("name"), proxy.getAttribute("name")))
    check_equal(sorted(listed), sorted(shown), "the proxies in the menus")


def field_of(singularities, **domain):
    return PerforatedCrossField(
        Input=DrillHoles(Input=PlanarDomainSource(**domain), Singularities=singularities))


def fetch(proxy):
    proxy.UpdatePipeline()
    data = servermanager.Fetch(proxy)
    if proxy.GetXMLName() in ("DrillHoles", "PerforatedCrossField", "HField"):
        kept.keep_data(data)
    return data


def test_h_field():
    field = HField(Input=PlanarDomainSource(), Singularities=SingularitySource())
    data = fetch(field)
    check(data.GetPointData().GetArray("SizeMap") is not None, "there is no size map")
    # docs/method.md §9: W of four +1 at radius 0.6 is 2.05; this polygon of 0.07 is 0.5 off.
    check(abs(value(data, "RenormalizedEnergy") - 2.05) < 0.5, "the renormalised energy")
    check_equal(value(data, "UnwantedSingularities"), 0, "unwanted singularities")
    drilled = fetch(HField(Input=DrillHoles(
        Input=PlanarDomainSource(), Singularities=SingularitySource())))
    check(drilled.GetPointData().GetArray("H") is not None, "there is no H on a drilled mesh")


def test_layout_designer():
    designer = LayoutDesigner(Input=PlanarDomainSource())
    lines = fetch(designer)
    check_equal(value(lines, "Stale"), 0, "whether the layout is stale")
    check_equal(value(lines, "Faces"), 9, "faces of the chosen singularities")
    designer.UpdatePropertyInformation()
    rows = list(designer.GetPropertyValue("Rows"))
    check_equal(len(rows), 16, "values of the chosen rows")
    # A user takes the rows over and moves one.
    rows[0:2] = [0.3, 0.5]
    designer.Singularities = rows
    moved = fetch(designer)
    check(value(moved, "RenormalizedEnergy") > value(lines, "RenormalizedEnergy"), "a move from the minimum raises W")
    designer.InvokeCommand("Optimise")
    designer.UpdatePipeline()
    designer.UpdatePropertyInformation()
    best = fetch(designer)
    check(abs(value(best, "RenormalizedEnergy") - value(lines, "RenormalizedEnergy")) < 0.05, "the optimiser restores the minimum of W")
    rows = list(designer.GetPropertyValue("Rows"))
    rows[0] = 7.0
    designer.Singularities = rows
    stale = fetch(designer)
    check_equal(value(stale, "Stale"), 1, "whether a layout with a singularity outside is stale")
    check_equal(stale.GetNumberOfCells(), best.GetNumberOfCells(), "the separatrices of the last layout")
    check("outside" in stale.GetFieldData().GetAbstractArray("Summary").GetValue(0), "the sentence")
    check("outside" in servermanager.Fetch(designer, idx=4).GetValueByName(0, "Summary").ToString(), "the text")


def test_layout_designer_in_a_tilted_plane():
    tilted = Transform(Input=PlanarDomainSource())
    tilted.Transform.Rotate, tilted.Transform.Translate = [60, 0, 0], [0, 0, 2]
    designer = LayoutDesigner(Input=tilted)

    def places():
        designer.UpdatePipeline()
        designer.UpdatePropertyInformation()
        points = servermanager.Fetch(designer, idx=2)
        return np.array([points.GetPoint(i) for i in range(points.GetNumberOfPoints())])

    before = places()
    origin, *axes = np.reshape(designer.GetProperty("Plane"), (3, 3))
    rows = np.reshape(designer.GetProperty("Rows"), (-1, 4))
    check(abs(origin + rows[:, :2] @ axes - before).max() < 1e-6, "the rows are not coordinates in the plane")
    # z = 2 + y tan 60° is the plane, turned about x.
    check(abs(before[:, 2] - 2 - np.sqrt(3) * before[:, 1]).max() < 1e-5, "singularities are off the plane")
    check_equal([round(number, 6) for number in axes[0]], [1, 0, 0], "the first axis")
    rows[0, :2] += [0.05, 0.1]
    designer.Singularities = list(rows.ravel())
    check(abs(places()[0] - before[0] - np.dot([0.05, 0.1], axes)).max() < 1e-6, "a row does not move in the plane")
    check_equal(value(fetch(designer), "Stale"), 0, "whether the layout is stale")
    # Without the domain a source is in z = 0.
    source = SingularitySource(Singularities=list(rows.ravel()))
    source.UpdatePipeline()
    check_equal(source.GetDataInformation().GetBounds()[4:], (0, 0), "z without a domain")
    source.Domain = tilted
    source.UpdatePipeline()
    check(abs(source.GetDataInformation().GetBounds()[5] - places()[:, 2].max()) < 1e-5, "z with the domain")


def test_separatrices():
    flat = CrossFieldMap(Input=PlanarDomainSource(), Singularities=SingularitySource())
    lines = Separatrices(Input=flat)
    data = fetch(lines)
    check_equal(data.GetNumberOfCells(), 12, "the number of lines")
    faces = servermanager.Fetch(lines, idx=1)
    # docs/method.md §13.3: T - N + 1 patches, less those of separatrices that meet head-on.
    check_equal(faces.GetCellData().GetArray("FaceId").GetRange()[1] + 1,
                9 - value(data, "HeadOn"), "the number of faces")
    check(value(data, "Mismatch") < 1e-12, "opposite sides of faces")
    lines.Seeds = SingularitySource(Singularities=[0.1, 0.2, 1, 0.1])
    check_equal(fetch(lines).GetNumberOfCells(), 16, "the number of lines with streamlines")


def test_energies():
    better = SingularityOptimizer(Input=PlanarDomainSource(), Singularities=SingularitySource())
    moved = fetch(better)
    check_equal(value(moved, "Converged"), 1, "Converged")
    check(abs(value(moved, "RenormalizedEnergyAfter") + 7.2962) < 0.1, "the minimum energy")
    for i in range(4):
        x, y, _ = moved.GetPoint(i)
        check(abs(math.hypot(x, y) - 0.850092) < 2e-3, "the radius")
    history = servermanager.Fetch(better, idx=1)
    check_equal(history.GetNumberOfRows(), value(moved, "Iterations") + 1, "the rows of history")
    energies = SingularityEnergy(
        Input=PlanarDomainSource(), Configurations=[SingularitySource(), better])
    table = fetch(energies)
    check_equal(table.GetNumberOfRows(), 2, "the number of configurations")
    check_equal([table.GetValueByName(row, "Configuration").ToInt() for row in (0, 1)], [1, 0],
                "the order of the configurations")
    energies.Configurations = [better]
    check_equal(fetch(energies).GetNumberOfRows(), 1, "the number of configurations that are left")


def test_size_arrays():
    """A domain without arrays is accepted; the point arrays of a domain are offered as size arrays."""
    bare = PlanarDomainSource()
    sized = Calculator(Input=bare, ResultArrayName="Length", Function="1 + coordsX * coordsX")
    sized.UpdatePipeline()  # makes its arrays known
    for make in (QuadMesher, SingularityOptimizer):
        for domain, arrays in ((bare, {"None"}), (sized, {"None", "Length"})):
            proxy = make(Input=domain, Singularities=SingularitySource(), Sizing="Field").SMProxy
            given = proxy.GetProperty("Input")
            check(given.FindDomain("vtkSMInputArrayDomain").IsInDomain(given), "%s refuses it" % proxy.GetXMLName())
            choice = proxy.GetProperty("SizeArray").FindDomain("vtkSMArrayListDomain")
            choice.Update(given)
            check_equal({choice.GetString(i) for i in range(choice.GetNumberOfStrings())}, arrays, "the arrays")
    optimizer = SingularityOptimizer(Input=sized, Singularities=SingularitySource(), UniformSizes=1,
                                     Sizing="Field", SizeArray="Length")
    moved = fetch(optimizer)
    check_equal(value(moved, "Converged"), 1, "Converged")
    check(value(moved, "SizeSpreadAfter") < 0.95 * value(moved, "SizeSpreadBefore"), "the spread of sizes does not shrink")


def test_quad_mesher_outputs():
    """The singularities and corners that Quad Mesher used are outputs; another one makes the same mesh of them."""
    star = PlanarDomainSource(DomainName="star")
    chosen = QuadMesher(Input=star, QuadCount=300)
    quads = fetch(chosen)
    used = [servermanager.Fetch(chosen, idx=port) for port in (3, 4)]
    check_equal(used[1].GetNumberOfPoints(), 10, "the number of corners")
    quarters = [data.GetPointData().GetArray("QuarterIndex") for data in used]
    check_equal(sum(array.GetValue(i) for array in quarters for i in range(array.GetNumberOfTuples())), 4,
                "the sum of the quarter indices")
    given = fetch(QuadMesher(Input=star, QuadCount=300, CapCorners=0,
                             Singularities=servermanager.OutputPort(chosen, 3),
                             Corners=servermanager.OutputPort(chosen, 4)))
    check_equal(given.GetNumberOfPoints(), quads.GetNumberOfPoints(), "the number of points")
    for i in range(quads.GetNumberOfPoints()):
        check(math.dist(given.GetPoint(i), quads.GetPoint(i)) < 1e-9, "point %d is elsewhere" % i)


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
    """Dragging a handle moves its singularity; dragging back from a bad position restores the field."""
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


LoadPlugin(sys.argv[1], ns=globals())
for test in (test_proxies, test_menus, test_default_chain, test_h_field, test_layout_designer, test_layout_designer_in_a_tilted_plane, test_separatrices,
             test_energies, test_size_arrays, test_quad_mesher_outputs, test_domain_files, test_other_domains, test_unit_norm, test_bad_input, test_topology,
             test_handles, test_handles_of_a_proposal, test_summary_of_the_check,
             test_changed_input, test_input_untouched):
    test()
    print(test.__name__, "passed")
