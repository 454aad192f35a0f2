"""Parameter studies: the table is the same for any number of ranks, and gives the reason for rows
without energy.

    python3 test_study.py SCRIPT.py PROGRAM FOLDER_OF_THE_PACKAGE MPIRUN PVBATCH
"""
import csv
import json
import os
import subprocess
import sys
import tempfile

from checks import check, check_equal

script, program, package, mpirun, pvbatch = sys.argv[1:]
HEADER = "x,y,quarter_index,radius\n"
TABLE = """configuration,x,y,quarter_index,radius
near,0.4,0,1,0.1
near,-0.4,0,1,0.1
near,0,0.4,1,0.1
near,0,-0.4,1,0.1
two,0.5,0,2,0.1
two,-0.5,0,2,0.1
five,0,0,5,0.1
outside,3,0,4,0.1
words,zero,0,4,0.1
"""
environment = dict(os.environ, PYTHONPATH=package, OMP_NUM_THREADS="1",
                   OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")


def run(launcher, *options):
    # mpirun would read the input of the terminal.
    done = subprocess.run(launcher + [script] + list(options), cwd=directory, env=environment,
                          stdin=subprocess.DEVNULL, text=True,
                          check=False, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=200)
    print(*launcher, *options, "->", done.returncode, done.stdout, done.stderr)
    return done


def ranks(count, *options):
    return [mpirun, "--oversubscribe", "-n", str(count), pvbatch] + list(options)


def write(name, text):
    with open(os.path.join(directory, name), "w", encoding="utf-8") as file:
        file.write(text)


def content(name):
    with open(os.path.join(directory, name), encoding="utf-8", newline="") as file:
        return file.read()


def test_same_table():
    inputs = ("builtin:disk", "table.csv", "folder", "--size", "0.1")
    for name, launcher in (("alone.csv", [sys.executable]), ("one.csv", ranks(1, "--sym")),
                           ("three.csv", ranks(3, "--sym"))):
        check_equal(run(launcher, *inputs, "--output", name).returncode, 1, "the exit status")
    done = run(ranks(2, "--sym"), *inputs, "--output", "two.csv", "--fields", "fields")
    check("4 of 7 configurations solved by 2 ranks" in done.stdout, "the summary is not printed")
    for name in ("one.csv", "two.csv", "three.csv"):
        check_equal(content(name), content("alone.csv"), name)
    check_equal(sorted(os.listdir(os.path.join(directory, "fields"))),
                ["far.vtu", "near.vtu", "single.vtu", "two.vtu"], "the fields")


def test_rows():
    rows = list(csv.DictReader(content("two.csv").splitlines()))
    check_equal([(row["configuration"], row["status"]) for row in rows],
                [("far", "solved"), ("near", "solved"), ("two", "solved"), ("single", "solved"),
                 ("five", "inconsistent"), ("outside", "refused"), ("words", "refused")], "the rows")
    for row, word in zip(rows[4:], ("Poincaré-Hopf", "outside the domain", "need numbers")):
        check(word in row["reason"] and row["energy"] == "", "the row %s" % row)
    # The program computes the same by its own pipeline.
    answer = json.loads(subprocess.run(
        [program, "energy", "builtin:disk", "-s", "folder/far.csv", "--size", "0.1", "--json", "-"],
        cwd=directory, text=True, check=True, stdout=subprocess.PIPE).stdout)["configurations"][0]
    for name in ("energy", "energy_lower_bound", "energy_upper_bound", "renormalized_energy"):
        check_equal(float(rows[0][name]), answer[name], name)


def test_all_solved():
    done = run(ranks(2, "--sym"), "builtin:disk", "folder", "--size", "0.1", "--output", "solved.csv")
    check_equal(done.returncode, 0, "the exit status when all are solved")


def test_refusals():
    write("kept.csv", "what was there")
    for options, word in ((("builtin:banana", "folder"), "no built-in domain"),
                          (("builtin:disk", "missing.csv"), "missing.csv"),
                          (("builtin:disk", "folder", "folder/far.csv"), "'far'")):
        done = run(ranks(2, "--sym"), *options, "--output", "kept.csv")
        check_equal(done.returncode, 2, "the exit status")
        check_equal(done.stderr.count(word), 1, "how often '%s' is said" % word)
        check_equal(content("kept.csv"), "what was there", "the old table")
    done = run(ranks(2), "builtin:disk", "folder", "--output", "kept.csv")
    check(done.returncode != 0 and "--sym" in done.stderr, "no word on the missing option --sym")


with tempfile.TemporaryDirectory() as directory:
    write("table.csv", TABLE)
    os.mkdir(os.path.join(directory, "folder"))
    write("folder/far.csv", HEADER + "0.7,0,1,0.1\n-0.7,0,1,0.1\n0,0.7,1,0.1\n0,-0.7,1,0.1\n")
    write("folder/single.csv", HEADER + "0,0,4,0.1\n")
    for test in (test_same_table, test_rows, test_all_solved, test_refusals):
        test()
        print(test.__name__, "passed")
