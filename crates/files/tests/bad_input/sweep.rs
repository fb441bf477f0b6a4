use super::*;

#[test]
fn matings() {
    expect(
        &and("[sweep]\nmating = [[1, 1], [20, 31], [21, 31]]"),
        &[
            problem(
                "sweep.mating",
                "[20, 31]",
                &["value 2", "pinion tooth is 31", "1 … 30"],
                "from 1",
            ),
            problem(
                "sweep.mating",
                "[21, 31]",
                &[
                    "value 3",
                    "wheel tooth is 21, allowed is a whole number, 1 … 20",
                    "pinion tooth is 31",
                ],
                "from 1",
            ),
        ],
    );
    let help = "wheel tooth and pinion tooth";
    expect(
        &and("[sweep]\nmating = [[0, 1], [20, 31], [1], [1, 2, 3], 4, [1.5, 1]]"),
        &[
            problem(
                "sweep.mating",
                "[0, 1]",
                &["value 1", "a whole number, 1 … 10 000"],
                help,
            ),
            problem("sweep.mating", "[1]", &["length 1, expected 2"], help),
            problem("sweep.mating", "[1, 2, 3]", &["length 3, expected 2"], help),
            problem(
                "sweep.mating",
                "4",
                &["value 5", "a list of 2 whole numbers"],
                help,
            ),
            problem("sweep.mating", "[1.5, 1]", &["not whole"], help),
            problem(
                "sweep.mating",
                "[20, 31]",
                &["value 2", "pinion tooth is 31"],
                "from 1",
            ),
        ],
    );
    expect(
        &and("[sweep]\nmating = []\nfraction = []"),
        &[
            problem("sweep.mating", "[]", &["at least one"], help),
            problem("sweep.fraction", "[]", &["at least one"], "pitches"),
        ],
    );
    expect(
        &and("[sweep]\nmating = [[1, 1]]\nfraction = [0, inf, 1000.1]"),
        &[
            problem("sweep.fraction", "inf", &["value 2", "not finite"], "pitch"),
            problem("sweep.fraction", "1000.1", &["−1000 … 1000"], "pitch"),
        ],
    );
}

#[test]
fn keys_that_do_not_go_together() {
    expect(
        &and("[sweep]\nmating = [[1, 1]]\nrevolutions = \"wheel\""),
        &[problem(
            "sweep.mating",
            "[[1, 1]]",
            &[
                "together with revolutions",
                "one of `mating`, `revolutions` or `phases`",
            ],
            "remove",
        )],
    );
    expect(
        &and("[sweep]\nrevolutions = \"wheel\"\nfraction = [0.5]"),
        &[problem(
            "sweep.fraction",
            "[0.5]",
            &["given without mating"],
            "add `mating`",
        )],
    );
    expect(
        &and("[sweep]\nmating = [[1, 1]]\nsteps_per_pitch = 4\nstart = [1, 1]"),
        &[
            problem(
                "sweep.steps_per_pitch",
                "4",
                &["given without revolutions"],
                "add `revolutions`",
            ),
            problem(
                "sweep.start",
                "[1, 1]",
                &["given without revolutions"],
                "add `revolutions`",
            ),
        ],
    );
    expect(
        &and("[sweep]\nsteps_per_pitch = 4"),
        &[problem(
            "sweep.steps_per_pitch",
            "4",
            &["given without revolutions or phases"],
            "add",
        )],
    );
}

#[test]
fn revolutions() {
    expect(
        &and("[sweep]\nrevolutions = \"whel\"\nsteps_per_pitch = 1001\nstart = [1, 31]"),
        &[
            problem(
                "sweep.revolutions",
                "\"whel\"",
                &["\"wheel\" or \"hunting\""],
                "mean \"wheel\"",
            ),
            problem("sweep.steps_per_pitch", "1001", &["1 … 1000"], "16"),
            problem(
                "sweep.start",
                "[1, 31]",
                &["pinion tooth is 31", "1 … 30"],
                "from 1",
            ),
        ],
    );
}

/// lcm(997, 991) pitches × 16 × 2 materials = 31 616 864 poses.
#[test]
fn too_many_poses() {
    let text = GOOD
        .replace(
            "teeth = 20",
            "teeth = 997\nthickness.allowance_um = { min = -9, max = -5 }",
        )
        .replace("teeth = 30", "teeth = 991")
        .replace("75.2", "2982.1");
    expect(
        &(text + "[sweep]\nrevolutions = \"hunting\""),
        &[problem(
            "sweep",
            "hunting",
            &[
                "31616864 poses",
                "86 GB of result",
                "up to 10 million, 27 GB",
            ],
            "fewer",
        )],
    );
}
