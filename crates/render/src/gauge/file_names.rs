//! What the files of a gear are called.

use gearlash::study::Material;

/// One gauge's readings; the stem of the gear (`gauge_wheel`, `gauge_wheel_most`) comes before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FileName {
    Spans,
    Pins,
    ThreePins,
    Runout,
    PitchOwn,
    SinglePitchOwn,
    PitchDatum,
    SinglePitchDatum,
    Thickness,
    Roll,
}

impl FileName {
    const ALL: [FileName; 10] = [
        FileName::Spans,
        FileName::Pins,
        FileName::ThreePins,
        FileName::Runout,
        FileName::PitchOwn,
        FileName::SinglePitchOwn,
        FileName::PitchDatum,
        FileName::SinglePitchDatum,
        FileName::Thickness,
        FileName::Roll,
    ];

    fn name(self) -> &'static str {
        match self {
            FileName::Spans => "spans",
            FileName::Pins => "pins",
            FileName::ThreePins => "three_pins",
            FileName::Runout => "runout",
            FileName::PitchOwn => "pitch_own",
            FileName::SinglePitchOwn => "single_pitch_own",
            FileName::PitchDatum => "pitch_datum",
            FileName::SinglePitchDatum => "single_pitch_datum",
            FileName::Thickness => "thickness",
            FileName::Roll => "roll",
        }
    }

    /// Start of the ids in the chart of the gear of `stem`.
    pub fn prefix(self, stem: &str) -> String {
        format!("{stem}_{}", self.name())
    }

    /// Its readings.
    pub fn csv(self, stem: &str) -> String {
        format!("{}.csv", self.prefix(stem))
    }

    /// Its chart.
    pub fn svg(self, stem: &str) -> String {
        format!("{}.svg", self.prefix(stem))
    }
}

/// The gear file of the gear of `stem`.
pub(super) fn gear_file_name(stem: &str) -> String {
    format!("{stem}.toml")
}

/// How the files of the gear called `name` begin: `gauge_wheel`, with the material where there are two.
pub fn stem(name: &str, material: Material) -> String {
    match material {
        Material::AsMeasured => format!("gauge_{name}"),
        material => format!("gauge_{name}_{}", material.name()),
    }
}

/// Every name that a run could write for the gear of `stem`.
pub fn possible_files(stem: &str) -> Vec<String> {
    let readings = FileName::ALL.into_iter();
    readings
        .flat_map(|name| [name.csv(stem), name.svg(stem)])
        .chain([gear_file_name(stem)])
        .collect()
}
