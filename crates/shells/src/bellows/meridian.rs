//! Meridians of one corrugation.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use carom_special::RangeError;

/// A place on a meridian.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeridianPoint {
    /// Distance from the axis, r0.
    pub radius: f64,
    /// Height above the crest at xi = 0, z0.
    pub height: f64,
    /// Angle phi0 of the tangent with the radial direction.
    pub angle: f64,
    /// Arc length per unit of the parameter, g = ds/dxi.
    pub speed: f64,
}

/// The meridian of one corrugation by a parameter xi of period 2 pi: a crest at 0, a root at pi,
/// symmetric about both.
///
/// ```
/// use carom_shells::bellows::Meridian;
/// let fold = Meridian::u_shaped(10.0, 0.5, 1.0)?;
/// assert_eq!(fold.pitch(), 2.0);
/// assert_eq!(fold.at(0.0).radius, 11.0); // half of the height 2 a + l outside the mean radius
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meridian {
    mean_radius: f64,
    shape: Shape,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Shape {
    Sine { amplitude: f64, pitch: f64 },
    Folded { arc: f64, straight: f64, turn: f64 },
    Torus { arc: f64 },
}

impl Meridian {
    /// r0 = R + b cos xi, z0 = pitch xi/(2 pi). `amplitude` = b = 0 is a straight tube.
    ///
    /// # Errors
    /// [`RangeError`] unless R and pitch are positive, b is from 0 to 0.9 R, and the pitch from
    /// 1e-3 b to 100 R.
    pub fn sine(mean_radius: f64, amplitude: f64, pitch: f64) -> Result<Self, RangeError> {
        let mean_radius = RangeError::positive("mean_radius", mean_radius)?;
        let fits = (0.0..=0.9 * mean_radius).contains(&amplitude);
        RangeError::check("amplitude", amplitude, fits, "from 0 to 0.9 mean_radius")?;
        let pitch = RangeError::positive("pitch", pitch)?;
        let fits = pitch >= 1e-3 * amplitude && pitch <= 100.0 * mean_radius;
        RangeError::check("pitch", pitch, fits, "from amplitude/1000 to 100 mean_radius")?;
        Ok(Self { mean_radius, shape: Shape::Sine { amplitude, pitch } })
    }

    /// Half circles of radius `arc` at crest and root, joined by flat annular plates of width
    /// `straight` >= 0; pitch 4 arc, height 2 arc + straight about the mean radius.
    ///
    /// # Errors
    /// As for [`Meridian::folded`].
    pub fn u_shaped(mean_radius: f64, arc: f64, straight: f64) -> Result<Self, RangeError> {
        Self::folded(mean_radius, arc, straight, FRAC_PI_2)
    }

    /// Arcs of radius `arc` at crest and root that turn by `turn` to each side, joined by cones of
    /// length `straight` >= 0. With `turn` > pi/2 the folds are narrower at their mouths.
    ///
    /// # Errors
    /// [`RangeError`] unless mean radius and arc are positive, `turn` is from 0.05 to 3, the height
    /// is at most 1.8 mean radii, the meridian rises from fold to fold, and neighbouring folds do
    /// not meet: a meridian that cuts itself is refused, by the field `straight`.
    pub fn folded(
        mean_radius: f64,
        arc: f64,
        straight: f64,
        turn: f64,
    ) -> Result<Self, RangeError> {
        let mean_radius = RangeError::positive("mean_radius", mean_radius)?;
        let arc = RangeError::positive("arc", arc)?;
        let straight = RangeError::non_negative("straight", straight)?;
        RangeError::check("turn", turn, (0.05..=3.0).contains(&turn), "from 0.05 to 3")?;
        let meridian = Self { mean_radius, shape: Shape::Folded { arc, straight, turn } };
        let height = 2.0 * (meridian.at(0.0).radius - mean_radius);
        let allowed = "at most 1.8 mean_radius";
        RangeError::check("height", height, height <= 1.8 * mean_radius, allowed)?;
        let is_apart = meridian.least_gap() > 0.0;
        let allowed = "so short that the meridian does not cut itself";
        RangeError::check("straight", straight, is_apart, allowed)?;
        Ok(meridian)
    }

    /// A circle of radius `arc` about the mean radius, slit at its inside: the toroidal bellows
    /// (Omega joint). The dilatation is the gape of the slit.
    ///
    /// # Errors
    /// [`RangeError`] unless both are positive and arc <= 0.9 mean radius.
    pub fn torus(mean_radius: f64, arc: f64) -> Result<Self, RangeError> {
        let mean_radius = RangeError::positive("mean_radius", mean_radius)?;
        let fits = arc > 0.0 && arc <= 0.9 * mean_radius;
        RangeError::check("arc", arc, fits, "> 0 and <= 0.9 mean_radius")?;
        Ok(Self { mean_radius, shape: Shape::Torus { arc } })
    }

    /// Mean radius of crest and root.
    #[must_use]
    pub const fn mean_radius(&self) -> f64 {
        self.mean_radius
    }

    /// Length of a corrugation along the axis; 0 for a torus.
    #[must_use]
    pub fn pitch(&self) -> f64 {
        match self.shape {
            Shape::Sine { pitch, .. } => pitch,
            Shape::Folded { .. } => 2.0 * self.on_half(PI).height,
            Shape::Torus { .. } => 0.0,
        }
    }

    /// The place of the parameter; it may be any number.
    #[must_use]
    pub fn at(&self, parameter: f64) -> MeridianPoint {
        let turns = (parameter / TAU).floor();
        let within = parameter - TAU * turns;
        let mut place = if within <= PI {
            self.on_half(within)
        } else {
            let image = self.on_half(TAU - within);
            MeridianPoint { height: self.pitch() - image.height, angle: PI - image.angle, ..image }
        };
        if let (Shape::Torus { .. }, true) = (self.shape, within > PI) {
            place.angle += TAU; // once around
        }
        place.height += turns * self.pitch();
        place
    }

    /// From crest to root.
    fn on_half(&self, xi: f64) -> MeridianPoint {
        let mean = self.mean_radius;
        match self.shape {
            Shape::Sine { amplitude, pitch } => {
                let rise = pitch / TAU;
                let fall = -amplitude * libm::sin(xi);
                MeridianPoint {
                    radius: mean + amplitude * libm::cos(xi),
                    height: rise * xi,
                    angle: libm::atan2(rise, fall),
                    speed: libm::hypot(rise, fall),
                }
            }
            Shape::Folded { arc, straight, turn } => Fold { arc, straight, turn }.at(mean, xi),
            Shape::Torus { arc } => MeridianPoint {
                radius: mean + arc * libm::cos(xi),
                height: arc * libm::sin(xi),
                angle: FRAC_PI_2 + xi,
                speed: arc,
            },
        }
    }

    /// The least radius of curvature of the meridian; infinite for a straight tube.
    #[must_use]
    pub fn least_curvature_radius(&self) -> f64 {
        match self.shape {
            Shape::Sine { amplitude, pitch } => {
                let rise = pitch / TAU;
                rise * rise / amplitude
            }
            Shape::Folded { arc, .. } | Shape::Torus { arc } => arc,
        }
    }

    /// Whether curvature is continuous, so that series converge exponentially.
    #[must_use]
    pub const fn is_smooth(&self) -> bool {
        !matches!(self.shape, Shape::Folded { .. })
    }

    /// Whether it is a ring of its own, without neighbours outside.
    pub const fn is_closed(&self) -> bool {
        matches!(self.shape, Shape::Torus { .. })
    }

    /// The least distance along the axis of neighbouring folds, both inside a fold and between two:
    /// twice the least distance from the plane of its crest, on the inner half of the meridian, or
    /// of its root, on the outer half. Of a torus, the distance at its slit, 0.
    #[must_use]
    pub fn least_gap(&self) -> f64 {
        let count = 256;
        let heights =
            (0..=count).map(|i| self.on_half(PI * f64::from(i) / f64::from(count)).height);
        least_gap(&heights.collect::<Vec<_>>(), self.is_closed())
    }
}

/// The least gap of a half meridian of heights at equal steps of the parameter, crest first.
pub(super) fn least_gap(heights: &[f64], is_closed: bool) -> f64 {
    let (Some(first), Some(last)) = (heights.first(), heights.last()) else { return 0.0 };
    let middle = heights.len() / 2;
    let inner = heights[middle..].iter().map(|height| height - first);
    let outer = if is_closed { &[] } else { &heights[..=middle] };
    let outer = outer.iter().map(|height| last - height);
    2.0 * inner.chain(outer).fold(f64::INFINITY, f64::min)
}

/// Two arcs with a straight line between, from crest to root.
struct Fold {
    arc: f64,
    straight: f64,
    turn: f64,
}

impl Fold {
    fn at(&self, mean: f64, xi: f64) -> MeridianPoint {
        let length = 2.0 * self.arc * self.turn + self.straight;
        let s = length * xi / PI;
        let speed = length / PI;
        let half_height =
            self.arc * (1.0 - rise(self.turn)) + 0.5 * self.straight * libm::sin(self.turn);
        let half_pitch = 2.0 * self.arc * libm::sin(self.turn) + self.straight * rise(self.turn);
        let from_crest = self.first_half(s.min(length - s));
        let is_first = 2.0 * s <= length;
        let (radius, height) = if is_first {
            (mean + half_height - from_crest.radius, from_crest.height)
        } else {
            (mean - half_height + from_crest.radius, half_pitch - from_crest.height)
        };
        MeridianPoint { radius, height, angle: from_crest.angle, speed }
    }

    /// How far it has gone inward and up after a length s of at most half.
    fn first_half(&self, s: f64) -> MeridianPoint {
        let turned = (s / self.arc).min(self.turn);
        let straight = (s - self.arc * self.turn).max(0.0);
        MeridianPoint {
            radius: self.arc * (1.0 - libm::cos(turned)) + straight * libm::sin(self.turn),
            height: self.arc * libm::sin(turned) + straight * rise(self.turn),
            angle: FRAC_PI_2 + turned,
            speed: 1.0,
        }
    }
}

/// Cosine of the angle that the arcs turn; exactly 0 for flat plates.
fn rise(turn: f64) -> f64 {
    if turn == FRAC_PI_2 { 0.0 } else { libm::cos(turn) }
}
