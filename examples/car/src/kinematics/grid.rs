//! Kinematics from tables like K&C data: places at intervals, linear between them.

use suspension_core::Signal;
use suspension_core::baked::Outside;

use super::baked::{COORDINATES, Table};

/// The spacing of the grid in bump travel and rack travel, m.
const STEPS: [f64; 2] = [0.010, 0.002];

/// The number of grid points on either side of the design position.
const AROUND: [usize; 2] = [11, 9];

/// Places along the rack.
const COLUMNS: usize = 2 * AROUND[1] + 1;

/// Coordinates at places of bump and steer.
#[derive(Clone, Debug)]
pub struct Grid {
    from: [f64; 2],
    /// Place by place along the second drive, then along the first.
    coordinates: Vec<[f64; COORDINATES]>,
}

impl Grid {
    /// Samples another table.
    ///
    /// # Errors
    ///
    /// [`Outside`] if the other table is smaller.
    pub fn of(other: &impl Table, design: [f64; 2]) -> Result<Self, Outside<f64>> {
        let from = [0, 1].map(|drive| design[drive] - AROUND[drive] as f64 * STEPS[drive]);
        let places =
            (0..=2 * AROUND[0]).flat_map(|bump| (0..COLUMNS).map(move |rack| [bump, rack]));
        let at = |place: [usize; 2]| {
            let value = [0, 1].map(|drive| from[drive] + place[drive] as f64 * STEPS[drive]);
            let [coordinates, ..] = other.motion(&Signal::still(value))?;
            Ok(coordinates)
        };
        Ok(Self {
            coordinates: places.map(at).collect::<Result<_, _>>()?,
            from,
        })
    }

    /// The place before a value along a drive, and how far that is on the way to the next.
    fn before(&self, drive: usize, value: f64) -> Result<(usize, f64), Outside<f64>> {
        let steps = (value - self.from[drive]) / STEPS[drive];
        let last = 2 * AROUND[drive];
        if !(0.0..=last as f64).contains(&steps) {
            let nearest = steps.clamp(0.0, last as f64) * STEPS[drive] + self.from[drive];
            return Err(Outside {
                drive: value,
                nearest,
            });
        }
        let before = (steps as usize).min(last - 1);
        Ok((before, steps - before as f64))
    }
}

impl Table for Grid {
    fn motion(&self, drives: &Signal<[f64; 2]>) -> Result<[[f64; COORDINATES]; 4], Outside<f64>> {
        let [bump, rack] = drives.value;
        let ((row, u), (column, v)) = (self.before(0, bump)?, self.before(1, rack)?);
        let at = |row: usize, column: usize| &self.coordinates[row * COLUMNS + column];
        let corners = [
            at(row, column),
            at(row + 1, column),
            at(row, column + 1),
            at(row + 1, column + 1),
        ];
        let [rate, second_rate] = [drives.rate, drives.second_rate];
        let mut motion = [[0.0; COORDINATES]; 4];
        for coordinate in 0..COORDINATES {
            let [a, b, c, d] = corners.map(|corner| corner[coordinate]);
            let twist = a - b - c + d;
            let per_bump = (b - a + v * twist) / STEPS[0];
            let per_rack = (c - a + u * twist) / STEPS[1];
            let mixed = twist / (STEPS[0] * STEPS[1]);
            let along = |[bump, rack]: [f64; 2]| per_bump * bump + per_rack * rack;
            let all = [
                a + u * (b - a) + v * (c - a) + u * v * twist,
                along(rate),
                along(second_rate) + 2.0 * mixed * rate[0] * rate[1],
                per_bump,
            ];
            for (motion, number) in motion.iter_mut().zip(all) {
                motion[coordinate] = number;
            }
        }
        Ok(motion)
    }
}
