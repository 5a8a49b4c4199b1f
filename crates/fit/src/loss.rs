//! How large residuals count.

/// How large residuals count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Loss {
    /// By their squares.
    #[default]
    Squares,
    /// Pseudo-Huber: by their squares up to about 1.345 standard errors, then by their size, so that single wrong values
    /// count little.
    Huber,
}

impl Loss {
    /// The standard errors beyond which a residual counts by its size.
    pub const KNEE: f64 = 1.345;

    /// Its word.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Squares => "squares",
            Self::Huber => "pseudo-Huber",
        }
    }

    /// The residual whose square counts, and its derivative by the given one.
    pub(crate) fn seen(self, residual: f64) -> [f64; 2] {
        match self {
            Self::Squares => [residual, 1.0],
            Self::Huber => {
                // (root - 1)(root + 1) = part^2, without cancellation.
                let part = residual / Self::KNEE;
                let root = (1.0 + part * part).sqrt();
                let scale = (2.0 / (root + 1.0)).sqrt();
                [residual * scale, 1.0 / (root * scale)]
            }
        }
    }

    /// The weight of a residual.
    pub(crate) fn weight(self, residual: f64) -> f64 {
        match self {
            Self::Squares => 1.0,
            Self::Huber => 1.0 / (1.0 + (residual / Self::KNEE).powi(2)).sqrt(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_loss_has_its_derivative_and_its_limits() {
        for residual in [-30.0, -2.0, -0.1, 1e-9, 0.7, 5.0] {
            let [_, slope] = Loss::Huber.seen(residual);
            let [above, below] = [1e-6, -1e-6].map(|step| Loss::Huber.seen(residual + step)[0]);
            assert!((slope - (above - below) / 2e-6).abs() < 1e-8, "{residual}");
            // (root - 1) 2 knee^2 is the loss.
            let part: f64 = residual / Loss::KNEE;
            let loss = 2.0 * Loss::KNEE.powi(2) * ((1.0 + part * part).sqrt() - 1.0);
            assert!((Loss::Huber.seen(residual)[0].powi(2) - loss).abs() < 1e-9 * (1.0 + loss));
        }
    }
}
