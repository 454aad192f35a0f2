"""The size field, layouts and quads in ParaView: pvpython test_plugin_quads.py PLUGIN"""
import math
import os
import tempfile

import numpy as np
from paraview import servermanager

from checks import check, check_equal, value
from loaded_plugin import *


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


def test_save_data_for_solvers():
    mesher = QuadMesher(Input=PlanarDomainSource(), QuadCount=100, Curves="auto")
    with tempfile.TemporaryDirectory() as folder:
        for order, name, begin in ((1, "a.su2", "NDIME= 2\n"), (2, "a.inp", "** "), (3, "a.msh", "$MeshFormat\n4.1 ")):
            joined = QuadsToHigherOrder(Input=mesher, Boundary=OutputPort(mesher, 5), Order=order)
            SaveData(os.path.join(folder, name), proxy=joined)
            with open(os.path.join(folder, name), encoding="utf-8") as file:
                text = file.read()
            check(text.startswith(begin), "the format of %s" % name)
            check("outer0" in text, "the side in %s" % name)
        # One step, without Quads To Higher Order, and behind filters that only add arrays.
        calculator = Calculator(Input=mesher, ResultArrayName="x", Function="coordsX")
        for proxy, name in ((mesher, "b.msh"), (mesher, "b.inp"), (mesher, "b.su2"), (mesher, "b.exo"), (mesher, "b/b.foam"),
                            (calculator, "c.su2"), (QuadsToHigherOrder(Input=mesher), "d.msh"),
                            (ExtrudeQuads(Input=calculator), "e.su2")):
            if name == "b.exo" and GetParaViewVersion() >= (5, 12):
                continue  # has a writer of its own for this ending
            os.makedirs(os.path.dirname(os.path.join(folder, name)), exist_ok=True)
            SaveData(os.path.join(folder, name), proxy=proxy)
            with open(os.path.join(folder, name.replace("b.foam", "constant/polyMesh/boundary")), "rb") as file:
                check(b"outer0" in file.read(), "the side in %s" % name)
        SaveData(os.path.join(folder, "b.msh"), proxy=joined, MshVersion="2.2")
        with open(os.path.join(folder, "b.msh"), encoding="utf-8") as file:
            check(file.read().startswith("$MeshFormat\n2.2 "), "the version")


def test_save_data_behind_a_transform():
    """Quads whose points have changed are refused, and the remedy of the message works."""
    mesher = QuadMesher(Input=PlanarDomainSource(), QuadCount=100)
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "a.su2")
        try:
            SaveData(file, proxy=Transform(Input=mesher))
        except RuntimeError:
            pass
        check(not os.path.exists(file), "a file without sides")
        SaveData(file, proxy=Transform(Input=QuadsToHigherOrder(Input=mesher, Order=1)))
        with open(file, encoding="utf-8") as text:
            check("outer0" in text.read(), "the side after the remedy")


def test_periodic_sides():
    rectangle = PlanarDomainSource(DomainName="rectangle")
    mesher = QuadMesher(Input=rectangle, QuadCount=100, Periodic="outer3:outer1")
    joined = QuadsToHigherOrder(Input=mesher, Boundary=OutputPort(mesher, 5), Order=2)
    data = fetch(joined).GetFieldData()
    names = data.GetAbstractArray("PeriodicSides")
    check_equal([names.GetValue(i) for i in range(2)], ["outer3", "outer1"], "names of the pair")
    check_equal(data.GetArray("PeriodicMotion").GetNumberOfComponents(), 16, "numbers of the motion")
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "a.msh")
        SaveData(file, proxy=joined)
        with open(file, encoding="utf-8") as text:
            check("$Periodic\n1\n" in text.read(), "periodic sides in the file")


def test_extruded_quads():
    mesher = QuadMesher(Input=PlanarDomainSource(), QuadCount=100)
    solid = ExtrudeQuads(Input=mesher, Height=0.5, Layers=3)
    quads = fetch(mesher).GetNumberOfCells()
    check_equal(value(fetch(solid), "Hexahedra"), 3 * quads, "hexahedra")
    check_equal(servermanager.Fetch(solid, idx=1).GetNumberOfBlocks(),
                servermanager.Fetch(mesher, idx=1).GetNumberOfBlocks(), "blocks")
    with tempfile.TemporaryDirectory() as folder:
        SaveData(os.path.join(folder, "a.msh"), proxy=solid)
        with open(os.path.join(folder, "a.msh"), encoding="utf-8") as file:
            text = file.read()
        check('"back"' in text and '"front"' in text, "the sides at the ends")
        check(' "domain"' in text, "the region")


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
    """A domain without arrays is accepted; the point arrays of a domain are offered as size
    arrays."""
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
    unset = QuadMesher(Input=sized, Sizing="Field", SizeArray="None")
    unset.UpdatePipeline()
    text = servermanager.Fetch(unset, idx=8).GetValueByName(0, "Summary").ToString()
    check("No size array is chosen" in text, "the text without a size array: " + text)
    optimizer = SingularityOptimizer(Input=sized, Singularities=SingularitySource(), UniformSizes=1,
                                     Sizing="Field", SizeArray="Length")
    moved = fetch(optimizer)
    check_equal(value(moved, "Converged"), 1, "Converged")
    check(value(moved, "SizeSpreadAfter") < 0.95 * value(moved, "SizeSpreadBefore"), "the spread of sizes does not shrink")


def test_quad_mesher_for_a_first_user():
    """Quads alone are the first output, its colours are those of quads, and a text reports it."""
    mesher = QuadMesher(Input=PlanarDomainSource(), QuadCount=300)
    quads = fetch(mesher)
    report = servermanager.Fetch(mesher, idx=8)
    check_equal(quads.GetNumberOfCells(), value(report, "Quads"), "the number of cells")
    shown = Show(mesher, CreateView("RenderView")).SMProxy.GetProperty("ColorArrayName")
    choice = shown.FindDomain("vtkSMArrayListDomain")
    check_equal([choice.GetString(i) for i in range(choice.GetNumberOfStrings())],
                ["BoundarySide", "Irregular", "Valence", "BlockId", "I", "J", "Part", "ScaledJacobian", "SizeRatio"], "the colours")
    text = report.GetValueByName(0, "Summary").ToString().replace("\n", " ")
    check("%d quads in 5 blocks" % quads.GetNumberOfCells() in text and "4 of valence 3" in text, "the text: " + text)
    boundary, nodes = (servermanager.Fetch(mesher, idx=port) for port in (5, 6))
    check_equal(boundary.GetNumberOfCells(), boundary.GetNumberOfPoints(), "the edges of one loop")
    check_equal(nodes.GetNumberOfPoints(), 4, "irregular nodes")
    # Writers that accept one type of cells.
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "quads.vtu")
        SaveData(file, proxy=mesher, DataMode="Binary")
        check_equal(fetch(OpenDataFile(file)).GetNumberOfCells(), quads.GetNumberOfCells(), "cells of the file")


def test_what_filters_of_paraview_give():
    disk = Disk(InnerRadius=0.5, OuterRadius=1, CircumferentialResolution=48)
    other = Transform(Input=disk)
    other.Transform.Translate = [3, 0, 0]
    outer = PlanarDomainSource()
    inner = Transform(Input=PlanarDomainSource())
    inner.Transform.Scale = [0.3, 0.3, 1]
    image = Wavelet(WholeExtent=[-10, 10, 0, 0, -5, 5])
    bent = Calculator(Input=disk, ResultArrayName="Bent", CoordinateResults=1)
    bent.Function = "coordsX*iHat + coordsY*jHat + 5e-5*coordsX*coordsX*kHat"
    raised = IsoVolume(Input=Wavelet(WholeExtent=[-10, 10, -10, 10, 0, 0]), InputScalars=["POINTS", "RTData"], ThresholdRange=[160, 400])
    ring = 0.75 * math.pi
    cases = (("strips", TriangleStrips(Input=Triangulate(Input=disk)), 1, ring), ("image", image, 1, 200.0),
             ("image as a structured grid", Transform(Input=image), 1, 200.0),
             ("appended", AppendDatasets(Input=[disk, other]), 2, 2 * ring), ("group", GroupDatasets(Input=[disk, other]), 2, 2 * ring),
             ("group of loops", GroupDatasets(Input=[outer, inner]), 1, 0.91 * math.pi), ("bent", bent, 1, ring),
             ("iso volume", raised, 3, None))
    for name, source, parts, area in cases:
        mesher = QuadMesher(Input=source, QuadCount=400)
        mesher.UpdatePipeline()
        quads = servermanager.Fetch(mesher)
        check_equal(quads.GetClassName(), "vtkUnstructuredGrid", name)
        check(320 < quads.GetNumberOfCells() < 480, "%s: %d quads" % (name, quads.GetNumberOfCells()))
        check_equal(quads.GetCellData().GetArray("Part").GetRange(), (0.0, parts - 1.0), name)
        if area is not None:
            total = servermanager.Fetch(IntegrateVariables(Input=mesher)).GetCellData().GetArray("Area").GetValue(0)
            check(abs(total - area) < 0.01 * area, "%s: area %g instead of %g" % (name, total, area))


def test_what_filters_of_paraview_give_in_space():
    image = Calculator(Input=Wavelet(WholeExtent=[-8, 8, -8, 8, -8, 8]), ResultArrayName="r",
                       Function="sqrt(coordsX^2 + coordsY^2 + 1.5*coordsZ^2)")
    slice_ = Slice(Input=image, SliceType="Sphere")
    slice_.SliceType.Radius = 6
    half = Clip(Input=slice_)
    half.ClipType.Normal = [1, 0, 0]
    cases = (("slice", slice_, 2), ("clip", half, 1), ("contour", Contour(Input=image, ContourBy=["POINTS", "r"], Isosurfaces=[6.0]), 2),
             ("iso volume", IsoVolume(Input=image, InputScalars=["POINTS", "r"], ThresholdRange=[0, 6]), 2))
    for name, source, characteristic in cases:
        mesher = QuadMesher(Input=source, QuadCount=400)
        mesher.UpdatePipeline()
        quads = servermanager.Fetch(mesher)
        check(280 < quads.GetNumberOfCells() < 520, "%s: %d quads" % (name, quads.GetNumberOfCells()))
        sides = servermanager.Fetch(mesher, idx=5).GetNumberOfCells()
        edges = (4 * quads.GetNumberOfCells() + sides) // 2
        check_equal(quads.GetNumberOfPoints() - edges + quads.GetNumberOfCells(), characteristic, "χ of " + name)


def test_layout_designer_on_a_surface():
    designer = LayoutDesigner(Input=Sphere(Radius=1, ThetaResolution=40, PhiResolution=30), QuadCount=300)
    designer.UpdatePipeline()
    designer.UpdatePropertyInformation()
    rows = np.reshape(designer.GetProperty("Rows"), (-1, 4))
    check_equal(rows[:, 2].sum(), 8, "the sum of quarter indices")
    check(abs(np.linalg.norm(rows[:, [0, 1, 3]], axis=1) - 1).max() < 0.02, "rows are on the sphere")
    check(len(designer.GetProperty("Triangles")) % 9 == 0, "nine numbers each")
    check(240 < servermanager.Fetch(designer, idx=3).GetNumberOfCells() < 360, "the quads")
    turned = rows @ [[np.cos(0.2), np.sin(0.2), 0, 0], [-np.sin(0.2), np.cos(0.2), 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    designer.Singularities = list(turned.ravel())
    designer.UpdatePipeline()
    check_equal(value(fetch(designer), "Stale"), 0, "whether the layout is stale")
    nodes = servermanager.Fetch(designer, idx=2)
    found = np.array([nodes.GetPoint(i) for i in range(nodes.GetNumberOfPoints())])
    check(abs(found - turned[:, [0, 1, 3]]).max() < 0.05, "nodes are at the rows")


def test_sides():
    """Rows of the table prescribe numbers of edges, progressions and sizes."""
    mesher = QuadMesher(Input=PlanarDomainSource(DomainName="l-shape"), QuadSize=0.1,
                        Sides=["outer0", "23", "2", "", "outer5", "", "", "0.08"])

    def edges():
        fetch(mesher)
        data = servermanager.Fetch(mesher, idx=8).GetFieldData()
        names, counts = data.GetAbstractArray("SideNames"), data.GetArray("SideEdges")
        return {names.GetValue(i): counts.GetValue(i) for i in range(counts.GetNumberOfTuples())}

    check_equal(edges()["outer0"], 23, "the number of edges")
    check(abs(edges()["outer5"] - 25) <= 5, "the size of edges")
    sides = servermanager.Fetch(mesher, idx=5).GetCellData().GetAbstractArray("Side")
    check_equal(len({sides.GetValue(i) for i in range(sides.GetNumberOfValues())}), 6, "the number of names")
    mesher.Sides = ["outer0", "18", "", ""]
    check_equal(edges()["outer0"], 18, "the number of edges after a change")
    mesher.Sides = []
    check(edges()["outer0"] in (19, 20, 21), "the number of edges without rows")


def test_quad_mesher_side_table():
    """Quad Mesher reads what is prescribed for sides from a .csv file."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "sides.csv")
        with open(path, "w", encoding="utf-8") as file:
            file.write("Side,Count,Progression,LayerFirst\nouter0,18,,\nouter2,,2,\n")
        table = CSVReader(FileName=[path])
        mesher = QuadMesher(Input=PlanarDomainSource(DomainName="l-shape"), QuadSize=0.1, SideTable=table)
        fetch(mesher)
        data = servermanager.Fetch(mesher, idx=8).GetFieldData()
        names, counts = data.GetAbstractArray("SideNames"), data.GetArray("SideEdges")
        edges = {names.GetValue(i): counts.GetValue(i) for i in range(counts.GetNumberOfTuples())}
        check_equal(edges["outer0"], 18, "the number of edges")


def test_quad_mesher_outputs():
    """The singularities and corners that Quad Mesher used are outputs; another one makes the same
    mesh of them."""
    star = PlanarDomainSource(DomainName="star")
    chosen = QuadMesher(Input=star, QuadCount=300, Sizing="Conformal")  # other sizes move the nodes
    quads = fetch(chosen)
    used = [servermanager.Fetch(chosen, idx=port) for port in (3, 4)]
    check_equal(used[1].GetNumberOfPoints(), 10, "the number of corners")
    quarters = [data.GetPointData().GetArray("QuarterIndex") for data in used]
    check_equal(sum(array.GetValue(i) for array in quarters for i in range(array.GetNumberOfTuples())), 4,
                "the sum of the quarter indices")
    given = fetch(QuadMesher(Input=star, QuadCount=300, Sizing="Conformal", CapCorners=0,
                             Singularities=servermanager.OutputPort(chosen, 3),
                             Corners=servermanager.OutputPort(chosen, 4)))
    check_equal(given.GetNumberOfPoints(), quads.GetNumberOfPoints(), "the number of points")
    for i in range(quads.GetNumberOfPoints()):
        check(math.dist(given.GetPoint(i), quads.GetPoint(i)) < 1e-9, "point %d is elsewhere" % i)


run_tests(*[test for name, test in list(globals().items()) if name.startswith("test_")])
