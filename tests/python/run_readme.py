"""Extracts an example from README.md, and optionally runs it, so that no example becomes outdated.

    python3 run_readme.py README.md LANGUAGE BUILD_DIRECTORY FILE [-- COMMAND...]

README.md must have exactly one fenced block of the LANGUAGE, other pages at least one, which make
one example together. It is written to FILE, with `build/`
replaced by the build directory of the tests. With a COMMAND, `COMMAND... FILE` runs in a temporary
directory, and must succeed and write a file `field.vtu` there.
"""
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "verify"))
import kept  # noqa: E402

readme, language, build_directory, name = sys.argv[1:5]
command = sys.argv[6:]

with open(readme, encoding="utf-8") as file:
    blocks = re.findall(r"^```%s\n(.*?)^```$" % language, file.read(), re.DOTALL | re.MULTILINE)
if len(blocks) != 1 and (not blocks or os.path.basename(readme) == "README.md"):
    sys.exit("%s has %d blocks of %s instead of 1." % (readme, len(blocks), language))
with open(name, "w", encoding="utf-8") as file:
    file.write(re.sub(r"\bbuild/", build_directory + "/", "\n".join(blocks)))

if command:
    with tempfile.TemporaryDirectory() as directory:
        subprocess.run(command + [name], cwd=directory, check=True)
        if not os.path.exists(os.path.join(directory, "field.vtu")):
            sys.exit("The example has not written field.vtu.")
        kept.keep_folder(directory)
