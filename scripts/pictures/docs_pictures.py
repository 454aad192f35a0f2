"""Draw the pictures of docs/filters and docs/choosing_singularities.md.

Usage:

    xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython docs_pictures.py
        --plugin CrossFieldPlugin.so --folder docs/pictures [--only NAME]

Positive singularities are red, negative ones blue. In pictures of the norm blue areas have a norm
below one, orange ones above. Sample run: scripts/pictures.sh.
"""
import pathlib
import sys
import argparse
import os
import tempfile

import numpy as np

from paraview import servermanager
from paraview.simple import *

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "pipelines" / "pvpython"))
from docs_drawing import (BLACK, GREEN, bounds_of, draw_labels, draw_scalar, figure, on_circle, panel,
                          polygon)
from drawing import (boundary, draw_boundaries, draw_lines, draw_norm, draw_singularities,
                     look_from_above, white_view)
from drawing_quads import draw_blocks, draw_nodes

DOMAINS = ["disk", "ring", "ellipse", "quarter-disk", "square", "rectangle", "l-shape", "hexagonal",
           "star", "angular-balanced", "angular-negative", "angular-positive", "angular-hole"]
GREY = [0.5, 0.5, 0.5]
PALE = [(0.98, 0.85, 0.8), (0.82, 0.9, 0.98), (0.85, 0.96, 0.84), (0.97, 0.94, 0.76), (0.91, 0.85, 0.96)]


def rows(*singularities):
    """Creates a singularity source with rows (x, y, quarter index[, radius])."""
    return SingularitySource(
        Singularities=[value for row in singularities for value in (tuple(row) + (0.05,))[:4]])


def disk():
    return PlanarDomainSource(EdgeLength=0.05)


def path_of(name):
    return os.path.join(arguments.folder, name + ".png")


def draw_crosses(field, view, spacing, colour=BLACK):
    draw_lines(CrossGlyphs(Input=field, Spacing=spacing, Scale=0.75), view, colour, 1)


def draw_mesh(mesh, view):
    shown = Show(mesh, view)
    SetProperties(shown, Representation="Surface With Edges", ColorArrayName=[None, ""],
                  DiffuseColor=[0.9, 0.94, 1], AmbientColor=[0.9, 0.94, 1], Ambient=1, Diffuse=0,
                  EdgeColor=GREY)
    draw_boundaries(mesh, view)


def field_panel(field, title, spacing=0.1, found=False):
    """Shows the norm of a field, its crosses and its boundaries."""
    view = panel(field, title)
    draw_norm(field, view, 0, 1.4, show_bar=False)
    draw_crosses(field, view, spacing)
    draw_boundaries(field, view)
    if found:
        draw_singularities(CrossFieldSingularities(Input=field), view, 0.03)
    return view


def solved(domain, singularities, size=0.05, **options):
    drilled = DrillHoles(Input=domain, Singularities=singularities, MeshSize=size)
    return PerforatedCrossField(Input=drilled, **options)


def reference(domain, size, **options):
    drilled = DrillHoles(Input=domain, Singularities=rows(), MeshSize=size)
    return GinzburgLandauCrossField(Input=drilled, **options)


# Filters


def planar_domain_source():
    view = white_view(1000, 640)
    for number, name in enumerate(DOMAINS):
        domain = PlanarDomainSource(DomainName=name)
        x0, x1, y0, y1 = bounds_of(domain)[:4]
        place = [2.6 * (number % 5) - (x0 + x1) / 2, -2.8 * (number // 5) - (y0 + y1) / 2, 0]
        moved = Transform(Input=domain)
        moved.Transform.Translate = place
        draw_lines(moved, view, BLACK, 2)
        text = a3DText(Text=name)
        width = bounds_of(text)[1]
        label = Transform(Input=text)
        label.Transform.Scale = [0.2, 0.2, 0.2]
        label.Transform.Translate = [2.6 * (number % 5) - 0.1 * width,
                                     -2.8 * (number // 5) - 1.35, 0]
        draw_lines(label, view, GREEN, 1)
    look_from_above(view, [-1.2, 11.6, -7, 1.1], 0)
    view.CameraParallelScale = 4.2
    SaveScreenshot(path_of("planar_domain_source"), view, ImageResolution=[1000, 640],
                   CompressionLevel="9")


def singularity_source():
    domain, points = disk(), rows(*on_circle(5, 0.6), (0, 0, -1))
    view = panel(domain, "five of +1, one of -1")
    draw_lines(domain, view, BLACK, 2)
    draw_singularities(points, view, 0.05)
    figure(path_of("singularity_source"), view)


def coast():
    """Creates a reader of a ragged coast: a circle with waves of all lengths and fixed phases."""
    angles = np.linspace(0, 2 * np.pi, 160, endpoint=False)
    waves = range(2, 40)
    phases = np.random.default_rng(7).uniform(0, 2 * np.pi, len(waves))
    radius = 1 + sum(0.2 / wave**1.1 * np.cos(wave * angles + phase) for wave, phase in zip(waves, phases))
    file = os.path.join(tempfile.mkdtemp(), "coast.csv")
    np.savetxt(file, np.column_stack([radius * np.cos(angles), radius * np.sin(angles)]), delimiter=",",
               header="x,y", comments="")
    return PlanarDomainReader(FileName=file)


def boundary_simplifier():
    ragged = coast()
    views = []
    for length in (0, 0.1, 0.3):
        mesh = DrillHoles(Input=BoundarySimplifier(Input=ragged, SmoothingLength=length),
                          Singularities=rows(), MeshSize=0.2, Gradation=0.5)
        view = panel(mesh, "SmoothingLength %g" % length)
        draw_mesh(mesh, view)
        views.append(view)
    figure(path_of("boundary_simplifier"), *views)


def drill_holes():
    views = []
    for mode in ("Perforate", "Imprint", "Triangle"):
        mesh = DrillHoles(Input=disk(), Singularities=rows(*(row + (0.1,) for row in on_circle(4, 0.6))),
                          Mode=mode, MeshSize=0.12)
        view = panel(mesh, mode)
        draw_mesh(mesh, view)
        views.append(view)
    figure(path_of("drill_holes"), *views)


def boundary_corner_classifier():
    views = []
    for name in ("l-shape", "hexagonal", "star"):
        domain = PlanarDomainSource(DomainName=name)
        corners = BoundaryCornerClassifier(Input=domain)
        corners.UpdatePipeline()
        view = panel(domain, name)
        draw_lines(domain, view, BLACK, 2)
        view.CameraParallelScale *= 1.1
        draw_labels(corners, "QuarterIndex", view)
        views.append(view)
    figure(path_of("boundary_corner_classifier"), *views)


def poincare_hopf_check():
    views = []
    for singularities in (on_circle(4, 0.6), on_circle(3, 0.6)):
        domain, points = disk(), rows(*singularities)
        check = PoincareHopfCheck(Input=domain, Singularities=points)
        view = panel(domain, room_below=-0.22)
        view.CameraParallelScale *= 1.2
        draw_lines(domain, view, BLACK, 2)
        draw_singularities(points, view, 0.05)
        SetProperties(Show(OutputPort(check, 3), view), Color=BLACK, FontSize=11)
        views.append(view)
    figure(path_of("poincare_hopf_check"), *views)


def configuration_proposal():
    views = []
    for name, options in (("disk", {}), ("angular-hole", {}),
                          ("angular-hole", dict(CancelFlatCorners=1))):
        domain = PlanarDomainSource(DomainName=name)
        view = panel(domain, name + (", Cancel Flat Corners" if options else ""))
        draw_lines(domain, view, BLACK, 2)
        draw_singularities(ConfigurationProposal(Input=domain, **options), view, 0.04)
        views.append(view)
    figure(path_of("configuration_proposal"), *views)


def perforated_cross_field():
    points = rows(*on_circle(5, 0.6), (0, 0, -1))
    figure(path_of("perforated_cross_field"),
           *(field_panel(solved(disk(), points, Method=method), method)
             for method in ("Constrained", "Unit Norm")))


def ginzburg_landau_cross_field():
    ring = PlanarDomainSource(DomainName="ring", EdgeLength=0.04)
    figure(path_of("ginzburg_landau_cross_field"),
           *(field_panel(reference(ring, 0.04, Epsilon=0.04, Start=start), "start: " + start,
                         found=True)
             for start in ("Harmonic", "Constant")))


def singularity_energy():
    views = []
    for title, singularities in (("like signs repel", on_circle(4, 0.6)),
                                 ("opposite signs attract", on_circle(5, 0.6) + [(0.25, 0.22, -1)])):
        domain, points = disk(), rows(*singularities)
        energy = SingularityEnergy(Input=domain, Configurations=[points])
        downhill = Calculator(Input=OutputPort(energy, 1), AttributeType="Point Data",
                              ResultArrayName="Downhill", Function="-Gradient/mag(Gradient)")
        view = panel(domain, title)
        draw_lines(domain, view, BLACK, 2)
        draw_singularities(points, view, 0.04)
        arrows = Glyph(Input=downhill, GlyphType="Arrow", OrientationArray=["POINTS", "Downhill"],
                       ScaleArray=["POINTS", "No scale array"], ScaleFactor=0.3,
                       GlyphMode="All Points")
        draw_lines(arrows, view, BLACK, 1)
        views.append(view)
    figure(path_of("singularity_energy"), *views)


def singularity_optimizer():
    views = []
    # The few iterations show intermediate states, so the warning about convergence is expected.
    for name, start in (("disk", [(0.5, 0.1, 1), (0.1, 0.4, 1), (-0.5, 0.3, 1), (0, -0.3, 1)]),
                        ("ellipse", [(0.5, 0.1, 1), (0.1, 0.3, 1), (-0.5, 0.2, 1), (0, -0.2, 1)])):
        domain, points = PlanarDomainSource(DomainName=name, EdgeLength=0.05), rows(*start)
        view = panel(domain, name)
        draw_lines(domain, view, BLACK, 2)
        ways = [[] for _ in start]
        for iterations in list(range(12)) + [200]:
            better = servermanager.Fetch(SingularityOptimizer(
                Input=domain, Singularities=points, MeshSize=0.05, MaximumIterations=iterations))
            for i, way in enumerate(ways):
                way.extend(better.GetPoint(i))
        for way in ways:
            draw_lines(PolyLineSource(Points=way), view, GREY, 2)
        draw_singularities(points, view, 0.02)
        draw_singularities(rows(*((way[-3], way[-2], 1) for way in ways)), view, 0.045)
        views.append(view)
    figure(path_of("singularity_optimizer"), *views)


def cross_field_singularities():
    field = reference(disk(), 0.05, Epsilon=0.05)
    figure(path_of("cross_field_singularities"), field_panel(field, "", found=True))


def separatrices():
    views = []
    for title, domain, singularities in (
            ("five of +1, one of -1", disk(), on_circle(5, 0.7, first=6) + [(0, 0, -1)]),
            ("four of each", PlanarDomainSource(DomainName="ring", EdgeLength=0.03),
             on_circle(4, 0.8, first=6) + on_circle(4, 0.55, -1, first=6))):
        points = rows(*singularities)
        lines = Separatrices(Input=CrossFieldMap(Input=domain, Singularities=points, MeshSize=0.04))
        view = panel(domain, title)
        faces = Show(OutputPort(lines, 1), view)
        ColorBy(faces, ("CELLS", "FaceId"))
        faces.LookupTable = CreateLookupTable(RGBPoints=[
            value for face in range(24) for value in (face, *PALE[face * 7 % len(PALE)])])
        SetProperties(faces, Ambient=1, Diffuse=0)
        draw_lines(lines, view, BLACK, 2)
        draw_lines(domain, view, BLACK, 2)
        draw_singularities(points, view, 0.03)
        views.append(view)
    figure(path_of("separatrices"), *views)


def layout_designer():
    views = []
    places = [row[:3] for row in on_circle(6, 0.7, first=6)] + [(0.2, 0.02, -1), (-0.2, -0.02, -1)]
    start = [value for place in places for value in (*place, 0.1)]
    for title, snaps in (("as dragged", False), ("after Snap", True)):
        designer = LayoutDesigner(Input=disk(), QuadCount=600, Singularities=start)
        if snaps:
            designer.InvokeCommand("Snap")
        designer.UpdatePipeline()
        view = panel(disk(), title)
        shown = Show(OutputPort(designer, 1), view)
        ColorBy(shown, ("CELLS", "FaceId"))
        shown.LookupTable = CreateLookupTable(RGBPoints=[
            value for face in range(60) for value in (face, *PALE[face * 7 % len(PALE)])])
        SetProperties(shown, Ambient=1, Diffuse=0)
        draw_lines(ExtractEdges(Input=OutputPort(designer, 3)), view, GREY, 1)
        draw_lines(designer, view, BLACK, 2)
        draw_lines(disk(), view, BLACK, 2)
        draw_singularities(OutputPort(designer, 2), view, 0.03)
        views.append(view)
    figure(path_of("layout_designer"), *views)


def quad_mesher():
    views = []
    for title, options in (("conformal", {}), ("uniform", dict(Sizing="Uniform"))):
        points = rows(*on_circle(5, 0.7, first=6), (0, 0, -1))
        quads = QuadMesher(Input=disk(), Singularities=points, QuadCount=500, **options)
        view = panel(disk(), title)
        draw_blocks(quads, view)
        draw_lines(OutputPort(quads, 2), view, BLACK, 2)
        draw_nodes(quads, view, 0.03)
        views.append(view)
    figure(path_of("quad_mesher"), *views)


def cross_glyphs():
    field = solved(disk(), SingularitySource(), size=0.1)
    views = []
    for title, options in (("Spacing 0", dict(Spacing=0)), ("Spacing 0.1", dict(Spacing=0.1)),
                           ("Scale By Norm", dict(Spacing=0.1, ScaleByNorm=1))):
        view = panel(field, title)
        draw_lines(CrossGlyphs(Input=field, **options), view, BLACK, 1)
        draw_boundaries(field, view)
        views.append(view)
    figure(path_of("cross_glyphs"), *views)


# Choosing singularities


def valence():
    views = []
    for sides in (3, 4, 5, 6):
        points = rows((0, 0, 4 - sides)) if sides != 4 else rows()
        field = HField(Input=polygon(sides), Singularities=points, MeshSize=0.03)
        view = panel(field, "k = %+d" % (4 - sides) if sides != 4 else "k = 0")
        draw_crosses(field, view, 0.11)
        draw_lines(boundary(field, 1, 2), view, BLACK, 2)
        draw_singularities(points, view, 0.05)
        views.append(view)
    figure(path_of("valence"), *views)


def holonomy():
    ring = PlanarDomainSource(DomainName="ring", EdgeLength=0.03)
    views = []
    for title, singularities in (("no defect", []), ("a defect: H jumps", [(0.7, 0, 1), (-0.7, 0, -1)])):
        points = rows(*singularities)
        field = HField(Input=ring, Singularities=points, MeshSize=0.03)
        view = panel(field, title)
        draw_scalar(field, view, "H", "Cool to Warm")
        draw_crosses(field, view, 0.08)
        draw_singularities(points, view, 0.04)
        views.append(view)
    figure(path_of("holonomy"), *views)


def unwanted():
    corners = [(1.3, 0), (1.13, 0.5), (0.65, 0.87), (0, 1), (-0.65, 0.87), (-1.13, 0.5),
               (-1.3, 0), (-1.13, -0.5), (-0.65, -0.87), (0, -1), (0.65, -0.87), (1.13, -0.5)]
    domain = PolyLineSource(Points=[value for x, y in corners for value in (x, y, 0)], Closed=1)
    figure(path_of("unwanted"),
           *(field_panel(solved(domain, SingularitySource(), Method=method), method, found=True)
             for method in ("Constrained", "Unit Norm")))


def sizes():
    views = []
    for title, singularities in (("k = +1: small quads", on_circle(4, 0.6)),
                                 ("k = -1: large quads", on_circle(5, 0.7) + [(0, 0, -1)])):
        points = rows(*singularities)
        field = HField(Input=disk(), Singularities=points, MeshSize=0.03)
        view = panel(field, title)
        draw_scalar(field, view, "SizeMap", "Grayscale")
        draw_crosses(field, view, 0.08, [0.1, 0.3, 0.8])
        draw_singularities(points, view, 0.03)
        views.append(view)
    figure(path_of("sizes"), *views)


PICTURES = [planar_domain_source, singularity_source, boundary_simplifier, drill_holes, boundary_corner_classifier,
            poincare_hopf_check, configuration_proposal, perforated_cross_field,
            ginzburg_landau_cross_field, singularity_energy, singularity_optimizer,
            cross_field_singularities, separatrices, layout_designer, quad_mesher, cross_glyphs, valence, holonomy,
            unwanted, sizes]

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--plugin", required=True, help="path of CrossFieldPlugin.so")
parser.add_argument("--folder", required=True, help="where the .png files are written")
parser.add_argument("--only", action="append", choices=[picture.__name__ for picture in PICTURES],
                    help="draw this picture; may be repeated")
arguments = parser.parse_args()
LoadPlugin(arguments.plugin, ns=globals())
os.makedirs(arguments.folder, exist_ok=True)
for picture in PICTURES:
    if not arguments.only or picture.__name__ in arguments.only:
        picture()
        print("wrote", path_of(picture.__name__))
