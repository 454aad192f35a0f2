"""Singularity Source with a domain in ParaView's client: rows that fit it, handles where something is
shown; started by run_client.py."""
import numpy as np
from paraview.simple import *

import gui_driver
from gui_driver import check, check_equal, drag, gui, messages, new_view, picture, run, wait

DEFAULTS = [0.4242640687119285, 0.4242640687119285, 1, 0.1, -0.4242640687119285, 0.4242640687119285, 1, 0.1,
            -0.4242640687119285, -0.4242640687119285, 1, 0.1, 0.4242640687119285, -0.4242640687119285, 1, 0.1]


def handles(view):
    """Returns the number of handles in the view, which alone have transparent colours."""
    actors = view.GetClientSideObject().GetNonCompositedRenderer().GetActors2D()
    mappers = (actors.GetItemAsObject(i).GetMapper() for i in range(actors.GetNumberOfItems()))
    drawings = [mapper.GetInput() for mapper in mappers if mapper and mapper.IsA("vtkPolyDataMapper2D")]
    scalars = [drawing.GetPointData().GetScalars() for drawing in drawings if drawing]
    return sum(bool(colours) and colours.GetNumberOfComponents() == 4 for colours in scalars)


def rows_of(source):
    """Returns the rows that the source has now."""
    source.UpdatePropertyInformation()
    return np.reshape(source.GetProperty("OutputRows"), (-1, 4))


def shown_rows():
    return np.array([[gui.gui_number(row, column) for column in range(4)] for row in range(gui.gui_rows())])


def note():
    return gui.gui_label(b"Note").decode()


def make(name, **inputs):
    made = gui_driver.make(name, **inputs)
    check_equal(messages(), "", "messages of " + name)
    return made


def test_without_a_domain(view):
    source = make("Singularity Source")
    check_equal(list(source.Singularities), DEFAULTS, "the default rows")
    check_equal((gui.gui_rows(), handles(view)), (4, 4), "rows and handles")
    check("No domain" in note() and "unit disk" in note(), "the panel does not say that there is no domain: " + note())
    picture("without_a_domain.png")
    gui.gui_type(0, 0, 0.25)
    wait()
    check("unit disk" not in note() and "No domain" in note(), "the panel with rows of the user: " + note())


def test_with_a_domain(view):
    domain = make("Planar Domain Source")
    RenameSource("Domain", domain)
    SetProperties(domain, DomainName="ellipse", Width=6, Height=2)
    ResetCamera(view)
    source = make("Singularity Source", Domain="Domain")
    check_equal(list(source.Singularities), DEFAULTS, "the property, which follows the domain")
    fitted = rows_of(source)
    check_equal((len(fitted), fitted[:, 2].tolist()), (4, [1, 1, 1, 1]), "rows that fit an ellipse")
    check(((fitted[:, 0] / 3) ** 2 + fitted[:, 1] ** 2 < 1).all() and np.ptp(fitted[:, 0]) > 2.5, "rows are not spread inside")
    check_equal(shown_rows().tolist(), fitted.tolist(), "the table")
    check_equal(handles(view), 4, "handles")
    check("fit the domain" in note(), "the panel: " + note())
    picture("with_a_domain.png")
    # They follow the domain.
    SetProperties(domain, Width=8)
    Render()
    wait(400)
    wide = rows_of(source)
    check(np.ptp(wide[:, 0]) > np.ptp(fitted[:, 0]) + 0.5, "the rows do not follow the domain")
    check_equal(shown_rows().tolist(), wide.tolist(), "the table of another domain")
    SetProperties(domain, Width=6)
    Render()
    wait(400)
    # After a drag the rows belong to the user, and undo gives them back to the domain.
    end = fitted[0, :2] + [-0.1, 0.1]
    for _ in drag(view, [fitted[0, :2], end]):
        pass
    moved = np.reshape(list(source.Singularities), (-1, 4))
    check(abs(moved[0, :2] - end).max() < 0.03, "the final position: %s" % moved[0])
    check_equal(moved[1:].tolist(), fitted[1:].tolist(), "the other rows")
    check_equal(note(), "", "the panel after a drag")
    gui.gui_undo()
    wait(400)
    check_equal((list(source.Singularities), shown_rows().tolist()), (DEFAULTS, fitted.tolist()), "rows after undo")
    # The quads have these singularities.
    SetActiveSource(domain)
    quads = make("Quad Mesher", Singularities=gui_name(source))
    text = quads.GetClientSideObject().GetOutputDataObject(8).GetRowData().GetAbstractArray("Summary").GetValue(0)
    check("4 of valence 3" in " ".join(text.split()), "the text of Quad Mesher: " + text)
    check_equal(messages(), "", "messages")


def gui_name(source):
    return [key[0] for key, value in GetSources().items() if value == source][0]


def test_handles_of_what_is_shown(view):
    domain = make("Planar Domain Source")
    RenameSource("Disk", domain)
    source = make("Singularity Source", Domain="Disk")
    check_equal(handles(view), 4, "handles of a source that is shown")
    Hide(source, view)
    Render()
    wait(400)
    check_equal((gui.gui_rows(), handles(view)), (4, 0), "rows, and handles of a source that is not shown")
    # A filter downstream is shown.
    lines = Separatrices(registrationName="Lines", Input=CrossFieldMap(Input=domain, Singularities=source))
    SetActiveSource(source)
    wait()
    check_equal(handles(view), 0, "handles before the filter is shown")
    Show(lines, view)
    Render()
    wait(400)
    check_equal(handles(view), 4, "handles with a filter downstream shown")
    picture("downstream.png")
    Hide(lines, view)
    Render()
    wait(400)
    check_equal(handles(view), 0, "handles after the filter is hidden")
    # Another pipeline in the same view does not bring them back.
    Show(domain, view)
    Render()
    wait(400)
    check_equal(handles(view), 0, "handles with the domain shown")
    Show(source, view)
    Render()
    wait(400)
    check_equal(handles(view), 4, "handles of the source shown again")


def in_new_session(test):
    test(new_view())


run("test_", globals(), in_new_session, (1000, 800, 370))
