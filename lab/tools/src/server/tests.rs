//! The server, called over real sockets.

use std::io::{Read, Write};
use std::net::TcpStream;

use super::*;

#[test]
fn an_address_names_a_file() {
    for (url, file) in [
        ("/", "index.html"),
        ("/?width=960&height=540", "index.html"),
        ("/pkg/wasm_demo_bg.wasm", "pkg/wasm_demo_bg.wasm"),
        ("/data/", "data/index.html"),
        ("/two%20words.svg#part", "two words.svg"),
    ] {
        assert_eq!(file_of(url), Some(file.into()), "{url}");
    }
}

#[test]
fn an_address_never_leads_out_of_the_folder() {
    for url in [
        "",
        "index.html",
        "http://127.0.0.1/",
        "/..",
        "/../Cargo.toml",
        "/pkg/../../Cargo.toml",
        "/%2e%2e/Cargo.toml",
        "/..%2fCargo.toml",
        "/.git/config",
        "/..\\Cargo.toml",
        "/c:/windows",
        "/%00",
        "/%ff",
        "//etc/passwd",
        "/pkg//etc/passwd",
        "/%2fetc/passwd",
    ] {
        let file = file_of(url);
        assert!(file.is_none(), "{url} leads to {file:?}");
    }
}

#[test]
fn each_kind_of_file_has_its_type() {
    assert_eq!(mime(Path::new("a.wasm")), "application/wasm");
    assert_eq!(mime(Path::new("a.js")), "text/javascript; charset=utf-8");
    assert_eq!(mime(Path::new("a.b.svg")), "image/svg+xml");
    assert_eq!(mime(Path::new("a")), "application/octet-stream");
}

/// A folder with a page, and a server of it.
fn served(limits: Limits) -> (tempfile::TempDir, Server) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("index.html"), "the page").unwrap();
    let server = Server::start_within(limits, &HEADERS, listen(0).unwrap(), folder.path()).unwrap();
    (folder, server)
}

fn connect(server: &Server) -> TcpStream {
    let stream = TcpStream::connect(("127.0.0.1", server.port)).unwrap();
    // Upper bound of the wait for a response, for a busy machine.
    stream.set_read_timeout(Some(LIMITS.answering)).unwrap();
    stream
}

fn answer_to(mut stream: TcpStream) -> String {
    let mut answer = String::new();
    stream.read_to_string(&mut answer).expect("an answer that no reset follows");
    answer
}

/// Sends any bytes and returns the status of the response, which is empty if the connection was
/// closed.
fn send(server: &Server, bytes: &[u8]) -> String {
    let mut stream = connect(server);
    stream.write_all(bytes).unwrap();
    answer_to(stream).split(' ').nth(1).unwrap_or_default().to_owned()
}

fn ask(server: &Server, request: &str) -> String {
    let mut stream = connect(server);
    // An error does not matter: the server may refuse the request before all of it is sent.
    let _ = write!(stream, "{request} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n\r\n", server.port);
    answer_to(stream)
}

#[test]
fn the_folder_is_served_isolated_and_uncached() {
    let (_folder, server) = served(LIMITS);
    let page = ask(&server, "GET /");
    assert!(page.starts_with("HTTP/1.1 200"), "{page}");
    assert!(page.ends_with("the page"), "{page}");
    for line in [
        "Content-Type: text/html; charset=utf-8",
        "Cache-Control: no-store",
        "Cross-Origin-Opener-Policy: same-origin",
        "Cross-Origin-Embedder-Policy: require-corp",
    ] {
        assert!(page.contains(line), "{line} is missing from {page}");
    }
    assert!(ask(&server, "GET /none.html").starts_with("HTTP/1.1 404"));
    assert!(ask(&server, "GET /../index.html").starts_with("HTTP/1.1 403"));
    let refused = ask(&server, "POST /");
    assert!(refused.starts_with("HTTP/1.1 405") && refused.contains("Allow: GET, HEAD\r\n"), "{refused}");
}

#[test]
fn only_this_machine_is_the_host() {
    let (_folder, server) = served(LIMITS);
    for (hosts, status) in [
        ("Host: 127.0.0.1\r\n", "200"),
        ("Host: 127.0.0.1:8080\r\n", "200"),
        ("host: LocalHost:1\r\n", "200"),
        ("Host: [::1]:8080\r\n", "200"),
        ("Host: [::1]\r\n", "200"),
        ("Host: evil.example\r\n", "421"),
        ("Host: 127.0.0.1.evil.example:8080\r\n", "421"),
        ("Host: evil.example:127.0.0.1\r\n", "421"),
        ("Host: localhost@evil.example\r\n", "421"),
        ("Host: \r\n", "400"),
        ("", "400"),
        ("Host: 127.0.0.1\r\nHost: evil.example\r\n", "400"),
    ] {
        let request = format!("GET / HTTP/1.1\r\n{hosts}\r\n");
        assert_eq!(send(&server, request.as_bytes()), status, "{hosts}");
    }
}

#[test]
fn what_is_no_request_is_answered() {
    let (_folder, server) = served(LIMITS);
    let host = "Host: 127.0.0.1\r\n";
    let long = format!("GET / HTTP/1.1\r\n{host}A: {}\r\n\r\n", "b".repeat(4 << 20));
    let many = format!("GET / HTTP/1.1\r\n{host}{}\r\n", "A: b\r\n".repeat(70));
    for (bytes, status) in [
        (&b"GET /\r\n\r\n"[..], "400"),
        (b"GET /\xff HTTP/1.1\r\n\r\n", "400"),
        (b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", "400"),
        (long.as_bytes(), "431"),
        (many.as_bytes(), "431"),
    ] {
        assert_eq!(send(&server, bytes), status, "{:?}", &bytes[..8]);
    }
    assert!(ask(&server, "GET /").ends_with("the page"));
}

#[test]
fn calls_over_the_limit_are_refused_until_others_end() {
    let (_folder, server) = served(LIMITS);
    let held: Vec<_> = (0..LIMITS.calls).map(|_| connect(&server)).collect();
    let refused = answer_to(connect(&server));
    assert!(refused.starts_with("HTTP/1.1 503"), "{refused}");
    drop(held);
    // The server needs some time to see that the connections are closed.
    let end = Instant::now() + LIMITS.answering;
    while !ask(&server, "GET /").ends_with("the page") {
        assert!(Instant::now() < end, "nobody is answered any more");
        thread::sleep(PAUSE);
    }
}

#[test]
fn a_call_has_one_time_for_all_its_bytes() {
    let asking = Duration::from_millis(300);
    let (_folder, server) = served(Limits { asking, ..LIMITS });
    let mut stream = connect(&server);
    stream.set_nodelay(true).unwrap();
    let start = Instant::now();
    // Sends single bytes, each well within the limit after the one before.
    let cut_off = b"GET / HTTP/1.1\r\nA: ".iter().chain(&[b'b'; 200]).any(|byte| {
        thread::sleep(asking / 10);
        stream.write_all(&[*byte]).is_err()
    });
    assert!(cut_off, "after {:?} the call may still go on", start.elapsed());
}

#[test]
fn an_answer_that_nobody_reads_ends() {
    let limits = Limits { answering: Duration::from_millis(300), calls: 1, ..LIMITS };
    let (folder, server) = served(limits);
    fs::write(folder.path().join("large.bin"), vec![0; 64 << 20]).unwrap();
    let mut unread = connect(&server);
    unread.write_all(b"GET /large.bin HTTP/1.1\r\nHost: localhost\r\n\r\n").unwrap();
    // The unread response takes the only slot until its time is up.
    let end = Instant::now() + LIMITS.answering;
    while !ask(&server, "GET /").ends_with("the page") {
        assert!(Instant::now() < end, "the answer is still being written");
        thread::sleep(PAUSE);
    }
}

#[cfg(unix)]
#[test]
fn links_are_not_followed() {
    let (folder, server) = served(LIMITS);
    let outside = tempfile::tempdir().unwrap();
    fs::write(outside.path().join("secret"), "a secret").unwrap();
    for (name, target) in [
        ("link", outside.path().join("secret")),
        ("folder", outside.path().to_owned()),
        // A link is not followed even if it leads to a file that is served.
        ("inside", folder.path().join("index.html")),
    ] {
        std::os::unix::fs::symlink(target, folder.path().join(name)).unwrap();
    }
    for url in ["/link", "/folder/secret", "/inside"] {
        assert!(ask(&server, &format!("GET {url}")).starts_with("HTTP/1.1 404"), "{url} is served");
    }
}

#[test]
fn many_callers_at_once_are_answered_while_others_say_nothing() {
    let (_folder, server) = served(LIMITS);
    let _silent: Vec<_> = (0..16).map(|_| connect(&server)).collect();
    let mut callers: Vec<_> = (0..16).map(|_| connect(&server)).collect();
    for caller in &mut callers {
        caller.write_all(b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n").unwrap();
    }
    for caller in callers {
        let answer = answer_to(caller);
        assert!(answer.ends_with("the page"), "{answer}");
    }
}

#[test]
fn a_taken_port_is_told_with_its_remedy() {
    let port = listen(0).unwrap().local_addr().unwrap().port();
    let _taken = listen(port).unwrap();
    let error = listen(port).unwrap_err().to_string();
    assert!(error.contains(&port.to_string()) && error.contains("--port N"), "{error}");
}
