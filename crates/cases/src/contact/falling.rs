//! Friction that depends on the slip velocity: FRCLAW = 2, 3 and 4.

use super::fault::Fault;
use super::lines::Lines;
use carom_laws::slip_speed::SlipSpeedFriction;
use carom_rolling::RollingFriction;
use carom_special::RangeError;
use std::f64::consts::LN_2;

/// The least velocity at which CONTACT halves a term.
const LEAST: f64 = 1e-4;

/// How the terms of a law fall with the velocity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Linear,
    Rational,
    Exponential,
}

/// A limit at high velocities, and two terms beyond it with the velocity at which each is halved, mm/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Falling {
    kind: Kind,
    limit: f64,
    terms: [[f64; 2]; 2],
    /// MEMDST, the distance after which slip is forgotten, and its line.
    memory: (f64, usize),
}

impl Falling {
    /// Reads the numbers of a law, FRCLAW.
    pub(super) fn read(lines: &mut Lines<'_>, law: u8) -> Result<Self, Fault> {
        let (kind, names) = match law {
            2 => (Kind::Linear, ["FKIN", "FLIN1", "SABSH1", "FLIN2", "SABSH2"]),
            3 => (Kind::Rational, ["FKIN", "FRAT1", "SABSH1", "FRAT2", "SABSH2"]),
            _ => (Kind::Exponential, ["FKIN", "FEXP1", "SABSH1", "FEXP2", "SABSH2"]),
        };
        let [limit, first, at, second, other] = lines.numbers(names)?;
        let [distance, speed] = lines.numbers(["MEMDST", "MEM_S0"])?;
        for given in [&limit, &at, &other, &distance, &speed] {
            given.checked(|value| value >= 0.0, ">= 0")?;
        }
        let [one, two] = [first, second].map(|given| given.value);
        let least = limit.value + one.min(0.0) + two.min(0.0);
        if least < 0.0 || limit.value + one + two < 1e-4 {
            return Err(limit.must("such that friction is positive at all velocities"));
        }
        let terms = [[one, at.value.max(LEAST)], [two, other.value.max(LEAST)]];
        Ok(Self { kind, limit: limit.value, terms, memory: (distance.value, distance.line) })
    }

    /// The coefficient at a slip velocity; FSTAT at 0.
    pub(super) fn at(&self, velocity: f64) -> f64 {
        let [[one, first], [two, second]] = self.terms;
        let (v, w) = (velocity / first, velocity / second);
        let [one, two] = match self.kind {
            Kind::Linear => [one * (1.0 - 0.5 * v).max(0.0), two * (1.0 - 0.5 * w).max(0.0)],
            Kind::Rational => [one / (1.0 + v), two / (1.0 + w * w)],
            Kind::Exponential => [one * libm::exp(-LN_2 * v), two * libm::exp(-LN_2 * w)],
        };
        self.limit + one + two
    }

    /// Checks that it is a law of carom's solver, FKIN + FEXP1 2^(-v/SABSH1) without memory.
    pub(super) fn check_solver(&self, line: usize) -> Result<(), Fault> {
        if self.kind != Kind::Exponential || self.terms[1][0] != 0.0 {
            let value = "a law of two terms, or not exponential,";
            return Err(Fault::new(line, "control digit L (FRCLAW)", value, "4 with FEXP2 = 0"));
        }
        match self.memory {
            (0.0, _) => Ok(()),
            (distance, line) => {
                let allowed = "0: carom's friction has no memory";
                Err(Fault::new(line, "MEMDST", distance, allowed))
            }
        }
    }

    /// The law a + b exp(-c v) of the solver, v in mm/s.
    pub(super) fn law(&self) -> Result<SlipSpeedFriction, RangeError> {
        let [[part, half], _] = self.terms;
        SlipSpeedFriction::new(self.limit, part, LN_2 / half)
    }

    /// The same of a contact that rolls at a velocity, mm/s.
    pub(super) fn rolling(&self, velocity: f64) -> Result<RollingFriction, RangeError> {
        RollingFriction::new(self.law()?, velocity)
    }
}
