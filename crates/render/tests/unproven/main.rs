//! An unproven pose is a row of its own, and affects no other.
//!
//! No pair file is known to make one. So the polygons are cut from other gears than the pair's: their tips are lower. Where the
//! pair touches near a tip, the certificate must refuse the exact result, and the two methods must differ; elsewhere nothing may
//! change. The exact method on the pair of the polygons determines these poses, and the polygons' results there.

mod outputs;
mod poses;

use gearlash::analysis::compare::{ComparedRun, compared};
use gearlash::analysis::study::{RunPlan, Study};
use gearlash::contact::{CutPair, Method, PoseResult, Unproven, sweep};
use gearlash::error::go_on as on;
use gearlash::pair::{GearPair, Member};
use gearlash_input::{PairFile, read_text};
use std::path::Path;
use std::sync::LazyLock;

/// 160 poses.
const REVOLUTION: &str = "[sweep]\nrevolutions = \"wheel\"\nsteps_per_pitch = 8\n";

/// 20 and 21 teeth, module 2, the wheel 30 µm eccentric, wheel tooth 5 so much thicker, µm: it is in contact from
/// tip to tip, and has the least backlash near one. All tips are so much lower, mm.
fn text(thicker: u32, lower: f64, rest: &str) -> String {
    let um = (1..=20).map(|tooth| if tooth == 5 { thicker } else { 0 });
    let per_tooth = um.map(|um| um.to_string()).collect::<Vec<_>>().join(", ");
    let [wheel, pinion] = [44.0, 46.0].map(|tip| tip - 2.0 * lower);
    format!(
        "title = \"Low tips on polygons\"\n\
         [wheel]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\n\
         tip_diameter_mm = {wheel}\nthickness = {{ allowance_um = -40, per_tooth_um = [{per_tooth}] }}\n\
         runout = {{ total_um = 60, high_tooth = 4 }}\n\
         [pinion]\nteeth = 21\nmodule_mm = 2.0\npressure_angle_deg = 20.0\nreference_face = \"back\"\n\
         tip_diameter_mm = {pinion}\n\
         [assembly]\ncenter_distance_mm = 41.1\n{rest}"
    )
}

/// 20 and 20 teeth whose tips are so wide, mm, that they hardly reach each other: 43.5 mm of 44 mm at which those of 44 mm pass.
fn far(tip: f64, rest: &str) -> String {
    let gear = format!(
        "teeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\ntip_diameter_mm = {tip}\n"
    );
    format!("[wheel]\n{gear}[pinion]\n{gear}[assembly]\ncenter_distance_mm = 43.5\n{rest}")
}

fn read(text: &str) -> PairFile {
    read_text(Path::new("pair.toml"), text).unwrap()
}

/// A study, its one plan, and the polygons of another pair.
struct Case {
    /// As read.
    pair: PairFile,
    study: Study,
    plan: RunPlan,
    /// The pair that the polygons are of.
    other: GearPair,
    cut: CutPair,
}

impl Case {
    /// The case of two pair files that differ only in their gears: the pair's, and that of its polygons.
    fn new(pair: &str, polygons: &str) -> Case {
        let (pair, other) = (read(pair), read(polygons).study);
        let study = pair.study.clone();
        let plan = study.runs().unwrap().remove(0);
        let other = other.runs().unwrap().remove(0).run.assembly;
        let other = other.data().unwrap().clone();
        let cut = CutPair::for_certificates(other.gear(Member::Wheel), other.gear(Member::Pinion));
        Case {
            pair,
            study,
            plan,
            other,
            cut,
        }
    }

    /// The pair with low tips on its polygons; `rest` follows its centre distance.
    fn low_tips(rest: &str) -> Case {
        Case::new(&text(5, 0.0, rest), &text(5, 0.2, rest))
    }

    /// A pair whose polygons have nothing to touch.
    fn far(rest: &str) -> Case {
        Case::new(&far(44.0, rest), &far(43.0, rest))
    }

    fn swept(&self, method: Method) -> Vec<PoseResult> {
        self.swept_as(self.plan.run.assembly.data().unwrap(), method)
    }

    fn swept_as(&self, pair: &GearPair, method: Method) -> Vec<PoseResult> {
        let clearance = self.study.bearing_clearance;
        sweep(pair, &self.cut, method, &self.plan.matings, clearance, &on).unwrap()
    }

    /// The poses by a method, each with the exact results there, without certificates: of the pair itself, and of that of the polygons.
    fn beside_exact(&self, method: Method) -> impl Iterator<Item = [PoseResult; 3]> {
        let [own, other] = [self.plan.run.assembly.data().unwrap(), &self.other]
            .map(|pair| self.swept_as(pair, BELIEVED));
        let poses = self.swept(method).into_iter().zip(own).zip(other);
        poses.map(|((pose, own), other)| [pose, own, other])
    }

    fn compared(&self, method: Method) -> Vec<ComparedRun> {
        let run = self.plan.run.clone();
        let tolerance = self.study.tolerance_um;
        let poses = self.swept(method).into_iter();
        let poses = poses
            .map(|pose| compared(&run.assembly, pose, tolerance))
            .collect();
        vec![ComparedRun { run, poses }]
    }
}

/// A revolution whose poses near a tip of tooth 5 are not proven.
static LOW_TIPS: LazyLock<Case> = LazyLock::new(|| Case::low_tips(REVOLUTION));

const CERTIFIED: Method = Method::Checked;
const BELIEVED: Method = Method::Exact { certify: false };

fn unproven(pose: &PoseResult) -> Option<&Unproven> {
    pose.found.as_ref().err()
}
