//! Listings with published hardpoints, moved to published states.

use nalgebra::Vector3;
use suspension_core::body::angular_velocity;
use suspension_core::listing::{Kind, Part, Parts as _};
use suspension_core::signal::Number as _;
use suspension_core::wheel::{Carrier, contact};
use suspension_core::{Corner, Signal, Values};
use suspension_runtime::{Listing, Model};

/// Room for the unknowns of all these listings.
const ROOM: usize = 30;

/// A number with its derivatives with respect to what drives it.
pub(crate) type Number = Signal<f64>;

/// A double wishbone with rack steering.
pub(crate) const DOUBLE_WISHBONE: &str = "
    fixed: lower_inboard_front, lower_inboard_rear, upper_inboard_front, upper_inboard_rear, trackrod_inboard;
    free:  lower_outboard, upper_outboard, trackrod_outboard, axle_outboard;

    link lower_fore: lower_inboard_front -> lower_outboard;
    link lower_aft:  lower_inboard_rear  -> lower_outboard;
    link upper_fore: upper_inboard_front -> upper_outboard;
    link upper_aft:  upper_inboard_rear  -> upper_outboard;
    link trackrod:   trackrod_inboard    -> trackrod_outboard;
    body upright:    lower_outboard, upper_outboard, trackrod_outboard, axle_outboard;
    point axle_inboard: upright;

    drive bump:  axle_outboard.z;
    drive steer: trackrod_inboard.y;";

/// Five links; the track rod's inner end moves.
pub(crate) const FIVE_LINK: &str = "
    fixed: upper_front_inboard, upper_rear_inboard, lower_front_inboard, lower_rear_inboard, trackrod_inboard;
    free:  upper_front, upper_rear, lower_front, lower_rear, trackrod, axle_outboard;

    link one:   upper_front_inboard -> upper_front;
    link two:   upper_rear_inboard  -> upper_rear;
    link three: lower_front_inboard -> lower_front;
    link four:  lower_rear_inboard  -> lower_rear;
    link five:  trackrod_inboard    -> trackrod;
    body upright: upper_front, lower_front, trackrod, upper_rear, lower_rear, axle_outboard;
    point axle_inboard: upright;

    drive bump:  axle_outboard.z;
    drive steer: trackrod_inboard.y;";

/// A listing with hardpoints in the axes of ISO 8855: `axle_inboard` and `axle_outboard`, the wheel centre, are on
/// the spin axis; the drives are `bump` and `steer`.
pub(crate) struct Suspension {
    listing: Listing,
    hardpoints: Vec<Vector3<f64>>,
}

impl Suspension {
    pub(crate) fn new(statements: &str, point: impl Fn(&str) -> Vector3<f64>) -> Self {
        let listing = Listing::parse(statements).unwrap_or_else(|mistakes| panic!("{mistakes}"));
        let hardpoints: Vec<_> = names(&listing).map(point).collect();
        Self {
            listing: listing.ordered_at(&hardpoints),
            hardpoints,
        }
    }

    /// In its design position.
    pub(crate) fn design(&self) -> Position<'_> {
        let corner = self.listing.corner(&self.hardpoints);
        Position {
            listing: &self.listing,
            corner: corner.unwrap_or_else(|error| panic!("{error}")),
        }
    }
}

/// The points of a listing in order.
fn names(listing: &Listing) -> impl Iterator<Item = &str> {
    let count: usize = Kind::POINTS.map(|kind| listing.count(kind)).iter().sum();
    (0..count).map(|index| listing.name(Part::Point(index)))
}

/// A suspension in a position.
#[derive(Clone, Copy)]
pub(crate) struct Position<'l> {
    listing: &'l Listing,
    corner: Corner<Model<'l, f64, ROOM>, ROOM>,
}

impl<'l> Position<'l> {
    /// Bump travel and shift of the rack from here, to the left as ISO 8855 has it.
    pub(crate) fn moved(mut self, by: [f64; 2]) -> Self {
        let drives = Signal::line(self.corner.drives(), self.change(by), 1.0).value;
        let stepped = self.corner.step(1.0, Signal::still(drives));
        stepped.unwrap_or_else(|error| panic!("{by:?}: {error}"));
        self
    }

    fn change<D: Values<f64>>(&self, [bump, steer]: [f64; 2]) -> D {
        let place = |name| self.listing.drive(name).expect("a drive");
        D::from_values([])
            .with(place("bump"), bump)
            .with(place("steer"), steer)
    }

    /// As the drives change in this direction.
    pub(crate) fn per(&self, change: [f64; 2]) -> Moving<'l> {
        let derivatives = self.corner.per(self.change(change));
        let points = derivatives.unwrap_or_else(|error| panic!("{error}")).points;
        let components = |rate: usize| {
            let all = [&points.value, &points.rate, &points.second_rate];
            all[rate].values().collect::<Vec<_>>()
        };
        Moving {
            listing: self.listing,
            points: [0, 1, 2].map(components),
        }
    }

    /// As bump travel grows.
    pub(crate) fn in_bump(&self) -> Moving<'l> {
        self.per([1.0, 0.0])
    }

    /// As the rack moves to the left.
    pub(crate) fn in_steering(&self) -> Moving<'l> {
        self.per([0.0, 1.0])
    }
}

/// A suspension that moves.
pub(crate) struct Moving<'l> {
    listing: &'l Listing,
    /// With first and second derivatives.
    points: [Vec<Vector3<f64>>; 3],
}

impl Moving<'_> {
    /// A point.
    pub(crate) fn point(&self, name: &str) -> Vector3<Number> {
        let place = self.listing.point(name);
        let place = place.unwrap_or_else(|| panic!("no point {name}"));
        let [value, rate, second_rate] = [0, 1, 2].map(|rate| self.points[rate][place]);
        let signal = Signal {
            value,
            rate,
            second_rate,
        };
        signal.components()
    }

    pub(crate) fn centre(&self) -> Vector3<Number> {
        self.point("axle_outboard")
    }

    /// Outboard.
    pub(crate) fn spin_axis(&self) -> Vector3<Number> {
        self.centre() - self.point("axle_inboard")
    }

    pub(crate) fn contact(&self, radius: f64) -> Vector3<Number> {
        contact(&self.centre(), &self.spin_axis(), Signal::still(radius))
    }

    /// The carrier by three of its points.
    pub(crate) fn carrier(&self, body: [&str; 3]) -> Carrier<f64> {
        let points = body.map(|name| self.point(name));
        let [at, velocities] = [values, rates].map(|part| points.each_ref().map(part));
        Carrier {
            centre: values(&self.centre()),
            velocity: rates(&self.centre()),
            omega: angular_velocity(&at, &velocities).expect("three points not in line"),
        }
    }
}

pub(crate) fn values(point: &Vector3<Number>) -> Vector3<f64> {
    point.map(|number| number.value)
}

pub(crate) fn rates(point: &Vector3<Number>) -> Vector3<f64> {
    point.map(|number| number.rate)
}

/// From x rearwards and y to the right to the axes of ISO 8855, and back.
pub(crate) fn half_turn(v: Vector3<f64>) -> Vector3<f64> {
    Vector3::new(-v.x, -v.y, v.z)
}

pub(crate) fn length(span: &Vector3<Number>) -> Number {
    span.dot(span).square_root()
}
