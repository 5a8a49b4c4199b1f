//! The plugins: the contact, and DIRT's default group with it.

use dirt_atom::{DemAtomInsertPlugin, DemAtomPlugin, MaterialTable};
use dirt_granular::RotationalDynamicsPlugin;
use dirt_schedule::CONTACT_FORCE;
use grass_app::prelude::*;
use grass_scheduler::prelude::*;
use soil_core::{ParticleSimScheduleSet, VirialStressPlugin, register_atom_data};
use soil_verlet::VelocityVerletPlugin;

use crate::contacts::Contacts;
use crate::force::contact_force;
use crate::pairs::Pairs;

/// The contact forces of grains by carom, in place of DIRT's `HertzMindlinContactPlugin`.
///
/// Materials are those of `[[dem.materials]]`: Young's modulus, Poisson's ratio, friction, restitution. What the law does
/// not have is refused when the app is built: other contact, tangential and adhesion models, rolling and twisting
/// friction, cohesion, liquid bridges. Walls stay DIRT's.
pub struct CaromContactPlugin;

impl Plugin for CaromContactPlugin {
    fn dependencies(&self) -> Vec<std::any::TypeId> {
        grass_app::type_ids![DemAtomPlugin]
    }

    fn provides(&self) -> Vec<&str> {
        vec!["contact_forces"]
    }

    fn requires(&self) -> Vec<&str> {
        vec!["dem_particles", "neighbor_list"]
    }

    fn build(&self, app: &mut App) {
        if let Err(error) = self.try_build(app) {
            panic!("{error}");
        }
    }

    fn try_build(&self, app: &mut App) -> Result<(), AppError> {
        let pairs = {
            let table = app.get_resource_ref::<MaterialTable>();
            let table = table.ok_or_else(|| AppError::message("there are no dem.materials"))?;
            Pairs::new(&table).map_err(AppError::message)?
        };
        app.add_plugins(VirialStressPlugin);
        register_atom_data!(app, Contacts::default());
        app.add_resource(pairs);
        let force = contact_force.label(CONTACT_FORCE);
        app.add_update_system(force, ParticleSimScheduleSet::Force);
        Ok(())
    }
}

/// DIRT's `GranularDefaultPlugins` with carom's contact.
///
/// DIRT's group cannot be asked to leave its contact out: its builder skips only what is added after `disable`.
pub struct CaromGranularPlugins;

impl PluginGroup for CaromGranularPlugins {
    fn build(self) -> PluginGroupBuilder {
        PluginGroupBuilder::start::<Self>()
            .add(DemAtomPlugin)
            .add(DemAtomInsertPlugin)
            .add(VelocityVerletPlugin::new())
            .add(CaromContactPlugin)
            .add(RotationalDynamicsPlugin)
    }
}
