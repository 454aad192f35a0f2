"""Recomputes the contents of a .vtu of this project from its points, cells and arrays alone.

    python3 verify.py [--quiet] [--jobs N] FILE.vtu|FOLDER...

Uses neither the program nor the library, only the mathematics. Needs numpy and the Python modules
of VTK, with or without ParaView, for reading. Exits with 1 if a check fails and with 2 if there is
nothing to verify.
"""
import argparse
import collections
import concurrent.futures
import pathlib
import sys
import time
import traceback

import alignment
import counts
import energies
import field as fields
import seamless_map
import hfield
import indices as winding
import lines
import quads
import singularities as singular
import solids
import stationarity
import unit_norm
from crouzeix_raviart import energies as gradient_energies
from reading import Data
from report import Report, Unverifiable
from topology import HOLE, IMPRINTED, Mesh, check_mesh

MESH_ARRAYS = ("BoundaryKind", "BoundaryId", "QuarterIndex")


def verify(name):
    """Returns the Report of one file."""
    report = Report(str(name))
    try:
        data = Data(name)
        if "UV" in data.at_points and len(data.points) > 0:
            report.kind = "seamless map"
            seamless_map.check_map(data, report)
            lines.check_beside(name, data, report)
            return report
        if len(data.solids) > 0:
            report.kind = "swept quads"
            solids.check_solids(data, report)
            return report
        if len(data.quads) > 0 and "BlockId" in data.quad_cells:
            report.kind = "quad mesh"
            quads.check_quads(data, report)
            return report
        if not all(array in data.cells for array in MESH_ARRAYS) or len(data.points) == 0:
            return report
        report.kind = "drilled mesh"
        mesh = Mesh(data)
        check_mesh(data, mesh, report)
        if "CrossFieldCR" in data.cells and not report.failures():
            _verify_field(data, mesh, report)
    except Unverifiable as reason:
        report.true("the file makes sense", False, str(reason))
    except Exception:  # a defect of the verifier, or an unknown kind of file
        report.true("the verifier understands the file", False, traceback.format_exc())
    return report


def _verify_field(data, mesh, report):
    report.kind = "cross field"
    field = fields.Field(data, mesh)
    fields.check_arrays(data, mesh, field, report)
    alignment.check_alignment(mesh, field, report)
    boundary = winding.BoundaryTurns(mesh)
    indices = winding.Indices(mesh, field, boundary)
    if "Energy" not in data.field:
        report.note("there is no report in the field data")
        return
    loops, degrees = winding.check_degrees(data, mesh, field, report)
    winding.check_sum(data, mesh, indices, loops, degrees, report)
    found = singular.find(mesh, field, indices, boundary)
    total = sum(s.quarter for s in found)
    if "H" in data.at_points:
        _verify_h(data, mesh, field, boundary, indices, loops, degrees, found, report)
    elif data.value("ConvexifiedSteps") is not None:
        report.kind = "Ginzburg-Landau field"
        counts.check_counts(data, mesh, boundary, indices, total, report)
        size = sum(abs(s.quarter) for s in found)
        report.equal("UnwantedSingularities", data.value("UnwantedSingularities"),
                     max(0, size - abs(data.value("RequiredInteriorQuarters"))))
        (norm_name, norm), (weight_name, weight) = energies.find_pinning(data, mesh, field)
        if norm_name or weight_name:
            report.note("pinned by the arrays f = '%s', w = '%s', which the file does not name: they "
                        "make the energies agree" % (norm_name, weight_name))
        energies.check_terms(data, mesh, field, norm, weight, report)
        stationarity.check_ginzburg_landau(data, mesh, field, report, norm, weight)
    else:
        _verify_perforated(data, mesh, field, boundary, indices, loops, degrees, found, report)
    # The tolerance is not in the file: 1e-10 by default, and 1e-6 for the alignment of unit norms.
    report.true("Converged only with a small residual", data.value("Converged") != 1 or
                data.value("Residual") <= 1e-6, "Residual is %s" % data.value("Residual"))


def _verify_perforated(data, mesh, field, boundary, indices, loops, degrees, found, report):
    chosen = counts.check_counts(data, mesh, boundary, indices, counts.prescribed(mesh), report)
    by_sum = False
    if data.value("Epsilon") is not None:
        report.kind = "constrained field with penalty"
        energies.check_terms(data, mesh, field, 1.0, 1.0, report)
        by_sum = stationarity.check_constrained(data, mesh, field, report)
    elif field.of_unit_norm and not mesh.of_kind(IMPRINTED):
        report.kind = "unit-norm field"
        energy, _ = unit_norm.check_unit_norm(data, mesh, field, report)
        energies.check_energy("Energy", data.value("Energy"), energy, mesh, report,
                              unit_norm.potential_range(energy, mesh))
    else:
        report.kind = "constrained field"
        energy = gradient_energies(mesh, field.in_triangle).sum()
        energies.check_energy("Energy", data.value("Energy"), energy, mesh, report)
        by_sum = stationarity.check_constrained(data, mesh, field, report)
    if mesh.of_kind(IMPRINTED):
        report.kind += ", insides kept"
    singular.check_reached(data, mesh, loops, degrees, by_sum, report)
    singular.check_unwanted(data, mesh, indices, boundary, chosen, found, report)


def _verify_h(data, mesh, field, boundary, indices, loops, degrees, found, report):
    on_holes = bool(mesh.of_kind(HOLE))
    report.kind = "H field on holes" if on_holes else "H field of points"
    report.true("crosses have norm one", field.of_unit_norm)
    hfield.check_arrays(data, mesh, on_holes, report)
    given = counts.prescribed(mesh) if on_holes else None
    chosen = counts.check_counts(data, mesh, boundary, indices, given, report)
    if on_holes:
        energy, phase = unit_norm.check_unit_norm(data, mesh, field, report)
        energies.check_energy("Energy", data.value("Energy"), energy, mesh, report,
                              unit_norm.potential_range(energy, mesh))
        hfield.check_on_holes(data, mesh, phase, report)
        singular.check_reached(data, mesh, loops, degrees, False, report)
        singular.check_unwanted(data, mesh, indices, boundary, chosen, found, report)
        return
    singular.give_to_boundary(data, mesh, boundary, found)
    hfield.check_at_points(data, mesh, field, boundary, found, chosen, report)
    if data.value("UnwantedSingularities") == 0:
        report.equal("GivenInteriorQuarters: the singularities inside",
                     data.value("GivenInteriorQuarters"), sum(s.quarter for s in found if s.inside))
    report.note("Energy and RenormalizedEnergy need a potential of their own: not recomputed")


def files_of(names):
    """Returns given files and every .vtu in given folders; for a .vtm those in its folder of
    blocks."""
    for name in map(pathlib.Path, names):
        if name.is_dir():
            yield from sorted(name.rglob("*.vtu"))
        elif name.suffix == ".vtm":
            yield from sorted(name.with_suffix("").glob("*.vtu"))
        else:
            yield name


def _worst(reports):
    """Returns for each check its number of uses and the largest fraction of its tolerance."""
    worst = collections.OrderedDict()
    for report in reports:
        for name, _, found, tolerance, _ in report.checks:
            count, share, at, where = worst.get(name, (0, 0.0, 0.0, ""))
            part = 0.0 if not found else found / tolerance if tolerance else float("inf")
            worst[name] = (count + 1, *((part, found, report.name) if part > share else (share, at, where)))
    return worst


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("names", nargs="+", help=".vtu files, .vtm files, folders")
    parser.add_argument("--quiet", action="store_true", help="failures and a summary only")
    parser.add_argument("--jobs", type=int, default=1, help="processes (default 1)")
    options = parser.parse_args(arguments)
    started = time.monotonic()
    names = list(files_of(options.names))
    if options.jobs > 1:
        with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
            reports = list(pool.map(verify, names, chunksize=4))
    else:
        reports = list(map(verify, names))
    for report in reports:
        if report.failures() or not options.quiet:
            print(report.text(everything=not options.quiet))
    verified = [report for report in reports if report.checks]
    failed = [report for report in verified if report.failures()]
    if options.quiet:
        print("checks: how many, the largest part of the tolerance that was used, and by what")
        for name, (count, share, found, where) in _worst(verified).items():
            print("  %5d  %-70s %s" % (count, name, "" if not where else "%.2g of it: %.1e  %s" % (
                share, found, pathlib.Path(where).name)))
        for kind, count in collections.Counter(report.kind for report in reports).most_common():
            print("  %5d  files: %s" % (count, kind))
    print("%d files, %d verified with %d checks, %d files failed, %.1f seconds" % (
        len(reports), len(verified), sum(len(report.checks) for report in verified), len(failed),
        time.monotonic() - started))
    return 1 if failed else 0 if verified else 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
