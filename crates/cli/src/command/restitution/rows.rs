//! R_x of a pair of numbers, and its columns.

use super::Tensor;
use super::bodies::{Bodies, Coupling};
use super::tensor::TensorRecord;
use crate::columns::Record;
use crate::error::CliError;
use carom_impact::oblique::{ObliqueImpact, Regime};
use carom_impact::restitution::DissimilarRestitution;
use carom_table::Column;
use serde::Serialize;

/// R_x and what belongs to it.
#[derive(Debug)]
pub(super) struct Row {
    numbers: [f64; 2],
    pub(super) restitution: f64,
    normal_restitution: Option<f64>,
    regimes: Vec<&'static str>,
    tensor: Option<TensorRecord>,
    dissimilar: Option<(Coupling, DissimilarRestitution)>,
}

const KAPPA: Column<Row> =
    Column::new("kappa", "", "ratio of stiffness c_z/c_x", |row| row.numbers[0].into());
const LAMBDA: Column<Row> =
    Column::new("lambda", "", "tangential over normal velocity, over friction", |row| {
        row.numbers[1].into()
    });
const RESTITUTION: Column<Row> =
    Column::new("R_x", "", "tangential restitution", |row| row.restitution.into());
const REGIMES: Column<Row> =
    Column::text("regimes", "", "what the contact does, one after the other", |row| {
        row.regimes.clone().into()
    });

/// The columns of spheres.
pub(super) const OF_SPHERES: &[Column<Row>] = &[KAPPA, LAMBDA, RESTITUTION, REGIMES];

/// The columns of bodies that lose energy, after their numbers.
pub(super) const OF_LOSSY: &[Column<Row>] = &[
    Column::new("normal_restitution", "", "restitution e along the normal", |row| {
        row.normal_restitution.into()
    }),
    RESTITUTION,
];

/// The columns of dissimilar spheres.
pub(super) const OF_DISSIMILAR: &[Column<Row>] = &[
    KAPPA,
    Column::new("gamma", "", "coupling of dissimilar materials", |row| {
        row.dissimilar.map(|(coupling, _)| coupling.gamma).into()
    }),
    Column::new("friction", "", "coefficient of friction", |row| {
        row.dissimilar.map(|(coupling, _)| coupling.friction.get()).into()
    }),
    LAMBDA,
    RESTITUTION,
    Column::text("method", "", "table, rings, uncoupled (gamma = 0) or frictionless", |row| {
        row.dissimilar.map(|(_, found)| found.method.name()).into()
    }),
    Column::new("error_estimate", "", "how far R_x may be off", |row| {
        row.dissimilar.map(|(_, found)| found.error_estimate).into()
    }),
];

/// The columns of any bodies.
pub(super) const OF_ANY: &[Column<Row>] = &[
    Column::new("chi", "", "D_xx c_x/(D_zz c_z)", |row| row.numbers[0].into()),
    Column::new("psi", "", "c_x/c_z times lambda", |row| row.numbers[1].into()),
    RESTITUTION,
    REGIMES,
];

macro_rules! component {
    ($name:literal, $row:literal, $column:literal) => {
        Column::new($name, "", "component of the tensor (3.3)", |row: &Row| {
            row.tensor.map(|tensor| tensor.rows[$row][$column]).into()
        })
    };
}

/// Those of a tensor.
pub(super) const OF_TENSOR: &[Column<Row>] = &[
    Column::text("tensor", "", "its name", |row| row.tensor.map(|tensor| tensor.name).into()),
    component!("R_xx", 0, 0),
    component!("R_xy", 0, 1),
    component!("R_xz", 0, 2),
    component!("R_yx", 1, 0),
    component!("R_yy", 1, 1),
    component!("R_yz", 1, 2),
    component!("R_zx", 2, 0),
    component!("R_zy", 2, 1),
    component!("R_zz", 2, 2),
];

/// A row as it stands in JSON.
#[derive(Serialize)]
pub(super) struct RowRecord<'a> {
    #[serde(flatten)]
    row: Record<'a, Row>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tensor: Option<TensorRecord>,
}

impl Row {
    /// The impact of two numbers of the plane.
    pub(super) fn new(
        bodies: Bodies,
        numbers: [f64; 2],
        tensor: Option<Tensor>,
        ratio: f64,
    ) -> Result<Self, CliError> {
        if let Bodies::Dissimilar(coupling) = bodies {
            return Self::dissimilar(coupling, numbers);
        }
        if let loss @ Some(_) = bodies.normal_loss() {
            let restitution = bodies.restitution(numbers)?;
            return Ok(Self { normal_restitution: loss, ..Self::plain(numbers, restitution) });
        }
        let groups = bodies.groups(numbers)?;
        let impact = ObliqueImpact::new(groups)?;
        let regimes = impact.regimes().map(Regime::name).collect();
        let restitution = impact.restitution();
        let tensor = tensor.map(|tensor| tensor.record(groups, ratio)).transpose()?;
        Ok(Self { regimes, tensor, ..Self::plain(numbers, restitution) })
    }

    fn plain(numbers: [f64; 2], restitution: f64) -> Self {
        let (normal_restitution, tensor, dissimilar) = (None, None, None);
        Self { numbers, restitution, normal_restitution, regimes: Vec::new(), tensor, dissimilar }
    }

    fn dissimilar(coupling: Coupling, numbers: [f64; 2]) -> Result<Self, CliError> {
        let found = coupling.found(numbers)?;
        let dissimilar = Some((coupling, found));
        Ok(Self { dissimilar, ..Self::plain(numbers, found.r_x) })
    }

    /// As it stands in JSON, with these columns.
    pub(super) fn record<'a>(&'a self, columns: &'a [Column<Self>]) -> RowRecord<'a> {
        RowRecord { row: Record::new(columns, self), tensor: self.tensor }
    }
}
