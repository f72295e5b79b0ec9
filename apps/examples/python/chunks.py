# SPDX-License-Identifier: Apache-2.0
"""Chunks of work, in this process or by Dask's workers (Debian's python3-distributed): what study.py and catalogue.py share.

Chunks are a dictionary of keys and arguments. A chunk's result depends on its arguments alone, so that any worker may compute
it, and another one again if the first dies. Results have their chunk's key, so that none counts twice, and none may be missing.
"""

import argparse
import importlib
import pathlib
import sys
import uuid


def positive(text):
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError(f"{number}: must be >= 1")
    return number


def add_options(parser):
    where = parser.add_mutually_exclusive_group()
    where.add_argument("--workers", type=positive, help="worker processes to start on this machine")
    where.add_argument("--scheduler", help="address of a scheduler that has workers")


def run(work, chunks, options):
    """The results of work(*arguments) by the chunks' keys, computed where the options say."""
    if not options.workers and not options.scheduler:
        return {key: work(*arguments) for key, arguments in chunks.items()}
    import distributed

    if work.__module__ == "__main__":  # as the workers import it: what stands in __main__ would be sent with each chunk
        work = getattr(importlib.import_module(pathlib.Path(sys.argv[0]).stem), work.__name__)
    if options.scheduler:
        try:
            client = distributed.Client(options.scheduler)
        except (OSError, ValueError) as error:
            raise SystemExit(f"--scheduler {options.scheduler}: {error}") from None
    else:
        client = distributed.Client(n_workers=options.workers, threads_per_worker=1, dashboard_address=None)
    with client:
        return run_by(client, work, chunks)


def run_by(client, work, chunks, on_result=lambda done: None):
    """The same by the workers of a scheduler, which need litfog installed, but not this file nor that of the work.
    on_result is called with the number of chunks done, after each."""
    from distributed import as_completed

    for file in (__file__, sys.modules[work.__module__].__file__):
        client.upload_file(file)
    run_id = uuid.uuid4()  # Dask gives tasks of one key one result, also those of other runs
    futures = {
        client.submit(work, *arguments, key=f"{work.__module__}-{run_id}-{key}"): key
        for key, arguments in chunks.items()
    }
    results = {}
    for future, result in as_completed(list(futures), with_results=True):
        results[futures.pop(future)] = result  # a second result of a chunk would be a KeyError
        future.release()
        on_result(len(results))
    return results


def require_all(results, chunks):
    """Refuses results that lack a chunk, or have one too many."""
    if results.keys() != chunks.keys():
        raise ValueError(f"the results are of {len(results)} chunks, not of the {len(chunks)} that there are")
