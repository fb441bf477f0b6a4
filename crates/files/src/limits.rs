//! How large each number of a pair file may be: what the reader allows, and what the schema says.

use super::entry::Limits;
use std::ops::Bound::{Excluded, Included, Unbounded};
use std::ops::RangeInclusive;

/// A length.
const fn length(help: &'static str) -> Limits {
    Limits {
        allowed: "a number of mm above 0 and up to 1e9",
        range: (Excluded(0.0), Included(1e9)),
        help,
    }
}

/// A deviation of a length.
const fn deviation(help: &'static str) -> Limits {
    Limits {
        allowed: "a number of µm, −1e7 … 1e7",
        range: (Included(-1e7), Included(1e7)),
        help,
    }
}

/// A helix angle.
pub const HELIX_ANGLE: Limits = Limits {
    allowed: "a number of degrees, 0 … 60",
    range: (Included(0.0), Included(60.0)),
    help: "give the helix angle at the reference circle, in degrees: 0 is a spur gear; hand says which way it winds",
};
/// A face width.
pub const FACE_WIDTH: Limits = length("give the length of the teeth along the axis, in mm");
/// A place along the axis.
pub const FACE_PLACE: Limits = Limits {
    allowed: "a number of mm, −1e6 … 1e6",
    range: (Included(-1e6), Included(1e6)),
    help: "give both ends of the teeth, mm along the axis from the measuring plane",
};
/// How far two measuring planes lie apart.
pub const FACE_OFFSET: Limits = Limits {
    allowed: "a number of mm, −1e6 … 1e6",
    range: (Included(-1e6), Included(1e6)),
    help: "give how far the pinion's measuring plane lies beyond the wheel's, mm along the axis away from the viewer",
};
/// A temperature.
pub const TEMPERATURE: Limits = Limits {
    allowed: "a number of °C, −200 … 400",
    range: (Included(-200.0), Included(400.0)),
    help: "give the temperature of gears and housing in °C; lengths are stated at 20 °C",
};
/// A coefficient of thermal expansion.
pub const EXPANSION: Limits = Limits {
    allowed: "a number of 1/K, 0 … 0.0003",
    range: (Included(0.0), Included(3e-4)),
    help: "give the coefficient of thermal expansion in 1/K: of steel some 11.5e-6, of aluminium 23e-6, of POM 110e-6",
};
/// What flanks stand out.
pub const FLANK_OFFSET: Limits = Limits {
    allowed: "a number of mm, −100 … 100",
    range: (Included(-100.0), Included(100.0)),
    help: "give what each flank stands out along its normal, in mm; negative: in",
};
/// A backlash that is required.
pub const REQUIRED_UM: Limits = Limits {
    allowed: "a number of µm, −1e6 … 1e6",
    range: (Included(-1e6), Included(1e6)),
    help: "give the limit in µm",
};
/// A length that scatters.
pub const SCATTER: Limits = deviation("give it in µm");
/// How far a length scatters.
pub const SPREAD: Limits = Limits {
    allowed: "a number of µm above 0 and up to 1e7",
    range: (Excluded(0.0), Included(1e7)),
    help: "give the standard deviation, or the scale, in µm",
};
/// `C_pk`.
pub const CAPABILITY: Limits = Limits {
    allowed: "a number above 0 and up to 100",
    range: (Excluded(0.0), Included(100.0)),
    help: "give the process capability: 1.33 is usual, 1 has limits of three standard deviations",
};
/// Of two thicknesses.
pub const CORRELATION: Limits = Limits {
    allowed: "a number, −1 … 1",
    range: (Included(-1.0), Included(1.0)),
    help: "give the correlation: 0 for none, 1 for gears of one batch",
};
/// A share of a million.
pub const PPM: Limits = Limits {
    allowed: "a number, 0 … 1e6",
    range: (Included(0.0), Included(1e6)),
    help: "give how many of a million assemblies may miss the requirement",
};
/// A share.
pub const SHARE: Limits = Limits {
    allowed: "a number, 0 … 1",
    range: (Included(0.0), Included(1.0)),
    help: "give the share of draws that may be of no gear: 0.001 is one of a thousand",
};
/// Assemblies drawn.
pub const ASSEMBLIES: RangeInclusive<u32> = 1..=1_000_000_000;
/// Of a population.
pub const SEED: RangeInclusive<u32> = 0..=u32::MAX;
/// Of the samples that contributions come from.
pub const CONTRIBUTION_ROWS: RangeInclusive<u32> = 0..=10_000_000;
/// A lost motion that is required.
pub const REQUIRED_ARCMIN: Limits = Limits {
    allowed: "a number of minutes of arc, −10800 … 10800",
    range: (Included(-10_800.0), Included(10_800.0)),
    help: "give the limit in minutes of arc; a degree has 60",
};
/// A clearance that is required.
pub const REQUIRED_MM: Limits = Limits {
    allowed: "a number of mm, −1000 … 1000",
    range: (Included(-1000.0), Included(1000.0)),
    help: "give the limit in mm",
};
/// A standard uncertainty.
pub const UNCERTAINTY: Limits = Limits {
    allowed: "a number of µm, 0 … 1e6",
    range: (Included(0.0), Included(1e6)),
    help: "give the standard uncertainty in µm: half of the expanded one with k = 2",
};
/// A coverage factor.
pub const COVERAGE: Limits = Limits {
    allowed: "a number above 0 and up to 10",
    range: (Excluded(0.0), Included(10.0)),
    help: "give the coverage factor k; 2 is usual, for about 95 %",
};
/// `z`.
pub const TEETH: RangeInclusive<u32> = 3..=10_000;
/// A tooth of the largest gear.
pub const TOOTH: RangeInclusive<u32> = 1..=10_000;
/// A coordinate in a drawing.
pub const COORDINATE: Limits = Limits {
    allowed: "a number of mm, −1e6 … 1e6",
    range: (Included(-1e6), Included(1e6)),
    help: "give the coordinate in mm",
};
/// What ends of lines may be apart.
pub const JOIN: Limits = Limits {
    allowed: "a number of mm, 0 … 10",
    range: (Included(0.0), Included(10.0)),
    help: "give the greatest gap that is closed, in mm",
};
/// A direction in a drawing.
pub const FIRST_TOOTH: Limits = Limits {
    allowed: "a number of degrees, −360 … 360",
    range: (Included(-360.0), Included(360.0)),
    help: "give the direction of tooth 1, counter-clockwise from +x",
};
/// `m`.
pub const MODULE: Limits = Limits {
    allowed: "a number of mm, 0.01 … 1000",
    range: (Included(0.01), Included(1000.0)),
    help: "give the module in mm",
};
/// `α`.
pub const PRESSURE_ANGLE: Limits = Limits {
    allowed: "a number of degrees, 5 … 45",
    range: (Included(5.0), Included(45.0)),
    help: "give the pressure angle in degrees",
};
/// `x`.
pub const PROFILE_SHIFT: Limits = Limits {
    allowed: "a number of modules, −100 … 100",
    range: (Included(-100.0), Included(100.0)),
    help: "give the profile shift coefficient x, 0 for none",
};
/// `d_a`.
pub const TIP_DIAMETER: Limits = length(
    "give the tip diameter, or leave it out to have it follow from addendum and profile shift",
);

/// Addendum and dedendum of the basic rack.
pub const RACK_DEPTH: Limits = Limits {
    allowed: "a number of modules above 0 and up to 10",
    range: (Excluded(0.0), Included(10.0)),
    help: "give it in modules; ISO 53 A has addendum 1.0 and dedendum 1.25",
};
/// Its root radius; what the dedendum leaves room for is the geometry's to say.
pub const ROOT_RADIUS: Limits = Limits {
    allowed: "a number of modules, 0 up to the dedendum",
    range: (Included(0.0), Unbounded),
    help: "give the tool's tip round in modules; ISO 53 A has 0.38",
};

/// A measured length, as of a span or over pins.
pub const LENGTH: Limits = length("give the measured length in mm");
/// `A_s`.
pub const ALLOWANCE: Limits =
    deviation("give the deviation from the nominal thickness, negative when thinner");
/// Thickness of a tooth beyond the mean.
pub const PER_TOOTH: Limits =
    deviation("give what each tooth is thicker than the mean, negative when thinner");
/// Of `[thickness.cross_check]`.
pub const CROSS_CHECK: Limits = Limits {
    allowed: "a number of µm, 0 or more",
    range: (Included(0.0), Unbounded),
    help: "give how far the two may lie apart as base thickness",
};

/// `F_r`; the tooth depth is checked once it is known.
pub const RUNOUT: Limits = Limits {
    allowed: "a number of µm, 0 or more, less than the tooth depth",
    range: (Included(0.0), Unbounded),
    help: "give the radial runout F_r, twice the eccentricity",
};
/// Its direction; the number of teeth is checked beside it.
pub const HIGH_TOOTH: Limits = Limits {
    allowed: "a tooth number, 1 or more, fractions allowed",
    range: (Included(1.0), Unbounded),
    help: "give the number of the tooth at the highest reading",
};
/// The ball of runout readings.
pub const BALL: Limits = length("give the diameter of the ball that was read with");
/// A pitch deviation.
pub const PITCH: Limits =
    deviation("give a deviation for every tooth, measured at the reference circle");
/// A profile deviation.
pub const PROFILE: Limits = deviation("give the deviation in µm, positive for more material");
/// What a relief takes off.
pub const RELIEF: Limits = Limits {
    allowed: "a number of µm, 0 … 1e7",
    range: (Included(0.0), Included(1e7)),
    help: "give what is taken off at the end of the flank, in µm",
};
/// Where on a flank something is.
pub const FLANK_DIAMETER: Limits = length("give a diameter on the flank in mm");
/// The same by the roll.
pub const ROLL_LENGTH: Limits = Limits {
    allowed: "a number of mm, 0 … 1e9",
    range: (Included(0.0), Included(1e9)),
    help: "give roll lengths from the base circle on, in mm",
};

/// `a`. Twenty times the largest pair there can be; beyond, squares of lengths would lose the gears.
pub const CENTER_DISTANCE: Limits = length("give the distance between the two axes in mm");
/// What a centre distance may lie above or below the nominal one.
pub const CENTER_DISTANCE_DEVIATION: Limits =
    deviation("give the deviation from the nominal centre distance, negative when less");
/// The same on both sides.
pub const CENTER_DISTANCE_TOLERANCE: Limits = Limits {
    allowed: "a number of µm, 0 … 1e7",
    range: (Included(0.0), Included(1e7)),
    help: "give the tolerance on either side, 50 for ± 50 µm; or upper_um and lower_um",
};
/// How many of them: each is a run that holds both gears.
pub const MOST_DISTANCES: usize = 10_000;
/// Radial play of a bearing.
pub const CLEARANCE: Limits = Limits {
    allowed: "a number of mm, 0 or more",
    range: (Included(0.0), Unbounded),
    help: "give the radial play of the gear on its axis, 0 for none",
};

/// Poses of a study, over all centre distances and materials: their result fills 27 GB.
pub const MOST_POSES: u64 = 10_000_000;

/// Bytes that a pose takes in a result as JSON, about: 900 where a pair is jammed to 2250 with tip corners.
pub const POSE_BYTES_JSON: u64 = 2250;

/// The same as CSV.
pub const POSE_BYTES_CSV: u64 = 450;

/// Of a pose beyond its mating.
pub const FRACTION: Limits = Limits {
    allowed: "a number of pitches, −1000 … 1000",
    range: (Included(-1000.0), Included(1000.0)),
    help: "give how far beyond the mating each pose stands, 0.5 for half a pitch",
};
/// Poses a pitch.
pub const STEPS_PER_PITCH: RangeInclusive<u32> = 1..=1000;
/// Chordal error of the polygons.
pub const CHORD: Limits = Limits {
    allowed: "a number of µm, 1e-5 … 100",
    range: (Included(1e-5), Included(100.0)),
    help: "0.01 is the default; finer is slower",
};
/// Of a comparison.
pub const TOLERANCE: Limits = Limits {
    allowed: "a number of µm, 0 or more",
    range: (Included(0.0), Unbounded),
    help: "give by how much simulated and analytic backlash may differ, 0.1 by default",
};
