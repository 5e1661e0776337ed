//! Long steps: the right branch or an error, never another assembly in silence.

use nalgebra::{SVector, Vector3};
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::{
    Build, Inputs, Linkage, Motion, Named, Real, Signal, SolveError, Still, Tracker,
};

use crate::support;

/// How steps ended.
#[derive(Debug, Default)]
struct Ends {
    right: usize,
    refused: usize,
}

impl Ends {
    /// Tries one step and compares it with the true motion, `None` where there is none.
    fn add<T: Real, L: Linkage<15, Scalar = T>>(
        &mut self,
        tracker: &Tracker<T>,
        model: &L,
        inputs: &Inputs<Still, L::Drives>,
        [dt, bound]: [T; 2],
        [from, to]: [Option<&Motion<T, 15>>; 2],
    ) {
        let start = from.expect("a motion to start from");
        let mut motion = *start;
        match tracker.step(model, inputs, dt, &mut motion) {
            Ok(_) => {
                let to = to.expect("no configuration, and yet a success");
                let off = (motion.position - to.position).amax();
                assert!(off <= bound, "another assembly, {off} m away, dt = {dt}");
                self.right += 1;
            }
            Err(_) => {
                assert_eq!(motion, *start, "a refused step changes nothing");
                self.refused += 1;
            }
        }
    }
}

/// Every single step between instants 50 ms apart over the published motion, near and far, forwards
/// and backwards; the ends of those of 50 ms and of 100 ms, and of all others.
fn published<T: Real, L: Build<15, Scalar = T>>(
    model: &L,
    rough: &L::Points,
    inputs: impl Fn(T) -> Inputs<Still, L::Drives>,
    bound: f64,
) -> [Ends; 3] {
    let tracker = Tracker::default();
    let mut motion = support::motions(model, rough, &inputs)[0];
    let instants: Vec<T> = (0..40).map(|i| T::constant(f64::from(i) * 0.05)).collect();
    let mut truth = vec![motion];
    for pair in instants.windows(2) {
        let fine =
            (1..=50).map(|i| pair[0] + (pair[1] - pair[0]) * T::constant(f64::from(i) / 50.0));
        let mut last = pair[0];
        for t in fine {
            let step = tracker.step(model, &inputs(t), t - last, &mut motion);
            step.expect("a regular motion");
            last = t;
        }
        truth.push(motion);
    }
    let mut ends: [Ends; 3] = Default::default();
    for from in 0..truth.len() {
        for to in (0..truth.len()).filter(|to| *to != from) {
            let kind = from.abs_diff(to).min(3) - 1;
            let dt = instants[to] - instants[from];
            let between = [truth.get(from), truth.get(to)];
            let sizes = [dt, T::constant(bound)];
            ends[kind].add(&tracker, model, &inputs(instants[to]), sizes, between);
        }
    }
    ends
}

#[test]
fn jumps_of_the_published_motion() {
    // At 1.95 s, near the turning point, an f32 knows the position to 1e-4 m.
    let cases = [
        published::<f64, _>(
            &support::attia_model(),
            &support::attia_rough(),
            support::attia_inputs,
            1e-12,
        ),
        published::<f64, _>(
            &support::five_link_model(),
            &support::five_link_rough(),
            support::five_link_inputs,
            1e-12,
        ),
        published::<f32, _>(
            &support::attia_model(),
            &support::attia_rough(),
            support::attia_inputs,
            2e-4,
        ),
        published::<f32, _>(
            &support::five_link_model(),
            &support::five_link_rough(),
            support::five_link_inputs,
            2e-4,
        ),
    ];
    for ends in cases {
        println!("50 ms, 100 ms, longer: {ends:?}");
        let [fifty, hundred, _] = ends;
        assert!(fifty.refused <= 2, "78 steps of 50 ms: {fifty:?}");
        assert!(hundred.refused <= 8, "76 steps of 100 ms: {hundred:?}");
    }
}

/// A generator of the same numbers every time (Marsaglia's xorshift).
struct Random(u64);

impl Random {
    /// In [0, 1).
    fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn vector(&mut self, size: f64) -> Vector3<f64> {
        Vector3::from_fn(|_, _| (self.uniform() * 2.0 - 1.0) * size)
    }
}

/// A drive that is accelerated evenly.
#[derive(Clone, Copy)]
struct Drive {
    start: f64,
    rate: f64,
    second_rate: f64,
}

impl Drive {
    fn inputs<D: Named<f64>>(&self, t: f64) -> Inputs<Still, D> {
        let &Self {
            start,
            rate,
            second_rate,
        } = self;
        Inputs::still(Signal {
            value: D::from_fn(|_| start + rate * t + second_rate * t * t / 2.0),
            rate: D::from_fn(|_| rate + second_rate * t),
            second_rate: D::from_fn(|_| second_rate),
        })
    }
}

const FINE: f64 = 1e-3;

/// The motion from the design in fine steps, as far as it goes.
fn fine_motion<L: Build<15, Scalar = f64>>(
    model: &L,
    design: &L::Points,
    drive: &Drive,
) -> Vec<Motion<f64, 15>> {
    let tracker = Tracker::default();
    let mut motion = Motion::at_rest(L::unknowns(design));
    let mut truth = Vec::new();
    let mut last = 0.0;
    for index in 0..1500 {
        let t = f64::from(index) * FINE;
        let inputs = |t| drive.inputs::<L::Drives>(t);
        if tracker
            .advance(model, inputs, last, t, &mut motion)
            .is_err()
        {
            break;
        }
        truth.push(motion);
        last = t;
    }
    truth
}

/// Steps of 2 ms to 1 s of suspensions with random points, from random places, either way.
fn random_jumps<L: Build<15, Scalar = f64>>(rough: &L::Points, seed: u64) -> Ends {
    println!("seed {seed}");
    let mut random = Random(seed);
    let tracker = Tracker::default();
    let mut ends = Ends::default();
    for index in 0..240 {
        let size = [0.02, 0.1, 0.3][index % 3];
        let mut points = rough.values();
        let design =
            L::Points::from_fn(|_| points.next().unwrap_or_default() + random.vector(size));
        let Ok(model) = L::new(&design) else {
            continue;
        };
        let drive = Drive {
            start: model.drives_at(&design).values().next().unwrap_or_default(),
            rate: random.uniform() * 4.0 - 2.0,
            second_rate: random.uniform() * 4.0 - 2.0,
        };
        let truth = fine_motion(&model, &design, &drive);
        for _ in 0..if truth.len() < 20 { 0 } else { 40 } {
            let from = (random.uniform() * truth.len() as f64) as usize;
            let length = 10_f64.powf(random.uniform() * 2.7) * 2.0;
            let forwards = random.uniform() < 0.5;
            let Some(to) = from.checked_add_signed(if forwards {
                length as isize
            } else {
                -(length as isize)
            }) else {
                continue;
            };
            if to >= 1500 {
                continue;
            }
            let dt = (to as f64 - from as f64) * FINE;
            let inputs = drive.inputs(to as f64 * FINE);
            let between = [truth.get(from), truth.get(to)];
            ends.add(&tracker, &model, &inputs, [dt, 1e-7], between);
        }
    }
    ends
}

#[test]
fn jumps_of_random_suspensions() {
    let ends = [
        random_jumps::<attia2003::Model<f64>>(&support::attia_rough(), 2003),
        random_jumps::<five_link::Model<f64>>(&support::five_link_rough(), 17),
    ];
    for ends in ends {
        println!("{ends:?}");
        assert!(ends.right > 3000, "{ends:?}");
    }
}

/// A suspension with two turning points of the drive close together: a step across both ends with the
/// same sign of the determinant, near enough to its prediction for every other test.
#[test]
fn an_even_number_of_singularities_is_seen() {
    let mut points = [
        [
            -1.5108121929112002,
            0.24921197502089995,
            -0.06058312204111056,
        ],
        [-1.588159124548218, -0.07566166830110822, -0.534251005633094],
        [-1.1086765251039115, 0.8499229613210226, -0.3274438547726599],
        [-1.7104483203639824, 0.9646439450283073, 0.36267912730321045],
        [
            -1.1436341078664842,
            0.4830277954478788,
            -0.13568867314336422,
        ],
        [-1.5926017879146497, 0.4131412170712462, 0.26274295407965464],
        [-1.6802722614032846, 0.3674213256795723, 0.6674456293510402],
        [
            -1.2047113964623082,
            0.23181577636930922,
            -0.035602614725374265,
        ],
        [
            -0.639192293726621,
            -0.14904542220609235,
            0.019729072805196424,
        ],
        [-1.1527458820263188, 0.3354102943425843, 0.03879444396387305],
        [-1.3411262584142414, 0.3589877806043034, 0.4515637918620492],
    ]
    .into_iter();
    let design = five_link::Points::from_fn(|_| Vector3::from(points.next().expect("11 points")));
    let model = five_link::Model::new(&design).expect("a geometry");
    let drive = Drive {
        start: model.drives_at(&design).theta,
        rate: -0.6467181928322563,
        second_rate: 0.4042771321327354,
    };
    let inputs = |t| drive.inputs::<five_link::Drives<f64>>(t);
    let guarded = Tracker::default();
    let unguarded = Tracker {
        change_of_jacobian: f64::MAX,
        ..guarded
    };
    let (from, to) = (1.247, 1.782);
    let mut start = Motion::at_rest(five_link::Model::unknowns(&design));
    let followed = guarded.advance(&model, inputs, 0.0, from, &mut start);
    followed.expect("a regular motion");
    let mut jumped = start;
    let step = unguarded.step(&model, &inputs(to), to - from, &mut jumped);
    step.expect("another assembly, in silence");
    assert_eq!(jumped.positive_determinant, start.positive_determinant);
    let mut true_motion = start;
    // The drive locks before the step's end: the motion does not go there at all.
    let followed = guarded.advance(&model, inputs, from, to, &mut true_motion);
    let stopped = followed.expect_err("a lock");
    assert!((stopped.reached - 1.491_577).abs() < 1e-6, "{stopped:?}");
    assert!((true_motion.position - jumped.position).amax() > 1e-3);
    let mut motion = start;
    let refused = guarded.step(&model, &inputs(to), to - from, &mut motion);
    assert!(
        matches!(refused, Err(SolveError::TooFar { .. })),
        "{refused:?}"
    );
    assert_eq!(motion, start);
}

/// However far apart two inputs, sub-steps lead from one to the other, at rest or not.
#[test]
fn inputs_far_apart_are_joined_in_sub_steps() {
    let model: five_link::Model<f64> = support::five_link_model();
    let inputs = support::five_link_inputs::<f64>;
    let motions = support::motions(&model, &support::five_link_rough(), inputs);
    let tracker = Tracker::default();
    let join = |from: usize, to: usize, dt: f64| {
        let [first, last] = [from, to].map(|instant| inputs(support::INSTANTS[instant]));
        let mut motion = motions[from];
        let advanced = tracker
            .step_between(&model, [&first, &last], dt, &mut motion)
            .expect("a configuration within reach");
        let off: SVector<f64, 15> = motion.position - motions[to].position;
        assert!(off.amax() < 1e-13, "{from} to {to}: {} m", off.amax());
        let off = motion.acceleration - motions[to].acceleration;
        let size = motions[to].acceleration.amax();
        assert!(off.amax() < 1e-10 * size, "the rates are those of the end");
        advanced.steps
    };
    for (from, to) in [(0, 8), (8, 0), (2, 5), (7, 1), (3, 3)] {
        let dt = support::INSTANTS[to] - support::INSTANTS[from];
        let dt = if dt == 0.0 { 1e-3 } else { dt };
        let steps = [dt, 1e-3].map(|dt| join(from, to, dt));
        println!("from instant {from} to {to}: {steps:?} sub-steps");
    }
    let locked = Inputs::still(Signal {
        value: five_link::Drives { theta: 3.0 },
        ..Signal::default()
    });
    let mut motion = motions[0];
    let ends = [&inputs(0.0), &locked];
    let stopped = tracker.step_between(&model, ends, 1.0, &mut motion);
    assert!(stopped.is_err_and(|stopped| stopped.reached < 1.0));
    assert_eq!(motion, motions[0]);
}
