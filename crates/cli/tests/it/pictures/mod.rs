//! Pictures agree with the results: every curve of every panel is compared with the rows.

mod grids;
mod histories;
mod impacts;
mod statics;

use crate::common::picture::{Panel, panels};
use crate::common::{fresh, stdout};
use serde_json::Value;

/// A panel: its title, the labels of its axes, and its curves by name with what they show of a row.
type Wanted<'a> = (&'a str, [&'a str; 2], Vec<(&'a str, [&'a str; 2])>);

/// Results of a command in JSON, with its picture.
fn both(arguments: &[&str], name: &str) -> (Value, Vec<Panel>) {
    let file = fresh(name);
    let all: &[&str] = if arguments[0] == "restitution" { &[] } else { &["--panels", "all"] };
    let file_name = file.to_str().unwrap();
    let plotted = [arguments, all, &["--format", "json", "--plot", file_name]].concat();
    let results = serde_json::from_str(&stdout(&plotted)).unwrap();
    (results, panels(&std::fs::read_to_string(&file).unwrap()))
}

/// A number of a row by its path: `F_z`, `force.2`, or `-depth` for the opposite.
fn number(row: &Value, path: &str) -> f64 {
    let (sign, path) = path.strip_prefix('-').map_or((1.0, path), |path| (-1.0, path));
    let found = path.split('.').fold(row, |at, part| match part.parse::<usize>() {
        Ok(index) => &at[index],
        Err(_) => &at[part],
    });
    sign * found.as_f64().unwrap_or_else(|| panic!("{path} of {row}"))
}

/// Every row lies on its curves, and no two curves of a panel show the same.
fn shows(panels: &[Panel], rows: &[Value], wanted: &[Wanted<'_>]) {
    for (title, labels, curves) in wanted {
        let of = |panel: &&Panel| {
            panel.title == *title && [panel.x.label.as_str(), &panel.y.label] == *labels
        };
        let mut found = panels.iter().filter(of);
        let told = || panels.iter().map(|p| (&p.title, &p.x.label, &p.y.label)).collect::<Vec<_>>();
        let panel = found.next().unwrap_or_else(|| panic!("{title} {labels:?} in {:?}", told()));
        for (name, [x, y]) in curves {
            for row in rows {
                let at = [number(row, x), number(row, y)];
                let off = panel.distance(name, at);
                assert!(off < 0.8, "{title}, {name}: {x} {y} {at:?} is {off} pixels off");
            }
        }
        let ways = |name: &str| panel.curves(name).concat();
        for (i, (one, _)) in curves.iter().enumerate() {
            for (other, _) in &curves[..i] {
                assert_ne!(ways(one), ways(other), "{title}: {one} and {other} tell nothing apart");
            }
        }
    }
}

/// A panel of loads over the steps.
fn over_steps<'a>(title: &'a str, label: &'a str, curves: &[[&'a str; 2]]) -> Wanted<'a> {
    let curves = curves.iter().map(|[name, column]| (*name, ["step", *column])).collect();
    (title, ["step", label], curves)
}
