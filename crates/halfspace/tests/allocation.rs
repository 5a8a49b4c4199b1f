//! A repeated product allocates nothing.
//!
//! Allocations are counted for this thread only, because the test harness allocates at the same
//! time.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::sync::atomic::{AtomicBool, Ordering};

use carom_halfspace::operator::{
    DisplacementField, HalfSpaceOperator, Plate, PlateOperator, PlateSymbol, SurfaceOperator,
    Threads, TractionField,
};
use carom_halfspace::{Grid, Material, MaterialPair};

/// The system's allocator with a count of the calls of each thread.
struct Counting;

thread_local! {
    // Constant and without a destructor, so that counting itself allocates nothing.
    static CALLS: Cell<usize> = const { Cell::new(0) };
}

/// How often this thread has allocated.
fn calls() -> usize {
    CALLS.with(Cell::get)
}

// SAFETY: every call is handed on to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        CALLS.with(|calls| calls.set(calls.get() + 1));
        // SAFETY: the caller's promises are those of the system's allocator.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

#[test]
fn the_count_is_that_of_this_thread() {
    let before = calls();
    std::hint::black_box(vec![0_u8; 10]);
    assert_eq!(calls() - before, 1);
    let go = AtomicBool::new(false);
    std::thread::scope(|scope| {
        let other = scope.spawn(|| {
            while !go.load(Ordering::Acquire) {
                std::thread::yield_now();
            }
            (0..1000).for_each(|i| drop(std::hint::black_box(vec![0_u8; i])));
            calls()
        });
        let before = calls();
        go.store(true, Ordering::Release);
        while !other.is_finished() {
            std::thread::yield_now();
        }
        assert_eq!(calls(), before);
        assert!(other.join().unwrap() >= 999);
    });
}

#[test]
fn repeated_products_allocate_nothing() {
    let one = Material::from_shear(1.0, 0.1).unwrap();
    let two = Material::from_shear(3.0, 0.45).unwrap();
    let pair = MaterialPair::new(one, two).unwrap();
    let grid = Grid::new(70, 45, 1.0, 1.0).unwrap();
    let operator = HalfSpaceOperator::new(pair, grid).unwrap();
    let mut workspace = operator.workspace();
    let load = vec![1.0; grid.cells()];
    let [mut u, mut v, mut w] = [0; 3].map(|_| vec![0.0; grid.cells()]);
    let mut count = 0;
    for round in 0..10 {
        let before = calls();
        let tractions = TractionField::full(&load, &load, &load);
        let displacements = DisplacementField::full(&mut u, &mut v, &mut w);
        operator.apply(tractions, displacements, &mut workspace).unwrap();
        let normal = DisplacementField::normal(&mut w);
        operator.apply(TractionField::normal(&load), normal, &mut workspace).unwrap();
        if round > 0 {
            count += calls() - before;
        }
    }
    assert_eq!(count, 0);
}

#[test]
fn repeated_products_with_a_plate_allocate_nothing() {
    let pane = Material::from_shear(1.0, 0.2).unwrap();
    let pair = MaterialPair::new(Material::RIGID, pane).unwrap();
    let plate = Plate::new(1.0, 0.7, 0.05).unwrap();
    let grid = plate.grid(45, 26).unwrap();
    let operator = PlateOperator::new(pair, plate, grid, PlateSymbol::Layer, Threads::One).unwrap();
    let (inverse, mut workspace) = (operator.inverse().unwrap(), operator.workspace());
    let (load, mut w) = (vec![1.0; grid.cells()], vec![0.0; grid.cells()]);
    let mut back = w.clone();
    let mut count = 0;
    for round in 0..10 {
        let before = calls();
        let displacement = DisplacementField::normal(&mut w);
        operator.apply(TractionField::normal(&load), displacement, &mut workspace).unwrap();
        inverse.pressure(&w, &mut back, &mut workspace);
        if round > 0 {
            count += calls() - before;
        }
    }
    assert_eq!(count, 0);
}
