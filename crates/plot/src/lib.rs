#![forbid(unsafe_code)]
//! Plots as SVG, PNG and PDF: panels of axes with lines, markers, arrows, areas and coloured fields; an
//! SVG may be animated.
//!
//! The crate contains no mechanics and needs no system fonts: letters in a PNG and a PDF are
//! those of DejaVu Sans (copyright Bitstream, Inc. and Tavmjong Bah; free to embed). The SVG has clip paths, dash
//! patterns and text, on a light background, in colours that colour-blind readers can distinguish.
//! In labels, `F_x` and `F_max` are set with subscripts, `ζ^1.5` and `N^(1/4)` with exponents. Panels
//! with the same axes share a legend.
//!
//! ```
//! use carom_plot::{Panel, Series, render};
//!
//! let mut panel = Panel::new("x", "x²");
//! panel.add(Series::line("parabola", (-50..=50).map(|i| (f64::from(i), f64::from(i * i)))));
//! let svg = render("A parabola", &[panel])?;
//! assert!(svg.starts_with("<svg"));
//! # Ok::<(), carom_plot::PlotError>(())
//! ```

mod axes;
mod contour;
mod draw;
mod error;
mod field;
mod heat;
mod legend;
mod look;
mod movement;
mod panel;
mod pdf;
mod plot;
mod raster;
mod render;
mod series;
mod span;
mod svg;
mod text;

pub use error::PlotError;
pub use field::Field;
pub use panel::{Aspect, Axis, Limits, Panel, Scale};
pub use raster::base64;
pub use render::{render, render_each, render_pdf, render_png};
pub use series::{Arrow, Marker, Motion, Point, Series, Stroke, Style};
