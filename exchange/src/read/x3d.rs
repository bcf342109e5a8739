pub(crate) fn read(_: &str) -> Result<super::Found, crate::Refusal> {
    Ok(super::Found::default())
}
