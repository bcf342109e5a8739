//! The browser demo: a thin shell over `luminaire-render`.
