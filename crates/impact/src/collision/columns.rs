//! The contact point of a collision, as columns.

use carom_table::Column;

use super::Collision;

impl Collision {
    /// Contact point, axes and curvatures.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::vector("point", "m", "contact point", |c| <[f64; 3]>::from(c.point()).into()),
        Column::vector("x_axis", "", "along the semi-axis a", |collision| {
            <[f64; 3]>::from(collision.frame().x()).into()
        }),
        Column::vector("y_axis", "", "along the semi-axis b", |collision| {
            <[f64; 3]>::from(collision.frame().y()).into()
        }),
        Column::vector("z_axis", "", "common normal, into body 1", |collision| {
            <[f64; 3]>::from(collision.frame().z()).into()
        }),
        Column::new("curvature_a", "1/m", "A of the gap A x^2 + B y^2", |collision| {
            collision.hertz().curvature().a().into()
        }),
        Column::new("curvature_b", "1/m", "B", |c| c.hertz().curvature().b().into()),
        Column::new("axis_ratio", "", "a/b of the contact", |collision| {
            collision.hertz().axis_ratio().get().into()
        }),
        Column::vector("centre_1", "m", "centre of mass of body 1", |collision| {
            <[f64; 3]>::from(collision.bodies()[0].placed().centre()).into()
        }),
        Column::vector("centre_2", "m", "centre of mass of body 2", |collision| {
            <[f64; 3]>::from(collision.bodies()[1].placed().centre()).into()
        }),
    ];
}
