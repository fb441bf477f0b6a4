//! A half tooth as chords. Chords are cut finer only where a search needs them finer.
//!
//! Each chord stores an error bound: its curve lies within that distance of it. A cut in the middle of the parameter
//! range divides the bound by four (by eight where an involute begins). A chord can also be cut on either side of the
//! place where it is nearest to another chord. All teeth of a gear and all poses share the chords down to a coarse
//! error, which are cut once. Finer chords are made on demand and not stored.
//!
//! Tip and root lands are cut in advance only as far as all teeth share them. That is the near half of the tip land (or the land of a
//! thinner tooth) and the root land of the narrowest space. The rest depends on the deviations of each tooth ([`Half`]).

use crate::gear::{AsBuilt, Profile, ProfilePart, Side};
use crate::pair::Member;
use nalgebra::{Isometry2, Point2};

/// Greatest chordal error in [`Half::outline`], as a part of the radius of the half tooth (tuned for the certificate).
const OUTLINE: f64 = 0.03;

/// Shortest part of a chord that is cut off. It is far above rounding, so every piece has a direction.
const SHORTEST: f64 = 1e-6;

/// A stretch of one curve of a half tooth, and the chord through its ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chord {
    pub curve: ProfilePart,
    /// Parameters of the ends, the one nearer the tip first.
    pub parameters: [f64; 2],
    pub ends: [Point2<f64>; 2],
    /// The curve lies within this of the chord, mm.
    pub error: f64,
    /// Half its length, mm.
    pub half_length: f64,
    /// Index of its two halves among the chords cut in advance.
    halves: Option<u32>,
}

impl Chord {
    fn new(profile: &Profile, side: Side, curve: ProfilePart, [from, to]: [f64; 2]) -> Chord {
        let ends = [from, to].map(|t| profile.point(curve, t, side));
        Chord::between(profile, curve, [from, to], ends)
    }

    fn between(
        profile: &Profile,
        curve: ProfilePart,
        parameters: [f64; 2],
        ends: [Point2<f64>; 2],
    ) -> Chord {
        Chord {
            curve,
            parameters,
            ends,
            error: profile.chordal_error(curve, parameters[0], parameters[1]),
            half_length: 0.5 * (ends[1] - ends[0]).norm(),
            halves: None,
        }
    }

    fn cut(&self, profile: &Profile, side: Side) -> [Chord; 2] {
        let [from, to] = self.parameters;
        let t = 0.5 * (from + to);
        let middle = profile.point(self.curve, t, side);
        let [start, end] = self.ends;
        [
            Chord::between(profile, self.curve, [from, t], [start, middle]),
            Chord::between(profile, self.curve, [t, to], [middle, end]),
        ]
    }

    /// The pieces between cuts at two parts of the parameter range, the middle piece first. Cuts outside the range are ignored.
    fn cut_at(&self, profile: &Profile, side: Side, parts: [f64; 2]) -> Pieces {
        let [from, to] = self.parameters;
        let mut pieces = Pieces {
            chords: [*self; 3],
            count: 0,
        };
        let mut start = (from, self.ends[0]);
        let inside = |part: &f64| *part > SHORTEST && *part < 1.0 - SHORTEST;
        let cuts = parts.into_iter().filter(inside);
        let cuts = cuts.map(|part| {
            let t = from + part * (to - from);
            (t, profile.point(self.curve, t, side))
        });
        for end in cuts.chain([(to, self.ends[1])]) {
            let (parameters, ends) = ([start.0, end.0], [start.1, end.1]);
            pieces.chords[pieces.count] = Chord::between(profile, self.curve, parameters, ends);
            pieces.count += 1;
            start = end;
        }
        if inside(&parts[0]) {
            pieces.chords.swap(0, 1);
        }
        pieces
    }

    /// Whether its halves exist already.
    pub fn is_cut(&self) -> bool {
        self.halves.is_some()
    }

    /// This chord in another frame.
    pub fn seen_in(&self, frame: &Isometry2<f64>) -> Chord {
        Chord {
            ends: self.ends.map(|end| frame * end),
            ..*self
        }
    }

    /// Parameter at a point of the chord. Its error is less than the chord's own range.
    pub fn parameter_at(&self, point: &Point2<f64>) -> f64 {
        let along = self.ends[1] - self.ends[0];
        let part = (point - self.ends[0]).dot(&along) / along.norm_squared();
        // A chord without length has no direction: use its start.
        let part = if part.is_finite() {
            part.clamp(0.0, 1.0)
        } else {
            0.0
        };
        self.parameters[0] + part * (self.parameters[1] - self.parameters[0])
    }
}

/// Up to three chords in the place of one.
pub(super) struct Pieces {
    chords: [Chord; 3],
    count: usize,
}

impl Pieces {
    pub fn chords(&self) -> &[Chord] {
        &self.chords[..self.count]
    }
}

/// Chordal error, in modules, of the polygons from which a certificate starts. Any value gives equal results; this one
/// is tuned for speed (a tenth takes 8 % longer, ten times as much 2 %).
const CERTIFICATE_CHORDAL_ERROR: f64 = 3e-4;

/// Both gears, cut into chords once for all centre distances.
pub struct CutPair {
    pub(super) wheel: CutGear,
    pub(super) pinion: CutGear,
}

impl CutPair {
    /// Cuts both gears with chords within `chordal_error` mm of their curves.
    pub fn new(wheel: &AsBuilt, pinion: &AsBuilt, chordal_error: f64) -> CutPair {
        CutPair {
            wheel: CutGear::new(wheel, chordal_error),
            pinion: CutGear::new(pinion, chordal_error),
        }
    }

    /// Cuts both gears as coarsely as is best for certificates.
    pub fn for_certificates(wheel: &AsBuilt, pinion: &AsBuilt) -> CutPair {
        let module = wheel.gear().basic_data().module();
        CutPair::new(wheel, pinion, CERTIFICATE_CHORDAL_ERROR * module)
    }

    /// One of the gears.
    pub(super) fn gear(&self, member: Member) -> &CutGear {
        match member {
            Member::Wheel => &self.wheel,
            Member::Pinion => &self.pinion,
        }
    }
}

/// The half teeth of a gear, cut into chords in advance. Equal teeth share them.
pub(super) struct CutGear {
    sides: [CutSide; 2],
    /// Chordal error of the chords cut in advance, mm.
    pub chordal_error: f64,
}

/// The half teeth of one side.
struct CutSide {
    /// By shape ([`AsBuilt::shape_of`]).
    halves: Vec<CutHalf>,
    /// The lands that belong to each tooth alone, tooth 1 first.
    own: Vec<OwnLands>,
}

/// The chords that all half teeth of one shape share.
struct CutHalf {
    chords: Vec<Chord>,
    /// How many chords at the start of `chords` are uncut: one for each curve without edges.
    curves: usize,
    /// A coarse outline. It is close enough to show that half teeth far from contact are clear.
    outline: Vec<Chord>,
    /// A disc that holds the chords, up to the far corner of the tip land and the middle of the space.
    centre: Point2<f64>,
    radius: f64,
}

/// The parts of one half tooth that it does not share with the others.
struct OwnLands {
    /// Index of its shape.
    shape: usize,
    /// The tip land's parameter at its far corner.
    land_start: f64,
    /// The root land's parameter in the middle of the space as built.
    root_end: f64,
    /// The rest of the tip land, and of the root land.
    chords: [Option<Chord>; 2],
    /// Greatest length of these parts, mm.
    length: f64,
}

impl CutGear {
    /// Cuts the half teeth of `gear` with chords within `chordal_error` mm of its curves.
    pub fn new(gear: &AsBuilt, chordal_error: f64) -> CutGear {
        CutGear {
            sides: Side::BOTH.map(|side| CutSide::new(gear, side, chordal_error)),
            chordal_error,
        }
    }
}

impl CutSide {
    fn new(gear: &AsBuilt, side: Side, chordal_error: f64) -> CutSide {
        // For each shape: where the shared tip land starts and where the shared root land ends. If every space is wider
        // than nominal, the rest of each land begins beyond the nominal middle.
        let mut shared = vec![(0.0f64, f64::INFINITY); gear.shapes(side)];
        let teeth = 1..=gear.gear().basic_data().teeth();
        for tooth in teeth.clone() {
            let (start, end) = &mut shared[gear.shape_of(side, tooth)];
            *start = start.max(gear.land_start(side, tooth));
            *end = end.min(gear.root_end(side, tooth));
        }
        let half = |(shape, lands): (usize, &(f64, f64))| {
            CutHalf::new(&gear.shape(side, shape), side, chordal_error, *lands)
        };
        let own = |tooth| OwnLands::new(gear, side, tooth, &shared);
        CutSide {
            halves: shared.iter().enumerate().map(half).collect(),
            own: teeth.map(own).collect(),
        }
    }
}

impl CutHalf {
    fn new(
        profile: &Profile,
        side: Side,
        chordal_error: f64,
        (land_start, root_end): (f64, f64),
    ) -> CutHalf {
        let mut chords: Vec<Chord> = ProfilePart::ALL
            .into_iter()
            .filter_map(|curve| {
                let (from, to) = match (curve, profile.range(curve)) {
                    (ProfilePart::Tip, (_, to)) => (land_start, to),
                    (ProfilePart::Root, (from, _)) => (from, root_end),
                    (_, range) => range,
                };
                let is_there = if curve.is_land() {
                    to > from
                } else {
                    from > to
                };
                is_there.then_some((curve, [from, to]))
            })
            .flat_map(|(curve, [from, to])| {
                let stretches = profile.part(curve).curve.between_edges(from, to);
                stretches.into_iter().map(move |ends| (curve, ends))
            })
            .map(|(curve, ends)| Chord::new(profile, side, curve, ends))
            .collect();
        let curves = chords.len();
        let mut next = 0;
        while next < chords.len() {
            if chords[next].error > chordal_error {
                chords[next].halves = Some(chords.len() as u32);
                let halves = chords[next].cut(profile, side);
                chords.extend(halves);
            }
            next += 1;
        }
        let (mut low, mut high) = (chords[0].ends[0], chords[0].ends[0]);
        for end in chords.iter().flat_map(|chord| chord.ends) {
            low = low.inf(&end);
            high = high.sup(&end);
        }
        let radius = 0.5 * (high - low).norm() + chordal_error;
        let is_close = |chord: &Chord| chord.error <= OUTLINE * radius || chord.halves.is_none();
        let mut outline = chords[..curves].to_vec();
        while let Some(place) = outline.iter().position(|chord| !is_close(chord)) {
            let cut = outline[place].halves.map_or(0, |first| first as usize);
            outline.splice(place..=place, chords[cut..cut + 2].iter().copied());
        }
        CutHalf {
            centre: nalgebra::center(&low, &high),
            radius,
            chords,
            curves,
            outline,
        }
    }
}

impl OwnLands {
    /// The lands of the half tooth on `side` of `tooth`. `shared` gives for each shape where the shared tip land starts
    /// and where the shared root land ends.
    fn new(gear: &AsBuilt, side: Side, tooth: u32, shared: &[(f64, f64)]) -> OwnLands {
        let shape = gear.shape_of(side, tooth);
        let (shared_start, shared_end) = shared[shape];
        let profile = &gear.shape(side, shape);
        let (land_start, root_end) = (gear.land_start(side, tooth), gear.root_end(side, tooth));
        let far =
            (land_start < shared_start).then_some((ProfilePart::Tip, [land_start, shared_start]));
        // A space without a root land has none in either half tooth.
        let from = shared_end.max(profile.range(ProfilePart::Root).0);
        let rest = (root_end > from).then_some((ProfilePart::Root, [from, root_end]));
        let chord = |(curve, range)| Chord::new(profile, side, curve, range);
        OwnLands {
            shape,
            land_start,
            root_end,
            chords: [far.map(chord), rest.map(chord)],
            length: gear.gear().tip_radius() * (shared_start - land_start)
                + gear.gear().root_radius() * (root_end - shared_end).max(0.0),
        }
    }
}

/// One half tooth: the shared chords, the rest of its tip land up to the far corner, and the rest of its root land.
///
/// The tip land reaches its far corner, because the mate may touch only the far half where tips barely reach each other or press on a root.
/// The far half is metal of the same tooth, and a mate that turns in meets the near half first wherever it can.
#[derive(Clone, Copy)]
pub(super) struct Half<'a> {
    /// The curves of the gear's half teeth.
    pub profile: Profile<'a>,
    /// The side of the tooth on which it lies.
    pub side: Side,
    cut: &'a CutHalf,
    own: &'a OwnLands,
}

impl<'a> Half<'a> {
    /// The half tooth on `side` of `tooth`, with the profile of that tooth.
    pub fn new(profile: Profile<'a>, cut: &'a CutGear, side: Side, tooth: u32) -> Half<'a> {
        let cut = &cut.sides[usize::from(side == Side::Left)];
        let own = &cut.own[tooth as usize - 1];
        Half {
            profile,
            side,
            cut: &cut.halves[own.shape],
            own,
        }
    }

    /// The tip land's parameter at its far corner.
    pub fn land_start(&self) -> f64 {
        self.own.land_start
    }

    /// The root land's parameter in the middle of the space as built.
    pub fn root_end(&self) -> f64 {
        self.own.root_end
    }

    /// The uncut chords that all teeth share: one for each curve without edges.
    pub fn shared(&self) -> &'a [Chord] {
        &self.cut.chords[..self.cut.curves]
    }

    /// About a dozen chords that all teeth share and that follow the outline closely.
    pub fn outline(&self) -> &'a [Chord] {
        &self.cut.outline
    }

    /// The uncut chords of this tooth alone: the rest of the tip land and of the root land.
    pub fn own(&self) -> impl Iterator<Item = &'a Chord> + use<'a> {
        self.own.chords.iter().flatten()
    }

    /// The two halves of a chord. `made` stores them unless they were cut in advance.
    pub fn halves<'b>(&'b self, chord: &Chord, made: &'b mut Option<[Chord; 2]>) -> &'b [Chord] {
        match chord.halves {
            Some(first) => &self.cut.chords[first as usize..first as usize + 2],
            None => made.insert(chord.cut(&self.profile, self.side)),
        }
    }

    /// A chord cut at two parts of its parameter range; cuts outside the range are ignored.
    pub fn cut_at(&self, chord: &Chord, parts: [f64; 2]) -> Pieces {
        chord.cut_at(&self.profile, self.side, parts)
    }

    /// Greatest curvature of the chord's curve, 1/mm, where it is known.
    pub fn curvature(&self, chord: &Chord) -> Option<f64> {
        let [from, to] = chord.parameters;
        self.profile.curvature(chord.curve, from, to)
    }

    /// Centre and radius, mm, of a disc that holds the half tooth.
    pub fn disc(&self) -> (Point2<f64>, f64) {
        // Its own lands are no longer than their arcs.
        (self.cut.centre, self.cut.radius + self.own.length)
    }
}
