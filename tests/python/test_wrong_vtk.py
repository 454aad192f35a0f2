"""Importing the package into a Python with another VTK is an ImportError with the cause, not a
crash.

    python3 test_wrong_vtk.py FOLDER_OF_THE_PACKAGE PYTHON...

Uses those of the Pythons that exist; ends with status 77 (skipped) if there is none.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

from checks import check, check_equal

folder, pythons = sys.argv[1], [name for name in sys.argv[2:] if shutil.which(name)]
if not pythons:
    print("No Python with another VTK is here.")
    sys.exit(77)
with tempfile.TemporaryDirectory() as directory:
    script = os.path.join(directory, "import.py")  # pvpython has no -c
    with open(script, "w", encoding="utf-8") as file:
        file.write("try:\n    import crossfield\nexcept ImportError as error:\n    print(error)\n")
    for python in pythons:
        done = subprocess.run([python, script], text=True, check=False, stdout=subprocess.PIPE,
                              env=dict(os.environ, PYTHONPATH=folder))
        print(python, "->", done.returncode, done.stdout)
        check_equal(done.returncode, 0, "the exit status, negative after a crash")
        found = re.search(r"built for VTK (\S+) but this Python has VTK (\S+);", done.stdout)
        check(found is not None, "the import succeeds, or its error says something else")
        check(found.group(1) != found.group(2), "both versions are the same")
