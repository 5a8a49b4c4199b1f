//! The two bodies of a contact: two grains, or a grain and a wall.

use carom_laws::grains::{Apart, Grain, Meeting, Surface};
use carom_special::RangeError;

use crate::error::{CaromStatus, Failure};
use crate::law::CaromLaw;
use crate::pointers::read;

/// Two bodies that may touch.
pub(crate) trait Bodies: Copy {
    /// What is known of bodies that can meet.
    type Apart: Copy;

    /// Checks that they can meet.
    fn apart(self) -> Result<Self::Apart, RangeError>;

    /// Their relative position and motion at the contact.
    fn meeting(self, apart: Self::Apart, law: &CaromLaw) -> Meeting;

    fn radii(self) -> [f64; 2];
}

/// Body 2.
#[derive(Clone, Copy)]
pub(crate) enum Second<'a> {
    Grain(&'a Grain),
    Wall(&'a Surface),
}

impl Second<'_> {
    /// Exactly one of both is given.
    ///
    /// # Safety
    /// The pointers are null, or may be read.
    #[inline(always)]
    pub(crate) unsafe fn of<'a>(
        two: *const Grain,
        wall: *const Surface,
    ) -> Result<Second<'a>, Failure> {
        // SAFETY: the caller's promise.
        unsafe {
            match wall.is_null() {
                true => Ok(Second::Grain(read(two, "two")?)),
                false if two.is_null() => Ok(Second::Wall(read(wall, "wall")?)),
                false => Err(both()),
            }
        }
    }
}

#[cold]
fn both() -> Failure {
    let text = "wall and two are both given: one of them must be a null pointer";
    Failure::new(CaromStatus::OutOfRange, "wall", text)
}

impl Bodies for [&Grain; 2] {
    type Apart = Apart;

    #[inline(always)]
    fn apart(self) -> Result<Apart, RangeError> {
        let [one, two] = self;
        Apart::of(one, two)
    }

    #[inline(always)]
    fn meeting(self, apart: Apart, law: &CaromLaw) -> Meeting {
        Meeting::of_apart(self, &apart, law.shares)
    }

    #[inline(always)]
    fn radii(self) -> [f64; 2] {
        self.map(|grain| grain.radius)
    }
}

impl Bodies for (&Grain, &Surface) {
    type Apart = ();

    #[inline]
    fn apart(self) -> Result<(), RangeError> {
        let Surface { normal, axis, .. } = *self.1;
        let square = dot(normal, normal);
        let holds = (square - 1.0).abs() < 1e-9;
        RangeError::check("normal", square.sqrt(), holds, "of length 1")?;
        let [square, along] = [axis, normal].map(|v| dot(axis, v));
        let (length, holds) = (square.sqrt(), square == 0.0 || (square - 1.0).abs() < 1e-9);
        RangeError::check("axis", length, holds, "of length 0 or 1")?;
        RangeError::check("axis", along, along.abs() < 1e-9, "across the normal").map(|_| ())
    }

    #[inline]
    fn meeting(self, (): (), law: &CaromLaw) -> Meeting {
        let (grain, wall) = self;
        Meeting::on_surface(grain, wall, law.shares[0])
    }

    #[inline(always)]
    fn radii(self) -> [f64; 2] {
        [self.0.radius, f64::INFINITY]
    }
}

#[inline(always)]
fn dot([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    a * x + b * y + c * z
}
