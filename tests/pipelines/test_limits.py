"""The program at the limits of memory, threads and writable outputs."""

import os
import re
import resource
import signal
import stat
import subprocess
import threading
import time

from program import PROGRAM, SENTENCE, ProgramTest, write_configuration

import unittest

MEBIBYTE = 2**20


class Memory(ProgramTest):
    TOO_MUCH = re.compile(
        r"edge length 1e-05 would have about 7\.\d+e\+10 triangles .* GiB available; choose a larger "
        r"edge length, about (\S+)\.\n")

    def refuse_within(self, seconds, *arguments):
        begin = time.monotonic()
        self.assertRegex(self.refuse(*arguments), self.TOO_MUCH)
        self.assertLess(time.monotonic() - begin, seconds)

    def test_a_size_that_would_take_all_memory(self):
        # From a file, because builtin:disk has 600,000 segments at this size, which take long to
        # read.
        self.succeed("domain", "disk", "-o", "disk.vtp")
        for command in (("solve", "-o", "f.vtu"), ("solve", "--method", "unit-norm"),
                        ("drill", "-o", "f.vtu"), ("hfield", "-o", "f.vtu"), ("energy",),
                        ("optimize", "-o", "f.csv"), ("compare", "-o", "f.vtm"),
                        ("solve", "--method", "ginzburg-landau"),
                        ("solve", "--mode", "imprint"), ("solve", "--mode", "triangle")):
            with self.subTest(" ".join(command)):
                self.refuse_within(10, command[0], "disk.vtp", "-s", "four.csv", "--size", "1e-5",
                                   *command[1:])

    def test_the_suggested_size_is_possible(self):
        write_configuration(self.folder / "none.csv", [])
        limit = 700 * MEBIBYTE
        result = self.run_limited(limit, "drill", "builtin:square", "-s", "none.csv", "-o", "mesh.vtu",
                                  "--size", "1e-4")
        self.assertEqual(result.returncode, 2, result)
        size = float(re.search(r"edge length, about (\S+)\.\n", result.stderr).group(1))
        # A tenth more, because the memory already in use varies between runs.
        result = self.run_limited(limit, "drill", "builtin:square", "-s", "none.csv", "-o", "mesh.vtu",
                                  "--size", 1.1 * size)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def run_limited(self, limit, *arguments):
        return self.run_program(
            *arguments,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))

    def starts(self, limit):
        """Returns whether the program starts: OpenBLAS of Debian 13 waits for ever if it is loaded with too little memory."""
        try:
            subprocess.run([PROGRAM, "--help"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=10, check=False,
                           preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
        except subprocess.TimeoutExpired:
            return False
        return True

    def test_every_limit_of_memory_ends_in_a_field_or_in_one_sentence(self):
        # From too little for the mesh to enough for everything; in between it fails at random
        # places.
        arguments = ("solve", "builtin:disk", "-s", "four.csv", "--size", "0.005", "-o", "field.vtu",
                     "--json", "report.json")
        for name in ("field.vtu", "report.json"):
            (self.folder / name).write_text("from an earlier run\n")
        before = self.snapshot()
        statuses = []
        for limit in range(300, 1500, 60):
            if not self.starts(limit * MEBIBYTE):
                continue
            result = self.run_limited(limit * MEBIBYTE, *arguments)
            with self.subTest(f"{limit} MiB"):
                self.assertIn(result.returncode, (0, 2), result)
                if result.returncode == 2:
                    self.assertRegex(result.stderr, SENTENCE)
                    self.assertIn("memory", result.stderr)
                    self.assertEqual(self.snapshot(), before)
            statuses.append(result.returncode)
            if result.returncode == 0:
                break
        self.assertEqual(statuses[-1], 0, "never enough")
        self.assertIn(2, statuses, "always enough")

    def test_a_quarter_index_with_more_edges_than_memory(self):
        write_configuration(self.folder / "many.csv", [(0.0, 0.0, 1000000000, 0.1)])
        self.refuse("drill", "builtin:disk", "-s", "many.csv", "-o", "mesh.vtu")


    def test_more_quads_than_memory(self):
        sentence = self.refuse("quads", "builtin:disk", "-s", "four.csv", "--quads", "2000000000",
                               "-o", "quads.vtu")
        self.assertIn("more than the maximum of 5e+07 quads, which need 50 GB of memory; request fewer quads.", sentence)


class Threads(ProgramTest):
    RUNS = (("solve", "--size", "0.03"), ("solve", "--size", "0.05", "--method", "unit-norm"),
            ("hfield", "--size", "0.05"), ("drill", "--size", "0.05"),
            ("solve", "--size", "0.15", "--method", "ginzburg-landau"),
            ("solve", "--size", "0.1", "--mode", "imprint"),
            ("solve", "--size", "0.1", "--epsilon", "0.1"), ("quads", "--quads", "25000"))
    LIMITS = ({"OMP_THREAD_LIMIT": "1", "OPENBLAS_NUM_THREADS": "1"},
              {"OMP_NUM_THREADS": "4", "OPENBLAS_NUM_THREADS": "4", "OMP_DYNAMIC": "true"},
              {"OMP_NUM_THREADS": "1", "OMP_WAIT_POLICY": "passive", "VTK_SMP_MAX_THREADS": "1"})

    def test_same_bytes_for_any_number_of_threads(self):
        for command, *options in self.RUNS:
            digests = set()
            for limits in ({}, *self.LIMITS):
                result = self.run_program(command, "builtin:disk", "-s", "four.csv", *options,
                                          "-o", "field.vtu", env={**os.environ, **limits})
                self.assertEqual((result.returncode, result.stderr), (0, ""), result)
                digests.add(self.digest("field.vtu"))
            with self.subTest(" ".join([command, *options])):
                self.assertEqual(len(digests), 1)


    @unittest.skipUnless(os.geteuid() == 0, "only root can become a user without other processes")
    def test_a_system_that_denies_threads(self):
        user = 54321
        self.folder.chmod(0o777)
        try:
            self.run_program("--version", user=user)
        except PermissionError:
            self.skipTest("the folder of the program is private")
        digests = set()
        for count in (1, 2, 3, 100):
            result = self.run_program(
                "solve", "builtin:disk", "-s", "four.csv", "--size", "0.012", "-o", "field.vtu", user=user,
                env={**os.environ, "OMP_NUM_THREADS": "4", "OPENBLAS_NUM_THREADS": "1"},
                preexec_fn=lambda count=count: resource.setrlimit(resource.RLIMIT_NPROC, (count, count)))
            with self.subTest(f"{count} threads"):
                self.assertEqual((result.returncode, result.stderr), (0, ""), result)
                digests.add(self.digest("field.vtu"))
        self.assertEqual(len(digests), 1)


class Transactions(ProgramTest):
    """All outputs of a command are put in place, or none."""

    # Every subcommand with two or more outputs: arguments, then options and names of outputs.
    COMMANDS = (
        (("solve", "builtin:disk", "-s", "four.csv"), (("-o", "f.vtu"), ("--json", "r.json"))),
        (("solve", "builtin:disk", "--method", "ginzburg-landau", "--size", "0.2"),
         (("-o", "f.vtu"), ("--json", "r.json"))),
        (("hfield", "builtin:disk", "-s", "four.csv"), (("-o", "f.vtu"), ("--json", "r.json"))),
        (("optimize", "builtin:disk", "-s", "four.csv", "--iterations", "200"),
         (("-o", "f.csv"), ("--json", "r.json"))),
        (("corners", "builtin:l-shape"), (("-o", "f.vtp"), ("--json", "r.json"))),
        (("check", "builtin:disk"), (("--propose", "f.csv"), ("--json", "r.json"))),
        (("compare", "builtin:disk", "-s", "four.csv", "--size", "0.2", "--methods",
          "constrained,unit-norm"), (("-o", "f.vtm"), ("--csv", "t.csv"), ("--json", "r.json"))),
    )

    def snapshot(self):
        # The time of a folder changes when files in it are written and removed.
        return {name: digest if digest == "folder" else (time, digest)
                for name, (time, digest) in super().snapshot().items()}

    def all_arguments(self, arguments, outputs):
        return [*arguments, *(word for option in outputs for word in option)]

    def test_all_outputs_are_written(self):
        for arguments, outputs in self.COMMANDS:
            with self.subTest(arguments[0]):
                result = self.run_program(*self.all_arguments(arguments, outputs))
                self.assertEqual((result.returncode, result.stderr), (0, ""), result)
                for _, name in outputs:
                    self.assertGreater((self.folder / name).stat().st_size, 0)
                    (self.folder / name).unlink()
                self.assertEqual([], [p.name for p in self.folder.glob("*.*.*")])

    def test_an_output_that_cannot_be_written_leaves_the_others_alone(self):
        for arguments, outputs in self.COMMANDS:
            for option, name in outputs:
                with self.subTest(f"{arguments[0]}: a folder in the place of {name}"):
                    (self.folder / name).mkdir()
                    self.refuse(*self.all_arguments(arguments, outputs), says=[name])
                    (self.folder / name).rmdir()
                with self.subTest(f"{arguments[0]}: a folder that is missing for {option}"):
                    others = [(o, n if o != option else f"missing/{n}") for o, n in outputs]
                    self.refuse(*self.all_arguments(arguments, others), says=["missing"])

    def test_a_full_device_leaves_the_others_alone(self):
        for arguments, outputs in self.COMMANDS:
            for option, name in outputs:
                if name.endswith(".json"):
                    with self.subTest(arguments[0]):
                        before = self.snapshot()
                        others = [(o, n if o != option else "/dev/full") for o, n in outputs]
                        result = self.run_program(*self.all_arguments(arguments, others))
                        self.assertEqual(result.returncode, 2, result)
                        self.assertRegex(result.stderr, SENTENCE)
                        self.assertIn("/dev/full", result.stderr)
                        self.assertEqual(self.snapshot(), before)
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/full").st_mode))

    def test_a_summary_that_cannot_be_printed_leaves_the_outputs_alone(self):
        before = self.snapshot()
        for arguments, outputs in self.COMMANDS:
            with self.subTest(arguments[0]), open("/dev/full", "w") as full:
                result = self.run_program(*self.all_arguments(arguments, outputs[:1]), stdout=full)
                self.assertEqual(result.returncode, 2, result)
                self.assertRegex(result.stderr, SENTENCE)
                self.assertEqual(self.snapshot(), before)

    def test_a_limit_on_the_size_of_files(self):
        # The first output fits, the second does not, and the other way round.
        for arguments, outputs in self.COMMANDS:
            for restore in (True, False):  # with its signal or without
                for limit in (16, 600, 4096):
                    for _, name in outputs:
                        (self.folder / name).write_text("from an earlier run\n")
                    before = self.snapshot()
                    result = self.run_program(
                        *self.all_arguments(arguments, outputs), restore_signals=restore,
                        preexec_fn=lambda: resource.setrlimit(
                            resource.RLIMIT_FSIZE, (limit, limit)))
                    with self.subTest(f"{arguments[0]}, {limit} bytes"):
                        if result.returncode != 0:  # 4096 bytes are enough for some outputs
                            self.assertEqual(result.returncode, 2, result)
                            self.assertRegex(result.stderr, SENTENCE)
                            self.assertEqual(self.snapshot(), before)

    def test_one_place_for_two_outputs(self):
        for arguments, outputs in self.COMMANDS:
            name = outputs[0][1]
            both = [outputs[0], *((option, f"./{name}") for option, _ in outputs[1:])]
            with self.subTest(arguments[0]):
                self.refuse(*self.all_arguments(arguments, both), says=[name])

    def test_blocks_that_cannot_be_written(self):
        arguments = (*self.COMMANDS[-1][0], "-o", "f.vtm", "--json", "r.json")
        (self.folder / "f").write_text("a file in the place of the folder\n")
        self.refuse(*arguments, says=["f'"])
        (self.folder / "f").unlink()
        (self.folder / "f" / "unit-norm.vtu").mkdir(parents=True)  # the second of the blocks
        self.refuse(*arguments, says=["unit-norm.vtu"])
        (self.folder / "f" / "unit-norm.vtu").rmdir()
        (self.folder / "f" / "other.vtu").write_text("of somebody else\n")
        self.succeed(*arguments)
        self.assertEqual((self.folder / "f" / "other.vtu").read_text(), "of somebody else\n")
        self.assertEqual(len(list((self.folder / "f").iterdir())), 3)

    def test_figures_that_cannot_be_written(self):
        arguments = ("figures", "-o", "a/b/figures", "--only", "disk_reference,disk_holes")
        (self.folder / "a/b/figures/disk_reference.vtu").mkdir(parents=True)
        before = self.snapshot()
        result = self.run_program(*arguments)
        self.assertEqual(result.returncode, 2, result)
        self.assertEqual(self.snapshot(), before)
        # Folders that the program made are removed as well; it prints before it fails.
        with open("/dev/full", "w") as full:
            result = self.run_program("figures", "-o", "new/figures", "--only", "disk_holes",
                                      stdout=full)
        self.assertEqual(result.returncode, 2, result)
        self.assertEqual(self.snapshot(), before)

    def test_a_signal_leaves_nothing_behind(self):
        # A pipe without a reader stops the program after the other outputs are written beside their
        # places.
        os.mkfifo(self.folder / "pipe")
        before = self.snapshot_without("pipe")
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(number.name):
                process = subprocess.Popen(
                    [PROGRAM, "compare", "builtin:disk", "-s", "four.csv", "--size", "0.2",
                     "--methods", "unit-norm", "-o", "new.vtm", "--json", "pipe"],
                    cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
                deadline = time.monotonic() + 30
                while not list(self.folder.glob("new.vtm.part*")):
                    self.assertLess(time.monotonic(), deadline)
                    time.sleep(0.01)
                time.sleep(0.2)
                process.send_signal(number)
                process.communicate(timeout=30)
                self.assertEqual(process.returncode, -number)
                self.assertEqual(self.snapshot_without("pipe"), before)

    def snapshot_without(self, name):
        return {key: value for key, value in self.snapshot().items() if key != name}

    def test_a_named_pipe_and_a_device_stay_what_they_are(self):
        os.mkfifo(self.folder / "pipe")
        read = []
        reader = threading.Thread(
            target=lambda: read.append((self.folder / "pipe").read_text()), daemon=True)
        reader.start()
        self.succeed("solve", "builtin:disk", "-s", "four.csv", "--json", "pipe")
        reader.join(30)
        self.assertIn('"energy"', read[0])
        self.assertTrue(stat.S_ISFIFO((self.folder / "pipe").stat().st_mode))
        self.succeed("solve", "builtin:disk", "-s", "four.csv", "--json", "/dev/null")
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))

    def test_links_and_permissions_are_kept(self):
        (self.folder / "target.json").write_text("{}")
        (self.folder / "target.json").chmod(0o600)
        (self.folder / "link.json").symlink_to("target.json")
        (self.folder / "dangling.vtu").symlink_to("later.vtu")
        self.succeed("solve", "builtin:disk", "-s", "four.csv", "--json", "link.json",
                     "-o", "dangling.vtu")
        self.assertTrue((self.folder / "link.json").is_symlink())
        self.assertIn('"energy"', (self.folder / "target.json").read_text())
        self.assertEqual((self.folder / "target.json").stat().st_mode & 0o777, 0o600)
        self.assertTrue((self.folder / "later.vtu").is_file())

    def test_input_and_output_may_be_one_file(self):
        write_configuration(self.folder / "none.csv", [])
        self.succeed("drill", "builtin:disk", "-s", "none.csv", "-o", "a.vtu")
        self.succeed("solve", "a.vtu", "-s", "four.csv", "-o", "b.vtu", "--method", "unit-norm")
        mesh = self.digest("a.vtu")
        # A refused run keeps the input.
        self.refuse("solve", "a.vtu", "-s", "four.csv", "-o", "a.vtu", "--json", "/dev/full")
        self.assertEqual(self.digest("a.vtu"), mesh)
        self.succeed("solve", "a.vtu", "-s", "four.csv", "-o", "a.vtu", "--method", "unit-norm")
        self.assertEqual(self.digest("a.vtu"), self.digest("b.vtu"))
        self.succeed("optimize", "builtin:disk", "-s", "four.csv", "-o", "better.csv")
        self.succeed("optimize", "builtin:disk", "-s", "four.csv", "-o", "four.csv")
        self.assertEqual(self.digest("four.csv"), self.digest("better.csv"))


if __name__ == "__main__":
    unittest.main()
