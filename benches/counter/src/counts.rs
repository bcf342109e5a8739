//! How often each address was executed in each region.

use std::collections::BTreeMap;
use std::fmt;

use crate::marker::Marker;

/// The counts of a run so far.
#[derive(Debug)]
pub(crate) struct Counts {
    /// Executions by address, one map for each region that has begun.
    regions: Vec<BTreeMap<u64, u64>>,
    is_open: bool,
}

impl Counts {
    pub(crate) const fn new() -> Self {
        Self { regions: Vec::new(), is_open: false }
    }

    /// Records an executed marker. A begin marker within a region begins the next region. An end
    /// marker outside a region is ignored.
    pub(crate) fn mark(&mut self, marker: Marker) {
        self.is_open = marker == Marker::Begin;
        if self.is_open {
            self.regions.push(BTreeMap::new());
        }
    }

    /// Records any other executed instruction.
    pub(crate) fn execute(&mut self, address: u64) {
        if self.is_open
            && let Some(region) = self.regions.last_mut()
        {
            *region.entry(address).or_default() += 1;
        }
    }
}

/// One line for each region and address: `region address count`, the address in hexadecimal. A
/// region in which nothing was executed has no line.
impl fmt::Display for Counts {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, region) in self.regions.iter().enumerate() {
            for (address, count) in region {
                writeln!(out, "{index} {address:x} {count}")?;
            }
        }
        Ok(())
    }
}
