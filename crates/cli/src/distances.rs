//! `--center-distance`: one centre distance, or a scan.

use gearlash_input::spec::MAX_DISTANCES;

/// Centre distances from the command line, mm.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Distances(pub Vec<f64>);

impl std::fmt::Display for Distances {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match &self.0[..] {
            [first, .., last] => write!(f, "{first} … {last}"),
            all => all.iter().try_for_each(|one| write!(f, "{one}")),
        }
    }
}

/// `132.1`, or `132.0..132.4:0.01`: from, to (included), step.
///
/// Values are rounded to the decimals that were typed, so that 132.0 + 3 · 0.01 is 132.03.
pub(super) fn parse(text: &str) -> Result<Distances, String> {
    const FORM: &str = "a centre distance in mm, or a scan FROM..TO:STEP such as 132.0..132.4:0.01";
    let Some((from, rest)) = text.split_once("..") else {
        return one(text)
            .map(|a| Distances(vec![a]))
            .map_err(|wrong| format!("{wrong}; give {FORM}"));
    };
    let (to, step) = rest.split_once(':').ok_or(FORM)?;
    let (Ok(first), Ok(last), Ok(width)) = (one(from), one(to), one(step)) else {
        return Err(FORM.to_owned());
    };
    if last < first {
        return Err(format!(
            "the scan ends at {last}, before it starts at {first}; {FORM}"
        ));
    }
    // A step that ends within a thousandth of TO includes it.
    let steps = ((last - first) / width + 1e-3).floor();
    if steps >= MAX_DISTANCES as f64 {
        return Err(format!(
            "{} centre distances, allowed are up to {MAX_DISTANCES}: take a wider step",
            steps + 1.0
        ));
    }
    let decimals = [from, step].map(|text| text.trim().split_once('.').map_or(0, |(_, d)| d.len()));
    let scale = 10f64.powi(decimals[0].max(decimals[1]).min(12) as i32);
    let value = |i: u32| ((first + f64::from(i) * width) * scale).round() / scale;
    Ok(Distances((0..=steps as u32).map(value).collect()))
}

/// One centre distance, mm.
pub(super) fn one(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(mm) if mm.is_finite() && mm > 0.0 => Ok(mm),
        Ok(_) => {
            Err("a centre distance is above 0, the distance between the two axes in mm".to_owned())
        }
        Err(_) => Err("this is no number".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scan_has_round_values_and_both_ends() {
        let Distances(scan) = parse("132.0..132.4:0.01").unwrap();
        assert_eq!(scan.len(), 41);
        assert_eq!((scan[0], scan[3], scan[40]), (132.0, 132.03, 132.4));
        assert_eq!(parse("132.1"), Ok(Distances(vec![132.1])));
        assert_eq!(parse("1..2:0.3").unwrap().0, [1.0, 1.3, 1.6, 1.9]);
    }

    #[test]
    fn what_is_not_a_scan() {
        let wrong = "|x|-1|nan|132..|132..131:0.1|1..2|1..2:0|1..2:-1|1..9:1e-5";
        for text in wrong.split('|') {
            assert!(parse(text).is_err(), "{text}");
        }
    }
}
