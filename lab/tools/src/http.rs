//! The part of HTTP that a browser needs to fetch files: one request and one response per
//! connection.
//!
//! Connections are not kept alive. A browser opens half a dozen at once, and a server whose pool of
//! threads waits on idle connections leaves some requests unanswered. `tiny_http` has this fault;
//! it also limits neither the number of connections nor the total time of a request.

use std::io::{self, Read, Write};

/// No browser sends a longer head, or more headers.
const LONGEST_HEAD: usize = 32 * 1024;
const MOST_HEADERS: usize = 64;

/// A request. Headers other than the host, and the body, are ignored.
#[derive(Debug, PartialEq)]
pub(crate) struct Request {
    pub(crate) method: String,
    pub(crate) target: String,
    /// The `Host` of the request, as in `127.0.0.1:8080`; empty if it has none.
    pub(crate) host: String,
}

/// A response.
pub(crate) struct Response {
    pub(crate) status: &'static str,
    pub(crate) mime: &'static str,
    pub(crate) body: Vec<u8>,
}

/// The reason why a call is not a valid request.
#[derive(Debug, PartialEq)]
pub(crate) enum BadCall {
    /// It sent nothing, or reading from its connection failed.
    Silent,
    /// It is not HTTP, or it has two hosts.
    Malformed,
    /// It has more headers, or longer ones, than any browser sends.
    TooLarge,
}

impl Request {
    /// Reads a request's head.
    pub(crate) fn read(stream: &mut impl Read) -> Result<Self, BadCall> {
        let mut head = Vec::new();
        let mut part = [0; 4096];
        while head.len() < LONGEST_HEAD {
            match stream.read(&mut part).map_err(|_| BadCall::Silent)? {
                0 if head.is_empty() => return Err(BadCall::Silent),
                0 => return Err(BadCall::Malformed),
                length => head.extend_from_slice(&part[..length]),
            }
            if let Some(request) = Self::parse(&head)? {
                return Ok(request);
            }
        }
        Err(BadCall::TooLarge)
    }

    /// Parses the request in a head. Returns `None` while the head is incomplete.
    fn parse(head: &[u8]) -> Result<Option<Self>, BadCall> {
        let mut headers = [httparse::EMPTY_HEADER; MOST_HEADERS];
        let mut request = httparse::Request::new(&mut headers);
        let status = request.parse(head).map_err(|error| match error {
            httparse::Error::TooManyHeaders => BadCall::TooLarge,
            _ => BadCall::Malformed,
        })?;
        let (httparse::Status::Complete(_), Some(method), Some(target)) =
            (status, request.method, request.path)
        else {
            return Ok(None);
        };
        let mut hosts = request.headers.iter().filter(|header| header.name.eq_ignore_ascii_case("host"));
        let host = hosts.next().map_or("", |header| str::from_utf8(header.value).unwrap_or_default());
        if hosts.next().is_some() {
            return Err(BadCall::Malformed);
        }
        Ok(Some(Self { method: method.to_owned(), target: target.to_owned(), host: host.to_owned() }))
    }
}

impl Response {
    /// Creates a short response of plain text.
    pub(crate) fn plain(status: &'static str, words: &str) -> Self {
        Self { status, mime: "text/plain; charset=utf-8", body: words.into() }
    }

    /// Writes the response, without the body for `HEAD`.
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
        let [method, target, host] = ["GET", "/pkg/a.wasm?x=1", "127.0.0.1"].map(String::from);
        assert_eq!(request, Request { method, target, host });
    }

    #[test]
    fn what_is_no_request_is_refused() {
        let with = |header: &str| format!("GET / HTTP/1.1\r\n{header}\r\n");
        for (head, bad) in [
            ("", BadCall::Silent),
            ("GET / HT", BadCall::Malformed),
            ("\u{1}\r\n\r\n", BadCall::Malformed),
            ("GET /\r\n\r\n", BadCall::Malformed),
            (&with("Host: a\r\nhost: b\r\n"), BadCall::Malformed),
            (&with(&"A: b\r\n".repeat(MOST_HEADERS + 1)), BadCall::TooLarge),
            (&with(&format!("A: {}\r\n", "b".repeat(LONGEST_HEAD))), BadCall::TooLarge),
        ] {
            assert_eq!(Request::read(&mut head.as_bytes()).unwrap_err(), bad, "{head:.20}");
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
