"""Runs the examples of a page of the documentation, so that none becomes outdated.

    python3 test_docs.py PAGE.md PROGRAM PLUGIN.so [FOLDER] -- PVPYTHON...

All blocks of the page run in one folder, from top to bottom, as a reader would run them. The folder is
temporary unless FOLDER is given, which scripts/parts.sh draws.

- ```csv NAME, ```svg NAME, ```text NAME: the block is written to the file NAME. The files of the folder with the
  page's name, such as docs/drawings of docs/drawings.md, are there as well, apart from pictures.
- ```console: every line that begins with `crossfield` or `build/bin/crossfield`, after an optional
  `$ `, runs with PROGRAM; a `\` continues a line. Its exit status must be 0, or that of a comment
  `# exit status 1` at its end; the words in double quotes in the comment must be in its output.
  Lines that begin with cat, ccx, checkMesh, cmp, cp or python3 run as well; words that begin with `docs/`, `examples/`
  or `tests/data/` are files of the project. Where a solver is not installed, the rest of the page is skipped (status 77).
  Other lines are not compared.
- ```python: runs in pvpython with the plugin loaded and everything of paraview.simple imported.
  An error that a filter reports fails the test, as an exception does.
- ```py that begins with `import crossfield`: runs with the package that belongs to PROGRAM.

All links of the page to files must have a target.
"""
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "verify"))
import kept  # noqa: E402

own_arguments = sys.argv[1:sys.argv.index("--")]
page, program, plugin = own_arguments[:3]
pvpython = sys.argv[sys.argv.index("--") + 1:]
ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
PROGRAMS = {"crossfield": program, "build/bin/crossfield": program, "python3": sys.executable}
OTHERS = ("cat", "ccx", "checkMesh", "cmp", "cp")
# Debian's package of OpenFOAM does not set its folder; ccx starts one thread for each processor otherwise.
ENVIRONMENT = {"WM_PROJECT_DIR": "/usr/share/openfoam", "OMP_NUM_THREADS": "1", **os.environ}
with open(page, encoding="utf-8") as file:
    text = file.read()

PREAMBLE = """\
from paraview.simple import *
LoadPlugin(%r, ns=globals())
"""
# Results of the example are kept for the verifier.
END = """
import sys
sys.path.insert(0, %r)
import kept
kept.keep_sources()
"""


def run(command, directory, status=0):
    done = subprocess.run(command, cwd=directory, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          universal_newlines=True, check=False, env=ENVIRONMENT)
    if done.returncode != status:
        sys.exit("%s: %s\nended with status %d instead of %d:\n%s"
                 % (page, " ".join(command), done.returncode, status, done.stdout))
    return done.stdout


def run_console(block, directory):
    for line in block.replace("\\\n", " ").splitlines():
        words = shlex.split(re.sub(r"^\$ ", "", line), comments=True)
        if not words or words[0] not in (*PROGRAMS, *OTHERS):
            continue
        found = PROGRAMS.get(words[0]) or shutil.which(words[0])
        if not found:
            print("%s: skipped from here on, %s is not installed: %s" % (page, words[0], line))
            sys.exit(77)
        words = [os.path.join(ROOT, word) if word.startswith(("docs/", "examples/", "tests/data/")) else word for word in words]
        comment = line.partition("#")[2]
        expected = re.search(r"exit status (\d)", comment)
        output = run([found] + words[1:], directory, int(expected.group(1)) if expected else 0)
        output = re.sub(r"\s+", " ", output)
        for said in re.findall(r'"([^"]*)"', comment):
            if said not in output:
                sys.exit('%s: %s\ndoes not say "%s" but:\n%s' % (page, line, said, output))


def run_python(block, directory):
    script = os.path.join(directory, "example.py")
    with open(script, "w", encoding="utf-8") as file:
        file.write(PREAMBLE % plugin + block + END % os.path.dirname(kept.__file__))
    output = run(pvpython + [script], directory)
    if re.search(r"ERR\||ERROR: In ", output):
        sys.exit("%s: this example reports an error:\n%s\n%s" % (page, block, output))


def run_package(block, directory):
    script = os.path.join(directory, "package.py")
    with open(script, "w", encoding="utf-8") as file:
        file.write(block)
    folder = re.search("^python: (.*)$", run([program, "--paths"], directory), re.MULTILINE).group(1)
    run(["env", "PYTHONPATH=" + folder, sys.executable, script], directory)


# Links in code blocks are ignored.
prose = re.sub(r"^```.*?^```$", "", text, flags=re.DOTALL | re.MULTILINE)
for target in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", prose):
    if "://" not in target and not os.path.exists(os.path.join(os.path.dirname(page), target)):
        sys.exit("%s links to %s, which does not exist." % (page, target))

blocks = re.findall(r"^```(\w+)(?: (\S+))?\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)
with tempfile.TemporaryDirectory(prefix="crossfield-docs-") as temporary:
    directory = os.path.abspath(own_arguments[3]) if len(own_arguments) > 3 else temporary
    os.makedirs(directory, exist_ok=True)
    own = os.path.splitext(page)[0]
    for name in os.listdir(own) if os.path.isdir(own) else ():
        if not name.endswith(".png"):
            shutil.copy(os.path.join(own, name), directory)
    for language, name, block in blocks:
        if language in ("csv", "svg") or language == "text" and name:
            with open(os.path.join(directory, name), "w", encoding="utf-8") as file:
                file.write(block)
        elif language == "console":
            run_console(block, directory)
        elif language == "python":
            run_python(block, directory)
        elif language == "py" and block.startswith("import crossfield"):
            run_package(block, directory)
        kept.keep_folder(directory)
print("%s: %d blocks" % (page, len(blocks)))
