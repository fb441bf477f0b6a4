//! The pairs of stages against the second reading, and zipped models. `tests/sessions/rexs_stages.txt` and `rexs_faults.txt` hold what each stage becomes.

use super::oracle::Model;
use super::*;
use std::io::Write;

#[test]
fn xml_and_json_make_the_same_pairs() {
    let (xml, json) = (fixture("gearbox.rexs"), fixture("gearbox.rexsj"));
    let files = [read(&xml).unwrap(), read(&json).unwrap()];
    let versions = files.each_ref().map(|file| file.version.clone());
    assert_eq!(versions, ["2.0.0", "1.7"]);
    for stage in [10, 20] {
        let [one, two] = files.each_ref().map(|file| pair(file, stage));
        assert_eq!(one, two);
        Model::of_xml(&xml).check(stage.into(), &one);
        Model::of_json(&json).check(stage.into(), &two);
    }
    // Stage 10 wound by 15°.
    for [one, other] in [["15.0", "-15.0"], ["-15.0", "15.0"]] {
        let angle = |angle: &str| format!("unit=\"deg\">{angle}<");
        let wound = xml.replacen(&angle("-0.0"), &angle(one), 1);
        let wound = wound.replacen(&angle("0.0"), &angle(other), 1);
        let wound = wound.replacen(">78.0<", ">80.8<", 1);
        Model::of_xml(&wound).check(10, &pair(&read(&wound).unwrap(), 10));
    }
}

#[test]
fn a_zipped_model_is_read() {
    let mut bytes = std::io::Cursor::new(Vec::new());
    let mut archive = zip::ZipWriter::new(&mut bytes);
    let options = zip::write::SimpleFileOptions::default();
    for (name, content) in [
        ("rexs-model.rexs", fixture("gearbox.rexs")),
        ("__MACOSX/._rexs-model.rexs", "x".to_owned()),
        ("gear.gde", "y".to_owned()),
    ] {
        archive.start_file(name, options).unwrap();
        archive.write_all(content.as_bytes()).unwrap();
    }
    archive.finish().unwrap();
    let file = read_bytes(bytes.get_ref()).unwrap();
    let plain = read(&fixture("gearbox.rexs")).unwrap();
    assert_eq!(pair(&file, 10), pair(&plain, 10));
    let cut = &bytes.get_ref()[..bytes.get_ref().len() / 2];
    let error = read_bytes(cut).unwrap_err().to_string();
    let words = "the archive: not a whole zip archive";
    assert!(error.contains(words), "{error}");
}
