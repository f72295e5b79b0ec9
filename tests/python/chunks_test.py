# SPDX-License-Identifier: Apache-2.0
"""The study and the catalogue of apps/examples/python give one result however their chunks are spread: over threads, over
four workers of one Dask scheduler, and over workers of two nodes, one of which is killed on the way. The nodes are addresses
of this machine (127.0.0.2, 127.0.0.3), each worker a process of its own.

chunks_test.py <apps/examples/python> <tests/data/photometry> <folder of litfog-fit> StudyTest|CatalogueTest|DaskTest
"""

import concurrent.futures
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

examples, photometry, commands, chosen = sys.argv[1:]
sys.path.insert(0, examples)
os.environ["PATH"] = os.pathsep.join((commands, os.environ["PATH"]))
import catalogue  # noqa: E402
import chunks  # noqa: E402
import study  # noqa: E402

try:
    import distributed
except ImportError:
    distributed = None

VISIBILITIES = 5000


def run_in_order(work, of, order):
    """The results of chunks, computed by four threads in an order."""
    with concurrent.futures.ThreadPoolExecutor(4) as threads:
        return dict(zip(order, threads.map(lambda key: work(*of[key]), order)))


def shuffled(of):
    return random.Random(1).sample(list(of), len(of))


def catalogue_folder(test):
    """Some 40 files in two folders, of which one is no photometric file and one lacks what it names."""
    folder = pathlib.Path(tempfile.mkdtemp())
    test.addClassCleanup(shutil.rmtree, folder)
    for maker in ("", "a maker, and/b"):
        (folder / maker).mkdir(parents=True, exist_ok=True)
        for file in pathlib.Path(photometry).glob("*.ies"):
            shutil.copy(file, folder / maker)
    (folder / "bad.ies").write_text("no lamp")
    return folder


class Catalogue:
    """What a catalogue in chunks of five has for a result in one process."""

    @classmethod
    def set_up_catalogue(cls):
        cls.folder = catalogue_folder(cls)
        cls.addClassCleanup(setattr, catalogue, "CHUNK", catalogue.CHUNK)
        catalogue.CHUNK = 5
        cls.parts = catalogue.chunks_of(cls.folder)
        cls.catalogue = cls.gathered(run_in_order(catalogue.fit_chunk, cls.parts, cls.parts))

    @classmethod
    def gathered(cls, results):
        with tempfile.TemporaryDirectory() as lights:
            table, messages = catalogue.gather(results, cls.parts, cls.folder, pathlib.Path(lights))
            files = sorted(file for file in pathlib.Path(lights).rglob("*") if file.is_file())
            return table, messages, {str(file.relative_to(lights)): file.read_bytes() for file in files}


class Study:
    """What the whole study has for a result in one process and one thread."""

    @classmethod
    def set_up_study(cls):
        cls.study = study.chunks_of(VISIBILITIES)
        cls.results = {key: study.solve_chunk(*arguments) for key, arguments in cls.study.items()}
        cls.histogram, cls.digest = study.summarise(cls.results, VISIBILITIES)

    def assert_same_study(self, results):
        histogram, digest = study.summarise(results, VISIBILITIES)
        self.assertEqual((list(histogram), digest), (list(self.histogram), self.digest))


class StudyTest(Study, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.set_up_study()

    def test_chunks_by_threads_in_any_order_give_the_same_result(self):
        self.assert_same_study(run_in_order(study.solve_chunk, self.study, shuffled(self.study)))

    def test_missing_doubled_and_foreign_chunks_are_refused(self):
        lacking = dict(self.results)
        del lacking[study.CHUNK]
        shifted = {begin + (begin > 0): result for begin, result in self.results.items()}
        doubled = self.results | {0: (2 * self.results[0][0], self.results[0][1])}
        for results in (lacking, shifted, doubled):
            self.assertRaises(ValueError, study.summarise, results, VISIBILITIES)

    def test_no_workers_and_no_lights_are_refused(self):
        for option in ("--workers", "--visibilities"):
            ended = subprocess.run([sys.executable, study.__file__, option, "0"], capture_output=True, text=True)
            self.assertEqual(ended.returncode, 2)
            self.assertIn(f"argument {option}: 0: must be >= 1", ended.stderr)


class CatalogueTest(Catalogue, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.set_up_catalogue()

    def test_chunks_by_threads_in_any_order_give_the_same_result(self):
        self.assertEqual(self.gathered(run_in_order(catalogue.fit_chunk, self.parts, shuffled(self.parts))), self.catalogue)

    def test_every_file_has_a_row_and_every_good_one_a_light(self):
        (header, *rows), messages, lights = self.catalogue
        files = [file.relative_to(self.folder) for file in sorted(self.folder.rglob("*.ies"))]
        self.assertEqual((header[0], header[-1]), ("input", "status"))
        self.assertEqual(sorted(row[0] for row in rows), sorted(map(str, files)))
        good = [row[0] for row in rows if row[-1] != "error"]
        self.assertEqual(sorted(lights), sorted(str(pathlib.Path(name).with_suffix(".json")) for name in good))
        self.assertEqual([row[-1] for row in rows if row[0] == "bad.ies"], ["error"])
        self.assertIn("bad.ies:1:8: TILT: must be given, but the file ends here", messages)
        self.assertTrue(any(message.startswith("a maker, and/b/tilt_file.ies:5:6: TILT") for message in messages))

    def test_program_gives_what_the_command_gives(self):
        with tempfile.TemporaryDirectory() as lights, tempfile.TemporaryDirectory() as own_lights:
            folder = self.folder / "a maker, and" / "b"
            ended = subprocess.run([sys.executable, catalogue.__file__, folder, lights], capture_output=True, text=True)
            own = subprocess.run(
                ["litfog-fit", "--format", "csv", "-o", own_lights, *sorted(os.listdir(folder))],
                cwd=folder, capture_output=True, text=True,
            )  # fmt: skip
            self.assertEqual(ended.returncode, 0)
            self.assertEqual(ended.stdout, own.stdout)
            self.assertEqual(ended.stderr, own.stderr)
            for file in pathlib.Path(own_lights).iterdir():
                self.assertEqual((pathlib.Path(lights) / file.name).read_bytes(), file.read_bytes())

    def test_two_files_of_one_light_and_no_file_are_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            for wanted in ("holds no photometric file", "lamp.ldt: must not differ from another file in its ending alone"):
                ended = subprocess.run([sys.executable, catalogue.__file__, folder, folder], capture_output=True, text=True)
                self.assertNotEqual(ended.returncode, 0)
                self.assertIn(wanted, ended.stderr)
                for name in ("lamp.ies", "lamp.ldt"):
                    (pathlib.Path(folder) / name).touch()

    def test_lights_that_cannot_be_written_and_a_missing_command_are_told_before_files_are_fitted(self):
        for lights, path, wanted in (
            (self.folder / "bad.ies", os.environ["PATH"], "bad.ies: cannot be made: File exists\n"),
            (self.folder, "", "litfog-fit must be in PATH: install litfog-tools\n"),
        ):
            ended = subprocess.run(
                [sys.executable, catalogue.__file__, self.folder, lights],
                env=os.environ | {"PATH": path}, capture_output=True, text=True,
            )  # fmt: skip
            self.assertEqual(ended.returncode, 2)
            self.assertTrue(ended.stderr.endswith(wanted), ended.stderr)


class DaskTest(Study, Catalogue, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.set_up_study()
        cls.set_up_catalogue()

    def test_four_workers_of_one_scheduler_give_the_same_result(self):
        output = subprocess.run(
            [sys.executable, study.__file__, "--workers", "4", "--visibilities", str(VISIBILITIES)],
            check=True, capture_output=True, text=True, timeout=60,
        ).stdout  # fmt: skip
        self.assertEqual(output.splitlines()[-1], f"sha256 {self.digest}")

    def start(self, *command):
        """Starts a process of Dask's and returns it and the line that says its address."""
        process = subprocess.Popen([sys.executable, "-m", *command], stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        for line in process.stderr:
            for word in line.split():
                if word.startswith("tcp://127."):
                    return process, word
        self.fail(f"{command} ended with {process.wait()}")

    def run_while_one_is_killed(self, work, of):
        """The results of chunks by workers of two nodes, of which one is killed with work in hand."""
        _, scheduler = self.start("distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard")
        workers = [
            self.start("distributed.cli.dask_worker", scheduler, "--host", node, "--no-nanny", "--nthreads", "1",
                       "--no-dashboard")
            for node in ("127.0.0.2", "127.0.0.3") for _ in range(2)
        ]  # fmt: skip
        victim, address = workers[-1]
        left_to_victim = []

        with distributed.Client(scheduler) as client:
            client.wait_for_workers(len(workers), timeout=30)
            self.assertEqual(
                {worker["host"] for worker in client.scheduler_info()["workers"].values()}, {"127.0.0.2", "127.0.0.3"}
            )

            def kill_one(done):
                if done >= 2 and not left_to_victim:
                    left_to_victim.extend(client.processing([address])[address])
                    if left_to_victim:
                        victim.send_signal(signal.SIGKILL)

            results = chunks.run_by(client, work, of, kill_one)
            self.assertGreater(len(left_to_victim), 0)
            self.assertEqual(victim.wait(), -signal.SIGKILL)
            self.assertNotIn(address, client.scheduler_info()["workers"])
        return results

    def test_study_on_two_nodes_of_which_a_worker_is_killed_gives_the_same_result(self):
        self.assert_same_study(self.run_while_one_is_killed(study.solve_chunk, self.study))

    def test_catalogue_on_two_nodes_of_which_a_worker_is_killed_gives_the_same_result(self):
        self.assertEqual(self.gathered(self.run_while_one_is_killed(catalogue.fit_chunk, self.parts)), self.catalogue)

    def test_catalogue_by_four_workers_of_one_scheduler_gives_the_same_result(self):
        with distributed.Client(n_workers=4, threads_per_worker=1, dashboard_address=None) as client:
            self.assertEqual(self.gathered(chunks.run_by(client, catalogue.fit_chunk, self.parts)), self.catalogue)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], chosen])
