//! What CONTACT prints of a case, with its words, signs and units.

use super::case::{Asked, ContactCase, Motion};
use carom_solver::{CellState, ContactState, Driven, Estimated, Estimates};
use carom_table::{Column, Value};

/// Joules in a newton millimetre.
const JOULE: f64 = 1e-3;

/// A case in the words of CONTACT. Forces act on body 1, the upper one; motions are those of body 1 against
/// body 2.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The number of the case.
    pub case: usize,
    /// The line of its control digits.
    pub line: usize,
    /// What happens along the surface.
    pub motion: Motion,
    /// Which of FX and FY are given.
    pub forced: [bool; 2],
    /// Whether FN is given.
    pub pressed: bool,
    /// FN.
    pub fn_: f64,
    /// FX.
    pub fx: f64,
    /// FY.
    pub fy: f64,
    /// MZ about the origin.
    pub mz: f64,
    /// Elastic energy, J.
    pub elastic: f64,
    /// Frictional power, W, or of a shift frictional work, J.
    pub friction: f64,
    /// FN over the shear modulus of the pair.
    pub fn_over_g: f64,
    /// FX over FSTAT FN.
    pub fx_rel: f64,
    /// FY over FSTAT FN.
    pub fy_rel: f64,
    /// CKSI, or the shift along x.
    pub cksi: f64,
    /// CETA.
    pub ceta: f64,
    /// CPHI.
    pub cphi: f64,
    /// The approach PEN.
    pub approach: f64,
    /// The greatest pressure.
    pub pmax: f64,
    /// Cells, and those in contact, in adhesion and in slip.
    pub counts: [usize; 4],
    /// Discretisation errors, if they were estimated.
    pub estimates: Option<Estimates>,
}

impl Row {
    pub(super) fn of(
        case: &ContactCase,
        state: &ContactState,
        force: f64,
        estimates: Option<Estimates>,
        heat: f64,
        energy: f64,
    ) -> Self {
        let (load, [x, y], scale) = (state.load(), case.area.middle(), case.scale());
        let [stick, slip] = [CellState::Stick, CellState::Slip].map(|cell| state.count(cell));
        let adhesion = if case.motion == Motion::None { stick + slip } else { stick };
        // carom's torque has the sign of y t_x - x t_y about the middle of the cells.
        let mz = x * load.f_y - y * load.f_x - load.m_z;
        let limit = scale * force;
        let told = |value: f64| if value.abs() < 0.5 * case.eps * limit { 0.0 } else { value };
        let relative = |force: f64| if limit > 0.0 { told(force) / limit } else { 0.0 };
        let middle = case.of_middle();
        let motion = |i: usize, found: f64| match case.drive.along[i] {
            Asked::Creepage(given) => given,
            Asked::Force(_) => -found - middle[i],
        };
        let rate = case.motion.rolling().map_or(1.0, |rolling| rolling.veloc / rolling.dq);
        let pair = case.materials;
        Self {
            case: case.number,
            line: case.line,
            motion: case.motion,
            forced: case.drive.along.map(|asked| matches!(asked, Asked::Force(_))),
            pressed: matches!(case.drive.normal, Driven::Load(_)),
            fn_: force,
            fx: told(load.f_x),
            fy: told(load.f_y),
            mz: told(mz),
            elastic: JOULE * energy,
            friction: -JOULE * rate * heat,
            fn_over_g: 0.5 * force / pair.shear_modulus(),
            fx_rel: relative(load.f_x),
            fy_rel: relative(load.f_y),
            cksi: motion(0, state.shift.xi),
            ceta: motion(1, state.shift.eta),
            cphi: case.drive.spin,
            approach: state.shift.zeta,
            // Of the cells: carom's own greatest pressure may lie between them.
            pmax: state.pressure.values().iter().copied().fold(0.0, f64::max),
            counts: [case.area.count(), stick + slip, adhesion, stick + slip - adhesion],
            estimates,
        }
    }

    fn error(&self, of: fn(&Estimates) -> &Estimated) -> Value {
        self.estimates.as_ref().map_or(Value::Absent, |all| of(all).error.into())
    }
}

/// All columns.
pub const COLUMNS: &[Column<Row>] = &[
    Column::count("case", "", "its number in the file", |row| (row.case as u64).into()),
    Column::count("line", "", "the line of its control digits", |row| (row.line as u64).into()),
    Column::new("FN", "N", "normal force", |row| row.fn_.into()),
    Column::new("FX", "N", "force on body 1 along x", |row| row.fx.into()),
    Column::new("FY", "N", "force on body 1 along y", |row| row.fy.into()),
    Column::new("MZ", "N mm", "torque on body 1 about the origin, from x to y", |row| {
        row.mz.into()
    }),
    Column::new("ELAST_EN", "J", "elastic energy of both bodies", |row| row.elastic.into()),
    Column::new(
        "FRIC_POWER",
        "W",
        "power of friction in rolling; in J its work in a shift",
        |row| row.friction.into(),
    ),
    Column::new("FN_G", "mm^2", "FN over the combined shear modulus", |row| row.fn_over_g.into()),
    Column::new("FX_REL", "", "FX over FSTAT FN, over FN if FSTAT varies", |row| row.fx_rel.into()),
    Column::new("FY_REL", "", "FY over the same", |row| row.fy_rel.into()),
    Column::new("CKSI", "", "creepage along x of body 1 against body 2; in mm a shift", |row| {
        row.cksi.into()
    }),
    Column::new("CETA", "", "the same along y", |row| row.ceta.into()),
    Column::new("CPHI", "rad/mm", "spin, from x to y; in rad that of a shift", |row| {
        row.cphi.into()
    }),
    Column::new("APPROACH", "mm", "PEN", |row| row.approach.into()),
    Column::new("PMAX", "N/mm^2", "greatest pressure", |row| row.pmax.into()),
    Column::count("NPOT", "", "cells", |row| (row.counts[0] as u64).into()),
    Column::count("NCON", "", "cells in contact", |row| (row.counts[1] as u64).into()),
    Column::count("NADH", "", "cells in adhesion", |row| (row.counts[2] as u64).into()),
    Column::count("NSLIP", "", "cells in slip", |row| (row.counts[3] as u64).into()),
    Column::new("FN_error", "N", "estimated error of the mesh", |row| row.error(|all| &all.f_z)),
    Column::new("FX_error", "N", "the same of FX", |row| row.error(|all| &all.f_x)),
    Column::new("FY_error", "N", "the same of FY", |row| row.error(|all| &all.f_y)),
    Column::new("MZ_error", "N mm", "the same of MZ", |row| row.error(|all| &all.m_z)),
    Column::new("CKSI_error", "", "the same of CKSI", |row| row.error(|all| &all.xi)),
    Column::new("CETA_error", "", "the same of CETA", |row| row.error(|all| &all.eta)),
    Column::new("APPROACH_error", "mm", "the same of APPROACH", |row| row.error(|all| &all.zeta)),
    Column::new("PMAX_error", "N/mm^2", "the same of PMAX", |row| row.error(|all| &all.peak)),
];
