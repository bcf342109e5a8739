//! What holds for the repository as a whole: its texts, the imports between its files, and what its
//! crates pack.

mod documents;
mod graph;
mod imports;
mod kept;
mod listing;
mod packed;
mod used;
