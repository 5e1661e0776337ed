//! What `--names` prints.

use super::format::is_name_of_other_angle;
use super::names::Names;
use crate::quantities::WIDTH;

/// Lists the names that import knows: the layouts with their points, the other names of points and of numbers, and the words
/// that mean the same.
pub(super) fn known_names(names: &Names) -> String {
    let mut text = "layouts and their points\n".to_owned();
    for layout in &names.layouts {
        text += &row(layout.name, &layout.points);
    }
    let parts = [
        ("other names of points", &names.points),
        ("other names of numbers", &names.numbers),
        ("words that mean the same", &names.synonyms),
        ("words of headings", &names.headings),
    ];
    for (heading, rows) in parts {
        text += &format!("{heading}\n");
        for (own, others) in rows {
            // Known so that their rows are refused.
            let is_refused = |other: &String| own == "toe" && is_name_of_other_angle(other);
            let others = others.iter().filter(|other| !is_refused(other));
            let others: Vec<String> = others.cloned().collect();
            if !others.is_empty() {
                text += &row(own, &others);
            }
        }
    }
    text += &format!("words without a meaning\n{}", row("", &names.unsaid));
    text
}

/// Returns a name with others beside it, in lines that a terminal does not break.
fn row(name: &str, others: &[String]) -> String {
    let first = format!("  {name:24} ");
    let behind = " ".repeat(first.len());
    let lines = textwrap::Options::new(WIDTH)
        .initial_indent(&first)
        .subsequent_indent(&behind);
    textwrap::fill(&others.join(", "), lines) + "\n"
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::super::spelling::spelled;
    use super::*;

    #[test]
    fn names_toml_has_points_of_the_catalogue_in_normal_spelling() {
        let names = Names::read().expect("a table");
        let layouts = names.layouts.iter();
        let points: Vec<&String> = layouts.flat_map(|layout| &layout.points).collect();
        for (point, others) in &names.points {
            assert!(points.contains(&point), "no listing has {point}");
            for name in others {
                assert_eq!(*name, spelled(name));
            }
        }
        let arrangement = &names.arrangement;
        let ordered = arrangement.ahead.iter().chain(&arrangement.above).flatten();
        for point in ordered {
            assert!(points.contains(&point), "no listing has {point}");
        }
    }

    #[test]
    fn no_name_is_that_of_two_points_of_a_layout_or_stands_twice() {
        let names = Names::read().expect("a table");
        for layout in &names.layouts {
            let mut found = BTreeMap::new();
            for point in &layout.points {
                for name in names.of_point(point) {
                    let other = found.insert(names.normal(name), (point, name));
                    assert_eq!(other, None, "{}: {point}, {name}", layout.name);
                }
            }
        }
    }

    /// Names of the templates of other programs, of theses and of racing teams, behind the point of the listing.
    const TEMPLATES: &str = "\
lower_front: lca_front lower_wishbone_front_pivot lower_inboard_front chas_lowfor lca_fwd_chassis \
    lower_control_arm_front_bushing front_lower_inboard lower_a_arm_fore_inner querlenker_unten_vorn \
    vorderer_unterer_querlenker lca_f lcafront triangle_inférieur_avant braccio_inferiore_anteriore trapecio_inferior_delantero
upper_rear: uca_rear upper_arm_rear_pivot chas_uppaft uwb_aft uca_inboard_rear top_wishbone_rear ucar triangle_supérieur_arrière \
    triangolo_superiore_posteriore trapecio_superior_trasero
lower_ball: lca_outer lower_wishbone_outer_ball_joint upri_lowpnt lbj lca_upright traggelenk_unten lower_balljoint \
    rotule_inférieure snodo_inferiore rótula_inferior
upper_ball: uca_outer upri_upppnt ubj top_ball_joint outer_ball_joint_upper_arm
rack: tierod_inner inner_track_rod_ball_joint chas_tiepnt toe_rod_inner spurstange_innen innere_spurstange tri \
    steering_inner rack_end biellette_de_direction_intérieure tirante_sterzo_interno barra_de_dirección_interior
tie_ball: tierod_outer outer_tie_rod upri_tiepnt toelink_outboard steering_arm tro spurstange_radträger biellette_de_direction_extérieure \
    tirante_sterzo_esterno
wheel_centre: wheel_center wheelcenter wheel_center_point radmittelpunkt wc centre_de_roue centro_ruota centro_de_rueda
axle: wheel_spindle_point
pushrod_lower: prod_outboard push_rod_wishbone_end pullrod_outer pushrod_to_uca nsma_ppattpnt druckstange_außen
pushrod_upper: prod_to_bellcrank push_rod_rocker_end pushrod_inboard rock_rodpnt
rocker_front: rocker_axis_front bellcrank_pivot_fwd bellcrank_pivot rocker_axis_1st_point chas_rocpiv
rocker_rear: rocker_axis_rear rocker_bearing_aft bellcrank_axis bellcrank_pivot_orient chas_rocaxi
damper_inner: shock_to_chassis damper_to_body_point damper_inboard chas_attpnt dämpfer_karosserie
damper_outer: shock_to_bellcrank damper_to_rocker_point rock_coipnt dämpfer_umlenkhebel
damper_lower: damper_to_lca shock_lower
damper_upper: shock_top damper_top_mount
spring_upper: spring_top coil_spring_top spring_top_mount upper_spring_mount spring_seat_upper feder_oben
spring_lower: spring_bottom spring_bottom_mount lower_spring_mount feder_unten
integral_upper: integral_link_top
bar_outer: arb_pivot_outer arb_bushing_mount arb_pivot
drop_upper: arb_drop_link_upper sway_bar_end_link_upper arblink_to_bellcrank droplink_upper
drop_lower: anti_roll_bar_link_bottom arb_drop_link_bar droplink_to_arb arblink_to_arb
";

    #[test]
    fn names_of_other_programs_are_known() {
        let names = Names::read().expect("a table");
        for row in TEMPLATES.lines() {
            let (point, templates) = row.split_once(": ").expect("a point and its names");
            let known: Vec<String> = names
                .of_point(point)
                .map(|name| names.normal(name))
                .collect();
            for name in templates.split(' ') {
                assert!(known.contains(&names.normal(name)), "{point}: {name}");
            }
        }
        let strange = "lower front wishbone lca lca_rocker upper_lower_ball point";
        for name in strange.split(' ') {
            assert!(!names.is_point(name), "{name}");
        }
    }
}
