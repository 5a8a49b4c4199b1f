//! The calls of the hostile caller in the tests of `carom-capi`, chosen by the fuzzer: each ends with a status, none
//! with a panic inside.
#![no_main]

#[path = "../../crates/capi/tests/it/hostile/calls/mod.rs"]
mod calls;
#[path = "../../crates/capi/tests/it/hostile/random.rs"]
mod random;
#[path = "../../crates/capi/tests/it/hostile/world.rs"]
mod world;

use libfuzzer_sys::fuzz_target;
use std::cell::RefCell;
use world::World;

thread_local! {
    /// Made once: the matrices of its law of rings take longer than the calls.
    static WORLD: RefCell<World> = RefCell::new(World::new(1));
}

fuzz_target!(|bytes: &[u8]| {
    WORLD.with_borrow_mut(|world| {
        world.begin(bytes);
        calls::all_of_bytes(world);
    });
});
