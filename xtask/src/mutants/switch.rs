//! Which mutant is on: read from the environment, once; none without it.

static ON: std::sync::LazyLock<u32> = std::sync::LazyLock::new(|| {
    let number = std::env::var("CAROM_MUTANT").unwrap_or_default();
    number.parse().unwrap_or(0)
});

#[inline]
pub(crate) fn is_on(number: u32) -> bool {
    *ON == number
}
