//! Small linkages of random shape, driven to where their two assemblies meet and beyond: all roots
//! are known in closed form.

use fastrand::Rng;
use nalgebra::{SVector, Vector3};
use suspension_core::certificate::Certifier;
use suspension_core::{Build, Inputs, Linkage, Listing, Newton, Real, Signal};
use suspension_double_double::DoubleDouble;

use super::judge::{Proof, Root, judge, nearest, proof, square_root};
use super::random::{Counts, power_of_ten, sign, sum_of_cases, uniform};

suspension_core::linkage! {
    /// A rod; two coordinates of its end are driven.
    mod rod {
        fixed: a;
        free:  p;
        link rod: a -> p;
        drive y: p.y;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    /// A rod that is turned about x; its end is driven along y too.
    mod crank {
        fixed: a;
        free:  p;
        link rod: a -> p;
        drive theta: angle(a -> p, z);
        drive y: p.y;
    }
}

suspension_core::linkage! {
    /// Two rods that meet, one from an anchor that is driven.
    mod dyad {
        fixed: a, b;
        free:  p;
        link first:  a -> p;
        link second: b -> p;
        drive x: p.x;
        drive lift: b.z;
    }
}

fn exactly(x: f64) -> DoubleDouble {
    DoubleDouble::from(x)
}

fn square(x: DoubleDouble) -> DoubleDouble {
    x * x
}

fn random_point(rng: &mut Rng, size: f64) -> Vector3<f64> {
    Vector3::from_fn(|_, _| uniform(rng, -size..size))
}

/// By how much the reach of a linkage is missed (negative) or exceeded, relative.
fn beyond(rng: &mut Rng) -> f64 {
    sign(rng) * power_of_ten(rng, -16.0..-2.0)
}

/// The proof at a place near `q`: `q` itself, a root of Newton's method from there, or one
/// off by anything from rounding to a tenth of the linkage.
fn certify<T: Real, L>(model: &L, drives: L::Drives, q: &mut SVector<T, 3>, rng: &mut Rng) -> Proof
where
    L: Linkage<3, Scalar = T, Listing: Listing<3, Model<T> = L>> + Copy,
{
    let inputs = Inputs::still(Signal {
        value: drives,
        ..Signal::default()
    });
    if rng.u8(0..3) > 0 {
        // Success is not required: any configuration will do.
        let _ = Newton::from_afar().solve(model, &inputs, q);
    }
    if rng.u8(0..3) > 0 {
        let by = nearest(&model.size()) * power_of_ten(rng, -16.0..-1.0);
        *q += random_point(rng, by).map(T::constant);
    }
    proof(&Certifier::new(model).certify(&inputs, q))
}

/// The roots `middle +- across`, whose difference has the square `discriminant`.
fn two_roots(
    middle: Vector3<DoubleDouble>,
    across: Vector3<DoubleDouble>,
    discriminant: DoubleDouble,
) -> Vec<Root<3>> {
    if discriminant < exactly(0.0) {
        return Vec::new();
    }
    let root = if discriminant > exactly(0.0) {
        square_root(discriminant)
    } else {
        discriminant
    };
    let across = across.map(|entry| entry * root);
    vec![middle + across, middle - across]
}

fn rod_case<T: Real>(seed: u64, rng: &mut Rng) -> Counts {
    let size = power_of_ten(rng, -2.0..2.0);
    let a = random_point(rng, size);
    let p = a + random_point(rng, size);
    let [a, p] = [a, p].map(|point| point.map(T::constant));
    let Ok(model) = rod::Model::new(&rod::Points { a, p }) else {
        return Counts::default();
    };
    let (a, length) = (a.map(|x| nearest(&x)), nearest(&model.lengths().rod));
    let reach = length * (1.0 + beyond(rng));
    let (sine, cosine) = uniform(rng, 0.0..6.3).sin_cos();
    let drives = [a.y + reach * cosine, a.z + reach * sine].map(T::constant);
    let [y, z] = drives.map(|drive| exactly(nearest(&drive)));
    let left = square(exactly(length)) - square(y - exactly(a.y)) - square(z - exactly(a.z));
    let across = left.nearest().max(0.0).sqrt() * sign(rng);
    let [y_drive, z_drive] = drives;
    let mut q = Vector3::new(T::constant(a.x + across), y_drive, z_drive);
    let drives = rod::Drives {
        y: y_drive,
        z: z_drive,
    };
    let certificate = certify(&model, drives, &mut q, rng);
    let unit = Vector3::new(1.0, 0.0, 0.0).map(exactly);
    let roots = two_roots(Vector3::new(exactly(a.x), y, z), unit, left);
    judge(certificate, &q.map(|x| nearest(&x)), &roots, ("rod", seed))
}

fn crank_case(seed: u64, rng: &mut Rng) -> Counts {
    let size = power_of_ten(rng, -2.0..2.0);
    let a = random_point(rng, size);
    let design = crank::Points {
        a,
        p: a + random_point(rng, size),
    };
    let Ok(model) = crank::Model::new(&design) else {
        return Counts::default();
    };
    let length = model.lengths().rod;
    let theta = uniform(rng, 0.05..3.1);
    let across_axis = length * theta.sin() * (1.0 + beyond(rng)) * sign(rng);
    let drives = crank::Drives {
        theta,
        y: a.y + across_axis,
    };
    let (sine, cosine) = exactly(theta).sine_cosine();
    let [y, z] = [exactly(drives.y), exactly(a.z) + exactly(length) * cosine];
    let left = square(exactly(length) * sine) - square(y - exactly(a.y));
    let across = left.nearest().max(0.0).sqrt() * sign(rng);
    let mut q = Vector3::new(a.x + across, drives.y, z.nearest());
    let certificate = certify(&model, drives, &mut q, rng);
    let unit = Vector3::new(1.0, 0.0, 0.0).map(exactly);
    let roots = two_roots(Vector3::new(exactly(a.x), y, z), unit, left);
    judge(certificate, &q, &roots, ("crank", seed))
}

fn dyad_case(seed: u64, rng: &mut Rng) -> Counts {
    let size = power_of_ten(rng, -2.0..2.0);
    let [a, p] = [(); 2].map(|()| random_point(rng, size));
    // The second rod in line with the first, seen along x, save for a little.
    let along = Vector3::new(0.0, p.y - a.y, p.z - a.z);
    let aside = Vector3::new(0.0, -along.z, along.y) * (sign(rng) * power_of_ten(rng, -8.0..-1.0));
    let b = p + along * uniform(rng, -2.0..2.0) + aside + Vector3::x() * uniform(rng, -size..size);
    let elsewhere = b + Vector3::z() * size;
    let lengths = dyad::Lengths {
        first: (p - a).norm(),
        second: (p - b).norm() * (1.0 + beyond(rng)),
    };
    let design = dyad::Points { a, b: elsewhere, p };
    let Ok(model) = dyad::Model::new(&design).and_then(|model| model.with_lengths(&lengths)) else {
        return Counts::default();
    };
    let drives = dyad::Drives { x: p.x, lift: b.z };
    // Two circles in the plane of `x`, with squares of radii and of the distance of the centres.
    let [ya, za, yb, zb, x] = [a.y, a.z, b.y, b.z, p.x].map(exactly);
    let first = square(exactly(lengths.first)) - square(x - exactly(a.x));
    let second = square(exactly(lengths.second)) - square(x - exactly(b.x));
    let (dy, dz) = (yb - ya, zb - za);
    let apart = square(dy) + square(dz);
    let along = (apart + first - second) / (apart + apart);
    let left = first / apart - square(along);
    let middle = Vector3::new(x, ya + dy * along, za + dz * along);
    let across = Vector3::new(exactly(0.0), -dz, dy);
    let roots = two_roots(middle, across, left);
    let mut q = roots.first().unwrap_or(&middle).map(DoubleDouble::nearest);
    let certificate = certify(&model, drives, &mut q, rng);
    judge(certificate, &q, &roots, ("dyad", seed))
}

/// A million with those of [`near_turning_points`](super::near_turning_points).
#[test]
fn no_proof_is_false_for_linkages_near_a_singularity() {
    for (name, cases, case) in [
        (
            "rod",
            300_000,
            rod_case::<f64> as fn(u64, &mut Rng) -> Counts,
        ),
        ("rod of f32", 100_000, rod_case::<f32>),
        ("crank", 200_000, crank_case),
        ("dyad", 300_000, dyad_case),
    ] {
        let counts = sum_of_cases(cases, case);
        println!("{name}, seeds 0..{cases}: {counts:?}");
        assert!(counts.proved > counts.cases / 10 && counts.refused > counts.cases / 4);
    }
}
