//! Each fault by name: where it is and what to do.

use super::*;

/// Three good rows of four teeth, the header and the last row to be chosen.
const PITCH: &str = "tooth,left (µm),right (µm)\n1,0.5,0.25\n2,1.5,1.25\n3,-1,0\n4,0,0\n";

/// All problems of a wheel of `teeth` teeth with `keys`, below the folder's name.
fn problems(name: &str, table: &[u8], teeth: u32, keys: &str) -> Vec<String> {
    let extra = "profile_shift = 0.6\nrack = { addendum = 0.6, dedendum = 0.8 }\n";
    let text = pair(teeth, &format!("{extra}{keys}"));
    let text = text.replace("[pinion]\n", &format!("[pinion]\n{extra}"));
    let text = text.replace("center_distance_mm = ", "center_distance_mm = 1");
    let told = match read_with(name, table, &text) {
        Ok(study) => panic!("{:#?}", study.spec),
        Err(problems) => problems,
    };
    let message = |problem: &Problem| {
        // Without the folder, which every run has anew.
        let at = problem.reason.find(".csv: ").map_or(0, |end| {
            problem.reason[..end].rfind('/').map_or(0, |at| at + 1)
        });
        format!(
            "{}: {}; {}",
            problem.key,
            &problem.reason[at..],
            problem.help
        )
    };
    told.iter().map(message).collect()
}

/// The messages of a pitch table, one a line.
fn pitch(table: impl AsRef<[u8]>) -> String {
    problems(
        "p.csv",
        table.as_ref(),
        4,
        "pitch = { kind = \"cumulative\", file = \"p.csv\" }",
    )
    .join("\n")
}

fn put(from: &str, to: &str) -> String {
    assert_eq!(PITCH.matches(from).count(), 1, "{from}");
    PITCH.replace(from, to)
}

#[test]
fn rows() {
    let cases = [
        put("2,1.5,1.25\n", ""),
        put("2,1.5,1.25\n", "2,1.5,1.25\n2,1.5,1.25\n"),
        put("4,0,0\n", "4,0,0\n5,0,0\n"),
        put("2,1.5", "2.0,1.5"),
        put("2,1.5", "0,1.5"),
        put("1.25", "x"),
        put("1.25", ""),
        put("1.25", "nan"),
        put("1.25", "1e999"),
        put("1.25", "2e7"),
        put("1.25", "1.25,7"),
        put("1.25", "\"1,25\""),
        put("1.25", "1.250.0"),
        put("1.25", "-05"),
        put("1.25", "01.25"),
        put(",1.25", ""),
        PITCH.replace("\n4,0,0\n", "\n"),
        put("\n1,0.5,0.25\n2,1.5,1.25\n3,-1,0\n4,0,0\n", "\n"),
    ];
    insta::assert_snapshot!(cases.map(pitch).join("\n"));
}

#[test]
fn headers() {
    let header = "tooth,left (µm),right (µm)";
    let cases = [
        put(header, "tooth,left (mm),right (µm)"),
        put(header, "tooth,left_mm,right"),
        put(header, "tooth (µm),left,right"),
        put(header, "tooth,left (parsec),right"),
        put(header, "tooth,left,links"),
        put(header, "tooth,left,runout"),
        put(header, "tooth,left,right,remark"),
        put(header, "tooth,left,"),
        put(header, "tooth left right"),
        put(header, "tooth;left,right"),
        put(&format!("{header}\n"), ""),
        String::new(),
        "\n ;;\n".to_owned(),
        put("3,-1", "3\r,-1"),
        put(header, "tooth\0,left,right"),
    ];
    insta::assert_snapshot!(cases.map(pitch).join("\n"));
}

/// What a comma or a point means is settled by the table, or it is a problem.
#[test]
fn decimal_signs() {
    let german = PITCH.replace(',', ";").replace('.', ",");
    let cases = [
        german.replace("1,25", "1.25"),
        german.replace("1,25", "1.234,5"),
        "tooth;left;right\n1;1.234;5\n2;0;0\n3;0;0\n4;0;0\n".to_owned(),
        "tooth\tleft\tright\n1\t1,234\t5\n2\t0\t0\n3\t0\t0\n4\t0\t0\n".to_owned(),
        // Once for the file.
        "tooth\tleft\tright\n1\t1,234\t5\n2\t2,345\t3,456\n3\t0\t0\n4\t0\t0\n".to_owned(),
    ];
    insta::assert_snapshot!(cases.map(pitch).join("\n"));
}

#[test]
fn keys() {
    let good = PITCH.as_bytes();
    let told = |keys: &str| problems("p.csv", good, 4, keys).join("\n");
    let cases = [
        "pitch = { file = \"p.csv\" }",
        "pitch = { file = \"q.csv\", kind = \"single\" }",
        "pitch = { file = 4, kind = \"single\" }",
        "pitch = { file = \"p.csv\", kind = \"single\", right_um = [1, 2, 3, 4] }",
        "pitch = { file = \"p.csv\", kind = \"single\", sheet = \"a\" }",
        "pitch = { file = \"p.csv\", kind = \"single\", decimal = \",\" }",
        "pitch = { file = \"p.csv\", kind = \"single\", decimal = \"comma\" }",
        "pitch = { kind = \"single\", right_um = [0, 0, 0, 0], left_um = [0, 0, 0, 0], decimal = \",\" }",
        "runout = { file = \"p.csv\" }",
        "runout = { file = \"p.csv\", at = \"gap\" }",
        "runout = { file = \"p.csv\", at = \"tooth\", total_um = 4 }",
        "runout = { total_um = 4, high_tooth = 1, at = \"tooth\" }",
        "thickness.per_tooth_um = { file = \"p.csv\", at = 1 }",
        "thickness.per_tooth_um = { }",
    ];
    insta::assert_snapshot!(cases.map(told).join("\n"));
}

/// The rest is reported in one line: 44 problems of one kind are one mistake.
#[test]
fn many_problems_of_a_table_are_reported_in_short() {
    let rows: Vec<String> = (1..=44).map(|tooth| format!("{tooth},x,0")).collect();
    let table = format!("tooth,left,right\n{}", rows.join("\n"));
    let keys = "pitch = { kind = \"single\", file = \"p.csv\" }";
    let told = problems("p.csv", table.as_bytes(), 44, keys);
    assert_eq!(told.len(), 13);
    assert!(told[12].contains("32 more problems"), "{}", told[12]);
}

fn protocol(from: &str, to: &str, kind: &str) -> String {
    let text = fs::read_to_string("../../fixtures/sheets/protocol.txt").unwrap();
    assert!(text.contains(from), "{from}");
    let table = text.replacen(from, to, 1);
    let keys = format!("pitch = {{ kind = \"{kind}\", file = \"p.txt\" }}");
    match read_with("p.txt", table.as_bytes(), &pair(44, &keys)) {
        Ok(study) => panic!("{:#?}", study.spec),
        Err(told) => {
            let from = |problem: &Problem| {
                problem
                    .to_string()
                    .split("/p.txt: ")
                    .last()
                    .unwrap()
                    .to_owned()
            };
            told.iter().map(from).collect::<Vec<_>>().join("\n")
        }
    }
}

#[test]
fn protocols() {
    let row = fs::read_to_string("../../fixtures/sheets/protocol.txt").unwrap();
    let row = row
        .lines()
        .find(|line| line.trim().starts_with("7 "))
        .unwrap();
    let cases = [
        (": 44\n", ": 45\n"),
        (": 3.000", ": 3.250"),
        (": 20.0000", ": 17.5000"),
        (".: 0.0000\n  24", ".: 12.0000\n  24"),
        (": 0.0000\n  27", ": 0.1000\n  27"),
        (": 138.000", ": 138.2"),
        (": 138.000", ": etwa"),
        ("rechte Zahnflanke", "rechte Zahnflunke"),
        ("rechte Zahnflanke", "linke Zahnflanke"),
        ("fp      Fp      Fr", "fp      Fq      Fr"),
        ("fp      Fp      Fr", "fp      fp      Fr"),
        (row, ""),
        (row, "7 0.1"),
        (row, "7 0,1 0,1 0,1"),
        (row, "7 -2147483.648 0 0"),
        (row, "8 0.0 0.0 0.0"),
        (row, "remark"),
    ];
    let told = cases.iter().map(|(from, to)| protocol(from, to, "single"));
    insta::assert_snapshot!(told.collect::<Vec<_>>().join("\n"));
}

/// fp and Fp tell different stories: 1 µm in one row shows in that row only, in `Fp` in two.
#[test]
fn contradicting_columns_of_a_protocol() {
    let text = fs::read_to_string("../../fixtures/sheets/protocol.txt").unwrap();
    let row = text
        .lines()
        .find(|line| line.trim().starts_with("7 "))
        .unwrap();
    let words: Vec<f64> = row
        .split_whitespace()
        .map(|word| word.parse().unwrap())
        .collect();
    let single = format!("7 {:.1} {:.1} {:.1}", words[1] + 1.0, words[2], words[3]);
    let cumulative = format!("7 {:.1} {:.1} {:.1}", words[1], words[2] + 1.0, words[3]);
    insta::assert_snapshot!(
        [
            protocol(row, &single, "single"),
            protocol(row, &cumulative, "single")
        ]
        .join("\n")
    );
}

#[test]
fn a_runout_that_differs_between_the_blocks() {
    let text = fs::read_to_string("../../fixtures/sheets/protocol.txt").unwrap();
    let row = text
        .lines()
        .find(|line| line.trim().starts_with("7 "))
        .unwrap();
    let (rest, _) = row.rsplit_once(' ').unwrap();
    let table = text.replacen(row, &format!("{rest} 99.0"), 1);
    let keys = "runout = { file = \"p.txt\", at = \"space\" }";
    let told = problems("p.txt", table.as_bytes(), 44, keys).join("\n");
    assert!(told.contains("line 67: Fr of tooth 7 is "), "{told}");
    let keys = "thickness.per_tooth_um = { file = \"p.txt\" }";
    let told = problems("p.txt", text.as_bytes(), 44, keys).join("\n");
    assert!(
        told.contains("is a pitch protocol, which has no thickness"),
        "{told}"
    );
}
