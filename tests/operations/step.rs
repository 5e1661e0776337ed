//! The operations of a bounded step by what they are for: the table of `docs/operations.md`.

use std::fmt::Write as _;

use suspension_core::linkage::Factors as _;
use suspension_core::signal::ChassisMotion;
use suspension_core::solve::motion::Prescribed;
use suspension_core::step::bounded::{Outputs, Step};
use suspension_core::{Inputs, Linkage, Motion, Signal, Still, Values};

use super::number::{Counting, Counts, count_different};
use super::{attia_model, chassis, five_link_model, unknowns};

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/operations.md");
const BEGIN: &str = "<!-- Written by the test operations::step: -->\n";

/// The counted operations of one linkage, each with its name.
type Rows = Vec<(&'static str, usize)>;

fn signal<V: Values<Counting>>() -> Signal<V> {
    Signal {
        value: unknown_values(),
        rate: unknown_values(),
        second_rate: unknown_values(),
    }
}

fn unknown_values<V: Values<Counting>>() -> V {
    V::from_values(std::iter::repeat_with(Counting::unknown))
}

fn total(counts: Counts) -> usize {
    counts.into_iter().sum()
}

/// A step of which equal operations are made once.
fn step<const CORRECTIONS: usize, L, const N: usize>(model: &L, outputs: Outputs) -> usize
where
    L: Linkage<N, Scalar = Counting>,
    Still: ChassisMotion<L::Fixed>,
{
    let inputs = Inputs::still(signal());
    let motion = Motion {
        position: unknowns(),
        velocity: unknowns(),
        acceleration: unknowns(),
        positive_determinant: None,
    };
    let dt = Counting::unknown();
    total(count_different(|| {
        let prescribed = Prescribed::new::<L, Still, N>(model, &inputs);
        Step::<L, Still, N, CORRECTIONS, 2>::new(model, &prescribed, &motion, dt)
            .in_fixed_order(outputs)
    }))
}

fn rows<L, const N: usize>(model: &L) -> Rows
where
    L: Linkage<N, Scalar = Counting>,
    Still: ChassisMotion<L::Fixed>,
{
    let (q, v, w, rest) = (unknowns(), unknowns(), unknowns(), L::Fixed::default());
    let fixed = chassis();
    let drives = unknown_values();
    let factors = model.factor(&q, &fixed);
    let inputs: Signal<L::Drives> = signal();
    let drive = total(count_different(|| model.coordinates(&inputs)));
    let residual = total(count_different(|| model.residual(&q, &fixed, &drives)));
    let both = total(count_different(|| {
        model.residual(&q, &fixed, &drives);
        model.factor(&q, &fixed)
    }));
    let solve = total(count_different(|| factors.solve(&w)));
    let square = total(count_different(|| model.curvature(&v, &rest, &v, &rest)));
    let product = total(count_different(|| model.curvature(&v, &rest, &w, &rest)));
    let [position, velocity, acceleration] =
        [Outputs::Position, Outputs::Velocity, Outputs::Acceleration]
            .map(|outputs| step::<1, L, N>(model, outputs));
    let uncorrected = step::<0, L, N>(model, Outputs::Acceleration);
    let known = drive + both + 3 * solve + 2 * square + 2 * product;
    vec![
        ("drive's angle to a coordinate, with rates", drive),
        ("residual", residual),
        (
            "Jacobian and its factors, less operations shared with the residual",
            both - residual,
        ),
        ("one back-substitution", solve),
        ("curvature of one vector: `C(e, e)`, `C(v, v)`", square),
        ("curvature of two: `C(e, v)`, `C(e, a)`", product),
        ("**step, one correction: position**", position),
        ("**with velocity**", velocity),
        ("**with acceleration**", acceleration),
        (
            "of which prediction, first values of the rates and tests of the step, less operations that curvatures share",
            acceleration - known,
        ),
        (
            "**step without corrections, with acceleration**",
            uncorrected,
        ),
    ]
}

fn table() -> String {
    let mut table = String::from("| operations | attia2003 | five_link |\n| --- | --- | --- |\n");
    for ((what, attia), (_, five_link)) in rows(&attia_model())
        .into_iter()
        .zip(rows(&five_link_model()))
    {
        let _ = writeln!(table, "| {what} | {attia} | {five_link} |");
    }
    table
}

#[test]
fn operations_md_has_the_counted_operations() {
    let page = || std::fs::read_to_string(PAGE).expect("a page");
    let old = page();
    let (before, rest) = old.split_once(BEGIN).expect("the table's place");
    let (_, after) = rest
        .split_once("\n\n")
        .expect("a blank line after the table");
    let table = table();
    let current = format!("{before}{BEGIN}{table}\n{after}");
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some_and(|value| value == "1") {
        std::fs::write(PAGE, &current).expect("the page is written");
    }
    assert!(
        page() == current,
        "docs/operations.md has other counts; to write them run \
         `UPDATE_SNAPSHOTS=1 cargo test --test all operations::`:\n{table}"
    );
}
