//! The outline of a gear as a file for other programs: DXF, SVG or CSV, in mm, with its bound in the header.
//!
//! Numbers are the shortest text that reads back to the same f64. The same gear gives the same bytes: no date, no random id.

mod dxf;

use gearlash::analysis::study::Material;
use gearlash::gear::{AsBuilt, Face};
use gearlash::outline::{PathSegment, of_gear, of_section};
use gearlash_text::characters::{cut, plain};
use nalgebra::Point2;
use std::f64::consts::PI;
use svg::node::Text;
use svg::node::element::{Description, Path, SVG, Title};

/// A format of outlines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutlineFormat {
    /// One closed LWPOLYLINE, lands as bulges.
    Dxf,
    /// One closed path, lands as arcs; y downwards.
    Svg,
    /// `x_mm,y_mm` of a closed polygon.
    Csv,
}

/// Characters of a title in a header: a line of a DXF has up to 2049 bytes, and a character of it up to 14.
const LONGEST_TITLE: usize = 100;

/// An outline and its description in the file.
#[derive(Debug, Clone, Copy)]
pub struct OutlineFile<'a> {
    /// Title of the file that states the gear.
    pub title: &'a str,
    /// `wheel`, `pinion` or `gear`.
    pub name: &'a str,
    /// The thickness that is drawn.
    pub material: Material,
    /// The gear.
    pub gear: &'a AsBuilt,
    /// The transverse section that is drawn, mm from the measuring plane away from the viewer; 0 where all are equal.
    pub section_mm: f64,
    /// Bound on the distance of a chord from its curve, µm (> 0).
    pub tolerance_um: f64,
}

impl OutlineFile<'_> {
    /// The outline in `format`: see [`of_gear`] and [`of_section`] for its position.
    pub fn text(&self, format: OutlineFormat) -> String {
        let tolerance = self.tolerance_um * 1e-3;
        let outline = if self.gear.varies_along_face() {
            of_section(self.gear, self.section_mm, tolerance)
        } else {
            of_gear(self.gear, tolerance)
        };
        match format {
            OutlineFormat::Dxf => dxf::text(&outline, tolerance, &self.header(true)),
            OutlineFormat::Svg => self.svg(&outline),
            OutlineFormat::Csv => self.csv(outline.iter().flat_map(|part| part.chords(tolerance))),
        }
    }

    /// The description, one line each.
    fn header(&self, arcs: bool) -> Vec<String> {
        let built = self.gear;
        let lands = if arcs {
            "on flanks; tip and root lands are arcs"
        } else {
            "everywhere"
        };
        let mut lines = vec![
            format!("title: {}", cut(&plain(self.title), LONGEST_TITLE)),
            format!("gear: {}", self.name),
            format!("teeth: {}", built.gear().basic_data().teeth()),
            format!("material: {}", self.material.name()),
            format!(
                "tolerance: {} um (chord to curve, {lands})",
                self.tolerance_um
            ),
            "unit: mm".to_owned(),
            "origin: the rotation axis".to_owned(),
            format!(
                "view: on the reference face{}, tooth 1 up (+y), numbers clockwise",
                match built.face() {
                    Face::Front => "",
                    Face::Back => " (read it with reference_face = \"back\")",
                }
            ),
        ];
        let basic_data = built.gear().basic_data();
        if built.varies_along_face() {
            let helix = basic_data.hand().map_or(String::new(), |hand| {
                format!(
                    ", in which tooth 1 is up (helix {} deg, {} hand)",
                    number((basic_data.helix_angle().to_degrees() * 1e9).round() / 1e9),
                    hand.name()
                )
            });
            lines.push(format!(
                "section: transverse, {} mm from the measuring plane{helix}",
                number(self.section_mm)
            ));
        }
        if built.any_direction() && built.eccentricity() > 0.0 {
            lines.push("runout: direction not stated, tooth 1 drawn high".to_owned());
        }
        lines.push(format!("program: gearlash {}", env!("CARGO_PKG_VERSION")));
        lines
    }

    fn svg(&self, outline: &[PathSegment]) -> String {
        // y points down. Counter-clockwise stays counter-clockwise on the sheet, the negative sense of SVG.
        let spot = |point: Point2<f64>| format!("{} {}", number(point.x), number(-point.y));
        let mut data = format!("M{}", spot(outline[0].start()));
        for (part, next) in outline.iter().zip(outline.iter().cycle().skip(1)) {
            data += &match *part {
                PathSegment::Arc { radius, sweep, .. } => {
                    let radius = number(radius);
                    let flags = [sweep.abs() > PI, sweep < 0.0].map(u8::from);
                    format!(" A{radius} {radius} 0 {} {} ", flags[0], flags[1])
                }
                PathSegment::Line(_) => " L".to_owned(),
                PathSegment::Cubic([_, b, c, _]) => format!(" C{} {} ", spot(b), spot(c)),
            };
            data += &spot(next.start());
        }
        // A margin for the line around the gear, to whole µm.
        let reach = (1020.0 * self.gear.reach()).ceil() / 1e3;
        let [corner, size] = [-reach, 2.0 * reach].map(number);
        let svg = SVG::new()
            .set("width", format!("{size}mm"))
            .set("height", format!("{size}mm"))
            .set("viewBox", format!("{corner} {corner} {size} {size}"))
            .add(Title::new(cut(&plain(self.title), LONGEST_TITLE)))
            .add(Description::new().add(Text::new(self.header(true).join("\n"))));
        let path = Path::new()
            .set("id", self.name)
            .set("d", data + " Z")
            .set("fill", "none")
            .set("stroke", "black")
            .set("stroke-width", number(reach / 500.0));
        format!("{}\n", svg.add(path))
    }

    fn csv(&self, points: impl Iterator<Item = Point2<f64>>) -> String {
        let mut text = String::new();
        for line in self.header(false) {
            text += &format!("# {line}\n");
        }
        text += "x_mm,y_mm\n";
        for point in points {
            text += &format!("{},{}\n", number(point.x), number(point.y));
        }
        text
    }
}

/// The shortest text that reads back to `value`; never −0.
fn number(value: f64) -> String {
    (value + 0.0).to_string()
}
