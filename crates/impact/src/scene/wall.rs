//! A wall: a plane, infinite or rectangular.

use carom_halfspace::Material;
use carom_special::RangeError;
use nalgebra::Vector3;
use std::borrow::Cow;

use super::flight::{Flight, along};
use super::roots::falls;
use super::wall_motion::WallMotion;
use crate::impact_friction::ImpactFriction;
use crate::normal_restitution::NormalRestitution;

/// A wall: the surface of a half-space, which may move, or a thin rectangular plate that can be hit from both sides.
///
/// ```
/// use carom_halfspace::Material;
/// use carom_impact::scene::Wall;
/// use carom_laws::friction::Friction;
/// let (steel, f) = (Material::from_shear(80e9, 0.3)?, Friction::new(0.2)?);
/// let table = Wall::new([0.0; 3], [0.0, 0.0, 1.0], steel, f)?;
/// let book = Wall::new([0.3, 0.0, 0.1], [0.0, 0.0, -1.0], steel, f)?
///     .rectangle([1.0, 0.0, 0.0], [0.15, 0.1])?;
/// assert_eq!(book.corners().map(|corners| corners[0].x), Some(0.15));
/// assert_eq!(table.corners(), None);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Wall {
    point: Vector3<f64>,
    normal: Vector3<f64>,
    extent: Extent,
    material: Material,
    friction: ImpactFriction,
    normal_restitution: NormalRestitution,
    rolling_resistance: f64,
    motion: Option<WallMotion>,
}

/// The extent of a wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Extent {
    /// Infinite.
    Infinite,
    /// A rectangle about the wall's point.
    Rectangle {
        /// Unit vectors along its sides.
        axes: [Vector3<f64>; 2],
        /// Half its lengths along them.
        half_lengths: [f64; 2],
    },
}

/// The part of a wall that the ball touches first, and when.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Meeting {
    /// A face, with the normal into the ball.
    Face { time: f64, normal: Vector3<f64> },
    /// An edge or a corner of a rectangle.
    Edge { time: f64 },
}

impl Meeting {
    pub(super) const fn time(&self) -> f64 {
        match self {
            Self::Face { time, .. } | Self::Edge { time } => *time,
        }
    }
}

impl Wall {
    /// The half-space below the plane through `point`; `normal` is the outward normal and need not be of unit
    /// length.
    ///
    /// # Errors
    /// [`RangeError`] for a point that is not finite, or a normal that is zero or not finite.
    pub fn new(
        point: [f64; 3],
        normal: [f64; 3],
        material: Material,
        friction: impl Into<ImpactFriction>,
    ) -> Result<Self, RangeError> {
        for value in point {
            RangeError::finite("point", value)?;
        }
        let normal = unit("normal", normal)?;
        Ok(Self {
            point: point.into(),
            normal,
            extent: Extent::Infinite,
            material,
            friction: friction.into(),
            normal_restitution: NormalRestitution::ELASTIC,
            rolling_resistance: 0.0,
            motion: None,
        })
    }

    /// Restricts the wall to a thin rectangle about its point, which can be hit from both sides. One pair of
    /// its sides lies along `along` (made perpendicular to the normal); their lengths are twice
    /// `half_lengths`.
    ///
    /// # Errors
    /// [`RangeError`] if `along` is not finite, zero or parallel to the normal, or a half length
    /// is not finite and positive.
    pub fn rectangle(self, along: [f64; 3], half_lengths: [f64; 2]) -> Result<Self, RangeError> {
        let along = unit("along", along)?;
        let inside = along - along.dot(&self.normal) * self.normal;
        let length = inside.norm();
        RangeError::check("along", length, length > 1e-8, "not parallel to the normal")?;
        for value in half_lengths {
            RangeError::positive("half length", value)?;
        }
        // The difference cancels where both directions are nearly parallel: what is left of the normal is taken out again.
        let first = (inside - inside.dot(&self.normal) * self.normal).normalize();
        let axes = [first, self.normal.cross(&first)];
        Ok(Self { extent: Extent::Rectangle { axes, half_lengths }, ..self })
    }

    /// A wall off which the ball bounces with a loss in the material, [`NormalRestitution`].
    #[must_use]
    pub fn with_normal_restitution(self, normal_restitution: NormalRestitution) -> Self {
        Self { normal_restitution, ..self }
    }

    /// A wall that resists a ball that turns on it with the torque mu_r R F_z against its spin along the wall.
    ///
    /// # Errors
    /// [`RangeError`] unless mu_r is finite and not negative.
    pub fn with_rolling_resistance(self, coefficient: f64) -> Result<Self, RangeError> {
        let rolling_resistance = RangeError::non_negative("rolling_resistance", coefficient)?;
        Ok(Self { rolling_resistance, ..self })
    }

    /// A wall that moves, without turning; only an infinite one.
    ///
    /// # Errors
    /// [`RangeError`] for a rectangle, named by half of its first length.
    pub fn with_motion(self, motion: WallMotion) -> Result<Self, RangeError> {
        match self.extent {
            Extent::Infinite => Ok(Self { motion: Some(motion), ..self }),
            Extent::Rectangle { half_lengths: [half, _], .. } => {
                Err(RangeError::new("half length", half, "absent: a wall that moves is infinite"))
            }
        }
    }

    /// Its motion; None if it is fixed.
    #[must_use]
    pub const fn motion(&self) -> Option<&WallMotion> {
        self.motion.as_ref()
    }

    /// The wall where it is at a time.
    pub(super) fn placed(&self, time: f64) -> Cow<'_, Self> {
        match &self.motion {
            None => Cow::Borrowed(self),
            Some(motion) => {
                Cow::Owned(Self { point: self.point + motion.displacement(time), ..self.clone() })
            }
        }
    }

    /// Its velocity at a time.
    pub(super) fn velocity(&self, time: f64) -> Vector3<f64> {
        self.motion.as_ref().map_or_else(Vector3::zeros, |motion| motion.velocity(time))
    }

    /// Its acceleration at a time.
    pub(super) fn acceleration(&self, time: f64) -> Vector3<f64> {
        self.motion.as_ref().map_or_else(Vector3::zeros, |motion| motion.acceleration(time))
    }

    /// mu_r of the torque that resists rolling.
    #[must_use]
    pub const fn rolling_resistance(&self) -> f64 {
        self.rolling_resistance
    }

    /// A point of the plane; the centre of a rectangle.
    #[must_use]
    pub const fn point(&self) -> Vector3<f64> {
        self.point
    }

    /// The unit normal.
    #[must_use]
    pub const fn normal(&self) -> Vector3<f64> {
        self.normal
    }

    /// Its extent.
    #[must_use]
    pub const fn extent(&self) -> Extent {
        self.extent
    }

    /// Its material.
    #[must_use]
    pub const fn material(&self) -> Material {
        self.material
    }

    /// Friction between it and the ball. Each bounce evaluates it at its slip speed.
    #[must_use]
    pub const fn friction(&self) -> ImpactFriction {
        self.friction
    }

    /// The loss in the material of a bounce.
    #[must_use]
    pub const fn normal_restitution(&self) -> &NormalRestitution {
        &self.normal_restitution
    }

    /// The corners of a rectangle, in order around it; None for an infinite plane.
    #[must_use]
    pub fn corners(&self) -> Option<[Vector3<f64>; 4]> {
        let Extent::Rectangle { axes: [u, v], half_lengths: [a, b] } = self.extent else {
            return None;
        };
        let corner = |s: f64, t: f64| self.point + s * a * u + t * b * v;
        Some([corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)])
    }

    /// Distance of a ball's surface from the wall; negative inside.
    #[must_use]
    pub fn gap(&self, centre: &Vector3<f64>, radius: f64) -> f64 {
        let offset = centre - self.point;
        let height = offset.dot(&self.normal);
        match self.extent {
            Extent::Infinite => height - radius,
            Extent::Rectangle { axes, half_lengths } => {
                let beyond = |i: usize| (offset.dot(&axes[i]).abs() - half_lengths[i]).max(0.0);
                Vector3::new(height, beyond(0), beyond(1)).norm() - radius
            }
        }
    }

    // Round-off of a gap.
    pub(super) fn tolerance(&self, centre: &Vector3<f64>, radius: f64) -> f64 {
        1e-12 * (radius + centre.amax() + self.point.amax())
    }

    /// The normal of the face above or below which a place lies; None beside a rectangle.
    pub(super) fn face(&self, place: &Vector3<f64>) -> Option<Vector3<f64>> {
        let height = (place - self.point).dot(&self.normal);
        self.holds(place).then(|| self.side(height) * self.normal)
    }

    /// When a ball that moves on a rectangle with a constant acceleration comes to its edge.
    pub(super) fn rim(&self, flight: &Flight) -> Option<f64> {
        let Extent::Rectangle { axes, half_lengths } = self.extent else { return None };
        let offset = flight.position - self.point;
        let mut first: Option<f64> = None;
        for (axis, half) in axes.iter().zip(half_lengths) {
            for outwards in [*axis, -axis] {
                let gap = (half - offset.dot(&outwards)).max(0.0);
                if let Some(time) = flight.closing(gap, &-outwards) {
                    first = Some(first.map_or(time, |first| first.min(time)));
                }
            }
        }
        first
    }

    pub(super) fn holds(&self, place: &Vector3<f64>) -> bool {
        let Extent::Rectangle { axes, half_lengths } = self.extent else {
            return true;
        };
        let offset = place - self.point;
        (0..2).all(|i| offset.dot(&axes[i]).abs() <= half_lengths[i])
    }

    /// The normal of a face on which the ball rests, pressed on by gravity.
    pub(super) fn pressed(&self, flight: &Flight, radius: f64) -> Option<Vector3<f64>> {
        let height = (flight.position - self.point).dot(&self.normal);
        let normal = self.side(height) * self.normal;
        let touches = self.gap(&flight.position, radius)
            <= self.tolerance(&flight.position, radius)
            && self.holds(&flight.position);
        let still =
            along(&flight.velocity, &normal) == 0.0 && along(&flight.gravity, &normal) < 0.0;
        (touches && still).then_some(normal)
    }

    fn side(&self, height: f64) -> f64 {
        if self.extent == Extent::Infinite || height >= 0.0 { 1.0 } else { -1.0 }
    }

    /// The first contact of a ball with the wall in a flight that begins at `start`, up to the time `end` after that.
    pub(super) fn meeting(
        &self,
        start: f64,
        flight: &Flight,
        radius: f64,
        end: f64,
    ) -> Result<Option<Meeting>, RangeError> {
        let Some(motion) = &self.motion else {
            return Ok(self.still_meeting(flight, radius, end));
        };
        let wall = self.placed(start);
        let gap = wall.gap(&flight.position, radius);
        let gap = if gap <= wall.tolerance(&flight.position, radius) { 0.0 } else { gap };
        let time = motion.closing(start, flight, gap, &self.normal, end)?;
        Ok(time.map(|time| Meeting::Face { time, normal: self.normal }))
    }

    /// The same of a fixed wall.
    fn still_meeting(&self, flight: &Flight, radius: f64, end: f64) -> Option<Meeting> {
        let height = (flight.position - self.point).dot(&self.normal);
        let slack = self.tolerance(&flight.position, radius);
        let face = |sign: f64| {
            let normal = sign * self.normal;
            let gap = sign * height - radius;
            let whole = self.extent == Extent::Infinite;
            let gap = if gap.abs() <= slack || (whole && gap < 0.0) { 0.0 } else { gap };
            let time = flight.closing(gap, &normal)?;
            let foot = flight.position_after(time);
            (time <= end && self.holds(&foot)).then_some(Meeting::Face { time, normal })
        };
        let above = face(1.0);
        if self.extent == Extent::Infinite {
            return above;
        }
        let first = earlier(above, face(-1.0));
        let end = first.map_or(end, |meeting| meeting.time());
        earlier(first, self.edge(flight, radius, end).map(|time| Meeting::Edge { time }))
    }

    // The first contact with an edge or a corner, if before `end`: a face comes first.
    fn edge(&self, flight: &Flight, radius: f64, end: f64) -> Option<f64> {
        let corners = self.corners()?;
        let mut first: Option<f64> = None;
        let mut take = |time: f64| {
            if time < first.unwrap_or(end) {
                first = Some(time);
            }
        };
        for (i, corner) in corners.iter().enumerate() {
            falls(&flight.distance_polynomial(corner, None, radius), end, &mut take);
            let edge = corners[(i + 1) % 4] - corner;
            let length = edge.norm();
            let axis = edge / length;
            falls(&flight.distance_polynomial(corner, Some(&axis), radius), end, |time| {
                let along = (flight.position_after(time) - corner).dot(&axis);
                if (0.0..=length).contains(&along) {
                    take(time);
                }
            });
        }
        first
    }
}

// The first of two meetings; the first named if they come together.
fn earlier(one: Option<Meeting>, other: Option<Meeting>) -> Option<Meeting> {
    match (one, other) {
        (Some(a), Some(b)) => Some(if b.time() < a.time() { b } else { a }),
        (a, b) => a.or(b),
    }
}

fn unit(field: &'static str, vector: [f64; 3]) -> Result<Vector3<f64>, RangeError> {
    for value in vector {
        RangeError::finite(field, value)?;
    }
    let vector = Vector3::from(vector);
    let largest = vector.amax();
    RangeError::check(field, largest, largest > 0.0, "a vector other than zero")?;
    // Scaled first: no overflow.
    let scaled = vector / largest;
    Ok(scaled / scaled.norm())
}
