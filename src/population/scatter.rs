//! The distribution of one number over a population.

use crate::numeric::mean;
use statrs::function::erf::{erfc, erfc_inv};
use std::f64::consts::{FRAC_PI_2, SQRT_2};
use std::sync::Arc;

/// Standard deviations from the mean at which the worst case cuts a distribution without an end.
pub const LIMIT_SIGMAS: f64 = 3.0;

/// The share of a Rayleigh distribution below its limit: that of a normal one within [`LIMIT_SIGMAS`].
pub const LIMIT_SHARE: f64 = 0.9973;

/// The scatter of one number from assembly to assembly, in its own unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Scatter {
    law: Law,
    /// The range of the worst case.
    limits: [f64; 2],
}

#[derive(Debug, Clone, PartialEq)]
enum Law {
    Fixed(f64),
    Uniform([f64; 2]),
    Triangular { low: f64, mode: f64, high: f64 },
    Normal { mean: f64, sigma: f64 },
    Rayleigh { scale: f64 },
    Table(Arc<[f64]>),
}

/// Invalid parameters of a distribution.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ScatterError {
    /// Not a finite number.
    #[error("a number is not finite")]
    NotFinite,
    /// Limits in the wrong order.
    #[error("the lower limit {low} lies above the upper one, {high}")]
    Limits {
        /// The lower one.
        low: f64,
        /// The upper one.
        high: f64,
    },
    /// A number outside the limits.
    #[error("{what} {value} lies outside the limits {low} … {high}")]
    Outside {
        /// Name of the quantity.
        what: &'static str,
        /// The number.
        value: f64,
        /// The lower limit.
        low: f64,
        /// The upper limit.
        high: f64,
    },
    /// A spread or an index that is not above 0.
    #[error("{what} is {value}, it must be above 0")]
    NotPositive {
        /// Name of the quantity.
        what: &'static str,
        /// The number.
        value: f64,
    },
    /// An empty table.
    #[error("the table has no values")]
    Empty,
}

/// `error` unless `holds`.
fn require(holds: bool, error: ScatterError) -> Result<(), ScatterError> {
    if holds { Ok(()) } else { Err(error) }
}

fn finite(numbers: &[f64]) -> Result<(), ScatterError> {
    let all = numbers.iter().all(|number| number.is_finite());
    require(all, ScatterError::NotFinite)
}

fn ordered(low: f64, high: f64) -> Result<(), ScatterError> {
    finite(&[low, high])?;
    require(low <= high, ScatterError::Limits { low, high })
}

fn positive(what: &'static str, value: f64) -> Result<(), ScatterError> {
    finite(&[value])?;
    require(value > 0.0, ScatterError::NotPositive { what, value })
}

fn within(what: &'static str, value: f64, low: f64, high: f64) -> Result<(), ScatterError> {
    ordered(low, high)?;
    finite(&[value])?;
    let outside = ScatterError::Outside {
        what,
        value,
        low,
        high,
    };
    require((low..=high).contains(&value), outside)
}

impl Scatter {
    /// Always `value`.
    ///
    /// # Errors
    /// [`ScatterError::NotFinite`].
    pub fn fixed(value: f64) -> Result<Scatter, ScatterError> {
        finite(&[value])?;
        Ok(Scatter {
            law: Law::Fixed(value),
            limits: [value; 2],
        })
    }

    /// Uniform between the limits.
    ///
    /// # Errors
    /// [`ScatterError::Limits`].
    pub fn uniform(low: f64, high: f64) -> Result<Scatter, ScatterError> {
        ordered(low, high)?;
        Ok(Scatter {
            law: Law::Uniform([low, high]),
            limits: [low, high],
        })
    }

    /// Triangular: most frequent at `mode`, zero at the limits.
    ///
    /// # Errors
    /// [`ScatterError::Limits`], [`ScatterError::Outside`].
    pub fn triangular(low: f64, mode: f64, high: f64) -> Result<Scatter, ScatterError> {
        within("the mode", mode, low, high)?;
        Ok(Scatter {
            law: Law::Triangular { low, mode, high },
            limits: [low, high],
        })
    }

    /// Normal, without limits; the worst case uses [`LIMIT_SIGMAS`] either way.
    ///
    /// # Errors
    /// [`ScatterError::NotPositive`].
    pub fn normal(mean: f64, sigma: f64) -> Result<Scatter, ScatterError> {
        finite(&[mean])?;
        positive("the standard deviation", sigma)?;
        let reach = LIMIT_SIGMAS * sigma;
        Ok(Scatter {
            law: Law::Normal { mean, sigma },
            limits: [mean - reach, mean + reach],
        })
    }

    /// Normal about `mean` with the process capability `C_pk = min(high − mean, mean − low)/(3 σ)`: some values exceed the limits.
    ///
    /// # Errors
    /// [`ScatterError::Limits`], [`ScatterError::Outside`], [`ScatterError::NotPositive`].
    pub fn normal_within(
        low: f64,
        high: f64,
        mean: f64,
        cpk: f64,
    ) -> Result<Scatter, ScatterError> {
        within("the mean", mean, low, high)?;
        positive("C_pk", cpk)?;
        let sigma = (high - mean).min(mean - low) / (3.0 * cpk);
        positive("the standard deviation from limits and C_pk", sigma)?;
        Ok(Scatter {
            law: Law::Normal { mean, sigma },
            limits: [low, high],
        })
    }

    /// The length of a vector with two normal components of standard deviation `scale`, such as an eccentricity. The
    /// worst case uses the value that [`LIMIT_SHARE`] of all do not reach.
    ///
    /// # Errors
    /// [`ScatterError::NotPositive`].
    pub fn rayleigh(scale: f64) -> Result<Scatter, ScatterError> {
        positive("the scale", scale)?;
        let law = Law::Rayleigh { scale };
        Ok(Scatter {
            limits: [0.0, law.at(LIMIT_SHARE)],
            law,
        })
    }

    /// A Rayleigh distribution with [`LIMIT_SHARE`] of all values below `high`.
    ///
    /// # Errors
    /// [`ScatterError::NotPositive`].
    pub fn rayleigh_below(high: f64) -> Result<Scatter, ScatterError> {
        positive("the upper limit", high)?;
        Scatter::rayleigh(high / Law::Rayleigh { scale: 1.0 }.at(LIMIT_SHARE))
    }

    /// One of `values`, each as often as it is listed.
    ///
    /// # Errors
    /// [`ScatterError::Empty`], [`ScatterError::NotFinite`].
    pub fn table(values: &[f64]) -> Result<Scatter, ScatterError> {
        finite(values)?;
        let low = values.iter().copied().reduce(f64::min);
        let high = values.iter().copied().reduce(f64::max);
        let (low, high) = low.zip(high).ok_or(ScatterError::Empty)?;
        Ok(Scatter {
            law: Law::Table(Arc::from(values)),
            limits: [low, high],
        })
    }

    /// The value below which the share `p` of all values is, `0 < p < 1`.
    pub fn at(&self, p: f64) -> f64 {
        self.law.at(p)
    }

    /// The values of the worst case at the low end, and at the high end.
    pub fn limits(&self) -> [f64; 2] {
        self.limits
    }

    /// The lowest value; of a normal distribution, that at the least probability.
    pub fn least(&self) -> f64 {
        self.at(f64::MIN_POSITIVE).min(self.limits[0])
    }

    /// Whether no value exceeds the limits.
    pub fn is_bounded(&self) -> bool {
        !matches!(self.law, Law::Normal { .. } | Law::Rayleigh { .. })
    }

    /// The mean of all values.
    pub fn mean(&self) -> f64 {
        match &self.law {
            Law::Fixed(value) => *value,
            Law::Uniform([low, high]) => 0.5 * (low + high),
            Law::Triangular { low, mode, high } => (low + mode + high) / 3.0,
            Law::Normal { mean, .. } => *mean,
            Law::Rayleigh { scale } => scale * FRAC_PI_2.sqrt(),
            Law::Table(values) => mean(values.iter()),
        }
    }

    /// Whether every value is the same.
    pub fn is_fixed(&self) -> bool {
        matches!(self.law, Law::Fixed(_))
    }
}

impl Law {
    /// The inverse of the cumulative distribution.
    fn at(&self, p: f64) -> f64 {
        match self {
            Law::Fixed(value) => *value,
            Law::Uniform([low, high]) => low + p * (high - low),
            Law::Triangular { low, mode, high } => {
                let width = high - low;
                // F(x) = (x − low)²/(width (mode − low)) up to the mode.
                if p * width <= mode - low {
                    low + (p * width * (mode - low)).sqrt()
                } else {
                    high - ((1.0 - p) * width * (high - mode)).sqrt()
                }
            }
            Law::Normal { mean, sigma } => mean + sigma * standard_normal(p),
            // F(x) = 1 − exp(−x²/(2 scale²)).
            Law::Rayleigh { scale } => scale * (-2.0 * (-p).ln_1p()).sqrt(),
            Law::Table(values) => {
                let index = (p * values.len() as f64) as usize;
                values[index.min(values.len() - 1)]
            }
        }
    }
}

/// The standard normal deviate below which the share `p` is.
pub(super) fn standard_normal(p: f64) -> f64 {
    -SQRT_2 * erfc_inv(2.0 * p)
}

/// The share below the standard normal deviate `z`.
pub(super) fn normal_share(z: f64) -> f64 {
    0.5 * erfc(-z / SQRT_2)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Normal: quantiles of the tables of any handbook. The others: their inverse CDF by hand.
    #[test]
    fn quantiles_are_those_of_the_distributions() {
        let uniform = Scatter::uniform(-1.0, 3.0).unwrap();
        let triangular = Scatter::triangular(0.0, 1.0, 4.0).unwrap();
        let rayleigh = Scatter::rayleigh(2.0).unwrap();
        let below = Scatter::rayleigh_below(10.0).unwrap();
        let table = Scatter::table(&[1.0, 2.0, 5.0, 7.0]).unwrap();
        // C_pk = 1.5 and the nearer limit 9 away: σ = 2.
        let within = Scatter::normal_within(-10.0, 20.0, -1.0, 1.5).unwrap();
        assert_eq!(within.limits(), [-10.0, 20.0]);
        let mut cases = vec![
            (within, 0.8413447460685429, 1.0, 1e-12),
            (uniform, 0.25, 0.0, 0.0),
            // F(1) = 1/4; above it 1 − (4 − x)²/12.
            (triangular.clone(), 0.25, 1.0, 1e-15),
            (triangular, 1.0 - 1.0 / 12.0, 3.0, 1e-15),
            (rayleigh, 1.0 - (-0.5f64).exp(), 2.0, 1e-14),
            (below, LIMIT_SHARE, 10.0, 1e-13),
            (table.clone(), 0.1, 1.0, 0.0),
            (table.clone(), 0.3, 2.0, 0.0),
            (table.clone(), 0.6, 5.0, 0.0),
            (table, 0.9, 7.0, 0.0),
        ];
        for (p, z) in [
            (0.5, 0.0),
            (0.975, 1.959963984540054),
            (0.001349898031630095, -3.0),
            (0.8413447460685429, 1.0),
        ] {
            cases.push((Scatter::normal(2.0, 0.5).unwrap(), p, 2.0 + 0.5 * z, 1e-12));
            // The crate's error function is good to 1.4e-11 (seen here).
            assert!((normal_share(z) - p).abs() < 1e-10);
        }
        for (scatter, p, expected, within) in cases {
            let off = (scatter.at(p) - expected).abs();
            assert!(off <= within, "{scatter:?} at {p}: {off}");
        }
    }

    #[test]
    fn numbers_that_describe_nothing_are_refused() {
        use ScatterError::{Empty, Limits, NotFinite, NotPositive, Outside};
        let error = |scatter: Result<Scatter, ScatterError>| scatter.unwrap_err();
        assert!(matches!(error(Scatter::fixed(f64::NAN)), NotFinite));
        assert!(matches!(error(Scatter::uniform(1.0, 0.0)), Limits { .. }));
        let beyond = Scatter::triangular(0.0, 2.0, 1.0);
        assert!(matches!(error(beyond), Outside { .. }));
        for scatter in [
            Scatter::normal(0.0, 0.0),
            Scatter::normal_within(0.0, 1.0, 1.0, 1.0),
            Scatter::rayleigh(-1.0),
        ] {
            assert!(matches!(error(scatter), NotPositive { .. }));
        }
        assert!(matches!(error(Scatter::table(&[])), Empty));
    }
}
