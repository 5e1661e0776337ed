//! Bodies that turn where equations are missing.

use crate::kind::Kind;
use crate::name::Name;
use crate::system::{Body, Equation, Site, System};
use crate::vector::{Vector, are_in_line};

/// A hint for the first body that can still turn as it is held; empty if none is known to.
pub(super) fn turning(system: &System) -> String {
    let mut bodies = system.bodies.iter();
    let hint = bodies.find_map(|body| {
        hint_in_line(system, body)
            .or_else(|| hint_on_one_slide(system, body))
            .or_else(|| hint_on_two_points(system, body))
    });
    hint.unwrap_or_default()
}

/// A hint for a body whose stated points are all collinear; `None` for other bodies, and if a point has no stated
/// position.
fn hint_in_line(system: &System, body: &Body) -> Option<String> {
    let stated = |site: &Site| {
        let points = if site.is_free() {
            &system.free
        } else {
            &system.fixed
        };
        points.get(site.index)?.at
    };
    let places: Option<Vec<Vector>> = body.points().map(stated).collect();
    let [a, b, c] = &body.frame.each_ref().map(|site| &site.name);
    are_in_line(&places?).then(|| {
        format!(
            "; the points of body `{}` lie on one line, about which the body can rotate: in place of the body write \
             `link NAME: {a} -> {b};`, unless \
             another body keeps these, and for each other point `slide NAME: {c} on {a} -> {b};` and `link NAME: {a} -> {c};`",
            body.name
        )
    })
}

/// A hint for a body that only one slide holds, whatever drives it; `None` for others.
fn hint_on_one_slide(system: &System, body: &Body) -> Option<String> {
    let has = |site: &Site| body.points().any(|point| point.name == site.name);
    let holds = |equation: &&Equation| {
        let mut sites = equation.form.equations().sites().into_iter();
        equation.origin.kind != Kind::DRIVE
            && equation.origin.statement != body.name
            && sites.any(has)
    };
    let held: Vec<&Equation> = system.equations.iter().filter(holds).collect();
    let [only] = held[..] else {
        return None;
    };
    let is_on_chassis = body.points().any(|point| !point.is_free());
    (only.origin.kind == Kind::SLIDE && !is_on_chassis).then(|| {
        format!(
            "; slide `{}` alone holds body `{}`, which can still rotate about the sliding point: a second `slide` on the same line \
             leaves only the rotation about the line, and a `plane` for a third point prevents that too",
            only.origin.statement, body.name
        )
    })
}

/// A hint for a body that other statements or the chassis hold at only two points; `None` for others, and for a body
/// on the chassis, where it is meant to turn.
fn hint_on_two_points(system: &System, body: &Body) -> Option<String> {
    let equations = system.equations.iter();
    let others = equations.filter(|equation| equation.origin.statement != body.name);
    let held: Vec<&Name> = others
        .flat_map(|equation| equation.form.equations().sites())
        .map(|site| &site.name)
        .collect();
    let points = body.points();
    let attached = points.filter(|site| !site.is_free() || held.contains(&&site.name));
    let [first, second] = attached.collect::<Vec<_>>()[..] else {
        return None;
    };
    if !first.is_free() && !second.is_free() {
        return None;
    }
    Some(format!(
        "; body `{}` is held only at `{}` and `{}` and can rotate about the line through them: an `angle` or a third attachment prevents that",
        body.name, first.name, second.name
    ))
}
