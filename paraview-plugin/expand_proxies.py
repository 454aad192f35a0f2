"""Expands the inheritance of proxies: expand_proxies.py OUTPUT INPUT...

Writes all proxies that have a class, with the properties of their bases, to one file. The rules are
ParaView's own: inherited elements come first, and a property with override="1" replaces one in its
place. ParaView's generator of the help reads each proxy alone and would list no inherited property.
"""
import copy
import os
import sys
import xml.etree.ElementTree as tree


def is_property(element):
    return element.tag.endswith("Property")


def expanded(proxy, proxies):
    """Returns a copy of a proxy with the elements of its bases."""
    result = copy.deepcopy(proxy)
    base = (result.attrib.pop("base_proxygroup", None), result.attrib.pop("base_proxyname", None))
    if base == (None, None):
        return result
    own = list(result)
    result[:] = list(expanded(proxies[base], proxies))
    for element in own:
        same = [index for index, other in enumerate(result) if is_property(element)
                and is_property(other) and other.get("name") == element.get("name")]
        overrides = element.attrib.pop("override", None) == "1"
        if overrides != bool(same):
            sys.exit("%s.%s: override=\"1\" is for a property that a base has"
                     % (proxy.get("name"), element.get("name")))
        if overrides:
            result[same[0]] = element
        else:
            result.append(element)
    return result


def main(output, *inputs):
    groups = [group for name in inputs for group in tree.parse(name).getroot()]
    proxies = {(group.get("name"), proxy.get("name")): proxy for group in groups for proxy in group}
    root = tree.Element("ServerManagerConfiguration")
    for group in groups:
        concrete = [expanded(proxy, proxies) for proxy in group if proxy.get("class")]
        if concrete:
            tree.SubElement(root, "ProxyGroup", name=group.get("name")).extend(concrete)
    text = tree.tostring(root, encoding="unicode") + "\n"
    if os.path.exists(output):
        with open(output, encoding="utf-8") as file:
            if file.read() == text:
                return
    with open(output, "w", encoding="utf-8") as file:
        file.write(text)


main(*sys.argv[1:])
