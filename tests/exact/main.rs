//! The exact method against everything outside it: the reference poses, closed forms, a
//! brute-force search, and the hard cases.

#[path = "../common/along_face.rs"]
mod along_face;
mod both_methods;
mod brackets;
mod campaign;
#[path = "../common/clearance/mod.rs"]
mod clearance;
#[path = "../common/design.rs"]
mod design;
mod drawn;
mod extremes;
mod face_width;
mod field;
#[cfg(feature = "offset")]
mod flank_offset;
mod grazing;
mod hard;
mod helical;
mod helical_extremes;
mod helical_pairs;
mod helical_sections;
mod helical_warm;
mod leads;
mod modified;
mod odd_teeth;
mod outline_extremes;
mod outlines;
mod perfect;
#[path = "../common/posed.rs"]
mod posed;
mod profiles;
mod proofs;
mod random;
mod reference;
mod reference_poses;
mod straight_sided;
mod ties;
mod traced;
mod wide;
mod witnesses;
mod witnesses_extremes;
mod witnesses_helical;
mod witnesses_outlines;
