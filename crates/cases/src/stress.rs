//! The stresses below a contact under normal and tangential load.

use crate::Error;
use crate::Pressed;
use crate::case::{Given, StressCase};
use crate::input::CaseFile;
use carom_halfspace::{Material, Point, Stress, Traction};
use carom_laws::validity::Validity;
use carom_special::{RangeError, interrupt};
use carom_table::Column;
use rayon::prelude::*;

/// The stress at a point, in the axes of the contact.
#[derive(Debug, Clone, Copy)]
pub struct StressPoint {
    /// x, y and depth.
    pub at: [f64; 3],
    /// The stress, tension positive.
    pub stress: Stress,
}

impl StressPoint {
    /// The columns of a point.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("x", "m", "along the larger relative curvature", |point| point.at[0].into()),
        Column::new("y", "m", "perpendicular to x", |point| point.at[1].into()),
        Column::new("depth", "m", "below the surface", |point| point.at[2].into()),
        Column::new("s_xx", "Pa", "stress, tension positive; z points into body 1", |p| {
            p.stress.xx.into()
        }),
        Column::new("s_yy", "Pa", "", |point| point.stress.yy.into()),
        Column::new("s_zz", "Pa", "", |point| point.stress.zz.into()),
        Column::new("s_xy", "Pa", "", |point| point.stress.xy.into()),
        Column::new("s_yz", "Pa", "", |point| point.stress.yz.into()),
        Column::new("s_zx", "Pa", "", |point| point.stress.zx.into()),
        Column::new("von_mises", "Pa", "equivalent stress", |p| p.stress.von_mises().into()),
        Column::new("maximum_shear", "Pa", "half of Tresca's equivalent stress", |point| {
            point.stress.maximum_shear().into()
        }),
    ];
}

/// A contact under its load, and the stresses at all points.
#[derive(Debug, Clone)]
pub struct Solved {
    /// The case.
    pub case: StressCase,
    /// The contact under its normal force.
    pub state: Pressed,
    /// Width of the stick area over that of the contact.
    pub stick_radius: f64,
    /// The points: for each depth, for each y, for each x.
    pub points: Vec<StressPoint>,
    /// The point of greatest equivalent stress, found by a search that starts at the greatest of the
    /// points and goes on between them.
    pub greatest: StressPoint,
    /// The point of greatest shear stress, found likewise; it is another one.
    pub greatest_shear: StressPoint,
}

impl Solved {
    /// How far the contact is from the limits of the theory.
    #[must_use]
    pub fn validity(&self) -> Validity {
        self.state.validity(&self.case.contact, self.case.smallest_radius)
    }
}

/// Computes the stresses at all points of a case, in parallel.
///
/// # Errors
/// If the case has an error, or a value is out of range.
pub fn solved(file: &CaseFile) -> Result<Solved, Error> {
    let case = file.parse::<StressCase>()?;
    file.follow(|| Ok(at_all_points(case)?))
}

fn at_all_points(case: StressCase) -> Result<Solved, RangeError> {
    let state = case.contact.at(Given::Force, case.force[2])?;
    let stick_radius = stick_radius(&case, &state);
    let field = StressField::new(&case, &state, stick_radius);
    let points = field.at_all(&case.places)?;
    let greatest = |size: fn(&Stress) -> f64| field.greatest(&case.places, &points, size);
    let (greatest, greatest_shear) =
        (greatest(Stress::von_mises)?, greatest(Stress::maximum_shear)?);
    Ok(Solved { case, state, stick_radius, points, greatest, greatest_shear })
}

/// a*/a of Cattaneo and Mindlin.
fn stick_radius(case: &StressCase, state: &Pressed) -> f64 {
    let [x, y, normal] = case.force;
    let pushed = libm::hypot(x, y);
    if pushed == 0.0 { 1.0 } else { state.stick_width(pushed / (case.friction * normal)) }
}

/// The stresses in one body under its tractions.
struct StressField {
    state: Pressed,
    stick_radius: f64,
    body: Material,
    /// The tractions where the pressure is greatest, if that place slips.
    peak: Traction,
    /// 1 in body 1, -1 in body 2.
    side: f64,
}

/// The search for the greatest stress ends with steps of this part of the first ones, and of the contact.
const FINEST: f64 = 1e-7;
/// More rounds of the search than any takes: some 25 halvings an axis, and moves between them.
const MOST_ROUNDS: usize = 2000;

impl StressField {
    fn new(case: &StressCase, state: &Pressed, stick_radius: f64) -> Self {
        let [x, y, _] = case.force;
        let pushed = libm::hypot(x, y);
        let [unit_x, unit_y] = if pushed > 0.0 { [x / pushed, y / pushed] } else { [0.0; 2] };
        // Body 2 feels the opposite traction; seen from inside it, the normal points the other way.
        let (body, side) = match case.is_in_body_1 {
            true => (case.contact.materials().body_1(), 1.0),
            false => (case.contact.materials().body_2(), -1.0),
        };
        let limit = side * case.friction * state.peak_pressure();
        let peak = Traction { x: limit * unit_x, y: limit * unit_y, normal: state.peak_pressure() };
        Self { state: *state, stick_radius, body, peak, side }
    }

    /// The stress at a point; nothing after an interrupt.
    fn at(&self, at: [f64; 3]) -> Result<StressPoint, RangeError> {
        if interrupt::is_wanted() {
            return Ok(StressPoint { at, stress: Stress::default() });
        }
        let point = Point { x: at[0], y: at[1], z: at[2] };
        let s = self.state.stress(self.body, self.peak, self.stick_radius, point)?;
        let stress = Stress { yz: self.side * s.yz, zx: self.side * s.zx, ..s };
        Ok(StressPoint { at, stress })
    }

    /// The stresses at all points: for each depth, for each y, for each x.
    fn at_all(&self, [xs, ys, depths]: &[Vec<f64>; 3]) -> Result<Vec<StressPoint>, RangeError> {
        let ask = interrupt::asked();
        let at = |i: usize| {
            let (column, rest) = (i % xs.len(), i / xs.len());
            let place = [xs[column], ys[rest % ys.len()], depths[rest / ys.len()]];
            interrupt::under(ask.clone(), || self.at(place))
        };
        (0..xs.len() * ys.len() * depths.len()).into_par_iter().map(at).collect()
    }

    /// The point between the places at which a measure of the stress is greatest: from the greatest of the points
    /// along each axis to either side, with half the step of an axis where it does not lead up.
    fn greatest(
        &self,
        places: &[Vec<f64>; 3],
        points: &[StressPoint],
        measure: fn(&Stress) -> f64,
    ) -> Result<StressPoint, RangeError> {
        let size = |point: &StressPoint| measure(&point.stress);
        let mut best = points
            .iter()
            .fold(points[0], |best, point| if size(point) > size(&best) { *point } else { best });
        let ends = places.each_ref().map(|places| {
            places.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], place| {
                [low.min(*place), high.max(*place)]
            })
        });
        let steps = [0, 1, 2].map(|axis| {
            let parts = (places[axis].len() - 1).max(1) as f64;
            (ends[axis][1] - ends[axis][0]) / parts
        });
        let finest = steps.map(|step| FINEST * step.min(self.state.widest()));
        let mut way = steps;
        for _ in 0..MOST_ROUNDS {
            for axis in (0..3).filter(|axis| steps[*axis] > 0.0) {
                let from = best;
                for by in [-way[axis], way[axis]] {
                    let mut at = from.at;
                    at[axis] = (at[axis] + by).clamp(ends[axis][0], ends[axis][1]);
                    let point = self.at(at)?;
                    if size(&point) > size(&best) {
                        best = point;
                    }
                }
                let is_better = size(&best) > size(&from);
                way[axis] =
                    if is_better { steps[axis].min(2.0 * way[axis]) } else { 0.5 * way[axis] };
            }
            if (0..3).all(|axis| way[axis] <= finest[axis]) {
                break;
            }
        }
        Ok(best)
    }
}
