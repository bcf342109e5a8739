//! A small web server for one folder, reachable only from this machine.
//!
//! A connection has one request and one response. A browser opens half a dozen at once, and a server
//! whose pool of threads waits on idle connections leaves some unanswered, as `tiny_http` does.

use std::fs;
use std::io::{self, Read, Write};
use std::net::{Ipv4Addr, Shutdown, TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use anyhow::{Result, anyhow};
use percent_encoding::percent_decode_str;

/// The longest time that a client may take for its request, and may then let the server wait before it
/// reads on.
const PATIENCE: Duration = Duration::from_secs(10);

/// The most requests that are answered at once. A browser has six connections to a host; later clients
/// wait until one has ended, which no client can put off for long.
const MOST_AT_ONCE: usize = 64;

/// Time that a client has to stop sending after the response. If the connection were closed at
/// once, the client would see an error and lose the response.
const LINGER: Duration = Duration::from_secs(2);

/// No browser sends a longer head, or more headers.
const LONGEST_HEAD: usize = 32 * 1024;
const MOST_HEADERS: usize = 64;

/// Accepted names in the `Host` header. Any other name may be that of a foreign page whose owner
/// points it at this machine to read what is served (DNS rebinding). A port may follow the name,
/// and differs from the server's port if that is forwarded.
const HOSTS: [&str; 3] = ["127.0.0.1", "localhost", "[::1]"];

/// Headers of every response of the demo's own server. The demo may be rebuilt at any time, so nothing
/// is cached. `Allow` is required in the response to a method other than these. The `Cross-Origin`
/// headers make the page `crossOriginIsolated`, so that its clock has a resolution of microseconds.
pub const HEADERS: &str = "Allow: GET, HEAD\r\n\
    Cache-Control: no-store\r\n\
    Cross-Origin-Opener-Policy: same-origin\r\n\
    Cross-Origin-Embedder-Policy: require-corp\r\n\
    Cross-Origin-Resource-Policy: same-origin\r\n\
    X-Content-Type-Options: nosniff\r\n";

/// Status and words of a refusal.
type Refusal = (&'static str, &'static str);

const MALFORMED: Refusal = ("400 Bad Request", "this is no HTTP, or has too many headers");

/// A running server, which ends with the program.
#[derive(Debug)]
pub struct Server {
    port: u16,
    accepting: JoinHandle<()>,
}

/// Listens on a port of 127.0.0.1. Port 0 stands for any free port.
pub fn listen(port: u16) -> Result<TcpListener> {
    TcpListener::bind((Ipv4Addr::LOCALHOST, port))
        .map_err(|error| anyhow!("cannot serve on port {port}: {error}; choose another with `--port N`"))
}

impl Server {
    /// Serves `folder` to every client of any free port.
    pub fn start(folder: &Path) -> Result<Self> {
        Self::on(listen(0)?, HEADERS, folder)
    }

    /// Serves `folder` to every client of the port, with these headers in every response.
    pub fn on(listener: TcpListener, headers: &'static str, folder: &Path) -> Result<Self> {
        let port = listener.local_addr()?.port();
        let folder = Arc::<Path>::from(folder);
        let accepting = thread::spawn(move || {
            let places = Arc::new((Mutex::new(MOST_AT_ONCE), Condvar::new()));
            for call in listener.incoming() {
                let Ok(stream) = call else {
                    // The system may have run out of file handles.
                    thread::sleep(Duration::from_millis(50));
                    continue;
                };
                let folder = Arc::clone(&folder);
                let place = Place::wait_for(&places);
                // If no thread can be started, the request is dropped; a later one may succeed.
                let _ = thread::Builder::new().spawn(move || {
                    let _place = place;
                    answer(&stream, &folder, headers)
                });
            }
        });
        Ok(Self { port, accepting })
    }

    /// The address to type into a browser.
    pub fn address(&self) -> String {
        format!("http://127.0.0.1:{}/", self.port)
    }

    /// Serves until the program is ended from outside.
    pub fn wait(self) -> Result<()> {
        let ended = self.accepting.join();
        Err(anyhow!("the web server broke down ({ended:?}): start it again"))
    }
}

/// One of the places for requests that are answered at once.
struct Place(Arc<(Mutex<usize>, Condvar)>);

impl Place {
    fn wait_for(places: &Arc<(Mutex<usize>, Condvar)>) -> Self {
        let (free, changed) = &**places;
        let free = free.lock().unwrap_or_else(PoisonError::into_inner);
        let mut free = changed.wait_while(free, |free| *free == 0).unwrap_or_else(PoisonError::into_inner);
        *free -= 1;
        Self(Arc::clone(places))
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        let (free, changed) = &*self.0;
        *free.lock().unwrap_or_else(PoisonError::into_inner) += 1;
        changed.notify_one();
    }
}

/// Answers one request. A client that sends nothing in time gets no response.
fn answer(mut stream: &TcpStream, folder: &Path, headers: &str) -> io::Result<()> {
    stream.set_write_timeout(Some(PATIENCE))?;
    let call = call(stream, PATIENCE)?;
    let is_head = matches!(call, Ok((true, _)));
    let found = call.and_then(|(_, path)| {
        let body = content(folder, &path).ok_or(("404 Not Found", "there is no such file"))?;
        Ok(("200 OK", mime(&path), body))
    });
    let refuse = |(status, words): Refusal| (status, "text/plain; charset=utf-8", words.into());
    let (status, mime, body) = found.unwrap_or_else(refuse);
    let length = body.len();
    write!(stream, "HTTP/1.1 {status}\r\nContent-Type: {mime}\r\nContent-Length: {length}\r\n")?;
    write!(stream, "{headers}Connection: close\r\n\r\n")?;
    stream.write_all(if is_head { &[] } else { &body })?;
    stream.shutdown(Shutdown::Write)?;
    stream.set_read_timeout(Some(LINGER))?;
    io::copy(&mut stream, &mut io::sink()).map(drop)
}

/// Reads a request that must be complete in this time: whether it wants the headers alone, and the path of
/// a file.
fn call(mut stream: &TcpStream, patience: Duration) -> io::Result<Result<(bool, PathBuf), Refusal>> {
    let end = Instant::now() + patience;
    let (mut head, mut part) = (Vec::new(), [0; 4096]);
    while head.len() < LONGEST_HEAD {
        // A client that sends a byte now and then has no more time than one that sends none.
        let left = end.saturating_duration_since(Instant::now());
        if left.is_zero() {
            return Err(io::ErrorKind::TimedOut.into());
        }
        stream.set_read_timeout(Some(left))?;
        let read = match stream.read(&mut part) {
            // A read with a timeout is not resumed after a signal.
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            read => read?,
        };
        match read {
            0 if head.is_empty() => return Err(io::ErrorKind::UnexpectedEof.into()),
            0 => return Ok(Err(MALFORMED)),
            length => head.extend_from_slice(&part[..length]),
        }
        if let Some(call) = parse(&head).transpose() {
            return Ok(call);
        }
    }
    Ok(Err(MALFORMED))
}

/// Parses the head of a request. Returns `None` while it is incomplete.
fn parse(head: &[u8]) -> Result<Option<(bool, PathBuf)>, Refusal> {
    let mut headers = [httparse::EMPTY_HEADER; MOST_HEADERS];
    let mut request = httparse::Request::new(&mut headers);
    let status = request.parse(head).map_err(|_| MALFORMED)?;
    let (true, Some(method), Some(target)) = (status.is_complete(), request.method, request.path) else {
        return Ok(None);
    };
    let is_host = |header: &&httparse::Header<'_>| header.name.eq_ignore_ascii_case("host");
    let hosts: Vec<_> = request.headers.iter().filter(is_host).map(|header| header.value).collect();
    let &[host] = &hosts[..] else { return Err(("400 Bad Request", "expected one Host")) };
    let host = str::from_utf8(host).unwrap_or_default();
    let named = host.rsplit_once(':').filter(|(_, port)| port.bytes().all(|byte| byte.is_ascii_digit()));
    match named.map_or(host, |(name, _)| name) {
        "" => return Err(("400 Bad Request", "a Host is missing")),
        name if HOSTS.iter().any(|host| host.eq_ignore_ascii_case(name)) => {}
        _ => return Err(("421 Misdirected Request", "this is another host")),
    }
    if !["GET", "HEAD"].contains(&method) {
        return Err(("405 Method Not Allowed", "only GET and HEAD are answered"));
    }
    let file = file_of(target).ok_or(("403 Forbidden", "only files below this folder are served"))?;
    Ok(Some((method == "HEAD", file)))
}

/// Reads a file below a folder. Symbolic links are not followed, because they may lead out of the
/// folder.
fn content(folder: &Path, path: &Path) -> Option<Vec<u8>> {
    let file = folder.canonicalize().ok()?.join(path);
    if file.canonicalize().ok()? == file { fs::read(file).ok() } else { None }
}

/// The path that a request's address stands for, relative to the folder, or `None` if the path
/// might lead out of the folder.
fn file_of(url: &str) -> Option<PathBuf> {
    let path = url.split(['?', '#']).next()?.strip_prefix('/')?;
    let path = percent_decode_str(path).decode_utf8().ok()?;
    let (folders, name) = path.rsplit_once('/').unwrap_or(("", &path));
    let name = if name.is_empty() { "index.html" } else { name };
    let parts = folders.split('/').filter(|_| !folders.is_empty()).chain([name]);
    let is_name =
        |part: &str| !part.is_empty() && !part.starts_with('.') && !part.contains(['/', '\\', ':', '\0']);
    parts.map(|part| is_name(part).then_some(part)).collect()
}

fn mime(path: &Path) -> &'static str {
    match path.extension().and_then(|extension| extension.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("json") => "application/json",
        Some("txt") => "text/plain; charset=utf-8",
        Some("wasm") => "application/wasm",
        Some("svg") => "image/svg+xml",
        Some("jpg") => "image/jpeg",
        Some("png") => "image/png",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A folder with a page, and a server of it.
    fn served() -> (tempfile::TempDir, Server) {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("index.html"), "the page").unwrap();
        let server = Server::start(folder.path()).unwrap();
        (folder, server)
    }

    /// Sends bytes, and returns all that comes back.
    fn send(server: &Server, bytes: &[u8]) -> String {
        let mut stream = TcpStream::connect(("127.0.0.1", server.port)).unwrap();
        // An error does not matter: the server may refuse the request before all of it is sent.
        let _ = stream.write_all(bytes);
        let mut answer = String::new();
        stream.read_to_string(&mut answer).expect("an answer that no reset follows");
        answer
    }

    fn ask(server: &Server, request: &str) -> String {
        send(server, format!("{request} HTTP/1.1\r\nHost: localhost\r\n\r\n").as_bytes())
    }

    #[test]
    fn an_address_never_leads_out_of_the_folder() {
        for (url, file) in [
            ("/", "index.html"),
            ("/?width=960&height=540", "index.html"),
            ("/data/", "data/index.html"),
            ("/two%20words.svg#part", "two words.svg"),
        ] {
            assert_eq!(file_of(url), Some(file.into()), "{url}");
        }
        for url in "|index.html|http://127.0.0.1/|/..|/../a|/b/../../a|/%2e%2e/a|/..%2fa|/.git/a|/..\\a|/c:/a|/%00|/%ff\
            |//a/b|/b//a|/%2fa/b"
            .split('|')
        {
            assert_eq!(file_of(url), None, "{url}");
        }
    }

    #[test]
    fn the_folder_is_served_isolated_and_uncached() {
        let (folder, server) = served();
        let page = ask(&server, "GET /");
        assert!(page.starts_with("HTTP/1.1 200") && page.ends_with("the page"), "{page}");
        let headers = format!("Type: text/html; charset=utf-8\r\nContent-Length: 8\r\n{HEADERS}");
        assert!(page.contains(&headers), "{page}");
        assert_eq!(ask(&server, "HEAD /") + "the page", page);
        // A link is not followed, not even to a file that is served.
        #[cfg(unix)]
        std::os::unix::fs::symlink(folder.path().join("index.html"), folder.path().join("link")).unwrap();
        for (request, status) in [
            ("GET /none.html", "404"),
            ("GET /../index.html", "403"),
            ("POST /", "405"),
            ("GET /link", "404"),
        ] {
            assert_eq!(ask(&server, request).split(' ').nth(1), Some(status), "{request}");
        }
    }

    /// With a byte now and then, a client would keep a thread for hours.
    #[test]
    fn a_slow_request_ends_when_its_time_is_over() {
        let listener = listen(0).unwrap();
        let mut client = TcpStream::connect(listener.local_addr().unwrap()).unwrap();
        let (stream, _) = listener.accept().unwrap();
        let slow = thread::spawn(move || {
            // Ends once the server has closed the connection.
            while client.write_all(b"G").is_ok() {
                thread::sleep(Duration::from_millis(20));
            }
        });
        let found = call(&stream, Duration::from_millis(200)).map(|call| call.map_err(|(status, _)| status));
        let ended = found.as_ref().err().map(io::Error::kind);
        assert!(
            matches!(ended, Some(io::ErrorKind::TimedOut | io::ErrorKind::WouldBlock)),
            "expected no more time, found {found:?}"
        );
        drop(stream);
        slow.join().unwrap();
    }

    #[test]
    fn clients_beyond_the_most_wait_and_are_answered() {
        let (_folder, server) = served();
        let idle = || TcpStream::connect(("127.0.0.1", server.port)).unwrap();
        let mut idle: Vec<_> = (0..MOST_AT_ONCE).map(|_| idle()).collect();
        thread::scope(|scope| {
            let late = scope.spawn(|| ask(&server, "GET /"));
            thread::sleep(Duration::from_millis(200));
            assert!(!late.is_finished(), "expected a client that waits");
            idle.pop();
            assert!(late.join().unwrap().ends_with("the page"));
        });
    }

    #[test]
    fn only_requests_to_this_machine_are_answered() {
        let (_folder, server) = served();
        let hosted = |hosts: &str| format!("GET / HTTP/1.1\r\n{hosts}\r\n").into_bytes();
        let local = "Host: 127.0.0.1\r\n";
        for (bytes, status) in [
            (hosted(local), "200"),
            (hosted("Host: 127.0.0.1:8080\r\n"), "200"),
            (hosted("host: LocalHost:1\r\n"), "200"),
            (hosted("Host: evil.example\r\n"), "421"),
            (hosted("Host: 127.0.0.1.evil.example:8080\r\n"), "421"),
            (hosted("Host: evil.example:127.0.0.1\r\n"), "421"),
            (hosted("Host: localhost@evil.example\r\n"), "421"),
            (hosted("Host: \r\n"), "400"),
            (hosted(""), "400"),
            (hosted(&format!("{local}Host: evil.example\r\n")), "400"),
            (hosted(&format!("{local}{}", "A: b\r\n".repeat(70))), "400"),
            (hosted(&format!("{local}A: {}\r\n", "b".repeat(4 << 20))), "400"),
            (b"GET /\r\n\r\n".to_vec(), "400"),
            (b"GET /\xff HTTP/1.1\r\n\r\n".to_vec(), "400"),
            (b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03".to_vec(), "400"),
        ] {
            let answer = send(&server, &bytes);
            let found = answer.split(' ').nth(1);
            assert_eq!(found, Some(status), "{}", String::from_utf8_lossy(&bytes[..bytes.len().min(80)]));
        }
    }
}
