//! A headless Firefox, spoken to over WebDriver BiDi, which it has without another program.

use crate::chromium::{PATIENCE, Script, on_path};
use serde_json::{Value, json};
use std::io::{BufRead, BufReader};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use tungstenite::{Message, WebSocket};

/// The browser to use: `$FIREFOX`, or the first of the usual names on the path.
pub fn find() -> Option<PathBuf> {
    on_path("FIREFOX", &["firefox-esr", "firefox"])
}

/// A running browser with one tab and a profile of its own; ends with this value.
pub struct Firefox {
    process: Child,
    socket: WebSocket<TcpStream>,
    context: String,
    calls: u64,
    _profile: tempfile::TempDir,
}

impl Firefox {
    /// Starts `program`.
    pub fn start(program: &Path) -> Firefox {
        let profile = tempfile::tempdir().expect("a folder for the profile");
        let mut process = Command::new(program)
            .args([
                "--headless",
                "--no-remote",
                "--remote-debugging-port=0",
                "--profile",
            ])
            .arg(profile.path())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .expect("Firefox starts");
        let errors = process.stderr.take().expect("stderr is piped");
        let mut lines = BufReader::new(errors).lines().map_while(Result::ok);
        let found = lines.find_map(|line| {
            let (_, address) = line.split_once("BiDi listening on ")?;
            Some(address.trim().to_owned())
        });
        // Its pipe must not fill up.
        std::thread::spawn(move || lines.for_each(drop));
        let address = found.expect("Firefox says where it listens");
        let stream = TcpStream::connect(address.trim_start_matches("ws://"));
        let stream = stream.expect("Firefox listens");
        stream
            .set_read_timeout(Some(PATIENCE))
            .expect("a timeout above zero");
        let (socket, _) =
            tungstenite::client(format!("{address}/session"), stream).expect("a WebSocket");
        let mut firefox = Firefox {
            process,
            socket,
            context: String::new(),
            calls: 0,
            _profile: profile,
        };
        firefox.call("session.new", json!({ "capabilities": {} }));
        let tree = firefox.call("browsingContext.getTree", json!({}));
        let context = tree["contexts"][0]["context"].as_str();
        context.expect("a tab").clone_into(&mut firefox.context);
        firefox
    }

    fn call(&mut self, method: &str, params: Value) -> Value {
        self.calls += 1;
        let command = json!({ "id": self.calls, "method": method, "params": params });
        self.socket
            .send(Message::text(command.to_string()))
            .expect("Firefox takes commands");
        loop {
            let message = self.socket.read().expect("Firefox answers in time");
            let Message::Text(text) = message else {
                continue;
            };
            let answer: Value = serde_json::from_str(&text).expect("BiDi speaks JSON");
            if answer["id"] == json!(self.calls) {
                assert_eq!(answer["type"], "success", "{method}: {answer}");
                return answer["result"].clone();
            }
        }
    }
}

impl Drop for Firefox {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

impl Script for Firefox {
    fn open_address(&mut self, address: &str) {
        let to = json!({ "context": self.context, "url": address, "wait": "complete" });
        self.call("browsingContext.navigate", to);
    }

    fn eval(&mut self, expression: &str) -> Value {
        let json = format!("(async () => JSON.stringify((await ({expression})) ?? null))()");
        let evaluated = self.call(
            "script.evaluate",
            json!({ "expression": json, "target": { "context": self.context }, "awaitPromise": true }),
        );
        let value = evaluated["result"]["value"].as_str();
        let value = value.unwrap_or_else(|| panic!("{expression}: {evaluated}"));
        serde_json::from_str(value).expect("a value is JSON")
    }
}
