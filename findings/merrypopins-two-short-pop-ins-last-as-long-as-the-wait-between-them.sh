#!/usr/bin/env bash
# Finding: In merrypopins the total duration of the pop-ins of an indentation is the time from the first to the last, all the elastic loading between them included.
# Package: merrypopins 1.1.2 (PyPI)
# Expected: The total of two pop-ins that last 0.2 s each is 0.4 s, as the sum over the lengths that the package itself computes, however far they lie apart.
# Seen: 20.2 s for two that are 20 s apart, 50.2 s for 50 s, and the share of the test that is pop-in 34 and 84 % in place of 0.7 %; for one pop-in it is right.
# Touches carom: None in its code; durations from this summary are no measure of the slips that a contact history of carom is compared with.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-compile numpy==2.4.6 scipy==1.17.1 pandas==2.3.3 matplotlib==3.10.7 scikit-learn==1.7.2
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-deps merrypopins==1.1.2
cd "$folder"
cat > total.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
import pandas as pd
from merrypopins.statistics import calculate_curve_summary, default_statistics

print("merrypopins", importlib.metadata.version("merrypopins"))


def curve(starts: list[float]) -> pd.DataFrame:
    """Load and depth over 60 s, 10 points a second; at each start the load dips for 0.2 s while the tip sinks by 5 nm."""
    time = np.arange(601) / 10
    load, depth = 100.0 * time, 10.0 * time ** (2 / 3)
    flags = np.zeros(len(time), dtype=bool)
    for start in starts:
        first = int(round(10 * start))
        load[first + 1] = load[first] - 5
        load[first + 2 :] += load[first] - load[first + 2]
        depth[first + 1 :] += 5
        flags[first] = True
    return pd.DataFrame({"Time (s)": time, "Load (µN)": load, "Depth (nm)": depth, "popin": flags})


fault = False
for starts in ([20.0], [20.0, 40.0], [5.0, 55.0], [5.0, 20.0, 40.0]):
    found = default_statistics(curve(starts))
    lengths = found["popin_length"].dropna()
    summary = calculate_curve_summary(found)
    total = float(summary["total_popin_duration"])
    print(f"pop-ins at {starts} s: expected a total of {lengths.sum():.2f} s, seen {total:.2f} s of {summary['total_test_duration']:.0f} s, {summary['n_popins']:.0f} pop-ins")
    fault |= len(lengths) != len(starts) or int(summary["n_popins"]) != len(starts) or np.abs(lengths - 0.2).max() > 1e-9
    fault |= abs(total - (starts[-1] - starts[0] + 0.2)) > 1e-9
sys.exit(int(fault))
PYTHON
env/bin/python total.py 2> log.txt || { cat log.txt; exit 1; }
