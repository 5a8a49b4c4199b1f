//! The command line.

xflags::xflags! {
    /// Tasks of the workspace.
    cmd xtask {
        /// Computes every table and figure of the thesis and checks their claims: a table in
        /// the terminal, SVG, CSV and an HTML report in target/verification/. Fails if a claim
        /// or snapshot does. `cargo xtask verify --help` lists its options.
        cmd verify {}
        /// Runs all tests, documentation examples and example programs, optimised; with
        /// cargo-nextest if it is installed. `test laws` runs the tests of one crate, `test laws hertz` those
        /// whose name contains a word.
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
        /// Breaks the code in each way of xtask/mutants.toml, one at a time, and shows which test and which
        /// claim notices; fails if a mutant survives that the list does not explain. Those of the Python layer
        /// and of the LAMMPS plugin run with --layers.
        cmd mutants {
            /// Only the mutants whose item or name contains this.
            optional --only text: String
            /// Only so many, drawn by the seed.
            optional --sample count: usize
            /// Draws the sample; without it, the commit.
            optional --seed number: u64
            /// Only the tests that are known to notice, and others where these do not.
            optional --quick
            /// Note which test notices which mutant, for --quick.
            optional --record
            /// Only those of the Python layer and of the LAMMPS plugin, against their tests.
            optional --layers
        }
        /// Holds the index of the thesis's equations against the code: each item that it names is
        /// there, each equation and figure that a comment quotes is in the index or the catalogue,
        /// and none is left out. Each package says what a registry asks.
        cmd tidy {}
        /// Looks at the report of the last run in a browser without a window, at two widths and in
        /// both themes: no error of a script, no missing picture, nothing wider than the page, no
        /// pale words, search that finds; keeps screenshots. Skipped where there is no Chromium; in
        /// CI that is a failure.
        cmd browse {}
        /// Builds the Python module's wheel, installs it into a fresh environment below target/ and
        /// runs its tests and the examples of its documentation there. Skipped where there is no
        /// Python; in CI that is a failure.
        cmd python {}
        /// Goes through the list of what a release needs, releasing nothing: descriptions, licences and
        /// versions of all crates, their packages, built from what is packed, changed interfaces, the
        /// wheel.
        cmd release {
            /// Must be there: what goes to a registry goes by hand.
            optional --dry-run
            /// Pack without building what is packed, and leave out the wheel.
            optional --quick
        }
        /// Checks the links of the book below docs/book and makes its pages in target/book, where there is
        /// an mdbook.
        cmd book {}
        /// Writes the files that are made from the sources: the C header, the book's pictures and case reference,
        /// the result classes of Python. Snapshots of figures are written by `verify --update`, the record of
        /// mutants by `mutants --record`.
        cmd generate {
            /// In place of these, the table of R_x of dissimilar spheres that the crates store: some 15 minutes.
            optional --tables
            /// Compare the files with what would be written; fail if one differs. Of the table 100 entries, drawn by a
            /// stated seed.
            optional --check
        }
        /// Builds the LAMMPS plugin for the pinned release, in an environment below target/, and runs
        /// its tests there. Skipped only where the registry of Python's packages cannot be reached; in CI that
        /// is a failure.
        cmd lammps {
            /// Leave out the tests that take minutes.
            optional --short
        }
        /// Holds the dependencies against deny.toml by cargo-deny: licences, bans, sources, and advisories where
        /// their database can be fetched.
        cmd deny {}
        /// What continuous integration checks for every change: form, the index of equations, lints, tests,
        /// documentation, the quick figures, the report in a browser, the Python module; and, where paths that
        /// decide on them changed, the dependencies, the packages, the book, the LAMMPS plugin and the mutants.
        /// Changes are counted from the commit CAROM_BASE, else from origin/main, else from the commit before.
        /// Where CI is set, a part that is skipped is a failure, but for those in xtask/src/outcome.rs.
        cmd ci {
            /// All of this whatever changed, and what takes long: tests with overflow checks, the ignored
            /// tests, all tests of the LAMMPS plugin, the C border under sanitizers, a search for a bad path of
            /// Coulomb's law, every mutant against all tests.
            optional --long
        }
        /// Runs the benchmarks.
        cmd bench {
            /// Only those whose name contains this.
            optional filter: String
        }
    }
}
