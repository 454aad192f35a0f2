"""The picture of H: python3 test_draw_h.py DRAW_H.py --plugin PLUGIN -- COMMAND...

COMMAND runs the script, for example `xvfb-run -a pvpython`.
"""
import os
import subprocess
import sys
import tempfile

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from checks import check, check_equal

split = sys.argv.index("--")
script, options, command = sys.argv[1], sys.argv[2:split], sys.argv[split + 1:]
with tempfile.TemporaryDirectory() as directory:
    picture = os.path.join(directory, "h.png")
    subprocess.run([*command, script, *options, "--size", "0.03", "--picture", picture], check=True)
    reader = vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    check_equal(reader.GetOutput().GetDimensions(), (1600, 860, 1), "the size of the picture")
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)
    red, green, blue = pixels.T
    shares = {"white background": ((pixels > 250).all(axis=1).mean(), 0.2),
              "red points": (((red > 120) & (green < 70) & (blue < 70)).mean(), 2e-4),
              "green points": (((green > 90) & (red < 60) & (blue < 80)).mean(), 2e-4),
              "blue crosses": (((blue > 120) & (red < 90) & (green < 130)).mean(), 0.01)}
    for what, (share, least) in shares.items():
        check(share > least, "the share of %s is %g" % (what, share))
    # Without a domain there is no H, and the script reports it.
    done = subprocess.run([*command, script, *options, "--domain", "disk", "--picture", picture],
                          check=False, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    check(done.returncode != 0, "singularities outside the disk's sum pass")
    check("There is no H" in done.stderr, "the script does not say that there is no H")
