//! The state of a law as numbers, and back.

use carom_laws::law::ContactLaw;
use carom_laws::memory::{Lateral, VertexStack};
use carom_laws::rings::RingLaw;
use carom_laws::shift_law::ShiftLaw;
use carom_laws::torsion::law::{ShiftTwistLaw, TorsionLaw};

/// Room for any state of so few steps.
const ROOM: usize = 1 << 16;

/// A law whose state can be stored.
pub(crate) trait Stored: ContactLaw {
    /// Whether the state is that of another law, to the bit.
    fn is_same(&self, other: &Self) -> bool;

    /// Checks that the stored state comes back to the bit.
    fn check_stored(&self);
}

/// Compares the numbers of a state with those of the law restored from them.
fn check<L: Clone>(
    law: &L,
    pack: impl Fn(&L, &mut [f64]) -> bool,
    unpack: impl Fn(&mut L, &[f64]) -> bool,
) {
    let (mut numbers, mut again) = (vec![0.0; ROOM], vec![0.0; ROOM]);
    // A state of more vertices than its format can count is refused.
    if !pack(law, &mut numbers) {
        return;
    }
    let mut restored = law.clone();
    assert!(unpack(&mut restored, &numbers), "a state is refused");
    assert!(pack(&restored, &mut again), "a restored state is refused");
    let differ = (0..ROOM).find(|i| numbers[*i].to_bits() != again[*i].to_bits());
    assert!(differ.is_none(), "number {differ:?}: {:?}", differ.map(|i| (numbers[i], again[i])));
}

impl<V: Lateral, S: VertexStack<V>> Stored for ShiftLaw<V, S>
where
    Self: PartialEq,
{
    fn is_same(&self, other: &Self) -> bool {
        self == other
    }

    fn check_stored(&self) {
        check(self, |law, to| law.pack(to).is_ok(), |law, from| law.unpack(from).is_ok());
    }
}

impl Stored for TorsionLaw {
    fn is_same(&self, other: &Self) -> bool {
        self == other
    }

    fn check_stored(&self) {
        check(self, |law, to| law.pack(to) == Ok(0.0), |law, from| law.unpack(from).is_ok());
    }
}

impl Stored for ShiftTwistLaw {
    fn is_same(&self, other: &Self) -> bool {
        self == other
    }

    fn check_stored(&self) {
        self.tangential().check_stored();
        self.torsion().check_stored();
    }
}

impl Stored for RingLaw {
    fn is_same(&self, other: &Self) -> bool {
        let numbers = |law: &Self| {
            let mut numbers = vec![0.0; ROOM];
            law.pack(&mut numbers).expect("room");
            numbers.into_iter().map(f64::to_bits).collect::<Vec<_>>()
        };
        numbers(self) == numbers(other)
    }

    fn check_stored(&self) {
        check(self, |law, to| law.pack(to).is_ok(), |law, from| law.unpack(from).is_ok());
    }
}
