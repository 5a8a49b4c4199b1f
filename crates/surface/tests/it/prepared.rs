//! Levelling, filling and cutting a map.

use carom_surface::{Crop, Level, SurfaceError, Topography};

fn surface(of: impl Fn(f64, f64) -> f64) -> Topography {
    let heights = (0..35).map(|i| of(f64::from(i % 7), f64::from(i / 7)));
    Topography::new(7, heights.collect()).unwrap()
}

/// A surface of the fitted kind leaves nothing, also with points missing.
#[test]
fn what_is_fitted_is_subtracted_whole() {
    let quadratic =
        surface(|x, y| 3.0 - 2.0 * x + 0.5 * y + 0.1 * x * x - 0.3 * x * y + 0.7 * y * y);
    let mut holes = quadratic.heights().to_vec();
    holes[4] = f64::NAN;
    holes[20] = f64::NAN;
    let holes = Topography::new(7, holes).unwrap();
    for map in [&quadratic, &holes] {
        let rest = map.levelled(Level::Quadratic);
        assert!(rest.heights().iter().all(|height| height.is_nan() || height.abs() < 1e-12));
    }
    let plane = surface(|x, y| 1.0 + 2.0 * x - 3.0 * y);
    assert!(plane.levelled(Level::Plane).heights().iter().all(|height| height.abs() < 1e-13));
    let mean = plane.levelled(Level::Mean);
    assert!(mean.heights().iter().sum::<f64>().abs() < 1e-12);
    assert!((mean.heights()[1] - mean.heights()[0] - 2.0).abs() < 1e-12);
}

/// A row has no rise along y; the terms that it does not determine are left out.
#[test]
fn a_single_row_is_levelled_along_itself() {
    let row = Topography::new(5, vec![1.0, 3.0, 5.0, 7.0, 9.0]).unwrap();
    assert!(row.levelled(Level::Plane).heights().iter().all(|height| height.abs() < 1e-13));
    assert!(row.levelled(Level::Quadratic).heights().iter().all(|height| height.abs() < 1e-12));
}

/// A plane is harmonic: a patch of the means of neighbours restores it.
#[test]
fn a_hole_in_a_plane_is_filled_by_the_plane() {
    let plane = surface(|x, y| 1.0 + 2.0 * x - 3.0 * y);
    let mut heights = plane.heights().to_vec();
    [8, 9, 10, 15, 16, 17, 24].iter().for_each(|place| heights[*place] = f64::NAN);
    let filled = Topography::new(7, heights).unwrap().filled();
    for (one, other) in filled.heights().iter().zip(plane.heights()) {
        assert!((one - other).abs() < 2e-3, "{one} {other}");
    }
    assert_eq!(filled.missing(), 0);
}

#[test]
fn measured_points_are_not_moved_and_one_height_fills_all() {
    let mut heights = vec![f64::NAN; 20];
    heights[7] = 3.0;
    let filled = Topography::new(5, heights).unwrap().filled();
    assert!(filled.heights().iter().all(|height| *height == 3.0));
}

#[test]
fn a_part_lies_in_the_map() {
    let map = surface(|x, y| 10.0 * y + x).spaced(Some([2e-6, 3e-6]));
    let part = map.cropped(Crop([2, 1, 4, 3])).unwrap();
    assert_eq!(part.heights(), [12.0, 13.0, 22.0, 23.0]);
    assert_eq!((part.spacing(), part.size()), (Some([2e-6, 3e-6]), Some([4e-6, 6e-6])));
    for crop in [[4, 1, 4, 3], [2, 3, 4, 3], [0, 0, 8, 1], [0, 0, 1, 6], [5, 0, 3, 1]] {
        let error = map.cropped(Crop(crop)).unwrap_err();
        assert!(error.to_string().contains("from 0 to 7 and 5"), "{error}");
    }
}

#[test]
fn a_map_has_finite_heights_or_none() {
    let infinite = Topography::new(2, vec![1.0, 2.0, f64::NEG_INFINITY, 3.0]).unwrap_err();
    assert!(matches!(infinite, SurfaceError::NotFinite { row: 2, column: 1, .. }));
    assert!(matches!(Topography::new(2, vec![f64::NAN; 4]), Err(SurfaceError::Empty { .. })));
    assert!(Topography::new(3, vec![1.0; 4]).is_err() && Topography::new(0, vec![1.0]).is_err());
    let great = Topography::new(2, vec![1.0, 1e308]).unwrap().scaled(100.0).unwrap_err();
    assert!(matches!(great, SurfaceError::Scaled { row: 1, column: 2, .. }));
}
