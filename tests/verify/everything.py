"""Verifies all files that the tests of a run have written.

    python3 everything.py FOLDER --program-tests N --sources Program Vtk ...

After a full run, in which Rules.TestsKeepWhatTheyWrite and at least half of the N tests of the
program ran, every source must have written files. After a run of some tests there may be none.
"""
import argparse
import pathlib
import sys

import verify

parser = argparse.ArgumentParser()
parser.add_argument("folder")
parser.add_argument("--program-tests", type=int, required=True)
parser.add_argument("--sources", nargs="*", default=[])
options = parser.parse_args()
folder = pathlib.Path(options.folder)
names = [path.name for path in folder.glob("*.vtu")]
if (folder / "all.ran").exists() and 2 * len(list(folder.glob("Program.*.ran"))) >= options.program_tests:
    silent = [source for source in options.sources
              if not any(name.startswith(source + ".") for name in names)]
    if silent or not names:
        sys.exit("After all tests, nothing is there to verify from: %s. (Tests that were left out with -E "
                 "write nothing.)" % ", ".join(silent))
elif not names:
    print("The tests that ran have written nothing.")
    sys.exit(0)
sys.exit(verify.main(["--quiet", "--jobs", "2", options.folder]))
