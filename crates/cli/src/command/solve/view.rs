//! The steps as records and columns.

use carom_solver::StepSummary;
use carom_table::Column;

/// The columns of a table to read.
pub(super) fn readable() -> &'static [Column<StepSummary>] {
    &StepSummary::COLUMNS[..18]
}

/// The estimated errors of the last step, in a line to read.
pub(super) fn errors(steps: &[StepSummary]) -> String {
    let Some(all) = steps.last().and_then(|step| step.estimates) else { return String::new() };
    let errors = [
        ("zeta", all.zeta, "m"),
        ("xi", all.xi, "m"),
        ("eta", all.eta, "m"),
        ("omega", all.omega, "rad"),
        ("F_x", all.f_x, "N"),
        ("F_y", all.f_y, "N"),
        ("F_z", all.f_z, "N"),
        ("M_z", all.m_z, "N m"),
        ("peak_pressure", all.peak, "Pa"),
        ("stick_area", all.stick_area, "m2"),
    ];
    let errors = errors.iter().filter(|(_, one, _)| one.error > 1e-12 * one.value.abs());
    let errors: Vec<_> =
        errors.map(|(name, one, unit)| format!("{name} {:.1e} {unit}", one.error)).collect();
    if errors.is_empty() {
        return String::new();
    }
    format!("estimated discretisation errors of the last step: {}\n", errors.join(", "))
}
