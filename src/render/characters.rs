//! Characters that a picture or a page can hold.

/// `text` with a space for each character that XML or HTML cannot hold.
///
/// XML 1.0 §2.2 (production `Char`) leaves out most controls below U+0020, surrogates (which no `str` has), U+FFFE and
/// U+FFFF. HTML also forbids the controls U+007F to U+009F and all noncharacters. Tabs and line ends, which both hold
/// as white space, become spaces too: a title stands on one line.
pub fn plain(text: &str) -> String {
    let unfit = |c: char| {
        let code = c as u32;
        c.is_control() || (0xFDD0..=0xFDEF).contains(&code) || code & 0xFFFE == 0xFFFE
    };
    text.chars()
        .map(|c| if unfit(c) { ' ' } else { c })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::plain;

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
        roxmltree::Document::parse(&format!("<t>{}</t>", left.replace(['<', '&', '>'], " ")))
            .unwrap();
    }

    /// A title with U+FFFF made a snapshot that no parser reads.
    #[test]
    fn a_text_of_a_picture_is_xml() {
        let text = crate::render::page::text("a\u{ffff}b j_wt \u{1}<c>", [0.0; 2], 12.0, false);
        let text = text.to_string();
        let read = roxmltree::Document::parse(&text).unwrap();
        let words: String = read.descendants().filter_map(|node| node.text()).collect();
        assert!(words.contains("a b"), "{words}");
    }

    #[test]
    fn what_no_page_can_hold_becomes_a_space() {
        assert_eq!(
            plain("a\u{0}b\u{FDD0}c\u{FFFF}d\u{1FFFF}<e>\tf"),
            "a b c d <e> f"
        );
        assert_eq!(plain("z₁ – Ünïcode 齿轮 𝛼"), "z₁ – Ünïcode 齿轮 𝛼");
    }
}
