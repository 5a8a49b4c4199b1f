//! Bytes of touches that were changed while the mark is intact, one word at a time: each call ends with a status.

use super::*;
use crate::garbled::WORDS;

const DT: f64 = 1e-8;

/// Two grains that meet obliquely, at a time.
fn meeting(time: f64) -> [CaromGrain; 2] {
    let place = [0.3 * time, 0.1 * time, 2e-3 - 0.5 * time];
    [
        grain(place, [0.3, 0.1, -0.5], [40.0, 0.0, 30.0], 1e-3),
        grain([0.0; 3], [0.0; 3], [0.0; 3], 1e-3),
    ]
}

/// The statuses of every call that reads or changes a touch.
fn ask_all(
    law: &Made,
    garbled: &Touch,
    whole: &Touch,
    bodies: [CaromGrain; 2],
) -> Vec<CaromStatus> {
    let [one, two] = bodies;
    let status =
        |result: Result<(), Told>| result.map_or_else(|told| told.status, |()| CaromStatus::Ok);
    let (mut number, mut room) = (0.0, garbled.packed_room(law));
    let mut report = CaromReport { sticking: 0.0, regime: CaromRegime::Separated };
    let second = Second::Grain(two);
    let mut heats = CaromHeats::default();
    // Some that go together, among them the garbled one.
    let mut touches = vec![whole.clone(); 9];
    touches[2] = garbled.clone();
    let (at, none) = (garbled.at(), null_mut());
    // SAFETY: all pointers are references or null.
    let asked = unsafe {
        [
            carom_touch_energy(law.0, at, 1e-3, 1e-3, &mut number, none),
            carom_touch_report(law.0, at, &mut report, none),
            carom_touch_pack(law.0, at, room.as_mut_ptr(), none),
        ]
    };
    let mut all = asked.to_vec();
    all.push(status(garbled.load(law, &one, &second).map(drop)));
    all.push(status(garbled.clone().tried(law, (&one, &second), DT, None).map(drop)));
    all.push(status(garbled.clone().tried(law, (&one, &second), DT, Some(&mut heats)).map(drop)));
    let many = together(&[law], &mut touches, &[bodies; 9], DT, None).0;
    assert!(many.as_ref().err().is_none_or(|told| told.index == 2), "{many:?}");
    all.push(status(many));
    assert_eq!(all[6], all[4], "one by one or together");
    all
}

impl Touch {
    fn packed_room(&self, law: &Made) -> Vec<f64> {
        // SAFETY: a law.
        vec![0.0; unsafe { carom_touch_pack_size(law.0) }]
    }
}

#[test]
fn a_changed_word_of_a_touch_is_a_status_and_no_jump() {
    for law in LAWS {
        let plain = CaromLawOptions { relaxation: 1e-7, ..options(law) };
        let rolls = CaromLawOptions { rolling: ROLLING, ..plain };
        for its in [plain, rolls, CaromLawOptions { torsion: 1, ..rolls }] {
            let law = Made::new([GLASS; 2], 0.4, &its).unwrap();
            let mut whole = law.touch();
            for i in 1..40 {
                let [one, two] = meeting(DT * f64::from(i));
                whole.step(&law, &one, &Second::Grain(two), DT);
            }
            let (bodies, mut refused) = (meeting(40.0 * DT), 0);
            for at in 1..whole.words.len() {
                // Fields of rings are all alike.
                if its.law == CAROM_LAW_RINGS && (20..400).contains(&at) && at % 13 != 0 {
                    continue;
                }
                for word in WORDS {
                    let mut garbled = whole.clone();
                    garbled.words[at] = word;
                    let statuses = ask_all(&law, &garbled, &whole, bodies);
                    assert!(!statuses.contains(&CaromStatus::Internal), "{its:?} {at} {word:x}");
                    refused +=
                        usize::from(statuses.iter().all(|told| *told == CaromStatus::BadState));
                }
            }
            assert!(refused >= 10, "{its:?}: {refused}");
            // Another compiler or version is told apart by the mark.
            for bit in 0..64 {
                let mut strange = whole.clone();
                strange.words[0] ^= 1 << bit;
                let statuses = ask_all(&law, &strange, &whole, bodies);
                assert!(statuses.iter().all(|told| *told == CaromStatus::BadState), "{bit}");
            }
        }
    }
}
