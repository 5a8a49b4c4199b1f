//! What must hold of an answer.

use std::mem::MaybeUninit;

use carom_capi::*;

use super::super::world::World;
use super::NAMES;

/// What a call has told with success are numbers, unless the bytes of a memory were changed.
pub(super) fn told(
    world: &World,
    status: CaromStatus,
    which: usize,
    numbers: &[f64],
) -> CaromStatus {
    let are_numbers = numbers.iter().all(|number| number.is_finite());
    let holds = status != CaromStatus::Ok || are_numbers || world.are_damaged;
    assert!(holds, "{}: {numbers:?}", NAMES[which]);
    status
}

/// The numbers of a load, and of what became heat.
pub(super) fn parts(load: &CaromGrainLoad, heats: &CaromHeats) -> [f64; 12] {
    let CaromGrainLoad { force: [a, b, c], torque_1: [d, e, f], torque_2: [g, h, i] } = *load;
    [a, b, c, d, e, f, g, h, i, heats.friction, heats.damping, heats.rolling]
}

/// A report that was told has a regime that is one.
pub(super) fn reported(
    report: &mut MaybeUninit<CaromReport>,
    ask: impl FnOnce(*mut CaromReport) -> CaromStatus,
) -> CaromStatus {
    let status = ask(report.as_mut_ptr());
    if status == CaromStatus::Ok {
        // SAFETY: written, in the layout of C: a double and the number of the regime.
        let regime = unsafe { report.as_ptr().cast::<u32>().add(2).read() };
        assert!(regime <= 6, "{regime}");
    }
    status
}
