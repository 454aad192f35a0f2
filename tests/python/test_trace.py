"""Runs ParaView's trace of a session: pvpython test_trace.py PLUGIN

A session with every proxy of the plugin is traced, with changes that Apply makes; the recorded
script produces the same data in an empty ParaView.
"""
import os
import sys
import tempfile

from paraview import servermanager, smtrace
import paraview.simple as simple

from checks import check, check_equal

simple.LoadPlugin(sys.argv[1], ns=vars(simple))


def apply(proxy, **changes):
    """Does what the button Apply does: traces the changed properties, and updates."""
    item = smtrace.PropertiesModified(proxy)
    simple.SetProperties(proxy, **changes)
    item.finalize()
    proxy.UpdatePipeline()


def session(table):
    """Creates a source of each kind."""
    drawn = simple.PlanarDomainSource(registrationName="Drawn", DomainName="ring", EdgeLength=0.2)
    apply(drawn, DomainName="disk")
    domain = simple.PlanarDomainReader(registrationName="Domain", FileName=table)
    proposal = simple.ConfigurationProposal(registrationName="Proposal", Input=domain)
    proposal.UpdatePipeline()
    handles = simple.SingularityHandles(registrationName="Handles", Input=proposal)
    handles.UpdatePipeline()
    handles.UpdatePropertyInformation()
    found = list(handles.GetPropertyValue("OutputRows"))
    check(len(found) >= 4, "the proposal has no singularity")
    apply(handles, Singularities=[0.125, 0.25] + found[2:])
    rows = simple.SingularitySource(registrationName="Rows")
    apply(rows, Singularities=[0.5, 0.375] + list(rows.Singularities)[2:])
    simple.BoundaryCornerClassifier(registrationName="Corners", Input=domain, SplitHalves=1)
    simple.PoincareHopfCheck(registrationName="Check", Input=drawn, Singularities=rows)
    drilled = simple.DrillHoles(registrationName="Drilled", Input=drawn, Singularities=rows, MeshSize=0.2)
    field = simple.PerforatedCrossField(registrationName="Field", Input=drilled)
    field.UpdatePipeline()
    apply(field, Method="Constrained")
    simple.CrossGlyphs(registrationName="Crosses", Input=field, Spacing=0.1)
    simple.CrossFieldSingularities(registrationName="Read", Input=field)
    simple.GinzburgLandauCrossField(
        registrationName="Landau", Epsilon=0.3,
        Input=simple.DrillHoles(registrationName="Mesh", Input=drawn, MeshSize=0.3,
                                Singularities=simple.SingularitySource(registrationName="None", Singularities=[])))
    simple.HField(registrationName="H", Input=drawn, Singularities=rows, MeshSize=0.2)
    flat = simple.CrossFieldMap(registrationName="Map", Input=drawn, Singularities=rows, MeshSize=0.2)
    simple.Separatrices(registrationName="Lines", Input=flat)
    moved = simple.SingularityOptimizer(registrationName="Moved", Input=drawn, Singularities=rows, MeshSize=0.2)
    simple.SingularityEnergy(registrationName="Energies", Input=drawn, Configurations=[rows, moved], MeshSize=0.2)
    simple.LayoutDesigner(registrationName="Design", Input=drawn, StartFrom=rows, QuadCount=108, MeshSize=0.2)
    simple.QuadMesher(registrationName="Quads", Input=drawn, Singularities=rows, QuadCount=108, MeshSize=0.2)


def contents():
    """Returns proxy name, class, number of rows, and points of the data of each source."""
    found = {}
    for (name, _), source in simple.GetSources().items():
        data = servermanager.Fetch(source)
        table = data.IsA("vtkTable")
        rows = data.GetNumberOfRows() if table else data.GetNumberOfCells()
        values = [] if table else [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]
        check(rows > 0 or name in ("None", "Read"), "%s is not empty" % name)
        found[name] = (source.GetXMLName(), data.GetClassName(), rows, values)
    return found


with tempfile.TemporaryDirectory(prefix="crossfield-") as folder:
    file_name = os.path.join(folder, "domain.csv")
    with open(file_name, "w", encoding="utf-8") as file:
        file.write("x,y\n0,0\n2,0\n2,1\n1,2\n0,1\n")
    smtrace.start_trace()
    session(file_name)
    script = smtrace.stop_trace()
    print(script)
    first = contents()
    kinds = {kind for kind, _, _, _ in first.values()}
    check_equal(len(kinds), 19, "the number of proxies in the session")
    simple.ResetSession()
    simple.LoadPlugin(sys.argv[1], ns=vars(simple))
    check_equal(len(simple.GetSources()), 0, "the number of sources in an empty session")
    exec(compile(script, "trace", "exec"), {"__name__": "trace"})
    again = contents()
check_equal(sorted(again), sorted(first), "the sources of the script")
for source_name, content in first.items():
    check(again[source_name] == content, "%s of the script differs: %s\ninstead of %s"
          % (source_name, again[source_name], content))
