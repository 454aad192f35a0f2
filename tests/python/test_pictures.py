"""Draws the pictures of the documentation again, so that the script does not become outdated.

    python3 test_pictures.py docs_pictures.py docs/pictures PLUGIN.so -- xvfb-run ... pvpython

Every picture of the folder except the screenshots (tutorial_*.png) must be drawn, and no others; a
picture is larger than an empty one, and not larger than 300 kB. Every screenshot has texts in the list that
tests in the client compare (tests/paraview/tutorial_texts.py).
"""
import os
import subprocess
import sys
import tempfile

script, folder, plugin = sys.argv[1:4]
kept = {name for name in os.listdir(folder) if not name.startswith("tutorial_")}
with open(os.path.join(folder, "tutorial_texts.txt"), encoding="utf-8") as texts:
    listed = {line.split("\t")[0] for line in texts} | {"tutorial_texts.txt"}
if listed | kept != set(os.listdir(folder)):
    sys.exit("Screenshots without texts, or texts without a screenshot: %s" % sorted((listed | kept) ^ set(os.listdir(folder))))
with tempfile.TemporaryDirectory(prefix="crossfield-") as directory:
    subprocess.run(sys.argv[5:] + [script, "--plugin", plugin, "--folder", directory], check=True)
    drawn = set(os.listdir(directory))
    if drawn != kept:
        sys.exit("Drawn but not in %s: %s; there but not drawn: %s"
                 % (folder, sorted(drawn - kept), sorted(kept - drawn)))
    for name in sorted(drawn):
        size = os.path.getsize(os.path.join(directory, name))
        # A white view with a title has about 3 kB.
        if not 5000 < size <= 300 * 1024:
            sys.exit("%s has %d bytes." % (name, size))
