"""Smooth bodies and sheets: levels of fields, deformed spheres, tubes."""
import math

import numpy as np
import vtk

from .triangles import ball, grid, level, smoothed


def sphere():
    return ball(14)


def bumpy():
    """Returns a body like a scan of a stone: a sphere with bumps of several sizes."""
    def place(p):
        x, y, z = p.T
        radius = 1 + 0.12 * np.sin(2.3 * x + 1.1 * y) + 0.1 * np.cos(2.9 * z - 1.7 * x) + 0.04 * np.sin(5.1 * y + 3.7 * z)
        return p * radius[:, None] * np.array([1.3, 1.0, 0.9])
    return ball(24, place)


def egg():
    """Returns an egg, whose radius of curvature is small at one end."""
    def place(p):
        x, y, z = p.T
        slim = 1 - 0.32 * z
        return np.stack([x * slim, y * slim, 1.6 * z], axis=1)
    return ball(24, place)


def torus():
    return grid(32, 64, lambda u, v: ((2 + 0.7 * np.cos(2 * np.pi * u)) * np.cos(2 * np.pi * v),
                                      (2 + 0.7 * np.cos(2 * np.pi * u)) * np.sin(2 * np.pi * v), 0.7 * np.sin(2 * np.pi * u)), True, True)


def rings(centres):
    """Returns tori that blend into each other."""
    def field(x, y, z):
        total = 0
        for a, b in centres:
            total = total + np.exp(-np.hypot(np.hypot(x - a, y - b) - 1, z) / 0.12)
        return 0.12 * np.log(total) + 0.42
    reach = max(math.hypot(*centre) for centre in centres) + 1.7
    return level(field, (-reach, -reach, -0.8), (reach, reach, 0.8), 0.1)


def two_rings():
    return rings([(-1.15, 0), (1.15, 0)])


def three_rings():
    return rings([(1.35 * math.cos(a), 1.35 * math.sin(a)) for a in (math.pi / 2, math.pi * 7 / 6, math.pi * 11 / 6)])


def frame_of_potentials():
    """Returns a level of a sum of potentials, through which a hole leads."""
    def field(x, y, z):
        return sum(0.2 / ((x - math.cos(a)) ** 2 + (y - math.sin(a)) ** 2 + z * z + 0.02)
                   for a in (2 * math.pi * k / 5 for k in range(5))) - 1
    return level(field, (-2, -2, -2), (2, 2, 2), 4 / 39)


def wavelet():
    """Returns the largest part of a level of VTK's wavelet. Lower levels reach the faces of the box, where parts end in thin wedges."""
    source = vtk.vtkRTAnalyticSource()
    source.SetWholeExtent(-20, 20, -20, 20, -20, 20)
    source.SetXFreq(20)
    source.SetYFreq(10)
    source.SetZFreq(13)
    contour = vtk.vtkFlyingEdges3D()
    contour.SetInputConnection(source.GetOutputPort())
    contour.SetValue(0, 200)
    contour.ComputeNormalsOff()
    part = vtk.vtkPolyDataConnectivityFilter()
    part.SetInputConnection(contour.GetOutputPort())
    part.SetExtractionModeToLargestRegion()
    clean = vtk.vtkCleanPolyData()
    clean.SetInputConnection(part.GetOutputPort())
    return smoothed(clean)


def aeroplane():
    """Returns a fuselage and a wing that blend into each other."""
    def field(x, y, z):
        fuselage = 1 - np.sqrt((x / 2.4) ** 2 + (y / 0.5) ** 2 + (z / 0.5) ** 2)
        wing = 1 - np.sqrt(((x - 0.1 + 0.25 * np.sqrt(y * y + 0.1)) / 0.7) ** 2 + (y / 2.3) ** 2 + (z / 0.3) ** 2)
        return 0.08 * np.log(np.exp(fuselage / 0.08) + np.exp(wing / 0.08))
    return level(field, (-2.7, -2.6, -0.7), (2.7, 2.6, 0.7), 0.06)


def tee():
    """Returns two pipes that meet, open at three ends; the fillet between them is smooth."""
    def field(x, y, z):
        run, branch = 1 - np.hypot(y, z), 0.8 - np.hypot(x, y) - 4 * np.maximum(0, -0.2 - z)
        return 0.12 * np.log(np.exp(run / 0.12) + np.exp(branch / 0.12))
    return level(field, (-2.5, -1.5, -1.5), (2.5, 1.5, 2.5), 0.125)


def terrain():
    """Returns heights over a rectangle."""
    def place(u, v):
        x, y = 6 * u, 4 * v
        hills = 0.5 * np.exp(-((x - 1.8) ** 2 + (y - 2.4) ** 2) / 0.8) + 0.35 * np.exp(-((x - 4.3) ** 2 + (y - 1.5) ** 2) / 0.5)
        return x, y, hills + 0.06 * np.sin(2.1 * x + 0.7) * np.cos(1.9 * y) + 0.02 * np.sin(5.3 * x - 2.2 * y)
    return grid(72, 48, place)


def gutter():
    """Returns half a pipe that is bent by 90°."""
    def place(u, v):
        radius, angle = 3 + np.cos(np.pi * u), np.pi / 2 * v
        return radius * np.cos(angle), radius * np.sin(angle), -np.sin(np.pi * u)
    return grid(24, 40, place)


def spring():
    """Returns a tube along a helix of one and a half turns, open at both ends."""
    def place(u, v):
        turn, pitch, tube = 3 * np.pi * v, 0.22, 0.45
        radius = 1.5 + tube * np.cos(2 * np.pi * u)
        along = pitch / math.hypot(1.5, pitch)  # the circles are perpendicular to the helix
        up = tube * np.sin(2 * np.pi * u)
        return (radius * np.cos(turn) + along * up * np.sin(turn), radius * np.sin(turn) - along * up * np.cos(turn),
                pitch * turn + up * math.sqrt(1 - along * along))
    return grid(24, 120, place, closed_across=True)
