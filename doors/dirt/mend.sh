#!/bin/sh
# Copies the crates of DIRT below target/, and mends them so that they compile.
#
# DIRT 0.1.4 reads the numbers of atoms as fields of its substrate, and registers columns by a function of it. soil_core
# 0.1.4, the only version that the registry has for it, keeps these private and has public functions in their place. So the
# published crates do not compile (E0616, E0624), and this calls the functions. Nothing else is changed. Once DIRT is
# published again, this file, published/ and the patch in Cargo.toml can go.
set -eu
cd "$(dirname "$0")"
copies=../../target/doors/dirt/vendor
done="$copies/mended"
if [ "$done" -nt mend.sh ] && [ "$done" -nt published/Cargo.lock ]; then
    exit 0
fi
rm -rf "$copies"
${CARGO:-cargo} vendor --locked --quiet --manifest-path published/Cargo.toml "$copies" >/dev/null
find "$copies" -path '*/dirt_*/src/*' -name '*.rs' -exec sed -i -E \
    -e 's/([^a-z_]atoms?)\.natoms = ([a-z_]+);/\1.set_global_natoms(\2);/' \
    -e 's/([^a-z_]atoms?)\.(nlocal|natoms|nghost)([^a-z_(])/\1.\2()\3/g' \
    -e 's/^( *\.natoms)$/\1()/' \
    -e 's/\.try_register\(DemAtom::default\(\), 0\)/.register_for_atoms(DemAtom::default(), \&atom)/' {} +
touch "$done"
