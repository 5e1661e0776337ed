//! A spring or an anti-roll bar.

use serde::Deserialize;
use toml::Spanned;

use crate::tables::several_notations::written_as_table;

/// A spring along a measured length, or a bar about a measured angle.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, remote = "Self")]
pub struct SpringTable {
    /// The measure.
    pub along: Spanned<String>,
    /// The stiffness, N per unit of length, or N m per unit of angle.
    pub rate: Spanned<f64>,
    /// The preload at the design position, N or N m, positive if it increases the measure.
    #[serde(default = "nothing")]
    pub load: Spanned<f64>,
}

written_as_table!(
    SpringTable,
    "a spring, which has a name: write its lines under [springs.NAME]"
);

fn nothing() -> Spanned<f64> {
    Spanned::new(0..0, 0.0)
}
