"""Runs all commands of the program and compares every byte that they write, and the numbers of their reports except
times:

  python3 tests/pipelines/same_bytes.py PROGRAM                  with 1, 2, 3, 4, 8 and 16 threads
  python3 tests/pipelines/same_bytes.py PROGRAM --short          fewer runs, with 1, 3 and 16 threads
  python3 tests/pipelines/same_bytes.py PROGRAM --against OTHER  with another program, for example one of an earlier commit

Exits with 0 if all are equal.
"""

import argparse
import hashlib
import json
import math
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

DATA = pathlib.Path(__file__).resolve().parent.parent / "data"
THREADS = (1, 2, 3, 4, 8, 16)
SHORT_THREADS = (1, 3, 16)
FOUR = "x,y,quarter_index,radius\n" + "".join(
    f"{0.6 * math.cos(0.3 + k * math.pi / 2)},{0.6 * math.sin(0.3 + k * math.pi / 2)},1,0.1\n" for k in range(4))

# Arguments of each run; {o} stands for the path of outputs without its ending. Those of SHORT come first.
SHORT = 7
RUNS = (
    "solve builtin:disk -s four.csv --size 0.012 -o {o}.vtu --json {o}.json",
    "solve builtin:disk -s four.csv --size 0.012 --method unit-norm -o {o}.vtu --json {o}.json",
    "hfield builtin:disk -s four.csv --size 0.012 -o {o}.vtu --json {o}.json",
    "quads plate9.csv -o {o}.vtu --blocks {o}.vtm --json {o}.json",
    "quads builtin:disk -s four.csv --quads 60000 -o {o}.vtu --json {o}.json",
    "quads builtin:l-shape --mesh-size 0.012 -o {o}.vtu --layout {o}.vtp --json {o}.json",
    "energy builtin:disk -s four.csv -s moved.csv --json {o}.json",
    "domain ring -o {o}.vtp",
    "check plate9.csv --propose {o}.csv --json {o}.json",
    "check builtin:disk -s four.csv --json {o}.json",
    "corners builtin:l-shape -o {o}.vtp --json {o}.json",
    "drill builtin:disk -s four.csv --size 0.02 -o {o}.vtu",
    "drill builtin:disk -s four.csv --size 0.05 --mode imprint -o {o}.vtu",
    "solve builtin:ring --size 0.02 -o {o}.vtu --json {o}.json",
    "solve builtin:disk -s four.csv --size 0.05 --method ginzburg-landau -o {o}.vtu --json {o}.json",
    "solve builtin:disk -s four.csv --size 0.1 --epsilon 0.1 -o {o}.vtu --json {o}.json",
    "solve builtin:disk -s four.csv --size 0.03 --unit-holes -o {o}.vtu --json {o}.json",
    "solve builtin:disk -s four.csv --size 0.03 --global-constraint -o {o}.vtu --json {o}.json",
    "compare builtin:disk -s four.csv --size 0.1 --methods constrained,unit-norm -o {o}.vtm",
    "hfield plate9.csv -o {o}.vtu --json {o}.json",
    "optimize builtin:disk -s moved.csv -o {o}.csv --json {o}.json",
    "optimize builtin:ellipse -o {o}.csv --json {o}.json",
    "separatrices builtin:disk -s four.csv -o {o}.vtp --json {o}.json",
    "separatrices plate9.csv -o {o}.vtp --faces {o}-faces.vtp --map {o}.vtu --json {o}.json",
    "quads builtin:disk -o {o}.vtu --json {o}.json",
    "quads builtin:star -o {o}.vtu --json {o}.json",
    "quads builtin:ellipse --merge clean -o {o}.vtu --json {o}.json",
    "quads plate9.csv --merge coarse --order 2 -o {o}.msh --json {o}.json",
    "quads plate9.csv --merge clean -o {o}.vtu --json {o}.json",
    "quads builtin:star --merge coarse -o {o}.vtu --json {o}.json",
    "quads builtin:disk -s four.csv --quads 60000 --sizing uniform -o {o}.vtu --blocks {o}.vtm --json {o}.json",
    "quads builtin:square --sizing uniform --layers outer0:0.005 -o {o}.vtu --json {o}.json",
    "quads plate05.vtp --quads 1000 -o {o}.vtu --json {o}.json",
    "figures --only disk_holes,h_field -o {o}",
)


def write_inputs(folder):
    """Writes two configurations, a plate with nine holes and a domain where singularities reach the boundary."""
    shutil.copy(DATA / "hard" / "plate05_m16_k1.vtp", folder / "plate05.vtp")
    (folder / "four.csv").write_text(FOUR)
    (folder / "moved.csv").write_text(FOUR.replace("0.1\n", "0.05\n", 1))
    chance = random.Random(1)
    loops = [[(0, 0), (3, 0), (3, 3), (0, 3)]]
    for i in range(9):
        x, y = i % 3 + chance.uniform(0.35, 0.65), i // 3 + chance.uniform(0.35, 0.65)
        radius = chance.uniform(0.12, 0.25)
        loops.append([(x + radius * math.cos(math.pi * k / 16), y + radius * math.sin(math.pi * k / 16))
                      for k in range(32)])
    (folder / "plate9.csv").write_text(
        "x,y,loop\n" + "".join(f"{x},{y},{n}\n" for n, loop in enumerate(loops) for x, y in loop))


def without_times(value):
    """Removes the entries of a report that are seconds."""
    if isinstance(value, dict):
        return {key: without_times(entry) for key, entry in value.items() if key != "seconds"}
    return [without_times(entry) for entry in value] if isinstance(value, list) else value


def digest(folder, name):
    """Returns the digests of all outputs of a run by their names."""
    digests = {}
    for path in sorted(folder.rglob("*")):
        relative = str(path.relative_to(folder))
        if path.is_file() and relative.startswith(name):
            content = path.read_bytes()
            if path.suffix == ".json":
                content = json.dumps(without_times(json.loads(content)), sort_keys=True).encode()
            digests[relative] = hashlib.sha256(content).hexdigest()
    return digests


def run(program, arguments, threads):
    """Returns the exit status, the messages and the outputs of a run."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_inputs(folder)
        result = subprocess.run(
            [program, *arguments.format(o="out").split()], cwd=folder, capture_output=True, text=True, check=False,
            env={**os.environ, "OMP_NUM_THREADS": str(threads), "OMP_WAIT_POLICY": "passive",
                 "MALLOC_PERTURB_": str(17 * threads % 255)})  # what fresh memory contains, with glibc
        return result.returncode, result.stderr, digest(folder, "out")


def differing(first, second):
    """Returns what differs between two results."""
    if first[:2] != second[:2]:
        return f"status and messages {first[:2]} and {second[:2]}"
    names = {**first[2], **second[2]}
    return ", ".join(sorted(name for name in names if first[2].get(name) != second[2].get(name)))


def main():
    """Compares all runs."""
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=os.path.abspath)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--against", type=os.path.abspath, metavar="OTHER")
    options = parser.parse_args()
    if options.against:
        variants = [(options.program, 2), (options.against, 2)]
    else:
        variants = [(options.program, threads) for threads in (SHORT_THREADS if options.short else THREADS)]
    failures = 0
    for arguments in RUNS[:SHORT] if options.short else RUNS:
        first, *others = [run(program, arguments, threads) for program, threads in variants]
        problem = ", ".join({differing(first, other) for other in others} - {""})
        if first[0] not in (0, 1) or not first[2]:
            problem = f"status {first[0]}: {first[1].strip()}"
        failures += bool(problem)
        print(f"{'FAILED' if problem else 'equal '}  {arguments}  {problem}", flush=True)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
