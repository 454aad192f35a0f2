"""crossfield.quads: python3 test_quads.py PROGRAM

Its numbers equal those of the program, its arrays are a conforming mesh of quads with the requested
valences, the blocks are that mesh, and errors are exceptions.
"""
import contextlib
import doctest
import io
import json
import os
import subprocess
import sys
import tempfile
import types
import unittest

import numpy as np

from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGReader

import crossfield
from crossfield import _quads
from crossfield._input import as_domain

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "verify"))
import kept  # noqa: E402

PROGRAM = sys.argv.pop(1)
FIVE = [(0.7 * np.cos(t), 0.7 * np.sin(t), 1) for t in 0.1 + 2 * np.pi * np.arange(5) / 5] + [(0, 0, -1)]


class Quads(unittest.TestCase):
    def refused(self, word, *arguments, **options):
        with self.assertRaisesRegex(crossfield.Error, word):
            crossfield.quads(*arguments, **options)

    def test_sizes_near_positions_and_inside_sides(self):
        mesh = crossfield.quads("builtin:l-shape", size=0.25, sizes_near=[(1, 1, 0.04), (0.5, 0.5, 0.06, 0.1)])
        self.assertGreater(mesh.report["size_target"]["area_share"], 0.9)
        self.assertEqual([side["name"] for side in mesh.report["size_target"]["sides"]], ["1,1", "0.5,0.5"])
        steep = crossfield.quads("builtin:l-shape", size=0.25, sizes_near=[(1, 1, 0.04)], growth=2.0)
        self.assertLess(len(steep.quads), len(mesh.quads))
        ring = crossfield.quads("builtin:ring", sizes_inside={"hole0": 0.05})
        self.assertGreater(len(ring.quads), 500)
        with self.assertRaisesRegex(crossfield.Error, "no row"):
            crossfield.quads("builtin:disk", sizes_near=[(0, 0)])
        with self.assertRaisesRegex(crossfield.Error, "above 1"):
            crossfield.quads("builtin:disk", sizes_near=[(0, 0, 0.1)], growth=1.0)

    def test_materials_of_a_mesh(self):
        points, cells, materials = vtkPoints(), vtkCellArray(), vtkStringArray()
        points.SetDataTypeToDouble()
        for i in range(6):
            points.InsertNextPoint(i % 3, i // 3, 0)
        for corners, material in (((0, 1, 4, 3), "steel"), ((1, 2, 5, 4), "copper")):
            cells.InsertNextCell(4, corners)
            materials.InsertNextValue(material)
        domain = vtkPolyData()
        domain.SetPoints(points)
        domain.SetPolys(cells)
        materials.SetName("Metal")
        domain.GetCellData().AddArray(materials)
        mesh = crossfield.quads(domain, count=200, materials="Metal")
        self.assertEqual([region["name"] for region in mesh.report["regions"]], ["steel", "copper"])
        centres = mesh.points[mesh.quads].mean(axis=1)
        np.testing.assert_array_equal(mesh.region, (centres[:, 0] > 1).astype(int))
        inner = mesh.edges[mesh.boundary_kind == 5]
        self.assertEqual(set(mesh.edge_side[mesh.boundary_kind == 5]), {"steel+copper"})
        np.testing.assert_array_equal(mesh.points[inner][:, :, 0], 1)
        self.assertTrue((mesh.valence[inner[1:-1]] == 4).any())
        self.assertFalse(crossfield.quads("builtin:disk", count=100).region.any())
        self.refused("no cell array 'Grain'", domain, materials="Grain")

    def test_lines_and_nodes_inside(self):
        square = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
        lines = {"crack": [(-1, 0), (0, 0)], "probe": [(0.5, -1), (0.6, 1)]}
        mesh = crossfield.quads(square, count=400, lines=lines, open_lines=["crack"], nodes=[(0.33, 0.41)])
        self.assertLessEqual({"crack.left", "crack.right", "probe"}, set(mesh.edge_side))
        self.assertLess(np.linalg.norm(mesh.points[:, :2] - (0.33, 0.41), axis=1).min(), 1e-12)
        self.assertTrue(crossfield.check(square, lines=lines).consistent)
        # Names of the domain stay, whole numbers as well, in an array of any name.
        domain = crossfield.read("builtin:l-shape")
        numbers = vtkIntArray()
        numbers.SetName("Patch")
        for cell in range(domain.GetNumberOfCells()):
            numbers.InsertNextValue(7)
        domain.GetCellData().AddArray(numbers)
        mesh = crossfield.quads(domain, count=100, names="Patch", lines={"weld": [(0, 0.5), (0.5, 0.5)]})
        self.assertLessEqual({"7", "weld"}, set(mesh.edge_side))
        self.assertEqual(len(crossfield.quads(square, count=100, lines={}).quads), 100)
        self.refused("No line of the domain has the name 'weld'", square, lines=["weld"])
        self.refused("There is no line or interface 'weld' to open", square, open_lines=["weld"])
        self.refused("not called by names", square, lines={"a;b": [(0, 0), (1, 0)]})
        self.refused("There is no node for the place", square, nodes=[(5, 5)])

    def test_numbers_are_those_of_the_program(self):
        for options, arguments in (({}, ()), ({"size": 0.1}, ("--size", "0.1")),
                                   ({"count": 300, "mesh_size": 0.05}, ("--quads", "300", "--mesh-size", "0.05")),
                                   ({"pairs": 1, "clearance": 0.1}, ("--pairs", "1", "--clearance", "0.1")),
                                   ({"size": 0.1, "sizing": "uniform", "merge": "coarse"},
                                    ("--size", "0.1", "--sizing", "uniform", "--coarse"))):
            with tempfile.TemporaryDirectory() as folder:
                printed = subprocess.run(
                    [PROGRAM, "quads", "builtin:disk", "-o", "quads.vtu", "--json", "-", *arguments],
                    cwd=folder, text=True, check=True, stdout=subprocess.PIPE).stdout
            expected, found = json.loads(printed), crossfield.quads("builtin:disk", **options).report
            for report in (expected, found):
                del report["seconds"], report["integers"]["seconds"]
            self.assertEqual(json.dumps(found, sort_keys=True), json.dumps(expected, sort_keys=True))

    def test_another_configuration_is_used(self):
        loops = [[(np.cos(t), np.sin(t)) for t in np.linspace(0, 2 * np.pi, 181)[:-1]]]
        for turn in range(3):
            x, y = 0.6 * np.cos(2 * np.pi * turn / 3), 0.6 * np.sin(2 * np.pi * turn / 3)
            loops.append([(x + 0.1 * np.cos(t), y + 0.1 * np.sin(t)) for t in np.linspace(0, 2 * np.pi, 37)[:-1]])
        found = [crossfield.quads(loops, count=1500, alternative=i).report for i in (0, 1)]
        listed = found[0]["alternatives"]
        self.assertEqual(listed, found[1]["alternatives"])
        for report, one in zip(found, listed):
            self.assertEqual((report["blocks"], report["scaled_jacobian"]["min"]), (one["blocks"], one["scaled_jacobian"]))

    def test_nodes_of_periodic_sides_match_at_every_order(self):
        x = np.linspace(0, 2, 41)
        low = np.c_[x, 0.15 * np.sin(4 * x)]
        outline = np.vstack([low, low[::-1] + (0.1, 1)])
        names = {"outer0": "spline", "outer2": "spline"}
        for order in (1, 2, 3):
            for pairs in ({"outer0": "outer2"}, [("outer0", "outer2")]):
                mesh = crossfield.quads(outline, count=200, curves=names, order=order, periodic=pairs)
                [pair] = mesh.report["periodic"]
                shift = [pair["vector"][axis] for axis in "xyz"]
                self.assertLess(np.linalg.norm(shift - np.array([0.1, 1, 0])), 1e-13)
                self.assertLessEqual(pair["mismatch"], 1e-12)
                first, second = (mesh.points[np.unique(mesh.edge_nodes[mesh.edge_side == side])] for side in names)
                self.assertEqual(len(first), order * pair["edges"] + 1)
                distances = np.linalg.norm(first[:, None] + shift - second[None], axis=-1)
                self.assertLessEqual(distances.min(axis=1).max(), 1e-12)
                self.assertLessEqual(distances.min(axis=0).max(), 1e-12)
        self.refused("not images of each other", outline, count=200, periodic={"outer0": "outer1"})

    def test_layers_and_what_rows_do_at_corners(self):
        shape = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
        mesh = crossfield.quads(shape, size=0.1, layers={"outer0": (1e-3, 1.25), "outer2": 1e-3},
                                corners={(1, 1): "leave"})
        first, second = mesh.report["layers"]
        self.assertEqual((first["side"], second["side"]), ("outer0", "outer2"))
        for layer, growth in ((first, 1.25), (second, 1.2)):
            self.assertAlmostEqual(layer["heights"]["min"], 1e-3, places=8)
            self.assertLessEqual(layer["growth"], growth + 1e-9)
            self.assertEqual(layer["in_bounds"], 1)
        self.assertEqual(mesh.report["irregular"], {})
        turned = crossfield.quads(shape, size=0.1, corners={"outer2": "turn"})
        self.assertEqual(turned.report["irregular"], {"5": 1})
        self.assertNotIn("layers", turned.report)
        rows, = crossfield.quads(shape, size=0.1, layers={"outer0": (None, 1.2, 7)}).report["layers"]
        self.assertEqual((rows["first"], rows["rows"]), (0, 7))
        self.refused("no side 'wall'", shape, layers={"wall": 1e-3})
        self.refused("semicolon", shape, layers={"a;b": 1e-3})
        self.refused("give end, turn or leave", shape, corners={(1, 1): "stay"})

    def test_singularities_and_corners_used_are_outputs_of_the_filter(self):
        mesh = crossfield.quads("builtin:star", count=300, sizing="conformal")  # other sizes move the nodes
        mesher = crossfield.vtkQuadMesher()
        mesher.SetInputData(as_domain("builtin:star", None))
        mesher.SetQuadCount(300)
        mesher.SetSizingToConformal()
        mesher.Update()
        for port, data in ((3, mesh.singularities.data), (4, mesh.singularities.corners)):
            used = mesher.GetOutputDataObject(port)
            self.assertEqual([used.GetPoint(i) for i in range(used.GetNumberOfPoints())],
                             [data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
            quarters = [vtk_to_numpy(d.GetPointData().GetArray("QuarterIndex")).tolist() for d in (used, data)]
            self.assertEqual(*quarters)
        self.assertEqual(mesh.singularities.corners.GetNumberOfPoints(), 10)
        self.assertEqual(mesh.report["events"], mesh.singularities.events)
        self.assertGreater(mesh.report["seconds"]["choose"], 0)
        again = crossfield.quads("builtin:star", mesh.singularities, count=300, sizing="conformal",
                                 corners=mesh.singularities.corners, cap_corners=False)
        self.assertEqual(again.points.shape, mesh.points.shape)
        self.assertLess(np.abs(again.points - mesh.points).max(), 1e-9)
        self.assertNotIn("events", again.report)

    def test_large_indices_are_split_and_moves_are_reported(self):
        six = [(0.2, 0.1, -2)] + [(0.6 * np.cos(a), 0.6 * np.sin(a), 1) for a in range(6)]
        self.assertEqual(crossfield.quads("builtin:disk", six).report["irregular"], {"3": 6, "6": 1})
        split = crossfield.quads("builtin:disk", six, split=True)
        self.assertEqual(split.report["irregular"], {"3": 6, "5": 2})
        self.assertIn("was split into 2 of index -1.", split.report["events"][0])
        for x, y in split.singularities.points[:, :2]:
            self.assertLess(np.hypot(*(split.points[:, :2] - (x, y)).T).min(), 1e-12)

    def test_arrays_are_a_conforming_mesh_with_these_valences(self):
        mesh = crossfield.quads("builtin:disk", FIVE, size=0.1)
        kept.keep_data(mesh.grid)
        sides = np.sort(np.concatenate([mesh.quads[:, [i, (i + 1) % 4]] for i in range(4)]), axis=1)
        unique, quads = np.unique(sides, axis=0, return_counts=True)
        self.assertEqual(len(mesh.points) - len(unique) + len(mesh.quads), 1)  # Euler characteristic
        self.assertTrue((quads <= 2).all())
        self.assertEqual(set(map(tuple, unique[quads == 1])), set(map(tuple, np.sort(mesh.edges, axis=1))))
        self.assertTrue((np.bincount(mesh.quads.ravel()) == mesh.valence).all())
        inside = np.setdiff1d(np.arange(len(mesh.points)), mesh.edges)
        irregular = inside[mesh.valence[inside] != 4]
        self.assertEqual(sorted(4 - mesh.valence[irregular]), [-1, 1, 1, 1, 1, 1])
        found = {(round(x, 9), round(y, 9), 4 - v) for (x, y, _), v in
                 zip(mesh.points[irregular].tolist(), mesh.valence[irregular].tolist())}
        self.assertEqual(found, {(round(x, 9), round(y, 9), k) for x, y, k in FIVE})
        self.assertGreater(mesh.scaled_jacobian.min(), 0.8)

    def test_blocks_are_the_mesh(self):
        mesh = crossfield.quads("builtin:disk", FIVE, size=0.1)
        centres = np.concatenate([
            ((b[:-1, :-1] + b[1:, :-1] + b[1:, 1:] + b[:-1, 1:]) / 4).reshape(-1, 3) for b in mesh.blocks])
        expected = mesh.points[mesh.quads].mean(axis=1)
        self.assertEqual(len(centres), len(expected))
        order, expected_order = (np.lexsort(np.round(a, 9).T) for a in (centres, expected))
        self.assertLess(np.abs(centres[order] - expected[expected_order]).max(), 1e-12)
        for block in mesh.blocks:  # right-handed
            along, across = block[1, 0] - block[0, 0], block[0, 1] - block[0, 0]
            self.assertGreater(np.cross(along, across)[2], 0)
        self.assertEqual(len(mesh.blocks), mesh.report["blocks"])

    @staticmethod
    def channel(width):
        """Returns a channel of length 3 with size 0.1 at the left and 0.2 at the right."""
        channel = vtkPolyData()
        points, lines = vtkPoints(), vtkCellArray()
        for place in ((0, 0, 0), (3, 0, 0), (3, width, 0), (0, width, 0)):
            points.InsertNextPoint(place)
        lines.InsertNextCell(5)
        for point in (0, 1, 2, 3, 0):
            lines.InsertCellPoint(point)
        channel.SetPoints(points)
        channel.SetLines(lines)
        lengths = numpy_to_vtk(np.array([0.1, 0.2, 0.2, 0.1]), deep=True)
        lengths.SetName("Length")
        channel.GetPointData().AddArray(lengths)
        return channel

    def test_the_optimiser_follows_the_same_array(self):
        channel = self.channel(0.8)
        found = crossfield.optimize(channel, [], pairs=1, size_array="Length")
        self.assertEqual(sorted(found.quarter_index.tolist()), [-1, 1])
        self.assertLess(found.report["size_spread_after"], 0.6 * found.report["size_spread_before"])
        # Sizes of quads are nearer to the array than without it.
        deviations = []
        for rows in (found, []):
            mesh = crossfield.quads(channel, rows, sizing="field", size_array="Length", count=500)
            corners = mesh.points[mesh.quads]
            across = corners[:, 2:, :] - corners[:, :2, :]
            areas = 0.5 * np.abs(across[:, 0, 0] * across[:, 1, 1] - across[:, 0, 1] * across[:, 1, 0])
            deviations.append(np.std(0.5 * np.log(areas) - np.log(0.1 + corners[:, :, 0].mean(axis=1) / 30)))
        self.assertLess(deviations[0], 0.7 * deviations[1])
        for options, word in (({}, "with even or pairs"), ({"even": True}, "no point array 'Width'")):
            with self.assertRaisesRegex(crossfield.Error, word):
                crossfield.optimize(channel, [], size_array="Width", **options)

    def test_sizes_follow_an_array(self):
        """Columns of quads are twice as wide at the right."""
        strip = self.channel(0.3)
        mesh = crossfield.quads(strip, [], sizing="field", size_array="Length")
        x = np.sort(mesh.points[mesh.points[:, 1] == 0, 0])
        self.assertAlmostEqual(len(x) - 1, 30 * np.log(2), delta=1)
        self.assertAlmostEqual((x[-1] - x[-2]) / (x[1] - x[0]), 2, delta=0.25)
        count = len(crossfield.quads(strip, [], sizing="field", size_array="Length", count=200).quads)
        self.assertLessEqual(abs(count - 200), 10)

    def test_holonomy_is_repaired(self):
        def four(radius, first, quarters):
            return [(radius * np.cos(t), radius * np.sin(t), quarters) for t in first + np.pi / 2 * np.arange(4)]

        # The phase 4θ turns by the sum of k_j arg b_j: 0.6.
        rows = four(0.8, 0.25, 1) + four(0.55, 0.1, -1)
        repaired = crossfield.quads("builtin:ring", rows, size=0.1, repair_holonomy=True)
        self.assertEqual(repaired.report["irregular"], {"3": 4, "5": 4})
        moves = np.linalg.norm(repaired.singularities.points[:, :2] - np.array(rows)[:, :2], axis=1)
        self.assertAlmostEqual(moves.max(), repaired.report["repair"]["distance"], places=12)
        self.assertAlmostEqual(abs(repaired.report["repair"]["defect_before"][0]), 0.6, delta=0.01)
        # The rotations δ_j minimise the sum of squares of r_j δ_j subject to Σ k_j δ_j = 0.6.
        least = 0.15 * 4 / np.sqrt(4 / 0.8 ** 2 + 4 / 0.55 ** 2)
        most = least / np.sqrt(4 / 0.8 ** 2 + 4 / 0.55 ** 2) / 0.55
        self.assertAlmostEqual(repaired.report["repair"]["distance"], most, delta=0.03 * most)

    def test_results_have_short_summaries(self):
        mesh = crossfield.quads("builtin:disk", FIVE, size=0.1)
        self.assertRegex(repr(mesh), r"^<QuadMesh: %d quads in %d blocks, minimum scaled Jacobian 0\.\d\d>$"
                         % (len(mesh.quads), len(mesh.blocks)))
        self.assertEqual(repr(crossfield.propose("builtin:disk")), "<Configuration: quarter indices [1, 1, 1, 1]>")
        field = crossfield.hfield("builtin:disk", [(0, 0, 4)])
        self.assertEqual(repr(field), "<HField: %d triangles, %d points>" % (len(field.triangles), len(field.points)))

    def test_a_picture_has_blocks_and_nodes(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "mesh.png")
            with open(os.path.join(folder, "draw.py"), "w", encoding="utf-8") as script:
                script.write("import crossfield\ncrossfield.quads('builtin:disk', %r, size=0.1).plot(%r, width=500)\n"
                             % ([tuple(map(float, row)) for row in FIVE], file))
            # The executable that pvpython reports does not exist.
            python = sys.executable if os.path.exists(sys.executable) else "pvpython"
            subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -noreset", python, script.name], check=True)
            reader = vtkPNGReader()
            reader.SetFileName(file)
            reader.Update()
            image = reader.GetOutput()
            width, height, _ = image.GetDimensions()
            self.assertEqual(width, 500)
            self.assertAlmostEqual(height, 500, delta=2)
            pixels = vtk_to_numpy(image.GetPointData().GetScalars())[:, :3].astype(int)
            shares = [(np.abs(pixels - colour).max(axis=1) < 8).mean() for colour in (
                (255, 255, 255), (250, 217, 204), (209, 230, 250), (0, 0, 0), (217, 26, 26), (26, 51, 217))]
            self.assertAlmostEqual(shares[0], 1 - np.pi / 4 / 1.06 ** 2, delta=0.03)  # around the disk
            for share, least in zip(shares[1:], (0.05, 0.05, 0.003, 3e-4, 6e-5)):
                self.assertGreater(share, least)
            mesh = crossfield.quads("builtin:disk", FIVE, size=0.1)
            self.assertRaisesRegex(crossfield.Error, "ends in .png", mesh.plot, "mesh.jpg")
            self.assertRaisesRegex(crossfield.Error, "no folder", mesh.plot, os.path.join(folder, "no", "mesh.png"))

    def test_what_is_written_is_read(self):
        mesh = crossfield.quads("builtin:l-shape", [], size=0.2)
        with tempfile.TemporaryDirectory() as folder:
            mesh.write(os.path.join(folder, "quads.vtu"))
            read = crossfield.read(os.path.join(folder, "quads.vtu"))
            self.assertEqual(read.GetNumberOfCells(), 75 + len(mesh.edges))

    def test_files_for_solvers_are_those_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            for order, ending in ((1, ".msh"), (2, ".msh"), (3, ".msh"), (2, ".inp"), (1, ".su2")):
                mesh = crossfield.quads("builtin:l-shape", count=50, order=order)
                path, expected = os.path.join(folder, "a" + ending), os.path.join(folder, "b" + ending)
                mesh.write(path)
                subprocess.run([PROGRAM, "quads", "builtin:l-shape", "--quads", "50", "-o", expected, "--order", str(order)],
                               check=True, capture_output=True)
                with open(path, "rb") as written, open(expected, "rb") as by_program:
                    self.assertEqual(written.read(), by_program.read())
            self.assertRaisesRegex(crossfield.Error, "order 1 only",
                                   crossfield.quads("builtin:square", count=9, order=2).write, path)
            with open(path, "rb") as written, open(expected, "rb") as by_program:
                self.assertEqual(written.read(), by_program.read(), "the old file")
            self.assertEqual(len(os.listdir(folder)), 6, "no temporary files")

    def test_unknown_endings_are_refused_before_anything_is_written(self):
        mesh = crossfield.quads("builtin:square", [], count=16)
        field = crossfield.solve("builtin:square", [], size=0.5)
        with tempfile.TemporaryDirectory() as folder:
            for result, listed in ((mesh, ".msh, .msh2, .su2, .vtk, .xyz, or a folder .*, or one of .avs"), (mesh.extrude(1.0), ".msh, .msh2, .su2"),
                                   (field, "must end in .vtu")):
                for name in ("a.stl", "a.nothing", "a"):
                    with self.assertRaisesRegex(crossfield.Error, "'.*%s'.*%s" % (name, listed)):
                        result.write(os.path.join(folder, name))
            self.assertEqual(os.listdir(folder), [])

    def test_arguments_of_wrong_types_are_type_errors(self):
        square = [(0, 0), (2, 0), (2, 2), (0, 2)]
        for function, arguments, sentence in (
                (crossfield.quads, {"count": "400"}, "The argument count is '400'; give a whole number, or None."),
                (crossfield.quads, {"count": 400.5}, "The argument count is 400.5; give a whole number, or None."),
                (crossfield.quads, {"count": 1e12}, "The argument count is 1000000000000.0; give a whole number of at most "
                                                    "2147483647, or None."),
                (crossfield.quads, {"size": {}}, "The argument size is {}; give a number, or None."),
                (crossfield.quads, {"order": None}, "The argument order is None; give a whole number."),
                (crossfield.quads, {"split": "no"}, "The argument split is 'no'; give True or False."),
                (crossfield.quads, {"sizing": {"auto": 1}}, "The argument sizing is {'auto': 1}; give a text."),
                (crossfield.quads, {"counts": [("outer0", 3)]},
                 "The argument counts is [('outer0', 3)]; give a dictionary by the names of sides, as {'wall': 40}."),
                (crossfield.quads, {"counts": {"outer0": None}}, "The count of 'outer0' is None; give a whole number."),
                (crossfield.quads, {"sizes": {"outer0": "x"}}, "The size of 'outer0' is 'x'; give a length."),
                (crossfield.quads, {"progressions": {"outer0": "2"}},
                 "The progression of 'outer0' is '2'; give a number, or a tuple of numbers."),
                (crossfield.quads, {"layers": 0.1}, "The argument layers is 0.1; give a dictionary by the names of sides, as "
                                                    "{'wall': (1e-4, 1.2)}."),
                (crossfield.quads, {"layers": {"outer0": None}},
                 "The layer of 'outer0' is None; give the height of its first row, or a tuple of numbers."),
                (crossfield.quads, {"curves": 3}, "The argument curves is 3; give a dictionary by the names of sides, as "
                                                  "{'hole': 'circle'}."),
                (crossfield.quads, {"periodic": 3}, "The argument periodic has the entry 3; give pairs of names of sides, as "
                                                    "{'left': 'right'}."),
                (crossfield.quads, {"singularities": {"x": 1}}, "The singularities must be an array of numbers with 3 or 4 "
                                                                "columns; its shape is not that of an array."),
                (crossfield.solve, {"size": "0.1"}, "The argument size is '0.1'; give a number, or None."),
                (crossfield.check, {"corner_angle": None}, "The argument corner_angle is None; give a number."),
                (crossfield.optimize, {"pairs": "2"}, "The argument pairs is '2'; give a whole number.")):
            with self.assertRaises(TypeError) as caught:
                function(square, **arguments)
            self.assertIsInstance(caught.exception, crossfield.Error)
            self.assertEqual(str(caught.exception), sentence)
        for domain in (None, 3, {"points": square}):
            self.assertRaisesRegex(TypeError, "The domain is of the type .*; give an array of points", crossfield.quads, domain)
        numbers = crossfield.quads(square, count=np.float64(100.0), order=np.int32(1), cap_corners=np.bool_(True))
        self.assertEqual(numbers.report["quads"], crossfield.quads(square, count=100).report["quads"])

    def test_layers_in_the_form_of_the_interface(self):
        square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        first = crossfield.quads(square, size=0.1, layers={"outer0": (1e-2, 1.3)}).report["layers"]
        for layers in ("outer0:1e-2,1.3", {"outer0": "1e-2,1.3"}, {"outer0": [1e-2, 1.3]}, {"outer0": np.array([1e-2, 1.3])}):
            self.assertEqual(crossfield.quads(square, size=0.1, layers=layers).report["layers"], first)

    def test_other_endings_are_written_by_meshio(self):
        mesh, written = crossfield.quads("builtin:square", [], count=16), []
        fake = types.ModuleType("meshio")

        class Mesh:
            def __init__(self, points, cells, cell_data):
                self.parts = points, cells, cell_data

            def write(self, path):
                if path.endswith(".bdf"):
                    raise ValueError("no such format")
                written.append((path, *self.parts))

        fake.Mesh = Mesh
        before = sys.modules.get("meshio")
        try:
            sys.modules["meshio"] = None
            with self.assertRaisesRegex(crossfield.Error, "python3-meshio"):
                mesh.write("quads.med")
            sys.modules["meshio"] = fake
            mesh.write("quads.med")
            with self.assertRaisesRegex(crossfield.Error, "no such format"):
                mesh.write("quads.bdf")
        finally:
            del sys.modules["meshio"]
            if before is not None:
                sys.modules["meshio"] = before
        [(path, points, cells, data)] = written
        self.assertEqual((path, points.shape), ("quads.med", (25, 3)))
        self.assertEqual([(name, ids.shape) for name, ids in cells], [("quad", (16, 4)), ("line", (16, 2))])
        self.assertEqual([len(values) for values in data["BoundaryId"]], [16, 16])

    def test_sides_have_their_points_in_order(self):
        plate = as_domain([[(0, 0), (3, 0), (3, 2), (0, 2)],
                           [(1.4 + 0.4 * np.cos(a), 1 + 0.4 * np.sin(a)) for a in np.linspace(0, 2 * np.pi, 60, False)]],
                          None)
        mesh = crossfield.quads(plate, size=0.2, counts={"hole0": 21}, progressions={"outer0": ("both", 3.0)},
                                sizes={"outer3": 0.1})
        self.assertEqual(sorted(mesh.sides), ["hole0", "outer0", "outer1", "outer2", "outer3"])
        self.assertEqual(len(mesh.side("hole0")), 21)
        by_name = {side["name"]: side for side in mesh.report["sides"]}
        for name in mesh.sides:
            rows = mesh.side(name)
            self.assertEqual(len(set(rows)), len(rows))
            closed = name == "hole0"
            self.assertEqual(len(rows) - (not closed), by_name[name]["edges"])
            path = mesh.points[np.append(rows, rows[0]) if closed else rows]
            self.assertAlmostEqual(np.linalg.norm(np.diff(path, axis=0), axis=1).sum(), by_name[name]["length"])
            edges = {tuple(edge) for edge in mesh.edges[mesh.edge_side == name]}
            self.assertEqual(edges, set(zip(rows, np.roll(rows, -1) if closed else rows[1:])))
        # loops start at their lowest leftmost point, with the domain on the left
        bottom = mesh.points[mesh.side("outer0")]
        self.assertEqual(bottom[0].tolist(), [0, 0, 0])
        self.assertEqual(bottom[-1].tolist(), [3, 0, 0])
        lengths = np.diff(bottom[:, 0])
        self.assertAlmostEqual(lengths[(len(lengths) - 1) // 2] / lengths[0], 3)
        self.assertTrue((abs(np.diff(mesh.points[mesh.side("outer3")][:, 1]) + 0.1) < 0.02).all())
        with self.assertRaisesRegex(crossfield.Error, "no side 'x'"):
            mesh.side("x")
        for arguments, words in (({"counts": {"x": 3}}, "no side 'x'"), ({"names": "x"}, "no cell array 'x'"),
                                 ({"progressions": {"hole0": 2.0}}, "closed curve"),
                                 ({"counts": {"outer1": 3, "outer3": 4, "outer0": 2, "outer2": 9}}, "contradict|strip|fits"),
                                 ({"min_size": 2.0, "max_size": 1.0}, "minimum size")):
            with self.assertRaisesRegex(crossfield.Error, words):
                crossfield.quads(plate, size=0.2, **arguments)

    def test_refusals(self):
        self.refused("leave one out", "builtin:disk", size=0.1, count=100)
        self.refused("number 0 of quads is not positive", "builtin:disk", count=0)
        self.refused("not positive", "builtin:disk", size=-0.1)
        self.refused("no sizing 'even'; choose auto, conformal, uniform", "builtin:disk", sizing="even")
        self.refused("no merge 'all'; choose none, clean, coarse", "builtin:disk", merge="all")
        self.refused("no preference 'all'; choose nodes, blocks, uniform", "builtin:disk", prefer="all")
        self.refused("give both or none", "builtin:disk", sizing="field")
        self.refused("give both or none", "builtin:disk", size_array="Length")
        self.refused("leave size out", "builtin:disk", sizing="field", size_array="Length", size=0.1)
        self.refused("no point array 'Length'", "builtin:disk", sizing="field", size_array="Length")
        self.refused("split it", "builtin:disk", [(0.4, 0, 3), (-0.4, 0, 1)])

    def test_examples(self):
        printed = io.StringIO()  # doctest reads its encoding, which standard output of pvpython does not have
        with contextlib.redirect_stdout(printed):
            result = doctest.testmod(_quads, optionflags=doctest.ELLIPSIS)
        self.assertEqual(result.failed, 0, printed.getvalue())
        self.assertGreater(result.attempted, 2)


if __name__ == "__main__":
    unittest.main()
