//! The constants of the contacts of each two materials.

use std::error::Error;

use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::damping::HertzDamping;
use carom_laws::friction::Friction;
use carom_laws::grains::{GrainContact, compliance_shares};
use carom_laws::hertz::Hertz;
use carom_laws::memory::Fixed;
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;
use carom_special::RangeError;
use dirt_atom::MaterialTable;

/// Vertices of the load history of a contact; what is older and smaller is joined.
pub(crate) const VERTICES: usize = 12;

/// The contact of two grains.
pub(crate) type Contact = GrainContact<Fixed<[f64; 2], VERTICES>>;

/// The constants of each two materials, by the indices of DIRT's table.
pub(crate) struct Pairs(Vec<Vec<Pair>>);

impl Pairs {
    /// From DIRT's table; an error names what the law does not have, or the value that is out of range.
    pub(crate) fn new(table: &MaterialTable) -> Result<Self, String> {
        refuse(table)?;
        let count = table.names.len();
        let row = |i| (0..count).map(|j| Pair::new(table, i, j)).collect();
        let rows: Result<_, Box<dyn Error>> = (0..count).map(row).collect();
        rows.map(Self).map_err(|error| format!("dem.materials: {error}"))
    }

    /// Those of two types of atoms.
    pub(crate) fn of(&self, one: u32, two: u32) -> &Pair {
        &self.0[one as usize][two as usize]
    }
}

/// The models that the law replaces or does not have.
fn refuse(table: &MaterialTable) -> Result<(), String> {
    let words = [
        ("contact_model", &table.contact_model, "hertz"),
        ("tangential_model", &table.tangential_model, "history"),
        ("liquid_bridge_model", &table.liquid_bridge_model, "off"),
    ];
    for (name, word, only) in words {
        if word != only {
            return Err(format!(
                "dem.{name} = \"{word}\" must be \"{only}\" for contacts by carom"
            ));
        }
    }
    let numbers = [
        ("rolling_friction", &table.rolling_friction),
        ("cohesion_energy", &table.cohesion_energy),
        ("surface_energy", &table.surface_energy),
    ];
    for (name, values) in numbers {
        if values.iter().any(|value| *value != 0.0) {
            return Err(format!("{name} of dem.materials must be 0 for contacts by carom"));
        }
    }
    let twists = table.twisting_friction_ij.iter().flatten().any(|value| *value != 0.0);
    if twists || table.twisting_model == "marshall" {
        return Err("contacts by carom have no twisting friction".to_owned());
    }
    Ok(())
}

/// The constants of the contacts of two materials.
pub(crate) struct Pair {
    /// Stiffness at a relative radius of 1 m.
    stiffness: ContactStiffness,
    friction: Friction,
    damping: HertzDamping,
    /// The part of the approach by which each body is compressed.
    pub(crate) shares: [f64; 2],
}

impl Pair {
    fn new(table: &MaterialTable, i: usize, j: usize) -> Result<Self, Box<dyn Error>> {
        let material = |i: usize| Material::from_young(table.youngs_mod[i], table.poisson_ratio[i]);
        let materials = MaterialPair::new(material(i)?, material(j)?)?;
        // A gap of r^2/2, that of a relative radius of 1 m.
        let gap = RelativeCurvature::from_coefficients(0.5, 0.5)?;
        let unit = Hertz::new(gap, materials)?;
        // DIRT's mean.
        let restitution = (table.restitution[i] * table.restitution[j]).sqrt();
        Ok(Self {
            stiffness: unit.stiffness(),
            friction: Friction::new(table.friction_ij[i][j])?,
            damping: HertzDamping::of_restitution(restitution)?,
            shares: compliance_shares(&materials),
        })
    }

    /// A new contact of grains of these radii.
    pub(crate) fn contact(&self, radii: [f64; 2]) -> Result<Contact, RangeError> {
        // Stiffnesses grow as the root of the relative radius.
        let by = (1.0 / (1.0 / radii[0] + 1.0 / radii[1])).sqrt();
        let ContactStiffness { c_x, c_y, c_z } = self.stiffness;
        let stiffness = ContactStiffness::new(by * c_x, by * c_y, by * c_z)?;
        let contact = GrainContact::new(ShiftLaw::new(stiffness, self.friction), 0.0)?;
        Ok(contact.with_restitution(self.damping))
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use dirt_atom::{Elastic, Friction, Material};

    /// A table with one material.
    pub(crate) fn glass() -> MaterialTable {
        let mut table = MaterialTable::new();
        let glass = Material::new("glass", Elastic::new(70e9, 0.22, 0.9));
        table
            .add(glass.with_friction(Friction { sliding: 0.3, rolling: 0.0, twisting: 0.0 }))
            .unwrap();
        table.build_pair_tables();
        table
    }

    #[test]
    fn stiffness_is_that_of_hertz_and_mindlin() {
        let table = glass();
        let pairs = Pairs::new(&table).unwrap();
        let contact = pairs.of(0, 0).contact([2e-3, 6e-3]).unwrap();
        let root = 1.5e-3_f64.sqrt();
        let ContactStiffness { c_x, c_y, c_z } = contact.law().stiffness();
        // DIRT's own moduli: F = (4/3) E* sqrt(R) zeta^1.5, dF/dxi = 8 G* sqrt(R zeta).
        let (normal, tangential) = (2.0 * table.e_eff_ij[0][0], 8.0 * table.g_eff_ij[0][0]);
        assert!((c_z / (normal * root) - 1.0).abs() < 1e-12);
        assert!((c_x / (tangential * root) - 1.0).abs() < 1e-12);
        assert_eq!(c_x, c_y);
    }

    #[test]
    fn models_that_the_law_does_not_have_are_refused() {
        let refuses = |change: fn(&mut MaterialTable)| {
            let mut table = glass();
            change(&mut table);
            Pairs::new(&table).err().unwrap()
        };
        assert!(refuses(|table| table.contact_model = "hooke".into()).contains("contact_model"));
        assert!(refuses(|table| table.rolling_friction[0] = 0.1).contains("rolling_friction"));
        assert!(refuses(|table| table.surface_energy[0] = 0.1).contains("surface_energy"));
        assert!(refuses(|table| table.poisson_ratio[0] = 0.6).contains("poisson"));
    }
}
