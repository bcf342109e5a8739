//! Memory that may not be there.

use alloc::{collections::TryReserveError, vec::Vec};

/// A vector of so many equal values.
pub(crate) fn filled<T: Clone>(count: usize, value: T) -> Result<Vec<T>, TryReserveError> {
    let mut values = Vec::new();
    values.try_reserve_exact(count)?;
    values.resize(count, value);
    Ok(values)
}
