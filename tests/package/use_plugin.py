"""Checks that ParaView lists the installed plugin and loads it by name: pvpython use_plugin.py PREFIX"""
import sys

from paraview import servermanager
from paraview.simple import *

LoadDistributedPlugin("CrossFieldPlugin", remote=False, ns=globals())
plugins = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager().GetLocalInformation()
files = {plugins.GetPluginName(i): plugins.GetPluginFileName(i)
         for i in range(plugins.GetNumberOfPlugins())}
assert files["CrossFieldPlugin"].startswith(sys.argv[1] + "/"), files
field = PerforatedCrossField(Input=DrillHoles(Input=PlanarDomainSource(), Singularities=SingularitySource()))
assert servermanager.Fetch(field).GetFieldData().GetArray("Converged").GetValue(0) == 1
print("loaded", files["CrossFieldPlugin"])
