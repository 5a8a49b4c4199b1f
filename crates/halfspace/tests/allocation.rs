//! A repeated product allocates nothing.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};

use carom_halfspace::operator::{
    DisplacementField, HalfSpaceOperator, SurfaceOperator, TractionField,
};
use carom_halfspace::{Grid, Material, MaterialPair};

/// The system's allocator with a count of its calls.
struct Counting;

static CALLS: AtomicUsize = AtomicUsize::new(0);

// SAFETY: every call is handed on to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        CALLS.fetch_add(1, Ordering::Relaxed);
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
        let before = CALLS.load(Ordering::Relaxed);
        let tractions = TractionField::full(&load, &load, &load);
        let displacements = DisplacementField::full(&mut u, &mut v, &mut w);
        operator.apply(tractions, displacements, &mut workspace).unwrap();
        let normal = DisplacementField::normal(&mut w);
        operator.apply(TractionField::normal(&load), normal, &mut workspace).unwrap();
        if round > 0 {
            count += CALLS.load(Ordering::Relaxed) - before;
        }
    }
    assert_eq!(count, 0);
}
