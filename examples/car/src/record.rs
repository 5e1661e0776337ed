//! The results of a drive: rows of a table and curves of a plot.

use std::error::Error;
use std::path::Path;

use suspension_core::wheel::camber;

use crate::car::{CORNERS, Car, Controls};
use crate::plot::{Curve, Panel};

/// One instant.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// s.
    pub time: f64,
    /// The position of the sprung mass's centre, m.
    pub position: [f64; 3],
    /// m/s.
    pub speed: f64,
    /// Roll, pitch and yaw, rad: to the right, nose down, to the left.
    pub angles: [f64; 3],
    /// rad/s.
    pub yaw_rate: f64,
    /// m.
    pub rack: f64,
    /// m.
    pub travel: [f64; 4],
    /// On the chassis, rad.
    pub camber: [f64; 4],
    /// N.
    pub load: [f64; 4],
}

impl Row {
    /// Records the car.
    pub fn of(time: f64, car: &Car, controls: &Controls) -> Self {
        let chassis = &car.chassis;
        let (roll, pitch, yaw) = chassis.attitude.euler_angles();
        let corners = car.corners.each_ref();
        Self {
            time,
            position: chassis.position.into(),
            speed: chassis.velocity.norm(),
            angles: [roll, pitch, yaw],
            yaw_rate: chassis.turning.z,
            rack: controls.rack.value,
            travel: corners.map(|corner| corner.travel),
            camber: corners.map(|corner| camber(&corner.outboard())),
            load: corners.map(|corner| corner.ground.load),
        }
    }

    fn cells(&self) -> Vec<String> {
        let whole = [self.time]
            .into_iter()
            .chain(self.position)
            .chain([self.speed]);
        let turned = self.angles.into_iter().chain([self.yaw_rate, self.rack]);
        let wheels =
            (0..4).flat_map(|place| [self.travel[place], self.camber[place], self.load[place]]);
        whole
            .chain(turned)
            .chain(wheels)
            .map(|cell| format!("{cell:.9}"))
            .collect()
    }
}

/// Writes the rows as comma-separated values, units in the names of the columns.
///
/// # Errors
///
/// If the file cannot be written.
pub fn write(rows: &[Row], to: &Path) -> Result<(), Box<dyn Error>> {
    let whole = "time_s x_m y_m z_m speed_m_s roll_rad pitch_rad yaw_rad yaw_rate_rad_s rack_m";
    let mut names: Vec<String> = whole.split(' ').map(str::to_owned).collect();
    for corner in CORNERS {
        names.extend(["travel_m", "camber_rad", "load_N"].map(|name| format!("{corner}_{name}")));
    }
    let mut file = csv::Writer::from_path(to)?;
    file.write_record(&names)?;
    for row in rows {
        file.write_record(row.cells())?;
    }
    file.flush()?;
    Ok(())
}

/// The drive over time.
pub fn panels(rows: &[Row]) -> [Panel; 4] {
    let curve = |name: &str, value: &dyn Fn(&Row) -> f64| Curve {
        name: name.to_owned(),
        line: rows.iter().map(|row| (row.time, value(row))).collect(),
    };
    let corners = |value: &dyn Fn(&Row, usize) -> f64| {
        (0..4)
            .map(|place| curve(&CORNERS[place].replace('_', " "), &|row| value(row, place)))
            .collect()
    };
    let panel = |quantity: &str, curves: Vec<Curve>| Panel {
        across: "time in s".to_owned(),
        quantity: quantity.to_owned(),
        curves,
    };
    [
        panel(
            "rack in mm; yaw rate in deg/s",
            vec![
                curve("rack", &|row| 1e3 * row.rack),
                curve("yaw rate", &|row| row.yaw_rate.to_degrees()),
            ],
        ),
        panel(
            "angle in deg",
            vec![
                curve("roll, to the right", &|row| row.angles[0].to_degrees()),
                curve("pitch, nose down", &|row| row.angles[1].to_degrees()),
            ],
        ),
        panel(
            "travel in mm",
            corners(&|row, place| 1e3 * row.travel[place]),
        ),
        panel(
            "wheel load in kN",
            corners(&|row, place| 1e-3 * row.load[place]),
        ),
    ]
}
