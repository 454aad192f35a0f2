"""The proxies of the plugin: pvpython test_plugin_proxies.py PLUGIN

Every proxy exists, is documented and is listed in the menus.
"""
import glob
import os
import re
import xml.dom.minidom

from paraview import servermanager
from paraview.modules.vtkRemotingServerManager import vtkSMOrderedPropertyIterator

from checks import check, check_equal
from loaded_plugin import *

PLUGIN = os.path.join(os.path.dirname(__file__), "..", "..", "paraview-plugin")
ICONS = os.path.join(PLUGIN, "icons")

PROXIES = {
    "BoundaryCornerClassifier": (
        "filters", "Input CornerAngle PrintedCoefficient SplitHalves Overrides PointOverrides"),
    "BoundarySimplifier": ("filters", "Input FixedPoints Part MeshSize ThinningLength SmoothingLength CornerAngle"),
    "PoincareHopfCheck": ("filters", "Input Singularities Corners CornerAngle FeatureAngle Holonomy CapCorners"),
    "ConfigurationProposal": (
        "filters", "Input Singularities Corners CornerAngle CancelFlatCorners CapCorners Alternatives "
        "CoreRadius"),
    "PlanarDomainSource": ("sources", "DomainName Radius InnerRadius Width Height EdgeLength"),
    "PlanarDomainReader": ("sources", "FileName"),
    "DrawingReader": ("sources", "FileName Layers JoinTolerance AllFaces SamplingAngle"),
    "SingularitySource": ("sources", "Domain Singularities OutputRows FileName UseHandles Handles Plane"),
    "SingularityHandles": ("filters", "Input Domain Singularities OutputRows Plane"),
    "DrillHoles": ("filters", "Input Singularities Mode MeshSize MinimumHoleEdges Gradation"),
    "PerforatedCrossField": (
        "filters", "Input Corners Method UnitHoles UnitHoleRows GlobalConstraint Epsilon "
        "MaximumIterations Tolerance"),
    "HField": ("filters", "Input Singularities Corners MeshSize KeepMesh"),
    "LayoutDesigner": ("filters", "Input StartFrom Corners Singularities Rows Plane Triangles RequiredSum Reasons Propose Optimise Snap AddPair Undo Quads Merge Dragging "
                       "QuadSize QuadCount FeatureAngle MeshSize CapCorners"),
    "CrossFieldMap": ("filters", "Input Singularities Corners MeshSize CapCorners RepairHolonomy"),
    "QuadMesher": ("filters", "Input Singularities Corners QuadSize QuadCount MeshSize CapCorners "
                   "HoldSingularities FeatureAngle ChordError RepairHolonomy SplitSingularities Curves Sides SideNames SidePlaces"),
    "SmoothQuads": ("filters", "Input SlideOnBoundary CornerAngle UniformSizes"),
    "QuadsToHigherOrder": ("filters", "Input Boundary Order FeatureAngle"),
    "ExtrudeQuads": ("filters", "Input Boundary Motion Layers Height Angle Axis"),
    "QuadMeshWriter": ("writers", "Input FileName MshVersion PatchTypes"),
    "Separatrices": ("filters", "Input Seeds LongestStreamline"),
    "SingularityEnergy": ("filters", "Input Configurations Corners MeshSize CoreRadius KeepMesh"),
    "SingularityOptimizer": (
        "filters", "Input Singularities Corners MeshSize MaximumIterations Tolerance UniformSizes Sizing SizeArray Pairs"),
    "CrossGlyphs": ("filters", "Input Spacing Scale ScaleByNorm"),
}

def properties_of(prototype):
    iterator = prototype.NewPropertyIterator()
    iterator.Begin()
    while not iterator.IsAtEnd():
        yield iterator.GetKey(), iterator.GetProperty()
        iterator.Next()


def check_tooltip(item, name):
    """The tooltip of a parameter states what the parameter does and its default."""
    documentation = item.GetDocumentation()
    text = documentation.GetDescription() if documentation is not None else ""
    check(text, "%s has no documentation" % name)
    is_parameter = item.IsA("vtkSMVectorProperty") and not item.GetInformationOnly()
    hidden = item.GetPanelVisibility() == "never"
    if is_parameter and not item.IsA("vtkSMInputProperty") and not hidden:
        check("Default: " in " ".join(text.split()), "%s states no default" % name)


def test_proxies():
    icons = set()
    for name, (group, wanted) in PROXIES.items():
        prototype = servermanager.ProxyManager().GetPrototypeProxy(group, name)
        check(prototype is not None, "there is no proxy %s" % name)
        documentation = prototype.GetDocumentation()
        check(documentation.GetShortHelp() and documentation.GetLongHelp(), "%s has no help" % name)
        for part in ("Example", "glossary"):
            check(part in documentation.GetDescription(), "the help of %s has no %s" % (name, part))
        # Python names come from labels, so a label must be the name with spaces.
        check_equal(prototype.GetXMLLabel(), re.sub("(?<!^)(?=[A-Z])", " ", name), "the label")
        if name not in ("DrawingReader", "PlanarDomainReader", "QuadMeshWriter"):  # of File, Open and Save Data
            menu = prototype.GetHints().FindNestedElementByName("ShowInMenu")
            # A category here would come before menus.xml, and in another order.
            check_equal(menu.GetAttribute("category"), None, "the menu of %s" % name)
            icon = re.fullmatch(":/CrossField/(.*)", menu.GetAttribute("icon")).group(1)
            xml.dom.minidom.parse(os.path.join(ICONS, icon))  # raises if it is not valid XML
            check(icon not in icons, "%s has the icon %s of another filter" % (name, icon))
            icons.add(icon)
        found = dict(properties_of(prototype))
        check(set(wanted.split()) <= set(found), "%s lacks a property" % name)
        for key, item in found.items():
            check_tooltip(item, "%s.%s" % (name, key))
            check_equal(item.GetXMLLabel().replace(" ", ""), key, "the label")


def test_menus():
    """The menus list every proxy of the plugin and no abstract one, and first those that most users need."""
    menus = xml.dom.minidom.parse(os.path.join(PLUGIN, "menus", "menus.xml"))
    listed = [(item.getAttribute("group"), item.getAttribute("name"))
              for item in menus.getElementsByTagName("Proxy")]
    shown = []
    for file_name in glob.glob(os.path.join(PLUGIN, "CrossField*.xml")):
        for menu in xml.dom.minidom.parse(file_name).getElementsByTagName("ShowInMenu"):
            proxy = menu.parentNode.parentNode
            shown.append((proxy.parentNode.getAttribute("name"), proxy.getAttribute("name")))
    check_equal(sorted(listed), sorted(shown), "the proxies in the menus")
    filters = [name for group, name in listed if group == "filters"]
    check_equal(filters[:3], ["QuadMesher", "LayoutDesigner", "ExtrudeQuads"], "the first filters in the menu")


def test_groups():
    """Quad Mesher's properties are in groups, all but its domain, and those for few users under the gear."""
    prototype = servermanager.ProxyManager().GetPrototypeProxy("filters", "QuadMesher")
    groups = [prototype.GetPropertyGroup(i) for i in range(prototype.GetNumberOfPropertyGroups())]
    check_equal([group.GetXMLLabel() for group in groups], ["Size", "Sides and layers", "Singularities", "Corners"], "the groups")
    members = [group.GetProperty(i) for group in groups for i in range(group.GetNumberOfProperties())]
    lacking = [key for key, item in properties_of(prototype)
               if not any(item is member for member in members) and not item.GetInformationOnly()]
    check_equal(lacking, ["Input"], "properties in no group")
    # The panel shows a group where its first property is.
    ordered = vtkSMOrderedPropertyIterator()
    ordered.SetProxy(prototype)
    ordered.Begin()
    order = []
    while not ordered.IsAtEnd():
        order.append(ordered.GetProperty())
        ordered.Next()
    places = [order.index(member) for member in members]
    check_equal(places, sorted(places), "the order of the properties")
    for name, visibility in ("QuadSize", "default"), ("MaximumSize", "default"), ("MeshSize", "advanced"), ("Clearance", "advanced"):
        check_equal(prototype.GetProperty(name).GetPanelVisibility(), visibility, "the visibility of " + name)


run_tests(test_proxies, test_menus, test_groups)
