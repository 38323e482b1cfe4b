//! `linkwright watch`: a local page that follows a definition as it is edited: messages at their lines, drawing, motion, sliders.
//! Only this machine is answered. What is shown is made in `state`; requests are read in `request`.

mod request;
mod state;

use super::options::Study;
use crate::{ERRORS, USAGE};
use request::{Refused, Request};
use serde_json::Value;
use std::fs;
use std::io::{self, Write};
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant, SystemTime};

/// Where it listens if nothing is said.
pub const PORT: u16 = 4180;
/// Between two looks at the file, and at one that is just being written.
const LOOK: Duration = Duration::from_millis(5);
const AGAIN: Duration = Duration::from_millis(3);
/// A file that goes on changing, or stays empty or away, is shown after so many of these.
const LOOKS: usize = 20;
/// How long a page waits for a change before it asks anew.
const PATIENCE: Duration = Duration::from_secs(20);
/// Requests are short and come at once.
const SLOWEST: Duration = Duration::from_secs(5);
/// Of a thread that compiles, bytes.
const STACK: usize = 8 << 20;

const PAGE: &str = include_str!("page.html");
const CSS: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// The command: it ends when it is interrupted.
pub fn watch(study: &Study) -> ExitCode {
    if study.file == "-" {
        return fail(USAGE, "watch follows a file, and standard input is none: write its path");
    }
    let name = study.file.to_string_lossy().into_owned();
    if let Err(error) = fs::metadata(&study.file) {
        return fail(USAGE, &format!("`{name}` cannot be read: {error}"));
    }
    let listener = match TcpListener::bind((Ipv4Addr::LOCALHOST, study.port)) {
        Ok(listener) => listener,
        Err(error) if error.kind() == io::ErrorKind::AddrInUse => {
            let port = study.port;
            return fail(
                USAGE,
                &format!("port {port} is in use: give another with --port, or --port 0 for any that is free"),
            );
        }
        Err(error) => return fail(USAGE, &format!("port {} cannot be opened: {error}", study.port)),
    };
    let port = match listener.local_addr() {
        Ok(address) => address.port(),
        Err(error) => return fail(ERRORS, &format!("the page has no address: {error}")),
    };
    let mut out = io::stdout();
    let _ =
        writeln!(out, "http://127.0.0.1:{port}/ follows {name}; interrupt to end").and_then(|()| out.flush());
    let study = Arc::new(study.clone());
    for stream in listener.incoming().flatten() {
        let study = Arc::clone(&study);
        let answer = move || {
            // A page that was closed meanwhile is no failure.
            let _ = answer(&stream, port, &study);
        };
        let _ = thread::Builder::new().stack_size(STACK).spawn(answer);
    }
    ExitCode::SUCCESS
}

fn fail(code: u8, message: &str) -> ExitCode {
    eprintln!("error: {message}");
    ExitCode::from(code)
}

/// One request of a connection.
fn answer(stream: &TcpStream, port: u16, study: &Study) -> io::Result<()> {
    stream.set_read_timeout(Some(SLOWEST))?;
    stream.set_write_timeout(Some(SLOWEST))?;
    let request = match Request::read(stream, port) {
        Ok(request) => request,
        Err(Refused::Silent) => return Ok(()),
        Err(Refused::With(status, why)) => return send(stream, status, "text/plain", &format!("{why}\n")),
    };
    match request.path.as_str() {
        "/" => {
            let page = PAGE.replace("/*css*/", CSS).replace("/*script*/", SCRIPT);
            send(stream, "200 OK", "text/html", &page)
        }
        "/state" => {
            let stamp = changed(&study.file, request.value("after"));
            let mut state = state::state(study, &request);
            state["stamp"] = Value::from(stamp);
            send(stream, "200 OK", "application/json", &state.to_string())
        }
        other => {
            send(stream, "404 Not Found", "text/plain", &format!("there is no {other}: the page is /\n"))
        }
    }
}

/// The stamp of the file, once it is another than one that is known, or when the page has waited long enough.
fn changed(file: impl AsRef<Path>, known: Option<&str>) -> String {
    let begin = Instant::now();
    loop {
        let stamp = stamp(file.as_ref());
        if known.is_some() && known != Some(&stamp) {
            return settled(stamp, || {
                thread::sleep(AGAIN);
                self::stamp(file.as_ref())
            });
        }
        if known.is_none() || begin.elapsed() > PATIENCE {
            return stamp;
        }
        thread::sleep(LOOK);
    }
}

/// The stamp that two looks in a row find: editors empty a file or take it away before they write it, and what is there meanwhile
/// is nobody's text.
fn settled(mut stamp: String, mut look: impl FnMut() -> String) -> String {
    for _ in 0..LOOKS {
        let again = look();
        let is_text = again != GONE && !again.ends_with(EMPTY);
        if again == stamp && is_text {
            break;
        }
        stamp = again;
    }
    stamp
}

/// The stamp of a file that is gone, and the end of that of an empty one.
const GONE: &str = "gone";
const EMPTY: &str = "-0";

/// When it was changed, and its length; of a file that is gone, that.
fn stamp(file: &Path) -> String {
    let Ok(about) = fs::metadata(file) else { return GONE.to_string() };
    let since = about.modified().ok().and_then(|time| time.duration_since(SystemTime::UNIX_EPOCH).ok());
    format!("{}-{}", since.unwrap_or_default().as_nanos(), about.len())
}

fn send(mut stream: &TcpStream, status: &str, kind: &str, body: &str) -> io::Result<()> {
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {kind}; charset=utf-8\r\nContent-Length: {}\r\nCache-Control: no-store\r\n\
         X-Content-Type-Options: nosniff\r\nCross-Origin-Resource-Policy: same-origin\r\nConnection: close\r\n\r\n",
        body.len()
    );
    stream.write_all(head.as_bytes())?;
    stream.write_all(body.as_bytes())
}

#[cfg(test)]
mod tests {
    use super::{AGAIN, GONE, LOOK, LOOKS, settled};
    use std::time::Duration;

    /// What is shown is the file once it is written, and each look but the last is one that found it changing.
    #[test]
    fn a_file_is_shown_once_it_is_written() {
        for (first, looks, expected) in [
            ("1-9", vec!["1-9"], "1-9"),
            ("1-0", vec!["1-0", "2-4", "3-9", "3-9"], "3-9"),
            (GONE, vec![GONE, "1-9", "1-9"], "1-9"),
            (GONE, vec![GONE; LOOKS], GONE),
            ("1-0", vec!["1-0"; LOOKS], "1-0"),
        ] {
            let mut rest = looks.iter();
            let found = settled(first.to_string(), || rest.next().expect("no look too many").to_string());
            assert_eq!((found.as_str(), rest.len()), (expected, 0), "{first} {looks:?}");
        }
        let mut count = 0;
        let restless = settled(String::new(), || {
            count += 1;
            count.to_string()
        });
        assert_eq!((restless, count), (LOOKS.to_string(), LOOKS));
    }

    /// A tenth of the 100 ms within which an edit is to be seen goes to looking.
    #[test]
    fn looking_leaves_time_for_the_motion() {
        assert!(LOOK + AGAIN <= Duration::from_millis(10));
    }
}
