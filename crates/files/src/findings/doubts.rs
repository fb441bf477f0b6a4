//! Values that look as if something else were meant, in words.

use crate::cross_check::CrossCheck;
use crate::statements::Statements;
use gearlash::metrology::{Quantity, SameKind};

pub fn looks_like_mm(of: &Statements, quantity: Quantity, greatest: f64) -> String {
    format!(
        "{}: the greatest value is {greatest} µm, less than is measured on teeth: if mm were meant, multiply by 1000 ({greatest} mm are {:.4} µm)",
        path(of, quantity),
        1000.0 * greatest
    )
}

pub fn looks_like_whole(of: &Statements, quantity: Quantity, mean: f64) -> String {
    let what = match quantity {
        Quantity::Pitch => "the pitch itself",
        _ => "the thickness itself",
    };
    format!(
        "{}: the values are about {mean:.3}, what {what} is in mm; asked for is what each tooth deviates by, in µm",
        path(of, quantity)
    )
}

fn path(of: &Statements, quantity: Quantity) -> String {
    of.table.path_of(match quantity {
        Quantity::Allowance => "thickness.allowance_um",
        Quantity::Runout => of.runout.key(),
        Quantity::PerTooth => "thickness.per_tooth_um",
        Quantity::Pitch => "pitch",
    })
}

pub fn same_kind(of: &Statements, kind: SameKind) -> String {
    let words = match kind {
        SameKind::Span => "a span over as many teeth",
        SameKind::OverPins => "a dimension over the same pins",
        SameKind::Allowance => "an allowance",
    };
    format!(
        "{}: is {words}, like the statement that is used, and repeats its faults: check by another kind of measurement (span, over pins, \
         another number of teeth or pin)",
        of.table.path_of(CrossCheck::UNDER)
    )
}
