//! URIs: relative references with escapes, and `data:` with its content.

use crate::refusal::Refusal;

/// Returns the content of a URI that has it within itself; `None` for the name of a file.
pub(crate) fn data(uri: &str) -> Option<Result<Vec<u8>, Refusal>> {
    let data = uri.get(..5).filter(|scheme| scheme.eq_ignore_ascii_case("data:")).map(|_| &uri[5..])?;
    let refused = || Refusal::new("uri", "data:", "a media type, `;base64,` and base64, or a comma and text");
    let content = data.split_once(',').map(|(head, content)| (head, unescaped(content)));
    Some(match content {
        Some((head, content)) if head.to_ascii_lowercase().ends_with(";base64") => {
            base64(&content).ok_or_else(refused)
        }
        Some((_, content)) => Ok(content),
        None => Err(refused()),
    })
}

/// Returns the bytes of base64, with or without what pads them.
fn base64(text: &[u8]) -> Option<Vec<u8>> {
    let padding = text.iter().rev().take_while(|byte| **byte == b'=').count();
    let digits = &text[..text.len() - padding];
    if padding > 2 || digits.len() % 4 == 1 {
        return None;
    }
    let mut bytes = Vec::with_capacity(digits.len() / 4 * 3 + 2);
    for group in digits.chunks(4) {
        let mut bits = 0_u32;
        for place in 0..4 {
            let digit = match group.get(place).copied().unwrap_or(b'A') {
                digit @ b'A'..=b'Z' => digit - b'A',
                digit @ b'a'..=b'z' => digit - b'a' + 26,
                digit @ b'0'..=b'9' => digit - b'0' + 52,
                b'+' => 62,
                b'/' => 63,
                _ => return None,
            };
            bits = bits << 6 | u32::from(digit);
        }
        bytes.extend(&bits.to_be_bytes()[1..group.len()]);
    }
    Some(bytes)
}

/// Returns the bytes of a URI with escapes such as `%20`.
pub(crate) fn unescaped(uri: &str) -> Vec<u8> {
    let mut parts = uri.split('%');
    let mut bytes = parts.next().unwrap_or_default().as_bytes().to_vec();
    for part in parts {
        // `from_str_radix` takes a sign, too.
        let digits = part.get(..2).filter(|own| own.bytes().all(|byte| byte.is_ascii_hexdigit()));
        match digits.and_then(|digits| u8::from_str_radix(digits, 16).ok()) {
            Some(byte) => {
                bytes.push(byte);
                bytes.extend(&part.as_bytes()[2..]);
            }
            None => {
                bytes.push(b'%');
                bytes.extend(part.as_bytes());
            }
        }
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The test vectors of base64's own RFC, and what is no base64.
    #[test]
    fn data_is_base64_or_text_with_escapes() {
        let content = |uri: &str| data(uri).map(Result::ok);
        for (coded, text) in [
            ("", ""),
            ("Zg==", "f"),
            ("Zm8=", "fo"),
            ("Zm9v", "foo"),
            ("Zm9vYg==", "foob"),
            ("Zm9vYmE=", "fooba"),
            ("Zm9vYmE%3d", "fooba"),
            ("Zm9vYmE", "fooba"),
        ] {
            assert_eq!(content(&format!("data:a/b;base64,{coded}")), Some(Some(text.into())), "{coded}");
        }
        assert_eq!(content("DATA:;BASE64,/+8="), Some(Some(vec![0xff, 0xef])));
        assert_eq!(content("data:,a%20b%+1%zz"), Some(Some(b"a b%+1%zz".to_vec())));
        for wrong in ["data:", "data:a;base64,Z", "data:a;base64,Zg===", "data:a;base64,Z-9v"] {
            assert_eq!(content(wrong), Some(None), "{wrong}");
        }
        assert_eq!([content("a%20b.ies"), content("datä"), content("")], [None, None, None]);
    }
}
