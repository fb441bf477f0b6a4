//! SVG: shapes of the page with their transforms, read with `roxmltree` and the numbers and path data of `svgtypes` in f64.
//!
//! The outline is the path itself, not the edge of its stroke. Style sheets are not applied. No entity and no other file is read.
//! Lines, curves and circles stay exact.

mod path;
mod shape;

use super::affine::Affine;
use super::chain::DrawnPath;
use super::curve::elliptic;
use super::error::LONGEST_NAME;
use super::limits::MAX_SEGMENTS;
use super::pieces::Pieces;
use super::text::{Lines, decode};
use super::{DrawingError, Options};
use gearlash_text::characters::cut;
use gearlash_text::xml;
use roxmltree::Node;
use shape::Data;
use std::collections::HashMap;
use std::f64::consts::TAU;
use std::fmt::Display;
use std::str::FromStr;
use svgtypes::{Align, AspectRatio, Length, ViewBox};

const XLINK: &str = "http://www.w3.org/1999/xlink";
const NAMESPACE: &str = "http://www.w3.org/2000/svg";
/// Groups in groups: drawing programs nest a dozen.
const DEEPEST: usize = 200;
const PLAIN: &str = "save it as plain SVG with absolute paths";

const NOT_DRAWN: [&str; 19] = [
    "clipPath",
    "cursor",
    "defs",
    "desc",
    "filter",
    "font",
    "linearGradient",
    "marker",
    "mask",
    "metadata",
    "pattern",
    "radialGradient",
    "script",
    "style",
    "symbol",
    "title",
    "view",
    "animate",
    "set",
];
/// Elements that belong to no outline; they are ignored with a remark.
const IGNORED: [&str; 3] = ["text", "image", "foreignObject"];
/// Attributes that move or cut the shapes of an element and are not supported.
const UNSUPPORTED: [&str; 3] = ["clip-path", "mask", "transform-origin"];

/// Adds what the file draws to `pieces`.
pub fn read(bytes: &[u8], options: &Options, pieces: &mut Pieces) -> Result<(), DrawingError> {
    let text = decode(bytes)?;
    let document = xml::parse(&text).map_err(|fault| {
        let help = if fault.has_dtd {
            "delete the line <!DOCTYPE …>, or save it as plain SVG"
        } else {
            "export it again as SVG"
        };
        DrawingError::at(format!("line {}", fault.line), fault.reason, help)
    })?;
    let root = document.root_element();
    let with_id = root
        .descendants()
        .filter_map(|node| Some((node.attribute("id")?, node)));
    let mut page = Page {
        lines: Lines::of(&text),
        with_id: with_id.collect(),
        visited: 0,
        select: options.select.as_deref(),
        found: false,
        ids: Vec::new(),
        pieces,
    };
    if root.tag_name().name() != "svg" {
        return Err(page.syntax(root, "not an SVG: the root element is not svg"));
    }
    page.check_supported(root)?;
    if root.has_attribute("transform") {
        let place = page.place(root);
        return Err(DrawingError::refused(
            place,
            "a transform of the page",
            PLAIN,
        ));
    }
    let scale = page.scale(root, options)?;
    page.pieces.unit_mm = scale;
    let within = Within {
        map: Affine::upright(scale),
        selected: page.select.is_none(),
        shown: true,
        depth: 0,
    };
    page.children(root, within)?;
    match page.select {
        Some(name) if !page.found => Err(DrawingError::not_there("id", name, &page.ids)),
        _ => Ok(()),
    }
}

#[derive(Clone, Copy)]
struct Within {
    /// From user space to mm.
    map: Affine,
    /// Whether it is inside the selected element.
    selected: bool,
    shown: bool,
    depth: usize,
}

struct Page<'a> {
    lines: Lines,
    with_id: HashMap<&'a str, Node<'a, 'a>>,
    /// How many elements were visited, those that `use` repeats included.
    visited: usize,
    select: Option<&'a str>,
    found: bool,
    ids: Vec<String>,
    pieces: &'a mut Pieces,
}

impl Page<'_> {
    /// "line 12: path "teeth""
    fn place(&self, node: Node) -> String {
        let name = cut(node.tag_name().name(), LONGEST_NAME);
        let id = node.attribute("id");
        let id = id.map_or(String::new(), |id| {
            format!(" \"{}\"", cut(id, LONGEST_NAME))
        });
        format!("{}: {name}{id}", self.lines.place(node.range().start))
    }

    fn syntax(&self, node: Node, reason: impl Display) -> DrawingError {
        DrawingError::at(self.place(node), reason, PLAIN)
    }

    /// An attribute as `T`; `None` where it is not there.
    fn parsed<T: FromStr<Err: Display>>(
        &self,
        node: Node,
        name: &str,
    ) -> Result<Option<T>, DrawingError> {
        let Some(text) = node.attribute(name) else {
            return Ok(None);
        };
        let value = text.trim().parse();
        value.map(Some).map_err(|error: T::Err| {
            let text = cut(text, LONGEST_NAME);
            self.syntax(node, format!("{name} = \"{text}\": {error}"))
        })
    }

    fn number(&self, node: Node, name: &str) -> Result<Option<f64>, DrawingError> {
        shape::number(node, name).map_err(|reason| self.syntax(node, reason))
    }

    /// Length of a unit of the page, mm.
    fn scale(&self, root: Node, options: &Options) -> Result<f64, DrawingError> {
        let view = self.parsed::<ViewBox>(root, "viewBox")?;
        let size = ["width", "height"].map(|name| self.parsed::<Length>(root, name));
        let [width, height] = size;
        let stated = shape::page_unit([width?, height?], view, self.aspect(root)?)
            .map_err(|reason| self.syntax(root, reason))?;
        let why = "the SVG needs width and height in mm, cm or in, and a viewBox";
        options.unit_mm(stated, why)
    }

    fn aspect(&self, node: Node) -> Result<AspectRatio, DrawingError> {
        let usual = AspectRatio {
            defer: false,
            align: Align::XMidYMid,
            slice: false,
        };
        Ok(self.parsed(node, "preserveAspectRatio")?.unwrap_or(usual))
    }

    fn children(&mut self, node: Node, within: Within) -> Result<(), DrawingError> {
        if within.depth > DEEPEST {
            let reason = format!("groups nested deeper than {DEEPEST}");
            return Err(self.syntax(node, reason));
        }
        for child in node.children().filter(Node::is_element) {
            let name = child.tag_name();
            if name.namespace().is_none_or(|space| space == NAMESPACE) {
                self.element(child, name.name(), within)?;
            }
        }
        Ok(())
    }

    fn element(&mut self, node: Node, name: &str, mut within: Within) -> Result<(), DrawingError> {
        if NOT_DRAWN.contains(&name) || property(node, "display") == Some("none") {
            return Ok(());
        }
        let id = node.attribute("id");
        if let Some(id) = id {
            if self.ids.len() < MAX_SEGMENTS {
                self.ids.push(id.to_owned());
            }
            if self.select == Some(id) {
                (within.selected, self.found) = (true, true);
            }
        }
        match property(node, "visibility") {
            Some("hidden" | "collapse") => within.shown = false,
            Some("visible") => within.shown = true,
            _ => {}
        }
        self.visited += 1;
        if self.visited > MAX_SEGMENTS {
            return Err(DrawingError::too_large("elements", MAX_SEGMENTS));
        }
        let group = matches!(name, "g" | "a" | "svg" | "use");
        if within.selected || group {
            self.follow(node, &mut within)?;
        }
        if group {
            within.depth += 1;
        }
        if name == "use" {
            return self.repeated(node, within);
        }
        if group {
            return self.children(node, within);
        }
        if !within.selected {
            return Ok(());
        }
        let place = self.place(node);
        if !within.shown {
            self.pieces.leave_out("hidden element", &place);
            return Ok(());
        }
        if IGNORED.contains(&name) {
            self.pieces.leave_out(name, &place);
            return Ok(());
        }
        let Some(data) = shape::data(node, name) else {
            let kind = format!("the element {}", cut(name, LONGEST_NAME));
            let help = "convert it to a path, delete it, or name the `id` of the outline alone";
            return Err(DrawingError::refused(place, kind, help));
        };
        let paths = data.and_then(|data| match data {
            Data::Path(data) => path::read(&data, &within.map),
            Data::Round(centre, [rx, ry]) => {
                let axes = [[rx, 0.0], [0.0, ry]].map(|axis| within.map.vector(axis.into()));
                let centre = within.map.point(centre.into());
                Ok(vec![elliptic(centre, axes, 0.0, TAU)])
            }
        });
        for path in paths.map_err(|reason| self.syntax(node, reason))? {
            let piece = DrawnPath {
                segments: path.segments,
                name: id.unwrap_or_default().to_owned(),
                bound_mm: path.bound,
                place: place.clone(),
            };
            self.pieces.add("", piece)?;
        }
        Ok(())
    }

    /// Draws the element that a `use` names, moved by its x and y.
    fn repeated(&mut self, node: Node, mut within: Within) -> Result<(), DrawingError> {
        let link = node.attribute("href").or(node.attribute((XLINK, "href")));
        let target = link
            .and_then(|link| link.trim().strip_prefix('#'))
            .and_then(|id| self.with_id.get(id).copied());
        let Some(target) = target else {
            let link = cut(link.unwrap_or_default(), LONGEST_NAME);
            return Err(self.syntax(node, format!("href = \"{link}\": no element of this file")));
        };
        if within.depth > DEEPEST {
            return Err(self.syntax(node, format!("groups nested deeper than {DEEPEST}")));
        }
        let [x, y] = ["x", "y"].map(|name| self.number(node, name));
        let moved = Affine::shift(x?.unwrap_or_default(), y?.unwrap_or_default());
        within.map = within.map.after(&moved);
        match target.tag_name().name() {
            "symbol" if target.has_attribute("viewBox") => Err(DrawingError::refused(
                self.place(node),
                "a symbol with a viewBox",
                "unlink the clone in the drawing program",
            )),
            "symbol" => self.children(target, within),
            name => self.element(target, name, within),
        }
    }

    /// Rejects attributes that move or cut shapes in another way than a `transform`.
    fn check_supported(&self, node: Node) -> Result<(), DrawingError> {
        let is_set = |name: &&str| property(node, name).is_some_and(|value| value != "none");
        let unsupported = UNSUPPORTED.into_iter().find(is_set);
        let style = node.attribute("style");
        let style = style.and_then(|style| declared(style, "transform"));
        if let Some(name) = unsupported.or(style.map(|_| "transform in a style")) {
            let help = "apply it in the drawing program, or name the `id` of the outline alone";
            return Err(DrawingError::refused(self.place(node), name, help));
        }
        Ok(())
    }

    /// Enters the user space of an element.
    fn follow(&self, node: Node, within: &mut Within) -> Result<(), DrawingError> {
        self.check_supported(node)?;
        if let Some(transform) = self.parsed::<svgtypes::Transform>(node, "transform")? {
            within.map = within.map.after(&Affine::of(&transform));
        }
        if node.tag_name().name() != "svg" {
            return Ok(());
        }
        let number = |name| self.number(node, name);
        let corner = [number("x")?.unwrap_or(0.0), number("y")?.unwrap_or(0.0)];
        let Some(view) = self.parsed::<ViewBox>(node, "viewBox")? else {
            within.map = within.map.after(&Affine::shift(corner[0], corner[1]));
            return Ok(());
        };
        let (Some(width), Some(height)) = (number("width")?, number("height")?) else {
            return Err(self.syntax(node, "a viewBox without width and height"));
        };
        let inner = shape::viewport(corner, [width, height], view, self.aspect(node)?);
        within.map = within.map.after(&inner);
        Ok(())
    }
}

/// A property of an element, in its style or as an attribute.
fn property<'a>(node: Node<'a, '_>, name: &str) -> Option<&'a str> {
    let style = node.attribute("style");
    let style = style.and_then(|style| declared(style, name));
    style.or(node.attribute(name)).map(str::trim)
}

/// The value that a style declares for a property.
fn declared<'a>(style: &'a str, name: &str) -> Option<&'a str> {
    let declarations = style.split(';').filter_map(|one| one.split_once(':'));
    let mut values = declarations.filter(|(property, _)| property.trim() == name);
    values.next_back().map(|(_, value)| value)
}
