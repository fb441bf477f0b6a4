//! The pairs of stages.

use super::oracle::Model;
use super::*;
use std::io::Write;

#[test]
fn xml_and_json_make_the_same_pairs() {
    let (xml, json) = (fixture("gearbox.rexs"), fixture("gearbox.rexsj"));
    let files = [read(&xml).unwrap(), read(&json).unwrap()];
    assert_eq!(
        files.each_ref().map(|f| f.version.clone()),
        ["2.0.0", "1.7"]
    );
    for stage in [10, 20] {
        let [one, two] = files.each_ref().map(|file| pair(file, stage));
        assert_eq!(one, two);
        Model::of_xml(&xml).check(stage.into(), &one);
        Model::of_json(&json).check(stage.into(), &two);
    }
}

#[test]
fn a_designation_a_tool_and_a_tolerance_field() {
    let file = read(&fixture("gearbox.rexs")).unwrap();
    let stage = file.stage(10).unwrap().pair.as_ref().unwrap();
    let by_hand = r#"title = "Input, stage 10 of gearbox.rexs"

[wheel]  # cylindrical_gear 11 Pinion
teeth = 17
module_mm = 4.0
pressure_angle_deg = 20.0
profile_shift = 0.0
rack = { addendum = 1.0, dedendum = 1.25, root_radius = 0.25 }
thickness = { designation = "25c" }

[pinion]  # cylindrical_gear 12 Wheel
teeth = 22
module_mm = 4.0
pressure_angle_deg = 20.0
profile_shift = 0.0
rack = { addendum = 1.0, dedendum = 1.25, root_radius = 0.25 }
thickness = { designation = "25c" }

[assembly]
center_distance_mm = "78 js7"
"#;
    assert_eq!(stage.pair_file, by_hand);
    let unused = stage
        .unused
        .iter()
        .map(|(part, ids)| format!("{part}: {}", ids.join(" ")));
    let unused: Vec<String> = unused.collect();
    assert!(
        unused.contains(&"cylindrical_gear 11: face_width".to_owned()),
        "{unused:?}"
    );
    assert!(
        unused.contains(&"rack_shaped_tool 17: dedendum_coefficient_reference_profile".to_owned()),
        "{unused:?}"
    );
}

#[test]
fn allowances_of_the_span_must_agree_with_the_designation() {
    // DIN 3967 up to d = 50 mm: 25cd is −54/−84 µm, 27c −65/−145 µm. The span has the former, times cos 20°.
    let text = fixture("gearbox.rexs");
    let file = read(&text).unwrap();
    let [wheel, pinion] =
        ["wheel", "pinion"].map(|gear| pair(&file, 20)[gear]["thickness"].clone());
    assert_eq!(wheel.to_string(), "{ designation = \"25cd\" }");
    for (end, expected) in [("upper", -54.0), ("lower", -84.0)] {
        let found = pinion["allowance_um"][end].as_float().unwrap();
        assert!((found - expected).abs() < 1e-3, "{found}");
    }
    let other = read(&text.replacen("cd25", "c27", 1)).unwrap();
    assert_eq!(
        why(&other, 20),
        "cylindrical_gear 21 contradicts itself: 27c is −65.0 / −145.0 µm, the allowances of its span make −54.0 / −84.0 µm"
    );
}

#[test]
fn version_1_0_names_and_places_tools_otherwise() {
    let model = |flank: &str, tool: &str| {
        format!(
            r#"<model version="1.0" applicationId="made" applicationVersion="1" date="">
<relations>
<relation id="1" type="stage"><ref id="1" role="stage"/><ref id="2" role="gear_1"/><ref id="3" role="gear_2"/></relation>
<relation id="2" type="flank"><ref id="2" role="gear"/><ref id="4" role="left"/><ref id="5" role="right"/></relation>
<relation id="3" type="flank"><ref id="3" role="gear"/><ref id="4" role="left"/><ref id="4" role="right"/></relation>
{tool}</relations>
<components>
<component id="1" type="cylindrical_stage"><attribute id="center_distance" unit="mm">60</attribute>
<attribute id="din_3964_center_distance_tolerance_field" unit="none">6</attribute></component>
<component id="2" type="cylindrical_gear"><attribute id="number_of_teeth" unit="none">20</attribute>
<attribute id="normal_module" unit="mm">2</attribute><attribute id="helix_angle_reference_diameter" unit="°">0.0</attribute>
<attribute id="din_3967_deviation_tolerance_series" unit="none">e24</attribute></component>
<component id="3" type="cylindrical_gear"><attribute id="number_of_teeth">40</attribute>
<attribute id="normal_module">2</attribute><attribute id="helix_angle_reference_diameter">-0.0</attribute></component>
<component id="4" type="flank_geometry"><attribute id="normal_pressure_angle" unit="°">20.0</attribute></component>
<component id="5" type="flank_geometry"><attribute id="normal_pressure_angle" unit="°">{flank}</attribute></component>
<component id="6" type="rack_shaped_tool"><attribute id="addendum_reference_profile" unit="mm">2.8</attribute>
<attribute id="tip_radius" unit="mm">0.5</attribute></component>
</components></model>"#
        )
    };
    let tool = r#"<relation id="4" type="ordered_reference" order="1"><ref id="2" role="origin"/><ref id="6" role="referenced"/></relation>"#;
    let file = read(&model("20.0", tool)).unwrap();
    let found = pair(&file, 1);
    assert_eq!(
        found["assembly"]["center_distance_mm"].as_str(),
        Some("60 js6")
    );
    assert_eq!(
        found["wheel"]["thickness"]["designation"].as_str(),
        Some("24e")
    );
    assert_eq!(found["wheel"]["rack"]["dedendum"].as_float(), Some(1.4));
    assert_eq!(found["wheel"]["rack"]["root_radius"].as_float(), Some(0.25));
    let remarks = &file.stage(1).unwrap().pair.as_ref().unwrap().remarks;
    for message in [
        "cylindrical_gear 3 states no tooth thickness: nominal",
        "cylindrical_gear 3 has no addendum_modification_coefficient: taken as 0",
        "cylindrical_gear 3 has no rack-shaped tool with addendum and tip radius: the root is that of ISO 53 A",
    ] {
        assert!(
            remarks.iter().any(|remark| remark == message),
            "{message}: {remarks:?}"
        );
    }
    let different = read(&model("25.0", tool)).unwrap();
    assert!(why(&different, 1).contains("differs from the other flank in normal_pressure_angle"));
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
    assert_eq!(
        pair(&file, 10),
        pair(&read(&fixture("gearbox.rexs")).unwrap(), 10)
    );
    let cut = &bytes.get_ref()[..bytes.get_ref().len() / 2];
    let error = read_bytes(cut).unwrap_err().to_string();
    assert!(
        error.contains("the archive: not a whole zip archive"),
        "{error}"
    );
}

#[test]
fn allowances_of_the_centre_distance_must_agree_with_its_field() {
    // ISO 286: IT7 from 50 to 80 mm is 30 µm, IT6 19 µm.
    let good = fixture("gearbox.rexs");
    let field = |grade: &str| {
        format!(
            "<attribute id=\"center_distance_tolerance_field_din_3964_1980\" unit=\"none\">{grade}</attribute>"
        )
    };
    let ends = |grade: &str, um: f64| {
        let end = |end: &str, um: f64| {
            format!(
                "<attribute id=\"{end}_center_distance_allowance\" unit=\"mum\">{um}</attribute>"
            )
        };
        let new = field(grade) + &end("upper", um) + &end("lower", -um);
        assert!(good.contains(&field("7")));
        read(&good.replacen(&field("7"), &new, 1)).unwrap()
    };
    let distance = pair(&ends("7", 15.0), 10)["assembly"]["center_distance_mm"].clone();
    assert_eq!(distance["upper_um"].as_float(), Some(15.0));
    for (grade, um, message) in [
        (
            "7",
            200.0,
            "js7 is ±15 µm, its centre distance allowances are 200 / −200 µm",
        ),
        (
            "6",
            15.0,
            "js6 is ±9.5 µm, its centre distance allowances are 15 / −15 µm",
        ),
    ] {
        let found = why(&ends(grade, um), 10);
        assert_eq!(
            found,
            format!("cylindrical_stage 10 contradicts itself: {message}")
        );
    }
    let beyond = ends("11", 95.0);
    let remarks = &beyond.stage(10).unwrap().pair.as_ref().unwrap().remarks;
    assert!(
        remarks
            .iter()
            .any(|message| message.contains("js11 is not compared")),
        "{remarks:?}"
    );
}

#[test]
fn the_sign_of_a_micrometre_is_a_unit_and_no_unit_has_a_name() {
    let good = fixture("gearbox.rexs");
    let whole = pair(&read(&good).unwrap(), 20);
    for sign in ["\u{b5}m", "\u{3bc}m"] {
        let text = good.replace("unit=\"mum\"", &format!("unit=\"{sign}\""));
        assert_eq!(pair(&read(&text).unwrap(), 20), whole, "{sign}");
    }
    let text = good.replacen("unit=\"none\">17<", "unit=\"-\">17<", 1);
    assert_ne!(text, good);
    let message = why(&read(&text).unwrap(), 10);
    assert!(
        message.contains("in the unit -, the format has none;"),
        "{message}"
    );
}

#[test]
fn a_model_is_no_pair_file() {
    let folder = tempfile::tempdir().unwrap();
    for (name, of) in [
        ("box.rexs", "gearbox.rexs"),
        ("box.rexsj", "gearbox.rexsj"),
        ("box.xml", "gearbox.rexs"),
    ] {
        let path = folder.path().join(name);
        std::fs::write(&path, fixture(of)).unwrap();
        let message = gearlash_files::read(&path).unwrap_err().to_string();
        assert!(
            message.contains("is a gearbox model; gearlash import "),
            "{message}"
        );
        assert!(message.contains("--stage ID -o pair.toml"), "{message}");
    }
    let none = gearlash_files::read(&folder.path().join("none.rexs")).unwrap_err();
    assert!(none.to_string().contains("there is no such file"), "{none}");
}
