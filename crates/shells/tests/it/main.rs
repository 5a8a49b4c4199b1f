//! The integration tests of `carom-shells`: one executable with a module for each subject.

mod bellows_closed;
mod bellows_equilibrium;
mod bellows_limits;
mod bellows_reference;
mod flange_closed;
mod flange_limits;
mod flange_reference;
mod fourier;
mod reference;
