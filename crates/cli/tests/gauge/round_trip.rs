//! An as-built pair, gauged, its tables fed back: the same lost motion.

use super::made_up::{made_up, scaled};
use super::printed;
use gearlash::analysis::simulate::simulate;
use gearlash::analysis::study::Study;
use gearlash::contact::Method;
use gearlash::error::go_on;
use gearlash_input as input;

fn um_list(values: &[f64]) -> String {
    let values: Vec<f64> = values.iter().map(|mm| mm * 1e3).collect();
    format!("{values:?}")
}

/// `[name]` with thickness by tooth of the mean `mean_um`, eccentricity and, where asked for, pitch of both flanks.
pub fn table(name: &str, teeth: u32, face: &str, seed: u64, mean_um: f64, pitch: bool) -> String {
    let list = |n, by| um_list(&scaled(&made_up(teeth, seed + n), by));
    let beside = scaled(&made_up(teeth, seed), 6e-3);
    let beside: Vec<f64> = beside.iter().map(|mm| mm + 1e-3 * mean_um).collect();
    let table = format!(
        "[{name}]\nteeth = {teeth}\nmodule_mm = 3.0\npressure_angle_deg = 20.0\nprofile_shift = 0.05\nreference_face = \"{face}\"\n\
         [{name}.thickness]\nallowance_um = -20.0\nper_tooth_um = {}\n\
         [{name}.runout]\ntotal_um = 31.7\nhigh_tooth = 7.3\n",
        um_list(&beside),
    );
    if !pitch {
        return table;
    }
    let [right, left] = [list(1, 11e-3), list(2, 9e-3)];
    format!("{table}[{name}.pitch]\nkind = \"cumulative\"\nright_um = {right}\nleft_um = {left}\n")
}

/// Wheel and pinion; a `helix` winds them.
fn gears(teeth: [u32; 2], seeds: [u64; 2], mean_um: f64, pitch: bool, helix: bool) -> [String; 2] {
    [
        ("wheel", "front", "left", 0),
        ("pinion", "back", "right", 1),
    ]
    .map(|(name, face, hand, k)| {
        let table = table(name, teeth[k], face, seeds[k], mean_um, pitch);
        let wound = format!(
            "module_mm = 3.0\nhelix_angle_deg = 17\nhand = \"{hand}\"\nface_mm = [-8, 21]\n"
        );
        if helix {
            table.replace("module_mm = 3.0\n", &wound)
        } else {
            table
        }
    })
}

/// Helical gears: pitch, runout and thickness of the measuring plane, spans along the normal of the helix; and their runout as readings of the virtual
/// ball in every space, beside pitch and thickness as they were read: the eccentricity comes out as it went in.
#[test]
fn helical_gears_that_were_gauged_simulate_alike() {
    for (seeds, mean_um, ball, most_um) in [
        ([1, 11], 0.0, None, 1e-6),
        ([1, 11], -30.0, None, 1e-6),
        ([3, 13], 0.0, Some(5.5), 1e-5),
    ] {
        let gears = gears([44, 21], seeds, mean_um, true, true);
        let found = round_trip(gears, [102.3, 102.5], ball);
        assert_eq!(found.before.len(), 2 * 16 * 44);
        found.assert_alike(most_um, &format!("{mean_um} {ball:?}"));
    }
}

/// Issue 5: the same within 1e-4 µm at every pose. Inside interference as well as outside. It is bounded by the gauge, not by luck: picometres.
#[test]
fn what_was_gauged_simulates_alike() {
    let gears = gears([44, 21], [1, 11], 0.0, true, false);
    let found = round_trip(gears, [97.9, 97.75], None);
    assert_eq!(found.before.len(), 2 * 16 * 44);
    let [overlap, gap] = [-1.0, 1.0].map(|sign| found.before.iter().any(|j_wt| sign * j_wt > 0.0));
    assert!(overlap && gap);
    found.assert_alike(1e-6, "spur");
}

/// Mean thickness sets pose, root and fillet, a mean of the thickness by tooth does not, and the flanks cannot tell them
/// apart: stated as one mean, −20 and −40 µm made tips on fillets differ by up to 17 µm at 160.2 mm. The root tells.
#[test]
fn thickness_by_tooth_with_a_mean_comes_back() {
    for (seed, mean_um) in [(1, -40.0), (2, -5.0), (3, 12.5)] {
        for pitch in [false, true] {
            for (teeth, a) in [([86, 21], 160.2), ([45, 20], 97.3)] {
                let gears = gears(teeth, [seed, seed + 10], mean_um, pitch, false);
                let found = round_trip(gears, [a, a + 0.4], None);
                let name = format!("{mean_um} {pitch} {a}");
                found.assert_alike(1e-6, &name);
                // The two statements of the thickness do not look like one said twice, nor the left flanks like turned ones.
                let about =
                    |message: &&String| message.contains("thickness") || message.contains("flanks");
                assert_eq!(found.warnings.iter().find(about), None, "{name}");
            }
        }
    }
}

/// A gear file of the gauge once caused a false warning: thickness by tooth alone moves the flanks against each other, and the
/// file states that as pitch. Gears with few teeth are included, and teeth with no mean beside the allowance.
#[test]
fn thickness_by_tooth_alone_is_no_reversed_left_flank() {
    for mean_um in [0.0, 2.4] {
        for (teeth, a) in [([21, 20], 61.9), ([44, 8], 78.5), ([9, 45], 81.5)] {
            let gears = gears(teeth, [4, 7], mean_um, false, false);
            let found = round_trip(gears, [a, a + 0.1], None);
            let name = format!("{mean_um} {a}");
            found.assert_alike(1e-6, &name);
            let accused = |message: &&String| message.contains("flanks vary opposite");
            assert_eq!(found.warnings.iter().find(accused), None, "{name}");
        }
    }
}

/// Lost motion before and after, mm, and what the reader of the gear files warned of.
struct RoundTrip {
    before: Vec<f64>,
    after: Vec<f64>,
    warnings: Vec<String>,
}

impl RoundTrip {
    fn assert_alike(&self, most_um: f64, name: &str) {
        assert_eq!(self.before.len(), self.after.len());
        let pairs = self.before.iter().zip(&self.after);
        let off_um = pairs.fold(0.0, |most: f64, (a, b)| most.max(1e3 * (a - b).abs()));
        assert!(off_um < most_um, "{name}: {off_um} µm");
    }
}

fn backlash(study: &Study) -> Vec<f64> {
    let runs = simulate(study, Method::Exact { certify: false }, &go_on).unwrap();
    let poses = runs.iter().flat_map(|run| &run.poses);
    poses.map(|pose| pose.simulated.backlash.unwrap()).collect()
}

/// The round trip of a pair at these distances; with the readings of a `ball`, mm, in place of the stated runout.
fn round_trip(gears: [String; 2], distances: [f64; 2], ball: Option<f64>) -> RoundTrip {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let assembly = format!(
        "[assembly]\ncenter_distance_mm = {distances:?}\n[sweep]\nrevolutions = \"wheel\"\nsteps_per_pitch = 16\n"
    );
    let file = folder.join("pair.toml");
    std::fs::write(&file, gears.concat() + &assembly).unwrap();
    let with = ball.map_or(String::new(), |ball| format!(" --ball-mm={ball:?}"));
    let words = format!("gauge pair.toml -o out --steps-per-pitch 1{with}");
    printed(folder, &words);
    let back = ["wheel", "pinion"].map(|name| {
        let text = std::fs::read_to_string(folder.join(format!("out/gauge_{name}.toml"))).unwrap();
        let from = text.find("[gear]").unwrap();
        let table = text[from..].replace("[gear", &format!("[{name}"));
        ball.map_or(table.clone(), |ball| by_readings(&table, name, ball))
    });
    // The pair file is beside the readings it names.
    let again = folder.join("out/again.toml");
    std::fs::write(&again, back.concat() + &assembly).unwrap();
    let (before, after) = (input::read(&file).unwrap(), input::read(&again).unwrap());
    RoundTrip {
        before: backlash(&before.study),
        after: backlash(&after.study),
        warnings: after.warnings,
    }
}

/// The gear's `table` with a file of readings in place of its runout.
fn by_readings(table: &str, name: &str, ball: f64) -> String {
    let stated = |line: &&str| line.starts_with("total_um") || line.starts_with("high_tooth");
    assert_eq!(table.lines().filter(stated).count(), 2, "{table}");
    let lines = table.lines().filter(|line| !stated(line));
    let rest: String = lines.map(|line| format!("{line}\n")).collect();
    let head = format!("[{name}.runout]\n");
    let readings = format!(
        "{head}file = \"gauge_{name}.csv\"\ncolumn = \"runout_um\"\nat = \"space\"\nball_mm = {ball:?}\n"
    );
    rest.replace(&head, &readings)
}
