"""The coordinates of the plane that a domain lies in (docs/conventions.md).

(x, y) if z is constant, (y, z) if x is, (x, z) if y is; of a tilted plane the nearest of these,
turned into it the shortest way.
"""
import numpy as np

from report import ROUNDING


class Frame:
    """Two axes as rows, the normal, the points in their coordinates, and how exact these are."""

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
            # The nearest coordinate plane, z before y before x where two are as near.
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
        # Coordinates of a tilted plane are rounded to 2^-44 of their size by the product, and by
        # reading the plane again from its points.
        self.exactness = reach * (2.0 ** -43 if tilted else ROUNDING)


def _turn(pole, normal, vector):
    """The shortest rotation that takes the pole to the normal, of a vector (Rodrigues)."""
    axis, cosine = np.cross(pole, normal), pole @ normal
    return vector * cosine + np.cross(axis, vector) + axis * (axis @ vector) / (1.0 + cosine)
