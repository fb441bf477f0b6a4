//! JUnit XML: one suite per file, one case per judged property.

use gearlash_files::characters::plain;
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesEnd, BytesStart, BytesText, Event};
use std::io;

/// One file.
pub(crate) struct Suite {
    pub file: String,
    pub cases: Vec<TestCase>,
    /// The suite's output: warnings and notes on the file.
    pub output: Vec<String>,
}

/// One judged property.
pub(crate) struct TestCase {
    pub name: String,
    /// Why it fails (`failure`) or cannot be judged (`error`).
    pub reason: Option<(&'static str, String)>,
}

type Xml = Writer<Vec<u8>>;

/// The report of the command `name`.
///
/// # Errors
/// None: the text is in memory.
pub(crate) fn junit(name: &str, suites: &[Suite]) -> io::Result<String> {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 4);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    let cases: Vec<&TestCase> = suites.iter().flat_map(|suite| &suite.cases).collect();
    let all = counted_tag("testsuites", name, &cases);
    write_within(&mut xml, all, suites, |xml, suite| {
        let cases: Vec<&TestCase> = suite.cases.iter().collect();
        let tag = counted_tag("testsuite", &plain(&suite.file), &cases);
        let output = (!suite.output.is_empty()).then(|| Part::Output(suite.output.join("\n")));
        let parts: Vec<Part> = cases.into_iter().map(Part::Case).chain(output).collect();
        write_within(xml, tag, &parts, |xml, part| match part {
            Part::Case(case) => write_case(xml, suite, case),
            Part::Output(text) => {
                let tag = BytesStart::new("system-out");
                write_within(xml, tag, &[text], |xml, text| {
                    xml.write_event(Event::Text(BytesText::new(&plain(text))))
                })
            }
        })
    })?;
    Ok(String::from_utf8_lossy(&xml.into_inner()).into_owned() + "\n")
}

/// A part of a suite.
enum Part<'a> {
    Case(&'a TestCase),
    Output(String),
}

fn write_case(xml: &mut Xml, suite: &Suite, case: &TestCase) -> io::Result<()> {
    let mut tag = BytesStart::new("testcase");
    tag.push_attribute(("name", plain(&case.name).as_str()));
    tag.push_attribute(("classname", plain(&suite.file).as_str()));
    write_within(xml, tag, case.reason.as_slice(), |xml, (kind, reason)| {
        let lines: Vec<String> = reason.lines().map(plain).collect();
        let mut tag = BytesStart::new(*kind);
        let first = lines.first().map_or("", String::as_str);
        tag.push_attribute(("message", first));
        write_within(xml, tag, &[lines.join("\n")], |xml, text| {
            xml.write_event(Event::Text(BytesText::new(text)))
        })
    })
}

/// A tag with its name and the numbers of `cases`, of failures and of errors. No case is skipped.
fn counted_tag<'a>(tag: &'a str, name: &str, cases: &[&TestCase]) -> BytesStart<'a> {
    let count = |kind: &str| {
        let reasons = cases.iter().filter_map(|case| case.reason.as_ref());
        reasons.filter(|(of, _)| *of == kind).count()
    };
    let mut tag = BytesStart::new(tag);
    tag.push_attribute(("name", name));
    for (name, count) in [
        ("tests", cases.len()),
        ("skipped", 0),
        ("failures", count("failure")),
        ("errors", count("error")),
    ] {
        tag.push_attribute((name, count.to_string().as_str()));
    }
    tag
}

/// Writes `tag` around `each` of `list`, or an empty tag.
fn write_within<T>(
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
