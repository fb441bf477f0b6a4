//! A headless Chromium, spoken to over its DevTools protocol, and a headless Firefox, over WebDriver BiDi.
//!
//! They use a plain WebSocket (`tungstenite`), not a browser library. `headless_chrome` brings 141 crates and compiles the whole
//! protocol as of its release; `chromiumoxide` and `fantoccini` bring an async runtime (and a second program). The dozen commands
//! used here have been stable for years.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use tungstenite::{Message, WebSocket};

/// How long an answer, or a change in the page, may take.
const PATIENCE: Duration = Duration::from_secs(60);

/// Chromium: `$CHROME`, or the first of the usual names on the path.
pub fn chromium() -> Option<PathBuf> {
    on_path("CHROME", &["chromium", "chromium-browser", "google-chrome"])
}

/// Firefox: `$FIREFOX`, or the first of the usual names on the path.
pub fn firefox() -> Option<PathBuf> {
    on_path("FIREFOX", &["firefox-esr", "firefox"])
}

fn on_path(own: &str, names: &[&str]) -> Option<PathBuf> {
    if let Some(named) = std::env::var_os(own) {
        return Some(named.into());
    }
    let path = std::env::var_os("PATH")?;
    let folders: Vec<PathBuf> = std::env::split_paths(&path).collect();
    let mut places = names
        .iter()
        .flat_map(|name| folders.iter().map(move |folder| folder.join(name)));
    places.find(|place| place.is_file())
}

/// A running browser with a profile of its own; ends with this value.
struct Running {
    process: Child,
    /// Where it listens.
    address: String,
    _profile: tempfile::TempDir,
}

impl Running {
    /// Starts a browser that says behind `mark` where it listens; `profile` is the start of the option that names the profile.
    fn start(program: &Path, options: &str, profile: &str, mark: &str) -> Running {
        let folder = tempfile::tempdir().unwrap();
        let mut process = Command::new(program)
            .args(["--headless", "--remote-debugging-port=0"])
            .args(options.split(' '))
            .arg(format!("{profile}{}", folder.path().display()))
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the browser starts");
        let errors = BufReader::new(process.stderr.take().unwrap());
        let mut lines = errors.lines().map_while(Result::ok);
        let found = lines.find_map(|line| Some(line.split_once(mark)?.1.trim().to_owned()));
        // Its pipe must not fill up.
        std::thread::spawn(move || lines.for_each(drop));
        Running {
            process,
            address: found.expect("the browser says where it listens"),
            _profile: folder,
        }
    }

    fn connect(&self, path: &str) -> Connection {
        let host = self.address.trim_start_matches("ws://");
        let stream = TcpStream::connect(host.split('/').next().unwrap()).unwrap();
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        let (socket, _) = tungstenite::client(format!("{}{path}", self.address), stream).unwrap();
        Connection { socket, calls: 0 }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

struct Connection {
    socket: WebSocket<TcpStream>,
    calls: u64,
}

impl Connection {
    /// Sends a command and waits for its answer; `others` takes what comes before it.
    fn call(&mut self, mut command: Value, mut others: impl FnMut(Value)) -> Value {
        self.calls += 1;
        command["id"] = json!(self.calls);
        let text = Message::text(command.to_string());
        self.socket.send(text).expect("the browser takes commands");
        loop {
            let message = self.next();
            if message["id"] == command["id"] {
                assert!(message["error"].is_null(), "{command}: {message}");
                return message["result"].clone();
            }
            others(message);
        }
    }

    fn next(&mut self) -> Value {
        loop {
            let message = self.socket.read().expect("the browser answers in time");
            if let Message::Text(text) = message {
                return serde_json::from_str(&text).unwrap();
            }
        }
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
        let number = value.as_f64();
        number.unwrap_or_else(|| panic!("{expression} is {value}, no number"))
    }

    /// The numbers of the list that an expression evaluates to.
    fn numbers<const N: usize>(&mut self, expression: &str) -> [f64; N] {
        let value = self.eval(expression);
        let list: Result<Vec<f64>, _> = serde_json::from_value(value.clone());
        let numbers = list.ok().and_then(|list| list.try_into().ok());
        numbers.unwrap_or_else(|| panic!("{expression} is {value}, not {N} numbers"))
    }

    /// The text that an expression evaluates to.
    fn text(&mut self, expression: &str) -> String {
        let value = self.eval(expression);
        let text = value.as_str().map(str::to_owned);
        text.unwrap_or_else(|| panic!("{expression} is {value}, no text"))
    }

    /// Fails unless an expression is true.
    fn holds(&mut self, expression: &str) {
        assert_eq!(self.eval(expression), json!(true), "{expression}");
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

pub struct Chromium(Running);

impl Chromium {
    pub fn start(program: &Path) -> Chromium {
        let options = "--no-sandbox --disable-gpu --disable-quic --disable-background-networking \
                       --disable-component-update --disable-sync --no-first-run --hide-scrollbars";
        let mark = "DevTools listening on ";
        Chromium(Running::start(program, options, "--user-data-dir=", mark))
    }

    /// A new tab, `width` by `height` CSS pixels.
    pub fn tab(&self, width: u32, height: u32) -> Tab {
        let mut tab = Tab {
            connection: self.0.connect(""),
            session: Value::Null,
            events: Vec::new(),
        };
        let target = tab.call("Target.createTarget", json!({ "url": "about:blank" }));
        let attach = json!({ "targetId": target["targetId"], "flatten": true });
        tab.session = tab.call("Target.attachToTarget", attach)["sessionId"].clone();
        for domain in ["Page", "Runtime", "Log", "Network"] {
            tab.call(&format!("{domain}.enable"), json!({}));
        }
        tab.resize(width, height);
        tab
    }
}

/// One tab of Chromium.
pub struct Tab {
    connection: Connection,
    session: Value,
    events: Vec<Value>,
}

impl Script for Tab {
    fn open_address(&mut self, address: &str) {
        self.assert_silent();
        self.events.clear();
        self.call("Page.navigate", json!({ "url": address }));
        while self.events("Page.loadEventFired").is_empty() {
            let event = self.connection.next();
            self.events.push(event);
        }
    }

    fn eval(&mut self, expression: &str) -> Value {
        let params =
            json!({ "expression": expression, "returnByValue": true, "awaitPromise": true });
        let answer = self.call("Runtime.evaluate", params);
        let thrown = &answer["exceptionDetails"];
        assert!(thrown.is_null(), "{expression}: {thrown}");
        answer["result"]["value"].clone()
    }
}

impl Tab {
    /// Sends a command and waits for its answer.
    pub fn call(&mut self, method: &str, params: Value) -> Value {
        let mut command = json!({ "method": method, "params": params });
        if !self.session.is_null() {
            command["sessionId"] = self.session.clone();
        }
        let events = &mut self.events;
        self.connection.call(command, |event| events.push(event))
    }

    pub fn resize(&mut self, width: u32, height: u32) {
        let metrics =
            json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false });
        self.call("Emulation.setDeviceMetricsOverride", metrics);
    }

    /// The events of this name since the page was opened.
    pub fn events(&self, method: &str) -> Vec<&Value> {
        let named = |event: &&Value| event["method"] == method;
        self.events.iter().filter(named).collect()
    }

    /// The page has shown no error, said nothing, and asked for nothing elsewhere.
    fn assert_silent(&self) {
        let said = "Runtime.exceptionThrown Runtime.consoleAPICalled Log.entryAdded Page.javascriptDialogOpening";
        for event in said.split(' ') {
            assert_eq!(self.events(event), Vec::<&Value>::new());
        }
        for request in self.events("Network.requestWillBeSent") {
            let url = request["params"]["request"]["url"].as_str().unwrap();
            let mut own = ["file:", "blob:", "data:", "http://127.0.0.1:"].into_iter();
            assert!(own.any(|own| url.starts_with(own)), "it asks for {url}");
        }
    }

    /// Presses and releases a key, as named by `KeyboardEvent.key`; behind `Control+`, with the control key.
    pub fn key(&mut self, key: &str, shift: bool) {
        let with_control = key.strip_prefix("Control+");
        let modifiers = with_control.map_or(0, |_| 2) + if shift { 8 } else { 0 };
        let key = with_control.unwrap_or(key);
        let arrows = ["ArrowLeft", "ArrowUp", "ArrowRight", "ArrowDown"];
        let code = arrows.iter().position(|arrow| *arrow == key);
        let code = code.map_or(0, |arrow| 37 + arrow);
        let mut event = json!({ "key": key, "code": key, "modifiers": modifiers, "windowsVirtualKeyCode": code });
        if key.chars().count() == 1 || key == "Enter" {
            event["text"] = json!(key.replace("Enter", "\r"));
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
        self.numbers(&format!(
            "(() => {{ const e = document.querySelector('{selector}'); e.scrollIntoView({{ block: 'center' }}); \
             const b = e.getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; }})()"
        ))
    }

    /// Clicks the element of a selector.
    pub fn click(&mut self, selector: &str) {
        let at = self.middle(selector);
        self.click_at(at);
    }
}

/// Every tab was silent.
impl Drop for Tab {
    fn drop(&mut self) {
        if !std::thread::panicking() {
            self.assert_silent();
        }
    }
}

/// Firefox with one tab.
pub struct Firefox {
    connection: Connection,
    context: Value,
    _running: Running,
}

impl Firefox {
    pub fn start(program: &Path) -> Firefox {
        let options = "--no-remote --profile";
        let running = Running::start(program, options, "", "BiDi listening on ");
        let mut firefox = Firefox {
            connection: running.connect("/session"),
            context: Value::Null,
            _running: running,
        };
        firefox.call("session.new", json!({ "capabilities": {} }));
        let tree = firefox.call("browsingContext.getTree", json!({}));
        firefox.context = tree["contexts"][0]["context"].clone();
        firefox
    }

    fn call(&mut self, method: &str, params: Value) -> Value {
        let command = json!({ "method": method, "params": params });
        self.connection.call(command, drop)
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
        serde_json::from_str(value).unwrap()
    }
}
