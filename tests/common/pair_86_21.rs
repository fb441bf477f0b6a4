//! 86/21 teeth, module 3: its tips reach the fillets where the centre distance is short.

use std::path::PathBuf;

/// The pair at `distance`, 24 phases of a pitch.
pub fn pair_86_21(distance: f64) -> String {
    format!(
        "[wheel]\nteeth = 86\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n\
         [pinion]\nteeth = 21\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n\
         [assembly]\ncenter_distance_mm = {distance}\n\
         [sweep]\nmating = [[1, 1]]\nfraction = [{}]\n",
        (0..24)
            .map(|phase| (f64::from(phase) / 24.0).to_string())
            .collect::<Vec<_>>()
            .join(", ")
    )
}

/// `text` as a file of a folder.
pub fn written(text: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("pair.toml");
    std::fs::write(&file, text).unwrap();
    (folder, file)
}
