//! The power spectrum of a map, averaged over directions, and Hurst's exponent from its slope.

use crate::level::Level;
use crate::topography::Topography;
use carom_fourier::{Complex64, Transformed as _};
use std::f64::consts::{PI, TAU};

/// Power over wave number, averaged over directions.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// Wave number q in 1/m, and the power spectral density C(q) in m^4, whose integral over the plane of q divided by
    /// 4 pi^2 is the mean square height; ascending.
    pub density: Vec<[f64; 2]>,
    /// Hurst's exponent by C ~ q^(-2 (1 + H)) between the wave numbers that carry most of the slope; none if the
    /// density is no power of q there.
    pub hurst: Option<f64>,
    /// Standard deviation of the exponent, by the number of waves in each ring and the scatter about the line.
    pub hurst_deviation: Option<f64>,
}

/// Largest number of points along an axis that are transformed: of larger maps the middle.
const MOST: usize = 2048;
/// Bins for each factor of ten of the wave number.
const BINS: f64 = 12.0;
/// Part of the slope's variance up to which the exponent is fitted.
const SLOPE: f64 = 0.95;
/// Least number of bins for the exponent, and the largest standard deviation of log C about the line.
const LEAST_BINS: usize = 4;
const STRAIGHT: f64 = 0.6;
/// By how much log C may differ from a line in rings of any number of waves.
const WAVINESS: f64 = 0.1;
/// The number of waves over that of independent ones, if Hann's window spreads each over its neighbours: (35/18)^2.
const SPREAD: f64 = 3.8;
/// Exponents of a fit that are taken: a little beyond 0 to 1.
const POSSIBLE: std::ops::RangeInclusive<f64> = -0.2..=1.3;

/// The spectrum of a map that `is_periodic`, or of a part of a surface, to which Hann's window is applied; the plane of
/// best fit is subtracted and missing points are filled before. None without spacing or with fewer than 8 points along
/// an axis.
#[must_use]
pub fn spectrum(map: &Topography, is_periodic: bool) -> Option<Spectrum> {
    let spacing = map.spacing()?;
    let (map, is_periodic) = middle(map, is_periodic);
    let (nx, ny) = (map.columns(), map.rows());
    if nx < 8 || ny < 8 {
        return None;
    }
    let level = if is_periodic { Level::Mean } else { Level::Plane };
    let map = map.filled().levelled(level);
    let window = |i: usize, count: usize| match is_periodic {
        true => 1.0,
        // Its mean square is 1.
        false => {
            libm::sqrt(8.0 / 3.0) * 0.5 * (1.0 - libm::cos(TAU * (i as f64 + 0.5) / count as f64))
        }
    };
    let places = map.heights().iter().enumerate();
    let windowed = places.map(|(at, height)| height * window(at % nx, nx) * window(at / nx, ny));
    let power = transformed(windowed.collect(), [nx, ny]);
    let rings = averaged(&power, [nx, ny], spacing);
    let found = hurst(&rings, if is_periodic { 1.0 } else { SPREAD });
    let [hurst, hurst_deviation] = found.map_or([None; 2], |both| both.map(Some));
    let density = rings.into_iter().map(|ring| [ring.wave_number, ring.density]).collect();
    Some(Spectrum { density, hurst, hurst_deviation })
}

/// The middle of a map that is too large; a part of it is not periodic.
fn middle(map: &Topography, is_periodic: bool) -> (Topography, bool) {
    let (nx, ny) = (map.columns(), map.rows());
    if nx <= MOST && ny <= MOST {
        return (map.clone(), is_periodic);
    }
    let (mx, my) = (nx.min(MOST), ny.min(MOST));
    let (left, lower) = ((nx - mx) / 2, (ny - my) / 2);
    let rows = map.heights()[lower * nx..(lower + my) * nx].chunks_exact(nx);
    let heights = rows.flat_map(|row| &row[left..left + mx]).copied().collect();
    (Topography::of_parts(mx, heights, map.spacing()), false)
}

/// The squares of the absolute values of the transform.
fn transformed(values: Vec<f64>, [nx, ny]: [usize; 2]) -> Vec<f64> {
    let mut all: Vec<Complex64> =
        values.into_iter().map(|value| Complex64::new(value, 0.0)).collect();
    let along_x = f64::complex_plan(nx).forward;
    all.chunks_exact_mut(nx).for_each(|row| along_x.process(row));
    let along_y = f64::complex_plan(ny).forward;
    let mut column = vec![Complex64::new(0.0, 0.0); ny];
    for i in 0..nx {
        (0..ny).for_each(|j| column[j] = all[j * nx + i]);
        along_y.process(&mut column);
        (0..ny).for_each(|j| all[j * nx + i] = column[j]);
    }
    all.into_iter().map(|value| value.norm_sqr()).collect()
}

/// The waves whose numbers differ little.
struct Ring {
    wave_number: f64,
    density: f64,
    waves: f64,
}

/// Means over rings of wave numbers, up to the largest that all directions have.
fn averaged(power: &[f64], [nx, ny]: [usize; 2], [dx, dy]: [f64; 2]) -> Vec<Ring> {
    let (length_x, length_y) = (nx as f64 * dx, ny as f64 * dy);
    let least = TAU / length_x.min(length_y);
    let most = PI / dx.max(dy);
    if most <= least {
        return Vec::new();
    }
    let bins = libm::ceil(BINS * libm::log10(most / least)) as usize + 1;
    let mut sums = vec![[0.0; 3]; bins];
    let wave = |i: usize, count: usize, length: f64| TAU * i.min(count - i) as f64 / length;
    let scale = dx * dy / (nx * ny) as f64;
    for (at, value) in power.iter().enumerate() {
        let q = libm::hypot(wave(at % nx, nx, length_x), wave(at / nx, ny, length_y));
        if q >= least * (1.0 - 1e-9) && q <= most {
            let bin = libm::floor(BINS * libm::log10(q / least) + 0.5).max(0.0) as usize;
            let sum = &mut sums[bin.min(bins - 1)];
            sum[0] += 1.0;
            sum[1] += libm::log(q);
            sum[2] += scale * value;
        }
    }
    let ring = |[waves, log_q, sum]: [f64; 3]| Ring {
        wave_number: libm::exp(log_q / waves),
        density: sum / waves,
        waves,
    };
    sums.into_iter().filter(|sum| sum[0] > 0.0).map(ring).collect()
}

/// The exponent from a straight line through log C over log q, from the greatest density to before the slope has 95 % of
/// its variance; and its standard deviation.
///
/// The mean over a ring of n independent waves with Gaussian amplitudes scatters by 1/sqrt(n): rings count accordingly. A
/// real amplitude and its mirror image are one wave. The last ring may have waves on its inner side only.
fn hurst(rings: &[Ring], spread: f64) -> Option<[f64; 2]> {
    let top = rings.iter().enumerate().max_by(|a, b| a.1.density.total_cmp(&b.1.density))?.0;
    // The variance of the slope in a ring of equal width in log q is q^4 C.
    let shares: Vec<f64> =
        rings.iter().map(|ring| libm::pow(ring.wave_number, 4.0) * ring.density).collect();
    let all: f64 = shares.iter().sum();
    let mut sum = 0.0;
    let end = shares.iter().position(|share| {
        sum += share;
        sum >= SLOPE * all
    })?;
    let points: Vec<[f64; 3]> = rings
        .get(top..end)?
        .iter()
        .filter(|ring| ring.density > 0.0)
        .map(|ring| {
            let variance = WAVINESS * WAVINESS + 2.0 * spread / ring.waves;
            [libm::log(ring.wave_number), libm::log(ring.density), 1.0 / variance]
        })
        .collect();
    if points.len() < LEAST_BINS {
        return None;
    }
    let total = |f: &dyn Fn(&[f64; 3]) -> f64| points.iter().map(f).sum::<f64>();
    let weights = total(&|[.., w]| *w);
    let [x, y] = [total(&|[x, _, w]| w * x), total(&|[_, y, w]| w * y)].map(|sum| sum / weights);
    let steep = total(&|[px, _, w]| w * (px - x) * (px - x));
    let slope = total(&|[px, py, w]| w * (px - x) * (py - y)) / steep;
    let off = |[px, py, _]: &[f64; 3]| py - y - slope * (px - x);
    let degrees = points.len() as f64 - 2.0;
    let scatter = total(&|point| point[2] * off(point) * off(point)) / degrees;
    let exponent = -0.5 * slope - 1.0;
    let deviation = 0.5 * libm::sqrt(scatter.max(1.0) / steep);
    let is_straight =
        libm::sqrt(total(&|point| off(point) * off(point)) / points.len() as f64) <= STRAIGHT;
    (is_straight && POSSIBLE.contains(&exponent)).then_some([exponent, deviation])
}
