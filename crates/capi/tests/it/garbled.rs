//! Bytes that were changed while the mark is intact, one word at a time: each call ends with a status.

use std::mem::MaybeUninit;
use std::ptr::null_mut;

use carom_capi::*;

use crate::border;

/// What a word is changed to: letters, all bits, one tag beyond the last, a number that is none, a large one.
pub(crate) const WORDS: [u64; 8] = [
    0x5a5a_5a5a_5a5a_5a5a,
    u64::MAX,
    7,
    0x0706_0504,
    0x7ff8_0000_0000_0000,
    0x7fef_ffff_ffff_ffff,
    0xfff0_0000_0000_0000,
    0,
];

/// A contact that has turned, with vertices.
fn contact(pair: &CaromPair) -> CaromContact {
    let mut made = border::contact();
    for i in 0..9 {
        let (sin, cos) = f64::from(i).sin_cos();
        let zeta = 1e-7 * (1.0 + 0.2 * cos);
        let shift = CaromShift { zeta, xi: 3e-8 * sin, eta: 2e-8 * cos };
        // SAFETY: all pointers are references or null.
        let status =
            unsafe { carom_contact_advance(pair, &mut made, shift, null_mut(), null_mut()) };
        assert_eq!(status, CaromStatus::Ok);
    }
    made
}

/// What ended well, of every call that reads or changes a contact.
fn ask_all(pair: &CaromPair, garbled: &CaromContact) -> usize {
    let shift = CaromShift { zeta: 1.1e-7, xi: 1e-8, eta: -2e-8 };
    let mut load = CaromLoad::default();
    let (mut number, mut error) = (0.0, MaybeUninit::<CaromError>::zeroed());
    let mut state = CaromState { numbers: [0.0; CAROM_STATE_NUMBERS] };
    let [mut moved, mut taken, mut many] = [*garbled; 3];
    let (error, size) = (error.as_mut_ptr(), size_of::<CaromContact>());
    // SAFETY: all pointers are references or null.
    let statuses = unsafe {
        [
            carom_contact_load(pair, garbled, &mut load, error),
            carom_contact_energy(pair, garbled, &mut number, error),
            carom_contact_advance(pair, &mut moved, shift, &mut load, error),
            carom_contact_pack(pair, garbled, &mut state, error),
            carom_contact_unpack(pair, &state, &mut taken, error),
            carom_contact_advance_many(pair, 1, &mut many, size, &shift, 0, null_mut(), 0, error),
        ]
    };
    assert!(!statuses.contains(&CaromStatus::Internal), "{statuses:?}");
    statuses.into_iter().filter(|status| *status == CaromStatus::Ok).count()
}

/// With a lowest vertex above the approach a step that recedes looked for one below it, and panicked inside.
#[test]
fn a_vertex_at_another_depth_is_a_status_and_no_panic() {
    let mut refused = 0;
    for (law, friction) in [(0, 0.4), (1, 0.4), (0, f64::INFINITY)] {
        let pair = border::pair(friction, law);
        let whole = contact(&pair);
        for at in 0..CAROM_CONTACT_WORDS {
            for depth in [9.5e-8_f64, -1e-7, 1.0, f64::NAN] {
                let mut garbled = whole;
                garbled.words[at] = MaybeUninit::new(depth.to_bits());
                let back = CaromShift { zeta: 9e-8, xi: 1e-8, eta: 0.0 };
                // SAFETY: all pointers are references or null.
                let status = unsafe {
                    carom_contact_advance(&pair, &mut garbled, back, null_mut(), null_mut())
                };
                assert_ne!(status, CaromStatus::Internal, "{law} {friction} {at} {depth}");
                refused += usize::from(status == CaromStatus::BadState);
            }
        }
    }
    assert!(refused >= 12, "{refused}");
}

/// A contact without vertices whose regime and approach said that it touched was asked for its last vertex.
#[test]
fn a_separated_contact_that_claims_to_touch_is_a_status_and_no_panic() {
    for law in [CAROM_LAW_COULOMB, CAROM_LAW_FIXED_DIRECTION] {
        let pair = border::pair(0.4, law);
        let mut whole = contact(&pair);
        let apart = CaromShift { zeta: -1e-8, xi: 0.0, eta: 0.0 };
        // SAFETY: all pointers are references or null.
        let status =
            unsafe { carom_contact_advance(&pair, &mut whole, apart, null_mut(), null_mut()) };
        assert_eq!(status, CaromStatus::Ok);
        for at in 0..CAROM_CONTACT_WORDS {
            let mut touching = whole;
            touching.words[at] = MaybeUninit::new(1e-7_f64.to_bits());
            for other in (0..CAROM_CONTACT_WORDS).filter(|other| *other != at) {
                for regime in 1..8 {
                    let mut garbled = touching;
                    garbled.words[other] = MaybeUninit::new(0x0101_0101_0101_0101 * regime);
                    let mut load = CaromLoad::default();
                    // SAFETY: all pointers are references or null.
                    let status =
                        unsafe { carom_contact_load(&pair, &garbled, &mut load, null_mut()) };
                    assert_ne!(status, CaromStatus::Internal, "{law} {at} {other} {regime}");
                }
            }
        }
    }
}

#[test]
fn a_changed_tag_of_a_contact_is_a_status_and_no_jump() {
    let mut refused = 0;
    for (law, friction) in [(0, 0.4), (1, 0.4), (0, 0.0), (0, f64::INFINITY)] {
        let pair = border::pair(friction, law);
        let whole = contact(&pair);
        let packs = if friction.is_finite() { 6 } else { 4 };
        assert!(ask_all(&pair, &whole) >= packs);
        for at in 0..CAROM_CONTACT_WORDS {
            for word in WORDS {
                let mut garbled = whole;
                garbled.words[at] = MaybeUninit::new(word);
                refused += usize::from(ask_all(&pair, &garbled) == 0);
            }
        }
    }
    assert!(refused >= 10, "{refused}");
}

/// A contact that another compiler or version wrote is told apart by its mark, whatever its size.
#[test]
fn marks_of_contacts_know_the_build() {
    let pair = border::pair(0.4, 0);
    let whole = contact(&pair);
    let old = 0x6361_726f_6d00_0002 + ((8 * CAROM_CONTACT_WORDS as u64) << 8);
    assert!(whole.mark != old && whole.mark & 1 == 1);
    for bit in 0..64 {
        let strange = CaromContact { mark: whole.mark ^ (1 << bit), ..whole };
        assert_eq!(ask_all(&pair, &strange), 0);
    }
}
