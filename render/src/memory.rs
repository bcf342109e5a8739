//! Fallible allocation.

use alloc::{collections::TryReserveError, vec::Vec};

/// Returns a vector of `count` equal values.
pub(crate) fn filled<T: Clone>(count: usize, value: T) -> Result<Vec<T>, TryReserveError> {
    let mut values = Vec::new();
    values.try_reserve_exact(count)?;
    values.resize(count, value);
    Ok(values)
}
