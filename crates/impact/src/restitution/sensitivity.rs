//! The derivatives of R_x by the two numbers on which it depends.

use super::RestitutionTable;
use crate::closed_form::restitution_in_sliding;
use crate::oblique::{Groups, ObliqueError, ObliqueImpact, Regime};

/// Relative step of the differences: the exact impact has no error that shows in it.
const STEP: f64 = 1e-5;
/// Relative step of the curvature, which the table gives within 1e-8.
const CURVED: f64 = 4e-3;
/// Step of differences near a change, over the distance from it.
const SHARE_OF_REACH: f64 = 4e-4;
/// Smallest relative step: on a change itself.
const SMALLEST: f64 = 1e-7;
/// What curvatures by two widths may differ by, times the step.
const SURE: f64 = 1e-8;
/// Smallest psi by which a step is measured.
const LEAST: f64 = 0.05;

/// R_x and its derivatives by chi and psi.
///
/// ```
/// use carom_impact::oblique::Groups;
/// use carom_impact::restitution::Sensitivity;
/// // Sliding throughout: R_x = 2 chi/psi - 1.
/// let sliding = Sensitivity::of(Groups::new(3.0, 8.0)?)?;
/// assert_eq!((sliding.by_chi, sliding.by_psi), (2.0 / 8.0, -6.0 / 64.0));
/// let slipping = Sensitivity::of(Groups::of_spheres(1.2, 2.0)?)?;
/// assert!(slipping.by_psi > 0.0 && !slipping.is_at_change);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sensitivity {
    /// R_x.
    pub restitution: f64,
    /// dR_x/dchi.
    pub by_chi: f64,
    /// dR_x/dpsi.
    pub by_psi: f64,
    /// Whether the regimes change here in both directions of an input, so that a derivative is that of one side.
    pub is_at_change: bool,
}

impl Sensitivity {
    /// The derivatives at these groups, in the time of some three impacts.
    ///
    /// Closed where the contact slides throughout. Elsewhere differences of the exact impact to the side on which the regimes
    /// stay the same, less the curvature of the table of R_x; within some thousandths of a change of the course of the impact
    /// central ones, which take two impacts more. Both are within 1e-7 of the larger derivative.
    ///
    /// # Errors
    /// [`ObliqueError`] as for [`ObliqueImpact::new`].
    pub fn of(groups: Groups) -> Result<Self, ObliqueError> {
        let (chi, psi) = (groups.chi(), groups.psi());
        if let Some(restitution) = restitution_in_sliding(chi, psi) {
            let by_psi = if psi.is_finite() { -2.0 * chi / (psi * psi) } else { 0.0 };
            return Ok(Self { restitution, by_chi: 2.0 / psi, by_psi, is_at_change: false });
        }
        let here = ObliqueImpact::new(groups)?;
        let [of_chi, of_psi] = [[1.0, 0.0], [0.0, 1.0]];
        let (by_chi, chi_changes) = derivative(groups, &here, of_chi)?;
        let (by_psi, psi_changes) = derivative(groups, &here, of_psi)?;
        let is_at_change = chi_changes || psi_changes;
        Ok(Self { restitution: here.restitution(), by_chi, by_psi, is_at_change })
    }

    /// dR_x/dpsi alone.
    pub(super) fn by_psi_of(groups: Groups) -> Result<f64, ObliqueError> {
        let (chi, psi) = (groups.chi(), groups.psi());
        match restitution_in_sliding(chi, psi) {
            Some(_) => Ok(-2.0 * chi / (psi * psi)),
            None => Ok(derivative(groups, &ObliqueImpact::new(groups)?, [0.0, 1.0])?.0),
        }
    }
}

/// The groups moved by this part of an input.
fn moved(groups: Groups, [of_chi, of_psi]: [f64; 2], by: f64) -> Groups {
    let (chi, psi) = (groups.chi(), groups.psi());
    // Valid groups, of which a part less than 1 is taken, are valid.
    Groups::new(chi + of_chi * by, (psi + of_psi * by).max(0.0)).unwrap_or(groups)
}

/// The derivative along an input, and whether the regimes change to both sides.
fn derivative(
    groups: Groups,
    here: &ObliqueImpact,
    along: [f64; 2],
) -> Result<(f64, bool), ObliqueError> {
    let size = along[0] * groups.chi() + along[1] * groups.psi().max(LEAST);
    let there = |step: f64| -> Result<(f64, bool), ObliqueError> {
        let there = ObliqueImpact::new(moved(groups, along, step))?;
        Ok((there.restitution(), regimes(&there).eq(regimes(here))))
    };
    let reach = reach(groups, along);
    let step = STEP * size;
    if reach > 2.0 * CURVED * size
        && let Some(curvature) = sure_curvature(groups, along, CURVED * size, SURE / step)?
    {
        let (above, stays) = there(step)?;
        let (side, sign) = if stays { (above, 1.0) } else { (there(-step)?.0, -1.0) };
        return Ok((
            sign * (side - here.restitution()) / step - 0.5 * sign * step * curvature,
            false,
        ));
    }
    let step = (SHARE_OF_REACH * reach).min(0.25 * step).max(SMALLEST * size);
    let [(above, is_above), (below, is_below)] = [there(step)?, there(-step)?];
    let slope = match (is_above, is_below) {
        (true, false) => (above - here.restitution()) / step,
        (false, true) => (here.restitution() - below) / step,
        _ => 0.5 * (above - below) / step,
    };
    Ok((slope, !(is_above && is_below)))
}

/// How far the nearest change is at which an impact takes another course: sliding at first from psi = 1, throughout from
/// psi = 2 chi - 1, up to the greatest compression at psi = chi.
fn reach(groups: Groups, [of_chi, _]: [f64; 2]) -> f64 {
    let (chi, psi) = (groups.chi(), groups.psi());
    let of_both = [psi - chi, psi - 2.0 * chi + 1.0];
    let of_psi = [psi, psi - 1.0];
    let all = of_both.into_iter().chain(if of_chi > 0.0 { [chi, chi] } else { of_psi });
    all.map(f64::abs).fold(f64::MAX, f64::min)
}

fn regimes(impact: &ObliqueImpact) -> impl Iterator<Item = Regime> {
    impact.phases().iter().map(|phase| phase.regime)
}

/// The second derivative along an input, by the table, if it is the same by half the width within `allowed`: the table has weak
/// kinks, too.
fn sure_curvature(
    groups: Groups,
    along: [f64; 2],
    width: f64,
    allowed: f64,
) -> Result<Option<f64>, ObliqueError> {
    let table = RestitutionTable::shared();
    let middle = table.restitution(groups)?;
    let of = |width: f64| -> Result<f64, ObliqueError> {
        let at = |part: f64| table.restitution(moved(groups, along, part * width));
        Ok((at(1.0)? - 2.0 * middle + at(-1.0)?) / (width * width))
    };
    let (wide, narrow) = (of(width)?, of(0.5 * width)?);
    Ok(((wide - narrow).abs() <= allowed).then_some(wide))
}
