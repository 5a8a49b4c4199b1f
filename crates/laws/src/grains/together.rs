//! Some contacts that make their step together.

use std::array::from_fn;

use carom_special::RangeError;

use super::contact::{Before, GrainContact, GrainLoad, Step, drag, forces, parting};
use super::meeting::{Grain, Meeting};
use super::number::{LANES, Lanes, lanes};
use crate::law::{Checked as _, ContactLaw as _, ContactLoad, Shift};
use crate::memory::VertexStack;

/// How many contacts make a step together.
pub const TOGETHER: usize = LANES;

/// Two spheres and their contact.
#[derive(Debug)]
pub struct Touching<'a, S> {
    /// What they remember.
    pub contact: &'a mut GrainContact<S>,
    /// Body 1 and body 2.
    pub bodies: [&'a Grain; 2],
    /// As in [`Meeting::of_spheres`].
    pub shares: [f64; 2],
}

/// One step of the duration `dt` of some pairs of spheres, and the load of each, with its arms
/// ([`Meeting::arms`]): the same bits as by [`GrainContact::advance`], in less time.
///
/// `meanwhile` is called between the steps of the laws, with 0 to TOGETHER - 1, unless one of the contacts begins or
/// ends: what then goes to memory for the contacts to come costs no time.
///
/// ```
/// use carom_laws::friction::Friction;
/// use carom_laws::grains::{Grain, GrainContact, TOGETHER, Touching, advance_together};
/// use carom_laws::memory::Fixed;
/// use carom_laws::shift_law::ShiftLaw;
/// use carom_laws::stiffness::ContactStiffness;
/// let law = ShiftLaw::new(ContactStiffness::new(1.0, 1.0, 1.2)?, Friction::new(0.3)?);
/// let mut contacts = [GrainContact::<Fixed<_, 12>>::new(law, 0.0)?; TOGETHER];
/// let below = Grain { place: [0.0; 3], velocity: [0.0; 3], spin: [0.0; 3], radius: 1.0 };
/// let above = Grain { place: [0.0, 0.0, 1.99], velocity: [0.1, 0.0, 0.0], ..below };
/// let mut pairs = contacts.each_mut().map(|contact| {
///     Touching { contact, bodies: [&above, &below], shares: [0.5; 2] }
/// });
/// let loads = advance_together(&mut pairs, 1e-3, |_| {})?;
/// assert!(loads.iter().all(|(load, _)| load.force[0] < 0.0));
/// # Ok::<(), carom_special::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] for what one of the laws cannot take; no contact is then changed.
#[inline(always)]
pub fn advance_together<S: VertexStack<[f64; 2]>>(
    pairs: &mut [Touching<'_, S>; TOGETHER],
    dt: f64,
    meanwhile: impl FnMut(usize),
) -> Result<[(GrainLoad, [f64; 2]); TOGETHER], RangeError> {
    let shares = from_fn(|k| lanes(|i| pairs[i].shares[k]));
    let [one, two] = from_fn(|k| from_fn(|i| pairs[i].bodies[k]));
    let meeting = Meeting::of_pairs(one, two, shares)?;
    let part = parting(&meeting, dt);
    let goes_on =
        |i: usize| part.to_array()[i] >= -meeting.zeta.to_array()[i] && !pairs[i].contact.is_new();
    if (0..TOGETHER).all(goes_on) {
        go_on(pairs, &meeting, dt, meanwhile)
    } else {
        one_by_one(pairs, &meeting, dt)
    }
}

#[inline(always)]
fn go_on<S: VertexStack<[f64; 2]>>(
    pairs: &mut [Touching<'_, S>; TOGETHER],
    meeting: &Meeting<Lanes>,
    dt: f64,
    mut meanwhile: impl FnMut(usize),
) -> Result<[(GrainLoad, [f64; 2]); TOGETHER], RangeError> {
    let step = before(pairs).step(meeting, dt);
    let shifts: [Shift; TOGETHER] = from_fn(|i| lane(&step, i));
    for (pair, shift) in pairs.iter().zip(shifts) {
        pair.contact.law.check(shift)?;
    }
    let mut loads = [ContactLoad::default(); TOGETHER];
    for (i, ((pair, shift), load)) in pairs.iter_mut().zip(shifts).zip(&mut loads).enumerate() {
        meanwhile(i);
        *load = pair.contact.law.advance(shift)?;
    }
    let elastic = lanes(|i| loads[i].f_z);
    let friction = [lanes(|i| loads[i].f_x), lanes(|i| loads[i].f_y)];
    let drag = drag(lanes(|i| pairs[i].contact.viscosity), meeting, elastic);
    let [force, couple] = forces([step.tangent, meeting.normal], elastic + drag, friction);
    for (i, pair) in pairs.iter_mut().enumerate() {
        let contact = &mut *pair.contact;
        contact.tangent = step.tangent.map(|lane| lane.to_array()[i]);
        contact.normal = meeting.normal.map(|lane| lane.to_array()[i]);
        contact.friction = [loads[i].f_x, loads[i].f_y];
        contact.drag = drag.to_array()[i];
        contact.velocity = step.velocity.map(|lane| lane.to_array()[i]);
        contact.lead = step.lead.map(|lane| lane.to_array()[i]);
    }
    Ok(from_fn(|i| {
        let [force, couple] = [force, couple].map(|vector| vector.map(|lane| lane.to_array()[i]));
        (GrainLoad { force, couple }, meeting.arms.map(|lane| lane.to_array()[i]))
    }))
}

/// Where one of them begins or ends.
#[cold]
#[inline(never)]
fn one_by_one<S: VertexStack<[f64; 2]>>(
    pairs: &mut [Touching<'_, S>; TOGETHER],
    meeting: &Meeting<Lanes>,
    dt: f64,
) -> Result<[(GrainLoad, [f64; 2]); TOGETHER], RangeError> {
    let before: [_; TOGETHER] = from_fn(|i| pairs[i].contact.clone());
    let mut loads = [(GrainLoad::default(), [0.0; 2]); TOGETHER];
    for i in 0..TOGETHER {
        let meeting = meeting.lane(i);
        match pairs[i].contact.advance(&meeting, dt) {
            Ok(load) => loads[i] = (load, meeting.arms),
            Err(error) => {
                for (pair, before) in pairs.iter_mut().zip(before) {
                    *pair.contact = before;
                }
                return Err(error);
            }
        }
    }
    Ok(loads)
}

#[inline(always)]
fn before<S: VertexStack<[f64; 2]>>(pairs: &[Touching<'_, S>; TOGETHER]) -> Before<Lanes> {
    let contact = |i: usize| &*pairs[i].contact;
    Before {
        tangent: from_fn(|k| lanes(|i| contact(i).tangent[k])),
        normal: from_fn(|k| lanes(|i| contact(i).normal[k])),
        velocity: from_fn(|k| lanes(|i| contact(i).velocity[k])),
        lead: from_fn(|k| lanes(|i| contact(i).lead[k])),
        shift: [lanes(|i| contact(i).law.shift().xi), lanes(|i| contact(i).law.shift().eta)],
    }
}

#[inline(always)]
fn lane(step: &Step<Lanes>, i: usize) -> Shift {
    let [xi, eta] = step.shift.map(|lane| lane.to_array()[i]);
    Shift { zeta: step.zeta.to_array()[i], xi, eta, omega: 0.0 }
}
