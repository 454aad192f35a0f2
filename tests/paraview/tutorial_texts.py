"""Pictures of docs/tutorial_paraview.md, and the texts of the program that they show.

docs/pictures/tutorial_texts.txt lists them, one line for a text: the picture, a tab, and the text. A test fails if the program
no longer shows a text of the list, because the picture is then out of date; scripts/pictures.sh draws it again.
"""
import os
import re

from paraview.simple import GetActiveSource, GetActiveView, GetSources

from gui_driver import check, picture

LIST = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "docs", "pictures", "tutorial_texts.txt")


def labels(proxy):
    """Returns the labels in the panel of a proxy."""
    iterator = proxy.SMProxy.NewPropertyIterator()
    found = []
    iterator.Begin()
    while not iterator.IsAtEnd():
        if iterator.GetProperty().GetPanelVisibility() == "default" and not iterator.GetProperty().GetInformationOnly():
            found.append(iterator.GetProperty().GetXMLLabel())
        iterator.Next()
    return sorted(found)


def texts():
    """Returns the texts in the view, the names in the Pipeline Browser, and the labels of the panel."""
    found = []
    for shown in GetActiveView().Representations:
        if shown.GetXMLName() == "TextSourceRepresentation" and shown.Visibility:
            drawn = shown.GetClientSideObject().GetTextWidgetRepresentation().GetRepresentation().GetText()
            found.append(" ".join(drawn.split()))
    for (name, _), source in sorted(GetSources().items()):
        ports = source.SMProxy.GetNumberOfOutputPorts()
        found += [name] + ([source.SMProxy.GetOutputPortName(port) for port in range(ports)] if ports > 1 else [])
    return [text for text in found + labels(GetActiveSource()) if text]


def masked(text):
    """Returns a text without its numbers, which depend on rounding and on the pixels of the window."""
    return re.sub(r"[-−]?\d+(\.\d+)?", "0", text)


def settled_picture(name):
    """Saves a picture once two in succession are equal, because a busy machine draws later."""
    file, before = os.path.join(os.environ["FOLDER"], name), None
    for _ in range(30):
        picture(name, is_whole_window=False)
        with open(file, "rb") as saved:
            content = saved.read()
        if content == before:
            break
        before = content


def tutorial_picture(name):
    """Saves a picture, stores its texts beside it, and checks those of the list."""
    settled_picture(name + ".png")
    found = texts()
    with open(os.path.join(os.environ["FOLDER"], "tutorial_texts.txt"), "a", encoding="utf-8") as stored:
        stored.writelines("tutorial_%s.png\t%s\n" % (name, text) for text in found)
    if "CROSSFIELD_DRAW" in os.environ:  # scripts/pictures.sh replaces pictures and list
        return
    with open(LIST, encoding="utf-8") as listed:
        lines = [line.rstrip("\n").split("\t") for line in listed]
    expected = [text for file, text in lines if file == "tutorial_%s.png" % name]
    check(expected, "no texts of tutorial_%s.png in %s" % (name, LIST))
    current = {masked(text) for text in found}
    for text in expected:
        check(masked(text) in current, "tutorial_%s.png shows a text that the program no longer has; run scripts/pictures.sh: %s"
              "\nIt has now:\n%s" % (name, text, "\n".join(found)))
