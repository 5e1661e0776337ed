//! The catalogue of quantities for linkages with and without a wheel.

use suspension_mechanism::mechanism::{Length, Names, Unit, Wheel, WheelPoints};
use suspension_mechanism::quantities::{Shown, catalogue, columns};

/// Three points, the last a marker and the wheel centre.
fn names(wheel: bool, kingpin: bool) -> Names {
    let only = Wheel {
        points: WheelPoints {
            axis: [1, 2],
            carrier: [0, 1, 2],
            kingpin: kingpin.then_some([0, 1]),
        },
        ..Wheel::default()
    };
    Names {
        points: ["a", "b", "c"].map(str::to_owned).into(),
        chassis: 1,
        free: 1,
        wheels: wheel.then_some(only).into_iter().collect(),
        ..Names::default()
    }
}

fn tabled(names: &Names) -> Vec<String> {
    let unit = Unit {
        length: Length::Millimetre,
        ..Unit::METRE
    };
    let all = columns(catalogue(), names).into_iter();
    let tabled = all.filter(|column| column.quantity.shown != Shown::InSummaries);
    tabled.map(|column| column.csv_name(unit)).collect()
}

#[test]
fn quantities_of_missing_wheel_or_kingpin_have_no_columns() {
    let bare = tabled(&names(false, false));
    let wheel = tabled(&names(true, false));
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
        "omega_x omega_y omega_z alpha_x alpha_y alpha_z camber_rad camber_to_ground_rad toe_rad \
         wheel_travel_mm recession_mm"
    );
    assert_eq!(
        more(&wheel, &both),
        "kingpin_rad caster_rad kingpin_offset_mm caster_offset_mm"
    );
}

#[test]
fn entries_of_the_vehicle_add_their_columns() {
    let both = names(true, true);
    let with = |names: &Names, known: fn(Wheel) -> Wheel| Names {
        wheels: names.wheels.iter().cloned().map(known).collect(),
        ..names.clone()
    };
    let on_ground = with(&both, |wheel| Wheel {
        radius: Some(0.3),
        ..wheel
    });
    let moving = with(&on_ground, |wheel| Wheel {
        travel: Some(0),
        steer: Some(1),
        ..wheel
    });
    let more = |than: &Names, all: &Names| {
        let (than, all) = (tabled(than), tabled(all));
        let new = all.iter().filter(|name| !than.contains(name));
        new.cloned().collect::<Vec<_>>().join(" ")
    };
    assert_eq!(
        more(&both, &on_ground),
        "contact_x contact_y contact_z scrub_radius_mm mechanical_trail_mm half_track_change_mm"
    );
    assert_eq!(
        more(&on_ground, &moving),
        "virtual_kingpin_rad virtual_caster_rad virtual_scrub_radius_mm virtual_trail_mm \
         virtual_pitch_mm_rad roll_centre_mm jacking_percent front_centre_y front_centre_z front_arm_mm \
         side_centre_x side_centre_z side_arm_mm brake_angle_rad drive_angle_rad"
    );
}

#[test]
fn every_quantity_has_name_definition_and_source() {
    let mut names: Vec<_> = catalogue().map(|row| row.name).collect();
    names.retain(|name| !name.is_empty());
    let count = names.len();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), count, "no two rows have one name");
    for row in catalogue() {
        assert!(!row.title.is_empty(), "{}", row.name);
        assert!(
            !row.definition.is_empty() && !row.source.is_empty(),
            "{}",
            row.title
        );
    }
}
