//! Measures of maps whose numbers are known, and warnings of maps with one fault each.

use carom_drawn::{Draw as _, Xorshift};
use carom_fourier::{Complex64, Transformed as _};
use carom_surface::{Measures, Topography, spectrum, spikes};
use std::f64::consts::{PI, TAU};

/// A map of n x n points, 1 um apart.
fn map(n: usize, of: impl Fn(usize, usize) -> f64) -> Topography {
    let heights = (0..n * n).map(|place| of(place % n, place / n)).collect();
    Topography::new(n, heights).unwrap().spaced(Some([1e-6; 2]))
}

fn measures(map: &Topography, is_periodic: bool) -> Measures {
    Measures::of(map, spectrum(map, is_periodic).as_ref(), &spikes(map))
}

/// A periodic surface with C ~ q^(-2 (1 + H)) between waves of n/4 and `shortest` points, rms height 0.2 um.
fn self_affine(n: usize, hurst: f64, shortest: f64, seed: u64) -> Topography {
    let mut draw = Xorshift(seed);
    let mut waves = vec![Complex64::new(0.0, 0.0); n * n];
    for (place, wave) in waves.iter_mut().enumerate() {
        let along = |i: usize| if i <= n / 2 { i as f64 } else { i as f64 - n as f64 };
        let q = f64::hypot(along(place % n), along(place / n));
        let phase = TAU * draw.part();
        if q >= 4.0 && q <= n as f64 / shortest {
            *wave = Complex64::from_polar(q.powf(-1.0 - hurst), phase);
        }
    }
    let plan = f64::complex_plan(n).inverse;
    waves.chunks_exact_mut(n).for_each(|row| plan.process(row));
    let mut column = vec![Complex64::new(0.0, 0.0); n];
    for i in 0..n {
        (0..n).for_each(|j| column[j] = waves[j * n + i]);
        plan.process(&mut column);
        (0..n).for_each(|j| waves[j * n + i] = column[j]);
    }
    let heights: Vec<f64> = waves.iter().map(|value| value.re).collect();
    let rms =
        (heights.iter().map(|height| height * height).sum::<f64>() / heights.len() as f64).sqrt();
    map(n, |i, j| 2e-7 * heights[j * n + i] / rms)
}

/// A cosine of amplitude A and wave number q has rms height A/sqrt 2, rms slope A q/sqrt 2 and rms curvature A q^2/(2 sqrt 2);
/// differences over a step d are off by (q d)^2/24 and (q d)^2/12.
#[test]
fn a_wave_has_the_roughness_of_the_formula() {
    let (n, amplitude) = (256, 3e-8);
    let q = TAU / 32e-6;
    let wave = map(n, |i, _| amplitude * (1.0 + q * 1e-6 * i as f64).cos());
    let found = measures(&wave, true);
    let close = |one: f64, other: f64, error: f64| {
        assert!((one / other - 1.0).abs() < error, "{one} {other}");
    };
    close(found.rms_height, amplitude / 2_f64.sqrt(), 1e-12);
    close(found.rms_slope.unwrap(), amplitude * q / 2_f64.sqrt(), 4e-3);
    close(found.rms_curvature.unwrap(), amplitude * q * q / (2.0 * 2_f64.sqrt()), 8e-3);
    // About the plane of best fit, which a wave tilts a little.
    close(found.kurtosis, 1.5, 2e-2);
    assert!(found.skewness.abs() < 1e-2 && found.mean.abs() < 1e-20);
    assert_eq!((found.missing, found.spikes, found.points), (0, 0, [n, n]));
    let [width, _] = found.size().unwrap();
    close(width, 256e-6, 1e-12);
    assert!(found.border_step[0] < 1.5, "{:?}", found.border_step);
}

/// The integral of the density over the plane of wave numbers, over 4 pi^2, is the mean square (Parseval); here of rings.
#[test]
fn the_spectrum_holds_the_mean_square_height() {
    let map = self_affine(128, 0.8, 8.0, 5);
    let found = spectrum(&map, true).unwrap();
    let mut sum = 0.0;
    for pair in found.density.windows(2) {
        let [[q, c], [r, d]] = [pair[0], pair[1]];
        sum += 0.5 * (TAU * q * c + TAU * r * d) * (r - q);
    }
    let rms = (sum / (4.0 * PI * PI)).sqrt();
    assert!((rms / 2e-7 - 1.0).abs() < 0.1, "{rms}");
}

#[test]
fn hursts_exponent_is_that_of_the_surface() {
    for (hurst, seed) in [(0.3, 1), (0.5, 2), (0.8, 3), (0.95, 4)] {
        let surface = self_affine(512, hurst, 4.0, seed);
        for is_periodic in [true, false] {
            let found = spectrum(&surface, is_periodic).unwrap();
            let (exponent, deviation) = (found.hurst.unwrap(), found.hurst_deviation.unwrap());
            assert!((exponent - hurst).abs() < 0.06, "{hurst} {is_periodic}: {exponent}");
            assert!(deviation < 0.05, "{deviation}");
        }
    }
    let wave = map(256, |i, j| 1e-8 * ((0.3 * i as f64).cos() + (0.7 * j as f64).sin()));
    assert_eq!(spectrum(&wave, false).unwrap().hurst, None);
}

/// Of whole periods and of surfaces that are faded out, with waves down to two and to four points.
#[test]
fn hursts_exponent_lies_within_twice_its_deviation() {
    const SURFACES: u64 = 60;
    for (n, shortest, is_periodic) in [(128, 4.0, true), (128, 2.0, true), (128, 2.0, false)] {
        let found = (1..=SURFACES).map(|seed| {
            let found = spectrum(&self_affine(n, 0.8, shortest, 7919 * seed), is_periodic).unwrap();
            [found.hurst.unwrap(), found.hurst_deviation.unwrap()]
        });
        let found: Vec<[f64; 2]> = found.collect();
        let beyond = found.iter().filter(|[hurst, told]| (hurst - 0.8).abs() > 2.0 * told).count();
        assert!(beyond <= 3, "{beyond} of {SURFACES}: {n} {shortest} {is_periodic}");
        let mean = |of: &dyn Fn(&[f64; 2]) -> f64| found.iter().map(of).sum::<f64>() / 60.0;
        let scatter = mean(&|[hurst, _]| (hurst - 0.8).powi(2)).sqrt();
        let told = mean(&|[_, deviation]| *deviation);
        assert!(told < 3.0 * scatter, "{told} {scatter}");
    }
}

#[test]
fn a_map_of_equal_heights_is_flat() {
    for height in [0.0, 5.0, 1e-3, 1.1e-6, -3e-9, 0.1] {
        let found = measures(&map(12, |_, _| height), false);
        assert_eq!([found.rms_height, found.rms_height_level], [0.0; 2]);
        assert_eq!((found.mean, found.range, found.rise), (height, [height; 2], [0.0; 2]));
        assert!(found.skewness.is_nan() && found.tilt_over_rms().is_nan());
        assert_eq!(found.warnings(false), [""; 0]);
    }
    let stepped = measures(&map(12, |i, _| if i < 6 { 0.1 } else { 0.3 }), false);
    assert_eq!(stepped.range, [0.1, 0.3]);
}

#[test]
fn a_rough_map_without_a_fault_has_no_warning() {
    for seed in 1..6 {
        let surface = self_affine(128, 0.8, 8.0, seed);
        assert_eq!(measures(&surface, true).warnings(true), [""; 0]);
    }
}

/// One fault each: a tilt of 40 rms, 3 % missing, micrometres taken for metres, a point 1e7 times too high, a step over
/// the border. The warning names it, and the way out.
#[test]
fn each_fault_is_told() {
    let rough = self_affine(128, 0.8, 8.0, 7);
    let changed = |of: &dyn Fn(usize, f64) -> f64| {
        let heights = rough.heights().iter().enumerate().map(|(place, height)| of(place, *height));
        Topography::new(128, heights.collect()).unwrap().spaced(Some([1e-6; 2]))
    };
    let tilted = changed(&|place, height| height + 8e-6 * (place % 128) as f64 / 127.0);
    let missing = changed(&|place, height| if place % 33 == 5 { f64::NAN } else { height });
    let micro = changed(&|_, height| 1e6 * height);
    let spiked = changed(&|place, height| if place == 40 * 128 + 17 { 2.0 } else { height });
    let stepped = changed(&|place, height| height + 4e-7 * ((place % 128) as f64 / 127.0 - 0.5));
    for (map, words) in [
        (&tilted, ["tilted", "40 times", "`level` = \"plane\""]),
        (&missing, ["497 points are missing", "row 1, column 6", "`missing` = \"fill\""]),
        (&micro, ["rms slope", "another unit", "In um"]),
        (&spiked, ["row 41, column 18 is 2.0000e0 m", "around it", "nan"]),
    ] {
        let told = measures(map, false).warnings(false);
        assert_eq!(told.len(), 1, "{told:?}");
        words.iter().for_each(|word| assert!(told[0].contains(word), "{told:?}"));
    }
    let told = measures(&stepped, true).warnings(true);
    assert!(told.len() == 1 && told[0].contains("step over the border"), "{told:?}");
    assert_eq!(measures(&stepped, false).warnings(false), [""; 0]);
}

#[test]
fn a_grating_and_a_sphere_have_no_spikes() {
    let grating = map(64, |i, j| if (i / 8 + j / 8) % 2 == 0 { 1e-6 } else { 0.0 });
    let sphere = map(64, |i, j| -((i as f64 - 31.0).powi(2) + (j as f64 - 31.0).powi(2)) * 1e-9);
    for map in [grating, sphere] {
        assert_eq!(spikes(&map), []);
    }
}

/// The median of one or two neighbours tells nothing, and many points that lie far off are texture.
#[test]
fn a_lonely_point_and_many_points_are_no_spikes() {
    let with = |is_high: &dyn Fn(usize) -> bool, missing: &[usize]| {
        map(32, |i, j| match 32 * j + i {
            place if missing.contains(&place) => f64::NAN,
            place if is_high(place) => 1e-3,
            _ => 1e-7 * ((3 * i + 5 * j) % 7) as f64,
        })
    };
    let found =
        |is_high: &dyn Fn(usize) -> bool, missing: &[usize]| spikes(&with(is_high, missing)).len();
    // A corner has the neighbours 1, 32 and 33.
    assert_eq!(found(&|place| place == 0, &[]), 1);
    assert_eq!(found(&|place| place == 0, &[1, 32]), 0);
    // 5 of 1024 points, and 21 of them.
    assert_eq!(found(&|place| place % 200 == 100, &[]), 5);
    assert_eq!(found(&|place| place % 50 == 0, &[]), 0);
    // The farthest comes first, and not the highest.
    let heights = map(32, |i, j| match 32 * j + i {
        200 => 18.0,
        700 => -5.0,
        _ => 10.0 + 1e-3 * ((3 * i + 5 * j) % 7) as f64,
    });
    let rows: Vec<usize> = spikes(&heights).iter().map(|spike| spike.row).collect();
    assert_eq!(rows, [22, 7]);
}

/// Steeper than half-spaces bear, but no fault of a unit.
#[test]
fn a_steep_map_is_told() {
    let steep = map(64, |i, _| 0.5e-6 * (i % 2) as f64);
    let told = measures(&steep, false).warnings(false);
    assert!(told[0].contains("half-spaces"), "{told:?}");
}
