//! The motion in partial slip: an annulus slips, and the stick area inside shrinks along the
//! memory.
//!
//! Two positions describe it: the present one `tau`, and `tau*`, at which the whole contact had the
//! size of the present stick area. With the slip velocity q = u - s w (in units of zeta'_A) and the
//! derivative of the stored shift by depth, H = d(psi e* - s z*)/d tau*, the stick area shrinks by
//! d tau*/dt = q/H. The equation of motion then has a first integral in the memory, up to a
//! remainder E that grows with the annulus:
//!
//! `q^2 = M(tau*) + E`, `dE/d tau* = -(5/2) s (chi - 1) (zeta^(3/2) - z*^(3/2)) H`,
//!
//! M = L^2, L = u* - s w*, for an adhesive memory, which the motion retraces while E = 0. All
//! differences of the two positions are formed without cancellation from their gap tau + tau*, so
//! that small velocities keep their digits.

use super::memory::{Frozen, Shape, Stretch};
use super::position::{Difference, Position};

/// The independent variable of one integration, and its two unknowns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Clock {
    /// tau*; unknowns gap and E.
    Memory,
    /// tau*, well into the release; unknowns zeta - z*, which is smooth up to separation, and E.
    Release,
    /// The gap, to reach the closing of the annulus exactly; unknowns tau* and E.
    Gap,
    /// tau, if slip is slow; unknowns the mark of the memory and the slip velocity.
    Motion,
    /// The slip velocity, to reach its reversal exactly; unknowns tau and mark.
    SlipVelocity,
}

/// Two unknowns: the gap, E and the slip velocity in units of `unit`.
pub(super) type Unknowns = [f64; 2];

/// Partial slip with traction of sign `sign` on body 1, over one stretch of memory.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slip<'a> {
    pub(super) chi: f64,
    pub(super) psi: f64,
    pub(super) sign: f64,
    pub(super) stretch: &'a Stretch,
    /// The unit of the small unknowns: psi, at most 1.
    pub(super) unit: f64,
    /// q^2 at the start of the integration; `square * unit` is the unit in which E is integrated.
    pub(super) square: f64,
    /// -(5/2) s (chi - 1), divided by `square`.
    drive: f64,
    /// Position at which slip entered a frozen stretch, and q^2 there.
    pub(super) entry: (Position, f64),
}

/// The two positions of a slip phase and its slip velocity.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pair {
    pub(super) now: Position,
    pub(super) stick: Position,
    /// tau + tau* over the unit.
    pub(super) gap: f64,
    /// q = u - s w in units of zeta'_A; its sign is that of the slip.
    pub(super) slip_velocity: f64,
    pub(super) velocity: f64,
}

/// The other quantities at that instant.
#[derive(Debug, Clone, Copy)]
pub(super) struct Load {
    /// Width zeta - z* of the slip annulus, in the unit of u.
    pub(super) ring: f64,
    /// Traction Phi in the unit of u.
    pub(super) traction: f64,
    /// d (s q)/dt.
    pub(super) slip_rate: f64,
}

impl<'a> Slip<'a> {
    pub(super) fn new([chi, psi]: [f64; 2], sign: f64, stretch: &'a Stretch) -> Self {
        let (drive, entry) = (-2.5 * sign * (chi - 1.0), (Position::TOUCH, 0.0));
        Self { chi, psi, sign, stretch, unit: psi.min(1.0), square: 1.0, drive, entry }
    }

    /// The same, with its stretch entered here.
    pub(super) fn entered(self, pair: &Pair) -> Self {
        let q = pair.slip_velocity;
        Self { entry: (pair.stick, q * q), ..self }
    }

    /// The same with the slip velocity of `pair` as unit of E: an error of E displaces the motion
    /// by its share in q^2 times the time since the onset, which is about q.
    pub(super) fn measured_by(self, pair: &Pair) -> Self {
        let square = pair.slip_velocity.abs();
        Self { square, drive: -2.5 * self.sign * (self.chi - 1.0) / square, ..self }
    }

    /// The two positions `tau` and `tau*` with the tangential velocity `u`.
    pub(super) fn pair(&self, gap: f64, stick: f64, velocity: f64) -> Pair {
        let now = Position::at(self.unit * gap - stick);
        let slip_velocity = self.psi * velocity - self.sign * now.w;
        Pair { now, stick: Position::at(stick), gap, slip_velocity, velocity }
    }

    /// E in its unit.
    pub(super) fn rest(&self, pair: &Pair) -> f64 {
        match &self.stretch.shape {
            Shape::Adhesion(segment) => {
                let stored = segment.velocity(&pair.stick);
                let lag = self.psi * stored - self.sign * pair.stick.w;
                // q + L = psi (u + u*) - s (w + w*)
                let sum = self.psi * (pair.velocity + stored)
                    - self.sign * self.unit * self.velocity_sum(pair);
                (pair.slip_velocity - lag) * sum / (self.unit * self.square)
            }
            Shape::Slip(frozen) => {
                let q = pair.slip_velocity;
                (q * q - self.stored_square(frozen, &pair.stick)) / (self.unit * self.square)
            }
        }
    }

    // (w + w*)/unit
    fn velocity_sum(&self, pair: &Pair) -> f64 {
        let (now, stick) = (&pair.now, &pair.stick);
        let difference = Difference::new(now, stick);
        let radii = half_radii(now, stick);
        if now.w < -0.5 {
            // (a^5 - a*^5)/(w* - w), exact where both radii vanish
            return radii * pair.gap * difference.fifth / (stick.w - now.w);
        }
        (now.omega - stick.tau * difference.omega * radii) * pair.gap
    }

    // M over a frozen stretch.
    #[inline(always)]
    fn stored_square(&self, frozen: &Frozen, stick: &Position) -> f64 {
        let (first, square) = &self.entry;
        // a* less its value at the entry
        let fall = -0.5
            * (1.0 + stick.radius)
            * (1.0 + first.radius)
            * ((stick.tau - first.tau) * (stick.tau + first.tau));
        let (a, b) = (stick.radius, first.radius);
        let (squares, product) = (a * a + b * b, a * b);
        let fifth = squares * squares - product * product + product * squares;
        let linear = 5.0 * self.sign * self.chi * frozen.offset * (a + b);
        square + fall * (linear - 2.0 * (self.chi + 1.0) * fifth)
    }

    // q^2 = M + E and H at the stick place, with L where the memory is adhesive.
    #[inline(always)]
    fn memory(&self, stick: &Position, rest: f64) -> FirstIntegral {
        let more = 1.0 + stick.radius;
        match &self.stretch.shape {
            Shape::Adhesion(segment) => {
                let lag = self.psi * segment.nearly_velocity(stick) - self.sign * stick.w;
                let slip = self.sign * (lag * lag + self.unit * rest).sqrt();
                let per_lag = -2.0 * stick.radius * more * more / stick.omega;
                FirstIntegral { slip, steep: per_lag * lag, lag, per_lag }
            }
            Shape::Slip(frozen) => {
                let square = self.stored_square(frozen, stick) + self.unit * rest;
                let slip = self.sign * square.sqrt();
                FirstIntegral { slip, steep: self.steep(stick), lag: 0.0, per_lag: 0.0 }
            }
        }
    }

    // H over a frozen stretch, where d(psi e* - s z*)/dz = -2 s.
    #[inline(always)]
    fn steep(&self, stick: &Position) -> f64 {
        let more = 1.0 + stick.radius;
        4.0 * self.sign * stick.radius * stick.tau * more * more
    }

    /// d y/d clock at the clock reading `x`.
    pub(super) fn slope(&self, clock: Clock, x: f64, y: &Unknowns) -> Unknowns {
        match clock {
            Clock::Memory => self.along_memory(x, y[0], y[1]),
            Clock::Release => self.along_release(x, y[0], y[1]),
            Clock::Gap => {
                let [gap, rest] = self.along_memory(y[0], x, y[1]);
                [1.0 / gap, rest / gap]
            }
            Clock::Motion => {
                let [now, stick, slip] = self.in_time(x, y[0], y[1]);
                [stick / now, slip / now]
            }
            Clock::SlipVelocity => {
                let [now, stick, slip] = self.in_time(y[0], y[1], x);
                [now / slip, stick / slip]
            }
        }
    }

    // d gap/d tau* and dE/d tau*, both over the unit.
    #[inline(always)]
    fn along_memory(&self, tau: f64, gap: f64, rest: f64) -> Unknowns {
        let stick = Position::at(tau);
        let now = Position::at(self.unit * gap - tau);
        let rest = rest * self.square;
        let FirstIntegral { slip, steep, lag, .. } = self.memory(&stick, rest);
        let difference = Difference::new(&now, &stick);
        let radii = half_radii(&now, &stick) * gap; // (a - a*)/unit
        let rest_rate = -2.5 * self.sign * (self.chi - 1.0) / self.square
            * radii
            * difference.quadratic
            * steep;
        if matches!(self.stretch.shape, Shape::Slip(_)) {
            return [(1.0 + now.rate() * steep / slip) / self.unit, rest_rate];
        }
        // d tau/d tau* = B L/q with B = 1 where the places mirror each other.
        let (a, b) = (now.radius, stick.radius);
        let (more_a, more_b) = ((1.0 + a) * (1.0 + a), (1.0 + b) * (1.0 + b));
        let down = difference.omega * b * more_b
            - stick.omega * (1.0 + 2.0 * difference.linear + difference.quadratic);
        let mirror = radii * down / (stick.omega * a * more_a); // (B - 1)/unit
        [(mirror * lag + rest / (slip - lag)) / slip, rest_rate]
    }

    // d(zeta - z*)/d tau* and dE/d tau*, both over the unit, for w < 0.
    #[inline(always)]
    fn along_release(&self, tau: f64, ring: f64, rest: f64) -> Unknowns {
        let stick = Position::at(tau);
        let rest = rest * self.square;
        let FirstIntegral { slip, steep, lag, per_lag } = self.memory(&stick, rest);
        let (zeta, depth) = (stick.zeta() + self.unit * ring, stick.zeta());
        let radius = zeta.max(0.0).sqrt();
        let (squares, product) = (zeta + depth, radius * stick.radius);
        let w = -((1.0 - zeta * zeta * radius).max(0.0)).sqrt();
        let inverse = 1.0 / ((radius + stick.radius) * (stick.w - w));
        let cubes = (squares + product) * ring * inverse; // over w* - w
        let rest_rate = self.drive * (cubes * (stick.w - w)) * steep;
        if matches!(self.stretch.shape, Shape::Slip(_)) {
            let widening = 0.5 * (2.0 * w + self.sign * slip) / self.unit;
            return [widening * steep / slip, rest_rate];
        }
        // w + w* = (a^5 - a*^5)/(w* - w); dr/dt = (w u* - u w*)/L with u + u* = p + s (w + w*)
        let fifth = squares * squares - product * product + product * squares;
        let sum = fifth * ring * inverse;
        let widening = sum * lag - rest / (slip - lag) * stick.w;
        [per_lag * widening / slip, rest_rate]
    }

    // d tau/dt, d mark/dt and d(q/unit)/dt.
    #[inline(always)]
    fn in_time(&self, now: f64, mark: f64, slip: f64) -> [f64; 3] {
        let (now, stick) = (Position::at(now), Position::at(self.unmark(mark)));
        let more = 1.0 + stick.radius;
        let (mark_rate, pull) = match &self.stretch.shape {
            Shape::Adhesion(segment) => {
                let old = segment.nearly_at(&stick);
                let lag = self.psi * old.velocity - self.sign * stick.w;
                let rate = -0.5 * stick.omega * slip / (stick.radius * more * more * lag);
                (rate, self.psi * old.flux)
            }
            Shape::Slip(frozen) => {
                let rate = 0.5 * self.sign * slip / (stick.radius * more * more);
                (rate, self.chi * (frozen.offset + frozen.sign * stick.cube()))
            }
        };
        let slip_rate = self.sign * self.slip_rate(&now, &stick, pull);
        [now.rate(), self.unit * mark_rate, slip_rate / self.unit]
    }

    /// Replaces tau* where it is not the independent variable: its square over a frozen stretch,
    /// where the depth has no maximum about which to mirror.
    pub(super) fn mark(&self, stick: &Position) -> f64 {
        match &self.stretch.shape {
            Shape::Adhesion(_) => stick.tau,
            Shape::Slip(_) => stick.tau * stick.tau,
        }
    }

    fn unmark(&self, mark: f64) -> f64 {
        match &self.stretch.shape {
            Shape::Adhesion(_) => mark,
            Shape::Slip(_) => mark.max(0.0).sqrt(),
        }
    }

    // d (s q)/dt = -(5/4) (s chi psi Phi - zeta^(3/2)); `pull` is chi psi times the stored traction.
    #[inline(always)]
    fn slip_rate(&self, now: &Position, stick: &Position, pull: f64) -> f64 {
        let rise = now.cube() - stick.cube();
        -1.25 * (self.sign * pull + self.chi * rise - now.cube())
    }

    /// The two positions at a value of the independent variable.
    pub(super) fn at(&self, clock: Clock, x: f64, y: &Unknowns) -> Pair {
        let (stick, gap, rest) = match clock {
            Clock::Memory => (x, y[0], y[1]),
            Clock::Gap => (y[0], x, y[1]),
            Clock::Release => {
                let stick = Position::at(x);
                let radius = (stick.zeta() + self.unit * y[0]).max(0.0).sqrt();
                // a - a* = (1 + a)(1 + a*)(tau* - tau)(tau + tau*)/2
                let tau = release_tau(radius);
                let product = (1.0 + radius) * (1.0 + stick.radius) * (stick.tau - tau);
                (x, 2.0 * y[0] / ((radius + stick.radius) * product), y[1])
            }
            Clock::Motion => return self.slow(x, self.unmark(y[0]), self.unit * y[1]),
            Clock::SlipVelocity => return self.slow(y[0], self.unmark(y[1]), self.unit * x),
        };
        let stick = Position::at(stick);
        let now = Position::at(self.unit * gap - stick.tau);
        let rest = rest * self.square;
        let FirstIntegral { slip, lag, .. } = self.memory(&stick, rest);
        let pair = Pair { now, stick, gap, slip_velocity: slip, velocity: 0.0 };
        let velocity = match &self.stretch.shape {
            Shape::Adhesion(segment) => {
                let sum = rest / (slip - lag) + self.sign * self.velocity_sum(&pair);
                sum * (self.unit / self.psi) - segment.velocity(&stick)
            }
            Shape::Slip(_) => (slip + self.sign * now.w) / self.psi,
        };
        Pair { velocity, ..pair }
    }

    fn slow(&self, now: f64, stick: f64, slip_velocity: f64) -> Pair {
        let gap = (now + stick) / self.unit;
        let (now, stick) = (Position::at(now), Position::at(stick));
        let velocity = (slip_velocity + self.sign * now.w) / self.psi;
        Pair { now, stick, gap, slip_velocity, velocity }
    }

    /// Width of the annulus, traction and slip rate at this instant.
    pub(super) fn load(&self, pair: &Pair) -> Load {
        let (now, stick) = (&pair.now, &pair.stick);
        let difference = Difference::new(now, stick);
        let radii = half_radii(now, stick) * pair.gap * (self.unit / self.psi);
        let pull = self.stretch.pull(self.chi, self.psi, stick);
        Load {
            ring: radii * difference.linear,
            traction: pull / (self.chi * self.psi) + self.sign * radii * difference.quadratic,
            slip_rate: self.slip_rate(now, stick, pull),
        }
    }

    /// d tau/d tau*: below -1, the shift of the motion changes faster than slip along the memory allows.
    pub(super) fn pace(&self, pair: &Pair) -> f64 {
        let steep = match &self.stretch.shape {
            Shape::Adhesion(segment) => {
                let lag = self.psi * segment.velocity(&pair.stick) - self.sign * pair.stick.w;
                let more = 1.0 + pair.stick.radius;
                -2.0 * pair.stick.radius * more * more * lag / pair.stick.omega
            }
            Shape::Slip(_) => self.steep(&pair.stick),
        };
        pair.now.rate() * steep / pair.slip_velocity
    }

    /// tau and d tau/d tau* from the state of an integration along the memory.
    pub(super) fn progress(
        &self,
        clock: Clock,
        x: f64,
        y: &Unknowns,
        slope: &Unknowns,
    ) -> [f64; 2] {
        if clock != Clock::Release {
            return [self.unit * y[0] - x, self.unit * slope[0] - 1.0];
        }
        let stick = Position::at(x);
        let radius = (stick.zeta() + self.unit * y[0]).max(0.0).sqrt();
        let tau = release_tau(radius);
        // d zeta/d tau = -2 a tau (1 + a)^2 for both
        let rate = |radius: f64, tau: f64| -2.0 * radius * tau * (1.0 + radius) * (1.0 + radius);
        [tau, (rate(stick.radius, x) + self.unit * slope[0]) / rate(radius, tau)]
    }
}

// tau in release for a contact radius.
fn release_tau(radius: f64) -> f64 {
    -((1.0 - radius).max(0.0) / (1.0 + radius)).sqrt()
}

struct FirstIntegral {
    slip: f64,
    steep: f64,
    lag: f64,
    /// H/L
    per_lag: f64,
}

// (a - a*)/(tau + tau*)
#[inline]
fn half_radii(now: &Position, stick: &Position) -> f64 {
    0.5 * (1.0 + now.radius) * (1.0 + stick.radius) * (stick.tau - now.tau)
}
