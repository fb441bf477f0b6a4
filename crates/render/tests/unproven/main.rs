//! An unproven pose is a row of its own, and affects no other.
//!
//! No pair file is known to make one. So the polygons are cut from other gears than the pair's: their tips are lower. Where the
//! pair touches near a tip, the certificate must refuse the exact result, and the two methods must differ; elsewhere nothing may
//! change. The exact method on the pair of the polygons determines these poses, and the polygons' results there.

mod checks;
mod outputs;
mod poses;

use gearlash::analysis::compare::{ComparedRun, compare};
use gearlash::analysis::simulate::Run;
use gearlash::analysis::study::{RunPlan, Study};
use gearlash::contact::{CutPair, Method, PoseResult, Unproven, sweep};
use gearlash::pair::{GearPair, Member};
use gearlash_files::{self as input, PairFile};
use std::ops::ControlFlow;

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

fn read(text: &str) -> PairFile {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("pair.toml");
    std::fs::write(&file, text).unwrap();
    input::read(&file).unwrap()
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
        let other = other.runs().unwrap().remove(0).assembly;
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

    /// A revolution whose poses near a tip of tooth 5 are not proven.
    fn low_tips() -> Case {
        Case::of(REVOLUTION)
    }

    /// The same pair; `rest` follows its centre distance.
    fn of(rest: &str) -> Case {
        Case::new(&text(5, 0.0, rest), &text(5, 0.2, rest))
    }

    fn swept(&self, method: Method) -> Vec<PoseResult> {
        swept(self.plan.assembly.data().unwrap(), &self.cut, method, self)
    }

    /// The results of the exact method on the pair itself, and on that of the polygons, without certificates.
    fn exact(&self) -> [Vec<PoseResult>; 2] {
        let method = Method::Exact { certify: false };
        [self.plan.assembly.data().unwrap(), &self.other]
            .map(|pair| swept(pair, &self.cut, method, self))
    }

    fn compared(&self, method: Method) -> Vec<ComparedRun> {
        let run = Run {
            material: self.plan.material,
            assembly: self.plan.assembly.clone(),
            phase: None,
            poses: self.swept(method),
        };
        compare(vec![run], self.study.tolerance_um)
    }
}

fn swept(pair: &GearPair, cut: &CutPair, method: Method, case: &Case) -> Vec<PoseResult> {
    let clearance = case.study.bearing_clearance;
    sweep(pair, cut, method, &case.plan.matings, clearance, &|| {
        ControlFlow::Continue(())
    })
    .unwrap()
}

const CERTIFIED: Method = Method::Checked;

fn unproven(pose: &PoseResult) -> Option<&Unproven> {
    pose.found.as_ref().err()
}
