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
        title: "Materials and the names of laws",
        about: "carom_law_of_name reads the name of a law in an input file.",
        modules: &["material"],
    },
    Group {
        title: "Contacts of particles: grains and walls",
        about: "carom_law_make makes the law of the contacts of two materials: friction, damping, torsion, resistance\n\
                to rolling; carom_law_on_curved_wall that of a grain at a curved wall. carom_touch_step makes one step\n\
                of a contact, whose memory has carom_touch_size bytes: positions, velocities and spins in, force and\n\
                torques out; carom_touch_step_many makes those of many. carom_touch_pack writes a contact as numbers.",
        modules: &[
            "law/options",
            "law/mod",
            "meeting.rs",
            "heats.rs",
            "touch/report",
            "touch/mod",
            "touch/step",
            "touch/many",
            "touch/told",
            "touch/packed",
        ],
    },
    Group {
        title: "Surfaces of triangles",
        about: "carom_mesh_make makes a surface of triangles, carom_mesh_places finds where a ball touches it: places and\n\
                normals of the walls of carom_touch_step.",
        modules: &["mesh"],
    },
    Group {
        title: "Contacts with given shifts",
        about: "carom_pair_of_spheres and carom_pair_of_curvatures make the constants of a contact from the\n\
                materials and the shape. carom_contact_advance moves a contact to a new approach and shift and returns\n\
                the load; carom_contact_advance_many does so for an array.",
        modules: &["pair", "shift", "state", "contact", "batch"],
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
        title: "Creep forces of a rolling contact",
        about: "carom_creep_coefficients gives the forces of a wheel on a rail, or of any rolling bodies, at small\n\
                creepage, carom_creep_force at any creepage and spin.",
        modules: &["creep"],
    },
    Group {
        title: "Limits of the theory",
        about: "Warnings of an impact are bits of carom_rebound; carom_warning_text gives their words.\n\
                carom_law_validity tells whether a contact is small enough for Hertz's theory,\n\
                carom_law_impact_validity whether an impact is slow enough and its time step short enough;\n\
                carom_validity_text says it in a sentence. carom_law_impact_time tells how long an impact lasts.",
        modules: &["validity", "law/limits"],
    },
];

/// Modules of `carom_laws::grains` whose structures the header has too.
pub(super) const BELOW: [&str; 2] = ["meeting.rs", "heats.rs"];

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
