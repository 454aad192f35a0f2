"""ParaView with the plugin that the command line names, and what the tests of its filters share.

`from loaded_plugin import *` provides the functions of paraview.simple, those of the plugin and
those below.
"""
import os
import sys

from paraview import servermanager
from paraview.simple import *

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "verify"))
import kept  # noqa: E402

LoadPlugin(sys.argv[1], ns=globals())


def field_of(singularities, **domain):
    return PerforatedCrossField(
        Input=DrillHoles(Input=PlanarDomainSource(**domain), Singularities=singularities))


def fetch(proxy):
    proxy.UpdatePipeline()
    data = servermanager.Fetch(proxy)
    if proxy.GetXMLName() in ("DrillHoles", "PerforatedCrossField", "HField"):
        kept.keep_data(data)
    return data


def run_tests(*tests):
    for test in tests:
        test()
        print(test.__name__, "passed")
