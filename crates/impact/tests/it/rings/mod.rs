//! The law of rings and impacts by it, against the contact on a grid.

mod histories;
mod impacts;
