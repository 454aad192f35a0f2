"""Draws quads on surfaces in space with VTK, for the scripts of this folder."""
import vtk


def read_quads(path):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def lines_of(port, colour, width):
    """Returns an actor of lines that lighting does not change."""
    mapper = vtk.vtkDataSetMapper()
    mapper.SetInputConnection(port)
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetLineWidth(width)
    actor.GetProperty().LightingOff()
    return actor


def marked_lines(grid):
    """Returns a filter with the boundary, sharp edges and lines between regions."""
    marked = vtk.vtkThreshold()
    marked.SetInputData(grid)
    marked.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS, "BoundaryKind")
    marked.SetThresholdFunction(vtk.vtkThreshold.THRESHOLD_UPPER)
    marked.SetUpperThreshold(0.5)
    return marked


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


def add_quads(path, window, viewport, direction, zoom):
    """Draws the quads of a file in a viewport of the window, seen from a direction."""
    grid = read_quads(path)
    renderer = vtk.vtkRenderer()
    renderer.SetViewport(*viewport)
    renderer.SetBackground(1, 1, 1)
    mapper = vtk.vtkDataSetMapper()
    mapper.SetInputData(grid)
    mapper.ScalarVisibilityOff()
    mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 1)
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    quads = vtk.vtkActor()
    quads.SetMapper(mapper)
    quads.GetProperty().SetColor(0.86, 0.88, 0.92)
    renderer.AddActor(quads)
    edges = vtk.vtkExtractEdges()
    edges.SetInputData(grid)
    renderer.AddActor(lines_of(edges.GetOutputPort(), (0.25, 0.3, 0.4), 1))
    renderer.AddActor(lines_of(marked_lines(grid).GetOutputPort(), (0.1, 0.1, 0.15), 2.5))
    add_nodes(grid, renderer, 0.014 * max(b - a for a, b in zip(grid.GetBounds()[::2], grid.GetBounds()[1::2])))
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetPosition(*direction)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    camera.Zoom(zoom)
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
