//! Case files: TOML, read strictly. An unknown, missing or impossible field is an error that
//! names it.

mod body;
mod error;
mod impact;
mod range;
mod section;

pub use body::{BodyCase, Mass, Shape};
pub use error::CaseError;
pub use impact::{Angles, Approach, ImpactCase};
pub use range::Range;
