//! A layout of the catalogue, moved.

use std::collections::HashMap;

use nalgebra::Vector3;
use suspension_core::linkages::LISTINGS;
use suspension_core::listing::{Kind, Part, Parts};
use suspension_core::wheel::Wheel;
use suspension_core::{Signal, Values};
use suspension_runtime::Listing;

/// The largest error of a point relative to geometry, m.
pub(crate) const CLOSE: f64 = 1e-12;
/// Travel of a wheel, m: 60 mm of rebound to 60 mm of bump.
pub(crate) const TRAVEL: [f64; 9] = [-0.06, -0.045, -0.03, -0.015, 0.0, 0.015, 0.03, 0.045, 0.06];

type Points = HashMap<String, Vector3<f64>>;

/// A layout of the catalogue.
pub(crate) struct Layout {
    listing: Listing,
    hardpoints: Vec<Vector3<f64>>,
}

/// A configuration of a layout.
pub(crate) struct Pose {
    points: Points,
    rates: HashMap<String, Points>,
    measures: HashMap<String, f64>,
    pub(crate) wheel: Wheel<f64>,
}

impl Layout {
    pub(crate) fn read(name: &str) -> Self {
        let found = LISTINGS.iter().find(|(other, _)| *other == name);
        let listing = Listing::parse(found.expect("in the catalogue").1).expect("a listing");
        let hardpoints = listing.design().expect("all points are stated");
        Self {
            listing,
            hardpoints,
        }
    }

    /// A point of the design.
    pub(crate) fn at(&self, name: &str) -> Vector3<f64> {
        self.hardpoints[self.listing.point(name).expect("a point")]
    }

    /// Moves the drives named by as much from the design, and checks every link, body and slide.
    pub(crate) fn moved(&self, by: &[(&str, f64)]) -> Pose {
        let mut corner = self.listing.corner::<60>(&self.hardpoints).expect("built");
        let start = corner.drives();
        let mut rate = vec![0.0; self.listing.count(Kind::Drive)];
        for (drive, by) in by {
            rate[self.listing.drive(drive).expect("a drive")] = *by;
        }
        let rate = Values::from_values(rate);
        let advanced = corner.advance(1.0, |time| Signal::line(start, rate, time));
        advanced.unwrap_or_else(|stopped| panic!("{by:?}: {stopped}"));
        let per = |drive: usize| {
            let change = Values::from_values(rate_of_one(drive));
            let derived = corner.per(change).expect("not singular");
            self.points(derived.points.rate.values())
        };
        let name = |part| self.listing.name(part).to_owned();
        let drives = 0..self.listing.count(Kind::Drive);
        let measures = corner.measures().value;
        let measured = measures.values().take(self.listing.count(Kind::Measure));
        let measured = measured.enumerate();
        let at: Vec<_> = corner.points().value.values().collect();
        self.check(&at);
        Pose {
            rates: drives
                .map(|drive| (name(Part::Drive(drive)), per(drive)))
                .collect(),
            measures: measured
                .map(|(index, value)| (name(Part::Measure(index)), value))
                .collect(),
            wheel: corner.wheel().expect("a wheel"),
            points: self.points(at.into_iter()),
        }
    }

    fn points(&self, at: impl Iterator<Item = Vector3<f64>>) -> Points {
        let names = (0..self.hardpoints.len()).map(|place| self.listing.name(Part::Point(place)));
        names.map(str::to_owned).zip(at).collect()
    }

    /// Links and bodies have the distances of the design, bodies its handedness; what slides is on its line.
    fn check(&self, at: &[Vector3<f64>]) {
        let keeps = |a: usize, b: usize| {
            let [now, then] = [at, &self.hardpoints].map(|points| (points[a] - points[b]).norm());
            let [a, b] = [a, b].map(|place| self.listing.name(Part::Point(place)));
            assert!((now - then).abs() < CLOSE, "{a} to {b}: {now}, not {then}");
        };
        for [a, b] in self.listing.links() {
            keeps(a, b);
        }
        for body in self.listing.bodies() {
            for (index, &a) in body.iter().enumerate() {
                body[..index].iter().for_each(|&b| keeps(a, b));
            }
            for four in body.windows(4) {
                let [now, then] = [at, &self.hardpoints].map(|points| volume(points, four));
                assert!((now - then).abs() < CLOSE, "a body was turned inside out");
            }
        }
        for [from, to, point] in self.listing.slides() {
            let line = (at[to] - at[from]).normalize();
            let off = line.cross(&(at[point] - at[from])).norm();
            assert!(off < CLOSE, "{off:e} m off the line");
        }
    }
}

impl Pose {
    pub(crate) fn at(&self, name: &str) -> Vector3<f64> {
        self.points[name]
    }

    /// The derivative of a point with respect to a drive.
    pub(crate) fn per(&self, drive: &str, point: &str) -> Vector3<f64> {
        self.rates[drive][point]
    }

    pub(crate) fn measure(&self, name: &str) -> f64 {
        self.measures[name]
    }

    /// Returns the largest distance of this half of the layout from the mirror image of the other, for points with a twin.
    pub(crate) fn off_mirrored(&self, other: &Self) -> f64 {
        let off = self.points.iter().filter_map(|(name, at)| {
            let twin = if name.contains("left") {
                name.replace("left", "right")
            } else {
                name.replace("right", "left")
            };
            let twin = other.points.get(&twin)?;
            Some((at - Vector3::new(twin.x, -twin.y, twin.z)).norm())
        });
        off.fold(0.0, f64::max)
    }
}

/// Returns the rates in which one drive changes at 1.
fn rate_of_one(drive: usize) -> impl Iterator<Item = f64> {
    (0..=drive).map(move |other| f64::from(u8::from(other == drive)))
}

/// Six times the volume between four points, signed.
fn volume(points: &[Vector3<f64>], four: &[usize]) -> f64 {
    let [a, b, c] = [1, 2, 3].map(|corner| points[four[corner]] - points[four[0]]);
    a.cross(&b).dot(&c)
}

/// The roll axis of a live axle passes through two points of its plane of symmetry: where the lower links' lines meet, and a
/// point that is held laterally. Axle and wheel rotate about it, so it determines the ratio of roll steer.
pub(crate) fn rolls_about(layout: &Layout, held: Vector3<f64>) {
    let (front, rear) = (layout.at("lower_left_front"), layout.at("lower_left_rear"));
    let met = front + (rear - front) * (front.y / (front.y - rear.y));
    let axis = met - held;
    let pose = layout.moved(&[]);
    let per = |point| pose.per("bump_left", point) - pose.per("bump_right", point);
    let turned = per("left_wheel_centre") - per("right_wheel_centre");
    let (steer, ratio) = (-turned.x / turned.z, axis.z / axis.x);
    assert!((steer - ratio).abs() < 1e-9, "{steer}, not {ratio}");
    assert!(steer.abs() > 0.01, "a roll steer that is seen: {steer}");
}
