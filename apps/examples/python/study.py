# SPDX-License-Identifier: Apache-2.0
"""A parameter study that may be too large for one machine, over Dask (Debian's python3-distributed).

    python3 study.py                                       in this process
    python3 study.py --workers 4                           by four worker processes on this machine
    python3 study.py --scheduler tcp://head:8786           by the `dask worker` processes that joined this scheduler

The study: how the fog colour intensity is distributed over a grid of lights, extents by visibilities. The grid is cut into
chunks of indices (chunks.py). A chunk's result is a histogram and a digest of all bits, of the same size however long the
chunk: a study of 1e10 lights (--visibilities 5000000) is 40,000 chunks and 33 MB of results.

Processors with the same SIMD instructions give the same bits; others differ within the stated errors, and so in the digest.
"""

import argparse
import hashlib

import chunks
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
    metres = 50 * 200 ** (np.arange(row[0], row[-1] + 1) / visibilities)  # one fog for each row, of 50 to 10,000 m
    densities = litfog.density_from_visibility("exp", metres)
    solved = litfog.solve_fog_intensities(
        np.ones(end - begin), np.zeros(end - begin), 19 / extent**2, densities[row - row[0]]
    )
    if solved.invalid_count:
        raise ValueError(f"{solved.invalid_count} lights of [{begin}, {end}) are invalid")
    histogram, _ = np.histogram(solved.intensity, BINS, (0, 1))
    return histogram, hashlib.sha256(solved.intensity.tobytes()).digest()


def chunks_of(visibilities):
    count = EXTENTS * visibilities
    return {begin: (begin, min(begin + CHUNK, count), visibilities) for begin in range(0, count, CHUNK)}


def summarise(results, visibilities):
    """Histogram and digest of the whole grid."""
    chunks.require_all(results, chunks_of(visibilities))
    histogram = sum(results[begin][0] for begin in sorted(results))
    if histogram.sum() != EXTENTS * visibilities:
        raise ValueError(f"{histogram.sum()} lights were solved, not {EXTENTS * visibilities}")
    return histogram, hashlib.sha256(b"".join(results[begin][1] for begin in sorted(results))).hexdigest()


def main():
    parser = argparse.ArgumentParser(description="How intensity is distributed over a grid of lights.")
    parser.add_argument(
        "--visibilities", type=chunks.positive, default=5000, help="times 2,000 extents: the lights (default 5000)"
    )
    chunks.add_options(parser)
    options = parser.parse_args()
    results = chunks.run(solve_chunk, chunks_of(options.visibilities), options)
    histogram, digest = summarise(results, options.visibilities)
    for tenth, lights in enumerate(histogram.reshape(10, -1).sum(1)):
        print(f"intensity {tenth / 10:.1f} to {(tenth + 1) / 10:.1f}: {lights}")
    print(f"sha256 {digest}")


if __name__ == "__main__":
    main()
