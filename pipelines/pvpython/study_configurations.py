"""Compare many configurations on one domain, spread over the ranks of MPI; a table of energies.

Usage:

    mpirun -n 2 pvbatch --sym study_configurations.py DOMAIN CONFIGURATIONS... --output table.csv
        [--size 0.05] [--fields FOLDER] [--method constrained]

or with pvpython or python3, which process one configuration after the other. PYTHONPATH must
contain the Python package, see `crossfield --paths`. DOMAIN is a file or builtin:NAME.
CONFIGURATIONS are .csv files with the header x,y,quarter_index[,radius][,z]; folders of such files;
or tables with one more column `configuration`, whose rows of one name are one configuration.

The table has a row for every configuration, by increasing energy; configurations without a field
come last, with the reason. It is the same for any number of ranks. Exit status: 0 all solved, 1
some not, 2 bad usage.

Sample run:

    export PYTHONPATH=$(build/bin/crossfield --paths | sed -n 's/^python: //p') OMP_NUM_THREADS=1
    mpirun -n 2 pvbatch --sym pipelines/pvpython/study_configurations.py builtin:disk four.csv five.csv \
        --output table.csv
"""
import argparse
import contextlib
import csv
import glob
import os
import sys
import traceback

import crossfield  # before anything of ParaView

NUMBERS = (  # column, its unit if any, and array of vtkSingularityEnergy
    ("energy", "Energy"),
    ("energy_lower_bound", "EnergyLowerBound"),
    ("energy_upper_bound", "EnergyUpperBound"),
    ("energy_degree_only", "EnergyDegreeOnly"),
    ("logarithm_coefficient", "LogarithmCoefficient"),
    ("renormalized_energy", "RenormalizedEnergy"),
    ("holonomy_defect_radians", "HolonomyDefect"))
COLUMNS = ["configuration", "status"] + [column for column, _ in NUMBERS] + ["reason"]


class Ranks:
    """The processes that mpirun has started, or only this one without mpirun."""

    def __init__(self):
        self.rank, self.count, self.world = 0, 1, None
        if not {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"} & set(os.environ):
            return
        from mpi4py import MPI  # also starts MPI where pvbatch has not
        self.world = MPI.COMM_WORLD
        self.rank, self.count = self.world.Get_rank(), self.world.Get_size()
        sys.excepthook = self.abort
        if self.count > 1 and runs_on_first_rank_only():
            print("Give pvbatch the option --sym; without it only the first rank works.",
                  file=sys.stderr, flush=True)
            self.world.Abort(2)

    def abort(self, kind, error, trace):
        """Stops all ranks after an exception, because the others would wait for this one."""
        traceback.print_exception(kind, error, trace)
        sys.stderr.flush()
        self.world.Abort(3)

    def gather(self, rows):
        """Returns the rows of all ranks on the first rank, an empty list on the others."""
        if self.world is None:
            return rows
        parts = self.world.gather(rows)
        return sum(parts, []) if self.rank == 0 else []

    def agree(self, value):
        """Returns the value of the first rank on all ranks."""
        return value if self.world is None else self.world.bcast(value)

    def end(self, status):
        """Exits with the status of the first rank. Finalises MPI, which pvbatch does only if a
        script returns."""
        status = self.agree(status)
        if status == 0:
            return
        if self.world is not None:
            from mpi4py import MPI
            MPI.Finalize()
        sys.exit(status)


def runs_on_first_rank_only():
    with contextlib.suppress(ImportError):
        from paraview.modules.vtkRemotingCore import vtkProcessModule
        module = vtkProcessModule.GetProcessModule()
        return (module is not None
                and vtkProcessModule.GetProcessType() == vtkProcessModule.PROCESS_BATCH
                and not module.GetSymmetricMPIMode())
    return False


def read_table(name):
    """Returns the configurations of a file by name: the file itself, or rows if it has a column
    `configuration`."""
    with open(name, encoding="utf-8-sig", newline="") as file:
        reader = csv.DictReader(file, skipinitialspace=True)
        header = [column.strip() for column in reader.fieldnames or []]
        if "configuration" not in header:
            return {os.path.splitext(os.path.basename(name))[0]: name}
        reader.fieldnames = header
        found = {}
        for row in reader:
            found.setdefault((row["configuration"] or "").strip(), []).append(row)
        return found


def read_configurations(names):
    found = {}
    for name in names:
        files = sorted(glob.glob(os.path.join(glob.escape(name), "*.csv"))) \
            if os.path.isdir(name) else [name]
        if not files:
            raise crossfield.Error("The folder '%s' has no .csv files." % name)
        for file in files:
            for label, rows in read_table(file).items():
                if label in found or label in ("", ".", "..") or "/" in label:
                    raise crossfield.Error("The name '%s' of a configuration in '%s' is %s." % (
                        label, file, "taken" if label in found else "no name of a file"))
                found[label] = rows
    return found


def points_of(rows):
    """Returns points that filters read, from the name of a file or from rows of a table."""
    if isinstance(rows, str):
        source = crossfield.vtkSingularitySource()
        source.SetFileName(rows)
        return updated(source).GetOutput()
    columns = ["x", "y", "quarter_index"] + [name for name in ("radius", "z") if rows[0].get(name)]
    try:
        table = [[float(row[column]) for column in columns] for row in rows]
    except (KeyError, TypeError, ValueError):
        raise crossfield.Error("Its rows need numbers in the columns %s." % ", ".join(columns)) from None
    value = {column: [row[place] for row in table] for place, column in enumerate(columns)}
    places = [value[axis] for axis in ("x", "y", "z") if axis in value]
    return crossfield.configuration(list(zip(*places)), value["quarter_index"], value.get("radius"))


def updated(algorithm):
    """Updates a filter and returns it; raises the error that it reports."""
    errors = []

    def keep(caller, event, text):
        errors.append(text.split("): ", 1)[-1].strip())

    keep.CallDataType = "string0"
    algorithm.AddObserver("ErrorEvent", keep)
    algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    algorithm.Update()
    if algorithm.GetErrorCode() != 0:
        raise crossfield.Error(errors[0] if errors else "VTK does not say why it failed.")
    return algorithm


def read_domain():
    if not arguments.domain.startswith("builtin:"):
        return crossfield.read(arguments.domain)
    source = crossfield.vtkPlanarDomainSource()
    source.SetDomainName(arguments.domain[len("builtin:"):])
    source.SetEdgeLength(arguments.size)
    return updated(source).GetOutput()


def solve(label, rows):
    """Returns the row of one configuration in the table."""
    row = dict.fromkeys(COLUMNS, "")
    row.update(configuration=label, status="refused")
    try:
        points = points_of(rows)
        # 1. Check whether the configuration can exist.
        checked = crossfield.check(domain, points, holonomy=False)
        if not checked.consistent:
            row.update(status="inconsistent", reason=checked.reason)
            return row
        # 2. Compute its energy, for one configuration at a time: a common mesh would depend on the
        #    number of ranks.
        energy = crossfield.vtkSingularityEnergy()
        energy.SetInputData(domain)
        energy.AddConfigurationData(points)
        energy.SetMeshSize(arguments.size)
        table = updated(energy).GetOutput()
        numbers = {column: repr(table.GetValueByName(0, array).ToDouble())
                   for column, array in NUMBERS}
        # 3. Compute its field.
        if arguments.fields:
            field = crossfield.solve(domain, points, size=arguments.size or None,
                                     method=arguments.method)
            field.write(os.path.join(arguments.fields, label + ".vtu"))
            if not field.report["converged"]:
                row.update(status="not converged", reason="The iteration for its field stopped early.")
                return row
        row.update(numbers, status="solved")
    except (crossfield.Error, OSError, UnicodeDecodeError) as error:
        row["reason"] = str(error)
    return row


def write_table(rows):
    """Writes the table to a temporary file and renames it, so that an error leaves an earlier table
    unchanged."""
    unfinished = arguments.output + ".part"
    try:
        with open(unfinished, "w", encoding="utf-8", newline="") as file:
            writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
        os.replace(unfinished, arguments.output)
    except OSError:
        with contextlib.suppress(OSError):
            os.remove(unfinished)
        raise


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("domain", help="a file or builtin:NAME")
    parser.add_argument("configurations", nargs="+", help=".csv files or folders of them")
    parser.add_argument("--output", required=True, help="the table to write, a .csv file")
    parser.add_argument("--size", type=float, default=0.0,
                        help="edge length of the mesh; default: 1/40 of the diagonal of the domain")
    parser.add_argument("--fields", default="", help="folder for the cross fields, NAME.vtu each")
    parser.add_argument("--method", default="constrained", choices=("constrained", "unit-norm"),
                        help="of the cross fields")
    # Every rank reads the same command line; only the first one prints errors.
    with contextlib.redirect_stderr(sys.stderr if ranks.rank == 0 else open(os.devnull, "w")):
        return parser.parse_args()


ranks = Ranks()
arguments = parse_arguments()
complaint = ""
try:
    domain = read_domain()
    configurations = read_configurations(arguments.configurations)
    if arguments.fields:
        os.makedirs(arguments.fields, exist_ok=True)
except (crossfield.Error, OSError, UnicodeDecodeError, csv.Error) as error:
    complaint = str(error)
complaint = ranks.agree(complaint)
if complaint:
    if ranks.rank == 0:
        print(complaint, file=sys.stderr)
    ranks.end(2)

# Each rank solves every ranks.count-th configuration; they cost about the same on one domain and
# mesh size.
mine = list(configurations)[ranks.rank::ranks.count]
rows = ranks.gather([solve(label, configurations[label]) for label in mine])
status = 0
if ranks.rank == 0:
    rows.sort(key=lambda row: (row["status"] != "solved", float(row["energy"] or 0),
                               row["configuration"]))
    solved = sum(row["status"] == "solved" for row in rows)
    try:
        write_table(rows)
        print("%d of %d configurations solved by %d ranks; the table is in %s" % (
            solved, len(rows), ranks.count, arguments.output))
        status = 0 if solved == len(rows) else 1
    except OSError as error:
        print(error, file=sys.stderr)
        status = 2
ranks.end(status)
