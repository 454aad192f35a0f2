"""Cases of seamless maps, separatrices and patches that are corrupted in one place."""
import numpy as np

from corrupting import of

SEAMS = "seams close"
AREA = "the area is that of the domain"
TURNED = ("no triangle is turned over", "Flips")
PAIRED = "seams are the same from both sides"
SIDES = "sides are straight"
ANGLES = "angles add up to (4 - k) or (2 - k) quarter turns"
ALONG = "lines are along an axis in every triangle"
AHEAD = "lines go straight on across the sides of triangles"
LENGTH = "Length of lines"
RIGHT = "lines leave singularities at right angles of the map"
FACES = ("triangles of a face use its points", "no triangle of a face is turned over",
         "triangles fill their faces", "faces fill the domain")
IN_MAP = ("sides of faces are along an axis of the map", "UV of a face has the lengths of the map")
ONCE = "UV of a face runs once around its rectangle"
RECTANGLES = "rectangles have the area of the domain"
BOUNDARY = "edges of one face only make up the boundary"


def _apart(file):
    """Returns a point that is on no seam, side, singularity or separatrix."""
    vertex = file.point("VertexId")
    copies = np.bincount(vertex)[vertex]
    near = np.zeros(len(vertex), bool)
    near[file.data.lines.ravel()] = True
    near |= (copies > 1) | (file.point("QuarterIndex") != 0)
    passed = np.concatenate([arrays.points[:, :2] for arrays in file.beside.values()])
    free = np.flatnonzero(~near)
    gap = [np.abs(passed - place).max(axis=1).min() for place in file.points[free, :2]]
    return free[int(np.argmax(gap))]


@of("map", *TURNED, ANGLES)
def map_turned_over(file):
    point = _apart(file)
    around = file.data.triangles[(file.data.triangles == point).any(axis=1)]
    uv = file.point("UV")
    far = around[around != point][0]
    uv[point] += 1.5 * (uv[far] - uv[point])


@of("map", AREA, SEAMS, IN_MAP[1])
def map_stretched(file):
    file.point("UV")[:] *= 1.0 + 1e-6


@of("map", SEAMS)
def translation_of_a_seam_changed(file):
    file.report("SeamTranslation")[:2] += 1e-9


@of("map", PAIRED, SEAMS)
def seam_on_one_side(file):
    seam = file.cell("Seam")
    inner = np.argwhere(seam == 0)
    triangles = len(file.data.triangles)
    t, i = inner[(inner[:, 0] < triangles)][triangles // 2]
    seam[t, i] = 1


@of("map", "sides have their directions", SIDES)
def direction_of_a_side_changed(file):
    direction = file.cell("Direction")
    direction[len(file.data.triangles)] = (direction[len(file.data.triangles)] + 1) % 4


@of("map", "copies of a vertex are at its place")
def copy_of_a_vertex_moved(file):
    vertex = file.point("VertexId")
    file.points[np.flatnonzero(np.bincount(vertex)[vertex] > 1)[-1], 0] += 1e-13


@of("map", ALONG, AHEAD, LENGTH)
def point_of_a_line_moved(file):
    traced = file.beside["lines"]
    traced.points[traced.grid.GetCell(0).GetPointId(2)] += 1e-4


@of("map", ALONG, LENGTH, RIGHT)
def line_leaves_its_singularity_askew(file):
    traced = file.beside["lines"]
    traced.points[traced.grid.GetCell(0).GetPointId(1)] += 1e-3


@of("map", ALONG, LENGTH, "lines are inside the domain")
def line_goes_on_outside(file):
    traced = file.beside["lines"]
    cell = traced.grid.GetCell(int(np.flatnonzero(traced.cell("EndsAt") == 2)[0]))
    traced.points[cell.GetPointId(cell.GetNumberOfPoints() - 1), :2] *= 1.3


@of("map", LENGTH)
def length_of_a_line_changed(file):
    file.beside["lines"].cell("Length")[3] += 1e-5


@of("map", "4 - k lines leave every singularity")
def line_of_another_singularity(file):
    file.beside["lines"].cell("Singularity")[0] = -1


@of("map", "Faces")
def face_not_counted(file):
    file.beside["faces"].report("Faces")[0] += 1


@of("map", RECTANGLES, ONCE)
def size_of_a_face_changed(file):
    faces = file.beside["faces"]
    largest = faces.cell("FaceId")[np.argmax(faces.cell("USize") * faces.cell("VSize"))]
    faces.cell("USize")[faces.cell("FaceId") == largest] *= 1.0 + 1e-6


@of("map", IN_MAP[1], ONCE)
def uv_of_a_face_changed(file):
    faces = file.beside["faces"]
    faces.point("UV")[np.flatnonzero(faces.point("NodeKind") == 0)[4]] += 1e-6


@of("map", FACES[1], FACES[3], *IN_MAP, BOUNDARY)
def point_of_a_face_moved(file):
    faces = file.beside["faces"]
    point = np.flatnonzero(faces.point("NodeKind") == 0)[4]
    faces.points[point, :2] += 0.2


@of("map", FACES[0], FACES[2])
def triangle_of_another_face(file):
    faces = file.beside["faces"]
    faces.cell("FaceId")[5] = faces.cell("FaceId")[-1]
