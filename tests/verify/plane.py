"""The coordinates in the plane of a domain (docs/conventions.md).

(x, y) if z is constant, (y, z) if x is, (x, z) if y is; for a tilted plane the nearest of these,
turned into it by the shortest rotation.
"""
import numpy as np

from report import ROUNDING


class Frame:
    """Two axes as rows, the normal, the points in their coordinates, and the accuracy of these."""

    def __init__(self, points):
        low, high = points.min(axis=0), points.max(axis=0)
        extent = high - low
        size = np.linalg.norm(extent)
        self.size = size
        reach = np.abs(points).max()
        axes = np.eye(3)
        # Coordinates that went through single precision count as constant.
        flat = [extent[i] <= 1e-6 * size + 1e-6 * abs(low[i]) for i in range(3)]
        if flat[2]:
            self.axes, self.normal, tilted = axes[:2], axes[2], False
        elif extent[0] == 0.0:
            self.axes, self.normal, tilted = axes[1:], axes[0], False
        elif extent[1] == 0.0:
            self.axes, self.normal, tilted = axes[[0, 2]], -axes[1], False
        else:
            tilted = True
            normal = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2][2]
            # The nearest coordinate plane; z before y before x if two are equally near.
            sizes = np.abs(normal)
            near = max((2, 1, 0), key=lambda i: (sizes[i] >= sizes.max() - 1e-6, i))
            base = {2: (axes[0], axes[1]), 1: (axes[0], axes[2]), 0: (axes[1], axes[2])}[near]
            pole = np.cross(*base)
            normal = normal if normal @ pole > 0 else -normal
            self.axes = np.array([_turn(pole, normal, axis) for axis in base])
            self.normal = normal
        self.coordinates = points @ self.axes.T
        height = points @ self.normal
        self.deviation = 0.5 * (height.max() - height.min())
        # The program rounds coordinates of a tilted plane to 2^-44 of their size, and so does
        # reading the plane again from its points.
        self.exactness = reach * (2.0 ** -43 if tilted else ROUNDING)


def _turn(pole, normal, vector):
    """Applies the shortest rotation from the pole to the normal to a vector (Rodrigues)."""
    axis, cosine = np.cross(pole, normal), pole @ normal
    return vector * cosine + np.cross(axis, vector) + axis * (axis @ vector) / (1.0 + cosine)
