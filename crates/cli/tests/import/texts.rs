//! Text files.

use super::*;

fn comma(value: f64) -> String {
    format!("{value:.1}").replace('.', ",")
}

/// A machine's export as German Excel saves it: `sep=;`, comments, decimal commas, Windows-1252.
#[test]
fn german_csv_with_comments() {
    let (left, right) = (cumulative(LEFT), cumulative(RIGHT));
    let mut text = "sep=;\r\n# Export 12.03.2026, Gerät 3\r\nAuftrag;4711;;\r\nZahn;Teilungs-Summenabweichung links in µm;\
                    Teilungs-Summenabweichung rechts in µm;Datum\r\n"
        .to_owned();
    for tooth in 0..TEETH as usize {
        text += &format!(
            "{};{};{};12.03.2026\r\n",
            tooth + 1,
            comma(left[tooth]),
            comma(right[tooth])
        );
    }
    text += "# Ende der Messung\r\nMax;1,5;1,5;\r\nMittelwert;0,0;0,0;\r\n";
    // Windows-1252 has these letters at their Unicode numbers.
    let bytes: Vec<u8> = text.chars().map(|letter| letter as u8).collect();
    let shop = Shop::new("p.csv", bytes);
    let keys = "pitch = { kind = \"cumulative\", file = \"p.csv\" }";
    shop.is(keys, &listed("cumulative"), &[], "");
}

#[test]
fn english_csv_with_a_title_and_statistics() {
    let mut text = "Pitch report\nMachine,PNC 65,,\n\nTooth,fp left (um),fp right (um),Fp left (um),Fp right (um)\n".to_owned();
    let lists = [
        single(LEFT),
        single(RIGHT),
        cumulative(LEFT),
        cumulative(RIGHT),
    ];
    for tooth in 0..TEETH as usize {
        let values = lists.iter().map(|list| format!(",{:.1}", list[tooth]));
        text += &format!("{}{}\n", tooth + 1, values.collect::<String>());
    }
    text += "\nmax,1,1,1,1\nrange,2,2,2,2\n";
    let shop = Shop::new("p.csv", text);
    let keys = "pitch = { kind = \"cumulative\", file = \"p.csv\" }";
    shop.is(keys, &listed("cumulative"), &[], "");
    let keys = "pitch = { kind = \"single\", file = \"p.csv\" }";
    assert_eq!(
        shop.check(keys, "").unwrap().0,
        shop.check(&listed("single"), "").unwrap().0
    );
}

/// Spans have three decimals: their comma is a decimal comma, as no span is 22 m long.
#[test]
fn spans_with_three_decimals_between_tabs() {
    let mm: Vec<f64> = (0..TEETH)
        .map(|tooth| f64::from(22_900 + tooth % 4) / 1000.0)
        .collect();
    let rows = (1..)
        .zip(&mm)
        .map(|(tooth, mm): (u32, &f64)| format!("{tooth}\t{mm:.3}\tok\n").replace('.', ","));
    let text = format!(
        "Zahnweite über 3 Zähne\nerster Zahn\tWk [mm]\tBefund\n{}Mittelwert\t22,902\t\n",
        rows.collect::<String>()
    );
    let shop = Shop::new("w.txt", text);
    let keys = "thickness.span = { teeth = 3, file = \"w.txt\" }";
    let expected = format!("thickness.span = {{ teeth = 3, mm = {mm:?} }}");
    shop.is(keys, &expected, &[], "teeth = 3");
}
