//! The motion in partial slip: a ring slips, the stick area inside shrinks along the memory.
//!
//! Unknowns are the tangential velocity u, the width of the slip ring r = zeta - z* and the
//! shift e, all in units of the initial tangential velocity `scale` so that tiny velocities
//! lose nothing. The clock is whichever quantity is smooth and lands on the event wanted.

use super::memory::{Old, Stretch};

/// Below this |w| the normal velocity is the coordinate; above, the contact radius sqrt(zeta).
const MIDDLE: f64 = 0.7;

/// What stands for the normal motion: regular throughout its range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Chart {
    /// The normal velocity w, around maximal compression.
    Velocity,
    /// The contact radius sqrt(zeta) while compressing.
    RadiusIn,
    /// The contact radius while rebounding.
    RadiusOut,
}

impl Chart {
    pub(super) fn at(w: f64) -> Self {
        if w > MIDDLE {
            Self::RadiusIn
        } else if w < -MIDDLE {
            Self::RadiusOut
        } else {
            Self::Velocity
        }
    }

    /// The chart to go on in from a normal state: never one whose end is reached.
    pub(super) fn onward(w: f64, zeta: f64) -> Self {
        let chart = Self::at(w);
        let (coordinate, end) = (chart.coordinate(w, zeta), chart.end());
        match chart {
            Self::RadiusIn if coordinate >= end => Self::Velocity,
            Self::Velocity if coordinate <= end => Self::RadiusOut,
            _ => chart,
        }
    }

    /// Coordinate of a normal state.
    pub(super) fn coordinate(self, w: f64, zeta: f64) -> f64 {
        match self {
            Self::Velocity => w,
            Self::RadiusIn | Self::RadiusOut => zeta.sqrt(),
        }
    }

    /// Velocity and contact radius at a coordinate.
    #[inline]
    fn normal(self, coordinate: f64) -> (f64, f64) {
        match self {
            Self::Velocity => (coordinate, crate::normal::radius(coordinate)),
            Self::RadiusIn => (speed(coordinate), coordinate),
            Self::RadiusOut => (-speed(coordinate), coordinate),
        }
    }

    /// Where the chart hands over to the next.
    pub(super) fn end(self) -> f64 {
        match self {
            Self::Velocity => -MIDDLE,
            Self::RadiusIn => crate::normal::compression(MIDDLE).sqrt(),
            Self::RadiusOut => 0.0,
        }
    }

    #[inline]
    fn rate(self, w: f64, radius: f64) -> f64 {
        match self {
            Self::Velocity => -1.25 * (radius * radius * radius),
            Self::RadiusIn | Self::RadiusOut => 0.5 * w / radius,
        }
    }
}

fn speed(radius: f64) -> f64 {
    let squared = radius * radius;
    (1.0 - squared * squared * radius).max(0.0).sqrt()
}

/// The independent variable of one integration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Clock {
    /// The coordinate of the chart.
    Coordinate,
    /// The stick radius sqrt(z*): lands on the end of a stretch of memory.
    StickRadius,
    /// The slip velocity u - s w: lands on its reversal.
    SlipVelocity,
    /// The ring width r: lands on its closing.
    RingWidth,
}

/// Unknowns in the order coordinate, velocity u, weighted ring width, shift e.
pub(super) type Unknowns = [f64; 4];

/// What the ring width is multiplied by as an unknown.
///
/// Right after the onset a small error of the stick depth decays like 1/x with the distance x
/// from the onset: a stiffness that forces tiny steps. The product x r has none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Weight {
    /// Nothing: the unknown is r.
    One,
    /// The distance of w from the onset of slip at this w.
    FromOnset(f64),
}

impl Weight {
    pub(super) fn at(self, w: f64) -> f64 {
        match self {
            Self::One => 1.0,
            Self::FromOnset(onset) => onset - w,
        }
    }

    // d weight/dt
    fn rate(self, zeta_three_halves: f64) -> f64 {
        match self {
            Self::One => 0.0,
            Self::FromOnset(_) => 1.25 * zeta_three_halves,
        }
    }
}

/// Partial slip with traction of sign `sign` on body 1, over one stretch of memory.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slip<'a> {
    pub(super) chi: f64,
    pub(super) scale: f64,
    pub(super) sign: f64,
    pub(super) stretch: &'a Stretch,
    pub(super) chart: Chart,
    pub(super) weight: Weight,
}

/// Everything at one instant of a slip phase.
#[derive(Debug, Clone, Copy)]
pub(super) struct Instant {
    pub(super) w: f64,
    pub(super) zeta: f64,
    /// Contact radius.
    pub(super) radius: f64,
    pub(super) stick: f64,
    /// Width of the slip ring in the unit of u.
    pub(super) ring: f64,
    old: Old,
    zeta_three_halves: f64,
    /// Traction Phi in the unit of u.
    pub(super) traction: f64,
    /// sign (u - s w) in units of zeta_dot_A: positive while the ring slips.
    pub(super) slip_velocity: f64,
}

impl Slip<'_> {
    // The instant at given unknowns.
    #[inline]
    fn resolve(&self, y: &Unknowns) -> Instant {
        let (w, radius) = self.chart.normal(y[0]);
        let ring = match self.weight {
            Weight::One => y[2],
            Weight::FromOnset(onset) => y[2] / (onset - w),
        };
        let stick = (radius * radius - self.scale * ring).max(0.0);
        self.describe(y[1], w, radius, ring, stick, stick.sqrt())
    }

    // The instant with the stick radius as clock: near separation the compression follows from
    // z* and r, so that no resolution is lost. Its weight is one.
    #[inline]
    fn resolve_by_stick(&self, y: &Unknowns, stick_radius: f64) -> Instant {
        let stick = stick_radius * stick_radius;
        let (w, radius) = match self.chart {
            Chart::Velocity => self.chart.normal(y[0]),
            Chart::RadiusIn | Chart::RadiusOut => {
                self.chart.normal((stick + self.scale * y[2]).max(0.0).sqrt())
            }
        };
        self.describe(y[1], w, radius, y[2], stick, stick_radius)
    }

    #[inline]
    fn describe(
        &self,
        velocity: f64,
        w: f64,
        radius: f64,
        ring: f64,
        stick: f64,
        stick_radius: f64,
    ) -> Instant {
        let old = self.stretch.at(stick, stick_radius, self.chi);
        // zeta^1.5 - z*^1.5 = scale r Q without cancellation
        let zeta = radius * radius;
        let zeta_three_halves = zeta * radius;
        let halves = zeta_three_halves + stick * stick_radius;
        let squares = zeta * zeta + zeta * stick + stick * stick;
        let q = if halves > 0.0 { squares / halves } else { 0.0 };
        let traction = old.traction + self.sign * ring * q;
        let slip_velocity = self.sign * self.scale * velocity - w;
        Instant { w, zeta, radius, stick, ring, old, zeta_three_halves, traction, slip_velocity }
    }

    /// The instant described by unknowns of which all are current.
    pub(super) fn instant(&self, y: &Unknowns) -> Instant {
        self.resolve(y)
    }

    /// The instant at a clock reading in the midst of an integration.
    pub(super) fn at_clock(&self, clock: Clock, x: f64, y: &Unknowns) -> Instant {
        let mut y = *y;
        match clock {
            Clock::StickRadius => return self.resolve_by_stick(&y, x),
            Clock::Coordinate => y[0] = x,
            Clock::RingWidth => y[2] = x,
            Clock::SlipVelocity => {}
        }
        self.resolve(&y)
    }

    /// d y / d clock at the clock reading `x`.
    pub(super) fn slope(&self, clock: Clock, x: f64, y: &Unknowns) -> Unknowns {
        if clock == Clock::StickRadius {
            return self.slope_by_stick_radius(x, y);
        }
        let now = self.at_clock(clock, x, y);
        let widening = self.widening(y[1], &now) / self.lag(&now);
        let rates = [
            self.chart.rate(now.w, now.radius),
            -1.25 * self.chi * now.traction,
            self.weight.at(now.w) * widening + self.weight.rate(now.zeta_three_halves) * now.ring,
            y[1],
        ];
        let clock_rate = match clock {
            Clock::Coordinate => rates[0],
            Clock::RingWidth => rates[2],
            _ => self.slip_rate(&now),
        };
        let per_clock = 1.0 / clock_rate;
        rates.map(|rate| rate * per_clock)
    }

    // dz*/dt = w* (u - s w)/(u* - s w*): with sqrt(z*) as clock every rate carries 2 sqrt(z*) and
    // its value zero is an ordinary point.
    fn slope_by_stick_radius(&self, radius: f64, y: &Unknowns) -> Unknowns {
        let now = self.resolve_by_stick(y, radius);
        let step = 2.0 * radius / (now.old.speed * self.sign * now.slip_velocity);
        let time = step * self.lag(&now);
        let coordinate = match self.chart {
            Chart::Velocity => self.chart.rate(now.w, now.radius) * time,
            Chart::RadiusIn | Chart::RadiusOut => 0.0, // follows from z* and r
        };
        [
            coordinate,
            -1.25 * self.chi * now.traction * time,
            self.widening(y[1], &now) * step,
            y[1] * time,
        ]
    }

    /// d (s u - w)/dt = -(5/4) (s chi Phi - zeta^1.5)
    pub(super) fn slip_rate(&self, now: &Instant) -> f64 {
        let force = self.chi * self.scale * now.traction * self.sign;
        -1.25 * (force - now.zeta_three_halves)
    }

    // u* - s w* in units of zeta_dot_A
    fn lag(&self, now: &Instant) -> f64 {
        self.scale * now.old.velocity - self.sign * now.old.speed
    }

    // dr/dt = (w u* - u w*)/(u* - s w*)
    fn widening(&self, velocity: f64, now: &Instant) -> f64 {
        now.w * now.old.velocity - velocity * now.old.speed
    }

    /// The unknowns when the stick radius is `radius`, with the coordinate brought up to date.
    pub(super) fn settle(&self, radius: f64, y: &Unknowns) -> (Unknowns, Instant) {
        let now = self.resolve_by_stick(y, radius);
        ([self.chart.coordinate(now.w, now.zeta), y[1], y[2], y[3]], now)
    }
}
