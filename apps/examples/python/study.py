# SPDX-License-Identifier: Apache-2.0
"""A parameter study that may be too large for one machine, over Dask (Debian's python3-distributed).

    python3 study.py                                       in this process
    python3 study.py --workers 4                           by four worker processes on this machine
    python3 study.py --scheduler tcp://head:8786           by the `dask worker` processes that joined this scheduler

The study: how the fog colour intensity is distributed over a grid of lights, extents by visibilities. The grid is cut into
chunks of indices. A chunk's result depends on its range of indices alone, so that any worker may compute it, and another
one again if the first dies. It is a histogram and a digest of all bits, of the same size however long the chunk: a study of
1e10 lights (--visibilities 5000000) is 40,000 chunks and 33 MB of results. Results are keyed by chunk, so that none counts
twice, and the sum is refused if one is missing.

Processors with the same SIMD instructions give the same bits; others differ within the stated errors, and so in the digest.
"""

import argparse
import hashlib

import litfog
import numpy as np

EXTENTS = 2000  # metres: 5 to 5,000, evenly on a logarithmic scale
CHUNK = 250_000  # lights: some milliseconds, so that Dask's own time for a task counts little
BINS = 100  # of intensity, 0 to 1


def solve_chunk(begin, end, visibilities):
    """Histogram and digest of the intensities of the lights of indices [begin, end)."""
    index = np.arange(begin, end)
    extent = 5 * 1000 ** (index % EXTENTS / (EXTENTS - 1))
    row = index // EXTENTS
    densities = [  # one fog for each row, of 50 to 10,000 m
        litfog.Fog.from_visibility(litfog.FogMode.exp, 50 * 200 ** (i / visibilities)).density
        for i in range(row[0], row[-1] + 1)
    ]
    solved = litfog.solve_fog_intensities(
        np.ones(end - begin), np.zeros(end - begin), 19 / extent**2, np.array(densities)[row - row[0]]
    )
    if solved.invalid_count:
        raise ValueError(f"{solved.invalid_count} lights of [{begin}, {end}) are invalid")
    histogram, _ = np.histogram(solved.intensity, BINS, (0, 1))
    return histogram, hashlib.sha256(solved.intensity.tobytes()).digest()


def chunks_of(visibilities):
    count = EXTENTS * visibilities
    return [(begin, min(begin + CHUNK, count)) for begin in range(0, count, CHUNK)]


def run_in_process(visibilities):
    return {begin: solve_chunk(begin, end, visibilities) for begin, end in chunks_of(visibilities)}


def run_by(client, visibilities, on_result=lambda done: None):
    """The same by the workers of a scheduler. on_result is called with the number of chunks done, after each."""
    from distributed import as_completed

    futures = {
        client.submit(solve_chunk, begin, end, visibilities, key=f"study-{visibilities}-{begin}"): begin
        for begin, end in chunks_of(visibilities)
    }
    results = {}
    for future, result in as_completed(list(futures), with_results=True):
        results[futures.pop(future)] = result  # a second result of a chunk would be a KeyError
        future.release()
        on_result(len(results))
    return results


def summarise(results, visibilities):
    """Histogram and digest of the whole grid. Refuses results that lack a chunk, or have one too many."""
    chunks = chunks_of(visibilities)
    if sorted(results) != [begin for begin, _ in chunks]:
        raise ValueError(f"the results are of {len(results)} chunks, not of the {len(chunks)} of the study")
    histogram = sum(results[begin][0] for begin, _ in chunks)
    if histogram.sum() != EXTENTS * visibilities:
        raise ValueError(f"{histogram.sum()} lights were solved, not {EXTENTS * visibilities}")
    return histogram, hashlib.sha256(b"".join(results[begin][1] for begin, _ in chunks)).hexdigest()


def positive(text):
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError(f"{number}: must be >= 1")
    return number


def main():
    parser = argparse.ArgumentParser(description="How intensity is distributed over a grid of lights.")
    parser.add_argument(
        "--visibilities", type=positive, default=5000, help="times 2,000 extents: the lights (default 5000)"
    )
    where = parser.add_mutually_exclusive_group()
    where.add_argument("--workers", type=positive, help="worker processes to start on this machine")
    where.add_argument("--scheduler", help="address of a scheduler that has workers")
    arguments = parser.parse_args()
    if arguments.workers or arguments.scheduler:
        import distributed
        import study  # as the workers import it: what stands in __main__ would be sent with each chunk

        if arguments.scheduler:
            client = distributed.Client(arguments.scheduler)
            client.upload_file(study.__file__)  # its workers need litfog installed, but not this file
        else:
            client = distributed.Client(n_workers=arguments.workers, threads_per_worker=1, dashboard_address=None)
        with client:
            results = study.run_by(client, arguments.visibilities)
    else:
        results = run_in_process(arguments.visibilities)
    histogram, digest = summarise(results, arguments.visibilities)
    for tenth, lights in enumerate(histogram.reshape(10, -1).sum(1)):
        print(f"intensity {tenth / 10:.1f} to {(tenth + 1) / 10:.1f}: {lights}")
    print(f"sha256 {digest}")


if __name__ == "__main__":
    main()
