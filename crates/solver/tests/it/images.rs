//! Steps on oblong grids of oblong cells under exchanged bodies and turned axes.

#[path = "../../../../testing/image.rs"]
mod image;

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::ContactLoad;
use carom_solver::{ContactProblem, ContactState, Drive, Driven, Frictional, Gap, Method as _};
use image::Image;

fn height([x, y]: [f64; 2]) -> f64 {
    0.5 * x * x + 0.8 * y * y + 0.1 * x * y + 0.05 * x * x * x
}

fn loads(image: Image) -> (Vec<ContactLoad>, f64) {
    let [one, two] =
        image.bodies([(1.0, 0.1), (3.0, 0.45)].map(|(g, nu)| Material::from_shear(g, nu).unwrap()));
    let [nx, ny] = image.axes([18, 24]);
    let [dx, dy] = image.axes([0.05, 0.03]);
    let grid = Grid::new(nx, ny, dx, dy).unwrap();
    let gap = Gap::from_function(grid, |x, y| height(image.place_before([x, y]))).unwrap();
    let pair = MaterialPair::new(one, two).unwrap();
    let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(0.3).unwrap()).unwrap();
    let method = Frictional::default().within(1e-9).unwrap();
    let mut scratch = method.scratch(&problem).unwrap();
    let mut state = ContactState::apart(grid);
    let mut loads = Vec::new();
    for (zeta, across, omega) in
        [(0.05, [0.0, 0.0], 0.0), (0.06, [0.01, 0.004], 0.01), (0.05, [0.002, -0.015], -0.02)]
    {
        let [x, y] = image.across(across).map(Driven::Shift);
        let drive = Drive { normal: Driven::Shift(zeta), x, y, twist: Driven::Shift(omega) };
        let before = state.clone();
        method.step(&problem, &before, &drive, &mut state, &mut scratch, &mut ()).unwrap();
        loads.push(state.load());
    }
    (loads, state.peak_pressure())
}

#[test]
fn grids_have_no_favourite_body_or_axis() {
    let (first, peak) = loads(Image::ALL[0]);
    for image in Image::ALL {
        let (other, other_peak) = loads(image);
        assert!((peak / other_peak - 1.0).abs() < 1e-6, "{image:?}: {peak} {other_peak}");
        for (one, two) in first.iter().zip(&other) {
            let [x, y] = image.across([one.f_x, one.f_y]);
            for (a, b) in [(x, two.f_x), (y, two.f_y), (one.f_z, two.f_z), (one.m_z, two.m_z)] {
                assert!((a - b).abs() < 1e-6 * one.f_z, "{image:?}: {one:?} {two:?}");
            }
        }
    }
}
