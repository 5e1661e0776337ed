//! Which equations a listing gives, on which unknowns, and whether they can determine them.

use proc_macro2::TokenStream;
use quote::quote;
use suspension_listing::system::{Body, Site, System};

use super::{catalogue_system, lower};

fn determined(listing: TokenStream) -> System {
    let (system, messages) = lower(listing);
    assert!(messages.is_empty(), "{messages:?}");
    system
}

/// The messages of a listing with mistakes.
fn messages(listing: TokenStream) -> Vec<String> {
    lower(listing).1
}

fn rows(system: &System) -> Vec<String> {
    system.rows().iter().map(ToString::to_string).collect()
}

fn frame(body: &Body) -> [String; 3] {
    body.frame.clone().map(|site| site.name.to_string())
}

#[test]
fn attia2003_has_15_equations_and_70_non_zeros() {
    let system = catalogue_system("attia2003");
    assert_eq!((system.rows().len(), system.size()), (15, 15));
    let non_zeros: Vec<usize> = system.pattern().iter().map(Vec::len).collect();
    // Five links to the chassis, nine distances within the knuckle, one driven coordinate.
    assert_eq!(non_zeros, [3, 3, 3, 3, 3, 6, 6, 6, 6, 6, 6, 6, 6, 6, 1]);
    assert_eq!(non_zeros.iter().sum::<usize>(), 70);
}

#[test]
fn five_link_knuckle_is_a_frame_with_two_carried_points() {
    let system = catalogue_system("five_link");
    let pattern = system.pattern();
    let first_three_points: Vec<usize> = (0..9).collect();
    assert_eq!(pattern[0], [0, 1, 2]);
    assert_eq!(pattern[5], [0, 1, 2, 3, 4, 5]);
    assert_eq!(pattern[7], [3, 4, 5, 6, 7, 8]);
    for (row, own) in (8..14).zip(9..15) {
        assert_eq!(pattern[row], [&first_three_points[..], &[own]].concat());
    }
    assert_eq!(pattern[14], [2]);
    assert_eq!(pattern.iter().map(Vec::len).sum::<usize>(), 94);
}

#[test]
fn nine_distances_among_five_points_form_a_cluster() {
    let cluster = |name| {
        let system = catalogue_system(name);
        let named = |site: &Site| site.name.to_string();
        let clusters = system.clusters.iter();
        let points = clusters.map(|cluster| cluster.points().map(named).collect::<Vec<_>>());
        points.collect::<Vec<_>>()
    };
    assert_eq!(cluster("attia2003"), [["p6", "p7", "p8", "p9", "p10"]]);
    assert!(cluster("five_link").is_empty());
}

#[test]
fn links_to_two_chassis_points_form_a_cluster() {
    let system = determined(quote! {
        mod arm {
            fixed: front, rear, rack;
            free: p, q, r;
            link a: front -> p;
            link b: rear -> p;
            link c: front -> q;
            link d: rear -> q;
            link e: p -> q;
            link f: r -> p;
            link g: r -> q;
            link h: r -> rack;
            drive lift: p.z;
        }
    });
    let [cluster] = system.clusters.as_slice() else {
        panic!("one cluster");
    };
    assert_eq!(frame(cluster), ["front", "rear", "p"]);
    assert_eq!(cluster.carried[0].name.to_string(), "q");
}

#[test]
fn a_frame_takes_chassis_points_first() {
    let system = determined(quote! {
        mod rocker {
            fixed: front, rear;
            free: push, pull;
            body rocker: push, front, pull, rear;
            drive lift: push.z;
        }
    });
    assert_eq!(frame(&system.bodies[0]), ["front", "rear", "push"]);
    // The distance from front to rear is the chassis' own.
    assert_eq!(
        rows(&system),
        [
            "rocker_front_push",
            "rocker_rear_push",
            "rocker_pull_x",
            "rocker_pull_y",
            "rocker_pull_z",
            "lift"
        ]
    );
}

#[test]
fn the_shared_edge_of_two_bodies_is_one_equation() {
    let system = determined(quote! {
        mod hinge {
            fixed: front, rear;
            free: p, q, tip;
            body arm: front, rear, p, q;
            body flap: tip, p, q;
            drive lift: p.z;
            drive fold: tip.z - p.z;
        }
    });
    assert_eq!(frame(&system.bodies[1]), ["p", "q", "tip"]);
    let flap: Vec<String> = rows(&system)
        .into_iter()
        .filter(|row| row.starts_with("flap"))
        .collect();
    assert_eq!(flap, ["flap_p_tip", "flap_q_tip"]);
}

#[test]
fn a_body_of_two_points_is_one_distance_equation() {
    let system = determined(quote! {
        mod bar {
            fixed: a;
            free: p;
            body bar: a, p;
            drive y: p.y;
            drive z: p.z;
        }
    });
    assert!(system.bodies.is_empty());
    let [bar, ..] = system.equations.as_slice() else {
        panic!("an equation");
    };
    assert_eq!(bar.origin.kind.to_string(), "body");
    assert!(bar.form.equations().keeps().is_some());
}

#[test]
fn a_drive_of_a_chassis_point_adds_no_equation() {
    let system = determined(quote! {
        mod rack {
            fixed: rack, a, b;
            free: p;
            link tie_rod: rack -> p;
            link fore: a -> p;
            link aft: b -> p;
            drive steer: rack.y;
        }
    });
    assert_eq!(rows(&system), ["tie_rod", "fore", "aft"]);
}

#[test]
fn a_driven_angle_uses_the_length_that_a_body_keeps() {
    for drive in [
        quote!(angle(inner -> hub, z)),
        quote!(angle(hub -> inner, z)),
    ] {
        let system = determined(quote! {
            mod arm {
                fixed: inner, outer;
                free: hub, brake;
                body arm: hub, brake, inner, outer;
                drive turn: #drive;
            }
        });
        let length = system.drives[0].angle_of.as_ref().map(ToString::to_string);
        assert_eq!(length.as_deref(), Some("arm_inner_hub"));
    }
}

#[test]
fn points_of_differences_markers_and_wheels_count_as_used() {
    determined(quote! {
        mod used {
            fixed: datum, pole, mount, top;
            free: p;
            drive x: p.x - datum.x;
            drive y: p.y;
            drive z: p.z;
            drive raise: top.z;
            point mark: p, pole, mount;
            wheel: mark -> p;
            kingpin: p -> top;
        }
    });
}

#[test]
fn a_surplus_equation_in_one_part_is_found_by_structural_rank() {
    let messages = messages(quote! {
        mod lopsided {
            fixed: a, b, c, d;
            free: p, q;
            link first: a -> p;
            link second: b -> p;
            link third: c -> p;
            link fourth: d -> p;
            link bar: a -> q;
            drive lift: q.z;
        }
    });
    let [redundant, undetermined] = messages.as_slice() else {
        panic!("one equation too many, one unknown left: {messages:?}");
    };
    assert!(redundant.starts_with("`fourth` is one equation too many"));
    assert!(undetermined.starts_with("no equation is left to determine `q."));
}

#[test]
fn a_wrong_number_of_equations_is_reported_before_ranks() {
    let messages = messages(quote! {
        mod short {
            fixed: a;
            free: p;
            link rod: a -> p;
            drive z: p.z;
        }
    });
    assert_eq!(messages.len(), 1);
    assert!(messages[0].starts_with("2 equations for 3 unknowns: 1 of links"));
}

/// The same four points are the ends of two other lines.
#[test]
fn two_drives_of_which_one_is_a_multiple_are_refused() {
    let with = |second: TokenStream| {
        messages(quote! {
            mod crank {
                fixed: t, u, p;
                free: w, q;
                hinge first: t, u -> w;
                hinge second: t, u -> q;
                drive one: angle(t -> w, p -> q about t -> u);
                drive other: w along [0.0, 2.0, 0.0];
                #second
            }
        })
    };
    let is_refused = |second: TokenStream| {
        let messages = with(second);
        let mut same = messages
            .iter()
            .map(|message| message.contains("prescribes the same"));
        same.any(|same| same)
    };
    assert!(!is_refused(
        quote!(drive two: angle(t -> p, w -> q about t -> u);)
    ));
    assert!(!is_refused(
        quote!(drive two: angle(t -> w, p -> q about t -> p);)
    ));
    assert!(is_refused(
        quote!(drive two: angle(q -> p, t -> w about u -> t);)
    ));
    assert!(!is_refused(quote!(drive two: w along [1.0, 1.0, 0.0];)));
    assert!(is_refused(quote!(drive two: w along [0.0, -1.0, 0.0];)));
}

#[test]
fn a_measured_angle_with_a_line_along_its_axis_is_refused() {
    let messages = messages(quote! {
        mod arm {
            fixed: a, b, c;
            free: p;
            hinge arm: a, b -> p;
            drive lift: p.z;
            measure turn: angle(a -> p, b -> a about a -> b);
        }
    });
    assert_eq!(messages.len(), 1, "{messages:?}");
    assert!(messages[0].starts_with("the line `b -> a` is the axis"));
}
