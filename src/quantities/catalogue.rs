//! The catalogue: each quantity is one row. Signs and formulas are those of [`suspension_core::wheel`] and
//! [`suspension_core::body`].

use nalgebra::Vector3;
use suspension_core::body::{angular_acceleration, angular_velocity};
use suspension_core::wheel::{camber, camber_to_ground, caster, kingpin_angle, toe};

use crate::mechanism::{Names, State, WheelPoints};
use crate::quantities::kind::Kind;
use crate::quantities::quantity::{Quantity, Reading, Shown};
use crate::quantities::readings::{
    each, number, of_kingpin, of_kingpin_and_spin_axis, of_spin_axis, point, vector,
};

/// Makes a `static` of each row and the list of all.
macro_rules! catalogue {
    ($($row:ident: $title:literal { $($field:tt)* })+) => {
        $(
            #[doc = concat!("The row \"", $title, "\".")]
            pub static $row: Quantity = Quantity { title: $title, $($field)* };
        )+

        /// All rows, in the order in which tables have them.
        pub static CATALOGUE: &[&Quantity] = &[$(&$row),+];
    };
}

catalogue! {
    TIME: "time" {
        name: "t",
        sign: "",
        definition: "the instant",
        source: "the motion file",
        shown: Shown::InBoth,
        read: |_| number(Kind::Time, |state| state.t),
    }
    DRIVES: "drives" {
        name: "",
        sign: "",
        definition: "what each prescribes; one that a measure stands in for as the mechanism has it",
        source: "`drive` of the listing",
        shown: Shown::InBoth,
        read: |names| {
            let drives = names.drives.iter();
            let drives = drives.map(|drive| (drive.name.as_str(), drive.kind.into()));
            each(drives, |state, drive| state.drives[drive])
        },
    }
    POSITIONS: "free points" {
        name: "",
        sign: "x forward, y left, z up",
        definition: "the unknowns of the equations",
        source: "`free` of the listing",
        shown: Shown::InTables,
        read: |names| of_free_points(names, Kind::Length),
    }
    VELOCITIES: "velocities of free points" {
        name: "",
        sign: "",
        definition: "J qdot = -dF/du udot",
        source: "Attia 2003, eq. (3)",
        shown: Shown::InTables,
        read: |names| of_free_points(names, Kind::Velocity),
    }
    ACCELERATIONS: "accelerations of free points" {
        name: "",
        sign: "",
        definition: "J qddot = -C(qdot, qdot) - dF/du uddot",
        source: "Attia 2003, eq. (7) and (8)",
        shown: Shown::InTables,
        read: |names| of_free_points(names, Kind::Acceleration),
    }
    OMEGA: "angular velocity of the wheel's carrier" {
        name: "omega",
        sign: "right-handed",
        definition: "the least-squares fit of v = v0 + omega x r over three points",
        source: "Attia 2003, eq. (9), without its 0/0",
        shown: Shown::InTables,
        read: |names| of_carrier(names, Kind::AngularVelocity, |[omega, _]| omega),
    }
    ALPHA: "angular acceleration of the wheel's carrier" {
        name: "alpha",
        sign: "right-handed",
        definition: "the least-squares fit of a = a0 + alpha x r + omega x (omega x r) over three points",
        source: "Attia 2003, eq. (10), without its 0/0",
        shown: Shown::InTables,
        read: |names| of_carrier(names, Kind::AngularAcceleration, |[_, alpha]| alpha),
    }
    MARKERS: "markers, with velocities and accelerations" {
        name: "",
        sign: "x forward, y left, z up",
        definition: "points carried by bodies",
        source: "`point` of the listing",
        shown: Shown::InTables,
        read: |names| {
            let markers = names.chassis + names.free..names.points.len();
            let of_one = |marker| RATES.map(|kind| point(names, marker, kind)).into_iter();
            markers.flat_map(of_one).flatten().collect()
        },
    }
    CENTRE: "wheel centre" {
        name: "centre",
        sign: "x forward, y left, z up",
        definition: "the last point of the spin axis",
        source: "`wheel` of the listing",
        shown: Shown::InSummaries,
        read: |names| names.wheel.map_or_else(Vec::new, |WheelPoints { axis: [_, centre], .. }| {
            vector(None, Kind::Length, move |state| state.position(centre))
        }),
    }
    KINGPIN: "kingpin angle" {
        name: "kingpin",
        sign: "positive where the top of the kingpin leans inboard",
        definition: "from the vertical in the y-z plane, atan2(-k_y, k_z) on the left",
        source: "ISO 8855; Attia 2003, angle alpha, which has the opposite sign",
        shown: Shown::InBoth,
        read: |names| of_kingpin_and_spin_axis(names, kingpin_angle),
    }
    CASTER: "caster angle" {
        name: "caster",
        sign: "positive where the top of the kingpin leans rearwards",
        definition: "from the vertical in the x-z plane, atan2(-k_x, k_z)",
        source: "ISO 8855",
        shown: Shown::InBoth,
        read: |names| of_kingpin(names, caster),
    }
    CAMBER: "camber angle" {
        name: "camber",
        sign: "positive where the top of the wheel leans outboard",
        definition: "of the spin axis from the y axis in the y-z plane, atan2(-s_z, |s_y|)",
        source: "ISO 8855; Attia 2003, angle beta",
        shown: Shown::InBoth,
        read: |names| of_spin_axis(names, camber),
    }
    CAMBER_TO_GROUND: "camber angle to the ground" {
        name: "camber_to_ground",
        sign: "positive where the top of the wheel leans outboard",
        definition: "of the spin axis from the ground, asin(-s_z / |s|); differs where the wheel is steered",
        source: "Adams/Car",
        shown: Shown::InTables,
        read: |names| of_spin_axis(names, camber_to_ground),
    }
    TOE: "toe angle" {
        name: "toe",
        sign: "positive where the front of the wheel points inboard",
        definition: "of the spin axis from the y axis in the x-y plane, atan2(s_x, |s_y|)",
        source: "ISO 8855",
        shown: Shown::InBoth,
        read: |names| of_spin_axis(names, toe),
    }
    MEASURES: "measures" {
        name: "",
        sign: "",
        definition: "what the linkage measures",
        source: "`measure` of the listing",
        shown: Shown::InBoth,
        read: |names| {
            let measures = names.measures.iter();
            let measures = measures.map(|measure| (measure.name.as_str(), measure.kind.into()));
            each(measures, |state, measure| state.measures[measure])
        },
    }
    ITERATIONS: "iterations of Newton's method" {
        name: "iterations",
        sign: "",
        definition: "from the instant before, steps in between included",
        source: "the solver",
        shown: Shown::InTables,
        read: |_| number(Kind::Count, |state| state.iterations as f64),
    }
    RESIDUAL: "largest residual" {
        name: "residual",
        sign: "",
        definition: "of any equation, (|d|^2 - L^2) / (2 L) of a length",
        source: "the solver",
        shown: Shown::InTables,
        read: |_| number(Kind::Length, |state| state.residual),
    }
}

/// What is read of each marker.
const RATES: [Kind; 3] = [Kind::Length, Kind::Velocity, Kind::Acceleration];

fn of_free_points(names: &Names, kind: Kind) -> Vec<Reading> {
    let free = names.chassis..names.chassis + names.free;
    free.flat_map(|index| point(names, index, kind)).collect()
}

/// A rate of the body that carries the wheel: one of its angular velocity and acceleration.
fn of_carrier(
    names: &Names,
    kind: Kind,
    which: fn([Vector3<f64>; 2]) -> Vector3<f64>,
) -> Vec<Reading> {
    let Some(WheelPoints { carrier, .. }) = names.wheel else {
        return Vec::new();
    };
    vector(None, kind, move |state| which(rotation(state, carrier)))
}

/// Angular velocity and acceleration of the body of three points; not finite where they are in line.
fn rotation(state: &State, body: [usize; 3]) -> [Vector3<f64>; 2] {
    let points = &state.points;
    let [at, rates, seconds] =
        [&points.value, &points.rate, &points.second_rate].map(|all| body.map(|point| all[point]));
    let omega = angular_velocity(&at, &rates);
    let alpha = omega.and_then(|omega| angular_acceleration(&at, &omega, &seconds));
    [omega, alpha].map(|found| found.unwrap_or_else(|| Vector3::repeat(f64::NAN)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanism::Unit;
    use crate::quantities::quantity::columns;

    /// Three points, the last a marker and the wheel centre.
    fn names(wheel: bool, kingpin: bool) -> Names {
        Names {
            points: ["a", "b", "c"].map(str::to_owned).into(),
            chassis: 1,
            free: 1,
            wheel: wheel.then_some(WheelPoints {
                axis: [1, 2],
                carrier: [0, 1, 2],
            }),
            kingpin: kingpin.then_some([0, 1]),
            ..Names::default()
        }
    }

    fn tabled(names: &Names) -> Vec<String> {
        let all = columns(CATALOGUE, names).into_iter();
        let tabled = all.filter(|column| column.quantity.shown != Shown::InSummaries);
        tabled
            .map(|column| column.csv_name(Unit::Millimetre))
            .collect()
    }

    #[test]
    fn what_a_linkage_lacks_has_no_columns() {
        let bare = tabled(&names(false, false));
        let wheel = tabled(&names(true, false));
        let kingpin = tabled(&names(false, true));
        let both = tabled(&names(true, true));
        let more = |than: &[String], all: &[String]| {
            let new = all.iter().filter(|name| !than.contains(name));
            new.cloned().collect::<Vec<_>>().join(" ")
        };
        assert_eq!(
            bare.join(" "),
            "t_s b_x b_y b_z b_vx b_vy b_vz b_ax b_ay b_az \
             c_x c_y c_z c_vx c_vy c_vz c_ax c_ay c_az iterations residual_mm"
        );
        assert_eq!(
            more(&bare, &wheel),
            "omega_x omega_y omega_z alpha_x alpha_y alpha_z camber_rad camber_to_ground_rad toe_rad"
        );
        assert_eq!(more(&bare, &kingpin), "caster_rad");
        assert_eq!(more(&wheel, &both), "kingpin_rad caster_rad");
    }

    #[test]
    fn every_row_says_what_it_is_and_where_from() {
        let mut names: Vec<_> = CATALOGUE.iter().map(|row| row.name).collect();
        names.retain(|name| !name.is_empty());
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), count, "no two rows have one name");
        for row in CATALOGUE {
            assert!(!row.title.is_empty(), "{}", row.name);
            assert!(
                !row.definition.is_empty() && !row.source.is_empty(),
                "{}",
                row.title
            );
        }
    }
}
