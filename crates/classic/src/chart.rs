//! Structured programs: a Nassi-Shneiderman chart that is both executed and drawn.

use std::fmt::Display;

/// A part of a structured program, as in a Nassi-Shneiderman chart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Block<S: 'static> {
    /// Performs one step.
    Do(S),
    /// Repeats all parts until the question is answered with yes.
    Until {
        /// The repeated parts.
        body: &'static [Self],
        /// The question asked after each pass.
        done: S,
    },
}

/// A step or question of a chart; its `Display` text describes it.
pub trait Step: Copy + PartialEq + Display + 'static {}

impl<S: Copy + PartialEq + Display + 'static> Step for S {}

/// The object on which a chart is executed.
pub(crate) trait Machine {
    type Step: Step;
    type Error;

    /// Performs a step; returns a number that describes its effect.
    fn perform(&mut self, step: Self::Step) -> Result<f64, Self::Error>;

    /// Answers the question asked after this pass; the first pass is 1.
    fn is_done(&mut self, question: Self::Step, round: usize) -> Result<bool, Self::Error>;
}

/// The record of a program: its steps in order.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace<S> {
    entries: Vec<Entry<S>>,
}

/// A step that was performed, or a question that was asked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Entry<S> {
    /// The step or question.
    pub step: S,
    /// The effect: sweeps, cells that changed, a correction. For a question 1 is yes, 0 is no.
    pub amount: f64,
}

impl<S> Default for Trace<S> {
    fn default() -> Self {
        Self { entries: Vec::new() }
    }
}

impl<S: Step> Trace<S> {
    /// All entries in order.
    #[must_use]
    pub fn entries(&self) -> &[Entry<S>] {
        &self.entries
    }

    /// How often a step was performed.
    #[must_use]
    pub fn count(&self, step: S) -> usize {
        self.entries.iter().filter(|entry| entry.step == step).count()
    }

    /// The sum of the effects of a step.
    #[must_use]
    pub fn total(&self, step: S) -> f64 {
        self.entries.iter().filter(|entry| entry.step == step).map(|entry| entry.amount).sum()
    }

    /// Whether a program with this chart can have produced this trace.
    #[must_use]
    pub fn follows(&self, chart: &[Block<S>]) -> bool {
        walk(&self.entries, chart).is_some_and(<[Entry<S>]>::is_empty)
    }

    pub(crate) fn clear(&mut self) {
        self.entries.clear();
    }
}

/// The entries that remain after those of the given parts of a chart.
fn walk<'a, S: Step>(mut entries: &'a [Entry<S>], blocks: &[Block<S>]) -> Option<&'a [Entry<S>]> {
    for block in blocks {
        entries = match block {
            Block::Do(step) => entries.split_first().filter(|(entry, _)| entry.step == *step)?.1,
            Block::Until { body, done } => loop {
                let (answer, rest) = walk(entries, body)?.split_first()?;
                if answer.step != *done {
                    return None;
                }
                entries = rest;
                if answer.amount == 1.0 {
                    break rest;
                }
            },
        };
    }
    Some(entries)
}

/// Executes the parts of a chart one after the other.
pub(crate) fn run<M: Machine>(
    machine: &mut M,
    blocks: &[Block<M::Step>],
    trace: &mut Trace<M::Step>,
) -> Result<(), M::Error> {
    for block in blocks {
        match block {
            Block::Do(step) => {
                let amount = machine.perform(*step)?;
                trace.entries.push(Entry { step: *step, amount });
            }
            Block::Until { body, done } => {
                for round in 1.. {
                    run(machine, body, trace)?;
                    let yes = machine.is_done(*done, round)?;
                    trace.entries.push(Entry { step: *done, amount: f64::from(u8::from(yes)) });
                    if yes {
                        break;
                    }
                }
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const INNER: &[Block<char>] = &[Block::Do('a'), Block::Do('b')];
    const CHART: &[Block<char>] = &[
        Block::Until {
            body: &[Block::Until { body: INNER, done: '?' }, Block::Do('c')],
            done: '!',
        },
        Block::Do('d'),
    ];

    struct Rounds;

    impl Machine for Rounds {
        type Step = char;
        type Error = ();

        fn perform(&mut self, _: char) -> Result<f64, ()> {
            Ok(2.0)
        }

        fn is_done(&mut self, question: char, round: usize) -> Result<bool, ()> {
            Ok(round == if question == '?' { 3 } else { 2 })
        }
    }

    #[test]
    fn what_runs_is_what_is_drawn() {
        let mut trace = Trace::default();
        run(&mut Rounds, CHART, &mut trace).unwrap();
        let steps: String = trace.entries().iter().map(|entry| entry.step).collect();
        assert_eq!(steps, "ab?ab?ab?c!ab?ab?ab?c!d");
        assert_eq!((trace.count('b'), trace.total('b')), (6, 12.0));
        assert!(trace.follows(CHART));
        assert!(!trace.follows(&CHART[..1]));
        assert!(!trace.follows(&[CHART[1], CHART[0]]));
        assert!(!trace.follows(&[Block::Until { body: INNER, done: '?' }]));
    }
}
