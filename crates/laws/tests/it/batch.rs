//! Many contacts together: each as if alone, on any number of threads; on error none moves.

use carom_halfspace::operator::Threads;
use carom_laws::accounted::Accounted;
use carom_laws::batch::{Batch, BatchError};
use carom_laws::friction::Friction;
use carom_laws::law::{Checked, ContactLaw, ContactLoad, Shift};
use carom_laws::memory::Fixed;
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;
use carom_special::RangeError;

const CONTACTS: usize = 1000;

type Plane = ShiftLaw<[f64; 2], Fixed<[f64; 2], 16>>;

/// Laws of different stiffness, some without friction, some without slip.
fn laws() -> Vec<Plane> {
    (0..CONTACTS)
        .map(|i| {
            let t = i as f64 / CONTACTS as f64;
            let stiffness = ContactStiffness::new(0.8 + t, 1.0, 1.2 + t).unwrap();
            let friction = [0.3, 0.7, 0.0, f64::INFINITY][i % 4];
            ShiftLaw::new(stiffness, Friction::new(friction).unwrap())
        })
        .collect()
}

fn shifts(step: usize) -> Vec<Shift> {
    let at = |i: usize| {
        let (t, phase) = (0.3 * step as f64, i as f64);
        let zeta = 0.8 + (t + phase).sin();
        Shift { zeta, xi: (0.7 * t + phase).cos(), eta: 0.5 * (1.3 * t).sin(), omega: 0.1 }
    };
    (0..CONTACTS).map(at).collect()
}

fn advance<L>(law: L, threads: Threads) -> Vec<ContactLoad>
where
    L: Fn() -> Vec<Plane>,
{
    let mut batch = Batch::new(law(), threads);
    let mut loads = vec![ContactLoad::default(); CONTACTS];
    for step in 0..40 {
        batch.advance(&shifts(step), &mut loads).unwrap();
    }
    loads
}

#[test]
fn is_every_contact_by_itself_on_any_number_of_threads() {
    let mut single = laws();
    for step in 0..40 {
        for (law, shift) in single.iter_mut().zip(shifts(step)) {
            law.advance(shift).unwrap();
        }
    }
    let want: Vec<_> = single.iter().map(ContactLaw::load).collect();
    assert_eq!(advance(laws, Threads::One), want);
    for threads in [1, 2, 5] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        assert_eq!(pool.install(|| advance(laws, Threads::Pool)), want);
    }
}

fn change_none<L>(laws: Vec<L>, threads: Threads)
where
    L: Checked<Error = RangeError> + Send + Sync + PartialEq + Clone + std::fmt::Debug,
{
    let mut batch = Batch::new(laws, threads);
    let mut loads = vec![ContactLoad::default(); CONTACTS];
    batch.advance(&shifts(1), &mut loads).unwrap();
    let (before, written) = (batch.clone(), loads.clone());
    for bad in [f64::NAN, f64::INFINITY, -2e60] {
        let mut to = shifts(2);
        to[997].xi = bad;
        to[733].zeta = bad;
        to[801].eta = bad;
        let error = batch.advance(&to, &mut loads).unwrap_err();
        let BatchError::Range { contact: 733, error } = error else { panic!("{error}") };
        assert_eq!(error.field, "zeta");
        assert!(batch == before && loads == written);
    }
    let short = &shifts(2)[1..];
    let error = batch.advance(short, &mut loads).unwrap_err();
    assert_eq!(error, BatchError::Length { array: "shifts", length: 999, contacts: 1000 });
    let error = batch.advance(&shifts(2), &mut loads[1..]).unwrap_err();
    assert_eq!(error, BatchError::Length { array: "loads", length: 999, contacts: 1000 });
    assert!(batch == before && loads == written);
    // Separation of one contact is none of the others' business.
    let mut to = shifts(2);
    to[5].zeta = -1.0;
    batch.advance(&to, &mut loads).unwrap();
    assert!(loads[5] == ContactLoad::default() && loads[1].f_z > 0.0);
}

#[test]
fn batches_name_the_contact_and_change_none() {
    for threads in [Threads::One, Threads::Pool] {
        change_none(laws(), threads);
        change_none(laws().into_iter().map(Accounted::new).collect(), threads);
    }
}
