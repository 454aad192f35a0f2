"""Meshes many domains with `crossfield quads` and prints a table and a summary:

  python3 tests/corpus/survey.py PROGRAM [--seeds 0-206] [--files FILE...] [--options OPTION...]

Domains are random (random_domains.py) or given as files. A run ends after `--seconds`. The table is
in Markdown: quads, irregular nodes, blocks, minimum scaled Jacobian, its attainable bound and their
ratio, variation of sizes (standard deviation of edge length by its mean), processor seconds of the
whole run. `--keep FOLDER` writes the random domains there.
"""

import argparse
import json
import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import threading

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "pipelines"))
import domain_files
import random_domains

HEADER = """| domain | quads | irregular nodes | blocks | min SJ | attainable | ratio | sizes | seconds |
| --- | --- | --- | --- | --- | --- | --- | --- | --- |"""


def write_loops(folder, name, loops):
    """Writes closed curves as .vtp; returns the path."""
    points, lines = [], []
    for loop in loops:
        first = len(points)
        points += loop
        lines.append([*range(first, len(points)), first])
    path = pathlib.Path(folder) / (name + ".vtp")
    domain_files.write_vtp(path, points, lines)
    return path


def write_domain(folder, seed):
    return write_loops(folder, *random_domains.domain(seed))


def mesh(program, path, seconds=60, options=()):
    """Meshes a domain; returns a dictionary with `name`, processor `seconds`, and the `report` of the
    run or its `failure`."""
    with tempfile.TemporaryDirectory(prefix="crossfield-") as folder:
        printed, said = (pathlib.Path(folder) / name for name in ("printed", "said"))
        with open(printed, "wb") as out, open(said, "wb") as err:
            process = subprocess.Popen(
                [str(program), "quads", str(path), "-o", folder + "/quads.vtu", "--json", "-",
                 *options], stdout=out, stderr=err,
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5)))
            alarm = threading.Timer(5 * seconds, process.kill)  # the machine may be busy
            alarm.start()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            alarm.cancel()
        result = {"name": pathlib.Path(path).stem, "warning": said.read_text().strip(),
                  "seconds": usage.ru_utime + usage.ru_stime}
        if process.returncode == 0:
            result["report"] = json.loads(printed.read_text())
        elif process.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
            result["failure"] = f"No result after {seconds} processor seconds."
        else:
            result["failure"] = result["warning"] or f"Ended with {process.returncode}."
        return result


def problem(result):
    """Returns what is wrong with a result, or an empty text."""
    if "failure" in result:
        return result["failure"]
    report = result["report"]
    if report["inverted"]:
        return f"{report['inverted']} inverted quads."
    if report["irregular"] != report["asked"]:
        return f"Irregular nodes {report['irregular']}, requested {report['asked']}."
    return ""


def ratio(report):
    return report["scaled_jacobian"]["min"] / report["scaled_jacobian"]["bound"]


def nodes(report):
    return ", ".join(f"{count} × {valence}" for valence, count in report["irregular"].items()) or "–"


def row(result):
    if "failure" in result:
        return f"| {result['name']} | failed | | | | | | | {result['seconds']:.2f} |"
    report = result["report"]
    jacobian = report["scaled_jacobian"]
    return (f"| {result['name']} | {report['quads']} | {nodes(report)} | {report['blocks']} "
            f"| {jacobian['min']:.3f} | {jacobian['bound']:.3f} | {ratio(report):.2f} "
            f"| {report['size_variation']:.2f} | {result['seconds']:.2f} |")


def quantile(values, portion):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(portion * len(ordered)))]


def summary(results):
    """Returns lines with failures, then median, 90 % and extreme values."""
    failed = [result for result in results if problem(result)]
    meshed = [result["report"] for result in results if "report" in result]
    lines = [f"{len(results)} domains, {len(failed)} failures"]
    lines += [f"  {result['name']}: {problem(result)}" for result in failed]
    lines += [f"  {result['name']} warns: {result['warning']}" for result in results
              if not problem(result) and result["warning"]]

    def line(title, values, low=False):
        part = 0.1 if low else 0.9
        last = min(values) if low else max(values)
        return (f"{title}: median {quantile(values, 0.5):.3g}, {round(100 * part)} % "
                f"{quantile(values, part):.3g}, {'min' if low else 'max'} {last:.3g}")
    lines.append(line("processor seconds", [result["seconds"] for result in results]))
    if meshed:
        lines += [
            line("min SJ / attainable", [ratio(report) for report in meshed], low=True),
            line("variation of sizes", [report["size_variation"] for report in meshed]),
            line("irregular nodes", [sum(report["irregular"].values()) for report in meshed])]
    return lines


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=lambda name: pathlib.Path(name).resolve())
    parser.add_argument("--seeds", default="0-206", help="first and last seed")
    parser.add_argument("--files", nargs="*", default=[], help="meshes these instead")
    parser.add_argument("--seconds", type=int, default=60)
    parser.add_argument("--options", nargs=argparse.REMAINDER, default=[],
                        help="options of `crossfield quads`; last")
    parser.add_argument("--keep", help="folder for the random domains")
    parser.add_argument("--json", help="writes all results to this file")
    given = parser.parse_args()
    results = []
    print(HEADER, flush=True)
    with tempfile.TemporaryDirectory(prefix="crossfield-") as folder:
        first, _, last = given.seeds.partition("-")
        seeds = [] if given.files else range(int(first), int(last or first) + 1)
        if given.keep:
            pathlib.Path(given.keep).mkdir(parents=True, exist_ok=True)
        for domain in given.files or seeds:
            path = domain if given.files else write_domain(given.keep or folder, domain)
            results.append(mesh(given.program, path, given.seconds, given.options))
            print(row(results[-1]), flush=True)
    print("", *summary(results), sep="\n")
    if given.json:
        pathlib.Path(given.json).write_text(json.dumps(results, indent=1))
    sys.exit(1 if any(problem(result) for result in results) else 0)


if __name__ == "__main__":
    main()
