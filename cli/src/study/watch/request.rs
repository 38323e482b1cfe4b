//! The little of HTTP/1.1 (RFC 9112) that a page of one's own machine needs: the head of a request, and whose it is.

use std::io::{ErrorKind, Read};
use std::net::TcpStream;

/// The longest head, bytes.
const LONGEST: usize = 16 << 10;

/// What a page asks for.
#[derive(Debug)]
pub struct Request {
    pub path: String,
    /// Names and values behind the question mark.
    query: Vec<(String, String)>,
}

/// Why there is nothing to answer, or with what.
#[derive(Debug)]
pub enum Refused {
    /// The other side went away.
    Silent,
    /// Status and reason.
    With(&'static str, String),
}

impl Request {
    /// Reads the head; bodies are none of the page's.
    pub fn read(mut stream: &TcpStream, port: u16) -> Result<Request, Refused> {
        let (mut head, mut piece) = (Vec::new(), [0; 2048]);
        while !head.windows(4).any(|end| end == b"\r\n\r\n") {
            if head.len() > LONGEST {
                let why = format!("the head of a request has at most {LONGEST} bytes");
                return Err(Refused::With("431 Request Header Fields Too Large", why));
            }
            match stream.read(&mut piece) {
                Ok(0) => return Err(Refused::Silent),
                Ok(count) => head.extend_from_slice(&piece[..count]),
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(_) => return Err(Refused::Silent),
            }
        }
        Self::parse(&String::from_utf8_lossy(&head), port)
    }

    fn parse(head: &str, port: u16) -> Result<Request, Refused> {
        let mut lines = head.lines();
        let mut words = lines.next().unwrap_or_default().split(' ');
        let (Some(method), Some(target), Some("HTTP/1.1" | "HTTP/1.0"), None) =
            (words.next(), words.next(), words.next(), words.next())
        else {
            return Err(Refused::With("400 Bad Request", "this is no request of HTTP/1.1".to_string()));
        };
        // A page of another site may send its visitors' browsers here under a name of its own.
        let hosts: Vec<&str> = lines
            .take_while(|line| !line.is_empty())
            .filter_map(|line| line.split_once(':'))
            .filter(|(name, _)| name.eq_ignore_ascii_case("host"))
            .map(|(_, host)| host.trim())
            .collect();
        let own = [format!("127.0.0.1:{port}"), format!("localhost:{port}")];
        match hosts[..] {
            [host] if own.iter().any(|name| name.eq_ignore_ascii_case(host)) => {}
            _ => {
                let why = format!("only http://127.0.0.1:{port}/ is answered");
                return Err(Refused::With("403 Forbidden", why));
            }
        }
        if method != "GET" {
            return Err(Refused::With(
                "405 Method Not Allowed",
                format!("{method}: pages are only read here"),
            ));
        }
        let (path, query) = target.split_once('?').unwrap_or((target, ""));
        let pairs = query.split('&').filter(|pair| !pair.is_empty());
        let query = pairs.map(|pair| {
            let (name, value) = pair.split_once('=').unwrap_or((pair, ""));
            (decoded(name), decoded(value))
        });
        Ok(Request { path: path.to_string(), query: query.collect() })
    }

    pub fn value(&self, name: &str) -> Option<&str> {
        self.query.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str())
    }

    /// Names behind a prefix, and their values.
    pub fn under<'r>(&'r self, prefix: &'r str) -> impl Iterator<Item = (&'r str, &'r str)> {
        self.query.iter().filter_map(move |(name, value)| Some((name.strip_prefix(prefix)?, value.as_str())))
    }
}

/// `%20` and `+` as what they stand for.
fn decoded(text: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = text.as_bytes();
    while let [first, after @ ..] = rest {
        rest = after;
        let hex = |digit: &u8| char::from(*digit).to_digit(16);
        match (first, after) {
            (b'+', _) => bytes.push(b' '),
            (b'%', [high, low, more @ ..]) if hex(high).is_some() && hex(low).is_some() => {
                bytes.push((16 * hex(high).unwrap_or(0) + hex(low).unwrap_or(0)) as u8);
                rest = more;
            }
            (byte, _) => bytes.push(*byte),
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn status(head: &str) -> &'static str {
        match Request::parse(head, 4180) {
            Ok(_) => "200",
            Err(Refused::With(status, _)) => &status[..3],
            Err(Refused::Silent) => "",
        }
    }

    #[test]
    fn only_the_own_page_is_answered() {
        let head = |first: &str, host: &str| format!("{first}\r\n{host}\r\n\r\n");
        for (head, expected) in [
            (head("GET / HTTP/1.1", "Host: 127.0.0.1:4180"), "200"),
            (head("GET / HTTP/1.1", "host: LOCALHOST:4180"), "200"),
            (head("GET / HTTP/1.1", "Host: 127.0.0.1:4181"), "403"),
            (head("GET / HTTP/1.1", "Host: evil.example"), "403"),
            (head("GET / HTTP/1.1", "Host: 127.0.0.1:4180\r\nHost: evil.example"), "403"),
            (head("GET / HTTP/1.1", "Accept: */*"), "403"),
            (head("POST / HTTP/1.1", "Host: 127.0.0.1:4180"), "405"),
            (head("GET /", "Host: 127.0.0.1:4180"), "400"),
            (head("nonsense", ""), "400"),
        ] {
            assert_eq!(status(&head), expected, "{head}");
        }
    }

    #[test]
    fn values_are_decoded() {
        let head = "GET /state?set.length=0.5&input.drive=2*sin(t)%20%2B+1&bad=%zz HTTP/1.1\r\nHost: localhost:4180\r\n\r\n";
        let request = Request::parse(head, 4180).expect("a request");
        assert_eq!(request.path, "/state");
        assert_eq!(request.under("set.").collect::<Vec<_>>(), [("length", "0.5")]);
        assert_eq!(request.value("input.drive"), Some("2*sin(t) + 1"));
        assert_eq!(request.value("bad"), Some("%zz"));
    }
}
