//! Published: FVA Workbench examples 1-3 (z 27/51 and 23/34), 20° in the normal section. Lengths in mm.

/// A gear and its dimensions.
pub struct Published {
    pub teeth: u32,
    pub module: f64,
    pub helix_deg: f64,
    pub shift: f64,
    /// Diameter of the balls or pins.
    pub ball: f64,
    /// Over two balls and over two pins, of the nominal gear.
    pub over_balls: f64,
    pub over_pins: f64,
    /// Allowances of the dimension over balls for −115 and −165 µm of thickness in the normal section.
    pub allowances: [f64; 2],
}

pub const PUBLISHED: [Published; 4] = [
    Published {
        teeth: 27,
        module: 4.5,
        helix_deg: 21.0,
        shift: 0.3,
        ball: 9.0,
        over_balls: 147.07716569057362,
        over_pins: 147.3111662932581,
        allowances: [-0.23885299485385758, -0.34313756843801],
    },
    Published {
        teeth: 51,
        module: 4.5,
        helix_deg: 21.0,
        shift: 0.1628301985916763,
        ball: 8.0,
        over_balls: 258.8158215092951,
        over_pins: 258.9348349547439,
        allowances: [-0.28157221563412804, -0.4044946722594318],
    },
    Published {
        teeth: 23,
        module: 6.5,
        helix_deg: 10.0,
        shift: 0.3,
        ball: 12.0,
        over_balls: 172.6420925797242,
        over_pins: 173.01746144670994,
        allowances: [-0.23468449671668168, -0.3371109063772053],
    },
    Published {
        teeth: 34,
        module: 6.5,
        helix_deg: 10.0,
        shift: 0.0014790906759136746,
        ball: 12.0,
        over_balls: 242.8440796716534,
        over_pins: 242.8440796716534,
        allowances: [-0.2675679628538603, -0.3843866614119804],
    },
];
