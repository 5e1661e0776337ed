//! The tyre: a radial spring and damper, and the brush model in the plane of the road.
//!
//! The brush model with a parabolic distribution of pressure, equal in both directions, is that of E. Fiala (Seitenkräfte am rollenden
//! Luftreifen, VDI-Zeitschrift 96, 1954) in the form of H. B. Pacejka, Tire and Vehicle Dynamics, 3rd edition 2012, section 3.2: with the
//! slip `s`, the stiffness `c` per unit of load and the friction `mu`
//!
//! ```text
//! F = mu Fz (3 t - 3 t^2 + t^3)  against the slip,   t = c |s| / (3 mu),   F = mu Fz  for t > 1.
//! ```
//!
//! The slip follows the sliding velocity `v` of the tread over a length `l`, `l ds/dt + |vx| s = v`: the single contact point transient model
//! of the same book, section 7.2. With it a tyre at rest acts as a spring, so that a car can stand still. The model leaves out load-dependent
//! stiffness, camber thrust, aligning moment and rolling resistance; the rolling radius is the loaded one.

use nalgebra::Vector2;

/// A tyre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tyre {
    /// Unloaded radius, m.
    pub radius: f64,
    /// The stiffness of the radial spring, N/m.
    pub stiffness: f64,
    /// The coefficient of the radial damper, N s/m.
    pub damping: f64,
    /// Slip stiffness as a part of the load, 1/1.
    pub slip_stiffness: f64,
    /// Friction at the nominal load.
    pub friction: f64,
    /// The relative loss of friction per unit of load above the nominal one.
    pub friction_loss: f64,
    /// N.
    pub nominal_load: f64,
    /// Relaxation length, m.
    pub relaxation: f64,
}

impl Tyre {
    /// Returns the load for a deflection and its rate; zero off the ground.
    pub fn load(&self, deflection: f64, rate: f64) -> f64 {
        if deflection > 0.0 {
            (self.stiffness * deflection + self.damping * rate).max(0.0)
        } else {
            0.0
        }
    }

    /// Returns the slip after a time in which the tread slides with a velocity (ahead, to the left) while the wheel travels
    /// ahead with a speed. The step is implicit in the slip, so it is stable at any speed. A tread that slides fully is not
    /// deflected further.
    pub fn slip(
        &self,
        slip: Vector2<f64>,
        sliding: Vector2<f64>,
        speed: f64,
        dt: f64,
    ) -> Vector2<f64> {
        let next = (slip * self.relaxation + sliding * dt) / (self.relaxation + speed.abs() * dt);
        next.cap_magnitude(3.0 * self.friction / self.slip_stiffness)
    }

    /// The force of the road in its plane (ahead, to the left), N.
    pub fn force(&self, slip: Vector2<f64>, load: f64) -> Vector2<f64> {
        let friction =
            self.friction * (1.0 - self.friction_loss * (load / self.nominal_load - 1.0)).max(0.1);
        let per_slip = self.slip_stiffness / (3.0 * friction);
        let part = per_slip * slip.norm();
        // (3 t - 3 t^2 + t^3) / t, and 1 / t if all of the tread slides.
        let shape = if part < 1.0 {
            3.0 - 3.0 * part + part * part
        } else {
            1.0 / part
        };
        -slip * (friction * load * per_slip * shape)
    }
}
