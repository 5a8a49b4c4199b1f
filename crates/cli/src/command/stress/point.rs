//! The stress at one point, as a row of the results.

use carom_halfspace::Stress;
use carom_table::Column;

/// The stress at a point, in the axes of the contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct StressPoint {
    /// x, y and depth.
    pub(super) at: [f64; 3],
    pub(super) stress: Stress,
}

impl StressPoint {
    pub(super) const COLUMNS: &'static [Column<Self>] = &[
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
