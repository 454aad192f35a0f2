"""Prints the table of docs/limits.md: seconds and memory of whole runs, from the domain to the
.vtu.

    python3 scripts/limits.py build/bin/crossfield [TRIANGLES...]      100000 1000000 4000000
"""
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

HEAD = "| triangles | drill | constrained | unit norm | H field |\n| --- | --- | --- | --- | --- |"
COMMANDS = (("drill",), ("solve", "--method", "constrained"), ("solve", "--method", "unit-norm"), ("hfield",))
SIZES = (100000, 1000000, 4000000)


def eight_holes():
    """Returns six k = 1 at radius 0.7 and two k = −1 at (±0.2, 0), radius 0.02."""
    rows = [(0.7 * math.cos(math.pi * i / 3), 0.7 * math.sin(math.pi * i / 3), 1) for i in range(6)]
    rows += [(0.2, 0.0, -1), (-0.2, 0.0, -1)]
    return "x,y,quarter_index,radius\n" + "".join("%.17g,%.17g,%d,0.02\n" % row for row in rows)


def whole_run(program, command, triangles, folder):
    """Returns the elapsed seconds and the maximum memory of the process in GiB."""
    size = math.sqrt(4 * math.pi / (math.sqrt(3) * triangles))  # a disk in equilateral triangles
    words = [program, command[0], "builtin:disk", "-s", "eight.csv", "--size", repr(size), "-o", "field.vtu",
             *command[1:]]
    begin = time.monotonic()
    with subprocess.Popen(words, cwd=folder, stdout=subprocess.DEVNULL) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit("%s exited with status %d" % (" ".join(map(str, words)), process.returncode))
    return time.monotonic() - begin, usage.ru_maxrss / 1024 ** 2


def table(program, sizes):
    program = pathlib.Path(program).resolve()
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "eight.csv").write_text(eight_holes(), encoding="utf-8")
        for triangles in sizes:
            runs = [whole_run(program, command, triangles, folder) for command in COMMANDS]
            yield "| {:,} | ".format(triangles) + " | ".join("%.2g s, %.2f GiB" % run for run in runs) + " |"


if __name__ == "__main__":
    print(HEAD)
    for line in table(sys.argv[1], [int(word) for word in sys.argv[2:]] or SIZES):
        print(line, flush=True)
