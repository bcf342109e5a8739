//! The count of lines between a renderer and luminaire.

/// Returns the number of lines of source text between the comments `glue` and `end of glue`: from the
/// renderer's numbers of a point or of vertices to its pixel or colours.
///
/// # Panics
/// If a comment is missing.
pub fn glue(source: &str) -> usize {
    let is = |line: &str, comment: &str| {
        [format!("// {comment}"), format!("/* {comment} */")].contains(&line.trim().to_owned())
    };
    let lines = source.lines().skip_while(|line| !is(line, "glue")).skip(1);
    let mut is_closed = false;
    let count = lines
        .take_while(|line| {
            is_closed = is(line, "end of glue");
            !is_closed
        })
        .filter(|line| !line.trim().is_empty())
        .count();
    assert!(is_closed, "the comments `glue` and `end of glue`");
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_between_the_comments_are_counted() {
        assert_eq!(glue("a\n  // glue\nb\n\nc\n  // end of glue\nd"), 2);
        assert_eq!(glue("/* glue */\n  b;\n/* end of glue */\n"), 1);
    }

    #[test]
    #[should_panic(expected = "end of glue")]
    fn glue_without_an_end_is_refused() {
        glue("// glue\nb");
    }
}
