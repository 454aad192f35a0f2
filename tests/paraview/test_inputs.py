"""Optional inputs, chosen in the panel of a filter created from the menu; started by
run_client.py."""
import os

from paraview import servermanager
from paraview.simple import *

from gui_driver import check, check_equal, gui, messages, picture, run, wait


def make(name, domain):
    """Creates a filter of the domain from the menu, not yet applied."""
    SetActiveSource(domain)
    wait(200)
    check(gui.gui_trigger(name.encode()), name + " is not in the menu")
    wait()


def test_chosen_in_the_panel(domain, rows):
    for name, label in ("Poincare Hopf Check", "Singularities"), ("Cross Field Map", "Singularities"), (
            "Layout Designer", "StartFrom"):
        make(name, domain)
        check(gui.gui_select_choice(label.encode(), b"Three and one"), "no list of choices for " + name)
        check(gui.gui_click(b"Apply"), "no Apply")
        wait(200)
        # ParaView's browser rebuilds its tree for a further input and may select another branch.
        made = next((source for source in GetSources().values() if source.GetXMLLabel() == name), None)
        check(made is not None, name + " was not made")
        SetActiveSource(made)
        # The proxy itself, not the panel.
        check(made.SMProxy.GetProperty(label).GetProxy(0) is rows.SMProxy, "the input of %s is not what was chosen" % name)
        check_equal(messages(), "", "messages of " + name)
        if name == "Poincare Hopf Check":
            text = servermanager.Fetch(made, idx=3).GetColumn(0).GetValue(0)
            check("add up to 4" in text, "the check does not count what was chosen: " + text)
        picture(name.replace(" ", "_").lower() + ".png")


def test_input_removed(domain, rows):
    designer = GetActiveSource()
    check(gui.gui_select_choice(b"StartFrom", b"(none)"), "(none) cannot be selected")
    check(gui.gui_click(b"Apply"), "no Apply")
    wait(200)
    check_equal(designer.SMProxy.GetProperty("StartFrom").GetNumberOfProxies(), 0, "inputs after none was chosen")


def test_downstream_sources_are_disabled(domain, rows):
    designer = GetActiveSource()
    Show(SingularityHandles(registrationName="Follows", Input=OutputPort(designer, 2)))
    Render()
    SetActiveSource(designer)
    wait(200)
    check(not gui.gui_select_choice(b"StartFrom", b"Follows"), "a source downstream of the filter can be its input")
    check(gui.gui_select_choice(b"StartFrom", b"Three and one"), "the other choices are missing")


def run_with_sources(test):
    if not GetSources():
        GetActiveViewOrCreate("RenderView")
        for source in (PlanarDomainSource(registrationName="Domain"),
                       SingularitySource(registrationName="Three and one")):
            Show(source)
        Render()
    test(FindSource("Domain"), FindSource("Three and one"))


run("test_", globals(), run_with_sources, (1000, 800, 370))
