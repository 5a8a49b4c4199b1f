//! The forces of a step.

use carom_laws::grains::{Grain, GrainLoad, Meeting};
use carom_special::RangeError;
use dirt_atom::{DemAtom, same_body};
use grass_scheduler::prelude::*;
use soil_core::{Atom, BondStore, Neighbor, Optional, ParticlesWith, Read, VirialStress, Write};

use crate::contacts::Contacts;
use crate::pairs::Pairs;

type Columns = (Write<DemAtom>, Write<Contacts>, Optional<Read<BondStore>>);

/// Adds the forces and torques of all contacts. DIRT's systems have no errors: as its own contact does, this one stops
/// the program where a contact cannot go on.
pub(crate) fn contact_force(
    mut atoms: ResMut<'_, Atom>,
    neighbor: Res<'_, Neighbor>,
    particles: ParticlesWith<'_, Columns>,
    pairs: Res<'_, Pairs>,
    mut virial: Option<ResMut<'_, VirialStress>>,
) {
    particles.with(|(mut dem, mut contacts, bonds)| {
        contacts.begin(atoms.len());
        let local = atoms.nlocal() as usize;
        for (i, j) in neighbor.pairs(local) {
            let is_excluded = bonds.as_ref().is_some_and(|b| b.are_excluded(i, j, &atoms.tag));
            if is_excluded || same_body(&dem, i, j) {
                continue;
            }
            let load = match load(&atoms, &dem, &mut contacts, &pairs, [i, j]) {
                Ok(None) => continue,
                Ok(Some(load)) => load,
                Err(error) => {
                    panic!("contact of atoms {} and {}: {error}", atoms.tag[i], atoms.tag[j])
                }
            };
            // DIRT meets a pair twice if it does not use Newton's third law.
            let both = neighbor.newton;
            add(&mut atoms, &mut dem, i, load.force, load.torques[0], 1.0);
            if both {
                add(&mut atoms, &mut dem, j, load.force, load.torques[1], -1.0);
            }
            if let Some(virial) = virial.as_mut().filter(|virial| virial.active) {
                let part = if both { 1.0 } else { 0.5 };
                let [x, y, z] = apart(&atoms, [i, j]);
                let [f_x, f_y, f_z] = load.force.map(|force| part * force);
                virial.add_pair(x, y, z, f_x, f_y, f_z);
            }
        }
        contacts.end();
    });
}

/// The load on atom `i` by atom `j`, with the torque on each; none if they do not touch.
fn load(
    atoms: &Atom,
    dem: &DemAtom,
    contacts: &mut Contacts,
    pairs: &Pairs,
    [i, j]: [usize; 2],
) -> Result<Option<GrainLoad>, RangeError> {
    let reach = dem.radius[i] + dem.radius[j];
    let square: f64 = apart(atoms, [i, j]).iter().map(|part| part * part).sum();
    if square >= reach * reach {
        return Ok(None);
    }
    let tags = [atoms.tag[i], atoms.tag[j]];
    // The contact keeps its sense whatever the order of the pair: body 1 has the lower tag.
    let is_turned = tags[1] < tags[0];
    let [one, two] = if is_turned { [j, i] } else { [i, j] };
    let pair = pairs.of(atoms.atom_type[one], atoms.atom_type[two]);
    let radii = [dem.radius[one], dem.radius[two]];
    let meeting =
        Meeting::of_spheres(&grain(atoms, dem, one), &grain(atoms, dem, two), pair.shares)?;
    let entry = contacts.of([i, owner(atoms, j)], tags, || pair.contact(radii))?;
    let load = entry.live(pair, radii)?.advance(&meeting, atoms.dt)?;
    let [first, second] = load.torques;
    Ok(Some(match is_turned {
        false => load,
        true => GrainLoad { force: load.force.map(|force| -force), torques: [second, first] },
    }))
}

/// The atom itself, or the one that a ghost is a copy of if it is here too.
fn owner(atoms: &Atom, j: usize) -> usize {
    let origin = usize::try_from(atoms.origin_index[j]).unwrap_or(j);
    let is_here = j >= atoms.nlocal() as usize && origin < atoms.nlocal() as usize;
    if is_here && atoms.tag[origin] == atoms.tag[j] { origin } else { j }
}

/// From atom `i` to atom `j`.
fn apart(atoms: &Atom, [i, j]: [usize; 2]) -> [f64; 3] {
    std::array::from_fn(|k| atoms.pos[j][k] - atoms.pos[i][k])
}

fn grain(atoms: &Atom, dem: &DemAtom, i: usize) -> Grain {
    Grain {
        place: atoms.pos[i],
        velocity: atoms.vel[i],
        spin: dem.omega[i],
        radius: dem.radius[i],
        mass: atoms.mass[i],
    }
}

fn add(
    atoms: &mut Atom,
    dem: &mut DemAtom,
    i: usize,
    force: [f64; 3],
    torque: [f64; 3],
    sign: f64,
) {
    for k in 0..3 {
        atoms.force[i][k] += sign * force[k];
        dem.torque[i][k] += torque[k];
    }
}
