"""Choose the singularities of a cross field in numpy arrays: a plate with a round hole.

Usage, with Debian's Python, which finds ParaView's VTK or plain VTK, or with pvpython:

    PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 solve_numpy.py field.vtu
"""
import sys

import numpy as np

import crossfield

plate = np.array([(0, 0), (6, 0), (6, 4), (0, 4)])
angles = np.linspace(0, 2 * np.pi, 60, endpoint=False)
hole = np.column_stack([3 + 0.8 * np.cos(angles), 2 + 0.8 * np.sin(angles)])
singularities = [(x, y, -1, 0.1) for x in (1.5, 4.5) for y in (1.0, 3.0)]  # x, y, 4 x index, radius

checked = crossfield.check([plate, hole], singularities)
print(checked.reason)
if not checked.consistent:
    sys.exit(1)
field = crossfield.solve([plate, hole], singularities, size=0.1, method="unit-norm")
print("energy %.4f, degrees of the holes %s" % (field.report["energy"], field.hole_degrees))
centres = field.points[field.triangles].mean(axis=1)
below = centres[:, 1] < 1
print("mean |angle| of the crosses below the hole: %.2f degrees"
      % np.degrees(abs(field.angle[below]).mean()))
field.write(sys.argv[1])
