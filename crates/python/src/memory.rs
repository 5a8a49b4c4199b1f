//! Memory of the module. The C library's allocator on Linux keeps freed arrays of some megabytes for later use, and fills what it
//! uses again with zeros. The fields of a large grid are mostly zero and never touched: mapped on their own they take no memory
//! there, and what is freed is the system's at once. A rough contact on 1024 x 1024 cells takes half the memory so.

use std::alloc::{GlobalAlloc, Layout, System};
use std::ptr::null_mut;

/// Arrays from this size on, in bytes, are mapped on their own.
const LARGE: usize = 1 << 20;
/// Maps begin at multiples of at least this many bytes.
const PAGE: usize = 4096;

/// The system's allocator, with a map of its own for each large array.
pub(crate) struct LargeMapped;

fn is_large(layout: Layout) -> bool {
    layout.size() >= LARGE && layout.align() <= PAGE
}

/// New memory, all zero; null if there is none.
fn mapped(size: usize) -> *mut u8 {
    let (access, kind) =
        (libc::PROT_READ | libc::PROT_WRITE, libc::MAP_PRIVATE | libc::MAP_ANONYMOUS);
    // SAFETY: a new map at an address that the system chooses touches no other memory.
    let at = unsafe { libc::mmap(null_mut(), size, access, kind, -1, 0) };
    if at == libc::MAP_FAILED { null_mut() } else { at.cast() }
}

// SAFETY: a layout decides alone whether its array is mapped, so that each is freed as it was made. Maps are as large as asked
// for and aligned to pages; all else is the system's allocator.
unsafe impl GlobalAlloc for LargeMapped {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's duties are the same.
        if is_large(layout) { mapped(layout.size()) } else { unsafe { System.alloc(layout) } }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's duties are the same; a new map is zero.
        if is_large(layout) {
            mapped(layout.size())
        } else {
            unsafe { System.alloc_zeroed(layout) }
        }
    }

    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        if is_large(layout) {
            // SAFETY: `alloc` has mapped this many bytes here. That it fails leaves them in use.
            unsafe { libc::munmap(at.cast(), layout.size()) };
        } else {
            // SAFETY: the caller's duties are the same.
            unsafe { System.dealloc(at, layout) };
        }
    }

    unsafe fn realloc(&self, at: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        let Ok(new) = Layout::from_size_align(size, layout.align()) else { return null_mut() };
        match [is_large(layout), is_large(new)] {
            // SAFETY: the caller's duties are the same.
            [false, false] => unsafe { System.realloc(at, layout, size) },
            // SAFETY: a map of this size is here, and may move.
            [true, true] => unsafe {
                let moved = libc::mremap(at.cast(), layout.size(), size, libc::MREMAP_MAYMOVE);
                if moved == libc::MAP_FAILED { null_mut() } else { moved.cast() }
            },
            // SAFETY: both arrays hold the smaller number of bytes and do not overlap.
            _ => unsafe {
                let to = self.alloc(new);
                if !to.is_null() {
                    to.copy_from_nonoverlapping(at, layout.size().min(size));
                    self.dealloc(at, layout);
                }
                to
            },
        }
    }
}
