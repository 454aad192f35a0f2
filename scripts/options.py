"""Makes docs/options.md: how the options of Quad Mesher's panel, of `crossfield quads` and of crossfield.quads correspond.

    python3 scripts/options.py PROGRAM [PAGE.md]

Reads the definitions of the panel (paraview-plugin), the help of PROGRAM, and the Python package (filters/python). Ends with a
sentence if an option of one of them is in no row, a row names something that does not exist, or the program or the package
does not call the function of the row.
"""
import ast
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as tree

ROOT = pathlib.Path(__file__).resolve().parent.parent

# An option and an argument belong to the property of the same name: --cap-corners and cap_corners to CapCorners. Here are
# those with other names: property, options, arguments.
DIFFERENT = {
    # Shorter, because the program and the function make nothing but quads.
    "QuadSize": ("--size", "size"), "QuadCount": ("--quads", "count"), "SplitSingularities": ("--split", "split"),
    "HoldSingularities": ("--hold", "hold"), "MinimumSize": ("--min-size", "min_size"),
    "MaximumSize": ("--max-size", "max_size"), "OpenLines": ("--open", "open_lines"),
    # Named after what is given, not after the array that has it.
    "Input": ("DOMAIN", "domain"), "SideNameArray": ("--names", "names"), "MaterialArray": ("--materials", "materials"),
    "SizeArray": ("--sizing", "size_array"),
    # In the singular, because each has one entry and is repeated.
    "Lines": ("--line", "lines"), "Nodes": ("--node", "nodes"), "Sides.Count": ("--count", "counts"),
    "Sides.Progression": ("--progression", "progressions"), "Sides.Size": ("--size-at", "sizes"),
    "SizesNear": ("--size-near", "sizes_near"), "SizesInside": ("--size-in", "sizes_inside"),
    "CornerRows": ("--corner", "corners"), "Curves": ("--curve --curves", "curves"),
    "Merge": ("--merge --coarse", "merge"),
}
# Properties with a column for each option of the program.
COLUMNS = {"Sides": ("Count", "Progression", "Size")}
# What the program does with other filters, with the outputs of Quad Mesher, or alone: properties or outputs, option, and what
# Python has instead.
OTHERS = [
    ("BoundarySimplifier.Part", "--part", "simplify.part"),
    ("DrawingReader.Layers", "--drawing-layer", "read.layers"),
    ("DrawingReader.ClosedCurvesAreRegions", "--materials", "read.closed_curves_are_regions"),
    ("DrawingReader.AllFaces", "--all-faces", "read.all_faces"),
    ("DrawingReader.JoinTolerance", "--join-tolerance", "read.join_tolerance"),
    ("BoundarySimplifier.ThinningLength", "--thin-boundary", "simplify.thin"),
    ("BoundarySimplifier.SmoothingLength", "--smooth-boundary", "simplify.smooth"),
    ("QuadsToHigherOrder.Order", "--order", "quads.order"),
    ("ExtrudeQuads.Height ExtrudeQuads.Layers ExtrudeQuads.Ratio", "--extrude", "QuadMesh.extrude"),
    ("ExtrudeQuads.Angle ExtrudeQuads.Layers ExtrudeQuads.Axis", "--revolve", "QuadMesh.revolve"),
    ("QuadMeshWriter.MshVersion", "--msh-version", ""),
    ("QuadMeshWriter.PatchTypes", "--patch-type", "QuadMesh.write"),
    ("QuadMeshWriter.FileName", "--output", "QuadMesh.write"),
    ("output Blocks", "--blocks", "QuadMesh.blocks"),
    ("output Layout", "--layout", "QuadMesh.layout"),
    ("output Singularities", "--save-singularities", "QuadMesh.singularities"),
    ("output Summary", "--json", "QuadMesh.report"),
    ("output Summary", "--verbose", "QuadMesh.report"),
]
HEAD = """\
# Options: ParaView, program, Python

To find in one interface what you know from another, look for its row: each row is an option of *Quad Mesher* in ParaView, of
`crossfield quads` and of `crossfield.quads`. A dash means that an interface has no such option.

- The first column has the name in the panel, of *Quad Mesher* unless another filter is given; pvpython has the same name without
  spaces, and C++ the function below it.
- The second column has the usage as in `crossfield quads --help`.
- In Python, the names are arguments of `crossfield.quads`, unless another function of the [package](python.md) is given; `QuadMesh` is what
  `quads` returns.
- The last column has the default in ParaView, or of the program where ParaView has no such option.

[Quad Mesher](filters/QuadMesher.md) describes the options at length. `scripts/options.py` makes this page from the source code.
"""


def camel_to(separator, name):
    return re.sub(r"(?<=[a-z])(?=[A-Z])", separator, name).lower()


def sentence(text):
    """Returns the first sentence of a documentation."""
    return re.match(r".*?\.(?=\s|$)", " ".join(text.split()) + " ").group()


class Panel:
    """Properties of all filters, and the outputs of Quad Mesher."""

    def __init__(self, folder):
        self.proxies = {}
        for name in sorted(folder.glob("*.xml")):
            for proxy in tree.parse(str(name)).getroot().iter():
                if proxy.tag in ("SourceProxy", "WriterProxy"):
                    self.proxies[proxy.get("name")] = proxy
        self.properties = list(self.of("QuadMesher"))
        self.outputs = [port.get("name") for port in self.proxies["QuadMesher"].findall("OutputPort")]
        self.read_groups()

    def read_groups(self):
        """Reads the groups of the panel; other properties and options are in the last one, Other."""
        self.groups = {group.get("label"): [element.get("name") for element in group.findall("Property")]
                       for group in self.proxies["QuadMesher"].findall("PropertyGroup[@label]")}
        self.groups["Other"] = []

    def of(self, name):
        """Returns the properties of a filter by their names, first those that it inherits."""
        proxy = self.proxies[name]
        base = proxy.get("base_proxyname")
        found = self.of(base) if base else {}
        found.update((element.get("name"), element) for element in proxy if element.tag.endswith("Property"))
        return found

    def property(self, name):
        """Returns the filter and the element of a property, such as Order of QuadsToHigherOrder.Order."""
        owner, _, own = name.rpartition(".")
        owner = owner if owner in self.proxies else "QuadMesher"
        own = own if owner != "QuadMesher" else name.partition(".")[0]
        element = self.of(owner).get(own)
        if element is None:
            sys.exit("%s has no property %s; correct scripts/options.py." % (owner, own))
        return owner, element

    def group(self, name):
        return next((group for group, names in self.groups.items() if name.partition(".")[0] in names), "Other")

    def cell(self, names):
        """Returns what the first column says about properties of one filter, or an output."""
        if names.startswith("output "):
            if names[7:] not in self.outputs:
                sys.exit("Quad Mesher has no %s; correct scripts/options.py." % names)
            return "output *%s*" % names[7:]
        labels, functions = [], []
        for name in names.split():
            owner, element = self.property(name)
            label = element.get("label") or element.get("name")
            if label.replace(" ", "") != element.get("name"):
                sys.exit("The label %s of %s is not its name with spaces." % (label, name))
            labels.append("*%s*" % label)
            functions.append(self.function(owner, element))
        column = names.partition(".")[2] if owner == "QuadMesher" else ""
        return "%s%s%s<br>`%s`" % (", ".join(labels), ", column *%s*" % column if column else "",
                                   "" if owner == "QuadMesher" else " of **%s**" % self.proxies[owner].get("label"),
                                   "`, `".join(functions))

    def function(self, owner, element):
        """Returns the function of C++ for a property, which must be in the header of the filter."""
        header = (ROOT / "filters" / "vtk" / ("vtk%s.h" % owner)).read_text(encoding="utf-8")
        name = element.get("command")
        if element.tag == "InputProperty" and element.get("port_index", "0") != "0":
            name = "Set%sConnection" % element.get("name")
            is_there = "PortMacro(%s," % element.get("name") in header
        else:
            is_there = (element.tag == "InputProperty" or re.search(r"\b%s\(" % name, header)
                        or re.search(r"vtkSet\w*Macro\(%s," % re.sub("^Set", "", name), header))
        if not is_there:
            sys.exit("vtk%s has no function %s for its property %s." % (owner, name, element.get("name")))
        return name

    def text(self, name):
        """Returns the purpose and the default of a property."""
        element = self.property(name)[1]
        text = " ".join(element.find("Documentation").text.split())
        value = element.get("default_values", "")
        named = {entry.get("value"): entry.get("text") for entry in element.iterfind("EnumerationDomain/Entry")}
        if element.find("BooleanDomain") is not None:
            named = {"0": "off", "1": "on"}
        default = re.search(r"Default: (.*?)\.(?=\s|$)", text)
        default = default.group(1) if default else ""
        value = named.get(value, value)
        # Lists have no value, and numbers have several spellings.
        if value and default and not re.match(re.escape(re.sub(r"\.0$", "", value)), default.lstrip("*")):
            sys.exit("The documentation of %s gives the default '%s', but it is %s." % (name, default, value))
        # A text that begins with a value has a sentence for each.
        purpose = text.partition(" Default:")[0] if text.startswith("*") else sentence(text)
        return re.sub(r"^Optional: (.)", lambda match: match.group(1).upper(), purpose), re.sub(r"\.\.$", "...", default)


def options_of(text):
    """Returns the options of a program's help as name: (how to write it, purpose, default)."""
    found = {}
    # CLI11 writes its headings in capitals from version 2.5 on.
    text = re.split(r"(?i)\npositionals:", "\n" + text)[-1].partition("\nExample:")[0]
    text = re.sub(r"(?i)\n\noptions:", "", text)
    # An option begins with two spaces; its purpose is behind it, or in the lines below.
    for entry in re.split(r"\n  (?=\S)", text)[1:]:
        usage, purpose = (re.split(r"\n {10,}| {2,}", entry, maxsplit=1) + [""])[:2]
        written = re.sub(r":(?:NONNEGATIVE|POSITIVE)\b|:\w+ in \[.*?\]|\{false\}| (?:Excludes|REQUIRED|\.\.\.).*", "", usage)
        written = re.sub(r" WORD:\{(.*?)\}", lambda match: " " + match.group(1).replace(",", "|"), written)
        written = re.sub("^DOMAIN TEXT", "DOMAIN", written).replace(",--", ", --")
        purpose = re.sub(r"; (?:repeatable|may be repeated)\b", "", " ".join(purpose.split()))
        purpose, _, default = purpose.partition("; default: ")
        name = re.findall(r"--[\w-]+|^DOMAIN", written)[0]
        found[name] = written, purpose[:1].upper() + purpose[1:] + ".", default
    del found["--help"]
    return found


class Package:
    """Functions and classes of the Python package."""

    def __init__(self, folder):
        self.names = {}
        for path in sorted(folder.glob("_*.py")):
            for node in ast.parse(path.read_text(encoding="utf-8")).body:
                if isinstance(node, ast.FunctionDef):
                    arguments = node.args.args + node.args.kwonlyargs
                    self.names[node.name] = [argument.arg for argument in arguments]
                elif isinstance(node, ast.ClassDef):
                    self.names[node.name] = [getattr(entry, "name", getattr(getattr(entry, "target", None), "id", None))
                                             for entry in node.body]

    def cell(self, name):
        if not name:
            return "–"
        owner, _, own = name.partition(".")
        if own not in self.names.get(owner, ()):
            sys.exit("In Python, %s has no %s; correct scripts/options.py." % (owner, own))
        if owner == "quads":
            return "`%s`" % own
        return "`%s.%s`" % (owner, own) if owner[0].isupper() else "`%s` of `%s`" % (own, owner)


def check_calls(panel, name, option, argument):
    """Ends unless the program and the package call the function of a property exactly if they have an option for it."""
    function = panel.function(*panel.property(name))
    ports = re.sub("Connection$", "(?:Connection|Data)", function)  # data or the filter before
    for given, *files in ((option, "pipelines/QuadsCommand.cxx", "pipelines/io/SideOptions.cxx"),
                          (argument, "filters/python/_quads.py")):
        source = "".join((ROOT / file).read_text(encoding="utf-8") for file in files)
        if bool(given) != bool(re.search(r"mesher(?:->|\.)%s\(" % ports, source)):
            sys.exit("%s: %s does %scall %s; correct scripts/options.py."
                     % (name, files[0], "not " if given else "", function))


def rows_of(panel, options, package):
    """Returns rows of a group and five cells, and ends if an option or argument is in none of them."""
    rows, entries, used, given = [], [], set(), set()
    for name in panel.properties:
        for full in ["%s.%s" % (name, column) for column in COLUMNS.get(name, ())] or [name]:
            option, argument = "--" + camel_to("-", name), camel_to("_", name)
            option, argument = DIFFERENT.get(full, (option if option in options else "",
                                                    argument if argument in package.names["quads"] else ""))
            check_calls(panel, full, option, argument)
            entries.append((panel.group(full), full, option, "quads." + argument if argument else ""))
    order = list(panel.groups)
    entries.sort(key=lambda entry: order.index(entry[0]))
    for group, names, option, argument in entries + [("Other", *entry) for entry in OTHERS]:
        unknown = [name for name in option.split() if name not in options]
        if unknown:
            sys.exit("The program has no option %s; correct scripts/options.py." % unknown[0])
        used.update(option.split())
        given.add(argument)
        if names.startswith("output ") or " " in names:
            purpose, default = options[option][1:]
        else:
            purpose, default = panel.text(names)
            # A column of a property has no documentation of its own.
            purpose = options[option][1] if panel.property(names)[0] == "QuadMesher" and "." in names else purpose
        written = "<br>".join("`%s`" % options[name][0] for name in option.split()) or "–"
        cells = panel.cell(names), written, package.cell(argument), purpose, default or "–"
        rows.append((group, *(cell.replace("|", "\\|") for cell in cells)))
    missing = [name for name in options if name not in used]
    missing += ["argument %s of crossfield.quads" % name for name in package.names["quads"] if "quads." + name not in given]
    if missing:
        sys.exit("No row has %s; add it to scripts/options.py." % ", ".join(missing))
    return rows


def page(panel, options, package):
    rows = rows_of(panel, options, package)
    text = HEAD
    for group in panel.groups:
        inside = [row[1:] for row in rows if row[0] == group]
        if inside:
            text += "\n## %s\n\n| ParaView and C++ | `crossfield quads` | Python | purpose | default |\n" % group
            text += "| --- | --- | --- | --- | --- |\n" + "".join("| %s |\n" % " | ".join(row) for row in inside)
    return text


def read(program):
    """Returns what the page is made from."""
    done = subprocess.run([program, "quads", "--help"], stdout=subprocess.PIPE, universal_newlines=True, check=True)
    return Panel(ROOT / "paraview-plugin"), options_of(done.stdout), Package(ROOT / "filters" / "python")


if __name__ == "__main__":
    target = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else ROOT / "docs" / "options.md"
    target.write_text(page(*read(sys.argv[1])), encoding="utf-8")
