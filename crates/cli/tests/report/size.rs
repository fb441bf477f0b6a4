//! How large a page gets (issue 6): 704 poses up to 2 MB, 28 896 up to 8 MB.

use super::page;

/// z₁ and z₂ at `a` and a sweep over `revolutions`, 16 poses a pitch; runout and pitch deviations make every pose differ.
fn pair([wheel, pinion]: [u32; 2], a: f64, revolutions: &str) -> String {
    let gear = |name: &str, teeth: u32| {
        let wave = |ahead: f64| {
            let value = |i: u32| {
                let turn = f64::from(i) / f64::from(teeth) * std::f64::consts::TAU;
                format!("{:.2}", 3.0 * (3.0 * turn + ahead).sin())
            };
            (0..teeth).map(value).collect::<Vec<_>>().join(", ")
        };
        format!(
            "[{name}]\nteeth = {teeth}\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n\
             thickness = {{ allowance_um = -60 }}\nrunout = {{ total_um = 10, high_tooth = 2 }}\n\
             [{name}.pitch]\nkind = \"cumulative\"\nright_um = [{}]\nleft_um = [{}]\n",
            wave(0.0),
            wave(0.7)
        )
    };
    format!(
        "{}{}[assembly]\ncenter_distance_mm = {a}\n[sweep]\nrevolutions = \"{revolutions}\"\n",
        gear("wheel", wheel),
        gear("pinion", pinion)
    )
}

#[test]
fn one_revolution_of_44_teeth() {
    let page = page(&pair([44, 44], 132.1, "wheel"), &["--no-certify"]);
    // 704 right-flank poses, as many left-flank ones for the curves, and both extremes of the cycle.
    assert!(page.contains("Over 1410 poses"));
    assert!(page.len() <= 2_000_000, "{} bytes", page.len());
}

#[test]
fn a_hunting_cycle_of_86_and_21_teeth() {
    let page = page(&pair([86, 21], 160.6, "hunting"), &["--no-certify"]);
    // 28 896 right-flank poses, as many left-flank ones, and both extremes of the cycle.
    assert!(page.contains("Over 57794 poses"));
    assert!(page.len() <= 8_000_000, "{} bytes", page.len());
    // All runs are in the mesh, each with every third pose and its extremes.
    assert!(page.contains("of 57792 poses can be looked at here: of each run every 3rd"));
    let data = page
        .split("id=\"viewer-data\">")
        .nth(1)
        .expect("the mesh is in it");
    let data: serde_json::Value =
        serde_json::from_str(data.split("</script>").next().unwrap()).unwrap();
    let run = &data["runs"][0];
    assert_eq!(run["of"], 57_792);
    let column = |name: &str| run[name].as_array().unwrap();
    let numbers: Vec<u64> = column("number")
        .iter()
        .map(|n| n.as_u64().unwrap())
        .collect();
    assert!(numbers.is_sorted() && (19_264..19_268).contains(&numbers.len()));
    for name in ["chart_x", "j_wt_um", "pose_text", "flank"] {
        assert_eq!(column(name).len(), numbers.len(), "{name}");
    }
    // Left-flank poses start over at the first pitch.
    let first_left = numbers.iter().position(|number| *number == 28_897).unwrap();
    let flank = column("flank")[first_left].as_u64().unwrap() as usize;
    assert_eq!(data["words"]["flank"][flank], "left");
    assert_eq!(column("chart_x")[first_left], column("chart_x")[0]);
}
