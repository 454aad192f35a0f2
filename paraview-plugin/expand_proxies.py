"""Prepares the definitions of proxies for ParaView: expand_proxies.py FOLDER GLOSSARY DEFINITION...

Writes all proxies that have a class to one file, with the properties of their bases (ParaView 5.11 does not override a
property in the middle of a chain of bases), and a page FOLDER/help/GROUP.NAME.html for each, the name under which the
client looks for its help. The page help/glossary.html, to which they link, has the texts of GLOSSARY. (ParaView's own generator of help needs xmlpatterns, which Qt 6 does not have.)
"""
import copy
import html
import os
import re
import sys
import textwrap
import xml.etree.ElementTree as tree

PAGE = """<html><head><title>{label}</title></head><body>
<h2>{label} ({name})</h2>
<p><i>{short}</i></p>
{text}
<table width="97%" border="1">
<tr><th>Property</th><th width="60%">Description</th><th>Default</th><th>Values</th></tr>
{rows}
</table>
</body></html>
"""


def is_property(element):
    return element.tag.endswith("Property")


def expanded(proxy, proxies):
    """Returns a copy of a proxy with the elements of its bases first; a property with override="1"
    replaces one in its place."""
    result = copy.deepcopy(proxy)
    base = (result.attrib.pop("base_proxygroup", None), result.attrib.pop("base_proxyname", None))
    if base == (None, None):
        return result
    own = list(result)
    result[:] = list(expanded(proxies[base], proxies))
    for element in own:
        same = [index for index, other in enumerate(result) if is_property(element)
                and is_property(other) and other.get("name") == element.get("name")]
        if (element.attrib.pop("override", None) == "1") != bool(same):
            sys.exit("%s.%s: override=\"1\" is for a property that a base has"
                     % (proxy.get("name"), element.get("name")))
        if same:
            result[same[0]] = element
        else:
            result.append(element)
    return result


def move_to_groups(proxy):
    """Moves the properties of each group that has no widget of its own in front of it, in its order: the panel shows a
    group where its first property is."""
    for group in proxy.findall("PropertyGroup"):
        if group.get("panel_widget") is None:
            names = [item.get("name") for item in group.findall("Property")]
            members = {item.get("name"): item for item in proxy if is_property(item) and item.get("name") in names}
            for member in members.values():
                proxy.remove(member)
            start = list(proxy).index(group)
            proxy[start:start] = [members[name] for name in names]


def formatted(documentation):
    """Returns the text of an element as HTML."""
    text = documentation.text if documentation is not None and documentation.text else ""
    first, newline, others = text.partition("\n")
    made = marked((first.strip() + newline + textwrap.dedent(others)).strip())
    return made.replace("docs/glossary.md", 'the <a href="glossary.html">glossary</a>')


def marked(text):
    """Returns a text with marks of bold and italics and lists, those of ParaView and Markdown, as HTML."""
    text = html.escape(text, quote=False)
    text = re.sub(r"\*\*([^*]+)\*\*", r"<b>\1</b>", text)
    text = re.sub(r"\*([^*]+)\*", r"<i>\1</i>", text)
    parts = []
    for paragraph in re.split(r"\n\s*\n", text):
        before, *items = re.split(r"(?:^|\n)\s*- ", paragraph)
        parts.append("<p>%s</p>" % before if before else "")
        if items:
            parts.append("<ul>%s</ul>" % "".join("<li>%s</li>" % item for item in items))
    return "\n".join(part for part in parts if part)


def row(element):
    """Returns the row of a property; None if it is not for the user."""
    documentation = element.find("Documentation")
    if documentation is None or element.get("panel_visibility") == "never":
        return None
    values = {entry.get("value"): entry.get("text")
              for entry in element.iterfind("EnumerationDomain/Entry")}
    if element.find("BooleanDomain") is not None:
        values = {"0": "off", "1": "on"}
    default = element.get("default_values", "")
    cells = [html.escape(element.get("label") or element.get("name")), formatted(documentation),
             html.escape(values.get(default, default)), html.escape(", ".join(values.values()))]
    return "<tr>%s</tr>" % "".join("<td>%s</td>" % cell for cell in cells)


def page(proxy):
    """Returns the help page of a proxy."""
    documentation = proxy.find("Documentation")
    rows = [row(element) for element in proxy if is_property(element)]
    return PAGE.format(
        label=html.escape(proxy.get("label") or proxy.get("name")), name=proxy.get("name"),
        short=html.escape(documentation.get("short_help", "") if documentation is not None else ""),
        text=formatted(documentation), rows="\n".join(filter(None, rows)))


def glossary(file_name):
    """Returns a page with the texts of the glossary, without pictures and links."""
    with open(file_name, encoding="utf-8") as file:
        text = re.sub(r"^!\[.*\n", "", file.read(), flags=re.MULTILINE)
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    parts = [re.sub(r"^<p>(#+) (.*)</p>$", r"<h2>\2</h2>", marked(part)) for part in re.split(r"\n\s*\n", text)]
    return "<html><head><title>Glossary</title></head><body>\n%s\n</body></html>\n" % "\n".join(parts)


def write(path, text):
    """Writes a file unless it has this text already, which would compile the plugin again."""
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            if file.read() == text:
                return
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def main(folder, glossary_file, *inputs):
    groups = [group for name in inputs for group in tree.parse(name).getroot()]
    proxies = {(group.get("name"), proxy.get("name")): proxy for group in groups for proxy in group}
    os.makedirs(os.path.join(folder, "help"), exist_ok=True)
    write(os.path.join(folder, "help", "glossary.html"), glossary(glossary_file))
    root = tree.Element("ServerManagerConfiguration")
    for group in groups:
        concrete = [expanded(proxy, proxies) for proxy in group if proxy.get("class")]
        if concrete:
            tree.SubElement(root, "ProxyGroup", name=group.get("name")).extend(concrete)
        for proxy in concrete:
            move_to_groups(proxy)
            write(os.path.join(folder, "help", "%s.%s.html" % (group.get("name"), proxy.get("name"))), page(proxy))
    write(os.path.join(folder, "CrossField.xml"), tree.tostring(root, encoding="unicode") + "\n")


main(*sys.argv[1:])
