"""The help pages of the plugin's sources and filters, in the client's help; started by run_client.py."""
from paraview import servermanager

from gui_driver import check, gui, run


def page(group, name):
    return gui.gui_help(("%s.%s.html" % (group, name)).encode()).decode()


def test_every_proxy_has_a_page():
    count = 0
    manager = servermanager.ProxyManager()
    for group in "sources", "filters":
        for name in dir(getattr(servermanager, group)):
            proxy = manager.GetPrototypeProxy(group, name)
            hints = proxy.GetHints() if proxy else None
            menu = hints.FindNestedElementByName("ShowInMenu") if hints else None
            if menu and (menu.GetAttribute("icon") or "").startswith(":/CrossField/"):
                count += 1
                text = page(group, name)
                check("<h2>%s (%s)</h2>" % (proxy.GetXMLLabel(), name) in text, "the title of the page of " + name)
    check(count >= 20, "only %d sources and filters" % count)


def test_a_page():
    text = page("filters", "LayoutDesigner")
    check("<td>Quad Count</td>" in text, "no property")
    check("<td>Cap Corners</td>" in text, "no property of a base")
    check("<b>" in text and "**" not in text, "marks of bold text")


def test_the_glossary():
    """Pages link to the glossary, which is a page of the help too."""
    check('the terms are explained in the <a href="glossary.html">glossary</a>' in page("filters", "LayoutDesigner").lower(), "no link")
    text = gui.gui_help(b"glossary.html").decode()
    check("<h2>Glossary</h2>" in text and "<b>Quarter index (k).</b>" in text, "the page of the glossary")
    check("](" not in text and "![" not in text, "marks of links and pictures")


run("test_", globals(), lambda test: test(), (600, 400, 200))
