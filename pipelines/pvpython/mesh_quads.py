"""Make an all-quad mesh of a domain, with singularities that are chosen for it, and draw it.

The pipeline is that of `crossfield quads part.vtp`, built from ParaView proxies:

    domain (-> singularities) -> quads

Usage:

    xvfb-run -a -s -noreset pvpython mesh_quads.py --plugin CrossFieldPlugin.so --domain part.vtp
        --output quads.vtu --picture quads.png [--quads 1000] [--singularities rows.csv]

In the picture blocks have pale colours, quads thin and blocks thick lines; nodes of valence 5 are
blue, those of valence 3 red. `crossfield --paths` prints where the plugin is. On a desktop pvpython
needs no xvfb-run.
"""
import argparse
import sys

from paraview import servermanager
from paraview.simple import *

from drawing_quads import draw_quads


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--plugin", required=True, help="path of CrossFieldPlugin.so")
    parser.add_argument("--domain", required=True, help="a file that ParaView reads")
    parser.add_argument("--output", required=True, help="the .vtu file to write")
    parser.add_argument("--picture", required=True, help="the .png file to write")
    parser.add_argument("--quads", type=int, default=1000, help="target number of quads")
    parser.add_argument("--singularities", help="a .csv file; default: chosen for the domain")
    return parser.parse_args()


def check(quads):
    """Ends the script if the mesh is missing or has inverted quads, because ParaView continues
    after an error."""
    quads.UpdatePipeline()
    report = servermanager.Fetch(quads, idx=8).GetFieldData()  # output Summary
    count = report.GetArray("Quads")
    if count is None:
        sys.exit("There is no mesh; the error above says why.")
    if report.GetArray("Inverted").GetValue(0) > 0:
        sys.exit("Some quads are turned over; use more of them.")
    least, mean = (report.GetArray("ScaledJacobianRange").GetValue(i) for i in (0, 1))
    print("%d quads, scaled Jacobian at least %.3f, mean %.3f" % (count.GetValue(0), least, mean))


arguments = parse_arguments()
LoadPlugin(arguments.plugin, ns=globals())

# 1. Read the domain and make the quads, with given singularities or those that the mesher chooses.
domain = OpenDataFile(arguments.domain)
quads = QuadMesher(Input=domain, QuadCount=arguments.quads)
if arguments.singularities:
    quads.Singularities = SingularitySource(FileName=arguments.singularities)
check(quads)

# 2. Write the file in inline binary, because Debian's VTK cannot read appended data.
SaveData(arguments.output, proxy=quads, DataMode="Binary", CompressorType="ZLib")

# 3. The picture.
SaveScreenshot(arguments.picture, draw_quads(quads, OutputPort(quads, 2), 1200), CompressionLevel="9")
