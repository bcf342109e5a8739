//! A small web server for one folder, on this machine only.

use std::fs;
use std::io;
use std::net::{Ipv4Addr, TcpListener};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread::{self, JoinHandle};

use anyhow::{Context, Result, anyhow};
use percent_encoding::percent_decode_str;
use tiny_http::{Header, Method, Request, Response};

/// A browser asks for several files at a time.
const WORKERS: usize = 4;

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
    http: Arc<tiny_http::Server>,
    port: u16,
    workers: Vec<JoinHandle<()>>,
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
        let http = tiny_http::Server::from_listener(listener, None)
            .map_err(|error| anyhow!("cannot serve on port {port}: {error}"))?;
        let http = Arc::new(http);
        let workers = (0..WORKERS).map(|_| {
            let (http, folder) = (Arc::clone(&http), folder.to_owned());
            thread::spawn(move || http.incoming_requests().for_each(|request| answer(request, &folder)))
        });
        Ok(Self { workers: workers.collect(), http, port })
    }

    /// What to type into a browser.
    pub(crate) fn address(&self) -> String {
        format!("http://127.0.0.1:{}/", self.port)
    }

    /// Serves until the program is ended from outside.
    pub(crate) fn wait(mut self) -> Result<()> {
        for worker in self.workers.drain(..) {
            worker.join().map_err(|_| anyhow!("the web server broke down: start it again"))?;
        }
        Ok(())
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        for _ in &self.workers {
            self.http.unblock();
        }
        for worker in self.workers.drain(..) {
            // A worker that panicked has said so already.
            let _ = worker.join();
        }
    }
}

fn answer(request: Request, folder: &Path) {
    let response = match (request.method(), file_of(request.url())) {
        (Method::Get | Method::Head, Some(path)) => match read(&folder.join(&path)) {
            Ok(bytes) => Response::from_data(bytes).with_header(header("Content-Type", mime(&path))),
            Err(_) => plain(404, "not found"),
        },
        (Method::Get | Method::Head, None) => plain(403, "only files below this folder are served"),
        _ => plain(405, "only GET and HEAD are answered"),
    };
    let response =
        HEADERS.iter().fold(response, |response, &(name, value)| response.with_header(header(name, value)));
    // A browser that has gone away does not want its answer.
    let _ = request.respond(response);
}

fn read(path: &Path) -> Result<Vec<u8>> {
    fs::read(path).with_context(|| format!("cannot read {}", path.display()))
}

fn plain(status: u16, text: &str) -> Response<io::Cursor<Vec<u8>>> {
    Response::from_data(text)
        .with_status_code(status)
        .with_header(header("Content-Type", "text/plain; charset=utf-8"))
}

fn header(name: &str, value: &str) -> Header {
    Header::from_bytes(name, value).expect("the names and values are written in this file, in ASCII")
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
        write!(stream, "{request} HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n").unwrap();
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
    fn a_taken_port_is_told_with_its_remedy() {
        let port = listen(0).unwrap().local_addr().unwrap().port();
        let _taken = listen(port).unwrap();
        let error = listen(port).unwrap_err().to_string();
        assert!(error.contains(&port.to_string()) && error.contains("--port N"), "{error}");
    }
}
