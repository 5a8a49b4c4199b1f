//! Finds the annuli that may have reached their limits.

/// For each annulus the value of `approached` up to which it cannot slip. They are grouped in
/// blocks, which are examined only if one of their annuli may slip.
#[derive(Debug, Clone, Default)]
pub(super) struct Watch {
    safe: Vec<f64>,
    /// The least value of each block, or a lower one.
    low: Vec<f64>,
}

const BLOCK: usize = 32;

impl Watch {
    pub(super) fn clear(&mut self) {
        self.safe.clear();
        self.low.clear();
    }

    pub(super) fn push(&mut self, safe: f64) {
        if self.safe.len().is_multiple_of(BLOCK) {
            self.low.push(f64::INFINITY);
        }
        self.safe.push(safe);
        if let Some(low) = self.low.last_mut() {
            *low = low.min(safe);
        }
    }

    pub(super) fn pop(&mut self) {
        self.safe.pop();
        if self.safe.len().is_multiple_of(BLOCK) {
            self.low.pop();
        }
    }

    pub(super) fn replace(&mut self, run: std::ops::Range<usize>, count: usize, safe: f64) {
        let first = run.start / BLOCK;
        if count == run.len() {
            let last = (run.end - 1) / BLOCK;
            self.safe[run].fill(safe);
            for low in &mut self.low[first..=last] {
                *low = low.min(safe);
            }
        } else {
            self.safe.splice(run, std::iter::repeat_n(safe, count));
            self.low.truncate(first);
            self.low.resize(self.safe.len().div_ceil(BLOCK), f64::NEG_INFINITY);
        }
    }

    /// Lists the annuli beyond their limits, the outermost first. Returns whether other annuli are
    /// within their limits.
    pub(super) fn find(
        &mut self,
        approached: f64,
        excess: impl Fn(usize) -> f64,
        slipping: &mut Vec<usize>,
    ) -> bool {
        slipping.clear();
        let mut len = self.safe.len();
        for (block, low) in self.low.iter_mut().enumerate().rev() {
            if *low >= approached {
                len = block * BLOCK;
                continue;
            }
            let mut least = f64::INFINITY;
            for i in (block * BLOCK..len).rev() {
                if self.safe[i] < approached {
                    let excess = excess(i);
                    if excess > 0.0 {
                        slipping.push(i);
                    }
                    self.safe[i] = approached - excess;
                }
                least = least.min(self.safe[i]);
            }
            *low = least;
            len = block * BLOCK;
        }
        slipping.len() < self.safe.len()
    }
}
