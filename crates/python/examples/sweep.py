"""A hundred thousand impacts on many processes, by any executor: here dask.distributed, local workers.

    pip install distributed
    python sweep.py

Each task is a part of the motions; the outcome has the same bits as in one process.
"""

from __future__ import annotations

import numpy as np

import carom

STEEL = carom.Material(208e9, 0.3)
BALL = carom.sphere(0.01, STEEL, 0.033)
PLATE = carom.plane(STEEL)


def motions(count: int) -> np.ndarray:
    """Velocities of a ball that falls on a plate."""
    return np.random.default_rng(2).normal(size=(count, 3)) - [0, 0, 4]


def rebounds(velocities: np.ndarray) -> np.ndarray:
    """The velocities afterwards."""
    return carom.collide_many(BALL, PLATE, 0.3, body_1_velocity=velocities).body_1_velocity


def main(count: int = 100_000, workers: int = 2) -> np.ndarray:
    """The sweep on local workers."""
    from distributed import Client, LocalCluster

    parts = np.array_split(motions(count), 4 * workers)
    with (
        LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster,
        Client(cluster) as client,
    ):
        return np.concatenate(client.gather(client.map(rebounds, parts)))


if __name__ == "__main__":
    after = main()
    print(f"{len(after)} impacts; mean velocity afterwards {after.mean(axis=0).round(4)} m/s")
