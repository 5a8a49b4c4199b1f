"""Runs a program in a process of its own, with its threads and its time limited, and reads its answer."""

import json
import os
import subprocess
import tempfile
import time

THREADS = ("OMP", "OPENBLAS", "MKL", "NUMBA", "RAYON")
# The code with which solvers.py ends for a case that a peer does not have.
LACKS = 2


def environment(threads):
    names = {f"{name}_NUM_THREADS": str(threads) for name in THREADS}
    return {**os.environ, **names, "CAROM_THREADS": str(threads)}


def answer_of(command, threads, limit=60.0):
    """The JSON of the last printed line, with the largest memory and the processor's time of the process unless it tells them itself;
    or why there is none."""
    with tempfile.TemporaryFile("w+") as out:
        code, usage = ended(command, threads, limit, out)
        out.seek(0)
        lines = out.read().strip().splitlines()
    if code is None:
        return {"failed": f"took longer than {limit:.0f} s"}
    if code == LACKS:
        return {"lacks": True}
    if code != 0 or not lines:
        return {"failed": f"ended with code {code}"}
    whole = {"megabytes": usage.ru_maxrss / 1024, "processor": usage.ru_utime + usage.ru_stime}
    return {**whole, **json.loads(lines[-1])}


def ended(command, threads, limit, out):
    """Exit code and use of resources; no code if the program was stopped."""
    command = [str(word) for word in command]
    child = subprocess.Popen(command, stdout=out, stderr=subprocess.DEVNULL, env=environment(threads))
    end = time.monotonic() + limit
    while True:
        pid, status, usage = os.wait4(child.pid, os.WNOHANG)
        if pid:
            child.returncode = os.waitstatus_to_exitcode(status)
            return child.returncode, usage
        if time.monotonic() > end:
            child.kill()
            _, status, usage = os.wait4(child.pid, 0)
            child.returncode = os.waitstatus_to_exitcode(status)
            return None, usage
        time.sleep(0.01)
