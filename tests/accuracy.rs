//! Accuracy of every model against the f64 reference.
