//! Rolling under exchanged bodies and turned axes, on oblong cells with steps of another length.

#[path = "../../../../testing/image.rs"]
mod image;

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_rolling::{Creepage, RollingDrive, SteadyContact, Way};
use carom_solver::{ContactProblem, Driven, Gap};
use image::Image;

/// F_x, F_y, F_z, M_z and the heat of a contact that rolls along the image of x.
fn forces(image: Image) -> [f64; 5] {
    let [one, two] =
        image.bodies([(1.0, 0.2), (2.0, 0.4)].map(|(g, nu)| Material::from_shear(g, nu).unwrap()));
    let ([nx, ny], [dx, dy]) = (image.axes([26, 20]), image.axes([0.03, 0.05]));
    let grid = Grid::new(nx, ny, dx, dy).unwrap();
    let gap = Gap::from_function(grid, |x, y| {
        let [x, y] = image.place_before([x, y]);
        0.5 * x * x + 0.4 * y * y
    });
    let pair = MaterialPair::new(one, two).unwrap();
    let problem =
        ContactProblem::of_half_spaces(gap.unwrap(), pair, Friction::new(0.3).unwrap()).unwrap();
    let [x, y] = image.place([1.0, 0.0]);
    let way = Way::new(0.02).unwrap().towards(y.atan2(x)).unwrap();
    let mut contact = SteadyContact::new(&problem, way).unwrap();
    // Creepages and forces are those along the axes of the grid.
    let [along, across] = image.across([0.004, 0.003]);
    let creepage = Creepage { along, across, spin: 0.02 };
    let drive = RollingDrive::by_creepage(Driven::Shift(0.06), creepage);
    let rolling = contact.roll(&drive, &mut ()).unwrap();
    let load = rolling.state.load();
    [load.f_x, load.f_y, load.f_z, load.m_z, rolling.heat]
}

#[test]
fn rolling_has_no_favourite_body_or_axis_where_steps_are_no_cells() {
    let [f_x, f_y, f_z, m_z, heat] = forces(Image::ALL[0]);
    for image in Image::ALL {
        let [x, y] = image.across([f_x, f_y]);
        let found = forces(image);
        for (expected, found) in [x, y, f_z, m_z].into_iter().zip(found) {
            assert!((expected - found).abs() < 1e-6 * f_z, "{image:?}: {expected} {found}");
        }
        assert!((found[4] / heat - 1.0).abs() < 1e-6, "{image:?}: {heat} {}", found[4]);
    }
}
