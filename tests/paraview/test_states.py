"""Every state of the plugin, loaded in ParaView's client as File > Load State does; started by
run_client.py.

The message window must stay empty and every layout needs a view; pictures are saved for inspection.
"""
import os

import paraview.simple as simple

from gui_driver import check, check_equal, gui, messages, picture, run, wait

STATES = os.environ["STATES"]
# States that begin with handles to drag.
WITH_HANDLES = "design.py", "place_and_solve.py"


def load(state):
    simple.ResetSession()
    wait(200)
    gui.gui_load_state(os.path.join(STATES, state).encode())
    wait(300)
    for layout in simple.GetLayouts().values():
        check(len(simple.GetViewsInLayout(layout)) > 0, "a layout without views")
    check(len(simple.GetSources()) >= 2, "the state has no pipeline")
    for view in simple.GetRenderViews():
        texts = [str(shown.WindowLocation) for shown in view.Representations
                 if shown.GetXMLName() == "TextSourceRepresentation" and shown.Visibility]
        check_equal(sorted(set(texts)), sorted(texts), "positions of texts, in " + state)
    if state in WITH_HANDLES:
        check(gui.gui_rows() > 0, "the handles of the state are not shown")
    picture(state[:-3] + ".png")
    check_equal(messages(), "", "messages of " + state)


def test_states():
    wrong = []
    for state in sorted(name for name in os.listdir(STATES) if name.endswith(".py")):
        print(state, flush=True)
        try:
            load(state)
        except AssertionError as error:
            wrong.append("%s: %s" % (state, error))  # the other states are still loaded
    check_equal(wrong, [], "what is wrong with states")


run("test_", globals(), lambda test: test(), (1200, 900, 300))
