//! Advances several contacts together.

use std::array::from_fn;

use carom_special::RangeError;

use super::contact::GrainContact;
use super::dashpots::Dashpots;
use super::load::{GrainLoad, LARGEST_ARM, LARGEST_DRAG, elastic, forces};
use super::meeting::{Grain, Meeting, Meetings};
use super::number::{LANES, Lanes, hold, lanes};
use super::step::{Before, Step, parting};
use super::vector::dot;
use crate::bounds::{LARGEST, LARGEST_IN_MEMORY};
use crate::law::{ContactLaw as _, Shift};
use crate::memory::VertexStack;

/// Number of contacts that are advanced together.
pub const TOGETHER: usize = LANES;

/// Two spheres and their contact.
#[derive(Debug)]
pub struct Touching<'a, S: VertexStack<[f64; 2]>> {
    /// Their contact, with its load history.
    pub contact: &'a mut GrainContact<S>,
    /// Body 1 and body 2.
    pub bodies: [&'a Grain; 2],
    /// The fractions of the approach, as in [`Meeting::of_spheres`].
    pub shares: [f64; 2],
    /// The load on body 1 at the end of the step; output.
    pub load: &'a mut GrainLoad,
}

impl<S: VertexStack<[f64; 2]>> Touching<'_, S> {
    fn meeting(&self) -> Result<Meeting, RangeError> {
        let [one, two] = self.bodies;
        Meeting::of_spheres(one, two, self.shares)
    }
}

/// Advances several pairs of spheres by a step of duration `dt` and writes the load of each. The
/// results are the same bits as those of [`GrainContact::advance`], in less time.
///
/// `meanwhile` is called between the steps of the laws, with 0 to TOGETHER - 1, unless one of the
/// contacts begins or ends. It may prefetch the data of the next contacts, which then costs no
/// time.
///
/// ```
/// use carom_laws::friction::Friction;
/// use carom_laws::grains::{Grain, GrainContact, GrainLoad, Touching, advance_together};
/// use carom_laws::memory::Fixed;
/// use carom_laws::shift_law::ShiftLaw;
/// use carom_laws::stiffness::ContactStiffness;
/// let law = ShiftLaw::new(ContactStiffness::new(1.0, 1.0, 1.2)?, Friction::new(0.3)?);
/// let new = GrainContact::<Fixed<_, 12>>::new(law, 0.0)?;
/// let mut four = [(new, GrainLoad::default()); 4];
/// let below = Grain { place: [0.0; 3], velocity: [0.0; 3], spin: [0.0; 3], radius: 1.0, mass: 1.0 };
/// let above = Grain { place: [0.0, 0.0, 1.99], velocity: [0.1, 0.0, 0.0], ..below };
/// let mut pairs = four.each_mut().map(|(contact, load)| {
///     Touching { contact, bodies: [&above, &below], shares: [0.5; 2], load }
/// });
/// advance_together(&mut pairs, 1e-3, |_| {})?;
/// assert!(four.iter().all(|(_, load)| load.force[0] < 0.0));
/// # Ok::<(), carom_special::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] for a shift that one of the laws does not allow; all contacts are then unchanged.
#[inline(always)]
pub fn advance_together<S: VertexStack<[f64; 2]>>(
    pairs: &mut [Touching<'_, S>; TOGETHER],
    dt: f64,
    meanwhile: impl FnMut(usize),
) -> Result<(), RangeError> {
    let shares = from_fn(|k| each(pairs, |pair| pair.shares[k]));
    let bodies = from_fn(|k| from_fn(|i| pairs[i].bodies[k]));
    let (meeting, before) = (Meetings::of_pairs(bodies, shares)?, before(pairs));
    // A new contact has no tangent.
    let has_begun = dot(before.tangent, before.tangent).simd_gt(Lanes::splat(0.0));
    let stays = parting(&meeting, dt).simd_ge(Lanes::splat(0.0) - meeting.zeta);
    if hold(has_begun & stays) {
        go_on(pairs, &meeting, &before, dt, meanwhile)
    } else {
        one_by_one(pairs, dt)
    }
}

type Pairs<'a, S> = [Touching<'a, S>; TOGETHER];

#[inline(always)]
fn each<S: VertexStack<[f64; 2]>>(
    pairs: &Pairs<'_, S>,
    of: impl Fn(&Touching<'_, S>) -> f64,
) -> Lanes {
    lanes(|i| of(&pairs[i]))
}

#[inline(always)]
fn go_on<S: VertexStack<[f64; 2]>>(
    pairs: &mut Pairs<'_, S>,
    meeting: &Meetings,
    before: &Before<Lanes>,
    dt: f64,
    mut meanwhile: impl FnMut(usize),
) -> Result<(), RangeError> {
    let step = before.step(meeting, dt);
    let c_z = each(pairs, |pair| pair.contact.law.stiffness().c_z);
    let elastic = elastic(c_z, meeting.zeta);
    let dashpots = Dashpots {
        viscosity: each(pairs, |pair| pair.contact.dashpots.viscosity),
        ratio: each(pairs, |pair| pair.contact.dashpots.ratio),
    };
    let masses = || from_fn(|k| each(pairs, |pair| pair.bodies[k].mass));
    let drag = dashpots.force(meeting, masses, [c_z, elastic], dt);
    let to = normalised(pairs, &step);
    if !hold(allowed(&step, to) & allowed_beside(meeting.arms, drag)) {
        return one_by_one(pairs, dt);
    }
    let mut frictions = [[0.0; 2]; TOGETHER];
    for (i, pair) in pairs.iter_mut().enumerate() {
        meanwhile(i);
        let to = to.map(|lane| lane.to_array()[i]);
        frictions[i] = pair.contact.law.go(lane(&step, i), to);
    }
    let friction = from_fn(|k| lanes(|i| frictions[i][k]));
    let axes = [step.tangent, meeting.normal];
    let loads = forces(axes, meeting.arms, elastic + drag, friction);
    for (i, pair) in pairs.iter_mut().enumerate() {
        let contact = &mut *pair.contact;
        contact.tangent = step.tangent.map(|lane| lane.to_array()[i]);
        contact.normal = meeting.normal.map(|lane| lane.to_array()[i]);
        contact.friction = frictions[i];
        contact.drag = drag.to_array()[i];
        contact.velocity = step.velocity.map(|lane| lane.to_array()[i]);
        contact.lead = step.lead.map(|lane| lane.to_array()[i]);
    }
    for (i, pair) in pairs.iter_mut().enumerate() {
        let [force, torque_1, torque_2] = loads.map(|v| v.map(|lane| lane.to_array()[i]));
        *pair.load = GrainLoad { force, torques: [torque_1, torque_2] };
    }
    Ok(())
}

#[inline(always)]
fn before<S: VertexStack<[f64; 2]>>(pairs: &Pairs<'_, S>) -> Before<Lanes> {
    Before {
        tangent: from_fn(|k| each(pairs, |pair| pair.contact.tangent[k])),
        normal: from_fn(|k| each(pairs, |pair| pair.contact.normal[k])),
        velocity: from_fn(|k| each(pairs, |pair| pair.contact.velocity[k])),
        lead: from_fn(|k| each(pairs, |pair| pair.contact.lead[k])),
        zeta: each(pairs, |pair| pair.contact.law.shift().zeta),
        shift: [
            each(pairs, |pair| pair.contact.law.shift().xi),
            each(pairs, |pair| pair.contact.law.shift().eta),
        ],
    }
}

#[inline(always)]
fn normalised<S: VertexStack<[f64; 2]>>(pairs: &Pairs<'_, S>, step: &Step<Lanes>) -> [Lanes; 2] {
    from_fn(|k| step.shift[k] * each(pairs, |pair| pair.contact.law.scale_of_shifts()[k]))
}

/// Which lanes are at most this in magnitude.
#[inline(always)]
fn up_to(lane: Lanes, most: f64) -> Lanes {
    lane.abs().simd_le(Lanes::splat(most))
}

/// Which steps, with these normalised shifts, the laws allow.
#[inline(always)]
fn allowed(step: &Step<Lanes>, to: [Lanes; 2]) -> Lanes {
    let [xi, eta] = step.shift;
    let told = up_to(step.zeta, LARGEST) & up_to(xi, LARGEST) & up_to(eta, LARGEST);
    told & up_to(to[0], LARGEST_IN_MEMORY) & up_to(to[1], LARGEST_IN_MEMORY)
}

/// Of which contacts [`check_beside`] allows the rest of the load.
#[inline(always)]
fn allowed_beside([one, two]: [Lanes; 2], drag: Lanes) -> Lanes {
    up_to(one, LARGEST_ARM) & up_to(two, LARGEST_ARM) & up_to(drag, LARGEST_DRAG)
}

/// Advances the contacts one after the other, if one begins, ends or is refused.
#[cold]
#[inline(never)]
fn one_by_one<S: VertexStack<[f64; 2]>>(
    pairs: &mut Pairs<'_, S>,
    dt: f64,
) -> Result<(), RangeError> {
    let before: [_; TOGETHER] = from_fn(|i| pairs[i].contact.clone());
    let mut loads = [GrainLoad::default(); TOGETHER];
    for (pair, load) in pairs.iter_mut().zip(&mut loads) {
        match pair.meeting().and_then(|meeting| pair.contact.advance(&meeting, dt)) {
            Ok(exerted) => *load = exerted,
            Err(error) => {
                for (pair, before) in pairs.iter_mut().zip(before) {
                    *pair.contact = before;
                }
                return Err(error);
            }
        }
    }
    for (pair, load) in pairs.iter_mut().zip(loads) {
        *pair.load = load;
    }
    Ok(())
}

#[inline(always)]
fn lane(step: &Step<Lanes>, i: usize) -> Shift {
    let [xi, eta] = step.shift.map(|lane| lane.to_array()[i]);
    Shift { zeta: step.zeta.to_array()[i], xi, eta, omega: 0.0 }
}
