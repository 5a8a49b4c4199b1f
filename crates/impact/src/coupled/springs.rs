//! A lossy impact whose motions couple or whose slip turns, as a row of springs of Kelvin and Voigt, each with friction of
//! its own.
//!
//! Hertz's contact is a row of independent springs (the method of dimensionality reduction): they touch at the depths
//! zeta_max u^2, with u equally spaced from 0 to 1, and have the stiffness c_z zeta_max^(1/2) du along the normal, c_x/c_z and
//! c_y/c_z times that along the surface. Together they carry (2/3) c_z zeta^(3/2). In a material of relaxation time A each
//! carries A times its rate as well, but never pulls; its traction is at most f times its pressure, and it slips along its
//! traction. With static friction f is f_s until all springs slide, then f_k until one of them sticks. For slip along a line
//! this is the exact impact of [`crate::viscoelastic`].

use nalgebra::{Matrix3, Vector3};

use super::{CoupledImpact, Stage};
use crate::normal::DURATION;

/// Springs and steps up to the time of an elastic impact, of the coarse run and of the fine one.
const RUNS: [(usize, usize); 2] = [(100, 600), (150, 1500)];
/// The least error of the velocity, over the coefficient of friction: two runs may agree by chance.
const LEAST: f64 = 1e-4;
/// How much deeper than an elastic impact without friction the row begins, and by what it grows if that does not do.
const DEEPER: f64 = 1.1;
/// How often it grows at most: to a hundred times that depth.
const DEEPEST: i32 = 48;
/// The greatest change of a velocity in a step of the coarse run, over that velocity: beyond 2 steps are not stable.
const STEEPEST: f64 = 1.5;
/// How many times as many steps light bodies and deep rows may take.
const FINEST: f64 = 12.0;
/// An impact lasts at most this many times longer than an elastic one.
const LONGEST: usize = 60;
/// Of an elastic impact without friction, in the units of its greatest approach, its velocity and its mass: c_z, of which
/// (4/15) c_z = 1/2.
const STIFFNESS: f64 = 15.0 / 8.0;

/// An impact by a row of springs, in the units of the elastic impact without friction.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct SpringImpact {
    /// After the impact.
    pub(super) velocity: Vector3<f64>,
    /// The error of the velocity: twice the difference of two runs, and [`LEAST`].
    pub(super) error: f64,
    pub(super) duration: f64,
    pub(super) maximal_approach: f64,
    pub(super) maximal_force: f64,
    pub(super) compressions: u32,
    /// The work of the tractions on the slip.
    pub(super) friction_heat: f64,
    /// The ends of the steps.
    pub(super) instants: Vec<Instant>,
}

/// The end of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Instant {
    pub(super) time: f64,
    pub(super) shift: Vector3<f64>,
    pub(super) velocity: Vector3<f64>,
    /// In the middle of the step.
    pub(super) force: Vector3<f64>,
    pub(super) stage: Stage,
}

impl CoupledImpact {
    /// The impact of a material with this relaxation time, in the units of [`SpringImpact`]; none if it does not end, gets too
    /// deep, or moves so lightly along the surface that its steps are too short.
    pub(super) fn by_springs(&self, relaxation: f64) -> Option<SpringImpact> {
        let [coarse, fine] = RUNS;
        let (depth, coarse) = self.by_deep_springs(relaxation, coarse, 1)?;
        let (_, fine) = self.by_deep_springs(relaxation, fine, depth)?;
        let change = (fine.velocity - coarse.velocity).norm();
        Some(SpringImpact { error: 2.0 * change + LEAST * self.friction.get().min(1.0), ..fine })
    }

    /// The impact by the first row, from this one on, that is deep enough, and which one that is.
    fn by_deep_springs(
        &self,
        relaxation: f64,
        (springs, steps): (usize, usize),
        first: i32,
    ) -> Option<(i32, SpringImpact)> {
        (first..=DEEPEST).find_map(|i| {
            let deepest = DEEPER.powi(i);
            let finer = self.steepness(relaxation, deepest).ceil().max(1.0);
            let row = (finer <= FINEST).then(|| Row::new(self, relaxation, springs, deepest))?;
            Some((i, row.impact(self, steps, finer as usize)?))
        })
    }

    /// The greatest change of a velocity in a step of the coarse run, over that velocity and what is stable.
    fn steepness(&self, relaxation: f64, deepest: f64) -> f64 {
        let (mobility, stiff) = (self.mobility.matrix(), self.stiffness);
        let along = mobility.m11 * stiff.c_x + mobility.m22 * stiff.c_y;
        let dt = DURATION / RUNS[0].1 as f64;
        let lightness = 1.0 + along / (mobility.m33 * stiff.c_z);
        // A body that is damped strongly comes to rest at (2/3) STIFFNESS A zeta^(3/2) = 1: fewer springs touch.
        let touching = match deepest > DEEPER {
            true => deepest.sqrt(),
            false => libm::cbrt(1.5 / (STIFFNESS * relaxation)).min(1.0),
        };
        dt * (dt + relaxation) * STIFFNESS * touching * lightness / STEEPEST
    }
}

struct Row {
    /// Depths at which the springs touch, and their elastic shifts.
    depths: Vec<f64>,
    shifts: Vec<[f64; 2]>,
    stiffness: f64,
    /// c_x/c_z and c_y/c_z.
    ratios: [f64; 2],
    /// Of springs that stick or slip in part, and of a row all of which slides.
    friction: [f64; 2],
    stage: Stage,
    relaxation: f64,
    deepest: f64,
}

impl Row {
    fn new(impact: &CoupledImpact, relaxation: f64, count: usize, deepest: f64) -> Self {
        let depth = |i: usize| {
            let u = (i as f64 + 0.5) / count as f64;
            deepest * u * u
        };
        let of = impact.stiffness;
        let sliding = impact.static_friction.map_or(impact.friction, |both| both.kinetic());
        Self {
            depths: (0..count).map(depth).collect(),
            shifts: vec![[0.0; 2]; count],
            stiffness: STIFFNESS * deepest.sqrt() / count as f64,
            ratios: [of.c_x / of.c_z, of.c_y / of.c_z],
            friction: [impact.friction.get(), sliding.get()],
            stage: Stage::Slip,
            relaxation,
            deepest,
        }
    }

    /// In these steps up to the time of an elastic impact, each in so many parts.
    fn impact(
        mut self,
        impact: &CoupledImpact,
        steps: usize,
        parts: usize,
    ) -> Option<SpringImpact> {
        let matrix = impact.mobility.matrix();
        let mobility: Matrix3<f64> = matrix / matrix.m33;
        let dt = DURATION / (parts * steps) as f64;
        let mut now =
            SpringImpact { velocity: impact.velocity / impact.velocity.z, ..Default::default() };
        let (mut shift, mut parting) = (Vector3::zeros(), true);
        for part in 0..LONGEST * steps * parts {
            let middle = shift.z + 0.5 * dt * now.velocity.z;
            if middle > self.deepest {
                return None;
            }
            let (force, heat) = self.force(middle, &now.velocity, dt);
            if force.z == 0.0 {
                return Some(now);
            }
            let change = mobility * force;
            shift += dt * (now.velocity - 0.5 * dt * change);
            now.velocity -= dt * change;
            now.duration += dt;
            now.friction_heat += heat;
            now.maximal_approach = now.maximal_approach.max(shift.z);
            now.maximal_force = now.maximal_force.max(force.z);
            now.compressions += u32::from(parting && now.velocity.z > 0.0);
            parting = now.velocity.z < 0.0;
            let (time, velocity, stage) = (now.duration, now.velocity, self.stage);
            if part % parts == 0 {
                now.instants.push(Instant { time, shift, velocity, force, stage });
            }
        }
        None
    }

    /// The force of a step with this approach in its middle, whose springs end it as it leaves them, and the heat of their
    /// friction.
    fn force(&mut self, approach: f64, velocity: &Vector3<f64>, dt: f64) -> (Vector3<f64>, f64) {
        let [threshold, kinetic] = self.friction;
        let step = Step { approach, velocity: *velocity, dt };
        let slides = threshold > kinetic && (self.stage == Stage::Slide || self.all_slip(&step));
        let friction = if slides { kinetic } else { threshold };
        let (mut force, mut heat) = (Vector3::zeros(), 0.0);
        let (mut sticks, mut slips) = (false, false);
        for spring in 0..self.depths.len() {
            let Some(Pressed { pressure, limit, since, trial }) = self.pressed(spring, &step)
            else {
                self.shifts[spring] = [0.0; 2];
                continue;
            };
            let pull = limited(trial, friction * limit, self.ratios);
            let moves = pull != trial;
            (sticks, slips) = (sticks | !moves, slips | moves);
            let shift = &mut self.shifts[spring];
            for k in 0..2 {
                let elastic = pull[k] / (self.ratios[k] * self.stiffness);
                let growth = since * (elastic - shift[k]) / (since + self.relaxation);
                shift[k] += growth;
                force[k] += pull[k];
                heat += pull[k] * (since * velocity[k] - growth);
            }
            force.z += pressure;
        }
        self.stage = match (sticks, slips) {
            (true, true) => Stage::Slip,
            (false, true) => Stage::Slide,
            _ => Stage::Adhesion,
        };
        (force, heat)
    }

    fn all_slip(&self, step: &Step) -> bool {
        (0..self.depths.len()).filter_map(|spring| self.pressed(spring, step)).all(|pressed| {
            let [x, y] = pressed.trial;
            libm::hypot(x, y) > self.friction[0] * pressed.limit
        })
    }

    /// What a spring bears in a step; none if it does not touch or would pull.
    #[inline(always)]
    fn pressed(&self, spring: usize, step: &Step) -> Option<Pressed> {
        let (depth, shift, velocity) = (self.depths[spring], self.shifts[spring], step.velocity);
        let pressure = self.stiffness * (step.approach - depth + self.relaxation * velocity.z);
        if step.approach <= depth || pressure <= 0.0 {
            return None;
        }
        let ahead = 0.5 * step.dt * velocity.z;
        // A spring that touches in this step has moved for a part of it.
        let since = match step.approach - ahead < depth {
            true => (ahead + step.approach - depth) / velocity.z,
            false => step.dt,
        };
        let late = since + self.relaxation;
        let trial =
            [0, 1].map(|k| self.ratios[k] * self.stiffness * (shift[k] + late * velocity[k]));
        // Not 0: friction may be infinite.
        let limit = (pressure + self.stiffness * ahead).max(f64::MIN_POSITIVE);
        Some(Pressed { pressure, limit, since, trial })
    }
}

/// A step: the approach in its middle, and the velocity.
struct Step {
    approach: f64,
    velocity: Vector3<f64>,
    dt: f64,
}

/// What a spring bears.
struct Pressed {
    /// In the middle of the step.
    pressure: f64,
    /// At its end, as the trial.
    limit: f64,
    /// How long it has touched in this step.
    since: f64,
    /// The traction, if it does not slip.
    trial: [f64; 2],
}

/// The traction of a spring that slips along it until it is within the limit: q/(1 + l r) along each axis, of the length of
/// the limit.
fn limited(trial: [f64; 2], limit: f64, ratios: [f64; 2]) -> [f64; 2] {
    let size = (trial[0] * trial[0] + trial[1] * trial[1]).sqrt();
    if size <= limit {
        return trial;
    }
    if ratios[0] == ratios[1] {
        return trial.map(|one| one * (limit / size));
    }
    let at = |slip: f64| [0, 1].map(|k| trial[k] / (1.0 + slip * ratios[k]));
    let mut slip = (size / limit - 1.0) / ratios[0].max(ratios[1]);
    // The reciprocal length is concave and grows with the slip: Newton's iteration rises to the limit.
    for _ in 0..30 {
        let pull = at(slip);
        let length = (pull[0] * pull[0] + pull[1] * pull[1]).sqrt();
        if length - limit <= 1e-13 * limit {
            break;
        }
        let fall: f64 =
            (0..2).map(|k| pull[k] * pull[k] * ratios[k] / (1.0 + slip * ratios[k])).sum();
        slip += length * length * (length / limit - 1.0) / fall;
    }
    at(slip)
}

#[cfg(test)]
mod tests {
    use carom_laws::friction::Friction;
    use carom_laws::stiffness::ContactStiffness;

    use super::*;
    use crate::mobility::Mobility;
    use crate::viscoelastic::ViscousLoss;
    use carom_laws::static_friction::StaticFriction;

    const STIFF: ContactStiffness = ContactStiffness { c_x: 0.8, c_y: 0.8, c_z: 1.0 };

    fn impact(mobility: [f64; 3], stiffness: ContactStiffness, slip: [f64; 2]) -> CoupledImpact {
        let mobility = Mobility::from_matrix(Matrix3::from_diagonal(&mobility.into())).unwrap();
        let velocity = Vector3::new(slip[0], slip[1], 1.0);
        CoupledImpact::new(mobility, stiffness, Friction::new(0.3).unwrap(), velocity).unwrap()
    }

    /// In any direction: velocity, duration, approach and the heat of friction are those of the known impact.
    #[test]
    fn slip_along_a_line_is_the_exact_viscous_impact() {
        for (e, slip) in [(0.9, [0.3, 0.4]), (0.6, [-0.5, 0.8]), (0.3, [1.4, -0.2])] {
            let loss = ViscousLoss::of_restitution(e).unwrap();
            let exact = impact([3.5, 3.5, 1.0], STIFF, slip).with_loss(loss);
            let relaxation = exact.material_viscosity().unwrap().unwrap().relaxation();
            let unit = exact.normal.time_unit();
            let found = exact.by_springs(relaxation / unit).unwrap();
            let known = exact.solve(crate::coupled::TurningLaw::Coulomb).unwrap();
            let off = (found.velocity - known.velocity).norm();
            assert!(off < found.error && found.error < 2e-3, "{e}: {off} {}", found.error);
            assert!((found.duration * unit / known.duration - 1.0).abs() < 5e-3, "{e}");
            assert!((found.maximal_approach * unit / known.maximal_approach - 1.0).abs() < 2e-3);
            assert!((found.maximal_force / unit / known.maximal_force - 1.0).abs() < 5e-3, "{e}");
            let lost = 0.5 * known.impulse.dot(&(exact.velocity + known.velocity));
            let heat = lost - known.material_heat;
            assert!((found.friction_heat - heat).abs() < 3e-3 * lost, "{e}: {heat} {lost}");
            assert_eq!(found.compressions, 1);
        }
    }

    /// Mobility, whether c_x and c_y differ, relaxation time, slip before, velocity after.
    type Case = ([f64; 3], bool, f64, [f64; 2], [f64; 3]);
    const CASES: [Case; 3] = [
        ([3.5, 1.4, 1.0], false, 0.3, [0.3, 0.5], [-0.05937, -0.14624, -0.61574]),
        ([2.0, 3.5, 1.0], true, 0.1, [-0.6, 0.4], [0.35337, -0.17741, -0.83640]),
        ([1.2, 3.0, 1.0], true, 0.8, [0.9, 0.7], [0.47428, 0.12988, -0.34515]),
    ];

    fn check(found: &SpringImpact, after: [f64; 3]) {
        let (off, error) = ((found.velocity - Vector3::from(after)).norm(), found.error);
        assert!(off < 1e-3 && off < 2.0 * error, "{off} {error}: {:?}", found.velocity);
    }

    /// By another program: springs of the same kind, 400 of them and 5000 steps.
    #[test]
    fn slip_that_turns_is_that_of_another_program() {
        let unlike = ContactStiffness { c_y: 0.6, ..STIFF };
        for (mobility, stiffness, relaxation, slip, after) in CASES {
            let stiffness = if stiffness { unlike } else { STIFF };
            let found = impact(mobility, stiffness, slip).by_springs(relaxation).unwrap();
            check(&found, after);
        }
    }

    /// Springs that relax at once are the elastic law, whose steps end where the force drops.
    #[test]
    fn static_friction_is_that_of_the_elastic_law() {
        for (mobility, slip) in [
            ([3.5, 1.4, 1.0], [0.3, 0.5]),
            ([1.2, 3.0, 1.0], [0.9, -0.7]),
            ([2.0, 3.5, 1.0], [0.1, 0.4]),
        ] {
            let [f_s, f_k] = [0.4, 0.2].map(|f| Friction::new(f).unwrap());
            let both = StaticFriction::new(f_s, f_k).unwrap();
            let own = impact(mobility, STIFF, slip).with_static_friction(both);
            let known = own.solve(crate::coupled::TurningLaw::Coulomb).unwrap();
            let found = own.by_springs(1e-6).unwrap();
            let off = (found.velocity - known.velocity).norm();
            assert!(off < 2e-3, "{mobility:?} {off} {}", found.error);
        }
    }

    /// Sliding drives the bodies together: the row is several times deeper than without friction.
    #[test]
    fn deep_springs_that_relax_at_once_are_the_elastic_law() {
        let rows = Matrix3::new(3.0, 0.0, -1.6, 0.0, 2.0, 0.0, -1.6, 0.0, 1.0);
        let friction = Friction::new(1.5).unwrap();
        let mobility = Mobility::from_matrix(rows).unwrap();
        for slip in [3.0, 6.0] {
            let own = CoupledImpact { friction, mobility, ..impact([1.0; 3], STIFF, [slip, 0.0]) };
            let known = own.solve(crate::coupled::TurningLaw::Coulomb).unwrap();
            let found = own.by_springs(1e-6).unwrap();
            let deep = known.maximal_approach / own.normal.maximal_approach();
            let off = (found.velocity - known.velocity).norm() / own.velocity.norm();
            assert!(deep > 3.2 && (found.maximal_approach / deep - 1.0).abs() < 5e-3, "{deep}");
            assert!(off < 5e-3, "{slip}: {off} {} {:?}", found.error, known.velocity);
        }
    }

    /// A body that turns a thousand times more easily: its steps would grow without limit.
    #[test]
    fn a_body_that_is_too_light_along_the_surface_is_refused() {
        for axis in [0, 1] {
            let light = |by: f64, relaxation: f64| {
                let mut mobility = [3.5, 3.5, 1.0];
                mobility[axis] = by;
                impact(mobility, STIFF, [0.3, 0.5]).by_springs(relaxation)
            };
            assert!(light(1e3, 0.3).is_some() && light(1e5, 0.3).is_none());
            // A body that hardly indents has few springs to carry along.
            let damped = light(150.0, 30.0).unwrap();
            assert!(damped.velocity.norm() < 5e-3, "{:?}", damped.velocity);
        }
    }

    /// What has parted forgets its shift.
    #[test]
    fn bodies_pressed_together_again_are_those_of_the_elastic_law() {
        for (slope, times) in [(2.35, 3), (2.45, 2)] {
            let slanted = 0.3 + slope * slope;
            let rows = Matrix3::new(slanted, 0.0, slope, 0.0, 1.0, 0.0, slope, 0.0, 1.1);
            let mobility = Mobility::from_matrix(rows).unwrap();
            let friction = Friction::new(2.0).unwrap();
            let own = CoupledImpact { friction, mobility, ..impact([1.0; 3], STIFF, [1.0, 0.0]) };
            let known = own.solve(crate::coupled::TurningLaw::Coulomb).unwrap();
            let found = own.by_springs(1e-6).unwrap();
            let off = (found.velocity - known.velocity).norm();
            assert!(off < 1e-3, "{slope}: {off} {}", found.error);
            let loss = ViscousLoss::of_restitution(0.9999).unwrap();
            let lossy = own.with_loss(loss).solve(crate::coupled::TurningLaw::Coulomb).unwrap();
            let all = [found.compressions, known.compressions, lossy.compressions];
            assert_eq!(all, [times; 3]);
        }
    }

    /// The normal motion coupled to slip in a plane, by that program.
    #[test]
    fn coupled_slip_in_a_plane_is_that_of_another_program() {
        for (pull, relaxation, slip, x, z) in [
            (0.8, 0.3, 0.5, -0.37552, -0.52050),
            (-0.6, 0.1, 0.9, 0.22416, -0.84730),
            (0.5, 0.6, -0.4, 0.15473, -0.44564),
        ] {
            let rows = Matrix3::new(3.0, 0.0, pull, 0.0, 2.0, 0.0, pull, 0.0, 1.0);
            let own = impact([1.0; 3], STIFF, [slip, 0.0]);
            let own = CoupledImpact { mobility: Mobility::from_matrix(rows).unwrap(), ..own };
            let found = own.by_springs(relaxation).unwrap();
            check(&found, [x, 0.0, z]);
        }
    }

    /// It is of the length of the limit, and what it slips is along itself.
    #[test]
    fn a_traction_slips_along_itself() {
        for ratios in [[1.0, 1.0], [0.7, 0.9], [0.9, 0.2]] {
            let (trial, limit) = ([3.0, -4.0], 0.5);
            let pull = limited(trial, limit, ratios);
            assert!((pull[0].hypot(pull[1]) - limit).abs() < 1e-12);
            let slip = [0, 1].map(|k| (trial[k] - pull[k]) / ratios[k]);
            assert!(
                (slip[0] * pull[1] - slip[1] * pull[0]).abs() < 1e-11 && slip[0] * pull[0] > 0.0
            );
            assert_eq!(limited(trial, 5.0, ratios), trial);
        }
    }
}
