//! Special functions, integrals over rectangles, Hertz's ellipse, a case file.

use carom_cases::case::{Case as _, ImpactFile};
use carom_halfspace::{Offset, Rectangle};
use carom_special::AxisRatio;
use carom_special::elliptic::{Amplitude, complete, incomplete};
use carom_special::hypergeometric::{Gauss, UnitArgument};

use crate::{HotPath, Work};

pub(crate) const PATHS: &[HotPath] = &[
    ("complete_elliptic", complete_elliptic),
    ("incomplete_elliptic", incomplete_elliptic),
    ("hypergeometric", hypergeometric),
    ("rectangle_integrals", rectangle_integrals),
    ("case_read", case_read),
];

const CASE: &str = include_str!("../../../examples/alumina_on_glass.toml");

/// Numbers all over the open interval from 0 to 1.
fn parts(count: i32) -> impl Iterator<Item = f64> {
    (0..count).map(move |i| (f64::from(i) + 0.5) / f64::from(count))
}

fn complete_elliptic() -> Work {
    let ratios: Vec<_> = parts(1000).map(|x| AxisRatio::new(x).expect("positive")).collect();
    Box::new(move || ratios.iter().map(|&ratio| complete::k(ratio) + complete::e(ratio)).sum())
}

fn incomplete_elliptic() -> Work {
    let ratio = AxisRatio::new(0.3).expect("positive");
    let amplitudes: Vec<_> =
        parts(1000).map(|x| Amplitude::from_cosine(x).expect("a cosine")).collect();
    Box::new(move || {
        amplitudes.iter().map(|&at| incomplete::f(ratio, at) + incomplete::e(ratio, at)).sum()
    })
}

fn hypergeometric() -> Work {
    let function = Gauss::new(-0.476, 0.576, 0.6).expect("in range");
    let arguments: Vec<_> = parts(1000).map(|x| UnitArgument::new(x).expect("in range")).collect();
    Box::new(move || arguments.iter().map(|&x| function.at(x).expect("in range")).sum())
}

fn rectangle_integrals() -> Work {
    let cell = Rectangle::new(1.0, 0.7).expect("a cell");
    let offsets: Vec<_> = (0..40)
        .flat_map(|x| (0..40).map(move |y| Offset { x: f64::from(x), y: 0.7 * f64::from(y) }))
        .collect();
    Box::new(move || {
        let integrals = offsets.iter().map(|&offset| cell.integrals(offset).expect("finite"));
        integrals.map(|all| all.inverse_distance + all.xy + all.log_x).sum()
    })
}

fn case_read() -> Work {
    Box::new(|| {
        (0..20).map(|_| ImpactFile::parse(CASE).expect("a case").inputs().len() as f64).sum()
    })
}
