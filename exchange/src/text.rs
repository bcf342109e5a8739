//! Bytes of a file as text.

use crate::refusal::Refusal;

/// The largest file in bytes. Text of other tools has its lights in a few lines; a file over this size
/// has meshes in it that belong in files of their own.
pub(crate) const LARGEST: usize = 64 << 20;

/// Returns the text of a file: UTF-8, UTF-16 with a byte order mark, or Latin-1; with LF as line end, for CR
/// and CRLF, too, and without the NULs and the Ctrl-Z that pad a file.
///
/// Photometric files before 2019 are in the code page of their maker; every byte is a character of
/// Latin-1, and only names have such characters.
///
/// # Errors
/// A file over 64 MiB, an empty file, or a file with a NUL character in the text.
pub(crate) fn decode(bytes: &[u8]) -> Result<String, Refusal> {
    if bytes.len() > LARGEST {
        return Err(Refusal::new("size", bytes.len(), format_args!("at most {LARGEST} bytes")));
    }
    let wide = |bytes: &[u8], unit: fn([u8; 2]) -> u16| {
        let units: Vec<u16> = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]])).collect();
        String::from_utf16_lossy(&units)
    };
    let mut text = match bytes {
        [0xff, 0xfe, rest @ ..] => wide(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => wide(rest, u16::from_be_bytes),
        [0xef, 0xbb, 0xbf, rest @ ..] => String::from_utf8_lossy(rest).into_owned(),
        _ => match str::from_utf8(bytes) {
            Ok(text) => text.to_owned(),
            Err(_) => bytes.iter().map(|&byte| char::from(byte)).collect(),
        },
    };
    text.truncate(text.trim_end_matches(|c: char| c.is_whitespace() || matches!(c, '\0' | '\x1a')).len());
    if text.contains('\r') {
        text = text.replace("\r\n", "\n").replace('\r', "\n");
    }
    if text.is_empty() {
        return Err(Refusal::new("file", "empty", "a file with a light"));
    }
    match text.find('\0') {
        Some(at) => Err(Refusal::new("file", format_args!("a NUL at byte {at}"), "a text file")),
        None => Ok(text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_decoded_up_to_64_mib_without_their_padding() {
        assert_eq!(decode(b"a\rb\r\nc\n\0\0\x1a\n"), Ok("a\nb\nc".to_owned()));
        assert_eq!(decode(b"\xff\xfea\0\r\0b\0"), Ok("a\nb".to_owned()));
        assert!(decode(b"a\0b").is_err() && decode(b"\0").is_err_and(|refusal| refusal.value == "empty"));
        let large = vec![b'a'; LARGEST + 1];
        assert!(decode(&large).is_err() && decode(&large[1..]).is_ok_and(|text| text.len() == LARGEST));
    }
}
