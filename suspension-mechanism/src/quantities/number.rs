//! The numbers that quantities are read in.

use suspension_core::Signal;
use suspension_core::signal;

use crate::dual::Dual;
use crate::mechanism::{DRIVES_AT_ONCE, Gradient, Sensitive};

/// A number in which quantities are read. It carries derivatives; its type determines which ones.
pub trait Number: signal::Number {
    /// A number that does not change.
    fn still(value: f64) -> Self;

    /// A number whose derivatives are not known.
    fn alone(value: f64) -> Self;

    /// The number without its derivatives.
    fn value(self) -> f64;

    /// A number that does not exist, or is not known.
    fn unknown() -> Self {
        Self::alone(f64::NAN)
    }
}

/// The derivatives are those along the rates of a state.
impl Number for Signal<f64> {
    fn still(value: f64) -> Self {
        Self::still(value)
    }

    fn alone(value: f64) -> Self {
        Self {
            value,
            rate: f64::NAN,
            second_rate: f64::NAN,
        }
    }

    fn value(self) -> f64 {
        self.value
    }
}

/// The derivatives are the first ones with respect to some drives.
impl Number for Gradient {
    fn still(value: f64) -> Self {
        Self::still(value)
    }

    fn alone(value: f64) -> Self {
        Dual {
            value,
            rates: [f64::NAN; DRIVES_AT_ONCE],
        }
    }

    fn value(self) -> f64 {
        self.value
    }
}

/// The derivatives are those of a [`Gradient`] along changes of the design.
impl Number for Sensitive {
    fn still(value: f64) -> Self {
        Self::still(Dual::still(value))
    }

    fn alone(value: f64) -> Self {
        let unknown = Dual::still(f64::NAN);
        Dual {
            value: Dual {
                value,
                rates: unknown.rates.map(|_| f64::NAN),
            },
            rates: [unknown; DRIVES_AT_ONCE],
        }
    }

    fn value(self) -> f64 {
        self.value.value
    }
}
