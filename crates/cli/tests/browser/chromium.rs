//! A headless Chromium, spoken to over its DevTools protocol.
//!
//! It uses a plain WebSocket (`tungstenite`), not a browser library. `headless_chrome` brings 141 crates and compiles the whole
//! protocol as of its release; `chromiumoxide` and `fantoccini` bring an async runtime (and a second program). The dozen commands
//! used here have been stable for years.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use tungstenite::{Message, WebSocket};

const FLAGS: [&str; 10] = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
    "--hide-scrollbars",
    "--remote-debugging-port=0",
];
/// How long an answer, or a change in the page, may take.
pub const PATIENCE: Duration = Duration::from_secs(60);

/// The browser to use: `$CHROME`, or the first of the usual names on the path.
pub fn find() -> Option<PathBuf> {
    on_path("CHROME", &["chromium", "chromium-browser", "google-chrome"])
}

/// The program that the variable `own` names, or the first of `names` on the path.
pub fn on_path(own: &str, names: &[&str]) -> Option<PathBuf> {
    if let Some(named) = std::env::var_os(own) {
        return Some(named.into());
    }
    let path = std::env::var_os("PATH")?;
    let folders: Vec<PathBuf> = std::env::split_paths(&path).collect();
    let places = names
        .iter()
        .flat_map(|name| folders.iter().map(move |folder| folder.join(name)));
    places.into_iter().find(|place| place.is_file())
}

/// A running browser with a profile of its own; ends with this value.
pub struct Chromium {
    process: Child,
    address: String,
    _profile: tempfile::TempDir,
}

impl Chromium {
    /// Starts `program`.
    pub fn start(program: &Path) -> Chromium {
        let profile = tempfile::tempdir().expect("a folder for the profile");
        let mut process = Command::new(program)
            .args(FLAGS)
            .arg(format!("--user-data-dir={}", profile.path().display()))
            .arg("about:blank")
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .expect("Chromium starts");
        let errors = process.stderr.take().expect("stderr is piped");
        let mut lines = BufReader::new(errors).lines().map_while(Result::ok);
        let found = lines.find_map(|line| {
            let address = line.strip_prefix("DevTools listening on ")?;
            Some(address.trim().to_owned())
        });
        // Its pipe must not fill up.
        std::thread::spawn(move || lines.for_each(drop));
        let address = found.expect("Chromium says where it listens");
        Chromium {
            process,
            address,
            _profile: profile,
        }
    }

    /// A new tab, `width` by `height` CSS pixels.
    pub fn tab(&self, width: u32, height: u32) -> Tab {
        let host = self.address.trim_start_matches("ws://");
        let host = host.split('/').next().expect("an address has a host");
        let stream = TcpStream::connect(host).expect("Chromium listens");
        stream
            .set_read_timeout(Some(PATIENCE))
            .expect("a timeout above zero");
        let (socket, _) = tungstenite::client(self.address.as_str(), stream).expect("a WebSocket");
        let mut tab = Tab {
            socket,
            session: None,
            calls: 0,
            events: Vec::new(),
        };
        let target = tab.call("Target.createTarget", json!({ "url": "about:blank" }));
        let attach = json!({ "targetId": target["targetId"], "flatten": true });
        let session = tab.call("Target.attachToTarget", attach);
        tab.session = session["sessionId"].as_str().map(str::to_owned);
        for domain in [
            "Page.enable",
            "Runtime.enable",
            "Log.enable",
            "Network.enable",
        ] {
            tab.call(domain, json!({}));
        }
        let metrics =
            json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false });
        tab.call("Emulation.setDeviceMetricsOverride", metrics);
        tab
    }
}

impl Drop for Chromium {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// A page that runs scripts, in any browser.
pub trait Script {
    /// Opens an address and waits until it is loaded.
    fn open_address(&mut self, address: &str);

    /// The value of a JavaScript expression.
    fn eval(&mut self, expression: &str) -> Value;

    /// Opens a file from disk and waits until it is loaded.
    fn open(&mut self, page: &Path) {
        self.open_address(&format!("file://{}", page.display()));
    }

    /// The number that an expression evaluates to.
    fn number(&mut self, expression: &str) -> f64 {
        let value = self.eval(expression);
        value
            .as_f64()
            .unwrap_or_else(|| panic!("{expression} is {value}, no number"))
    }

    /// The text that an expression evaluates to.
    fn text(&mut self, expression: &str) -> String {
        let value = self.eval(expression);
        let text = value.as_str().map(str::to_owned);
        text.unwrap_or_else(|| panic!("{expression} is {value}, no text"))
    }

    /// Waits until an expression is true.
    fn until(&mut self, expression: &str) {
        self.until_within(expression, PATIENCE);
    }

    /// Waits until an expression is true, at most so long.
    fn until_within(&mut self, expression: &str, most: Duration) {
        let start = Instant::now();
        while self.eval(expression) != json!(true) {
            assert!(start.elapsed() < most, "in vain: {expression}");
            std::thread::sleep(Duration::from_millis(10));
        }
    }
}

impl Script for Tab {
    fn open_address(&mut self, address: &str) {
        self.events.clear();
        self.call("Page.navigate", json!({ "url": address }));
        let loaded = |event: &Value| event["method"] == "Page.loadEventFired";
        while !self.events.iter().any(loaded) {
            let event = self.next();
            self.events.push(event);
        }
    }

    fn eval(&mut self, expression: &str) -> Value {
        let params =
            json!({ "expression": expression, "returnByValue": true, "awaitPromise": true });
        let answer = self.call("Runtime.evaluate", params);
        assert!(
            answer["exceptionDetails"].is_null(),
            "{expression}: {}",
            answer["exceptionDetails"]
        );
        answer["result"]["value"].clone()
    }
}

/// One tab.
pub struct Tab {
    socket: WebSocket<TcpStream>,
    session: Option<String>,
    calls: u64,
    events: Vec<Value>,
}

impl Tab {
    /// Sends a command and waits for its answer.
    pub fn call(&mut self, method: &str, params: Value) -> Value {
        self.calls += 1;
        let id = self.calls;
        let mut command = json!({ "id": id, "method": method, "params": params });
        if let Some(session) = &self.session {
            command["sessionId"] = json!(session);
        }
        self.socket
            .send(Message::text(command.to_string()))
            .expect("Chromium takes commands");
        loop {
            let message = self.next();
            if message["id"] == json!(id) {
                assert!(message["error"].is_null(), "{method}: {}", message["error"]);
                return message["result"].clone();
            }
            self.events.push(message);
        }
    }

    fn next(&mut self) -> Value {
        loop {
            match self.socket.read().expect("Chromium answers in time") {
                Message::Text(text) => {
                    return serde_json::from_str(&text).expect("DevTools speak JSON");
                }
                _ => continue,
            }
        }
    }

    /// The events of this name since the page was opened.
    pub fn events(&self, method: &str) -> Vec<&Value> {
        let named = |event: &&Value| event["method"] == method;
        self.events.iter().filter(named).collect()
    }

    /// Presses and releases a key, as named by `KeyboardEvent.key`.
    pub fn key(&mut self, key: &str, shift: bool) {
        let modifiers = if shift { 8 } else { 0 };
        let code = match key {
            "ArrowLeft" => 37,
            "ArrowUp" => 38,
            "ArrowRight" => 39,
            "ArrowDown" => 40,
            _ => 0,
        };
        let mut event = json!({ "key": key, "code": key, "modifiers": modifiers, "windowsVirtualKeyCode": code });
        if key.chars().count() == 1 {
            event["text"] = json!(key);
        }
        for kind in ["keyDown", "keyUp"] {
            event["type"] = json!(kind);
            self.call("Input.dispatchKeyEvent", event.clone());
        }
    }

    /// A mouse event at a place of the window.
    pub fn mouse(&mut self, kind: &str, [x, y]: [f64; 2], wheel: f64) {
        let held = if kind == "mouseWheel" { "none" } else { "left" };
        self.call(
            "Input.dispatchMouseEvent",
            json!({ "type": kind, "x": x, "y": y, "button": held, "buttons": 1, "clickCount": 1, "deltaX": 0, "deltaY": wheel }),
        );
    }

    /// Clicks a place of the window.
    pub fn click_at(&mut self, at: [f64; 2]) {
        self.mouse("mousePressed", at, 0.0);
        self.mouse("mouseReleased", at, 0.0);
    }

    /// Brings the element of a selector into view; the middle of its box in the window.
    pub fn middle(&mut self, selector: &str) -> [f64; 2] {
        let found = self.eval(&format!(
            "(() => {{ const e = document.querySelector('{selector}'); e.scrollIntoView({{ block: 'center' }}); \
             const b = e.getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; }})()"
        ));
        [0, 1].map(|i| found[i].as_f64().expect("a box has a middle"))
    }

    /// Clicks the element of a selector.
    pub fn click(&mut self, selector: &str) {
        let at = self.middle(selector);
        self.click_at(at);
    }
}
