//! The integration tests of `carom-classic`: one executable with a module for each subject.

mod agreement;
mod direct_refusals;
mod literal;
#[path = "../../../laws/tests/it/common/reference.rs"]
mod reference;
mod rigid_slip;
mod theory;
