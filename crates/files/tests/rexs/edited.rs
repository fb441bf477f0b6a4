//! The backlash of a stage in a copy of the model: nothing else changes.

use super::*;
use gearlash_files::rexs::RexsBacklash;

const BACKLASH: RexsBacklash = RexsBacklash {
    normal: [0.0952133, 0.1655],
    transverse: [0.1, 0.25],
};
const NAMES: [&str; 4] = [
    "minimum_normal_backlash",
    "maximum_normal_backlash",
    "minimum_transverse_backlash",
    "maximum_transverse_backlash",
];
const VALUES: [&str; 4] = ["0.0952133", "0.1655", "0.1", "0.25"];

fn elements() -> [String; 4] {
    std::array::from_fn(|k| {
        let (name, value) = (NAMES[k], VALUES[k]);
        format!("<attribute id=\"{name}\" unit=\"mm\">{value}</attribute>")
    })
}

fn objects() -> [String; 4] {
    std::array::from_fn(|k| {
        let (name, value) = (NAMES[k], VALUES[k]);
        format!("{{\"id\": \"{name}\", \"unit\": \"mm\", \"floating_point\": {value}}}")
    })
}

#[test]
fn xml_attributes_are_added_and_replaced() {
    let text = fixture("gearbox.rexs");
    let file = read(&text).unwrap();
    let last = "<attribute id=\"common_face_width\" unit=\"mm\">20.0</attribute>";
    let added = text.replacen(
        last,
        &format!("{last}\n      {}", elements().join("\n      ")),
        1,
    );
    assert_eq!(file.with_backlash(10, &BACKLASH), Some(added));
    let there = "<attribute id=\"minimum_normal_backlash\" unit=\"mm\">0.5</attribute>";
    let replaced = text.replacen(there, &elements().join("\n      "), 1);
    assert_eq!(file.with_backlash(20, &BACKLASH), Some(replaced.clone()));
    // A second time all are there.
    let again = read(&replaced).unwrap().with_backlash(20, &BACKLASH);
    assert_eq!(again, Some(replaced));
}

#[test]
fn json_attributes_are_added_and_replaced() {
    let text = fixture("gearbox.rexsj");
    let file = read(&text).unwrap();
    let start = text.find("\"id\": \"minimum_normal_backlash\"").unwrap();
    let start = text[..start].rfind('{').unwrap();
    let end = start + text[start..].find('}').unwrap() + 1;
    let indent = "\n     ";
    let expected = [
        &text[..start],
        &objects().join(&format!(",{indent}")),
        &text[end..],
    ]
    .concat();
    let found = file.with_backlash(20, &BACKLASH).unwrap();
    assert_eq!(found, expected);
    assert_eq!(
        read(&found).unwrap().with_backlash(20, &BACKLASH),
        Some(found)
    );
}

#[test]
fn marks_line_ends_prefixes_and_empty_components_stay() {
    let model = |component: &str| {
        format!(
            "\u{feff}<?xml version=\"1.0\"?>\r\n<r:model xmlns:r=\"urn:x\" version=\"1.4\">\r\n<r:components>\r\n\
             \t{component}\r\n</r:components>\r\n</r:model>\r\n"
        )
    };
    let open = "<r:component type=\"cylindrical_stage\" id=\"7\"";
    let added = elements()
        .concat()
        .replace("<attribute", "<r:attribute")
        .replace("</attribute", "</r:attribute");
    for before in [
        format!("{open} />"),
        format!("{open}></r:component>"),
        format!("{open}> <!-- none --></r:component>"),
    ] {
        let found = read(&model(&before)).unwrap().with_backlash(7, &BACKLASH);
        let after = match before.strip_suffix("/>") {
            Some(start) => format!("{start}>{added}</r:component>"),
            None => before.replace("</r:component>", &format!("{added}</r:component>")),
        };
        assert_eq!(found, Some(model(&after)));
    }
    let json = |attributes: &str| {
        format!(
            "\u{feff}{{\"model\":{{\"version\":\"1.4\",\"components\":[{{\"attributes\":[{attributes}],\"id\":7,\"type\":\"cylindrical_stage\"}}]}}}}"
        )
    };
    let found = read(&json(" ")).unwrap().with_backlash(7, &BACKLASH);
    assert_eq!(found, Some(json(&format!("{} ", objects().join(", ")))));
    assert_eq!(read(&json("")).unwrap().with_backlash(8, &BACKLASH), None);
}
