"""Files of blocks and of VTK's readers: CGNS, PLOT3D, Exodus and legacy VTK are read back with the same
points, cells and names of sides, in two and three dimensions.

    python3 test_block_files.py
"""
import os
import shutil
import subprocess
import tempfile
import unittest

import crossfield
import numpy as np
from crossfield.vtkCrossFieldFilters import vtkExtrudeQuads, vtkQuadMeshWriter
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkUnstructuredGrid
from vtkmodules.vtkIOCGNSReader import vtkCGNSReader
from vtkmodules.vtkIOExodus import vtkExodusIIReader
from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader
from vtkmodules.vtkIOParallel import vtkMultiBlockPLOT3DReader

NAMES = ["in let", 'say "out"', "Стена / " + 9 * "длинная", "Стена / " + 9 * "длинная" + "!", "a" * 40 + "1", "a" * 40 + "2"]


def leaves(data, path=()):
    """Yields the names on the way to each data set of a composite, and the data set."""
    for i in range(data.GetNumberOfBlocks()):
        block = data.GetBlock(i)
        name = data.GetMetaData(i).Get(vtkCompositeDataSet.NAME()) if data.HasMetaData(i) else None
        if block is not None and block.IsA("vtkMultiBlockDataSet"):
            yield from leaves(block, (*path, name))
        elif block is not None:
            yield (*path, name), block


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def rows(places):
    return sorted(map(tuple, np.asarray(list(places), float)))


def single(places):
    return sorted(map(tuple, np.asarray(places, np.float32).astype(float)))


class Mesh:
    """Quads or hexahedra, their blocks as arrays (k, j, i, 3), and the cells and names of their boundary."""

    def __init__(self, grid):
        self.grid = grid
        data = grid.GetCellData()
        lengths = [grid.GetCell(i).GetCellDimension() for i in range(grid.GetNumberOfCells())]
        self.dimension = max(lengths)
        self.cells = [i for i, d in enumerate(lengths) if d == self.dimension]
        sides = data.GetAbstractArray("Side")
        self.sides = {}
        for i, d in enumerate(lengths):
            if d < self.dimension:
                self.sides.setdefault(sides.GetValue(i), []).append(i)

    def places(self, cells):
        """Returns the points of cells, each once, in order."""
        ids = sorted({self.grid.GetCell(i).GetPointId(n) for i in cells for n in range(self.grid.GetCell(i).GetNumberOfPoints())})
        return rows(self.grid.GetPoint(i) for i in ids)


class BlockFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def meshes(self, names=None):
        for domain, motion in (("l-shape", None), ("disk", None), ("ring", None), ("l-shape", {}), ("disk", {}),
                               ("l-shape", {"angle": 90}), ("l-shape", {"angle": 360})):
            quads = crossfield.quads("builtin:" + domain, count=60)
            grid = vtkUnstructuredGrid()
            grid.DeepCopy(quads.grid)
            if names:
                array = grid.GetCellData().GetAbstractArray("Side")
                for i in range(array.GetNumberOfValues()):
                    if array.GetValue(i):
                        array.SetValue(i, names[quads.sides.index(array.GetValue(i))])
            if motion is not None:
                extrude = vtkExtrudeQuads()
                extrude.SetInputData(grid)
                extrude.SetLayers(5)
                extrude.SetHeight(0.3)
                if "angle" in motion:
                    extrude.SetMotionToRevolution()
                    extrude.SetAngle(motion["angle"])
                extrude.Update()
                grid = extrude.GetOutput()
            yield Mesh(grid)

    def write(self, mesh, name):
        writer = vtkQuadMeshWriter()
        writer.SetInputData(mesh.grid)
        writer.SetFileName(self.path(name))
        writer.Write()
        self.assertEqual(writer.GetErrorCode(), 0)

    def block_points(self, mesh):
        """Returns the points of each block in the order of structured grids."""
        data = mesh.grid.GetCellData()
        arrays = [vtk_to_numpy(data.GetArray(name)) if data.GetArray(name) else None for name in ("BlockId", "I", "J", "K")]
        blocks = {}
        for cell in mesh.cells:
            block, *index = [int(array[cell]) if array is not None else 0 for array in arrays]
            ids = [mesh.grid.GetCell(cell).GetPointId(i) for i in range(mesh.grid.GetCell(cell).GetNumberOfPoints())]
            for corner, point in enumerate(ids):
                if len(ids) == 6:  # a prism, which may be turned in its block
                    blocks.setdefault(block, {})[corner, *index] = mesh.grid.GetPoint(point)
                    continue
                place = (index[0] + (corner % 4 in (1, 2)), index[1] + (corner % 4 in (2, 3)), index[2] + corner // 4)
                blocks.setdefault(block, {})[place[::-1]] = mesh.grid.GetPoint(point)
        return [[places[place] for place in sorted(places)] for _, places in sorted(blocks.items())]

    def expect_blocks(self, mesh, grids):
        expected = self.block_points(mesh)
        self.assertEqual(len(grids), len(expected))
        self.assertEqual(sum(grid.GetNumberOfCells() for grid in grids), len(mesh.cells))
        prisms = any(mesh.grid.GetCell(i).GetNumberOfPoints() == 6 for i in mesh.cells)
        for grid, points in zip(grids, expected):
            found = [tuple(place) for place in points_of(grid)]
            self.assertEqual(grid.GetPoints().GetData().GetDataTypeAsString(), "double")
            if prisms:
                self.assertEqual(set(found), set(points))
            else:
                self.assertEqual(found, points, "points to the last bit, the first index fastest")

    @unittest.skipUnless(vtkQuadMeshWriter.ReasonAgainst("a.cgns", 1) == "", "built without CGNS")
    def test_cgns(self):
        for names in (None, NAMES):
            for number, mesh in enumerate(self.meshes(names)):
                self.write(mesh, "a.cgns")
                if shutil.which("cgnscheck"):
                    check = subprocess.run(["cgnscheck", self.path("a.cgns")], check=True, capture_output=True, text=True)
                    self.assertNotRegex(check.stdout + check.stderr, "(?i)warning|error", (number, check.stdout))
                reader = vtkCGNSReader()
                reader.SetFileName(self.path("a.cgns"))
                reader.DoublePrecisionMeshOn()
                reader.LoadBndPatchOn()
                reader.UpdateInformation()
                reader.EnableAllFamilies()
                reader.Update()
                families = [reader.GetFamilyArrayName(i) for i in range(reader.GetNumberOfFamilyArrays())]
                self.assertEqual(len(families), len(mesh.sides))
                for family in families:
                    self.assertLessEqual(len(family.encode()), 32)
                    self.assertNotIn("/", family)
                if names is None:
                    self.assertEqual(set(families), set(mesh.sides))
                found = list(leaves(reader.GetOutput()))
                self.expect_blocks(mesh, [grid for path, grid in found if path[-1] == "Internal"])
                if names is None:
                    patches = {}
                    for path, grid in found:
                        if "Patches" in path and path[-1].split("_")[0] != "axis":
                            family = path[-1].split("_")[0]
                            patches[family] = patches.get(family, 0) + grid.GetNumberOfCells()
                    self.assertEqual(patches, {name: len(cells) for name, cells in mesh.sides.items()})

    def test_plot3d(self):
        for mesh in self.meshes():
            self.write(mesh, "a.xyz")
            reader = vtkMultiBlockPLOT3DReader()
            reader.SetFileName(self.path("a.xyz"))
            reader.BinaryFileOff()
            reader.MultiGridOn()
            reader.DoublePrecisionOn()
            reader.SetTwoDimensionalGeometry(mesh.dimension == 2)
            reader.Update()
            output = reader.GetOutput()
            self.expect_blocks(mesh, [output.GetBlock(i) for i in range(output.GetNumberOfBlocks())])
            with open(self.path("a.nmf"), encoding="ascii") as file:
                lines = [line.split() for line in file if line.startswith("'")]
            self.expect_map(mesh, [output.GetBlock(i) for i in range(output.GetNumberOfBlocks())], lines)

    def expect_map(self, mesh, grids, lines):
        """Expects that both ranges of a connection have the same points and that sides have all their faces."""
        blocks = []
        for grid in grids:
            size = [0, 0, 0]
            grid.GetDimensions(size)
            blocks.append(points_of(grid).reshape(size[2], size[1], size[0], 3).transpose(2, 1, 0, 3))

        def face(numbers):
            block, number, *ends = map(int, numbers)
            across = {1: 2, 2: 2, 3: 0, 4: 0, 5: 1, 6: 1}[number]
            points = np.moveaxis(blocks[block - 1], [across, (across + 1) % 3, (across + 2) % 3], [0, 1, 2])
            points = points[0 if number % 2 else -1]
            for axis, (first, last) in enumerate((ends[:2], ends[2:])):
                step = 1 if last >= first else -1
                points = np.take(points, np.arange(first - 1, last - 1 + step, step), axis)
            return points

        sides, inner = {}, 0
        for line in lines:
            name, first = line[0].strip("'"), face(line[1:7])
            count = max(1, first.shape[0] - 1) * max(1, first.shape[1] - 1)
            if name == "ONE_TO_ONE":
                second = face(line[7:13])
                inner += 2 * count
                self.assertTrue((first == (second.transpose(1, 0, 2) if line[13] == "'TRUE'" else second)).all())
            else:
                sides[name] = sides.get(name, 0) + count
        collapsed = sides.pop("COLLAPSED", 0)
        self.assertEqual(sides, {name: len(cells) for name, cells in mesh.sides.items()})
        size = sum(sum(np.prod([max(1, n - 1) for d, n in enumerate(block.shape[:3]) if d != across]) * 2
                       for across in range(mesh.dimension)) for block in blocks)
        self.assertEqual(sum(sides.values()) + inner + collapsed, size, "every face is in one line")

    def raised(self, order):
        mesh = crossfield.quads("builtin:disk", count=60, order=order)
        yield Mesh(mesh.grid)
        extrude = vtkExtrudeQuads()
        extrude.SetInputData(mesh.grid)
        extrude.SetLayers(2)
        extrude.Update()
        yield Mesh(extrude.GetOutput())

    def test_exodus(self):
        for names in (None, NAMES):
            for mesh in [*self.meshes(names), *(self.raised(2) if names is None else [])]:
                for ending in (".ex2", ".exo", ".e"):
                    self.write(mesh, "a" + ending)
                reader = vtkExodusIIReader()
                reader.SetFileName(self.path("a.e"))
                reader.UpdateInformation()
                reader.SetObjectStatus(reader.ELEM_BLOCK, 0, 1)
                self.assertEqual(reader.GetObjectName(reader.ELEM_BLOCK, 0), "domain")
                sets = reader.GetNumberOfObjects(reader.SIDE_SET)
                self.assertEqual(sets, len(mesh.sides))
                for i in range(sets):
                    reader.SetObjectStatus(reader.SIDE_SET, i, 1)
                reader.Update()
                found = list(leaves(reader.GetOutput()))
                (path, cells), *sides = found
                self.assertEqual((path[-1], cells.GetNumberOfCells()), ("domain", len(mesh.cells)))
                self.assertEqual(rows(points_of(cells)), single(mesh.places(mesh.cells)), "this reader has floats")
                for (path, grid), (name, faces) in zip(sides, mesh.sides.items()):
                    if names is None:
                        self.assertEqual(path[-1], name)
                    self.assertLessEqual(len(path[-1].encode()), 32)
                    self.assertEqual(grid.GetNumberOfCells(), len(faces))
                    self.assertEqual(set(rows(points_of(grid))), set(single(mesh.places(faces))))
                self.expect_same_cells(mesh, cells)

    def expect_same_cells(self, mesh, grid):
        """Expects cells of the same points in an order of the same meaning: the points are where VTK has them."""
        for number in (0, grid.GetNumberOfCells() // 2):
            cell, expected = grid.GetCell(number), mesh.grid.GetCell(mesh.cells[number])
            if expected.GetNumberOfPoints() != cell.GetNumberOfPoints():
                continue  # a prism
            for i in range(cell.GetNumberOfPoints()):
                self.assertEqual(*(single([c.GetPoints().GetPoint(i)]) for c in (cell, expected)))

    def test_legacy_vtk(self):
        for mesh in [*self.meshes(NAMES), *self.raised(2)]:
            self.write(mesh, "a.vtk")
            reader = vtkUnstructuredGridReader()
            reader.SetFileName(self.path("a.vtk"))
            reader.Update()
            again = reader.GetOutput()
            self.assertEqual(again.GetNumberOfCells(), mesh.grid.GetNumberOfCells())
            self.assertTrue((points_of(again) == points_of(mesh.grid)).all())
            found = again.GetCellData().GetArray("Side")
            self.assertIsNone(vtkStringArray.SafeDownCast(found), "other programs do not read texts")
            numbers = [{found.GetValue(i) for i in cells} for cells in mesh.sides.values()]
            self.assertEqual([len(of) for of in numbers], len(numbers) * [1])
            self.assertEqual(len(set.union(*numbers)), len(numbers))
            self.assertEqual(again.GetFieldData().GetAbstractArray("SideNames"), None)

    def test_a_thousand_names(self):
        mesh = crossfield.quads([(0, 0), (600, 0), (600, 1), (0, 1)], count=600)
        grid = mesh.grid
        array = grid.GetCellData().GetAbstractArray("Side")
        lines = [i for i in range(array.GetNumberOfValues()) if array.GetValue(i)]
        self.assertGreater(len(lines), 1000)
        for number, line in enumerate(lines):
            array.SetValue(line, "the same beginning of a long name " + str(number % 1000))
        for name in ("a.cgns", "a.xyz", "a.ex2"):
            if vtkQuadMeshWriter.ReasonAgainst(name, 1) == "":
                mesh.write(self.path(name))
        reader = vtkExodusIIReader()
        reader.SetFileName(self.path("a.ex2"))
        reader.UpdateInformation()
        names = {reader.GetObjectName(reader.SIDE_SET, i) for i in range(reader.GetNumberOfObjects(reader.SIDE_SET))}
        self.assertEqual(len(names), 1000)
        if os.path.exists(self.path("a.cgns")):
            reader = vtkCGNSReader()
            reader.SetFileName(self.path("a.cgns"))
            reader.UpdateInformation()
            self.assertEqual(len({reader.GetFamilyArrayName(i) for i in range(reader.GetNumberOfFamilyArrays())}), 1000)


if __name__ == "__main__":
    unittest.main()
