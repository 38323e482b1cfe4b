//! `linkwright watch` over a real socket: the page, a mistake at its line, sliders, a file that disappears, and who is not answered.

use serde_json::Value;
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

const PENDULUM: &str = "planar Pendulum {
    param length [m] = 0.5 in 0.1..2;
    input push [N*m];
    gravity [m/s^2] = (0, -9.81);
    rod bob { mass [kg] = 1; length [m] = length; }
    joint pivot: revolute(ground(0, 0) [m], bob.start);
    torque motor: torque(pivot) = push;
    start { pivot.angle [deg] = -60; pivot.rate [rad/s] = 0; }
    output angle [deg] = pivot.angle;
}
";

/// The program beside a file of its own; both are gone at the end.
struct Watch {
    child: Child,
    file: PathBuf,
    port: u16,
}

impl Watch {
    fn new(name: &str) -> Watch {
        let file = std::env::temp_dir().join(format!("linkwright_watch_{name}_{}.mech", std::process::id()));
        fs::write(&file, PENDULUM).expect("it can be written");
        let mut child = Command::new(env!("CARGO_BIN_EXE_linkwright"))
            .args(["watch", "--port", "0", "--for", "1s", "--step", "10ms"])
            .arg(&file)
            .stdout(Stdio::piped())
            .spawn()
            .expect("the program is built");
        let mut line = String::new();
        let out = child.stdout.as_mut().expect("it writes");
        BufReader::new(out).read_line(&mut line).expect("it says where it is");
        let address = line.strip_prefix("http://127.0.0.1:").expect("an address");
        let port = address.split('/').next().and_then(|port| port.parse().ok()).expect("a port");
        Watch { child, file, port }
    }

    /// Head and body of an answer.
    fn ask(&self, method: &str, target: &str, host: &str) -> (String, String) {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).expect("it listens");
        stream.set_read_timeout(Some(Duration::from_secs(60))).expect("a timeout");
        write!(stream, "{method} {target} HTTP/1.1\r\nHost: {host}\r\n\r\n").expect("it is sent");
        let mut answer = String::new();
        stream.read_to_string(&mut answer).expect("it answers");
        let (head, body) = answer.split_once("\r\n\r\n").expect("a head and a body");
        (head.to_string(), body.to_string())
    }

    fn get(&self, target: &str) -> String {
        let (head, body) = self.ask("GET", target, &format!("127.0.0.1:{}", self.port));
        assert!(head.starts_with("HTTP/1.1 200 OK"), "{head}");
        body
    }

    fn state(&self, query: &str) -> Value {
        serde_json::from_str(&self.get(&format!("/state{query}"))).expect("it is JSON")
    }
}

impl Drop for Watch {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
        let _ = fs::remove_file(&self.file);
    }
}

fn stamp(state: &Value) -> &str {
    state["stamp"].as_str().expect("a stamp")
}

#[test]
fn an_edit_is_shown_at_once() {
    let watch = Watch::new("edit");
    assert!(watch.get("/").contains("<iframe id=\"motion\""));
    let first = watch.state("");
    assert_eq!(first["messages"], Value::Array(Vec::new()));
    assert_eq!(first["name"], "Pendulum");
    assert!(first["drawing"].as_str().expect("a drawing").starts_with("<svg"));
    assert!(first["motion"].as_str().expect("a page").contains("id=\"stage\""));

    // The question waits for the change and is answered by it.
    let wrong = PENDULUM.replace("bob.start", "bob.begin");
    let query = format!("?after={}", stamp(&first));
    let (begin, answer) = std::thread::scope(|scope| {
        let waiting = scope.spawn(|| watch.state(&query));
        std::thread::sleep(Duration::from_millis(200));
        assert!(!waiting.is_finished(), "it waits");
        fs::write(&watch.file, wrong).expect("it can be written");
        (Instant::now(), waiting.join().expect("it is answered"))
    });
    assert!(begin.elapsed() < Duration::from_secs(5), "{:?}", begin.elapsed());
    assert!(answer.get("motion").is_none(), "{answer}");
    let message = &answer["messages"][0];
    assert_eq!((&message["severity"], &message["at"]["line"]), (&"error".into(), &6.into()), "{answer}");
    assert!(message["message"].as_str().expect("a text").contains("begin"), "{answer}");
    assert_eq!(message["at"]["text"], "    joint pivot: revolute(ground(0, 0) [m], bob.begin);");

    // It disappears, is said to be gone, and comes back.
    fs::remove_file(&watch.file).expect("it is there");
    let gone = watch.state(&format!("?after={}", stamp(&answer)));
    assert_eq!(stamp(&gone), "gone");
    assert!(gone["messages"][0]["message"].as_str().expect("a text").contains("there is no file"), "{gone}");
    fs::write(&watch.file, PENDULUM).expect("it can be written");
    assert_eq!(watch.state("?after=gone")["motion"], first["motion"]);
}

#[test]
fn sliders_change_the_motion() {
    let watch = Watch::new("sliders");
    let first = watch.state("");
    let parameter = &first["parameters"][0];
    assert_eq!((&parameter["name"], &parameter["value"]), (&"length".into(), &0.5.into()), "{parameter}");
    assert_eq!(parameter["bounds"], serde_json::json!([0.1, 2.0]));
    let longer = watch.state("?set.length=1.5&input.push=2*sin(t)");
    assert_eq!(longer["parameters"][0]["value"], 1.5);
    assert_eq!(longer["inputs"][0]["law"], "2*sin(t)");
    assert_ne!(longer["motion"], first["motion"]);
    assert_ne!(longer["drawing"], first["drawing"]);
    // What is gone from the file is no mistake, what is wrong is one.
    assert_eq!(watch.state("?set.width=3&input.pull=1")["motion"], first["motion"]);
    let text = |state: &Value| state["messages"][0]["message"].as_str().expect("a message").to_string();
    assert!(text(&watch.state("?set.length=7")).contains("0.1 to 2"));
    assert!(text(&watch.state("?input.push=2*sinn(t)")).contains("sinn"));
}

#[test]
fn strangers_are_not_answered() {
    let watch = Watch::new("strangers");
    let own = format!("127.0.0.1:{}", watch.port);
    for (method, target, host, status) in [
        ("GET", "/", "evil.example", "403"),
        ("GET", "/state", &format!("evil.example:{}", watch.port), "403"),
        ("POST", "/state", &own, "405"),
        ("GET", "/../../etc/passwd", &own, "404"),
    ] {
        let (head, body) = watch.ask(method, target, host);
        assert!(head.starts_with(&format!("HTTP/1.1 {status} ")), "{method} {target} {host}: {head}");
        assert!(!body.contains("Pendulum"), "{body}");
    }
    // A head without an end is cut, and others are answered beside it.
    let mut long = TcpStream::connect(("127.0.0.1", watch.port)).expect("it listens");
    let sent = long.write_all(&[b'x'; 20 << 10]);
    watch.get("/");
    let mut answer = Vec::new();
    if sent.is_ok() && long.read_to_end(&mut answer).is_ok() {
        assert!(answer.starts_with(b"HTTP/1.1 431"), "{}", String::from_utf8_lossy(&answer));
    }
}

#[test]
fn what_cannot_be_watched_is_said() {
    let taken = TcpListener::bind(("127.0.0.1", 0)).expect("a port is free");
    let port = taken.local_addr().expect("it has an address").port().to_string();
    let file = std::env::temp_dir().join(format!("linkwright_watch_taken_{}.mech", std::process::id()));
    fs::write(&file, PENDULUM).expect("it can be written");
    let file_text = file.display().to_string();
    for (arguments, said) in [
        (vec!["watch", "--port", &port, &file_text], format!("port {port} is in use")),
        (vec!["watch", "--port", "70000", &file_text], "no port".to_string()),
        (vec!["watch", "no_such.mech"], "`no_such.mech` cannot be read".to_string()),
        (vec!["watch", "-"], "standard input".to_string()),
        (vec!["watch"], "needs a file".to_string()),
        (vec!["watch", "--prot", "0", &file_text], "port".to_string()),
    ] {
        let output = Command::new(env!("CARGO_BIN_EXE_linkwright"))
            .args(&arguments)
            .output()
            .expect("the program is built");
        let errors = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {errors}");
        assert!(errors.contains(&said), "{arguments:?}: {errors}");
    }
    fs::remove_file(&file).expect("it is there");
}
