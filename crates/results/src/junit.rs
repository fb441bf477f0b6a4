//! JUnit XML: a suite a file, a case each of what was looked at.

use gearlash_files::characters::plain;
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesEnd, BytesStart, BytesText, Event};
use std::io;

/// One file.
pub(crate) struct Suite {
    pub file: String,
    /// Title of the pair: the class of its cases.
    pub title: String,
    pub cases: Vec<Case>,
    /// What else is to be said of it: the suite's output.
    pub said: Vec<String>,
}

/// One thing that was looked at.
pub(crate) struct Case {
    pub name: String,
    /// What is wrong with it.
    pub failure: Option<String>,
}

type Xml = Writer<Vec<u8>>;

/// The report of the command `name`.
///
/// # Errors
/// None: it is written to memory.
pub(crate) fn junit(name: &str, suites: &[Suite]) -> io::Result<String> {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 4);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    let cases: Vec<&Case> = suites.iter().flat_map(|suite| &suite.cases).collect();
    let all = counted("testsuites", name, &cases);
    within(&mut xml, all, suites, |xml, suite| {
        let cases: Vec<&Case> = suite.cases.iter().collect();
        let tag = counted("testsuite", &plain(&suite.file), &cases);
        let said = (!suite.said.is_empty()).then(|| Part::Said(suite.said.join("\n")));
        let parts: Vec<Part> = cases.into_iter().map(Part::Case).chain(said).collect();
        within(xml, tag, &parts, |xml, part| match part {
            Part::Case(case) => write_case(xml, suite, case),
            Part::Said(text) => {
                let tag = BytesStart::new("system-out");
                within(xml, tag, &[text], |xml, text| {
                    xml.write_event(Event::Text(BytesText::new(&plain(text))))
                })
            }
        })
    })?;
    Ok(String::from_utf8_lossy(&xml.into_inner()).into_owned() + "\n")
}

/// What stands in a suite.
enum Part<'a> {
    Case(&'a Case),
    Said(String),
}

fn write_case(xml: &mut Xml, suite: &Suite, case: &Case) -> io::Result<()> {
    let mut tag = BytesStart::new("testcase");
    tag.push_attribute(("name", plain(&case.name).as_str()));
    tag.push_attribute(("classname", plain(&suite.title).as_str()));
    within(xml, tag, case.failure.as_slice(), |xml, reason| {
        let mut failure = BytesStart::new("failure");
        failure.push_attribute(("message", plain(reason).as_str()));
        xml.write_event(Event::Empty(failure))
    })
}

/// A tag with its name and how many of `cases` there are and fail; nothing is skipped, and nothing ends in an error.
fn counted<'a>(tag: &'a str, name: &str, cases: &[&Case]) -> BytesStart<'a> {
    let failing = cases.iter().filter(|case| case.failure.is_some()).count();
    let mut tag = BytesStart::new(tag);
    tag.push_attribute(("name", name));
    for (name, count) in [
        ("tests", cases.len()),
        ("skipped", 0),
        ("failures", failing),
        ("errors", 0),
    ] {
        tag.push_attribute((name, count.to_string().as_str()));
    }
    tag
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
