//! Integrals of 1/r and related functions over an interval, evaluated without cancellation.
//!
//! The closed forms of (4.29) subtract values of one function at both ends of an edge. Here each
//! difference is evaluated analytically. It keeps full relative accuracy for short and for distant
//! intervals.

/// The interval (centre - half, centre + half), half > 0.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Interval {
    pub(crate) centre: f64,
    pub(crate) half: f64,
}

impl Interval {
    pub(crate) fn upper(self) -> f64 {
        self.centre + self.half
    }

    pub(crate) fn lower(self) -> f64 {
        self.centre - self.half
    }

    fn mirrored_right(self) -> Self {
        Self { centre: self.centre.abs(), half: self.half }
    }

    /// upper^2 - lower^2.
    fn square_difference(self) -> f64 {
        4.0 * self.centre * self.half
    }

    /// Integral of dx / sqrt(x^2 + c^2), the difference of asinh(x/c); infinite if c = 0 and the
    /// interval contains 0.
    pub(crate) fn inverse_distance(self, c: f64) -> f64 {
        let right = self.mirrored_right();
        let (a, b) = (right.lower(), right.upper());
        let (ra, rb) = ((a * a + c * c).sqrt(), (b * b + c * c).sqrt());
        if a >= 0.0 {
            libm::log1p(2.0 * right.half * (1.0 + 2.0 * right.centre / (ra + rb)) / (a + ra))
        } else {
            asinh_ratio(-a, ra, c) + asinh_ratio(b, rb, c)
        }
    }

    /// Integral of c^2 dx / (x^2 + c^2)^(3/2), the difference of x/r.
    pub(crate) fn inverse_cube(self, c: f64) -> f64 {
        let right = self.mirrored_right();
        let (a, b) = (right.lower(), right.upper());
        let (ra, rb) = ((a * a + c * c).sqrt(), (b * b + c * c).sqrt());
        if a > 0.0 {
            c * c * right.square_difference() / (ra * rb * (b * ra + a * rb))
        } else if ra > 0.0 {
            b / rb - a / ra
        } else {
            b / rb
        }
    }

    /// Integral of x dx / (x^2 + c^2)^(3/2), minus the difference of 1/r.
    pub(crate) fn first_moment_cube(self, c: f64) -> f64 {
        let (a, b) = (self.lower(), self.upper());
        let (ra, rb) = ((a * a + c * c).sqrt(), (b * b + c * c).sqrt());
        self.square_difference() / ((ra + rb) * ra * rb)
    }

    /// Integral of x dx / (x^2 + c^2), half the difference of ln(x^2 + c^2).
    pub(crate) fn log_distance(self, c: f64) -> f64 {
        let right = self.mirrored_right();
        let a = right.lower();
        let value = 0.5 * libm::log1p(right.square_difference() / (a * a + c * c));
        value.copysign(self.centre)
    }

    /// Integral of c dx / (x^2 + c^2) for c >= 0: the angle subtended by the interval, 0 to pi.
    pub(crate) fn angle(self, c: f64) -> f64 {
        libm::atan2(2.0 * self.half * c, c * c + self.lower() * self.upper())
    }
}

/// asinh(x/c) = ln((x + r)/c) for x >= 0 with r = sqrt(x^2 + c^2).
fn asinh_ratio(x: f64, r: f64, c: f64) -> f64 {
    libm::log1p((x + x * x / (r + c)) / c)
}
