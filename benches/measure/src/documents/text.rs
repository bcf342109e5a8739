//! Tables in Markdown, and figures with few digits.

/// A table in Markdown: heads, and the cells of each row.
pub(super) fn table(heads: &[String], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let rows: String = rows.into_iter().map(|row| line(&row)).collect();
    format!("{}|{}\n{rows}", line(heads), "---|".repeat(heads.len()))
}

/// Owned texts of cells.
pub(super) fn cells<const N: usize>(texts: [&str; N]) -> Vec<String> {
    texts.map(str::to_owned).into()
}

/// Formats an error with two significant digits, or as an integer from 10 on.
pub(super) fn error(value: f64) -> String {
    match value {
        0.0 => "0".to_owned(),
        value if value >= 9.95 => format!("{value:.0}"),
        value if value >= 0.995 => format!("{value:.1}"),
        value if value >= 0.0995 => format!("{value:.2}"),
        value if value >= 0.009_95 => format!("{value:.3}"),
        value => format!("{value:.1e}"),
    }
}

/// Formats a cost with three significant digits, or as an integer from 100 on.
pub(super) fn cost(value: f64) -> String {
    match value {
        value if value >= 99.95 => format!("{value:.0}"),
        value if value >= 9.995 => format!("{value:.1}"),
        value => format!("{value:.2}"),
    }
}
