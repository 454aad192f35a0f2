"""crossfield quads --extrude and --revolve: volumes, files of solvers, CalculiX, and refusals."""
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

from program import PROGRAM, ProgramTest
from test_sides import RECTANGLE, circle, write_domain

try:
    import meshio
except ImportError:
    meshio = None

ROOT = pathlib.Path(__file__).resolve().parents[2]


def volume(corners):
    """Returns the volume of a hexahedron or prism in the order of Gmsh, divided into tetrahedra at its middle."""
    faces = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)] if len(corners) == 8 else [
        (0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)]
    middle = [sum(x) / len(corners) for x in zip(*corners)]
    total = 0.0
    for face in faces:
        centre = [sum(corners[i][d] for i in face) / len(face) for d in range(3)]
        for i, j in zip(face, face[1:] + face[:1]):
            a, b, c = ([p - m for p, m in zip(q, middle)] for q in (corners[i], corners[j], centre))
            total += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                      + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
    return total


class Sweeps(ProgramTest):
    def setUp(self):
        super().setUp()
        write_domain(self.folder / "plate.vtp", [RECTANGLE, circle(24, 0.4, (1.4, 1.0), lambda i: "hole")])
        write_domain(self.folder / "plain.vtp", [RECTANGLE])

    def quads(self, domain, file, *arguments):
        return json.loads(self.succeed("quads", domain, "-o", file, "--quads", "100", "--json", "-", *arguments))

    def stresses(self, mesh, supports, loads):
        """Returns the stresses that CalculiX finds, six at each integration point, those along the axes first."""
        (self.folder / "a.inp").write_text(mesh + """*MATERIAL, NAME=m
*ELASTIC
1000, 0.3
*SOLID SECTION, ELSET=domain, MATERIAL=m
*BOUNDARY
%s
*STEP
*STATIC
*DLOAD
%s
*EL PRINT, ELSET=domain
S
*END STEP
""" % ("\n".join(supports), "\n".join(loads)))
        subprocess.run(["ccx", "a"], cwd=self.folder, check=True, capture_output=True)
        found = [tuple(map(float, row.split()[2:8])) for row in (self.folder / "a.dat").read_text().splitlines()
                 if re.match(r" +\d+ +\d+ ", row)]
        self.assertGreater(len(found), 400)
        return found

    @unittest.skipUnless(meshio, "meshio is not installed")
    def test_extruded_and_revolved_meshes_have_their_volume(self):
        area = 6 - 12 * 0.16 * math.sin(math.pi / 12)
        report = self.quads("plate.vtp", "a.msh", "--extrude", "0.5,3")
        self.assertEqual(report["sweep"], {"hexahedra": 3 * report["quads"], "layers": 3})
        for file in ("a.msh", "a.su2"):
            if file != "a.msh":
                self.quads("plate.vtp", file, "--extrude", "0.5,3")
            mesh = meshio.read(self.folder / file)
            volumes = [volume([list(mesh.points[i]) for i in row]) for row in mesh.cells_dict["hexahedron"]]
            self.assertGreater(min(volumes), 0)
            self.assertLess(abs(sum(volumes) / (area * 0.5) - 1), 0.02, "the polygon has chords of quads")
        report = self.quads("plain.vtp", "b.msh", "--revolve", "360,40")
        mesh = meshio.read(self.folder / "b.msh")
        cells = [*mesh.cells_dict["hexahedron"], *mesh.cells_dict["wedge"]]
        self.assertEqual(len(cells), 40 * report["quads"])
        volumes = [volume([list(mesh.points[i]) for i in row]) for row in cells]
        self.assertGreater(min(volumes), 0)
        self.assertLess(abs(sum(volumes) / (math.pi * 4 * 3) - 1), 0.005)
        self.assertEqual(set(mesh.field_data), {"right", "top", "left", "domain"})
        # About y = −1 the rectangle of 3 × 2 is a ring. The last of three layers is four times as high as the first.
        self.quads("plain.vtp", "c.msh", "--revolve", "90,24,0,-1,1,-1")
        mesh = meshio.read(self.folder / "c.msh")
        volumes = [volume([list(mesh.points[i]) for i in row]) for row in mesh.cells_dict["hexahedron"]]
        self.assertLess(abs(sum(volumes) / (math.pi / 4 * (3**2 - 1) * 3) - 1), 0.005)
        self.quads("plain.vtp", "d.msh", "--extrude", "7,3,4")
        heights = sorted({round(z, 9) for z in meshio.read(self.folder / "d.msh").points[:, 2]})
        self.assertEqual(heights, [0, 1, 3, 7])

    def test_the_grid_and_its_blocks(self):
        report = self.quads("plate.vtp", "a.vtu", "--extrude", "0.5,3", "--blocks", "b.vtm")
        self.assertEqual(len(list((self.folder / "b").glob("*.vts"))), report["blocks"])
        self.assertIn(f'NumberOfCells="{5 * report["quads"] + 3 * sum(s["edges"] for s in report["sides"])}"',
                      (self.folder / "a.vtu").read_text())
        output = self.succeed("quads", "plain.vtp", "-o", "c.vtu", "--quads", "60", "--revolve", "10")
        self.assertRegex(output, r"(?m)^\d+ hexahedra in 1 layer$")

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_calculix_stretches_solids(self):
        """Patch test: uniform tension on hexahedra of order 1 and 2."""
        for arguments in (("--extrude", "0.5,2"), ("--extrude", "0.5,2", "--order", "2")):
            self.quads("plain.vtp", "a.inp", *arguments)
            mesh = (self.folder / "a.inp").read_text()
            rows = mesh.split("*SURFACE, NAME=top, TYPE=ELEMENT\n")[1].split("*")[0].replace("S", "P").split("\n")[:-1]
            stresses = self.stresses(mesh, ("bottom, 2, 2", "left, 1, 1", "back, 3, 3"), [row + ", -1" for row in rows])
            for xx, yy, zz, xy, yz, zx in stresses:
                self.assertLess(max(map(abs, (xx, yy - 1, zz, xy, yz, zx))), 1e-4)

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_prisms_and_their_faces_carry_a_pressure(self):
        """A cylinder under pressure on all of its outside has the stress −p in all directions."""
        for order, element in (("1", "C3D6"), ("2", "C3D15")):
            self.quads("plain.vtp", "a.inp", "--revolve", "90,6", "--order", order)
            mesh = (self.folder / "a.inp").read_text()
            self.assertIn("*ELEMENT, TYPE=%s, ELSET=domain\n" % element, mesh)
            loads = [row.replace("S", "P") + ", 1" for side in ("top", "right")
                     for row in mesh.split(f"*SURFACE, NAME={side}, TYPE=ELEMENT\n")[1].split("*")[0].split("\n")[:-1]]
            stresses = self.stresses(mesh, ("left, 1, 1", "back, 3, 3", "front, 2, 2"), loads)
            for stress in stresses:
                self.assertLess(max(abs(s + 1) for s in stress[:3]), 0.02, "the polygon is loaded on its facets")

    @unittest.skipUnless(shutil.which("gmsh"), "Gmsh is not installed")
    def test_gmsh_reads_prisms_of_order_2(self):
        """Volume of a cylinder, and no element that Gmsh finds inverted."""
        report = self.quads("plain.vtp", "b.msh", "--revolve", "360,12", "--order", "2")
        mesh = meshio.read(self.folder / "b.msh")
        self.assertEqual(len(mesh.cells_dict["hexahedron27"]) + len(mesh.cells_dict["wedge18"]), 12 * report["quads"])
        plugin = "Plugin(MeshVolume)."
        (self.folder / "b.geo").write_text('Merge "b.msh";\n%sPhysicalGroup = -1;\n%sDimension = 3;\n%sRun;\nSave View[0] "volume.txt";\n'
                                           % (plugin, plugin, plugin))
        subprocess.run(["gmsh", "-", "b.geo"], cwd=self.folder, check=True, capture_output=True)
        volume_of_gmsh = float((self.folder / "volume.txt").read_text().split()[-1])
        self.assertLess(abs(volume_of_gmsh / (math.pi * 4 * 3) - 1), 3e-4, "straight edges would lose 5 %")

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_example_of_a_bracket(self):
        output = subprocess.run(
            [sys.executable, ROOT / "examples/bracket/bracket.py", "--program", PROGRAM, "--size", "4", "3"],
            stdout=subprocess.PIPE, text=True, check=True).stdout
        found = [float(stress) for stress in re.findall(r"nodes: fillet (.*) MPa", output)]
        self.assertEqual(len(found), 2, output)
        self.assertLess(abs(found[0] / 50.8 - 1), 0.02)
        self.assertLess(abs(found[1] / 50.8 - 1), 0.01)

    def test_refusals(self):
        for arguments, says in ((("--extrude", "0"), "'0' is not a positive height"),
                                (("--extrude", "1,2.5"), "is not a positive height, a number of layers and a positive ratio"),
                                (("--extrude", "1,2,x"), "is not a positive height"),
                                (("--revolve", "361"), "is not an angle from 0 to 360"),
                                (("--extrude", "1,2,-3"), "is not a positive height"),
                                (("--revolve", "90,2,z"), "x, y or two points"),
                                (("--revolve", "90,2,1,1,1,1"), "x, y or two points"),
                                (("--revolve", "90", "--extrude", "1"), "excludes"),
                                (("--extrude", "1", "--order", "3"), "order 3 cannot be swept")):
            result = self.run_program("quads", "plain.vtp", "-o", "a.vtu", *arguments)
            self.assertEqual(result.returncode, 2, result.stdout)
            self.assertIn(says, result.stderr)
            self.assertFalse((self.folder / "a.vtu").exists())
        write_domain(self.folder / "crossing.vtp", [[(0, -1, "a"), (3, -1, "b"), (3, 1, "c"), (0, 1, "d")]])
        self.refuse("quads", "crossing.vtp", "-o", "a.vtu", "--revolve", "90", says=["both sides of the axis"])
        self.refuse("quads", "plain.vtp", "-o", "a.ex2", "--revolve", "90", "--order", "2", says=["prisms of order 2"])
