//! Case files: TOML, read strictly, in SI units or with units of their own. An unknown, missing or
//! impossible field is an error that names it.

mod body;
mod contact;
mod encounter;
mod error;
mod hertz;
mod history;
mod impact;
mod pair;
mod placed;
mod range;
mod scene;
mod section;
mod solve;
mod uncertainty;
mod unit;

pub use body::{BodyCase, Mass, Shape};
pub use contact::Contact;
pub use encounter::EncounterCase;
pub use error::CaseError;
pub use hertz::{Given, HertzCase};
pub use history::{HistoryCase, Steps, TurningLaw};
pub use impact::{Approach, ImpactCase};
pub use range::Range;
pub use scene::SceneCase;
pub use section::Numbers;
pub use solve::{GapCase, HeightMap, Leg, SolveCase, Target};
pub use uncertainty::UncertainCase;
pub use unit::{Dimension, Measure};
