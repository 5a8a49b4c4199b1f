//! The two numbers that span the results, and R_x of a pair of them.

use super::bodies::{Bodies, Coupling, NormalLoss};
use super::{Arguments, rows, rows::Row};
use crate::range::Values;
use carom_special::RangeError;
use carom_table::Column;
use carom_table::short;

/// The two numbers that span the results: columns, symbols, values and meaning.
#[derive(Debug)]
pub(super) struct Plane<'a> {
    pub(super) columns: Vec<Column<Row>>,
    pub(super) symbols: [char; 2],
    pub(super) title: String,
    pub(super) values: [&'a [f64]; 2],
    pub(super) bodies: Bodies,
}

fn list(values: &Option<Values>) -> &[f64] {
    values.as_ref().map_or(&[], |values| &values.0)
}

impl Plane<'_> {
    pub(super) fn of(arguments: &Arguments) -> Result<Plane<'_>, RangeError> {
        let bodies = Bodies::of(arguments)?;
        let spheres = [list(&arguments.kappa), list(&arguments.lambda)];
        let any = [list(&arguments.chi), list(&arguments.psi)];
        let (columns, symbols, values) = match bodies {
            Bodies::Spheres(_) => (rows::OF_SPHERES, ['κ', 'λ'], spheres),
            Bodies::Any(_) => (rows::OF_ANY, ['χ', 'ψ'], any),
            Bodies::Dissimilar(_) => (rows::OF_DISSIMILAR, ['κ', 'λ'], spheres),
        };
        let columns = match bodies.normal_loss() {
            None => columns.to_vec(),
            Some(_) => [&columns[..2], rows::OF_LOSSY].concat(),
        };
        let title = match bodies {
            Bodies::Spheres(loss) => format!("Tangential restitution of spheres{}", with(loss)),
            Bodies::Any(loss) => format!("Tangential restitution{}", with(loss)),
            Bodies::Dissimilar(Coupling { gamma, friction, .. }) => {
                let (gamma, f) = (short(gamma), short(friction.get()));
                format!("Dissimilar spheres, γ = {gamma}, f = {f}")
            }
        };
        Ok(Plane { columns, symbols, title, values, bodies })
    }

    pub(super) fn count(&self) -> usize {
        self.values[0].len().saturating_mul(self.values[1].len())
    }

    /// The pair in this place, the second number running fastest.
    pub(super) fn pair(&self, place: usize) -> [f64; 2] {
        let [first, second] = self.values;
        [first[place / second.len()], second[place % second.len()]]
    }

    /// Whether all pairs are allowed. Each number has a range of its own.
    pub(super) fn check(&self) -> Result<(), RangeError> {
        let [first, second] = self.values;
        first.iter().try_for_each(|a| self.bodies.check([*a, second[0]]))?;
        second.iter().try_for_each(|b| self.bodies.check([first[0], *b]))
    }
}

fn with(loss: NormalLoss) -> String {
    loss.map_or_else(String::new, |e| format!(", e = {}", short(e)))
}
