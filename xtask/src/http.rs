//! As much of HTTP as a browser needs to fetch files: one request and one answer for each connection.
//!
//! Connections are not kept alive. A browser opens half a dozen at once, and a server with a pool of threads that
//! wait on idle connections leaves some of its calls unanswered.

use std::io::{self, ErrorKind, Read, Write};

/// Longer heads than this are sent by no browser.
const LONGEST_HEAD: usize = 32 * 1024;
const MOST_HEADERS: usize = 64;

/// What is asked for; a request's headers and body do not matter here.
#[derive(Debug, PartialEq)]
pub(crate) struct Request {
    pub(crate) method: String,
    pub(crate) target: String,
}

/// What is answered.
pub(crate) struct Response {
    pub(crate) status: &'static str,
    pub(crate) mime: &'static str,
    pub(crate) body: Vec<u8>,
}

impl Request {
    /// Reads a request's head.
    pub(crate) fn read(stream: &mut impl Read) -> io::Result<Self> {
        let mut head = Vec::new();
        let mut part = [0; 4096];
        while head.len() < LONGEST_HEAD {
            let length = stream.read(&mut part)?;
            if length == 0 {
                return Err(ErrorKind::UnexpectedEof.into());
            }
            head.extend_from_slice(&part[..length]);
            if let Some(request) = Self::parse(&head)? {
                return Ok(request);
            }
        }
        Err(ErrorKind::InvalidData.into())
    }

    /// The request in a head; none as long as more of it is to come.
    fn parse(head: &[u8]) -> io::Result<Option<Self>> {
        let mut headers = [httparse::EMPTY_HEADER; MOST_HEADERS];
        let mut request = httparse::Request::new(&mut headers);
        let status = request.parse(head).map_err(|error| io::Error::new(ErrorKind::InvalidData, error))?;
        Ok(match (status, request.method, request.path) {
            (httparse::Status::Complete(_), Some(method), Some(target)) => {
                Some(Self { method: method.to_owned(), target: target.to_owned() })
            }
            _ => None,
        })
    }
}

impl Response {
    /// A short answer in words.
    pub(crate) fn plain(status: &'static str, words: &str) -> Self {
        Self { status, mime: "text/plain; charset=utf-8", body: words.into() }
    }

    /// Writes the answer, with the body left out for `HEAD`.
    pub(crate) fn write(
        &self,
        stream: &mut impl Write,
        headers: &[(&str, &str)],
        head: bool,
    ) -> io::Result<()> {
        let mut answer = Vec::new();
        write!(answer, "HTTP/1.1 {}\r\n", self.status)?;
        write!(answer, "Content-Type: {}\r\nContent-Length: {}\r\n", self.mime, self.body.len())?;
        for (name, value) in headers {
            write!(answer, "{name}: {value}\r\n")?;
        }
        write!(answer, "Connection: close\r\n\r\n")?;
        if !head {
            answer.extend_from_slice(&self.body);
        }
        stream.write_all(&answer)?;
        stream.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_request_is_read_however_it_is_cut() {
        let (first, second) = ("GET /pkg/a.wasm?x=1 HT", "TP/1.1\r\nHost: 127.0.0.1\r\n\r\n");
        let request = Request::read(&mut first.as_bytes().chain(second.as_bytes())).unwrap();
        assert_eq!(request, Request { method: "GET".into(), target: "/pkg/a.wasm?x=1".into() });
    }

    #[test]
    fn what_is_no_request_is_refused() {
        let endless = "GET / HTTP/1.1\r\n".to_owned() + &"A: b\r\n".repeat(10_000);
        for head in ["", "GET / HT", "\u{1}\r\n\r\n", "GET /\r\n\r\n", &endless] {
            assert!(Request::read(&mut head.as_bytes()).is_err(), "{head:.20}");
        }
    }

    #[test]
    fn head_is_answered_without_the_body() {
        let (mut whole, mut head) = (Vec::new(), Vec::new());
        let response = Response::plain("200 OK", "light");
        response.write(&mut whole, &[("Cache-Control", "no-store")], false).unwrap();
        response.write(&mut head, &[("Cache-Control", "no-store")], true).unwrap();
        let (whole, head) = (String::from_utf8(whole).unwrap(), String::from_utf8(head).unwrap());
        assert_eq!(whole, format!("{head}light"));
        assert!(head.starts_with("HTTP/1.1 200 OK\r\n") && head.ends_with("\r\n\r\n"), "{head}");
        assert!(head.contains("Content-Length: 5\r\nCache-Control: no-store\r\n"), "{head}");
    }
}
