//! `gearlash report --live`: the page with a pair in it.

use super::{fixture, gearlash};
use data_encoding::BASE64;
use predicates::prelude::*;
use serde_json::Value;
use tempfile::TempDir;

/// A page without a pair, as far as the program reads it.
const PAGE: &str =
    "<html><script type=\"application/json\" id=\"own\">null</script><p>rest</p></html>";

#[test]
fn a_live_page_holds_the_files_of_the_pair() {
    let folder = TempDir::new().unwrap();
    let page = folder.path().join("empty.html");
    std::fs::write(&page, PAGE).unwrap();
    let pair = fixture("sheets/inspected_44x44.toml");
    let mut command = gearlash(folder.path());
    command.arg("report").arg(&pair).args(["--live", "--page"]);
    command.arg(&page).args(["-o", "with.html"]);
    command.assert().success();
    let text = std::fs::read_to_string(folder.path().join("with.html")).unwrap();
    let held = text.split("id=\"own\">").nth(1).unwrap();
    let held: Value = serde_json::from_str(held.split("</script>").next().unwrap()).unwrap();
    assert_eq!(held["main"], "inspected_44x44.toml");
    let files = held["files"].as_object().unwrap();
    assert!(files.len() > 1, "{:?}", files.keys());
    for (name, bytes) in files {
        let bytes = BASE64.decode(bytes.as_str().unwrap().as_bytes()).unwrap();
        let own = fixture("sheets").join(name);
        assert_eq!(bytes, std::fs::read(own).unwrap(), "{name}");
    }
    assert!(text.ends_with("<p>rest</p></html>"));
}

#[test]
fn without_a_page_it_says_where_to_get_it() {
    let folder = TempDir::new().unwrap();
    let pair = fixture("karba_44x44.toml");
    let mut command = gearlash(folder.path());
    command
        .arg("report")
        .arg(&pair)
        .args(["--live", "--page", "no.html"]);
    let told = predicate::str::contains("crates/web/build");
    command.assert().code(2).stderr(told);
}
