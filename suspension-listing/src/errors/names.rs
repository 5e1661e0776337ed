//! Of names and operands.

use syn::{Error, Ident};

use super::at;

pub fn duplicate_name(name: &Ident, first: &str) -> Error {
    at(
        name,
        format!("the name `{name}` is already taken by a {first}; choose another"),
    )
}

pub fn reserved_name(name: &Ident) -> Error {
    at(
        name,
        format!("the name `{name}` is used by the generated code; choose another"),
    )
}

pub fn unknown_point(name: &Ident) -> Error {
    at(
        name,
        format!("there is no point `{name}`; declare it under `fixed:` or `free:`"),
    )
}

pub fn marker_in_constraint(name: &Ident) -> Error {
    at(
        name,
        format!(
            "`{name}` is a marker and has no unknowns; declare it under `free:` and list it in its body"
        ),
    )
}

pub fn same_point_twice(name: &Ident) -> Error {
    at(
        name,
        format!("point `{name}` is listed twice; name another point or remove it"),
    )
}

pub fn all_fixed(name: &Ident, kind: &str) -> Error {
    at(
        name,
        format!("{kind} `{name}` joins chassis points only; give it a free point or remove it"),
    )
}

pub fn too_few_points(name: &Ident) -> Error {
    at(
        name,
        format!("body `{name}` needs two points or more; list them, or remove the body"),
    )
}

pub fn immovable_body(name: &Ident) -> Error {
    at(
        name,
        format!(
            "body `{name}` has three chassis points and cannot move; its other points are chassis \
             points too: declare them under `fixed:`"
        ),
    )
}

pub fn length_stated_twice(name: &Ident, other: &str) -> Error {
    at(
        name,
        format!(
            "`{name}` joins two points whose distance `{other}` keeps already; remove one of them"
        ),
    )
}

pub fn shared_triangle(name: &Ident, other: &Ident) -> Error {
    at(
        name,
        format!(
            "body `{name}` shares three points with body `{other}`: they are one body; list all points in one"
        ),
    )
}

pub fn unknown_axis(axis: &Ident) -> Error {
    at(
        axis,
        format!("there is no axis `{axis}`; write `x`, `y` or `z`"),
    )
}

pub fn different_axes(axis: &Ident, expected: &Ident) -> Error {
    at(
        axis,
        format!("both coordinates must be along one axis; write `.{expected}`"),
    )
}

pub fn coordinate_driven_twice(name: &Ident, other: &Ident) -> Error {
    at(
        name,
        format!("drive `{other}` prescribes this coordinate already; remove one of them"),
    )
}

pub fn bad_carriers(marker: &Ident, carriers: &[Ident]) -> Error {
    let message = match carriers {
        [one] => format!("there is no body `{one}` with three points or more to carry `{marker}`"),
        _ => format!(
            "`{marker}` is carried by one body or by three points; {} names are given",
            carriers.len()
        ),
    };
    at(carriers.first().unwrap_or(marker), message)
}

pub fn role_stated_twice(keyword: &Ident) -> Error {
    at(keyword, format!("`{keyword}` is stated twice; remove one"))
}

pub fn wheel_without_carrier(from: &Ident, to: &Ident) -> Error {
    at(
        from,
        format!(
            "no body carries both `{from}` and `{to}`; list them in one body, or declare one as \
             `point` carried by three points"
        ),
    )
}

pub fn body_bent(drive: &Ident, point: &Ident, body: &Ident) -> Error {
    at(
        drive,
        format!(
            "`{point}` is one of two chassis points of body `{body}`: to move it alone would bend \
             the body; drive a free point of the body instead"
        ),
    )
}
