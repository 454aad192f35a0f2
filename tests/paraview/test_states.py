"""Every state of the plugin, loaded in ParaView's client as File > Load State does; started by run_client.py.

Nothing may be said in the window of messages, every view has to show something, and the pictures are to be looked at.
"""
import os
import sys
import traceback

import paraview.simple as simple

from person import check, check_equal, hands, messages, picture, wait

STATES = os.environ["STATES"]


def test(state):
    simple.ResetSession()
    wait(200)
    hands.hands_load_state(os.path.join(STATES, state).encode())
    wait(300)
    for layout in simple.GetLayouts().values():
        check(len(simple.GetViewsInLayout(layout)) > 0, "a layout without views")
    check(len(simple.GetSources()) >= 2, "the state has no pipeline")
    picture(state[:-3] + ".png")
    check_equal(messages(), "", "messages of " + state)


try:
    hands.hands_window(1200, 900, 300)
    wait(500)
    simple.LoadPlugin(os.environ["PLUGIN"], remote=False, ns=vars(simple))
    wrong = 0
    for state in sorted(name for name in os.listdir(STATES) if name.endswith(".py")):
        print(state, flush=True)
        try:
            test(state)
        except AssertionError:
            # The next may be well.
            traceback.print_exc()
            wrong += 1
    if not wrong:
        print("all well")
except BaseException:
    traceback.print_exc()
sys.stdout.flush()
hands.hands_quit()
