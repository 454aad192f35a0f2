"""Draws quads on surfaces in space with VTK, for the scripts of this folder."""
import numpy as np
import vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

# Pale colours of different tones, which distinguish adjacent regions.
PALE = [(0.86, 0.88, 0.92), (0.98, 0.87, 0.72), (0.80, 0.90, 0.80), (0.95, 0.82, 0.88), (0.99, 0.96, 0.75), (0.86, 0.83, 0.94), (0.80, 0.94, 0.93)]


def read_quads(path):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def lines_of(data, colour, width):
    """Returns an actor of lines that lighting does not change."""
    mapper = vtk.vtkDataSetMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetLineWidth(width)
    actor.GetProperty().LightingOff()
    return actor


def marked_lines(grid):
    """Returns the boundary, sharp edges and lines between regions."""
    marked = vtk.vtkThreshold()
    marked.SetInputData(grid)
    marked.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS, "BoundaryKind")
    marked.SetThresholdFunction(vtk.vtkThreshold.THRESHOLD_UPPER)
    marked.SetUpperThreshold(0.5)
    marked.Update()
    return marked.GetOutput()


def add_nodes(grid, renderer, radius):
    """Draws irregular nodes inside of faces, valence 3 or less in red, 5 or more in blue."""
    indices, sides = (grid.GetPointData().GetArray(name) for name in ("Irregular", "BoundarySide"))
    for point in range(grid.GetNumberOfPoints()):
        if indices.GetValue(point) != 0 and sides.GetValue(point) < 0:
            ball = vtk.vtkSphereSource()
            ball.SetCenter(grid.GetPoint(point))
            ball.SetRadius(radius)
            balls = vtk.vtkPolyDataMapper()
            balls.SetInputConnection(ball.GetOutputPort())
            actor = vtk.vtkActor()
            actor.SetMapper(balls)
            actor.GetProperty().SetColor(*((0.85, 0.2, 0.15) if indices.GetValue(point) > 0 else (0.15, 0.35, 0.85)))
            renderer.AddActor(actor)


def colour_regions(grid, mapper):
    """Gives each region a colour; without regions all quads have the first one."""
    names = grid.GetCellData().GetAbstractArray("Region")
    numbers, tones = {}, vtk.vtkUnsignedCharArray()
    tones.SetName("Tone")
    tones.SetNumberOfComponents(3)
    for cell in range(grid.GetNumberOfCells()):
        region = names.GetVariantValue(cell).ToString() if names and grid.GetCell(cell).GetCellDimension() == 2 else ""
        number = numbers.setdefault(region, len(numbers)) if region else 0
        tones.InsertNextTuple3(*(255 * part for part in PALE[number % len(PALE)]))
    grid.GetCellData().AddArray(tones)
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("Tone")
    mapper.SetColorModeToDirectScalars()


def extent(grid, direction):
    """Returns the centre of the grid seen from a direction, and half of its extent to the right, upwards and in depth in the picture."""
    forward = -np.array(direction, dtype=float) / np.linalg.norm(direction)
    right = np.cross(forward, (0, 0, 1))
    right /= np.linalg.norm(right)
    places = vtk_to_numpy(grid.GetPoints().GetData())
    centre, halves = np.zeros(3), []
    for axis in (right, np.cross(right, forward), forward):
        low, high = (places @ axis).min(), (places @ axis).max()
        centre += axis * (low + high) / 2
        halves.append((high - low) / 2)
    return centre, halves


def fit(camera, grid, direction, aspect, margin=1.06):
    """Places the camera so that the grid fills a picture of this aspect ratio."""
    centre, halves = extent(grid, direction)
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(centre + np.array(direction) / np.linalg.norm(direction) * (1 + 4 * max(halves))))
    camera.SetViewUp(0, 0, 1)
    camera.SetParallelScale(margin * max(halves[1], halves[0] / aspect))


def add_quads(path, window, viewport, direction):
    """Draws the quads of a file in a viewport of the window, seen from a direction."""
    grid = read_quads(path)
    renderer = vtk.vtkRenderer()
    renderer.SetViewport(*viewport)
    renderer.SetBackground(1, 1, 1)
    camera = renderer.GetActiveCamera()
    width, height = window.GetSize()
    aspect = (viewport[2] - viewport[0]) * width / ((viewport[3] - viewport[1]) * height)
    fit(camera, grid, direction, aspect)
    mapper = vtk.vtkDataSetMapper()
    colour_regions(grid, mapper)
    mapper.SetInputData(grid)
    mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 1)
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    quads = vtk.vtkActor()
    quads.SetMapper(mapper)
    quads.GetProperty().SetAmbient(0.2)
    quads.GetProperty().SetDiffuse(0.8)
    renderer.AddActor(quads)
    edges = vtk.vtkExtractEdges()
    edges.SetInputData(grid)
    edges.Update()
    renderer.AddActor(lines_of(edges.GetOutput(), (0.25, 0.3, 0.4), 1))
    renderer.AddActor(lines_of(marked_lines(grid), (0.1, 0.1, 0.15), 2.5))
    add_nodes(grid, renderer, 0.02 * aspect * camera.GetParallelScale())  # 1/50 of half of the picture's width
    renderer.ResetCameraClippingRange()
    window.AddRenderer(renderer)


def new_window(width, height):
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(width, height)
    return window


def save(window, path):
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
