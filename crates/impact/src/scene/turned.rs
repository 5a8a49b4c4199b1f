//! The steps of a motion on a wall whose accelerations turn.

use carom_special::RangeError;
use carom_special::ode::{DenseStep, OdeError, Stepper, Tolerance};
use nalgebra::Vector3;

use super::flight::Flight;
use super::glide::{Gliding, Ground};
use super::path::{Manner, TimedFlight};

/// The longest step of an integration, over the time in which the slip or the velocity would vanish.
const SHARE: f64 = 0.2;
const TOLERANCE: f64 = 1e-13;
/// The end of rolling is found within this part of its last step.
const CROSSING: f64 = 1e-12;

/// A step of a motion whose accelerations turn.
#[derive(Debug)]
pub(super) struct Turned {
    dense: DenseStep<9>,
    end: f64,
}

/// Place, velocity and spin in one line.
fn line(place: Vector3<f64>, now: &Gliding) -> [f64; 9] {
    let mut line = [0.0; 9];
    for (i, vector) in [place, now.velocity, now.spinning].iter().enumerate() {
        line[3 * i..3 * i + 3].copy_from_slice(vector.as_slice());
    }
    line
}

fn part(line: &[f64; 9], i: usize) -> Vector3<f64> {
    Vector3::from_column_slice(&line[3 * i..3 * i + 3])
}

fn gliding(line: &[f64; 9]) -> Gliding {
    Gliding { velocity: part(line, 1), spinning: part(line, 2) }
}

impl Turned {
    /// A step from a place and a motion, of at most this time.
    pub(super) fn new(
        ground: &Ground,
        manner: Manner,
        place: Vector3<f64>,
        now: &Gliding,
        most: f64,
    ) -> Result<Self, OdeError> {
        let moving = match manner {
            Manner::Slides => now.slip(),
            Manner::Rolls => now.velocity,
        };
        let [rate, turning] = ground.rates(manner, now);
        let over = |moving: &Vector3<f64>, rate: &Vector3<f64>| match rate.norm() > 0.0 {
            true => SHARE * moving.norm() / rate.norm(),
            false => most,
        };
        let slides = manner == Manner::Slides;
        let moves = over(&moving, &if slides { rate + turning } else { rate });
        // The direction of the torque that resists changes at once where the spin vanishes.
        let turns = slides && ground.rolling > 0.0 && now.spinning.norm() > 0.0;
        let lasts = if turns { moves.min(over(&now.spinning, &turning)) } else { moves };
        let end = most.min(lasts);
        let slope = |_: f64, y: &[f64; 9]| {
            let now = gliding(y);
            let [rate, turning] = ground.rates(manner, &now);
            line(now.velocity, &Gliding { velocity: rate, spinning: turning })
        };
        let tolerance = Tolerance { absolute: TOLERANCE * ground.unit, relative: TOLERANCE };
        let mut stepper = Stepper::new(0.0, line(place, now), end, tolerance, slope)?;
        stepper.step(end)?;
        let end = stepper.x();
        Ok(Self { dense: stepper.dense(), end })
    }

    /// Its time.
    pub(super) const fn end(&self) -> f64 {
        self.end
    }

    /// A step of rolling, ended where it needs more than friction.
    pub(super) fn gripping(mut self, ground: &Ground) -> Result<Self, RangeError> {
        let bears = |time| ground.bears(&part(&self.dense.at(time), 1));
        let mut holds = if bears(self.end)? { self.end } else { 0.0 };
        while self.end - holds > CROSSING * self.end {
            let middle = 0.5 * (holds + self.end);
            match bears(middle)? {
                true => holds = middle,
                false => self.end = middle,
            }
        }
        Ok(self)
    }

    /// The same, ended at this time.
    pub(super) const fn cut(&mut self, end: f64) {
        self.end = end;
    }

    /// The centre after a time.
    pub(super) fn position(&self, time: f64) -> Vector3<f64> {
        part(&self.dense.at(time), 0)
    }

    /// The motion at the end.
    pub(super) fn gliding(&self) -> Gliding {
        gliding(&self.dense.at(self.end))
    }

    /// The flight with this start and end, of third degree in time.
    pub(super) fn flight(&self, start: f64, spin: Vector3<f64>, ground: &Ground) -> TimedFlight {
        let (from, to, time) = (self.dense.at(0.0), self.dense.at(self.end), self.end);
        let (place, velocity) = (part(&from, 0), part(&from, 1));
        let way = (part(&to, 0) - place - time * velocity) / (time * time);
        let change = (part(&to, 1) - velocity) / time;
        // way = a/2 + b t/6 and change = a + b t/2.
        let flight = Flight { position: place, velocity, gravity: 6.0 * way - 2.0 * change };
        TimedFlight {
            bend: 6.0 * (change - 2.0 * way) / time,
            turning: ground.spin(&(part(&to, 2) - part(&from, 2))) / time,
            ..TimedFlight::free(start, time, flight, spin)
        }
    }
}
