//! Layer 1, special functions: slender contacts without loss of digits.
//!
//! The modulus k of an elliptic integral is 1 to the last digit for every ellipse with a/b < 1e-8;
//! the axis ratio itself keeps all digits.

use carom::special::elliptic::complete;
use carom::special::{AxisRatio, RangeError};

fn main() -> Result<(), RangeError> {
    println!("{:>8} {:>20} {:>20} {:>10}", "a/b", "K", "ln(4 b/a)", "E");
    for slenderness in [1.0, 0.5, 1e-2, 1e-8, 1e-100, 1e-300] {
        let ratio = AxisRatio::new(slenderness)?;
        let (k, e) = (complete::k(ratio), complete::e(ratio));
        let limit = (4.0 / slenderness).ln();
        println!("{slenderness:>8.0e} {k:>20.12} {limit:>20.12} {e:>10.7}");
        // K = ln(4/k') (1 + k'^2/4 + ...) - k'^2/4 - ...
        assert!((k - limit).abs() < 0.3 * slenderness.powi(2) * (1.0 + limit) + 1e-12);
    }
    Ok(())
}
