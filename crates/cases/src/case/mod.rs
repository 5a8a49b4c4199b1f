//! Case files: TOML, in SI units or with units of their own. An unknown, missing or out-of-range field is an
//! error that names it. Each kind of case has one table of its fields.

mod body;
mod contact;
mod error;
mod field;
mod foreign;
mod hertz;
mod history;
mod impact;
mod kind;
mod material;
mod open_case;
mod pair;
mod range;
mod reader;
mod roll;
mod scene;
mod schema;
mod section;
mod shape;
mod shell;
mod solve;
mod stress;
mod template;
#[cfg(test)]
mod tests;
mod touch;
mod uncertainty;
mod unit;
mod varied;

pub use contact::Contact;
pub use error::{CaseError, CaseFault};
pub use field::{Default, Entry, Field, Form, Need, Rows, Schema, Word, entries};
pub use hertz::{Given, HertzCase};
pub use history::{HistoryCase, Steps};
pub use impact::{ImpactCase, ImpactFile};
pub use kind::CaseKind;
pub(crate) use kind::meant;
pub use open_case::{OpenCase, Renewed, Replaced, Stated};
pub use range::{End, Range};
pub use reader::Case;
pub use roll::{Elliptical, RollCase, Straight, Touching};
pub use scene::SceneCase;
pub(crate) use section::shortened;
pub use section::{Numbers, Understood, likely};
pub use shell::{BellowsCase, FlangeCase, ShellCase};
pub use solve::{
    Border, FrictionCase, GapCase, GridCase, HeightFile, InfluenceFile, Leg, Missing, PlateCase,
    SolveCase, SolveMethod, Target,
};
pub use stress::StressCase;
pub use uncertainty::Uncertainty;

pub use unit::{Dimension, Measure};
pub use varied::{Input, Unknown, Variation};
