//! The command line.

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
            /// Leave out the figures that take long.
            optional --quick
            /// Rewrite the snapshots that differ.
            optional --update
            /// List all tables and figures, done or missing, and stop.
            optional --list
        }
        /// Runs all tests and documentation examples, optimised; with cargo-nextest if it is
        /// installed.
        cmd test {}
        /// Breaks the physics in each way of xtask/mutants.toml, one at a time, and shows which
        /// test and which claim notices; fails if a mutant survives that the list does not explain.
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
        }
        /// What continuous integration checks: form, lints, documentation, tests, the quick
        /// figures, and the mutants.
        cmd ci {}
        /// Runs the benchmarks.
        cmd bench {
            /// Only those whose name contains this.
            optional filter: String
        }
    }
}

impl Verify {
    /// The same options, for carom-verify.
    pub(crate) fn arguments(&self) -> Vec<String> {
        let mut arguments = Vec::new();
        for id in &self.figure {
            arguments.extend(["--figure".to_owned(), id.clone()]);
        }
        for number in &self.chapter {
            arguments.extend(["--chapter".to_owned(), number.clone()]);
        }
        let switches = [("--quick", self.quick), ("--update", self.update), ("--list", self.list)];
        arguments.extend(switches.iter().filter(|(_, on)| *on).map(|(name, _)| (*name).to_owned()));
        arguments
    }
}
