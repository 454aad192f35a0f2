"""File > Save Data of quads for solvers in ParaView's client, as a first user does it; started by
run_client.py.

Every step of the user is counted.
"""
import os

from paraview.simple import *

from gui_driver import check, check_equal, gui, messages, picture, run, wait

FOLDER = os.environ["FOLDER"]


class User:
    """Counts actions."""

    def __init__(self):
        self.actions = 0

    def do(self, isDone, what):
        self.actions += 1
        wait(200)
        check(isDone, what)


def make(name):
    check(gui.gui_trigger(name), "%s is not in the menu" % name)
    check(gui.gui_click(b"Apply"), "no Apply")
    wait(600)
    return GetActiveSource()


def read(name):
    with open(os.path.join(FOLDER, name), "rb") as file:
        return file.read()


def save(item, name):
    """Selects an item of the Pipeline Browser and saves it; returns the number of actions."""
    user = User()
    user.do(gui.gui_select(item), "%s is not in the Pipeline Browser" % item)
    # File > Save Data, and the name with Enter: no further dialog.
    user.actions += 1
    user.do(gui.gui_save(os.path.join(FOLDER, name).encode(), None, None), "%s cannot be saved" % name)
    check_equal(messages(), "", "messages of " + name)
    return user.actions


def test_formats():
    domain = PlanarDomainSource(registrationName="Domain", DomainName="l-shape")
    Show(domain)
    SetActiveSource(domain)
    wait()
    mesher = make(b"Quad Mesher")
    wait()
    os.makedirs(os.path.join(FOLDER, "case"), exist_ok=True)
    for name in "quads.msh", "quads.msh2", "quads.inp", "quads.su2", "quads.exo", "quads.xyz", "case/case.foam":
        if name == "quads.exo" and GetParaViewVersion() >= (5, 12):
            continue  # has a writer of its own for this ending
        check_equal(save(b"QuadMesher1", name), 3, "actions to save " + name)
        content = read({"case/case.foam": "case/constant/polyMesh/boundary", "quads.xyz": "quads.nmf"}.get(name, name))
        if name != "quads.xyz":  # types of the .nmf
            for side in range(6):
                check(b"outer%d" % side in content, "side %d in %s" % (side, name))
    check(read("quads.msh").startswith(b"$MeshFormat\n4.1 "), "the version of .msh")
    check(read("quads.msh2").startswith(b"$MeshFormat\n2.2 "), "the version of .msh2")
    # The quads of filters behind the mesher, made with the menu alone.
    SetActiveSource(mesher)
    wait()
    make(b"Quads To Higher Order")
    check_equal(save(b"QuadsToHigherOrder1", "curved.inp"), 3, "actions to save quads of order 2")
    check(b"TYPE=CPS8" in read("curved.inp") and b"NAME=outer5" in read("curved.inp"), "quads of order 2")
    SetActiveSource(mesher)
    wait()
    make(b"Extrude Quads")
    check_equal(save(b"Hexahedra", "solid.msh"), 3, "actions to save hexahedra")
    check(b'"outer5"' in read("solid.msh") and b'"back"' in read("solid.msh"), "sides of hexahedra")
    picture("save_data.png")


def run_with_counts(test):
    ResetSession()
    wait(200)
    GetActiveViewOrCreate("RenderView")
    test()


run("test_", globals(), run_with_counts, (1200, 900, 370))
