//! Steps of the memories, in their normalised units: the limit of the force is the power 3/2 of the approach.

use carom_drawn::{Draw as _, Splitmix};
use carom_laws::coulomb::{CoulombMemory, FixedCurve, Tolerance, packed_numbers};
use carom_laws::memory::{Fixed, Lateral, ScalarMemory};

use crate::Done;
use crate::draw::of_case;
use crate::worst::Worst;

/// Capacity of the memories in two directions, that of particle codes.
const VERTICES: usize = 12;
/// A memory begins anew after so many steps, from the next seed.
const CASE: u64 = 10_000_000;
/// A state is stored and read back once in so many steps.
const STORED: u64 = 1 << 12;
/// Work is balanced once in so many steps, by this number of parts.
const BALANCED: u64 = 1 << 14;
const PARTS: usize = 1000;
/// By how much a force may exceed its limit, relative.
const ROUNDING: f64 = 1e-12;
/// Allowed error of the balance of work, of its largest term: that of the sum over the parts.
const IMBALANCE: f64 = 1e-3;
/// Room for a stored state.
const ROOM: usize = packed_numbers(99);

/// Approach and shift.
type Place = (f64, [f64; 2]);

/// What all memories can do.
trait March: Clone {
    /// The heat is asked for once in so many steps: in two directions it costs far more than a step.
    const HEATED: u64;
    fn go(&mut self, to: Place) -> Result<[f64; 2], String>;
    fn force(&self) -> [f64; 2];
    fn heat(&self, to: Place) -> f64;
    fn stored(&self) -> f64;
    /// The work of a step less the increase of the stored energy: the heat, less what a step adds by joining pieces. The
    /// heat alone misses what merged segments lose or gain later.
    fn loss(&self, to: Place) -> f64;
    fn merges(&self) -> u32;
    fn pack(&self, numbers: &mut [f64]) -> Result<(), String>;
    fn unpack(&mut self, numbers: &[f64]) -> Result<(), String>;
}

macro_rules! march {
    ($memory:ty, $v:ty, $heated:expr, $loss:expr) => {
        impl March for $memory {
            const HEATED: u64 = $heated;

            fn go(&mut self, (zeta, x): Place) -> Result<[f64; 2], String> {
                let force = self.advance(zeta, <$v>::from_components(x));
                force.map(Lateral::components).map_err(|error| error.to_string())
            }

            fn force(&self) -> [f64; 2] {
                self.force().components()
            }

            fn heat(&self, (zeta, x): Place) -> f64 {
                self.dissipation(zeta, <$v>::from_components(x)).components().iter().sum()
            }

            fn stored(&self) -> f64 {
                self.stored_energy().components().iter().sum()
            }

            fn loss(&self, to: Place) -> f64 {
                $loss(self, to)
            }

            fn merges(&self) -> u32 {
                self.merges()
            }

            fn pack(&self, numbers: &mut [f64]) -> Result<(), String> {
                self.pack(numbers).map_err(|error| error.to_string())
            }

            fn unpack(&mut self, numbers: &[f64]) -> Result<(), String> {
                self.unpack(numbers).map_err(|error| error.to_string())
            }
        }
    };
}

type Plane = carom_laws::memory::Memory<[f64; 2], Fixed<[f64; 2], VERTICES>>;
type Coulomb = CoulombMemory<[f64; 2], FixedCurve<[f64; 2], VERTICES>>;

march!(ScalarMemory, f64, 1, |memory: &Self, (zeta, [x, _]): Place| memory.loss(zeta, x, 1.0));
march!(Plane, [f64; 2], 64, |memory: &Self, (zeta, x)| memory.loss(zeta, x, [1.0; 2]));
march!(Coulomb, [f64; 2], 1024, |memory: &Self, to: Place| {
    memory.heat(to) - memory.joined_energy(to.0, to.1)
});

pub(crate) fn line(count: u64, seed: u64) -> Done {
    march(ScalarMemory::new, count, seed, true)
}

pub(crate) fn fixed_direction(count: u64, seed: u64) -> Done {
    march(Plane::new, count, seed, false)
}

pub(crate) fn coulomb(count: u64, seed: u64) -> Done {
    march(|| Coulomb::new(Tolerance::PARTICLES), count, seed, false)
}

fn march<M: March>(fresh: impl Fn() -> M, count: u64, seed: u64, in_line: bool) -> Done {
    let mut worst = Worst::default();
    for (k, from) in (0..count).step_by(CASE as usize).enumerate() {
        let seed = seed + k as u64;
        let mut walk = Walk { draw: of_case(seed), in_line, kept: (1.0, [0.0; 2]) };
        let case = Case { memory: fresh(), at: (0.0, [0.0; 2]), heat: 0.0 };
        case.run(&fresh, &mut walk, CASE.min(count - from), &mut worst)
            .map_err(|(step, error)| format!("--seed {seed} --count {}: {error}", step + 1))?;
    }
    Ok(worst)
}

/// A memory on its way.
struct Case<M> {
    memory: M,
    at: Place,
    /// The sum of what was asked for.
    heat: f64,
}

impl<M: March> Case<M> {
    fn run(
        mut self,
        fresh: &impl Fn() -> M,
        walk: &mut Walk,
        count: u64,
        worst: &mut Worst,
    ) -> Result<(), (u64, String)> {
        let (mut excess, mut least_heat) = (f64::NEG_INFINITY, 0.0_f64);
        for step in 0..count {
            let named = |error: String| (step, error);
            let (to, choice) = (walk.next(self.at), walk.draw.bits());
            if choice.is_multiple_of(BALANCED) {
                self.balance(to, worst).map_err(named)?;
            }
            if choice.is_multiple_of(M::HEATED) {
                let heat = self.memory.heat(to);
                least_heat = least_heat.min(heat);
                let sum = self.heat + heat;
                if !(sum >= self.heat && sum.is_finite()) {
                    return Err(named(format!("heat {heat:e} on the way to {to:?}")));
                }
                self.heat = sum;
            }
            let [x, y] = self.memory.go(to).map_err(named)?;
            self.at = to;
            let (zeta, force) = (to.0.max(0.0), (x * x + y * y).sqrt());
            let limit = zeta * zeta.sqrt();
            if limit > 0.0 {
                excess = excess.max(force / limit - 1.0);
            }
            // Not a number is not within the limit.
            let holds = force <= limit * (1.0 + ROUNDING);
            if !holds {
                return Err(named(format!("force {force:e} above {limit:e} at {to:?}")));
            }
            if (choice >> 32).is_multiple_of(STORED) {
                self.store(fresh, worst).map_err(named)?;
            }
        }
        worst.note("force_over_limit_less_1", excess);
        worst.note("negative_heat", -least_heat);
        worst.note("merges", f64::from(self.memory.merges()));
        Ok(())
    }

    /// Stores the state, reads it back and stores it again: the numbers are the same, to the bit.
    fn store(&self, fresh: &impl Fn() -> M, worst: &mut Worst) -> Result<(), String> {
        let (mut numbers, mut again) = ([0.0; ROOM], [0.0; ROOM]);
        self.memory.pack(&mut numbers)?;
        let mut restored = fresh();
        restored.unpack(&numbers)?;
        restored.pack(&mut again)?;
        if numbers.map(f64::to_bits) != again.map(f64::to_bits) {
            return Err("a state does not come back to the bit".to_owned());
        }
        let ([x, y], [u, v]) = (self.memory.force(), restored.force());
        let zeta = self.at.0.max(0.0);
        let off = (x - u).hypot(y - v) / (zeta * zeta.sqrt()).max(f64::MIN_POSITIVE);
        worst.note("vertices", numbers[0].rem_euclid(100.0));
        worst.check("restored_force_off_limit", off, 1e-9)
    }

    /// Work of the force on a straight step against the energies.
    fn balance(&self, to: Place, worst: &mut Worst) -> Result<(), String> {
        let mut after = self.memory.clone();
        after.go(to)?;
        if after.merges() != self.memory.merges() {
            return Ok(()); // the state changes beside the step
        }
        let (work, loss) = (self.work(to)?, self.memory.loss(to));
        let [before, now] = [self.memory.stored(), after.stored()];
        let error = work - (now - before + loss);
        let largest = [work, loss, before, now].map(f64::abs).into_iter().fold(1e-15, f64::max);
        worst.check("imbalance_of_work", error.abs() / largest, IMBALANCE)
    }

    /// The force on the way in contact, in the middle of each part, times the way.
    fn work(&self, to: Place) -> Result<f64, String> {
        let (from, way) = (self.at.0, [0, 1].map(|i| to.1[i] - self.at.1[i]));
        let touch = from / (from - to.0);
        let start = if from < 0.0 { touch } else { 0.0 };
        let end = if to.0 < 0.0 { touch } else { 1.0 };
        if from <= 0.0 && to.0 <= 0.0 {
            return Ok(0.0);
        }
        let mut sum = 0.0;
        for i in 0..PARTS {
            let t = start + (end - start) * (i as f64 + 0.5) / PARTS as f64;
            let mix = |a: f64, b: f64| a + t * (b - a);
            let place = (mix(self.at.0, to.0), [0, 1].map(|i| mix(self.at.1[i], to.1[i])));
            let force = self.memory.clone().go(place)?;
            sum += force[0] * way[0] + force[1] * way[1];
        }
        Ok(sum * (end - start) / PARTS as f64)
    }
}

/// A random walk of approach and shift, of steps over six decades; it returns to places where it was, and parts.
struct Walk {
    draw: Splitmix,
    in_line: bool,
    kept: Place,
}

impl Walk {
    fn next(&mut self, (zeta, x): Place) -> Place {
        let bits = self.draw.bits();
        let size = 0.5 / (1_u64 << (bits & 0xf)) as f64 / (1.0 + (bits >> 4 & 3) as f64);
        let to = match bits >> 8 & 0xff {
            0 => (-0.1, x),
            1..=3 => self.kept,
            4..=40 => (zeta, x.map(|x| self.moved(x, size))),
            41..=60 => (self.deeper(zeta, size), x),
            _ => (self.deeper(zeta, size), x.map(|x| self.moved(x, size))),
        };
        if bits >> 16 & 0x3f == 0 && to.0 > 0.0 {
            self.kept = to;
        }
        let y = if self.in_line { 0.0 } else { to.1[1] };
        (to.0, [to.1[0], y])
    }

    /// Within -0.05 and 1.5.
    fn deeper(&mut self, zeta: f64, size: f64) -> f64 {
        let to = zeta + size * self.draw.signed();
        if to > 1.5 { 1.5 - (to - 1.5) } else { to.max(-0.05) }
    }

    /// Within -2 and 2.
    fn moved(&mut self, x: f64, size: f64) -> f64 {
        let to = x + size * self.draw.signed();
        if to.abs() > 2.0 { 2.0_f64.copysign(to) - (to - 2.0_f64.copysign(to)) } else { to }
    }
}
