//! A small web server for one folder, reachable only from this machine.

use std::fs;
use std::io::{self, Read, Write};
use std::net::{Ipv4Addr, Shutdown, TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use anyhow::{Result, anyhow};
use percent_encoding::percent_decode_str;

use crate::http::{BadCall, Request, Response};

/// Limits on the resources that clients may use.
#[derive(Clone, Copy)]
struct Limits {
    /// Number of requests that are answered at the same time.
    calls: usize,
    /// Upper bound of the time from the connection to the last byte of the request. A browser opens
    /// connections in advance and may never send a request on them.
    asking: Duration,
    /// Upper bound of the time that a client takes to read a response.
    answering: Duration,
}

const LIMITS: Limits =
    Limits { calls: 64, asking: Duration::from_secs(10), answering: Duration::from_secs(60) };

/// Time that a client has to stop sending after the response. If the connection were closed at
/// once, the client would see an error and lose the response.
const LINGER: Duration = Duration::from_secs(2);

/// Pause after a connection that could not be accepted, because the system may have run out of file
/// handles. Also the time limit for writing a refusal.
const PAUSE: Duration = Duration::from_millis(50);

/// Accepted names in the `Host` header. Any other name may be that of a foreign page whose owner
/// points it at this machine to read what is served (DNS rebinding). A port may follow the name,
/// and differs from the server's port if that is forwarded.
const HOSTS: [&str; 3] = ["127.0.0.1", "localhost", "[::1]"];

/// Names and values of headers.
type Headers = &'static [(&'static str, &'static str)];

/// Headers of every response of the demo's own server. The demo may be rebuilt at any time, so nothing is cached. `Allow` is
/// required in the response to a method other than these. The `Cross-Origin` headers make the page
/// `crossOriginIsolated`, so that its clock has a resolution of microseconds.
const HEADERS: [(&str, &str); 6] = [
    ("Allow", "GET, HEAD"),
    ("Cache-Control", "no-store"),
    ("Cross-Origin-Opener-Policy", "same-origin"),
    ("Cross-Origin-Embedder-Policy", "require-corp"),
    ("Cross-Origin-Resource-Policy", "same-origin"),
    ("X-Content-Type-Options", "nosniff"),
];

/// A running server. Dropping it stops the server.
#[derive(Debug)]
pub struct Server {
    port: u16,
    stopped: Arc<AtomicBool>,
    accepting: Option<JoinHandle<()>>,
}

/// Listens on a port of 127.0.0.1. Port 0 stands for any free port.
pub fn listen(port: u16) -> Result<TcpListener> {
    TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(|error| match error.kind() {
        io::ErrorKind::AddrInUse => {
            anyhow!("port {port} is taken by another program: choose another with `--port N`")
        }
        _ => anyhow!("cannot serve on port {port}: {error}; choose another with `--port N`"),
    })
}

impl Server {
    /// Serves `folder` to every client of the port.
    pub fn start(listener: TcpListener, folder: &Path) -> Result<Self> {
        Self::start_within(LIMITS, &HEADERS, listener, folder)
    }

    /// Serves `folder` without any special header, as static hosts do.
    pub fn start_plain(listener: TcpListener, folder: &Path) -> Result<Self> {
        Self::start_within(LIMITS, &[], listener, folder)
    }

    fn start_within(limits: Limits, headers: Headers, listener: TcpListener, folder: &Path) -> Result<Self> {
        let port = listener.local_addr()?.port();
        let stopped = Arc::new(AtomicBool::new(false));
        let (stop, folder) = (Arc::clone(&stopped), Arc::<Path>::from(folder));
        let accepting = thread::spawn(move || {
            for call in listener.incoming().take_while(|_| !stop.load(Ordering::Relaxed)) {
                match call {
                    // The folder's reference count is one more than the number of requests being
                    // answered.
                    Ok(stream) if Arc::strong_count(&folder) > limits.calls => refuse(&stream, headers),
                    Ok(stream) => {
                        let folder = Arc::clone(&folder);
                        // If no thread can be started, the request is dropped; a later one may
                        // succeed.
                        let _ =
                            thread::Builder::new().spawn(move || answer(&stream, &folder, limits, headers));
                    }
                    Err(_) => thread::sleep(PAUSE),
                }
            }
        });
        Ok(Self { port, stopped, accepting: Some(accepting) })
    }

    /// The address to type into a browser.
    pub fn address(&self) -> String {
        format!("http://127.0.0.1:{}/", self.port)
    }

    /// Serves until the program is ended from outside.
    pub fn wait(mut self) -> Result<()> {
        let ended = self.accepting.take().map(JoinHandle::join);
        Err(anyhow!("the web server broke down ({ended:?}): start it again"))
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        self.stopped.store(true, Ordering::Relaxed);
        // The accepting thread sees the flag at the next connection, which is made here.
        let called = TcpStream::connect((Ipv4Addr::LOCALHOST, self.port));
        if let (Ok(_), Some(accepting)) = (called, self.accepting.take()) {
            // If it panicked, it has said so already.
            let _ = accepting.join();
        }
    }
}

/// A connection with a deadline, after which reads and writes fail.
struct Timed<'a> {
    stream: &'a TcpStream,
    end: Instant,
}

impl<'a> Timed<'a> {
    fn new(stream: &'a TcpStream, time: Duration) -> Self {
        Self { stream, end: Instant::now() + time }
    }

    fn left(&self) -> io::Result<Option<Duration>> {
        let left = self.end.saturating_duration_since(Instant::now());
        if left.is_zero() { Err(io::ErrorKind::TimedOut.into()) } else { Ok(Some(left)) }
    }
}

impl Read for Timed<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.stream.set_read_timeout(self.left()?)?;
        self.stream.read(buffer)
    }
}

impl Write for Timed<'_> {
    fn write(&mut self, buffer: &[u8]) -> io::Result<usize> {
        self.stream.set_write_timeout(self.left()?)?;
        self.stream.write(buffer)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.stream.flush()
    }
}

/// Answers one request. A client that does not send it in time gets no response.
fn answer(stream: &TcpStream, folder: &Path, limits: Limits, headers: Headers) {
    let request = Request::read(&mut Timed::new(stream, limits.asking));
    let is_head = request.as_ref().is_ok_and(|request| request.method == "HEAD");
    let response = match request {
        Ok(request) => respond(&request, folder),
        Err(BadCall::Silent) => return,
        Err(BadCall::Malformed) => Response::plain("400 Bad Request", "this is no HTTP"),
        Err(BadCall::TooLarge) => {
            Response::plain("431 Request Header Fields Too Large", "the headers are too many or too long")
        }
    };
    let written = response.write(&mut Timed::new(stream, limits.answering), headers, is_head);
    if written.and_then(|()| stream.shutdown(Shutdown::Write)).is_ok() {
        let _ = io::copy(&mut Timed::new(stream, LINGER), &mut io::sink());
    }
}

/// Refuses a request over the limit. The response is so short that writing it does not have to wait
/// for the client to read.
fn refuse(stream: &TcpStream, headers: Headers) {
    let full = Response::plain("503 Service Unavailable", "too many calls at once");
    let written = full.write(&mut Timed::new(stream, PAUSE), headers, false);
    let _ = written.and_then(|()| stream.shutdown(Shutdown::Write));
}

fn respond(request: &Request, folder: &Path) -> Response {
    let host =
        request.host.rsplit_once(':').filter(|(_, port)| port.bytes().all(|byte| byte.is_ascii_digit()));
    let host = host.map_or(request.host.as_str(), |(name, _)| name);
    if host.is_empty() {
        return Response::plain("400 Bad Request", "a Host is missing");
    }
    if !HOSTS.iter().any(|name| host.eq_ignore_ascii_case(name)) {
        return Response::plain("421 Misdirected Request", "this is another host");
    }
    if !matches!(request.method.as_str(), "GET" | "HEAD") {
        return Response::plain("405 Method Not Allowed", "only GET and HEAD are answered");
    }
    let Some(path) = file_of(&request.target) else {
        return Response::plain("403 Forbidden", "only files below this folder are served");
    };
    match read(folder, &path) {
        Ok(body) => Response { status: "200 OK", mime: mime(&path), body },
        Err(_) => Response::plain("404 Not Found", "there is no such file"),
    }
}

/// Reads a file below a folder. Symbolic links are not followed, because they may lead out of the
/// folder.
fn read(folder: &Path, path: &Path) -> io::Result<Vec<u8>> {
    let file = folder.canonicalize()?.join(path);
    if file.canonicalize()? == file && file.is_file() {
        fs::read(file)
    } else {
        Err(io::ErrorKind::NotFound.into())
    }
}

/// The path that a request's address stands for, relative to the folder, or `None` if the path
/// might lead out of the folder.
fn file_of(url: &str) -> Option<PathBuf> {
    let path = url.split(['?', '#']).next()?.strip_prefix('/')?;
    let path = percent_decode_str(path).decode_utf8().ok()?;
    let (folders, name) = path.rsplit_once('/').unwrap_or(("", &path));
    let name = if name.is_empty() { "index.html" } else { name };
    let parts = folders.split('/').filter(|_| !folders.is_empty()).chain([name]);
    parts.map(|part| is_plain(part).then_some(part)).collect()
}

/// Whether a part of a path is only a file name, on every operating system.
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
mod tests;
