//! The declarations of the header in groups, one for each task of a user.

use std::collections::HashMap;
use std::path::Path;

/// A group: its title, where to begin, and the modules whose items it has.
struct Group {
    title: &'static str,
    about: &'static str,
    modules: &'static [&'static str],
}

const GROUPS: &[Group] = &[
    Group { title: "Errors and versions", about: "", modules: &["error", "version"] },
    Group {
        title: "Constants of a pair",
        about: "carom_pair_of_spheres and carom_pair_of_curvatures make the constants of a contact from the\n\
                materials and the shape, carom_pair_of_stiffness from stiffnesses.",
        modules: &["pair"],
    },
    Group {
        title: "One contact with memory",
        about: "carom_contact_advance moves a contact of a carom_pair to a new approach and shift and returns the\n\
                load; carom_contact_advance_many does so for an array.",
        modules: &["law", "state", "contact", "batch"],
    },
    Group {
        title: "Contacts of particles: grains and walls",
        about: "carom_grains_of makes the constants of two materials. carom_touch_grains and carom_touch_wall make\n\
                one step of a contact: positions, velocities and spins in, force and torques out;\n\
                carom_touch_surface does so at walls that are curved or turn, with the constants of\n\
                carom_grains_on_curved_wall.\n\
                carom_grains_impact_time tells how long an impact lasts, for the choice of the time step.",
        modules: &["grains", "meeting.rs", "contact.rs", "touch", "grain_friction", "encounters"],
    },
    Group {
        title: "Impacts",
        about: "carom_collide computes the impact of two bodies.",
        modules: &["collide_options", "impact"],
    },
    Group {
        title: "R_x of spheres",
        about: "R_x is minus the tangential velocity of the contact after an impact over that before.",
        modules: &["restitution"],
    },
    Group {
        title: "Creep coefficients of a rolling contact",
        about: "carom_creep_coefficients gives the forces of a wheel on a rail, or of any rolling bodies, at small\n\
                creepage.",
        modules: &["creep"],
    },
    Group {
        title: "Limits of the theory",
        about: "Warnings of an impact are bits of carom_rebound; carom_warning_text gives their words.\n\
                carom_pair_validity and carom_grains_validity tell whether a contact is small enough for Hertz's\n\
                theory, carom_grains_impact_validity whether an impact is slow enough and its time step short\n\
                enough; carom_validity_text says it in a sentence.",
        modules: &["validity"],
    },
    Group {
        title: "Twist about the normal",
        about: "The torque of spin about the normal: carom_twist_advance for a carom_pair, carom_touch_twist_grains\n\
                and carom_touch_twist_wall for particles.",
        modules: &["twist", "touch_twist"],
    },
    Group {
        title: "Rolling resistance of particles",
        about: "carom_touch_roll_grains and carom_touch_roll_surface add the torque of a spring, a dashpot and a\n\
                slider to the load of a touch.",
        modules: &["touch_roll"],
    },
    Group {
        title: "Rings: particles of dissimilar materials",
        about: "Shift, twist and the coupling of dissimilar materials act together. carom_rings_of makes the\n\
                matrices of two materials, carom_ring_touch_grains and carom_ring_touch_wall make a step.",
        modules: &["rings", "ring_touch"],
    },
];

/// Modules of `carom_laws::grains` whose structures the header has too.
pub(super) const BELOW: [&str; 2] = ["meeting.rs", "contact.rs"];

/// The list of the groups, as a comment.
pub(super) fn contents() -> String {
    let lines =
        GROUPS.iter().enumerate().map(|(i, group)| format!("//   {}. {}\n", i + 1, group.title));
    format!(
        "//\n// Contents\n//\n{}\n\
         #ifndef CAROM_H\n#define CAROM_H\n\n#include <stddef.h>\n#include <stdint.h>\n",
        lines.collect::<String>()
    )
}

/// The module of each item, by its name in C.
pub(super) struct Modules(HashMap<String, &'static str>);

impl Modules {
    pub(super) fn read(root: &Path, config: &cbindgen::Config) -> Self {
        let mut modules = HashMap::new();
        for module in GROUPS.iter().flat_map(|group| group.modules) {
            let path = match module.ends_with(".rs") {
                true => root.join("../laws/src/grains").join(module),
                false => root.join(format!("src/{module}.rs")),
            };
            let text = std::fs::read_to_string(&path).unwrap();
            for name in text.lines().filter_map(item) {
                let name = config.export.rename.get(name).map_or(name, String::as_str);
                let other = modules.insert(name.to_owned(), *module);
                assert!(other.is_none(), "{name} is in {other:?} and {module}");
            }
        }
        Self(modules)
    }

    /// The declarations that cbindgen wrote, group by group: of each module its constants, structures and
    /// functions.
    pub(super) fn arrange(&self, declared: &str) -> String {
        let blocks = declared.split("\n\n").map(str::trim).filter(|block| !is_frame(block));
        let mut blocks: Vec<_> = blocks.map(|block| (self.place(name(block)), block)).collect();
        blocks.sort_by_key(|(place, _)| *place);
        let names: Vec<_> = blocks.iter().map(|(_, block)| name(block)).collect();
        assert!(
            (1..names.len()).all(|i| !names[i..].contains(&names[i - 1])),
            "declared twice: {names:?}"
        );
        let mut text = String::new();
        for (i, group) in GROUPS.iter().enumerate() {
            text.push_str(&banner(i, group));
            let own = blocks.iter().filter(|((of, _), _)| *of == i);
            own.for_each(|(_, block)| text.push_str(&format!("\n{}\n", plain(block))));
        }
        text
    }

    /// The group of an item and the place of its module there.
    fn place(&self, name: &str) -> (usize, usize) {
        let module =
            self.0.get(name).unwrap_or_else(|| panic!("no group has a module with {name}"));
        let mut places = GROUPS.iter().enumerate().filter_map(|(i, group)| {
            Some((i, group.modules.iter().position(|own| own == module)?))
        });
        places.next().unwrap()
    }
}

fn banner(i: usize, group: &Group) -> String {
    let about: String = group.about.lines().map(|line| format!("\n// {line}")).collect();
    let about = if about.is_empty() { about } else { format!("\n//{about}") };
    let title = format!("{}. {}", i + 1, group.title);
    format!("\n// ---- {title} {}{about}\n", "-".repeat(73 - title.len()))
}

/// The name of the item that a line of Rust declares.
fn item(line: &str) -> Option<&str> {
    let starts = [
        "pub const ",
        "pub struct ",
        "pub enum ",
        "pub unsafe extern \"C\" fn ",
        "pub extern \"C\" fn ",
    ];
    let rest = starts.iter().find_map(|start| line.strip_prefix(start))?;
    rest.split(|c: char| !c.is_alphanumeric() && c != '_').next()
}

/// Whether a block is no declaration but what frames them for C++.
fn is_frame(block: &str) -> bool {
    block.is_empty() || block.starts_with("#ifdef __cplusplus")
}

/// The name that a block declares.
fn name(block: &str) -> &str {
    let line = block.lines().find(|line| !line.starts_with("//")).unwrap_or_default();
    let before = line.split(['(', '{']).next().unwrap_or_default();
    let mut words =
        before.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty());
    match before.starts_with("#define") {
        true => words.nth(1),
        false => words.next_back(),
    }
    .unwrap_or_else(|| panic!("no name in {block}"))
}

/// A block without what its comment says for Rust only.
fn plain(block: &str) -> String {
    let rust_only =
        ["// # Safety", "// Pointers and memories are as [the crate](crate#pointers) asks."];
    let mut lines: Vec<&str> = block.lines().filter(|line| !rust_only.contains(line)).collect();
    // The empty line before them, if nothing follows.
    let code = lines.iter().position(|line| !line.starts_with("//")).unwrap_or(0);
    if code > 0 && lines[code - 1].trim() == "//" {
        lines.remove(code - 1);
    }
    lines.join("\n")
}
