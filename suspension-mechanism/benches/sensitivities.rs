//! The cost of all sensitivities of a design, compared with one state of it.
//!
//! Ids are `linkage/function`, of linkages of the catalogue:
//!
//! - `state`: the suspension solved from where it stands to 2 mm of travel further, then all quantities read there, with their
//!   derivatives with respect to each drive;
//! - `all`: what every hardpoint coordinate and every length does to all of these numbers at the design position.

use std::hint::black_box;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use suspension_mechanism::characteristics::columns;
use suspension_mechanism::file::Source;
use suspension_mechanism::kinematics::Kinematics;
use suspension_mechanism::mechanism::{CountedFrom, DerivativeOrder, Grid, GridAxis, Place};
use suspension_mechanism::prepare::load;
use suspension_mechanism::quantities::{Column, Reader};
use suspension_mechanism::sensitivities::sensitivities;

/// How much further the wheel is, m: the step of a curve over the usual travel.
const TRAVEL: f64 = 0.002;

/// What a motion file states beside its linkage; the motion is not made.
const REST: &str = "
    unit = 'm'
    vehicle = { wheel_radius = 0.3 }
    time = { start = 0.0, stop = 1.0, step = 0.1 }
    drives = { bump = [0.3], steer = [0.34] }
";

/// All numbers of a place: of each column its value, then its derivatives.
fn numbers(place: &dyn Place, columns: &[Column], drives: usize) -> Vec<f64> {
    let per = (0..drives).map(|drive| place.per(drive).expect("a regular place"));
    let (state, per) = (place.state(), per.collect::<Vec<_>>());
    let reader = Reader::new(&state);
    let per: Vec<Reader<'_>> = per.iter().map(Reader::new).collect();
    let of_column = |column: &Column| {
        let rates = per.iter().map(|reader| column.read(reader).rate);
        [column.read(&reader).value]
            .into_iter()
            .chain(rates)
            .collect::<Vec<_>>()
    };
    columns.iter().flat_map(of_column).collect()
}

fn state(mechanism: &dyn Kinematics, grid: &Grid, columns: &[Column]) -> Vec<f64> {
    let never = AtomicBool::new(false);
    let drives = mechanism.names.drives.len();
    let mut read = |place: &dyn Place| numbers(place, columns, drives);
    let visited = mechanism.visit(grid, DerivativeOrder::First, &never, &mut read);
    let place = visited.places.into_iter().next().flatten();
    place.expect("a regular place")
}

fn of_linkage(criterion: &mut Criterion, linkage: &str) {
    let source = Source::new("corner.toml", format!("linkage = \"{linkage}\"\n{REST}"));
    let loaded = load(&source).expect("a motion");
    let mechanism = &*loaded.at_design().expect("a design");
    let changes = loaded.changes(mechanism).expect("changes");
    let columns = columns(mechanism);
    let travel = mechanism.names.vehicle.travel[0];
    let axis = GridAxis::for_drive(travel, vec![TRAVEL]);
    let grid = Grid::new(mechanism, vec![axis], CountedFrom::Start).expect("a grid");
    let mut group = criterion.benchmark_group(linkage);
    group.bench_function("state", |bencher| {
        bencher.iter(|| state(black_box(mechanism), &grid, &columns));
    });
    group.bench_function("all", |bencher| {
        let never = AtomicBool::new(false);
        bencher.iter(|| sensitivities(black_box(mechanism), &changes, &never, || ()));
    });
}

fn linkages(criterion: &mut Criterion) {
    of_linkage(criterion, "double_wishbone");
    of_linkage(criterion, "double_wishbone_pushrod");
}

criterion_group! {
    name = all;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(3));
    targets = linkages
}
criterion_main!(all);
