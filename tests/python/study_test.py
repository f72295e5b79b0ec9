# SPDX-License-Identifier: Apache-2.0
"""The study of apps/examples/python gives one result however its chunks are spread: over threads, over four workers of
one Dask scheduler, and over workers of two nodes, one of which is killed on the way. The nodes are addresses of this machine
(127.0.0.2, 127.0.0.3), each worker a process of its own.

study_test.py <apps/examples/python> StudyTest|DaskTest
"""

import concurrent.futures
import os
import random
import signal
import subprocess
import sys
import unittest

sys.path.insert(0, sys.argv[1])
import study  # noqa: E402

try:
    import distributed
except ImportError:
    distributed = None

VISIBILITIES = 5000


class Results:
    """What the whole study has for a result in one process and one thread."""

    @classmethod
    def setUpClass(cls):
        cls.results = study.run_in_process(VISIBILITIES)
        cls.histogram, cls.digest = study.summarise(cls.results, VISIBILITIES)

    def assert_same(self, results):
        histogram, digest = study.summarise(results, VISIBILITIES)
        self.assertEqual((list(histogram), digest), (list(self.histogram), self.digest))


class StudyTest(Results, unittest.TestCase):
    def test_chunks_by_threads_in_any_order_give_the_same_result(self):
        chunks = study.chunks_of(VISIBILITIES)
        random.Random(1).shuffle(chunks)
        with concurrent.futures.ThreadPoolExecutor(4) as threads:
            results = threads.map(lambda chunk: (chunk[0], study.solve_chunk(*chunk, VISIBILITIES)), chunks)
            self.assert_same(dict(results))

    def test_missing_doubled_and_foreign_chunks_are_refused(self):
        lacking = dict(self.results)
        del lacking[study.CHUNK]
        shifted = {begin + (begin > 0): result for begin, result in self.results.items()}
        doubled = self.results | {0: (2 * self.results[0][0], self.results[0][1])}
        for results in (lacking, shifted, doubled):
            with self.assertRaises(ValueError):
                study.summarise(results, VISIBILITIES)

    def test_no_workers_and_no_lights_are_refused(self):
        for option in ("--workers", "--visibilities"):
            ended = subprocess.run([sys.executable, study.__file__, option, "0"], capture_output=True, text=True)
            self.assertEqual(ended.returncode, 2)
            self.assertIn(f"argument {option}: 0: must be >= 1", ended.stderr)


class DaskTest(Results, unittest.TestCase):
    def test_four_workers_of_one_scheduler_give_the_same_result(self):
        output = subprocess.run(
            [sys.executable, study.__file__, "--workers", "4", "--visibilities", str(VISIBILITIES)],
            check=True, capture_output=True, text=True, timeout=60,
        ).stdout
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

    def test_two_nodes_of_which_a_worker_is_killed_give_the_same_result(self):
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
            client.upload_file(study.__file__)

            def kill_one(done):
                if done >= 4 and not left_to_victim:
                    left_to_victim.extend(client.processing([address])[address])
                    if left_to_victim:
                        victim.send_signal(signal.SIGKILL)

            self.assert_same(study.run_by(client, VISIBILITIES, kill_one))
            self.assertGreater(len(left_to_victim), 0)  # it was killed with work in hand
            self.assertEqual(victim.wait(), -signal.SIGKILL)
            self.assertNotIn(address, client.scheduler_info()["workers"])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], sys.argv[2]])
