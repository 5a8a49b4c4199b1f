//! The native part of the Python module `carom`: arrays in, arrays out. The package in `python/carom`
//! documents, broadcasts and wraps it for users.

mod arrays;
mod bodies;
mod cases;
mod collide;
mod contact;
mod contacts;
mod creep;
mod error;
mod fit;
mod friction;
mod grains;
mod hertz;
mod influence;
mod line;
mod materials;
#[cfg(all(target_os = "linux", target_env = "gnu"))]
mod memory;
mod meshes;
mod mistakes;
mod plate;
mod quantities;
mod records;
mod restitution;
mod roll;
mod room;
mod show;
mod solver;
mod special;
mod stress;
mod surface;
mod threads;
mod told;
mod twist;
mod walked;

#[cfg(all(target_os = "linux", target_env = "gnu"))]
#[global_allocator]
static MEMORY: memory::LargeMapped = memory::LargeMapped;

/// The native part of carom.
#[pyo3::pymodule]
mod _carom {
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::bodies::Body;
    #[pymodule_export]
    use super::cases::{
        case_hertz, case_history, case_impact, case_new, case_roll, case_scene, case_shell,
        case_solve, case_stress, case_unusual,
    };
    #[pymodule_export]
    use super::collide::{
        collide, collide_many, history, rebound_derivatives, restitution_by_speed,
    };
    #[pymodule_export]
    use super::contact::Contact;
    #[pymodule_export]
    use super::contacts::Contacts;
    #[pymodule_export]
    use super::creep::{creep_coefficients, creep_force, fastsim};
    #[pymodule_export]
    use super::error::{CaromError, RangeError};
    #[pymodule_export]
    use super::fit::{fit, fit_table};
    #[pymodule_export]
    use super::friction::slip_speed_friction;
    #[pymodule_export]
    use super::grains::GrainContacts;
    #[pymodule_export]
    use super::hertz::Hertz;
    #[pymodule_export]
    use super::line::line_state;
    #[pymodule_export]
    use super::materials::{Material, MaterialPair};
    #[pymodule_export]
    use super::meshes::TriangleMesh;
    #[pymodule_export]
    use super::mistakes::{meant, renamed};
    #[pymodule_export]
    use super::plate::Plate;
    #[pymodule_export]
    use super::records::columns;
    #[pymodule_export]
    use super::restitution::{
        restitution, restitution_of_dissimilar, restitution_of_groups, restitution_tables,
    };
    #[pymodule_export]
    use super::roll::roll;
    #[pymodule_export]
    use super::room::available_room;
    #[pymodule_export]
    use super::solver::Solver;
    #[pymodule_export]
    use super::special::{complete, gamma, hyp2f1, hyp3f2, incomplete, ln_gamma};
    #[pymodule_export]
    use super::stress::stress;
    #[pymodule_export]
    use super::surface::{surface_measures, surface_prepared, surface_read};
    #[pymodule_export]
    use super::twist::{ShiftTwist, Twist, lubkin};

    #[pymodule_init]
    fn load(_module: &Bound<'_, PyModule>) -> PyResult<()> {
        super::threads::settle();
        Ok(())
    }

    /// The version of the library.
    #[pymodule_export]
    const __VERSION: &str = env!("CARGO_PKG_VERSION");
}
