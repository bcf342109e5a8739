//! A small web server for one folder, on this machine only.

use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};
use std::time::Duration;
use std::{fs, io};

use anyhow::{Result, anyhow};
use percent_encoding::percent_decode_str;

use crate::http::{Request, Response};

/// A browser opens connections in advance, which may never ask for anything.
const PATIENCE: Duration = Duration::from_secs(30);

/// The demo may be rebuilt at any time, so nothing is cached; the rest makes the page `crossOriginIsolated`, which
/// gives its clock microseconds.
const HEADERS: [(&str, &str); 5] = [
    ("Cache-Control", "no-store"),
    ("Cross-Origin-Opener-Policy", "same-origin"),
    ("Cross-Origin-Embedder-Policy", "require-corp"),
    ("Cross-Origin-Resource-Policy", "same-origin"),
    ("X-Content-Type-Options", "nosniff"),
];

/// A running server; dropping it stops it.
pub(crate) struct Server {
    port: u16,
    stopped: Arc<AtomicBool>,
    accepting: Option<JoinHandle<()>>,
}

/// Takes a port of 127.0.0.1; port 0 stands for any that is free.
pub(crate) fn listen(port: u16) -> Result<TcpListener> {
    TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(|error| match error.kind() {
        io::ErrorKind::AddrInUse => {
            anyhow!("port {port} is taken by another program: choose another with `--port N`")
        }
        _ => anyhow!("cannot serve on port {port}: {error}; choose another with `--port N`"),
    })
}

impl Server {
    /// Serves `folder` to whoever calls the port.
    pub(crate) fn start(listener: TcpListener, folder: &Path) -> Result<Self> {
        let port = listener.local_addr()?.port();
        let stopped = Arc::new(AtomicBool::new(false));
        let (stop, folder) = (Arc::clone(&stopped), Arc::<Path>::from(folder));
        let accepting = thread::spawn(move || {
            let calls = listener.incoming().take_while(|_| !stop.load(Ordering::Relaxed));
            for stream in calls.flatten() {
                let folder = Arc::clone(&folder);
                thread::spawn(move || answer(stream, &folder));
            }
        });
        Ok(Self { port, stopped, accepting: Some(accepting) })
    }

    /// What to type into a browser.
    pub(crate) fn address(&self) -> String {
        format!("http://127.0.0.1:{}/", self.port)
    }

    /// Serves until the program is ended from outside.
    pub(crate) fn wait(mut self) -> Result<()> {
        let ended = self.accepting.take().map(JoinHandle::join);
        Err(anyhow!("the web server broke down ({ended:?}): start it again"))
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        self.stopped.store(true, Ordering::Relaxed);
        // It learns of that with the next call.
        let called = TcpStream::connect((Ipv4Addr::LOCALHOST, self.port));
        if let (Ok(_), Some(accepting)) = (called, self.accepting.take()) {
            // If it panicked, it has said so already.
            let _ = accepting.join();
        }
    }
}

/// Answers a call. One that breaks off, or is no HTTP, gets no answer and misses none.
fn answer(mut stream: TcpStream, folder: &Path) {
    let _ = stream.set_read_timeout(Some(PATIENCE));
    if let Ok(request) = Request::read(&mut stream) {
        let _ = respond(&request, folder).write(&mut stream, &HEADERS, request.method == "HEAD");
    }
}

fn respond(request: &Request, folder: &Path) -> Response {
    if !matches!(request.method.as_str(), "GET" | "HEAD") {
        return Response::plain("405 Method Not Allowed", "only GET and HEAD are answered");
    }
    let Some(path) = file_of(&request.target) else {
        return Response::plain("403 Forbidden", "only files below this folder are served");
    };
    match fs::read(folder.join(&path)) {
        Ok(body) => Response { status: "200 OK", mime: mime(&path), body },
        Err(_) => Response::plain("404 Not Found", "there is no such file"),
    }
}

/// The file that a request's address stands for, relative to the folder; none where it might lead out of it.
fn file_of(url: &str) -> Option<PathBuf> {
    let path = url.split(['?', '#']).next()?.strip_prefix('/')?;
    let path = percent_decode_str(path).decode_utf8().ok()?;
    let (folders, name) = path.rsplit_once('/').unwrap_or(("", &path));
    let name = if name.is_empty() { "index.html" } else { name };
    let parts = folders.split('/').filter(|_| !folders.is_empty()).chain([name]);
    parts.map(|part| is_plain(part).then_some(part)).collect()
}

/// Whether a part of a path is a name and nothing more, on every system.
fn is_plain(part: &str) -> bool {
    !part.is_empty() && !part.starts_with('.') && !part.contains(['/', '\\', ':', '\0'])
}

fn mime(path: &Path) -> &'static str {
    match path.extension().and_then(|extension| extension.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("js" | "mjs") => "text/javascript; charset=utf-8",
        Some("json") => "application/json",
        Some("csv") => "text/csv; charset=utf-8",
        Some("txt" | "md") => "text/plain; charset=utf-8",
        Some("wasm") => "application/wasm",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        Some("ico") => "image/x-icon",
        Some("woff2") => "font/woff2",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
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

    fn ask(server: &Server, request: &str) -> String {
        let mut stream = TcpStream::connect(("127.0.0.1", server.port)).unwrap();
        write!(stream, "{request} HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n").unwrap();
        let mut answer = String::new();
        stream.read_to_string(&mut answer).unwrap();
        answer
    }

    #[test]
    fn the_folder_is_served_isolated_and_uncached() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("index.html"), "the page").unwrap();
        let server = Server::start(listen(0).unwrap(), folder.path()).unwrap();
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
        assert!(ask(&server, "POST /").starts_with("HTTP/1.1 405"));
    }

    #[test]
    fn many_callers_at_once_are_answered_while_others_say_nothing() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("index.html"), "the page").unwrap();
        let server = Server::start(listen(0).unwrap(), folder.path()).unwrap();
        let connect = |_| TcpStream::connect(("127.0.0.1", server.port)).unwrap();
        let _silent: Vec<_> = (0..16).map(connect).collect();
        let mut callers: Vec<_> = (0..16).map(connect).collect();
        for caller in &mut callers {
            caller.set_read_timeout(Some(Duration::from_secs(10))).unwrap();
            caller.write_all(b"GET / HTTP/1.1\r\n\r\n").unwrap();
        }
        for mut caller in callers {
            let mut answer = String::new();
            caller.read_to_string(&mut answer).unwrap();
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
}
