//! DIRT's bench of oblique impact: one sphere against another that is held fast.

use carom_dirt::CaromGranularPlugins;
use carom_geometry::Inertia;
use carom_halfspace::Material;
use carom_impact::{Body, Collision, Motion};
use carom_laws::friction::Friction;
use dirt_core::dirt_atom::DemAtom;
use dirt_core::prelude::{
    App, Atom, Config, CorePlugins, FixesPlugin, GranularDefaultPlugins, Input,
    ParticleSimScheduleSet, ParticlesWith, Read, Res, ResMut,
};

/// The material of DIRT's bench, alumina: Young's modulus in Pa, Poisson's ratio, friction, density in kg/m3.
pub(crate) const YOUNG: f64 = 380e9;
pub(crate) const POISSON: f64 = 0.23;
pub(crate) const FRICTION: f64 = 0.092;
pub(crate) const DENSITY: f64 = 4000.0;
/// The radius of both spheres, m.
pub(crate) const RADIUS: f64 = 0.005;
/// Gap at the start, m.
const GAP: f64 = 1e-3;

/// An impact of the bench.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Trial {
    /// Tangential over approach velocity, times 2 (1 - nu)/(f (2 - nu)).
    pub(crate) psi: f64,
    /// Speed of approach, m/s; 1 in the bench.
    pub(crate) approach: f64,
    /// The coefficient of restitution that DIRT is given.
    pub(crate) restitution: f64,
    /// Time step, s.
    pub(crate) step: f64,
}

/// Whose contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Contact {
    /// The tangential spring.
    Dirts,
    /// With memory.
    Caroms,
}

/// An impact as the bench sees it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Bounce {
    normal: [f64; 3],
    before: [f64; 3],
    /// Velocity and spin at the end.
    after: [f64; 3],
    spin: [f64; 3],
    has_touched: bool,
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl Bounce {
    /// R_x: the tangential velocity of the contact point after the impact, reversed, over that before.
    pub(crate) fn r_x(&self) -> f64 {
        let along = self.tangential(self.before);
        let [x, y, z] = self.normal;
        let [a, b, c] = self.spin;
        // The contact point lies at - R n.
        let turning = [b * z - c * y, c * x - a * z, a * y - b * x].map(|part| -RADIUS * part);
        let after: [f64; 3] = std::array::from_fn(|i| self.after[i] + turning[i]);
        -dot(after, along) / dot(along, along)
    }

    /// The normal velocity after over that before.
    pub(crate) fn restitution(&self) -> f64 {
        -dot(self.after, self.normal) / dot(self.before, self.normal)
    }

    /// The kinetic energy after over that before.
    pub(crate) fn energy(&self) -> f64 {
        let after = dot(self.after, self.after) + 0.4 * RADIUS * RADIUS * dot(self.spin, self.spin);
        after / dot(self.before, self.before)
    }

    /// The tangential over the normal impulse.
    pub(crate) fn grip(&self) -> f64 {
        let change: [f64; 3] = std::array::from_fn(|i| self.after[i] - self.before[i]);
        let drag = self.tangential(change);
        dot(drag, drag).sqrt() / dot(change, self.normal)
    }

    fn tangential(&self, v: [f64; 3]) -> [f64; 3] {
        let press = dot(v, self.normal);
        std::array::from_fn(|i| v[i] - press * self.normal[i])
    }
}

impl Trial {
    /// An elastic impact at DIRT's time step.
    pub(crate) fn elastic(psi: f64) -> Self {
        Self { psi, approach: 1.0, restitution: 1.0, step: 1e-7 }
    }

    /// Tangential velocity, m/s.
    fn across(&self) -> f64 {
        self.psi * FRICTION * (2.0 - POISSON) / (2.0 * (1.0 - POISSON)) * self.approach
    }

    /// R_x of the exact impact.
    pub(crate) fn exact(&self) -> f64 {
        let alumina = Material::from_young(YOUNG, POISSON).unwrap();
        let motion = Motion::new([self.across(), 0.0, -self.approach], [0.0; 3]).unwrap();
        let ball = || Body::sphere(RADIUS, alumina, 1.0).unwrap();
        let held = ball().with_inertia(Inertia::FIXED);
        let friction = Friction::new(FRICTION).unwrap();
        let outcome =
            Collision::new(ball().moving(motion), held, friction).unwrap().solve().unwrap();
        outcome.rebound().and_then(|rebound| rebound.r_x).unwrap()
    }

    /// The bench with this contact.
    pub(crate) fn run(&self, contact: Contact) -> Bounce {
        let mut app = App::new();
        app.add_resource(Config::from_str(&self.config()));
        app.add_resource(Input { filename: String::new(), output_dir: None });
        app.add_plugins(CorePlugins);
        match contact {
            Contact::Dirts => app.add_plugins(GranularDefaultPlugins),
            Contact::Caroms => app.add_plugins(CaromGranularPlugins),
        };
        app.add_plugins(FixesPlugin);
        app.add_resource(Bounce::default());
        app.add_update_system(watch, ParticleSimScheduleSet::PostFinalIntegration);
        app.start();
        let bounce = *app.get_resource_ref::<Bounce>().unwrap();
        assert!(
            bounce.has_touched && dot(bounce.after, bounce.normal) > 0.0,
            "{self:?} {bounce:?}"
        );
        bounce
    }

    fn config(&self) -> String {
        let Self { approach, restitution, step, .. } = *self;
        let across = self.across();
        // The centres are 2 R apart when the sphere arrives above the other.
        let (x, z) = (-across / approach * GAP, 0.05 + 2.0 * RADIUS + GAP);
        let steps = ((1.5 * GAP / approach + 1e-4) / step) as u64;
        format!(
            r#"
[domain]
x_low = -0.3
x_high = 0.3
y_low = -0.02
y_high = 0.02
z_low = 0.0
z_high = 0.2
boundary_x = "fixed"
boundary_y = "fixed"
boundary_z = "fixed"
[neighbor]
skin_fraction = 1.1
bin_size = 0.02
every = 1
[[dem.materials]]
name = "alumina"
youngs_mod = {YOUNG:e}
poisson_ratio = {POISSON}
restitution = {restitution}
friction = {FRICTION}
[[particles.insert]]
material = "alumina"
count = 1
radius = {RADIUS}
density = {DENSITY}
region = {{ type = "block", min = [-1e-9, -1e-9, 0.049999999], max = [1e-9, 1e-9, 0.050000001] }}
[[particles.insert]]
material = "alumina"
count = 1
radius = {RADIUS}
density = {DENSITY}
velocity_x = {across}
velocity_z = -{approach}
region = {{ type = "block", min = [{}, -1e-9, {}], max = [{}, 1e-9, {}] }}
[[group]]
name = "target"
region = {{ type = "block", min = [-0.002, -0.002, 0.045], max = [0.002, 0.002, 0.055] }}
[[freeze]]
group = "target"
[run]
steps = {steps}
thermo = {steps}
dt = {step:e}
"#,
            x - 1e-9,
            z - 1e-9,
            x + 1e-9,
            z + 1e-9,
        )
    }
}

/// Keeps the motion of the upper sphere, and the normal at the first touch.
fn watch(
    atoms: Res<'_, Atom>,
    particles: ParticlesWith<'_, Read<DemAtom>>,
    mut bounce: ResMut<'_, Bounce>,
) {
    particles.with(|dem| {
        if atoms.nlocal() != 2 {
            return;
        }
        let (ball, held) = if atoms.pos[0][2] > atoms.pos[1][2] { (0, 1) } else { (1, 0) };
        let apart: [f64; 3] = std::array::from_fn(|i| atoms.pos[ball][i] - atoms.pos[held][i]);
        let distance = dot(apart, apart).sqrt();
        let normal = apart.map(|part| part / distance);
        if distance < 2.0 * RADIUS && !bounce.has_touched {
            (bounce.normal, bounce.has_touched) = (normal, true);
        }
        if !bounce.has_touched {
            bounce.before = atoms.vel[ball];
        }
        (bounce.after, bounce.spin) = (atoms.vel[ball], dem.omega[ball]);
    });
}
