"""crossfield quads of meshes of several materials: input, report, files of solvers, and CalculiX on a bimetal strip."""
import collections
import json
import math
import pathlib
import re
import shutil
import subprocess
import unittest

from program import ProgramTest

REGIONS = pathlib.Path(__file__).resolve().parent.parent / "data" / "regions"

try:
    import meshio
except ImportError:
    meshio = None


def msh(nodes, faces, lines, names):
    """Returns a mesh of Gmsh, format 2.2: faces and lines are (group, nodes), `names` are (dimension, group, name)."""
    elements = [(1, *line) for line in lines] + [(3 if len(f[1]) == 4 else 2, *f) for f in faces]
    rows = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names))]
    rows += ['%d %d "%s"' % name for name in names] + ["$EndPhysicalNames", "$Nodes", str(len(nodes))]
    rows += ["%d %.17g %.17g 0" % (i + 1, *node) for i, node in enumerate(nodes)] + ["$EndNodes", "$Elements", str(len(elements))]
    rows += ["%d %d 2 %d %d %s" % (i + 1, kind, group, group, " ".join(str(n + 1) for n in corners))
             for i, (kind, group, corners) in enumerate(elements)]
    return "\n".join(rows + ["$EndElements", ""])


def strip(length, heights, columns=10):
    """Returns a mesh of layers of a length, one of each height, with a group for each, and named lines on the left."""
    levels = [sum(heights[:i]) for i in range(len(heights) + 1)]
    nodes = [(length * i / columns, y) for y in levels for i in range(columns + 1)]
    row = columns + 1
    faces = [(j + 1, (j * row + i, j * row + i + 1, (j + 1) * row + i + 1, (j + 1) * row + i))
             for j in range(len(heights)) for i in range(columns)]
    lines = [(11, (j * row, (j + 1) * row)) for j in range(len(heights))] + [(12, (i, i + 1)) for i in range(columns)]
    materials = ("steel", "copper", "tin")
    names = [(2, j + 1, materials[j]) for j in range(len(heights))] + [(1, 11, "left"), (1, 12, "bottom")]
    return msh(nodes, faces, lines, names)


class Regions(ProgramTest):
    def quads(self, domain, file, *arguments):
        return json.loads(self.succeed("quads", domain, "-o", file, "--json", "-", *arguments))

    def test_physical_surfaces_are_materials(self):
        (self.folder / "strip.msh").write_text(strip(4, (1, 0.5, 1)))
        report = self.quads("strip.msh", "quads.vtu", "--quads", "400")
        self.assertEqual([region["name"] for region in report["regions"]], ["steel", "copper", "tin"])
        self.assertEqual(sum(region["quads"] for region in report["regions"]), report["quads"])
        for region in report["regions"]:
            self.assertEqual((region["required_interior_quarters"], region["given_interior_quarters"]), (0, 0))
        self.assertEqual((report["irregular"], report["blocks"]), ({}, 3))
        self.assertGreater(report["scaled_jacobian"]["min"], 1 - 1e-9)
        self.assertEqual([interface["name"] for interface in report["interfaces"]], ["steel+copper", "copper+tin"])
        for interface in report["interfaces"]:
            self.assertLessEqual(interface["size_ratio"]["median"], interface["size_ratio"]["max"])
            self.assertGreaterEqual(interface["size_ratio"]["median"], 1)
            self.assertLess(interface["size_ratio"]["max"], 1.5)
        sides = {side["name"]: side for side in report["sides"]}
        self.assertLessEqual({"steel+copper", "copper+tin", "left", "bottom"}, set(sides))
        self.assertEqual(sides["steel+copper"]["edges"], sides["bottom"]["edges"])
        self.assertAlmostEqual(sides["left"]["length"], 2.5)
        self.assertIn("3 regions of 3 materials: steel, copper, tin\n",
                      self.succeed("quads", "strip.msh", "-o", "quads.vtu", "--quads", "400"))
        counted = self.quads("strip.msh", "quads.vtu", "--quads", "333", "--count", "tin+copper:37", "--count", "left:9")
        self.assertEqual({side["name"]: side["edges"] for side in counted["sides"]}["copper+tin"], 37)
        whole = self.quads("strip.msh", "quads.vtu", "--quads", "400", "--materials", "none")
        self.assertNotIn("regions", whole)

    def test_check_counts_each_region(self):
        sectors = [[(math.cos(a), math.sin(a)) for a in (2 * math.pi / 3 * (i + j / 24) for j in range(25))] for i in range(3)]
        nodes = [(0.0, 0.0)] + [point for sector in sectors for point in sector[:-1]]
        faces = [(i + 1, (0, 1 + 24 * i + j, 1 + (24 * i + j + 1) % 72)) for i in range(3) for j in range(24)]
        (self.folder / "y.msh").write_text(msh(nodes, faces, [], [(2, i + 1, name) for i, name in enumerate("abc")]))
        process = self.run_program("check", "y.msh", "--json", "counts.json")
        self.assertEqual(process.returncode, 1, process.stderr)
        self.assertIn("Material 'a' near (", process.stderr)
        self.assertIn("The node of regions at (0, 0) (3 quads) is an irregular node of the mesh.", process.stderr)
        report = json.loads((self.folder / "counts.json").read_text())
        self.assertEqual(report["regions"], [{"name": name, "required_interior_quarters": 1, "given_interior_quarters": 0}
                                             for name in "abc"])
        (self.folder / "s.csv").write_text("x,y,quarter_index\n" + "".join(
            "%g,%g,1\n" % (0.5 * math.cos(a), 0.5 * math.sin(a)) for a in (math.pi / 3 * k for k in (1, 3, 5))))
        report = json.loads(self.succeed("check", "y.msh", "-s", "s.csv", "--json", "-"))
        self.assertTrue(report["consistent"])
        self.assertEqual([region["given_interior_quarters"] for region in report["regions"]], [1, 1, 1])
        self.assertIn("  b: required 1, given 1\n", self.succeed("check", "y.msh", "-s", "s.csv"))
        self.assertNotIn("regions", json.loads(self.run_program("check", "y.msh", "--materials", "none", "--json", "-").stdout))
        self.refuse("check", "y.msh", "--propose", "p.csv", says=("leave out --propose",))

    def test_singularities_may_reach_an_interface(self):
        # The lake has one on its shore, which is an irregular node of the whole mesh.
        report = self.quads(REGIONS / "lake_in_coast.vtp", "quads.vtu", "--size", "0.25")
        self.assertEqual(report["irregular"], report["asked"])
        # Between two points of the outer boundary.
        (self.folder / "strip.msh").write_text(strip(4, (1, 1)))
        (self.folder / "s.csv").write_text("x,y,quarter_index\n0.9,0,-1\n1.1,0.55,1\n")
        given = self.quads("strip.msh", "quads.vtu", "--quads", "400", "-s", "s.csv")
        self.assertEqual(given["irregular"], {"3": 1})
        for region in report["regions"] + given["regions"]:
            self.assertEqual(region["required_interior_quarters"], region["given_interior_quarters"])

    def test_counts_are_symmetric_and_reach_all_sides(self):
        report = self.quads(REGIONS / "pipe.vtp", "quads.vtu", "--size", "0.15", "--curves", "auto",
                            "--count", "insulation+steel:72")
        edges = {side["name"]: side["edges"] for side in report["sides"]}
        self.assertEqual((edges["steel+insulation"], edges["insulation+soil"]), (72, 72))
        self.assertEqual(edges["outer1"], edges["outer3"])
        self.assertLess(edges["outer2"], 1.6 * edges["outer0"])

    def test_sizes_in_materials_are_targets(self):
        lakes = REGIONS / "lakes.vtp"
        report = json.loads(self.run_program("quads", lakes, "-o", "q.vtu", "--size", "0.16", "--size-in", "lake:0.08",
                                             "--json", "-").stdout)
        self.assertGreater(report["size_target"]["area_share"], 0.8)
        self.refuse("quads", lakes, "-o", "q.vtu", "--size-in", "pond:0.1",
                    says=("no material or side 'pond'", "'sea', 'land', 'lake'"))

    def test_attainable_shape_knows_the_angles_of_regions(self):
        oblique = msh([(0, 0), (1, 0), (2, 0), (2, 1), (1.5, 1), (0, 1)], [(1, (0, 1, 4, 5)), (2, (1, 2, 3, 4))], [],
                      [(2, 1, "a"), (2, 2, "b")])
        (self.folder / "oblique.msh").write_text(oblique)
        jacobian = self.quads("oblique.msh", "quads.vtu", "--quads", "300")["scaled_jacobian"]
        self.assertAlmostEqual(jacobian["bound"], 2 / math.sqrt(5), 6)
        self.assertAlmostEqual(jacobian["min"], 2 / math.sqrt(5), 4)

    def test_periodic_cells_of_a_fibre(self):
        report = self.quads(REGIONS / "fibre_hexagonal.vtp", "cell.inp", "--quads", "600", "--curves", "auto", "--order", "2",
                            "--periodic", "outer0:outer3", "--periodic", "outer1:outer4", "--periodic", "outer2:outer5")
        self.assertEqual(len(report["periodic"]), 3)
        edges = {side["name"]: side["edges"] for side in report["sides"]}
        for pair in report["periodic"]:
            self.assertLess(pair["mismatch"], 1e-12)
            self.assertEqual(edges[pair["first"]], edges[pair["second"]])
        self.assertIn("*EQUATION", (self.folder / "cell.inp").read_text())
        self.refuse("quads", REGIONS / "fibre_square.vtp", "-o", "q.vtu", "--periodic", "outer0:outer4",
                    says=("are not both of this region",))

    def test_blocks_are_merged_in_place(self):
        lakes = (REGIONS / "lakes.vtp", "quads.vtu", "--quads", "3000")
        kept = self.quads(*lakes)
        merged = self.quads(*lakes, "--merge", "coarse")
        self.assertLess(merged["blocks"], 0.7 * kept["blocks"])
        self.assertEqual((merged["inverted"], merged["irregular"]), (0, kept["irregular"]))
        self.assertEqual(merged["blocks_by_merge"], {"coarse": merged["blocks"]})

    def test_a_sharp_tip_has_a_remedy_that_works(self):
        def wedge(length):
            """Returns a square with a wedge of 1.4 degrees, whose tip is cut off at this length."""
            height = 0.05 * length / 2
            return msh([(length, 0), (2, 0), (2, 0.05), (2, 1), (0, 1), (0, 0), (length, height)],
                       [(1, (0, 1, 2, 6)), (2, (6, 2, 3, 4)), (2, (6, 4, 5, 0))], [], [(2, 1, "a"), (2, 2, "b")])
        sharp = msh([(0, 0), (2, 0), (2, 0.05), (2, 1), (0, 1)], [(1, (0, 1, 2)), (2, (0, 2, 3, 4))], [],
                    [(2, 1, "a"), (2, 2, "b")])
        (self.folder / "sharp.msh").write_text(sharp)
        message = self.refuse("quads", "sharp.msh", "-o", "q.vtu", "--quads", "300", says=("Material 'a'", "cut off its corners"))
        length = float(re.search(r"45° ([0-9.]+) before", message).group(1))
        (self.folder / "cut.msh").write_text(wedge(length))
        self.quads("cut.msh", "quads.vtu", "--quads", "300")

    def test_cells_that_touch_share_points(self):
        nodes = [(0, 0), (1, 0), (1, 1), (0, 1), (2, 0), (2, 0.5), (1, 0.5), (2, 1)]
        (self.folder / "t.msh").write_text(msh(nodes, [(1, (0, 1, 2, 3)), (2, (1, 4, 5, 6)), (3, (6, 5, 7, 2))], [],
                                               [(2, 1, "a"), (2, 2, "b"), (2, 3, "c")]))
        self.refuse("quads", "t.msh", "-o", "q.vtu", says=("The point at (1, 0.5) is on the edge of another cell",))

    def test_closed_curves_of_a_drawing_bound_materials(self):
        (self.folder / "pipe.svg").write_text(
            '<svg xmlns="http://www.w3.org/2000/svg" viewBox="-9 -9 90 90"><rect id="soil" width="40" height="30"/>'
            '<circle id="wool" cx="20" cy="18" r="8"/><circle id="steel" cx="20" cy="18" r="5"/>'
            '<circle id="hole" cx="20" cy="18" r="4"/></svg>')
        report = self.quads("pipe.svg", "quads.vtu", "--materials", "curves", "--curves", "auto", "--quads", "900")
        self.assertEqual([region["name"] for region in report["regions"]], ["soil", "wool", "steel"])
        self.assertEqual({side["name"] for side in report["sides"]}, {"soil", "wool", "steel", "hole"})
        # Given singularities that move are events, as on a domain of one material.
        (self.folder / "four.csv").write_text("x,y,quarter_index\n2,0,1\n-2,0,1\n0,2,1\n0,-2,1\n")
        (self.folder / "rod.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg" viewBox="-5 -5 10 10">'
                                             '<circle id="sleeve" r="5"/><circle id="rod" r="4"/></svg>')
        moved = self.quads("rod.svg", "quads.vtu", "--materials", "curves", "-s", "four.csv", "--count", "rod:32")
        self.assertGreater(moved["moved"], 1)
        self.assertEqual(sum("to its node at" in event for event in moved["events"]), len(moved["moves"]))
        self.assertNotIn("regions", self.quads("pipe.svg", "quads.vtu", "--quads", "900"))
        self.refuse("quads", "builtin:disk", "-o", "q.vtu", "--materials", "curves", says=("is no drawing",))

    def test_what_is_not_available_is_refused(self):
        (self.folder / "strip.msh").write_text(strip(4, (1, 1)))
        for arguments, cause in ((("--merge", "clean"), "Moves of singularities that merge blocks are not available for several materials"),
                                 (("--periodic", "left:outer0"), "'left'"),
                                 (("--layers", "bottom:0.01"), "Boundary layers are not available for several materials"),
                                 (("--smooth-boundary", "0.1"), "The boundary of a domain of several materials or with lines is not simplified"),
                                 (("--materials", "Grain"), "The domain has no cell array 'Grain'")):
            self.refuse("quads", "strip.msh", "-o", "quads.vtu", *arguments, says=(cause,))

    @unittest.skipUnless(meshio, "meshio is not installed")
    def test_files_have_groups_of_materials_and_interfaces(self):
        (self.folder / "strip.msh").write_text(strip(4, (1, 1)))
        report = self.quads("strip.msh", "a.msh", "--quads", "200", "--order", "2")
        quads = {region["name"]: region["quads"] for region in report["regions"]}
        mesh = meshio.read(self.folder / "a.msh")
        groups = {name: int(data[0]) for name, data in mesh.field_data.items()}
        self.assertLessEqual({"steel", "copper", "steel+copper", "left", "bottom"}, set(groups))
        found = collections.Counter(mesh.cell_data_dict["gmsh:physical"]["quad9"])
        self.assertEqual({name: found[groups[name]] for name in quads}, quads)
        # Every edge of the interface is one of a quad of each material.
        edges = mesh.cells_dict["line3"][mesh.cell_data_dict["gmsh:physical"]["line3"] == groups["steel+copper"]]
        owners = collections.defaultdict(set)
        for quad, group in zip(mesh.cells_dict["quad9"], mesh.cell_data_dict["gmsh:physical"]["quad9"]):
            for i in range(4):
                owners[frozenset((quad[i], quad[(i + 1) % 4]))].add(group)
        self.assertTrue(all(len(owners[frozenset(edge[:2])]) == 2 for edge in edges))
        for file in ("a.inp", "a.ex2", "a.xyz", "case/"):
            self.quads("strip.msh", file, "--quads", "200")
        self.assertIn("ELSET=steel", (self.folder / "a.inp").read_text())
        zones = (self.folder / "case/constant/polyMesh/cellZones").read_text()
        self.assertTrue("steel" in zones and "copper" in zones)
        self.assertNotIn("copper", (self.folder / "case/constant/polyMesh/boundary").read_text())
        self.refuse("quads", "strip.msh", "-o", "a.su2", says=("no regions",))

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_a_bimetal_strip_bends_as_timoshenko_says(self):
        """Curvature of two heated layers, plane stress, slenderness 20."""
        length, thickness, heat = 20.0, (0.4, 0.6), 100.0
        moduli, expansions = (200e3, 120e3), (12e-6, 17e-6)  # below and above
        (self.folder / "strip.msh").write_text(strip(length, thickness))
        self.quads("strip.msh", "a.inp", "--size", "0.1", "--order", "2")
        mesh = (self.folder / "a.inp").read_text()
        materials = "".join("*MATERIAL, NAME=%s\n*ELASTIC\n%g, 0.3\n*EXPANSION\n%g\n*SOLID SECTION, ELSET=%s, MATERIAL=%s\n%g\n"
                            % (name, modulus, expansion, name, name, 0.01 * length)
                            for name, modulus, expansion in zip(("steel", "copper"), moduli, expansions))
        nodes = {int(row[0]): (float(row[1]), float(row[2])) for row in (
            line.split(",") for line in mesh.split("*NODE, NSET=NALL\n")[1].split("*")[0].split("\n")[:-1])}
        corner = min(nodes, key=lambda node: math.hypot(*nodes[node]))
        (self.folder / "a.inp").write_text(mesh + materials + """*INITIAL CONDITIONS, TYPE=TEMPERATURE
NALL, 0
*BOUNDARY
left, 1, 1
%d, 2, 2
*STEP
*STATIC
*TEMPERATURE
NALL, %g
*NODE PRINT, NSET=bottom
U
*END STEP
""" % (corner, heat))
        subprocess.run(["ccx", "a"], cwd=self.folder, check=True, capture_output=True)
        rows = [row.split() for row in (self.folder / "a.dat").read_text().splitlines() if re.match(r" +\d+ +[-\d]", row)]
        deflection = sorted((nodes[int(row[0])][0], float(row[2])) for row in rows)
        self.assertGreater(len(deflection), 100)

        def at(x):
            return min(deflection, key=lambda one: abs(one[0] - x))
        (x0, v0), (x1, v1), (x2, v2) = (at(length * part) for part in (0.4, 0.5, 0.6))
        curvature = 2 * ((v2 - v1) / (x2 - x1) - (v1 - v0) / (x1 - x0)) / (x2 - x0)
        m, n = thickness[0] / thickness[1], moduli[0] / moduli[1]
        expected = (6 * (expansions[1] - expansions[0]) * heat * (1 + m)**2
                    / (sum(thickness) * (3 * (1 + m)**2 + (1 + m * n) * (m**2 + 1 / (m * n)))))
        self.assertLess(abs(abs(curvature) / expected - 1), 0.01)


if __name__ == "__main__":
    unittest.main()
