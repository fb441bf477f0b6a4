//! The outcome of `compare` as JUnit XML: the verdict first, then a case a run.

use super::{failure, run_name};
use gearlash::analysis::verdict::Requirement;
use gearlash_files::characters::plain;
use gearlash_files::results::ComparedPair;
use gearlash_files::verdict::sentence;
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesEnd, BytesStart, Event};
use std::io;

type Xml = Writer<Vec<u8>>;

/// JUnit XML: a suite a file, a case a run.
///
/// # Errors
/// None: it is written to memory.
pub fn junit(pairs: &[ComparedPair]) -> io::Result<String> {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 4);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    let mut all = BytesStart::new("testsuites");
    all.push_attribute(("name", "gearlash compare"));
    let counts = pairs.iter().map(counts);
    let counts = counts.fold([0, 0], |sum, of| [sum[0] + of[0], sum[1] + of[1]]);
    count(&mut all, ["tests", "skipped", "failures", "errors"], counts);
    within(&mut xml, all, pairs, suite)?;
    let bytes = xml.into_inner();
    Ok(String::from_utf8_lossy(&bytes).into_owned() + "\n")
}

/// The verdict and the runs, and those of them that fail.
fn counts(pair: &ComparedPair) -> [usize; 2] {
    let failing = pair.runs.iter().filter(|run| failure(pair, run).is_some());
    let unmet = pair.verdict().requirement == Requirement::NotMet;
    [1 + pair.runs.len(), failing.count() + usize::from(unmet)]
}

/// Adds `names` as attributes, each with its count; nothing is skipped, and nothing ends in an error.
fn count(tag: &mut BytesStart, names: [&str; 4], [tests, failures]: [usize; 2]) {
    for name in names {
        let value = match name {
            "tests" => tests,
            "failures" => failures,
            _ => 0,
        };
        tag.push_attribute((name, value.to_string().as_str()));
    }
}

fn suite(xml: &mut Xml, pair: &ComparedPair) -> io::Result<()> {
    let mut tag = BytesStart::new("testsuite");
    tag.push_attribute(("name", plain(&pair.file).as_str()));
    count(
        &mut tag,
        ["tests", "skipped", "errors", "failures"],
        counts(pair),
    );
    let verdict = pair.verdict();
    xml.write_event(Event::Start(tag.borrow()))?;
    let mut first = BytesStart::new("testcase");
    first.push_attribute(("name", sentence(&verdict).as_str()));
    first.push_attribute(("classname", plain(&pair.title).as_str()));
    let unmet = (verdict.requirement == Requirement::NotMet).then(|| sentence(&verdict));
    within(xml, first, unmet.as_slice(), |xml, reason| {
        failed(xml, reason)
    })?;
    for run in &pair.runs {
        let mut case = BytesStart::new("testcase");
        case.push_attribute(("name", run_name(run).as_str()));
        case.push_attribute(("classname", plain(&pair.title).as_str()));
        within(xml, case, failure(pair, run).as_slice(), |xml, reason| {
            failed(xml, reason)
        })?;
    }
    xml.write_event(Event::End(tag.to_end()))
}

fn failed(xml: &mut Xml, reason: &str) -> io::Result<()> {
    let mut failure = BytesStart::new("failure");
    failure.push_attribute(("message", reason));
    xml.write_event(Event::Empty(failure))
}

/// Writes `tag` with `each` of `list` in it, or closed where there is none.
fn within<T>(
    xml: &mut Xml,
    tag: BytesStart,
    list: &[T],
    each: impl Fn(&mut Xml, &T) -> io::Result<()>,
) -> io::Result<()> {
    if list.is_empty() {
        return xml.write_event(Event::Empty(tag));
    }
    let end = BytesEnd::new(tag.name().into_inner().to_owned());
    xml.write_event(Event::Start(tag))?;
    for element in list {
        each(xml, element)?;
    }
    xml.write_event(Event::End(end))
}
