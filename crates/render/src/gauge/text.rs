//! The gauges' readings as a short table per gear.

use gearlash::contact::{ContactKind, PoseClass, Touch};
use gearlash::gauge::{
    Eccentricity, FaceReadings, FlankTraces, Gauged, PitchReadings, TraceReading,
};
use gearlash::gear::{Flank, GRADE_SOURCE};
use gearlash_results::gauge::{self, GaugedGear, length_table, tooth_table};
use gearlash_results::text::Screen;
use gearlash_text::characters::plain;
use gearlash_text::numbers::{ascii, order_um, um_ascii};
use std::fmt::Write;

/// The text that `gauge` prints on `screen`; with `by_position` also every reading tooth by tooth.
pub fn text(title: &str, gears: &[GaugedGear], by_position: bool, screen: &Screen) -> String {
    let mut text = format!("{}\n", plain(title));
    let mut lengths_alone = true;
    for gauged in gears {
        let _ = write!(text, "\n{}\n\n", gauged.words());
        text += &length_table(gauged, screen);
        let deviations = deviations(&gauged.gauged, screen);
        lengths_alone &= deviations.is_empty();
        text += &deviations;
        text += &remarks(gauged);
        if by_position {
            text += POSITIONS;
            text += &tooth_table(gauged);
        }
    }
    if lengths_alone {
        return screen.fold(&(text + &screen.paragraphs(OF_LENGTHS)));
    }
    text += &screen.paragraphs(LEGEND);
    if gears.iter().any(GaugedGear::is_helical) {
        text += &screen.paragraphs(OF_HELICAL);
    }
    let graded = |gauged: &GaugedGear| {
        let grades = gauged.gauged.grades.as_ref();
        grades.is_ok_and(|grades| !grades.is_empty())
    };
    if gears.iter().any(graded) {
        text += OF_GRADES;
        let _ = writeln!(text, "Grades: {GRADE_SOURCE}.");
    }
    screen.fold(&text)
}

const LEGEND: &str = "
Lengths in mm; range, off and bound in µm. Formula: of the mean thickness, no deviations. Off: mean less formula.
Ball: its centre from the rotation axis, so its range is F_r. a'': tight mesh with the master, its range is F_i''.
F_r of an eccentricity e alone is 2 e, down to 2 e cos(π/z) where no space is in line with the high tooth; \
pitch and thickness of the teeth add to it.
Thickness is an arc of the reference circle. Pitch: own, about the gear's own centre; datum, about its rotation axis, \
which is what a standard grades.
--positions, --format csv and the CSV files have every reading tooth by tooth.";

const OF_LENGTHS: &str = "
Lengths in mm; range and bound in µm. The columns \"at\" name the first tooth spanned, or the tooth before the space of the (first) pin. \
The anvils reach down to a third of the depth above the root.";

const OF_HELICAL: &str = "
Helical gears: all is of the measuring plane, the centres of the balls too. Span: along the normal of the helix. M_dK: over balls; \
M_dR: over pins that lie along the spaces, opposite each other. Thickness: s_t on the arc of the transverse section, s_n = s_t cos β.";

const OF_GRADES: &str =
    "Grade: the finest that admits the value, with its tolerance; measured and tolerance in µm.\n";

/// Runout, pitch, roll and grades; empty if spans and pins alone are measured.
fn deviations(read: &Gauged, screen: &Screen) -> String {
    let mut text = String::new();
    if let Ok(runout) = &read.runout {
        let _ = writeln!(
            text,
            "F_r {} µm ({})",
            um_ascii(runout.total(), 3),
            read.eccentricity
                .as_ref()
                .map_or(String::new(), eccentricity),
        );
    }
    if let Ok(roll) = &read.roll {
        let [total, single] = [roll.total, roll.tooth_to_tooth].map(|range| {
            format!(
                "{} µm (+ {} at most)",
                um_ascii(range.found, 3),
                order_um(range.missed)
            )
        });
        let _ = writeln!(
            text,
            "F_i'' {total}, f_i'' {single}: {} poses a pitch and {} more round the extremes, each ± {} µm",
            roll.steps_per_pitch,
            roll.between.len(),
            order_um(roll.distances().error),
        );
    }
    for pitch in [&read.pitch_own, &read.pitch_datum].into_iter().flatten() {
        let _ = writeln!(text, "pitch, {}: {}", pitch.axis.name(), both(pitch));
    }
    if let Ok(profile) = &read.profile
        && profile.deviates()
    {
        for side in Flank::BOTH {
            let [from, to] = profile.evaluated_diameters[side.index()].map(|mm| ascii(mm, 3));
            let words = profile_words(profile.flank(side));
            let words = format!("{words} (d {from} to {to} mm)");
            let _ = writeln!(text, "profile, {} flanks: {words}", side.name());
        }
    }
    text += &read.along_face.as_ref().map_or(String::new(), along_face);
    if text.is_empty() {
        return text;
    }
    format!("\n{text}{}", grade_table(read, screen))
}

fn profile_words(flank: &FlankTraces) -> String {
    let slope = flank_words(flank, "f_Hα", |one| one.slope);
    let form = flank_words(flank, "f_fα", |one| one.form);
    let total = flank_words(flank, "F_α", |one| one.total);
    format!("{slope}, {form}, {total}")
}

/// A value of every tooth, or the mean and the worst.
fn flank_words(flank: &FlankTraces, symbol: &str, of: impl Fn(&TraceReading) -> f64) -> String {
    let mean = um_ascii(flank.mean(&of), 3);
    match flank.shapes.len() {
        1 => format!("{symbol} {mean} µm"),
        _ => {
            let (tooth, worst) = flank.worst(of);
            let worst = um_ascii(worst, 3);
            format!("{symbol} {mean} µm on average, {worst} at tooth {tooth}")
        }
    }
}

fn along_face(found: &FaceReadings) -> String {
    let mut text = String::new();
    for lead in found.leads() {
        for side in Flank::BOTH {
            let flank = lead.flank(side);
            let slope = flank_words(flank, "f_Hβ", |one| lead.helix_slope(side, one));
            let form = flank_words(flank, "f_fβ", |one| one.form);
            let total = flank_words(flank, "F_β", |one| one.total);
            let crown = flank_words(flank, "C_β over the face width", |one| lead.crowning(one));
            let hand = if lead.is_helical {
                ""
            } else {
                " (as right hand)"
            };
            let _ = writeln!(
                text,
                "lead, {}, {} flanks: {slope}{hand}, {form}, {total}, {crown}",
                lead.axis.name(),
                side.name()
            );
        }
    }
    for read in &found.sections {
        let (spans, runout) = (read.spans.as_ref(), read.runout.as_ref());
        let span = spans.map(|spans| format!(", W_k {} mm", ascii(spans.summary().mean, 6)));
        let runout = runout.map(|runout| format!(", F_r {} µm", um_ascii(runout.total(), 3)));
        let _ = writeln!(
            text,
            "{} mm from the reference face{}{} ({})",
            ascii(read.height, 3),
            span.unwrap_or_default(),
            runout.unwrap_or_default(),
            eccentricity(&read.eccentricity)
        );
    }
    let face = &found.face_runout;
    if face.amount > 0.0 {
        let _ = writeln!(
            text,
            "runout of the reference face on d {} mm: {} µm, high at tooth {}",
            ascii(face.diameter, 3),
            um_ascii(face.amount, 3),
            ascii(face.high_tooth, 2)
        );
    }
    text
}

fn eccentricity(found: &Eccentricity) -> String {
    if !(found.amount > 0.0) {
        return "no eccentricity".to_owned();
    }
    let towards = if found.any_direction {
        "; towards which tooth is not stated, read here with tooth 1 high".to_owned()
    } else {
        format!(" towards tooth {}", ascii(found.high_tooth, 2))
    };
    format!("2 e = {} µm{towards}", um_ascii(2.0 * found.amount, 3))
}

fn both(pitch: &PitchReadings) -> String {
    let side = |side: Flank| {
        format!(
            "{} flanks f_p {} µm, F_p {} µm",
            side.name(),
            um_ascii(pitch.cumulative.greatest_single(side), 3),
            um_ascii(pitch.cumulative.total(side), 3),
        )
    };
    format!("{}; {}", side(Flank::Right), side(Flank::Left))
}

/// Accuracy grades, or the reason for none.
fn grade_table(read: &Gauged, screen: &Screen) -> String {
    match &read.grades {
        Ok(graded) if graded.is_empty() => String::new(),
        Ok(graded) => format!("\n{}", gauge::grade_table(graded, screen)),
        Err(reason) => format!("\nno accuracy grades: {reason}\n"),
    }
}

/// Notes on readings that were not taken, and on contacts off the involute.
fn remarks(gauged: &GaugedGear) -> String {
    let read = &gauged.gauged;
    let mut text = String::new();
    for line in gauged.unmeasured() {
        let _ = writeln!(text, "{line}");
    }
    if let (Err(reason), Some(_)) = (&read.stated, gauged.basic_data()) {
        let _ = writeln!(text, "no gear file: {reason}");
    }
    let spans = read.spans.iter().flat_map(|spans| &spans.readings);
    let pins = read.pins.iter().flat_map(|pins| &pins.seats);
    let balls = read.runout.iter().flat_map(|runout| &runout.readings);
    text += &touched("spans", spans.map(|span| span.touched).collect());
    text += &touched("pins", pins.map(|seat| seat.touched).collect());
    text += &touched("balls", balls.map(|ball| ball.seat.touched).collect());
    if let Ok(roll) = &read.roll {
        let off = |class: PoseClass| class != PoseClass::Contact(ContactKind::Involute);
        let count = roll.poses.iter().filter(|pose| off(pose.class)).count();
        if count > 0 {
            let _ = writeln!(
                text,
                "at {count} of {} poses the roll test touches off the line of action",
                roll.poses.len()
            );
        }
    }
    text
}

fn touched(what: &str, touches: Vec<[Touch; 2]>) -> String {
    let mut text = String::new();
    for curve in ["tip", "fillet", "root"] {
        let on = |both: &&[Touch; 2]| both.iter().any(|touch| touch.curve.name() == curve);
        let count = touches.iter().filter(on).count();
        if count > 0 {
            let all = touches.len();
            let _ = writeln!(
                text,
                "{count} of {all} {what} touch the {curve}, not the flanks alone"
            );
        }
    }
    text
}

/// The head of the table of readings tooth by tooth.
const POSITIONS: &str = "
By tooth, in µm where not mm. Span: first tooth spanned; pins and ball: tooth before the space of the (first) pin.
f: single pitch, F: cumulative; ball and s less their means.
";
