//! The worst value of each invariant.

/// Names and values in the order in which they were first met.
#[derive(Debug, Clone, Default)]
pub(crate) struct Worst(Vec<(&'static str, f64)>);

impl Worst {
    /// Keeps the larger of this value and what was met before.
    pub(crate) fn note(&mut self, name: &'static str, value: f64) {
        match self.0.iter_mut().find(|(own, _)| *own == name) {
            Some((_, most)) => *most = most.max(value),
            None => self.0.push((name, value)),
        }
    }

    /// Keeps it, and refuses it above its bound; not a number is above every bound.
    pub(crate) fn check(
        &mut self,
        name: &'static str,
        value: f64,
        most: f64,
    ) -> Result<(), String> {
        self.note(name, value);
        if value <= most { Ok(()) } else { Err(format!("{name} = {value:e}, above {most:e}")) }
    }

    /// Lines of TOML.
    pub(crate) fn told(&self) -> String {
        let line = |(name, value): &(&str, f64)| format!("{name} = {value:.3e}\n");
        self.0.iter().map(line).collect()
    }
}
