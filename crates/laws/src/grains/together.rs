//! Advances several contacts together.

use std::array::from_fn;

use carom_special::RangeError;

use super::contact::GrainContact;
use super::dashpots::{Dashpots, Effective, Motion};
use super::drag_heat::DragHeat;
use super::load::{GrainLoad, LARGEST_ARM, LARGEST_DRAG, elastic, forces};
use super::meeting::{Grain, Meeting, Meetings};
use super::number::{LANES, Lanes, Number as _, hold, lanes};
use super::rolling::Rolling;
use super::step::{Before, Step, parting};
use super::vector::dot;
use crate::bounds::{LARGEST, LARGEST_IN_MEMORY};
use crate::law::{ContactLaw as _, Shift};
use crate::memory::VertexStack;
use crate::shift_law::ShiftLaw;

/// Number of contacts that are advanced together.
pub const TOGETHER: usize = LANES;

/// Two spheres and their contact.
#[derive(Debug)]
pub struct Touching<'a, S: VertexStack<[f64; 2]>> {
    /// Their contact, with its load history.
    pub contact: &'a mut GrainContact<ShiftLaw<[f64; 2], S>>,
    /// Body 1 and body 2.
    pub bodies: [&'a Grain; 2],
    /// The fractions of the approach, as in [`Meeting::of_spheres`].
    pub shares: [f64; 2],
    /// The resistance to rolling.
    pub rolling: Option<Rolling<'a>>,
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
/// contacts begins or ends, or some are damped and others are not. It may prefetch the data of the next contacts, which then costs no
/// time.
///
/// ```
/// use carom_laws::friction::Friction;
/// use carom_laws::grains::{Grain, GrainContact, GrainLoad, Touching, advance_together};
/// use carom_laws::memory::Fixed;
/// use carom_laws::shift_law::ShiftLaw;
/// use carom_laws::stiffness::ContactStiffness;
/// let law = ShiftLaw::new(ContactStiffness::new(1.0, 1.0, 1.2)?, Friction::new(0.3)?);
/// let new = GrainContact::<ShiftLaw<_, Fixed<_, 12>>>::new(law, 0.0)?;
/// let mut four = [(new, GrainLoad::default()); 4];
/// let below = Grain { place: [0.0; 3], velocity: [0.0; 3], spin: [0.0; 3], radius: 1.0, mass: 1.0 };
/// let above = Grain { place: [0.0, 0.0, 1.99], velocity: [0.1, 0.0, 0.0], ..below };
/// let mut pairs = four.each_mut().map(|(contact, load)| {
///     Touching { contact, bodies: [&above, &below], shares: [0.5; 2], rolling: None, load }
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
    match pairs.iter().any(|pair| pair.rolling.is_some()) {
        true => rolling(pairs, dt, meanwhile),
        false => without_rolling(pairs, dt, meanwhile),
    }
}

/// Pairs some of which resist rolling.
#[inline(never)]
fn rolling<S: VertexStack<[f64; 2]>>(
    pairs: &mut Pairs<'_, S>,
    dt: f64,
    meanwhile: impl FnMut(usize),
) -> Result<(), RangeError> {
    let mut rolls = [const { None }; TOGETHER];
    for (rolls, pair) in rolls.iter_mut().zip(&*pairs) {
        if let Some(rolling) = &pair.rolling {
            let meeting = pair.meeting()?;
            *rolls = Some((meeting, rolling.trial(&meeting, dt)?));
        }
    }
    without_rolling(pairs, dt, meanwhile)?;
    for (rolls, pair) in rolls.iter().zip(pairs) {
        if let (Some((meeting, trial)), Some(rolling)) = (rolls, &mut pair.rolling) {
            rolling.press(meeting, trial, pair.load, None);
        }
    }
    Ok(())
}

#[inline(always)]
fn without_rolling<S: VertexStack<[f64; 2]>>(
    pairs: &mut Pairs<'_, S>,
    dt: f64,
    meanwhile: impl FnMut(usize),
) -> Result<(), RangeError> {
    let resists: [bool; TOGETHER] = from_fn(|i| pairs[i].contact.frame.dashpots.resist());
    match resists {
        [false, false, false, false] => undamped(pairs, dt, meanwhile),
        [true, true, true, true] => damped(pairs, dt, meanwhile),
        _ => one_by_one(pairs, dt),
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
fn met<S: VertexStack<[f64; 2]>>(pairs: &Pairs<'_, S>) -> Result<Meetings, RangeError> {
    let shares = from_fn(|k| each(pairs, |pair| pair.shares[k]));
    let bodies = from_fn(|k| from_fn(|i| pairs[i].bodies[k]));
    Meetings::of_pairs(bodies, shares)
}

/// Of which contacts the bodies have touched: a new contact has no tangent.
#[inline(always)]
fn have_begun(before: &Before<Lanes>) -> Lanes {
    dot(before.tangent, before.tangent).simd_gt(Lanes::splat(0.0))
}

/// Contacts none of which is damped.
#[inline(always)]
fn undamped<S: VertexStack<[f64; 2]>>(
    pairs: &mut Pairs<'_, S>,
    dt: f64,
    meanwhile: impl FnMut(usize),
) -> Result<(), RangeError> {
    let meeting = met(pairs)?;
    let before = before(pairs, |contact| contact.law.shift().zeta);
    let stays = parting(&meeting, dt).simd_ge(Lanes::splat(0.0) - meeting.zeta);
    if hold(have_begun(&before) & stays) {
        go_on(pairs, &meeting, &before, dt, meanwhile)
    } else {
        one_by_one(pairs, dt)
    }
}

/// Contacts all of which are damped; their laws are driven as in [`super::damped`].
#[inline(never)]
fn damped<S: VertexStack<[f64; 2]>>(
    pairs: &mut Pairs<'_, S>,
    dt: f64,
    meanwhile: impl FnMut(usize),
) -> Result<(), RangeError> {
    let meeting = met(pairs)?;
    let before = before(pairs, |contact| contact.frame.approach);
    // Bodies that touched before and overlap.
    let overlaps = |zeta: Lanes| zeta.simd_gt(Lanes::splat(0.0));
    if hold(have_begun(&before) & overlaps(before.zeta) & overlaps(meeting.zeta)) {
        go_on_damped(pairs, &meeting, &before, dt, meanwhile)
    } else {
        one_by_one(pairs, dt)
    }
}

#[inline(always)]
fn go_on<S: VertexStack<[f64; 2]>>(
    pairs: &mut Pairs<'_, S>,
    meeting: &Meetings,
    before: &Before<Lanes>,
    dt: f64,
    meanwhile: impl FnMut(usize),
) -> Result<(), RangeError> {
    let step = before.step(meeting, dt);
    let c_z = each(pairs, |pair| pair.contact.law.stiffness().c_z);
    let elastic = elastic(c_z, meeting.zeta);
    let to = normalised(pairs, step.shift);
    let is_allowed = allowed([step.zeta, step.shift[0], step.shift[1]], to);
    if !hold(is_allowed & allowed_beside(meeting.arms, Lanes::splat(0.0))) {
        return one_by_one(pairs, dt);
    }
    let frictions = advanced(pairs, [step.zeta, step.shift[0], step.shift[1]], to, meanwhile);
    exert(pairs, meeting, &step, elastic, frictions);
    for (i, pair) in pairs.iter_mut().enumerate() {
        pair.contact.frame.lead = step.lead.map(|lane| lane.to_array()[i]);
    }
    Ok(())
}

#[inline(always)]
fn go_on_damped<S: VertexStack<[f64; 2]>>(
    pairs: &mut Pairs<'_, S>,
    meeting: &Meetings,
    before: &Before<Lanes>,
    dt: f64,
    meanwhile: impl FnMut(usize),
) -> Result<(), RangeError> {
    let step = before.step(meeting, dt);
    let c_z = each(pairs, |pair| pair.contact.law.stiffness().c_z);
    let Effective { approach, theta } = effective(pairs, &step, c_z, dt);
    let [lead, by] = before.led(step.velocity, theta, Lanes::splat(1.0), dt);
    let by = slid_on(pairs, &step, [approach, Lanes::splat(dt)], by);
    let shift: [_; 2] = from_fn(|k| before.shift[k] + by[k]);
    let (its, drag) = (elastic(c_z, approach), elastic(c_z, approach) - elastic(c_z, step.zeta));
    let to = normalised(pairs, shift);
    let is_allowed = up_to(step.zeta, LARGEST) & allowed([approach, shift[0], shift[1]], to);
    if !hold(is_allowed & allowed_beside(meeting.arms, drag)) {
        return one_by_one(pairs, dt);
    }
    let frictions = advanced(pairs, [approach, shift[0], shift[1]], to, meanwhile);
    exert(pairs, meeting, &step, its, frictions);
    let lead = lead.map(|lead| lead.where_positive(approach));
    for (i, pair) in pairs.iter_mut().enumerate() {
        let contact = &mut *pair.contact;
        let at = |lane: Lanes| lane.to_array()[i];
        contact.frame.drag_heat = DragHeat { drag: contact.frame.drag, speed: at(step.speed) };
        (contact.frame.drag, contact.frame.approach) = (at(drag), at(step.zeta));
        contact.frame.lead = lead.map(at);
    }
    Ok(())
}

#[inline(always)]
fn effective<S: VertexStack<[f64; 2]>>(
    pairs: &Pairs<'_, S>,
    step: &Step<Lanes>,
    c_z: Lanes,
    dt: f64,
) -> Effective<Lanes> {
    let dashpots = Dashpots {
        relaxation: each(pairs, |pair| pair.contact.frame.dashpots.relaxation),
        ratio: each(pairs, |pair| pair.contact.frame.dashpots.ratio),
    };
    let last = each(pairs, |pair| pair.contact.frame.drag_heat.speed);
    let since = Lanes::splat(1.0);
    let motion = Motion { zeta: step.zeta, speed: step.speed, before: last, since, dt };
    let over = |k: usize| Lanes::splat(1.0) / each(pairs, |pair| pair.bodies[k].mass);
    dashpots.effective(motion, c_z, || over(0) + over(1))
}

/// The growths of the shifts of laws, as [`GrainContact::slid_on`].
#[inline(always)]
fn slid_on<S: VertexStack<[f64; 2]>>(
    pairs: &Pairs<'_, S>,
    step: &Step<Lanes>,
    [approach, dt]: [Lanes; 2],
    by: [Lanes; 2],
) -> [Lanes; 2] {
    let all: [[f64; 2]; TOGETHER] = from_fn(|i| {
        let at = |lane: Lanes| lane.to_array()[i];
        let contact = &*pairs[i].contact;
        let truly = step.velocity.map(|v| at(v * dt));
        contact.slid_on(truly, [at(step.zeta), at(approach)], by.map(at))
    });
    from_fn(|k| lanes(|i| all[i][k]))
}

/// Advances the laws to approaches and shifts, given as such and as normalised ones, that are allowed.
#[inline(always)]
fn advanced<S: VertexStack<[f64; 2]>>(
    pairs: &mut Pairs<'_, S>,
    shift: [Lanes; 3],
    to: [Lanes; 2],
    mut meanwhile: impl FnMut(usize),
) -> [[f64; 2]; TOGETHER] {
    let mut frictions = [[0.0; 2]; TOGETHER];
    for (i, pair) in pairs.iter_mut().enumerate() {
        meanwhile(i);
        let to = to.map(|lane| lane.to_array()[i]);
        frictions[i] = pair.contact.law.go(lane(shift, i), to);
    }
    frictions
}

/// Keeps what a step changed beside the law, and writes the loads.
#[inline(always)]
fn exert<S: VertexStack<[f64; 2]>>(
    pairs: &mut Pairs<'_, S>,
    meeting: &Meetings,
    step: &Step<Lanes>,
    normal_force: Lanes,
    frictions: [[f64; 2]; TOGETHER],
) {
    let friction = from_fn(|k| lanes(|i| frictions[i][k]));
    let axes = [step.tangent, meeting.normal];
    let loads = forces(axes, meeting.arms, normal_force, friction);
    for (i, pair) in pairs.iter_mut().enumerate() {
        let contact = &mut *pair.contact;
        contact.frame.tangent = step.tangent.map(|lane| lane.to_array()[i]);
        contact.frame.normal = meeting.normal.map(|lane| lane.to_array()[i]);
        contact.frame.friction = frictions[i];
        contact.frame.velocity = step.velocity.map(|lane| lane.to_array()[i]);
    }
    for (i, pair) in pairs.iter_mut().enumerate() {
        let [force, torque_1, torque_2] = loads.map(|v| v.map(|lane| lane.to_array()[i]));
        *pair.load = GrainLoad { force, torques: [torque_1, torque_2] };
    }
}

#[inline(always)]
fn before<S: VertexStack<[f64; 2]>>(
    pairs: &Pairs<'_, S>,
    approach: impl Fn(&GrainContact<ShiftLaw<[f64; 2], S>>) -> f64,
) -> Before<Lanes> {
    Before {
        tangent: from_fn(|k| each(pairs, |pair| pair.contact.frame.tangent[k])),
        normal: from_fn(|k| each(pairs, |pair| pair.contact.frame.normal[k])),
        velocity: from_fn(|k| each(pairs, |pair| pair.contact.frame.velocity[k])),
        lead: from_fn(|k| each(pairs, |pair| pair.contact.frame.lead[k])),
        zeta: each(pairs, |pair| approach(pair.contact)),
        shift: [
            each(pairs, |pair| pair.contact.law.shift().xi),
            each(pairs, |pair| pair.contact.law.shift().eta),
        ],
    }
}

#[inline(always)]
fn normalised<S: VertexStack<[f64; 2]>>(pairs: &Pairs<'_, S>, shift: [Lanes; 2]) -> [Lanes; 2] {
    from_fn(|k| shift[k] * each(pairs, |pair| pair.contact.law.scale_of_shifts()[k]))
}

/// Which lanes are at most this in magnitude.
#[inline(always)]
fn up_to(lane: Lanes, most: f64) -> Lanes {
    lane.abs().simd_le(Lanes::splat(most))
}

/// Which approaches and shifts, with these normalised shifts, the laws allow.
#[inline(always)]
fn allowed([zeta, xi, eta]: [Lanes; 3], to: [Lanes; 2]) -> Lanes {
    let told = up_to(zeta, LARGEST) & up_to(xi, LARGEST) & up_to(eta, LARGEST);
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
fn lane(shift: [Lanes; 3], i: usize) -> Shift {
    let [zeta, xi, eta] = shift.map(|lane| lane.to_array()[i]);
    Shift { zeta, xi, eta, omega: 0.0 }
}
