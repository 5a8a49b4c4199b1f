//! The command line.

use std::path::PathBuf;

xflags::xflags! {
    /// Tasks of the workspace.
    cmd xtask {
        /// Computes every table and figure of the thesis and checks their claims: a table in
        /// the terminal, SVG, CSV and an HTML report in target/verification/. Fails if a claim
        /// or snapshot does.
        cmd verify {
            /// Only this figure or table, as 5.3 or table-13.1; may be repeated.
            repeated --figure id: String
            /// Only this chapter; may be repeated.
            repeated --chapter number: String
            /// Of these, only the ones with this text or regular expression in name or title.
            optional --filter pattern: String
            /// Leave out the figures that take long.
            optional --quick
            /// Rewrite the snapshots that differ, of pages whose claims all hold, and say what
            /// changed.
            optional --update
            /// List all tables and figures, done, partial or missing, and stop.
            optional --list
            /// What to print: table (unless said) or json.
            optional --format format: String
            /// Also write the result as JUnit's XML into this file.
            optional --junit file: PathBuf
            /// Also print failures as annotations of source lines, `::error file=...`; always
            /// if GITHUB_ACTIONS is set.
            optional --annotate
            /// Stop a page that takes longer than this many seconds (600 unless said).
            optional --time-limit seconds: f64
        }
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
        cmd book {
            /// Draw the book's pictures and write its case reference anew, in place of that.
            optional --update
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
        /// Computes anew what the crates store: the table of R_x of dissimilar spheres, in some 15 minutes.
        cmd generate {
            /// Must be there: the tables are all that there is to generate.
            optional --tables
            /// Compute 100 entries, drawn by a stated seed, and compare them with what is stored, writing nothing.
            optional --check
        }
        /// Runs the benchmarks.
        cmd bench {
            /// Only those whose name contains this.
            optional filter: String
        }
    }
}

impl Verify {
    /// The same options, for carom-verify, which runs at the root of the workspace.
    pub(crate) fn arguments(&self) -> Vec<String> {
        let mut arguments = Vec::new();
        let mut add = |name: &str, value: &str| {
            arguments.extend([name.to_owned(), value.to_owned()]);
        };
        self.figure.iter().for_each(|id| add("--figure", id));
        self.chapter.iter().for_each(|number| add("--chapter", number));
        self.filter.iter().for_each(|pattern| add("--filter", pattern));
        self.format.iter().for_each(|format| add("--format", format));
        self.time_limit.iter().for_each(|seconds| add("--time-limit", &seconds.to_string()));
        if let Some(file) = &self.junit {
            let file = std::path::absolute(file).unwrap_or_else(|_| file.clone());
            add("--junit", &file.to_string_lossy());
        }
        let switches = [
            ("--quick", self.quick),
            ("--update", self.update),
            ("--list", self.list),
            ("--annotate", self.annotate),
        ];
        arguments.extend(switches.iter().filter(|(_, on)| *on).map(|(name, _)| (*name).to_owned()));
        arguments
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_are_handed_on() {
        let given = "verify --figure 5.3 --figure 5.4 --chapter 6 --filter shift --quick --update \
                     --list --format json --junit /a/b.xml --annotate --time-limit 2.5";
        let words = given.split_whitespace().map(Into::into).collect();
        let XtaskCmd::Verify(verify) = Xtask::from_vec(words).unwrap().subcommand else { panic!() };
        let mut expected: Vec<&str> = given.split_whitespace().skip(1).collect();
        let mut arguments = verify.arguments();
        arguments.sort();
        expected.sort_unstable();
        assert_eq!(arguments, expected);
    }
}
