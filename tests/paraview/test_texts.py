"""Texts of filters in the view: black, or red on white if something is wrong, in which case the window
Output Messages stays closed; started by run_client.py."""
from paraview.simple import *

from gui_driver import apply, check, check_equal, gui, log, make, messages, picture, run, wait

BLACK, RED = [0, 0, 0], [0.85, 0.1, 0.1]
# The polygon of docs/tutorial_paraview.md.
POLYGON = [1.3, 0, 0, 1.13, 0.5, 0, 0.65, 0.87, 0, 0, 1, 0, -0.65, 0.87, 0, -1.13, 0.5, 0,
           -1.3, 0, 0, -1.13, -0.5, 0, -0.65, -0.87, 0, 0, -1, 0, 0.65, -0.87, 0, 1.13, -0.5, 0]


def drawn(where):
    """Returns the text at a position of the view and its colour; empty texts are not shown."""
    found = [shown for shown in GetActiveView().Representations
             if shown.GetXMLName() == "TextSourceRepresentation" and shown.Visibility and shown.WindowLocation == where]
    check_equal(len(found), 1, "texts in the view at " + where)
    text = found[0].GetClientSideObject().GetTextWidgetRepresentation().GetRepresentation().GetText()
    colour = [round(number, 6) for number in found[0].Color]
    has_backdrop = found[0].ShowBorder == "Always" and list(found[0].BackgroundColor) == [1, 1, 1, 1]
    check_equal(has_backdrop, colour == RED, "whether the text has a white backdrop")
    return " ".join(text.splitlines()), colour


def check_reported(word):
    """Checks that a message was added to the closed window Output Messages."""
    check_equal(messages(), "", "messages that open the window, although the view has them")
    check(not gui.gui_log_is_open(), "the window Output Messages is open")
    check(word in log(), "there is no message with the word %s: %s" % (word, log()))


def contrast(colour, other):
    """Returns the ratio of the brightness of two colours, as WCAG 2 defines it."""
    def brightness(rgb):
        return sum(weight * (c / 12.92 if c <= 0.03928 else ((c + 0.055) / 1.055) ** 2.4)
                   for weight, c in zip((0.2126, 0.7152, 0.0722), rgb)) + 0.05
    return max(brightness(colour), brightness(other)) / min(brightness(colour), brightness(other))


def test_field(domain, points):
    SetActiveSource(domain)
    gui.gui_filter(b"DrillHoles", b"Singularities", b"Points")
    apply()
    field = make("Perforated Cross Field")
    check_equal(drawn("Lower Center"), ("No unwanted singularities.", BLACK), "the text of the default")
    check_equal(messages(), "", "messages of the default")
    picture("unit_norm.png", is_whole_window=False)
    check(gui.gui_select_choice(b"Method", b"Constrained"), "no Constrained in the panel")
    apply()
    text, colour = drawn("Lower Center")
    check("4 unwanted singularities" in text and "Unit Norm" in text, "the text of Constrained: " + text)
    check_equal(colour, RED, "the colour of unwanted singularities")
    check_reported("unwanted")
    # Fetch would add an undo step.
    report = field.GetClientSideObject().GetOutputDataObject(0).GetFieldData()
    check_equal(report.GetArray("UnwantedSingularities").GetValue(0), 4, "unwanted singularities, as the tutorial says")
    picture("constrained.png", is_whole_window=False)
    # The colour is not an undo step.
    check_equal(gui.gui_undo_label(), b"Apply", "what would be undone")
    gui.gui_undo()
    wait(400)
    check_equal(drawn("Lower Center"), ("No unwanted singularities.", BLACK), "the text after undo")
    # Without a field, the text gives the reason.
    points.Singularities = [0, 0, 3, 0.1]
    Render()
    wait(400)
    text, colour = drawn("Lower Center")
    check("4" in text and colour == RED, "the text where the sum is wrong: %s %s" % (text, colour))
    check_reported("4")
    picture("no_field.png", is_whole_window=False)


def test_check(domain, points):
    points.Singularities = [0.4, 0, 1, 0.1]
    SetActiveSource(domain)
    make("Poincare Hopf Check", Singularities="Points")
    text, colour = drawn("Upper Left Corner")
    check(text.startswith("Inconsistent") and colour == RED, "the check on a wrong sum: %s %s" % (text, colour))
    picture("check.png", is_whole_window=False)
    points.Singularities = [0.4, 0, 4, 0.1]
    Render()
    wait(400)
    text, colour = drawn("Upper Left Corner")
    check(text.startswith("Consistent") and colour == BLACK, "the check on a right sum: %s %s" % (text, colour))


def test_designer(domain, points):
    SetActiveSource(domain)
    designer = make("Layout Designer")
    text, colour = drawn("Lower Center")
    check("minimum angle" in text and colour == BLACK, "the summary: %s %s" % (text, colour))
    rows = gui.gui_rows()
    check(rows > 0, "no singularities are proposed")
    # A singularity is moved outside and back.
    x = gui.gui_number(0, 0)
    gui.gui_type(0, 0, 7)
    wait(400)
    text, colour = drawn("Lower Center")
    check("outside" in text and colour == RED, "the summary of a singularity outside: %s %s" % (text, colour))
    picture("outside.png", is_whole_window=False)
    gui.gui_type(0, 0, x)
    wait(400)
    check_equal(drawn("Lower Center")[1], BLACK, "the colour after the singularity is back")
    designer.Singularities = []
    check_equal(messages(), "", "messages of a singularity outside")
    # An open curve is not a domain.
    domain.Closed = 0
    Render()
    wait(400)
    text, colour = drawn("Lower Center")
    check("open" in text and colour == RED, "the summary without a domain: %s %s" % (text, colour))
    check_equal(gui.gui_rows(), 0, "rows of the table without a domain")
    check_reported("open")
    picture("no_domain.png", is_whole_window=False)
    domain.Closed = 1
    Render()
    wait(400)
    text, colour = drawn("Lower Center")
    check("minimum angle" in text and colour == BLACK, "the summary with a domain again: %s %s" % (text, colour))
    check_equal(gui.gui_rows(), rows, "rows of the table with a domain again")


def test_quads(domain, points):
    SetActiveSource(domain)
    mesher = make("Quad Mesher")
    text, colour = drawn("Lower Center")
    count = mesher.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells()
    check(text.startswith("%d quads in" % count) and "minimum angle" in text and "of valence 3" in text, "the text: " + text)
    check_equal(colour, BLACK, "the colour of the text")
    check_equal(messages(), "", "messages of quads")
    picture("quads.png", is_whole_window=False)
    points.Singularities = [0.5, 0, 1, 0.1, -0.5, 0, 1, 0.1, 0, 0.5, 1, 0.1, 0, -0.5, 1, 0.1, 0, 0, 1, 0.1]
    SetProperties(mesher, Singularities=points)
    Render()
    wait(400)
    text, colour = drawn("Lower Center")
    check("add up to 5" in text and colour == RED, "the text on a wrong sum: %s %s" % (text, colour))
    check_reported("add up to 5")
    picture("no_quads.png", is_whole_window=False)
    # Readable on any background.
    check(contrast(RED, [1, 1, 1]) >= 4.5, "the contrast of alarms: %g" % contrast(RED, [1, 1, 1]))
    view = GetActiveView()
    for name, usePalette, colour in ("default", 1, [0.32, 0.34, 0.43]), ("black", 0, [0, 0, 0]):
        SetProperties(view, UseColorPaletteForBackground=usePalette, Background=colour)
        Render()
        picture("no_quads_%s.png" % name, is_whole_window=False)


def test_bad_quad(domain, points):
    """Warnings about bad quads are in the text, which is red."""
    points.Singularities = [0.3, 0, 2, 0.1, -0.3, 0, 2, 0.1]
    Render()
    SetActiveSource(domain)
    mesher = make("Quad Mesher")
    SetProperties(mesher, Singularities=points)
    Render()
    wait(600)
    text, colour = drawn("Lower Center")
    check("is a node of valence 2" in text and colour == RED, "the text on a bad quad: %s %s" % (text, colour))
    check_reported("is a node of valence 2")
    numbers = text.split("The singularity at (")[1].split(")")[0].split(", ")
    check(all(len(number.lstrip("-0.")) <= 4 for number in numbers), "coordinates: %s" % numbers)
    picture("bad_quad.png", is_whole_window=False)


def test_designer_of_no_domain(domain, points):
    """The designer is created while its domain is invalid."""
    domain.Closed = 0
    SetActiveSource(domain)
    wait()
    make("Layout Designer")
    text, colour = drawn("Lower Center")
    check("open" in text and colour == RED, "the summary without a domain: %s %s" % (text, colour))
    check_reported("open")
    picture("never_a_domain.png", is_whole_window=False)
    domain.Closed = 1
    Render()
    wait(600)
    picture("a_domain_at_last.png", is_whole_window=False)
    text, colour = drawn("Lower Center")
    check("minimum angle" in text and colour == BLACK, "the summary with a domain at last: %s %s" % (text, colour))


def test_without_a_text(domain, points):
    """Without a text in the view, the window Output Messages opens; last, because it stays open."""
    SetActiveSource(domain)
    mesher = make("Quad Mesher")
    Hide(OutputPort(mesher, 8))
    points.Singularities = [0.5, 0, 1, 0.1, -0.5, 0, 1, 0.1]
    SetProperties(mesher, Singularities=points)
    Render()
    wait(400)
    check("add up to 2" in messages() and gui.gui_log_is_open(), "no message without a text in the view")


def run_with_domain(test):
    ResetSession()
    wait(200)
    view = GetActiveViewOrCreate("RenderView")
    SetProperties(view, UseColorPaletteForBackground=0, Background=[1, 1, 1], OrientationAxesVisibility=0)
    domain = PolyLineSource(registrationName="Domain", Points=POLYGON, Closed=1)
    points = SingularitySource(registrationName="Points")
    Show(domain)
    points.UpdatePipeline()
    Render()
    test(domain, points)


run("test_", globals(), run_with_domain, (1000, 800, 370))
