//! What a sweep of a double wishbone with a rack takes, without writing it: all quantities with their first derivatives
//! at 161 x 41 places of travel and steering, on one core.
//!
//! Ids are `double_wishbone/model`:
//!
//! - `walked`: of the listing that is read at run time, as motion files have it;
//! - `written`: of the code that `linkage!` writes for the same listing.

use std::hint::black_box;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use suspension_core::linkages::double_wishbone::{Model, Points};
use suspension_core::{Build, Linkage, Motion, Values};
use suspension_mechanism::characteristics::GridTable;
use suspension_mechanism::file::Source;
use suspension_mechanism::kinematics::Kinematics;
use suspension_mechanism::mechanism::{
    CountedFrom, DerivativeOrder, Grid, GridAxis, Mechanism, evenly_spaced,
};
use suspension_mechanism::prepare::load;

const CORNER: &str = "
    linkage = 'double_wishbone'
    unit = 'm'
    vehicle = { wheel_radius = 0.3 }
    time = { start = 0.0, stop = 1.0, step = 0.1 }
    drives = { bump = [0.3], steer = [0.34] }
";

/// Travel, m, and places.
const BUMP: (f64, usize) = (0.08, 161);

/// The same of the rack.
const STEER: (f64, usize) = (0.03, 41);

/// The same mechanism as the code that `linkage!` writes.
fn written(walked: &dyn Kinematics) -> Mechanism<Model<f64>, 12> {
    let local = walked.points().into_iter();
    let points = Points::from_values(local.map(|point| point - walked.origin));
    let model = Model::new(&points).expect("the design of the catalogue");
    Mechanism {
        start: Motion::at_rest(model.unknowns(&points)),
        description: (**walked).clone(),
        model,
        lead: None,
        design_derivatives: None,
    }
}

/// All numbers of all places.
fn sweep(mechanism: &dyn Kinematics, grid: &Grid, table: &GridTable) -> Vec<Option<Vec<f64>>> {
    let never = AtomicBool::new(false);
    let visited = mechanism.visit(grid, DerivativeOrder::First, &never, &mut |place| {
        table.row(place)
    });
    visited.places
}

fn sweeps(criterion: &mut Criterion) {
    let source = Source::new("corner.toml", CORNER.to_owned());
    let loaded = load(&source).expect("a motion");
    let walked = loaded.at_design().expect("a design");
    let written = written(&*walked);
    let names = walked.names.drive_names();
    let axis = |name: &str, (most, count): (f64, usize)| {
        let drive = names.iter().position(|drive| *drive == name);
        GridAxis::for_drive(drive.expect("a drive"), evenly_spaced([-most, most], count))
    };
    let axes = vec![axis("bump", BUMP), axis("steer", STEER)];
    let grid = Grid::new(&walked, axes, CountedFrom::Start).expect("a grid");
    let table = GridTable::new(&walked, 1);
    let mut group = criterion.benchmark_group("double_wishbone");
    let mut bench = |id: &str, mechanism: &dyn Kinematics| {
        let reached = sweep(mechanism, &grid, &table);
        assert!(reached.iter().all(Option::is_some), "{id} locks");
        group.bench_function(id, |bencher| {
            bencher.iter(|| sweep(black_box(mechanism), &grid, &table));
        });
    };
    bench("walked", &*walked);
    bench("written", &written);
}

criterion_group! {
    name = all;
    config = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(3));
    targets = sweeps
}
criterion_main!(all);
