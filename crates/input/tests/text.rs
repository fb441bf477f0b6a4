//! Numbers and characters as text, and the rows of a population.

use gearlash::population::{OutcomeKind, Row};
use gearlash_input::tolerance::{RowsHead, RowsReader, row_line};
use gearlash_text::characters::{cell, cut, json, plain};
use gearlash_text::numbers::*;

#[test]
fn the_minus_is_true_and_zero_has_none() {
    for (value, decimals, text) in [
        (-16.2741, 2, "−16.27"),
        (-0.004, 2, "0.00"),
        (-0.0, 0, "0"),
        (-0.4, 0, "0"),
        (-0.005_1, 2, "−0.01"),
        (3.0, 1, "3.0"),
    ] {
        assert_eq!(fixed(value, decimals), text);
    }
    assert_eq!(ascii(-16.2741, 2), "-16.27");
    assert_eq!(shortest(-0.25), "−0.25");
    assert_eq!(shortest(-0.0), "0");
    assert_eq!(um(-0.0162741, 2), "−16.27");
    assert_eq!(um(-1e-9, 2), "0.00");
    assert_eq!(um_ascii(-0.0162741, 2), "-16.27");
    assert_eq!(um(None, 2), "–");
    let signed = [-1e-9, 1e-9, 0.0225, -0.0225].map(|mm| signed_um(mm, 2));
    assert_eq!(signed, ["0.00", "0.00", "+22.50", "-22.50"]);
}

#[test]
fn a_number_has_no_more_decimals_than_it_needs() {
    assert_eq!(trimmed(132.12345, 3, 6), "132.12345");
    assert_eq!(trimmed(0.25, 0, 6), "0.25");
    assert_eq!(trimmed(-120.0, 0, 6), "−120");
    assert_eq!(trimmed(120.0, 0, 0), "120");
    assert_eq!(stated_distance(132.04), "132.040");
    assert_eq!(stated_distance(132.12345), "132.12345");
    assert_eq!(stated_distance(160.0), "160.000");
    assert_eq!(stated_distance(61.999999968), "62.000");
}

#[test]
fn a_bound_is_rounded_up() {
    assert_eq!(bound_um(3.14e-12), "4·10⁻⁹");
    assert_eq!(bound_um(1e-12), "1·10⁻⁹");
    assert_eq!(bound_um(9.5e-12), "1·10⁻⁸");
    assert_eq!(bound_um(3.2e-5), "0.04");
    assert_eq!(bound_um(7e-4), "0.7");
    assert_eq!(bound_um(30.0), "3·10⁴");
    assert_eq!(um_within(0.0123456, 0.000561), "12.35 ± 0.57");
    assert_eq!(um_within(-0.0123456, 0.0123), "−12 ± 13");
    assert_eq!(um_within(0.25, 1e-9), "250.0000000 ± 0.0000010");
    assert_eq!(um_within(0.25, 0.0), "250.00");
    assert_eq!(um_bounded(0.0123456, 0.000561), "12.35 ± 0.57 µm");
    assert_eq!(um_bounded(0.25, 2e-12), "250.00 µm (error ≤ 2·10⁻⁹ µm)");
    assert_eq!(bound_um(0.0), "0");
    for (value, shown) in [
        (1.301e-9, 1.4e-9),
        (1.4e-9, 1.4e-9),
        (0.0, 0.0),
        (9.91, 10.0),
        (2.0, 2.0),
    ] {
        assert_eq!(two_digits_up(value), shown);
    }
}

#[test]
fn small_numbers_show_their_size() {
    assert_eq!(decades(3.2e-9), "3.2·10⁻⁹");
    assert_eq!(decades(1e-12), "1·10⁻¹²");
    assert_eq!(decades(0.0032), "0.0032");
    assert_eq!(decades(0.0), "0");
    assert_eq!(difference_um(-2.2e-15), "−2·10⁻¹²");
    assert_eq!(difference_um(-2.25218e-2), "−22.5218");
    assert_eq!(significant(3.14159e-7), "3.14 · 10⁻⁷");
    assert_eq!(significant(0.0123456), "0.0123");
    assert_eq!(order_um(6.2e-12), "6e-9");
}

#[test]
fn rounding_leaves_no_negative_zero() {
    assert_eq!(rounded(-0.00004, 4).to_bits(), 0f64.to_bits());
    assert_eq!(rounded(-66.100_05, 4), -66.1001);
}

/// XML 1.0 §2.2, production `Char`, as printed.
fn is_char(c: char) -> bool {
    matches!(c, '\u{9}' | '\u{A}' | '\u{D}' | '\u{20}'..='\u{D7FF}' | '\u{E000}'..='\u{FFFD}' | '\u{10000}'..='\u{10FFFF}')
}

#[test]
fn what_is_left_is_xml_whatever_comes_in() {
    let every: String = ('\0'..=char::MAX).collect();
    let left = plain(&every);
    assert!(left.chars().all(is_char));
    assert_eq!(left.chars().count(), every.chars().count());
    roxmltree::Document::parse(&format!("<t>{}</t>", left.replace(['<', '&', '>'], " "))).unwrap();
}

#[test]
fn what_no_page_can_hold_becomes_a_space() {
    let odd = "a\u{0}b\u{FDD0}c\u{FFFF}d\u{1FFFF}<e>\tf";
    assert_eq!(plain(odd), "a b c d <e> f");
    assert_eq!(plain("z₁ – Ünïcode 齿轮 𝛼"), "z₁ – Ünïcode 齿轮 𝛼");
    assert_eq!(plain("a\u{202e}b\u{2028}c\u{9b}d"), "a b c d");
}

/// The prefixes are those of the runners' sources: GitHub's `ActionCommand.cs`, Azure's `Command.cs`.
#[test]
fn no_command_of_a_log_is_left() {
    assert_eq!(plain(" \t::error::x"), ": :error::x");
    let apart = "a # #[error]b # #vso[task.x] ### #[c] ## [d] #1 ##2";
    let text = "a ##[error]b ##vso[task.x] ####[c] ## [d] #1 ##2";
    assert_eq!(plain(text), apart);
    assert_eq!(plain("gear::wheel"), "gear::wheel");
}

/// The signs are those of OWASP, "CSV Injection".
#[test]
fn no_cell_is_a_formula() {
    for (text, wanted) in [
        ("=cmd|' /C calc'!A0", "'=cmd|' /C calc'!A0"),
        (" @SUM(A1)", "' @SUM(A1)"),
        ("\t-1", "' -1"),
        ("+1", "'+1"),
        ("::error::x", ": :error::x"),
        ("\u{1b}[31mred", " [31mred"),
        ("w-1", "w-1"),
    ] {
        assert_eq!(cell(text), wanted);
    }
}

#[test]
fn json_reads_the_same() {
    let words = "a\u{7f}\u{9b}\u{202e}\u{1ffff}\u{1b}\n###[x]\"\\ü";
    let text = serde_json::to_string_pretty(&[words]).unwrap();
    let escaped = json(text);
    assert!(escaped.contains('\n') && !escaped.contains("##"));
    let acting = ['\u{7f}', '\u{9b}', '\u{202e}', '\u{1ffff}', '\u{1b}'];
    assert!(!escaped.contains(acting), "{escaped}");
    let read: Vec<String> = serde_json::from_str(&escaped).unwrap();
    assert_eq!(read, [words]);
}

#[test]
fn a_cut_is_visible_and_counts_characters() {
    assert_eq!(cut("äöü", 3), "äöü");
    assert_eq!(cut("äöüß", 3), "äöü …");
}

/// Rows of every outcome, and of lengths up to the greatest, read back.
#[test]
fn rows_and_headers_read_back() {
    let lengths = [
        0,
        1,
        -1,
        123_456_789,
        -98_765,
        1 << 53,
        -(1 << 53),
        7_000_000_000_001,
    ];
    let head = RowsHead {
        version: "0.1.0".to_owned(),
        input_sha256: "ab".repeat(32),
        seed: 4_294_967_295,
        first: 1_000_000_000,
        count: 7,
    };
    let row = |(number, kind): (u64, OutcomeKind)| {
        let one = |by: u64| Some(lengths[(number + by) as usize % lengths.len()]);
        let is_fourth = number % 4 == 0;
        Row {
            number,
            kind,
            least: one(0),
            greatest: one(3).filter(|_| !is_fourth),
            is_proven: number.is_multiple_of(2),
            is_below: number.is_multiple_of(3),
            is_above: number.is_multiple_of(5),
            margin: one(5).filter(|_| is_fourth),
        }
    };
    let rows = (1..).zip(OutcomeKind::ALL.into_iter().cycle().take(60));
    let rows: Vec<Row> = rows.map(row).collect();
    let text = head.lines() + &rows.iter().map(row_line).collect::<String>();
    let (found, reader) = RowsReader::begin("rows.csv", text.as_bytes()).unwrap();
    assert_eq!(found, head);
    assert_eq!(reader.map(Result::unwrap).collect::<Vec<Row>>(), rows);
}
