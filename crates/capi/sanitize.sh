#!/usr/bin/env bash
# sanitize.sh [CALLS]: the C border, called a million times (or CALLS) with whatever arguments and bytes, under the
# address sanitizer of the nightly in .ci/nightly; then some of the calls and the example in C under valgrind,
# which sees what was never written. Where that nightly is not installed: under valgrind alone, and more of them.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../.."
calls=${1:-1000000}
host=$(rustc -vV | sed -n 's/^host: //p')
pinned=$(cat .ci/nightly)

toolchain=$(.ci/toolchain)
few=20000
if [ -n "$toolchain" ]; then
    echo "== $calls calls under the address sanitizer of $pinned"
    export RUSTFLAGS="${RUSTFLAGS-} -Zsanitizer=address" CAROM_CALLS=$calls
    cargo "+$toolchain" test --release --package carom-capi --target "$host" --target-dir target/sanitized \
        --test it -- --include-ignored --nocapture garbled:: border:: wrong_bodies:: hostile::
    unset RUSTFLAGS CAROM_CALLS
else
    echo "== $pinned is not installed: no address sanitizer"
    few=100000
fi

command -v valgrind >/dev/null || { echo "sanitize.sh: valgrind is not installed" >&2; exit 1; }
echo "== $few calls under valgrind"
cargo test --release --package carom-capi --test it --no-run
tests=$(cargo test --release --package carom-capi --test it --no-run --message-format=json 2>/dev/null |
    sed -n 's/.*"executable":"\([^"]*\)".*/\1/p' | tail -n 1)
CAROM_CALLS=$few valgrind --quiet --error-exitcode=9 "$tests" --ignored --nocapture hostile::
(cd "$here" && "$tests" programs::)
echo "== the border holds"
