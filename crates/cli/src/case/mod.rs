//! Case files: TOML, read strictly. An unknown, missing or impossible field is an error that
//! names it.

mod body;
mod error;
mod hertz;
mod history;
mod impact;
mod pair;
mod range;
mod scene;
mod section;
mod uncertainty;

pub use body::{BodyCase, Mass, Shape};
pub use error::CaseError;
pub use hertz::{Given, HertzCase};
pub use history::{HistoryCase, Steps};
pub use impact::{Approach, ImpactCase};
pub use range::Range;
pub use scene::SceneCase;
pub use section::Numbers;
pub use uncertainty::UncertainCase;
