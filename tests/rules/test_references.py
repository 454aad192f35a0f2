"""Checks that cited sections, links and files exist.

    python3 test_references.py

- A reference `docs/method.md §3.1` needs a heading with that number there or in docs/method, and every
  section sign needs its document before it.
- A relative link in a .md page needs an existing file, and its #anchor an existing heading.
- A source or page that is named in a comment or page must be in the tree.
- Documents outside the tree must not be cited.
- The README must be short; longer explanations belong in docs.

The tree consists of the files that git tracks and new files; without git, of all files.
"""
import os
import re
import subprocess
import tempfile
import unittest

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
METHOD_PAGE = "docs/method.md"
README_LINES = 115
# Broken up, because this file is checked too.
ELSEWHERE = re.compile(
    r"(?<!\w)(?:MET" r"HOD|DES" r"IGN|STY" r"LE(?= ?§|\.md)|QUA" r"DS|\.\./sha" r"red)(?!\w)")
SUFFIXES = r"(?:h|hpp|cxx|cpp|md|pyi?|sh|cmake|xml|yml|yaml|module|plugin)(?:\.in)?"
MENTION = re.compile(r"(?<![\w./$}{%@*<>=-])((?:\.{1,2}/)*(?:[\w.-]+/)*[\w-][\w.-]*\." + SUFFIXES +
                     r")(?![\w*/(-]|\.\w)")
# Files of other projects, files of builds, and placeholders in usage texts.
FOREIGN = re.compile(r"(?:vtk\w*|CGAL/.*|Eigen/.*|cholmod|cblas|lapacke?)\.h$|Find\w+\.cmake$|build[\w-]*/"
                     r"|(?:PAGE\.md|SCRIPT\.py|STATE\.py|DRAW_H\.py)$")
# A line break inside a comment.
GAP = r"(?:[ \t`)\]]|\n[ \t]*(?:///?|#|\*)?[ \t]*)*"
SECTION = re.compile(r"method\.md" + GAP + r",?" + GAP + r"(§\d+(?:\.\d+)?(?:(?:,|;|–| and| to| or)?" + GAP +
                     r"§\d+(?:\.\d+)?)*)")
LITERAL = r'"(?:\\.|[^"\\\n])*"' + r"|'(?:\\.|[^'\\\n])*'"
COMMENTS = {
    "cxx": re.compile(r"(?P<comment>//[^\n]*|/\*.*?\*/)|" + LITERAL, re.DOTALL),
    "py": re.compile(r'(?P<comment>#[^\n]*|""".*?""")|' + LITERAL, re.DOTALL),
    "sh": re.compile(r"(?P<comment>(?<![^\s])#[^\n]*)"),
}
KINDS = {".h": "cxx", ".cxx": "cxx", ".py": "py", ".pyi": "py", ".sh": "sh", ".cmake": "sh", ".txt": "sh",
         ".yml": "sh", ".module": "sh", ".plugin": "sh", ".md": "all", ".xml": "all", "": "sh"}


def tree(root):
    """Returns the names of all files, relative to the root."""
    names = []
    try:
        listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                                cwd=root, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=True,
                                encoding="utf-8")
        names = listed.stdout.split("\0")
    except (OSError, subprocess.CalledProcessError):  # no git, or not a tree of it
        for folder, inside, files in os.walk(root):
            inside[:] = [name for name in inside if not name.startswith(("build", "__pycache__", ".git"))]
            names += [os.path.relpath(os.path.join(folder, name), root) for name in files]
    return sorted(name for name in set(names) if os.path.isfile(os.path.join(root, name)))


def kind_of(name):
    ending = os.path.splitext(re.sub(r"\.in$", "", name))[1]
    is_data = name.startswith(("tests/data/crashers", "tests/fuzz/corpus")) and ending != ".md"
    return None if is_data else KINDS.get(ending)


def read(root):
    """Returns the text of every text file by its name, None for other files."""
    texts = {}
    for name in tree(root):
        texts[name] = None
        if kind_of(name):
            with open(os.path.join(root, name), encoding="utf-8") as file:
                texts[name] = file.read()
    return texts


def slug(heading):
    """Returns the anchor of a heading."""
    plain = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", plain).replace(" ", "-")


def without_code(page):
    """Returns a page without its code; lines keep their numbers."""
    def blank(match):
        return "\n" * match.group().count("\n")
    return re.sub(r"`[^`\n]*`", "``", re.sub(r"^```.*?^```$", blank, page, flags=re.DOTALL | re.MULTILINE))


def headings(page):
    prose = re.sub(r"^```.*?^```$", "", page, flags=re.DOTALL | re.MULTILINE)
    return re.findall(r"^#+ +(.*)$", prose, re.MULTILINE)


def anchors(page):
    found = set()
    for heading in headings(page):
        name, count = slug(heading), 0
        while name in found:
            count += 1
            name = "%s-%d" % (slug(heading), count)
        found.add(name)
    return found


def line_of(text, place):
    return text.count("\n", 0, place) + 1


def is_of_the_method(name):
    return name == METHOD_PAGE or name.startswith("docs/method/")


def section_findings(texts):
    if METHOD_PAGE not in texts:
        return ["There is no %s, whose sections are cited" % METHOD_PAGE]
    there = {number for name in texts if is_of_the_method(name)
             for number in re.findall(r"^#+ +(\d+(?:\.\d+)?)\.? ", texts[name], re.MULTILINE)}
    found = []
    for name, text in texts.items():
        cited = []
        if is_of_the_method(name):
            cited = [(match.start(), match.group(1)) for match in re.finditer(r"§(\d+(?:\.\d+)?)", text)]
        elif text:
            for match in SECTION.finditer(text):
                cited += [(match.start(), number)
                          for number in re.findall(r"§(\d+(?:\.\d+)?)", match.group(1))]
        found += ["%s:%d cites %s §%s, which does not exist" % (name, line_of(text, place), METHOD_PAGE, number)
                  for place, number in cited if number not in there]
    return found


def bare_findings(texts):
    found = []
    for name, text in texts.items():
        # A list of sections may continue in the next comment.
        cited = [match.span() for match in SECTION.finditer(text or "")]
        for place, comment in comments(name, text) if text and not is_of_the_method(name) else ():
            found += ["%s:%d cites %s of no document" % (name, line_of(text, place + match.start()), match.group())
                      for match in re.finditer(r"§\d+(?:\.\d+)?", comment)
                      if not any(first <= place + match.start() < last for first, last in cited)]
    return found


def length_findings(texts):
    lines = (texts.get("README.md") or "").count("\n")
    return [] if lines <= README_LINES else ["README.md has %d lines, more than %d" % (lines, README_LINES)]


def link_findings(texts):
    folders = {os.path.dirname(name) for name in texts}
    while "" not in folders or any(os.path.dirname(folder) not in folders for folder in folders):
        folders |= {os.path.dirname(folder) for folder in folders} | {""}
    found = []
    for name, text in texts.items():
        if not name.endswith(".md"):
            continue
        prose = without_code(text)
        for match in re.finditer(r"\]\(([^)\s]+)\)", prose):
            target, _, anchor = match.group(1).partition("#")
            if re.match(r"[a-z]+:", target):
                continue
            path = os.path.normpath(os.path.join(os.path.dirname(name), target)) if target else name
            where = "%s:%d links to %s, " % (name, line_of(prose, match.start()), match.group(1))
            if path not in texts and path not in folders and path != ".":
                found.append(where + "which does not exist")
            elif anchor and anchor not in anchors(texts.get(path) or ""):
                found.append(where + "which has no such heading")
    return found


def comments(name, text):
    """Returns (position, text) of the comments of a file, or of the entire file if it is a page."""
    kind = kind_of(name)
    if kind == "all":
        return [(0, text)]
    return [(match.start(), match.group("comment"))
            for match in COMMENTS[kind].finditer(text) if match.group("comment")]


def mention_findings(texts):
    ends = set()
    for name in texts:
        parts = name.split("/")
        ends.update("/".join(parts[i:]) for i in range(len(parts)))
    found = []
    for name, text in texts.items():
        for place, comment in comments(name, text) if text else ():
            for match in MENTION.finditer(comment):
                said = re.sub(r"^(\.{1,2}/)+", "", match.group(1))
                if said not in ends and not FOREIGN.match(said):
                    found.append("%s:%d names %s, which is not in the tree"
                                 % (name, line_of(text, place + match.start()), match.group(1)))
    return found


def document_findings(texts):
    return ["%s:%d cites %s, which is not in the tree" % (name, line_of(text, match.start()), match.group())
            for name, text in texts.items() if text for match in ELSEWHERE.finditer(text)]


SAMPLE = "# The method\n\n## 2. Spaces\n\n### 2.1 P1\n\nSee §2.1.\n"


class References(unittest.TestCase):
    def check(self, function, texts, expected):
        self.assertEqual(function(dict(texts, **{METHOD_PAGE: SAMPLE})), expected)

    def test_finds_a_missing_section(self):
        self.check(section_findings, {"a.h": "/// (docs/method.md §2, §2.1 and §2)\n"}, [])
        self.check(section_findings, {"a.h": "\n/// (docs/method.md\n/// §2,\n/// §3.1; paper)\n"},
                   ["a.h:2 cites docs/method.md §3.1, which does not exist"])
        self.check(section_findings, {"a.md": "[The method](method.md) §7"},
                   ["a.md:1 cites docs/method.md §7, which does not exist"])
        self.assertEqual(len(section_findings({METHOD_PAGE: SAMPLE + "§5"})), 1)
        self.assertEqual(section_findings({METHOD_PAGE: SAMPLE + "§5", "docs/method/5.md": "# 5. More\n§2.1"}), [])
        self.assertEqual(len(section_findings({"a.h": ""})), 1)

    def test_finds_a_section_of_no_document(self):
        self.check(bare_findings, {"a.h": "// docs/method.md §1 and §2.1, Φ\n// there\n"}, [])
        self.check(bare_findings, {"a.h": "// docs/method.md §1\n// Φ of §2.1\nf(\"§3\");"},
                   ["a.h:2 cites §2.1 of no document"])
        self.check(bare_findings, {"a.md": "[Method](method.md) §1, [paper](paper.md) §4"},
                   ["a.md:1 cites §4 of no document"])

    def test_finds_a_long_readme(self):
        self.check(length_findings, {"README.md": "\n" * README_LINES}, [])
        self.assertEqual(len(length_findings({"README.md": "\n" * (README_LINES + 1)})), 1)

    def test_finds_a_broken_link(self):
        page = "[a](docs/method.md#21-p1) [b](docs) [c](https://x.y/z) `[d](e)` [f](#up)\n\n# Up\n"
        self.check(link_findings, {"a.md": page}, [])
        self.check(link_findings, {"a.md": "\n[a](docs/methods.md) [b](docs/method.md#up)"},
                   ["a.md:2 links to docs/methods.md, which does not exist",
                    "a.md:2 links to docs/method.md#up, which has no such heading"])

    def test_finds_a_file_that_is_not_there(self):
        good = "// see docs/method.md, a.cxx; vtkObject.h; Eigen/Core.h\nf(\"b.h\");\n"
        self.check(mention_findings, {"src/a.cxx": good}, [])
        self.check(mention_findings, {"a.cxx": "\n/* see\n b.h */ // ../src/a.cxx"},
                   ["a.cxx:3 names b.h, which is not in the tree",
                    "a.cxx:3 names ../src/a.cxx, which is not in the tree"])
        self.check(mention_findings, {"a.py": '"""See b.py."""\n# c.md\nx = "d.sh"\n'},
                   ["a.py:1 names b.py, which is not in the tree",
                    "a.py:2 names c.md, which is not in the tree"])
        self.check(mention_findings, {"a.md": "`scripts/b.sh`"},
                   ["a.md:1 names scripts/b.sh, which is not in the tree"])

    def test_finds_other_documents(self):
        # METHODS is an ordinary name.
        self.check(document_findings, {"a.py": "METHODS = 1"}, [])
        self.check(document_findings, {"a.py": "# see DES" + "IGN\n"},
                   ["a.py:1 cites DES" + "IGN, which is not in the tree"])
        self.check(document_findings, {"a.py": "# MET" + "HOD §3\n"},
                   ["a.py:1 cites MET" + "HOD, which is not in the tree"])

    def test_reads_a_tree_without_git(self):
        with tempfile.TemporaryDirectory() as folder:
            os.makedirs(os.path.join(folder, "docs"))
            os.makedirs(os.path.join(folder, "build"))
            for name in ("docs/a.md", "build/b.md"):
                with open(os.path.join(folder, name), "w", encoding="utf-8"):
                    pass
            self.assertEqual(tree(folder), ["docs/a.md"])

    def test_the_tree(self):
        texts = read(ROOT)
        self.assertGreater(len(texts), 100, "the files")
        found = [finding for function in (section_findings, bare_findings, length_findings, link_findings,
                                          mention_findings, document_findings) for finding in function(texts)]
        self.assertFalse(found, "\n" + "\n".join(found))


if __name__ == "__main__":
    unittest.main()
