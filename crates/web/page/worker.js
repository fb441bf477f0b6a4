// Runs one gearlash. Each message is a call {id, call, args}; the answer is {id, answer} or {id, fault}.
let gearlash;
let sent = 0;

// At most twenty messages a second.
function progress(done, of, stage) {
  const now = Date.now();
  if (now - sent < 50) return;
  sent = now;
  self.postMessage({ progress: { done, of, stage } });
}

self.onmessage = ({ data: { id, call, args } }) => {
  try {
    let answer = null;
    if (call === "start") {
      wasm_bindgen.initSync({ module: args[0] });
      gearlash = new wasm_bindgen.Gearlash();
      wasm_bindgen.Gearlash.on_progress(progress);
      answer = wasm_bindgen.Gearlash.version();
    } else {
      answer = gearlash[call](...args);
    }
    self.postMessage({ id, answer });
  } catch (fault) {
    self.postMessage({ id, fault: String(fault) });
  }
};
