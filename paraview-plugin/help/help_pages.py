"""Writes the help pages of the plugin: help_pages.py FOLDER DEFINITION...

Each proxy that has a class becomes GROUP.NAME.html, the name under which the client looks for its help.
ParaView's own generator needs xmlpatterns, which Qt 6 does not have, and leaves out inherited properties.
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
    replaces one in its place, as in ParaView."""
    result = copy.deepcopy(proxy)
    base = (proxy.get("base_proxygroup"), proxy.get("base_proxyname"))
    if base == (None, None):
        return result
    own = list(result)
    result[:] = list(expanded(proxies[base], proxies))
    for element in own:
        same = [index for index, other in enumerate(result) if is_property(element)
                and is_property(other) and other.get("name") == element.get("name")]
        if (element.get("override") == "1") != bool(same):
            sys.exit("%s.%s: override=\"1\" is for a property that a base has"
                     % (proxy.get("name"), element.get("name")))
        if same:
            result[same[0]] = element
        else:
            result.append(element)
    return result


def formatted(documentation):
    """Returns the text of an element, with ParaView's marks of bold and italics and its lists, as HTML."""
    text = documentation.text if documentation is not None and documentation.text else ""
    first, newline, others = text.partition("\n")
    text = html.escape((first.strip() + newline + textwrap.dedent(others)).strip(), quote=False)
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


def main(folder, *inputs):
    groups = [group for name in inputs for group in tree.parse(name).getroot()]
    proxies = {(group.get("name"), proxy.get("name")): proxy for group in groups for proxy in group}
    os.makedirs(folder, exist_ok=True)
    for (group, name), proxy in proxies.items():
        if not proxy.get("class"):
            continue
        proxy = expanded(proxy, proxies)
        documentation = proxy.find("Documentation")
        rows = [row(element) for element in proxy if is_property(element)]
        with open(os.path.join(folder, "%s.%s.html" % (group, name)), "w", encoding="utf-8") as file:
            file.write(PAGE.format(
                label=html.escape(proxy.get("label") or name), name=name,
                short=html.escape(documentation.get("short_help", "") if documentation is not None else ""),
                text=formatted(documentation), rows="\n".join(filter(None, rows))))


main(*sys.argv[1:])
