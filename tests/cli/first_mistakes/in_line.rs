//! Bodies whose first three points are collinear, for which another order of the points works.

use super::super::program::{folder, run};
use super::refusal;

fn file(statements: &str) -> String {
    format!(
        "unit = \"m\"\nstatements = '''\n{statements}'''\ntime = {{ instants = [0.0] }}\ndrives = {{ bump = 0.3 }}\n"
    )
}

fn with_body(points: &str) -> String {
    file(&format!(
        "fixed: lf at [0.2, 0.35, 0.16], lr at [-0.2, 0.35, 0.16], uf at [0.15, 0.42, 0.42], ur at [-0.15, 0.42, 0.42];\n\
         fixed: rack at [0.11, 0.34, 0.20];\n\
         free: lb at [0, 0.70, 0.16], ub at [0, 0.66, 0.44], tb at [0.12, 0.68, 0.21], wc at [0, 0.75, 0.30];\n\
         free: rod at [0, 0.68, 0.3];\n\
         hinge lower: lf, lr -> lb;\nhinge upper: uf, ur -> ub;\nlink tie: rack -> tb;\n\
         body knuckle: {points};\ndrive bump: wc.z;\n"
    ))
}

fn with_hinge(points: &str, ball: &str) -> String {
    let statements = format!(
        "fixed: front at [0.2, 0, 0], rear at [-0.2, 0, 0];\nfree: pin at [0, 0, 0], ball at {ball};\n\
         hinge arm: front, rear -> {points};\ndrive bump: ball.z;\n"
    );
    file(&statements)
}

#[test]
fn a_body_in_line_is_named_with_an_order_of_points_that_works() {
    let message = refusal(
        "check",
        &[("a.toml", &with_body("lb, rod, ub, wc, tb"))],
        &[],
    );
    assert_eq!(
        message,
        "a.toml:10:6: the first three points of body `knuckle` carry the others, and `lb`, `rod` and `ub` lie in line; \
         list `tb` before `ub`, or move one of them off the line"
    );
    assert_works(&with_body("lb, rod, tb, ub, wc"));
}

#[test]
fn a_hinge_in_line_is_named_with_an_order_of_points_that_works() {
    let message = refusal(
        "check",
        &[("a.toml", &with_hinge("pin, ball", "[0, 0.5, 0.3]"))],
        &[],
    );
    assert_eq!(
        message,
        "a.toml:5:7: point `pin` of hinge `arm` lies on the axis `front`, `rear`, and the first point after the arrow must be \
         off the axis, because the axis and this point carry the other points; list `ball` before `pin`, or move it off the axis"
    );
    assert_works(&with_hinge("ball, pin", "[0, 0.5, 0.3]"));
}

#[test]
fn for_a_hinge_without_a_working_order_none_is_proposed() {
    let message = refusal(
        "check",
        &[("a.toml", &with_hinge("pin, ball", "[0.1, 0, 0]"))],
        &[],
    );
    let remedy = "; list a point off the line before `pin`, or move it off the axis";
    assert!(message.ends_with(remedy), "{message}");
}

fn assert_works(file: &str) {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["check", "a.toml"]);
    assert!(output.status.success(), "{output:?}");
}
