//! States of bellows by the principle of virtual work: the energy of displaced shapes, written with
//! the positions r and z alone, is stationary. Nothing here uses the equations of equilibrium.

use std::f64::consts::{PI, TAU};

use carom_shells::Wall;
use carom_shells::bellows::{Axial, Bellows, BellowsLoad, BellowsState, Meridian};

/// r0 = R + b cos xi, z0 = pitch xi/2 pi, an elastic wall, a pressure.
struct Shell {
    mean: f64,
    amplitude: f64,
    pitch: f64,
    wall: Wall,
}

/// r = sum r_k cos k xi, z = z_0 xi + sum z_k sin k xi.
#[derive(Clone)]
struct Shape {
    radii: Vec<f64>,
    heights: Vec<f64>,
}

const COUNT: usize = 512;

impl Shape {
    /// From samples at crest to root.
    fn of(state: &BellowsState) -> Self {
        let places = state.profile();
        let last = places.len() - 1;
        let slope = places[last].height / PI;
        let weight = |j: usize| if j == 0 || j == last { 0.5 } else { 1.0 } * 2.0 / last as f64;
        let order = last / 2;
        let radii = (0..=order).map(|k| {
            let each = places
                .iter()
                .enumerate()
                .map(|(j, at)| weight(j) * at.radius * (k as f64 * at.parameter).cos());
            if k == 0 { 0.5 * each.sum::<f64>() } else { each.sum() }
        });
        let heights = (0..=order).map(|k| {
            let each = places.iter().enumerate().map(|(j, at)| {
                weight(j) * (at.height - slope * at.parameter) * (k as f64 * at.parameter).sin()
            });
            if k == 0 { slope } else { each.sum() }
        });
        Self { radii: radii.collect(), heights: heights.collect() }
    }

    /// r, r', r'', z', z''.
    fn at(&self, xi: f64) -> [f64; 5] {
        let mut at = [0.0, 0.0, 0.0, self.heights[0], 0.0];
        for (k, r) in self.radii.iter().enumerate() {
            let kf = k as f64;
            at[0] += r * (kf * xi).cos();
            at[1] -= kf * r * (kf * xi).sin();
            at[2] -= kf * kf * r * (kf * xi).cos();
        }
        for (k, z) in self.heights.iter().enumerate().skip(1) {
            let kf = k as f64;
            at[3] += kf * z * (kf * xi).cos();
            at[4] -= kf * kf * z * (kf * xi).sin();
        }
        at
    }

    fn length(&self) -> f64 {
        TAU * self.heights[0]
    }
}

impl Shell {
    /// Stored energy and volume of a shape.
    fn energy_and_volume(&self, shape: &Shape) -> [f64; 2] {
        let (c, d, nu) =
            (self.wall.stretching_stiffness(), self.wall.bending_stiffness(), self.wall.poisson());
        let q = self.pitch / TAU;
        let mut sum = [0.0, 0.0];
        for i in 0..COUNT {
            let xi = TAU * i as f64 / COUNT as f64;
            let (r0, r0_slope, r0_bend) = (
                self.mean + self.amplitude * xi.cos(),
                -self.amplitude * xi.sin(),
                -self.amplitude * xi.cos(),
            );
            let g = r0_slope.hypot(q);
            let [r, r_slope, r_bend, z_slope, z_bend] = shape.at(xi);
            let length = r_slope.hypot(z_slope);
            let strain = length / g - 1.0;
            let hoop = r / r0 - 1.0;
            let turning = (r_slope * z_bend - z_slope * r_bend) / (length * length);
            let turning_0 = -q * r0_bend / (g * g);
            let bend = (turning - turning_0) / g;
            let bend_hoop = (z_slope / length - q / g) / r0;
            let density = c * (strain * strain + 2.0 * nu * strain * hoop + hoop * hoop)
                + d * (bend * bend + 2.0 * nu * bend * bend_hoop + bend_hoop * bend_hoop);
            sum[0] += 0.5 * TAU * density * r0 * g * TAU / COUNT as f64;
            sum[1] += PI * r * r * z_slope * TAU / COUNT as f64;
        }
        sum
    }

    fn check(&self, harmonics: usize, load: BellowsLoad, least_rotation: f64) {
        let meridian = Meridian::sine(self.mean, self.amplitude, self.pitch).unwrap();
        let bellows = Bellows::new(meridian, self.wall, harmonics).unwrap();
        let state = bellows.solve(load).unwrap();
        assert!(state.greatest_rotation() > least_rotation, "{}", state.greatest_rotation());
        let shape = Shape::of(&state);
        let [energy, volume] = self.energy_and_volume(&shape);
        let near = |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 1e-8);
        near(energy, state.stored_energy());
        near(volume, state.volume());
        near(shape.length(), self.pitch + state.dilatation());
        for k in 0..12 {
            for is_radial in [true, false] {
                let displaced = |amount: f64| {
                    let mut shape = shape.clone();
                    let list = if is_radial { &mut shape.radii } else { &mut shape.heights };
                    list[k] += amount;
                    let [energy, volume] = self.energy_and_volume(&shape);
                    let work = load.pressure() * volume + state.force() * shape.length();
                    [energy, work]
                };
                let step = 1e-4 * self.wall.thickness();
                let [plus, minus] = [displaced(step), displaced(-step)];
                // Its own energy, by which the difference of work and energy is measured.
                let own = (plus[0] + minus[0] - 2.0 * energy).abs() / (step * step);
                let rate = (plus[0] - plus[1] - minus[0] + minus[1]) / (2.0 * step);
                let ratio = rate.abs() / (own * 2.0 * energy).sqrt();
                assert!(ratio < 2e-6, "{k} {is_radial}: {ratio:e}");
            }
        }
    }
}

fn load(pressure: f64, axial: Axial) -> BellowsLoad {
    BellowsLoad::new(pressure, axial).unwrap()
}

#[test]
fn stretched_bellows_is_in_equilibrium() {
    let shell =
        Shell { mean: 8.0, amplitude: 0.7, pitch: 2.4, wall: Wall::new(2.0, 0.2, 0.06).unwrap() };
    shell.check(40, load(0.0, Axial::Dilatation(0.5)), 0.2);
}

#[test]
fn pressed_bellows_is_in_equilibrium() {
    let shell =
        Shell { mean: 8.0, amplitude: 0.7, pitch: 2.4, wall: Wall::new(2.0, 0.4, 0.06).unwrap() };
    shell.check(48, load(1e-3, Axial::Force(-0.05)), 0.2);
    // From outside.
    shell.check(48, load(-3e-4, Axial::Dilatation(-0.2)), 0.1);
}
