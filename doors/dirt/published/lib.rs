//! Nothing: the manifest beside it names the crates of DIRT.
