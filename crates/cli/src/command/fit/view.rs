//! The result of a fit as text.

use crate::columns::{self, Record, Records};
use crate::error::CliError;
use crate::output::{Format, json};
use carom_fit::{Correlation, Determined, Fit, Point, Prediction, Quality};
use carom_table::row;
use serde::Serialize;

/// The complete result, in SI units.
#[derive(Serialize)]
struct Report<'a> {
    parameters: Records<'a, Determined>,
    quality: Record<'a, Quality>,
    correlations: Records<'a, Correlation>,
    statements: &'a [String],
    points: Records<'a, Point>,
    #[serde(skip_serializing_if = "Option::is_none")]
    predictions: Option<Records<'a, Prediction>>,
}

/// The text in this format, and warnings.
pub(super) fn answer(
    fit: &Fit,
    format: Format,
    has_points: bool,
) -> Result<(String, Vec<String>), CliError> {
    let has_predictions = !fit.predictions.is_empty();
    let text = match format {
        Format::Json => json(&Report {
            parameters: Records(Determined::COLUMNS, &fit.parameters),
            quality: Record::new(Quality::COLUMNS, &fit.quality),
            correlations: Records(Correlation::COLUMNS, &fit.correlations),
            statements: &fit.statements,
            points: Records(Point::COLUMNS, &fit.points),
            predictions: has_predictions.then_some(Records(Prediction::COLUMNS, &fit.predictions)),
        })?,
        Format::Table(page) => {
            let mut text = columns::rows(format, Determined::COLUMNS, &fit.parameters)?;
            text += &columns::upright(page, &row(Quality::COLUMNS, Some(&fit.quality)));
            if !fit.correlations.is_empty() {
                text += &columns::rows(format, Correlation::COLUMNS, &fit.correlations)?;
            }
            for sentence in &fit.statements {
                text += &page.fold(&format!("{sentence}\n"));
            }
            if has_points {
                text += &columns::rows(format, Point::COLUMNS, &fit.points)?;
            }
            if has_predictions {
                text += &columns::rows(format, Prediction::COLUMNS, &fit.predictions)?;
            }
            text
        }
        _ if has_predictions => columns::rows(format, Prediction::COLUMNS, &fit.predictions)?,
        _ if has_points => columns::rows(format, Point::COLUMNS, &fit.points)?,
        _ => columns::rows(format, Determined::COLUMNS, &fit.parameters)?,
    };
    Ok((text, fit.warnings.clone()))
}
