//! Features that plain readers of SVG lack: no picture uses them.
//!
//! Inkscape 1.2 showed no gears, since it takes `<use>` by XLink's `href` alone. LibreOffice 7.4 showed the whole pinion as overlap, since it
//! neither clips by a `<use>` nor clips one.

use roxmltree::{Document, Node};

const XLINK: &str = "http://www.w3.org/1999/xlink";

/// Elements that more readers understand than browsers do.
const PLAIN: [&str; 14] = [
    "svg",
    "g",
    "defs",
    "path",
    "rect",
    "circle",
    "text",
    "tspan",
    "use",
    "clipPath",
    "pattern",
    "title",
    "animate",
    "animateTransform",
];

/// `svg` is understood by plain readers.
pub fn check(name: &str, svg: &str) {
    let document = Document::parse(svg).unwrap();
    let elements = document.descendants().filter(Node::is_element);
    for node in elements {
        let tag = node.tag_name().name();
        assert!(PLAIN.contains(&tag), "{name}: {tag}");
        for lacking in [
            "href",
            "style",
            "class",
            "paint-order",
            "dominant-baseline",
            "mask",
        ] {
            let mut plain = node.attributes().filter(|one| one.namespace().is_none());
            let has = plain.any(|one| one.name() == lacking);
            assert!(!has, "{name}: {lacking} of {tag}");
        }
        let within = |above: &str| node.ancestors().any(|node| node.has_tag_name(above));
        if tag == "use" {
            let target = node.attribute((XLINK, "href")).unwrap();
            let target = target.strip_prefix('#').unwrap();
            let mut ids = document
                .descendants()
                .filter_map(|node| node.attribute("id"));
            assert!(ids.any(|id| id == target), "{name}: {target}");
            assert!(!within("clipPath"), "{name}: clipped by a use of {target}");
            assert!(
                !node.has_attribute("clip-path"),
                "{name}: a use of {target} clipped"
            );
        }
        // Each tspan of an anchored text goes to the text's own place.
        if tag == "tspan" {
            let text = node
                .ancestors()
                .find(|node| node.has_tag_name("text"))
                .unwrap();
            assert!(
                !text.has_attribute("text-anchor"),
                "{name}: {:?}",
                text.text()
            );
        }
    }
}
