suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p, q, r;
        link rod: a -> p;
        body plate: p, q, r;
        drive x: p.x;
        drive y: p.y;
        drive lift: q.z;
        point hub: plate;
        wheel: p -> hub;
        measure gap: length(a -> hub);
    }
}

suspension_core::linkage! {
    mod misnamed {
        fixed: a;
        free: p;
        link rod: a -> q;
        drive y: p.y;
        drive z: p.up;
    }
}

use m::{Drives, Lengths, Measures, Model, Points, equation, unknown};
use suspension_core::nalgebra::Vector3;
use suspension_core::wheel::Wheel;
use suspension_core::{Build, Inputs, Linkage, Newton, Signal, Tracker, Values, assemble};
use suspension_core::linkage::HasWheel;

fn main() {
    let mut points = Points {
        a: Vector3::zeros(),
        p: Vector3::x(),
        q: Vector3::y(),
        r: Vector3::z(),
        hub: Vector3::zeros(),
    };
    points.q.x += 0.5;
    let model = Model::<f64>::new(&points).unwrap();
    let lengths = Lengths::from_values(std::iter::repeat(1.0));
    let model = model.with_lengths(&lengths).unwrap();
    println!("{} {}", lengths.rod, lengths.plate_p_q);
    let drives = |lift| Drives { x: 0.0, y: 0.0, lift };
    let inputs = Inputs::still(Signal { value: drives(1.0), ..Signal::default() });
    let mut q = model.unknowns(&points);
    assemble(&Newton::from_afar(), &model, &inputs, &mut q).unwrap();
    let mut motion = suspension_core::Motion::at_rest(q);
    Tracker::default().step(&model, &inputs, 0.1, &mut motion).unwrap();
    let Measures { gap } = model.measures(&motion.points(&model, &inputs)).value;
    println!("{gap}");
    let wheel = Wheel::of(model.points(&q, model.fixed()).wheel());
    println!("{} {} {:?}", equation::ROD, q[unknown::P_X], wheel);
    misuse();
}

fn misuse() {
    use misnamed::{Drives, Lengths, Model, Points};
    let points = Points { a: Vector3::zeros(), p: Vector3::x() };
    let lengths = Lengths { rod: 1.0 };
    let model = Model::<f64>::new(&points).and_then(|model| model.with_lengths(&lengths));
    println!("{:?} {:?}", model, Drives { y: 0.0, z: 1.0 });
}
