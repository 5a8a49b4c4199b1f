//! The restitution tensor beside R_x, by its name.

use carom_impact::oblique::{Groups, ObliqueError};
use carom_impact::restitution::RestitutionTensor;
use carom_special::RangeError;
use serde::Serialize;

/// Which of the tensors that map the velocity before to that after.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Tensor {
    /// Final over initial velocity, component by component.
    Secant,
    /// How the final velocity answers to small changes of the initial one.
    Tangent,
}

/// A tensor with its name; rows and columns are x along the slip, y across it, z.
#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct TensorRecord {
    pub(super) name: &'static str,
    pub(super) rows: [[f64; 3]; 3],
}

impl Tensor {
    pub(super) fn record(self, groups: Groups, ratio: f64) -> Result<TensorRecord, ObliqueError> {
        let (name, tensor) = match self {
            Self::Secant => ("secant", RestitutionTensor::secant(groups)?),
            Self::Tangent => ("tangent", RestitutionTensor::tangent(groups, ratio)?),
        };
        // Columns of the transpose are rows.
        Ok(TensorRecord { name, rows: tensor.matrix().transpose().into() })
    }
}

/// |v_x|/v_z as an option gives it.
pub(super) fn velocity_ratio(value: f64) -> Result<f64, RangeError> {
    RangeError::non_negative("velocity-ratio", value)
}
