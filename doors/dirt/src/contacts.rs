//! The contacts of all grains, as DIRT stores data of atoms.

use std::any::Any;

use carom_laws::grains::grain_numbers;
use carom_special::RangeError;
use soil_core::AtomData;

use crate::pairs::{Contact, Pair, VERTICES};

/// Numbers that a contact takes when an atom is sent to another process.
const NUMBERS: usize = grain_numbers(VERTICES);

/// A contact, or the numbers of one that came from another process and waits for its constants.
#[derive(Clone)]
enum Touch {
    Live(Box<Contact>),
    Packed(Box<[f64; NUMBERS]>),
}

/// The contact of an atom with one partner.
#[derive(Clone)]
pub(crate) struct Entry {
    partner: u32,
    touch: Touch,
    is_active: bool,
}

impl Entry {
    /// A contact with the atom of this tag.
    pub(crate) fn new(partner: u32, contact: Contact) -> Self {
        Self { partner, touch: Touch::Live(Box::new(contact)), is_active: true }
    }

    /// The contact, for a step; it stays if the step is taken.
    pub(crate) fn live(
        &mut self,
        pair: &Pair,
        radii: [f64; 2],
    ) -> Result<&mut Contact, RangeError> {
        self.is_active = true;
        if let Touch::Packed(numbers) = &self.touch {
            let mut contact = pair.contact(radii)?;
            contact.unpack(&**numbers)?;
            self.touch = Touch::Live(Box::new(contact));
        }
        match &mut self.touch {
            Touch::Live(contact) => Ok(contact),
            Touch::Packed(_) => unreachable!("it was made live above"),
        }
    }

    fn numbers(&self) -> [f64; NUMBERS] {
        match &self.touch {
            Touch::Packed(numbers) => **numbers,
            Touch::Live(contact) => {
                let mut numbers = [0.0; NUMBERS];
                contact.pack(&mut numbers).expect("the room is that of a contact");
                numbers
            }
        }
    }
}

/// For each atom its contacts, each with the atom whose turn it is in DIRT's list of pairs.
#[derive(Clone, Default)]
pub(crate) struct Contacts(Vec<Vec<Entry>>);

impl Contacts {
    /// Before the forces of a step.
    pub(crate) fn begin(&mut self, atoms: usize) {
        if self.0.len() < atoms {
            self.0.resize_with(atoms, Vec::new);
        }
        self.0.iter_mut().flatten().for_each(|entry| entry.is_active = false);
    }

    /// After them: contacts that were not met have ended.
    pub(crate) fn end(&mut self) {
        self.0.iter_mut().for_each(|entries| entries.retain(|entry| entry.is_active));
    }

    /// The contact of atom `i` with the atom of a tag. If DIRT has changed the order of the pair, it is with the partner,
    /// atom `j`, and is moved here; if there is none, a new one begins.
    pub(crate) fn of(
        &mut self,
        [i, j]: [usize; 2],
        [own, partner]: [u32; 2],
        new: impl FnOnce() -> Result<Contact, RangeError>,
    ) -> Result<&mut Entry, RangeError> {
        let with = |entries: &[Entry], tag| entries.iter().position(|entry| entry.partner == tag);
        let at = match with(&self.0[i], partner) {
            Some(at) => at,
            None => {
                let entry = match with(&self.0[j], own).filter(|at| !self.0[j][*at].is_active) {
                    Some(at) => Entry { partner, ..self.0[j].swap_remove(at) },
                    None => Entry::new(partner, new()?),
                };
                self.0[i].push(entry);
                self.0[i].len() - 1
            }
        };
        Ok(&mut self.0[i][at])
    }
}

// DIRT marks what changes single columns as unsafe, since all columns must change together. Nothing unsafe is done here.
#[allow(unsafe_code)]
impl AtomData for Contacts {
    fn as_any(&self) -> &dyn Any {
        self
    }

    fn as_any_mut(&mut self) -> &mut dyn Any {
        self
    }

    fn snapshot(&self) -> Box<dyn AtomData> {
        Box::new(self.clone())
    }

    fn len(&self) -> usize {
        self.0.len()
    }

    unsafe fn push_default(&mut self) {
        self.0.push(Vec::new());
    }

    unsafe fn truncate(&mut self, count: usize) {
        self.0.resize_with(count, Vec::new);
    }

    unsafe fn swap_remove(&mut self, i: usize) {
        self.0.swap_remove(i);
    }

    unsafe fn apply_permutation(&mut self, order: &[usize], count: usize) {
        let sorted: Vec<_> = order[..count].iter().map(|&from| self.0[from].clone()).collect();
        self.0[..count].clone_from_slice(&sorted);
    }

    fn pack(&self, i: usize, buffer: &mut Vec<f64>) {
        let entries = self.0.get(i).map_or(&[][..], Vec::as_slice);
        buffer.push(entries.len() as f64);
        for entry in entries {
            buffer.push(f64::from(entry.partner));
            buffer.extend(entry.numbers());
        }
    }

    unsafe fn unpack(&mut self, buffer: &[f64]) -> usize {
        let count = buffer[0] as usize;
        let stored = buffer[1..].chunks_exact(1 + NUMBERS).take(count);
        let entry = |stored: &[f64]| {
            let mut numbers = Box::new([0.0; NUMBERS]);
            numbers.copy_from_slice(&stored[1..]);
            Entry { partner: stored[0] as u32, touch: Touch::Packed(numbers), is_active: false }
        };
        self.0.push(stored.map(entry).collect());
        1 + count * (1 + NUMBERS)
    }
}

#[cfg(test)]
#[allow(unsafe_code)]
mod tests {
    use super::*;
    use carom_laws::grains::{Grain, Meeting};

    use crate::pairs::Pairs;
    use crate::pairs::tests::glass;

    const RADII: [f64; 2] = [1e-3; 2];

    /// A grain above another, shifted along it, after a step.
    fn meeting(shift: f64) -> Meeting {
        let (mass, spin, radius) = (1e-5, [0.0; 3], RADII[0]);
        let below = Grain { place: [0.0; 3], velocity: [0.0; 3], spin, radius, mass };
        let place = [shift, 0.0, 1.999e-3];
        Meeting::of_spheres(&Grain { place, velocity: [0.1, 0.0, 0.0], ..below }, &below, [0.5; 2])
            .unwrap()
    }

    #[test]
    fn a_contact_is_found_with_either_atom_and_ends_when_it_is_not_met() {
        let pairs = Pairs::new(&glass()).unwrap();
        let mut contacts = Contacts::default();
        contacts.begin(2);
        contacts.of([0, 1], [7, 8], || pairs.of(0, 0).contact(RADII)).unwrap();
        contacts.end();
        contacts.begin(2);
        let entry = contacts.of([1, 0], [8, 7], || panic!("there is one")).unwrap();
        entry.live(pairs.of(0, 0), RADII).unwrap();
        contacts.end();
        assert_eq!(contacts.0.iter().map(Vec::len).collect::<Vec<_>>(), [0, 1]);
        contacts.begin(2);
        contacts.end();
        assert!(contacts.0.iter().all(Vec::is_empty));
    }

    #[test]
    fn a_contact_that_was_sent_goes_on_with_the_same_bits() {
        let pairs = Pairs::new(&glass()).unwrap();
        let pair = pairs.of(0, 0);
        let mut here = Contacts::default();
        here.begin(1);
        let contact = here.of([0, 0], [7, 8], || pair.contact(RADII)).unwrap();
        contact.live(pair, RADII).unwrap().advance(&meeting(1e-8), 1e-7).unwrap();
        let mut sent = Vec::new();
        here.pack(0, &mut sent);
        let mut there = Contacts::default();
        // SAFETY: there is no other column.
        assert_eq!(unsafe { there.unpack(&sent) }, sent.len());
        let next = |contacts: &mut Contacts| {
            let entry = contacts.of([0, 0], [7, 8], || panic!("it was sent")).unwrap();
            entry.live(pair, RADII).unwrap().advance(&meeting(2e-8), 1e-7).unwrap()
        };
        let load = next(&mut here);
        assert!(load.force[0] < 0.0);
        assert_eq!(load, next(&mut there));
    }
}
