#!/bin/sh
# Draws the figures of the paper, from the root of the sources.
set -e
carom="cargo run --release --quiet -p carom-cli --"
$carom restitution --kappa 1,1.0556,1.125,1.2143,1.3333,1.5 --lambda 0.01:10:400 --plot paper/restitution.png
$carom solve examples/solve_spence.toml --plot paper/spence.png
