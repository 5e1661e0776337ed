//! Random listings at run time, against independent methods: differences of the residual, dense elimination, and complex
//! steps.

use nalgebra::{Complex, SVector, Vector3};
use suspension_core::linkage::Factors;
use suspension_core::listing::Kind;
use suspension_core::solve::lu::Lu;
use suspension_core::{Build, Inputs, Linkage, Listing as _, Motion, Signal, Tracker, Values};
use suspension_runtime::{Fitted, Listing, Model, Room, Size, Work};

use crate::back_ends::hardpoints;
use crate::random;

/// The largest growth of pivots at which solutions are compared.
const HEALTHY: f64 = 1e3;

/// The results for a listing.
#[derive(Default)]
struct Found {
    /// Whether solutions were compared with dense ones.
    solved: bool,
    /// The number of steps of a motion.
    steps: usize,
}

/// Checks a listing at hardpoints.
struct Check<'a>(&'a [Vector3<f64>]);

impl Work for Check<'_> {
    type Answer = Option<Found>;

    fn on<const N: usize>(self, listing: Fitted<'_, N>) -> Option<Found>
    where
        Room<N>: Size,
    {
        let design = Values::from_values(self.0.iter().copied());
        let model = Model::<f64, N>::of(listing, &design).ok()?;
        let at = At::new(&model, &design);
        at.derivatives();
        at.inputs();
        at.constants(&design);
        complex_step(&model, &at);
        Some(Found {
            solved: at.solutions(),
            steps: at.motion(&design),
        })
    }
}

/// The model in complex numbers has the derivatives of the real one.
fn complex_step<const N: usize>(model: &Model<'_, f64, N>, at: &At<'_, Model<'_, f64, N>, N>)
where
    Room<N>: Size,
{
    const STEP: f64 = 1e-30;
    let complex = Fitted::converted(model, |x: f64| Complex::from(x));
    let d = at.change();
    let q = at.q.zip_map(&d, |q, d| Complex::new(q, STEP * d));
    let fixed = at.fixed.values().map(|point| point.map(Complex::from));
    let drives = at.drives.values().map(Complex::from);
    let residual = complex.residual(
        &q,
        &Values::from_values(fixed),
        &Values::from_values(drives),
    );
    let found = residual.map(|residual| residual.im / STEP);
    let expected = model.jacobian(&at.q, &at.fixed) * d;
    all_close(
        "a complex step",
        &found,
        &expected,
        1e-12 * (1.0 + expected.amax()),
    );
}

/// A model at its design position.
struct At<'a, L: Linkage<N>, const N: usize> {
    model: &'a L,
    count: usize,
    q: SVector<f64, N>,
    fixed: L::Fixed,
    drives: L::Drives,
}

fn close(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance
}

#[track_caller]
fn all_close<const N: usize>(
    what: &str,
    found: &SVector<f64, N>,
    expected: &SVector<f64, N>,
    tolerance: f64,
) {
    let off = (found - expected).amax();
    assert!(off <= tolerance, "{what} is off by {off:e}");
}

impl<'a, L: Build<N, Scalar = f64> + Copy, const N: usize> At<'a, L, N> {
    fn new(model: &'a L, design: &L::Points) -> Self {
        let anchors = L::Fixed::from_values(design.values());
        let count = model.count(Kind::ChassisPoint);
        let fixed = L::Fixed::from_values(anchors.values().take(count));
        let signal = Signal {
            value: model.drives_at(design),
            ..Signal::default()
        };
        Self {
            model,
            count: model.count(Kind::Unknown),
            q: model.unknowns(design),
            fixed,
            drives: model.coordinates(&signal).value,
        }
    }

    /// A change of all unknowns.
    fn change(&self) -> SVector<f64, N> {
        SVector::from_fn(|row, _| {
            if row < self.count {
                (row as f64).cos()
            } else {
                0.0
            }
        })
    }

    fn residual(&self, q: &SVector<f64, N>) -> SVector<f64, N> {
        self.model.residual(q, &self.fixed, &self.drives)
    }

    /// The design solves the equations; they are quadratic, with the stated derivatives.
    fn derivatives(&self) {
        let zero = SVector::zeros();
        let start = self.residual(&self.q);
        // Random points are on no line that they slide on.
        let slides = self.count > 3 * self.model.count(Kind::FreePoint);
        assert!(slides || start.amax() < 1e-12, "off by {:e}", start.amax());
        let jacobian = self.model.jacobian(&self.q, &self.fixed);
        for column in 0..N {
            let mut step = zero;
            step[column] = 0.5;
            let difference = self.residual(&(self.q + step)) - self.residual(&(self.q - step));
            let column = jacobian.column(column).into_owned();
            all_close(
                "a column",
                &difference,
                &column,
                1e-10 * (1.0 + column.amax()),
            );
        }
        let d = self.change();
        let at_rest = L::Fixed::default();
        let bent = self.model.curvature(&d, &at_rest, &d, &at_rest) * 0.5;
        let moved = start + jacobian * d + bent;
        all_close(
            "a quadratic",
            &self.residual(&(self.q + d)),
            &moved,
            1e-9 * (1.0 + moved.amax()),
        );
        assert!(bent.iter().skip(self.count).all(|x| *x == 0.0));
    }

    /// Drives and chassis points enter with the stated rates.
    fn inputs(&self) {
        let ones = L::Drives::from_values(self.drives.values().map(|_| 1.0));
        let pace = |place: usize| Vector3::new(0.3, -0.2, 0.5) * (1.0 + place as f64);
        let count = self.model.count(Kind::ChassisPoint);
        let rates = L::Fixed::from_values((0..count).map(pace));
        let driven = self.model.drive_anchors(L::Fixed::default(), &ones);
        let rates = self.model.drive_anchors(rates, &ones);
        let residual = |by: f64| {
            let values = self.fixed.values().zip(rates.values());
            let fixed = L::Fixed::from_values(values.map(|(point, rate)| point + rate * by));
            let drives = L::Drives::from_values(self.drives.values().map(|drive| drive + by));
            self.model.residual(&self.q, &fixed, &drives)
        };
        let difference = residual(-0.5) - residual(0.5);
        let of_drives = self.model.drive_rate(&self.q, &self.fixed, &rates, &ones);
        let of_chassis = self.model.chassis_rate(&self.q, &self.fixed, &rates);
        let sum = of_drives + of_chassis;
        all_close("input rates", &difference, &sum, 1e-9 * (1.0 + sum.amax()));
        // Undriven coordinates of driven points count as the drive's.
        let moved = driven.values().filter(|rate| *rate != Vector3::zeros());
        assert!(moved.count() <= self.model.count(Kind::Drive));
    }

    /// Lengths and shapes are those of the design.
    fn constants(&self, design: &L::Points) {
        let lengths = self.model.lengths();
        let same = self.model.with_lengths(&lengths).expect("its own lengths");
        for (kept, again) in lengths.values().zip(same.lengths().values()) {
            assert!(close(kept, again, 1e-12));
        }
        let fitted = self.model.fit(&self.q, &self.fixed);
        all_close("a fit", &fitted, &self.q, 1e-9);
        let points = self.model.points(&self.q, &self.fixed);
        for (point, stated) in points.values().zip(design.values()) {
            assert!((point - stated).amax() < 1e-12);
        }
    }

    /// Solutions with the factors equal those of dense elimination, if the pivots are healthy.
    fn solutions(&self) -> bool {
        let jacobian = self.model.jacobian(&self.q, &self.fixed);
        let factors = self.model.factor(&self.q, &self.fixed);
        let growth = factors.growth_squared().sqrt();
        let Some(dense) = Lu::factor(&jacobian).ok().filter(|_| growth < HEALTHY) else {
            return false;
        };
        let x = self.change();
        let tolerance = 1e-13 * growth * growth.max(10.0);
        all_close("a solution", &factors.solve(&(jacobian * x)), &x, tolerance);
        let transposed = factors.solve_transposed(&jacobian.tr_mul(&x));
        all_close("a transposed solution", &transposed, &x, tolerance);
        all_close(
            "a dense solution",
            &dense.solve(&(jacobian * x)),
            &x,
            tolerance,
        );
        let sign = Factors::determinant_sign(&dense);
        assert_eq!(factors.determinant_sign() > 0.0, sign > 0.0);
        true
    }

    /// Follows a little of a motion; each position solves the equations.
    fn motion(&self, design: &L::Points) -> usize {
        let rest = self.model.drives_at(design);
        let mut motion = Motion::at_rest(self.q);
        for step in 0..20 {
            let t = 1e-3 * f64::from(step);
            let inputs = Inputs::still(Signal {
                value: rest.map(|drive| drive + 0.1 * t),
                rate: rest.map(|_| 0.1),
                second_rate: rest.map(|_| 0.0),
            });
            let tracker = Tracker::default();
            if tracker
                .step(self.model, &inputs, 1e-3, &mut motion)
                .is_err()
            {
                return step as usize;
            }
            let drives = self.model.coordinates(&inputs.drives).value;
            let fixed = self.model.drive_anchors(*self.model.fixed(), &drives);
            let left = self.model.residual(&motion.position, &fixed, &drives);
            assert!(left.amax() < 1e-12);
            assert!(motion.position.iter().skip(self.count).all(|x| *x == 0.0));
        }
        20
    }
}

#[test]
fn random_listings_agree_with_independent_methods() {
    let (mut solved, mut steps, mut largest) = (0, 0, 0);
    for seed in 0..200 {
        let text = random::listing(seed, [4, 8, 16][(seed % 3) as usize]);
        let listing = Listing::parse(&text).expect("a listing");
        let mut random = fastrand::Rng::with_seed(seed);
        let hardpoints = hardpoints(&listing, &mut random);
        let listing = listing.ordered_at(&hardpoints);
        if let Some(found) = listing.in_its_size(Check(&hardpoints)) {
            solved += usize::from(found.solved);
            steps += found.steps;
            largest = largest.max(listing.size());
        }
    }
    assert!(solved >= 150, "{solved} of 200 compared");
    assert!(steps >= 1800, "{steps} steps");
    assert!(largest > 50);
}
