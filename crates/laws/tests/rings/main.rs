//! The law of rings against closed forms, other laws and invariants.

mod measure;
