"""The tables of docs/errors.md have the messages of the sources, all of them and no others.

    python3 test_errors.py

A row gives the beginning of a message, with "…" for what is known at run time only; several messages
may begin alike. How messages are found: messages.py.
"""
import os
import re
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import messages  # noqa: E402

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
PAGE = "docs/errors.md"
# Files that pass on the sentences of others, for which there is nothing to read in them.
FORWARD = {"FilterRun.h", "CheckCommand.cxx", "CompareCommand.cxx", "IsolatedReading.cxx",
           "PipelineRun.cxx", "_run.py"}


def rows_of(page):
    """The first column of the tables."""
    return [match.group(1).strip()
            for match in re.finditer(r"^\| (?!message begins with|---)(.*?) \|", page, re.MULTILINE)]


def begins(message, row):
    return message.startswith(row[:-1].rstrip() if row.endswith(messages.VARIABLE) else row)


def findings(page, sources):
    """What is wrong, a line each."""
    rows = rows_of(page)
    found = ["%s has two rows '%s'" % (PAGE, row) for row in sorted(set(rows)) if rows.count(row) > 1]
    said = messages.of_sources(sources)
    for name, line, message in said:
        if message is None:
            if os.path.basename(name) not in FORWARD:
                found.append("%s:%d says something that messages.py cannot read" % (name, line))
        elif not any(begins(message, row) for row in rows):
            found.append("%s:%d says '%s', which has no row in %s" % (name, line, message, PAGE))
    for row in rows:
        if not any(message and begins(message, row) for _, _, message in said):
            found.append("%s has a row '%s', which no source says" % (PAGE, row))
    return found


CPP = """
std::string Place(int i) { return "Point " + std::to_string(i) + " is bad"; }
void F(const std::string& what)
{
  std::ostringstream text; // throw Error("in a comment");
  if (what.empty())
  {
    text << what << " is empty" << ", fill it.";
    throw Error(text.str());
  }
  text << "The rest " << 1 << " is wrong.";
  throw crossfield::Error(text.str());
}
void G(bool b)
{
  F("The " + Name() + " of it");
  throw Error(b ? "It is b, "
                  "alas." : Place(3) + ".");
}
"""
SAID = ["It is b, alas.", "Point … is bad.", "The rest … is wrong.", "The … of it is empty, fill it."]
PYTHON = "def f(a):\n    raise Error('No %s of %d.' % (a, 3))\n"


class Errors(unittest.TestCase):
    def test_reads_cpp(self):
        self.assertEqual(sorted({m for _, _, m in messages.of_sources({"a.cxx": CPP})}), SAID)

    def test_reads_python(self):
        self.assertEqual(messages.of_sources({"a.py": PYTHON}), [("a.py", 2, "No … of ….")])

    def test_finds_a_missing_row(self):
        page = "".join("| %s | | |\n" % message for message in SAID[1:])
        self.assertEqual(findings(page, {"a.cxx": CPP}),
                         ["a.cxx:17 says 'It is b, alas.', which has no row in docs/errors.md"])

    def test_finds_a_row_that_nothing_says(self):
        page = "".join("| %s | | |\n" % message for message in SAID + ["The moon … is full"])
        self.assertEqual(findings(page, {"a.cxx": CPP}),
                         ["docs/errors.md has a row 'The moon … is full', which no source says"])

    def test_finds_what_it_cannot_read(self):
        self.assertEqual(findings("", {"a.cxx": "void F() { throw Error(*text); }"}),
                         ["a.cxx:1 says something that messages.py cannot read"])

    def test_the_page_has_the_messages_of_the_sources(self):
        sources = messages.read_sources(ROOT, ["filters", "pipelines"], ["pvpython"])
        self.assertGreater(len(sources), 100, "the sources")
        with open(os.path.join(ROOT, PAGE), encoding="utf-8") as file:
            found = findings(file.read(), sources)
        self.assertFalse(found, "\n" + "\n".join(found))


if __name__ == "__main__":
    unittest.main()
