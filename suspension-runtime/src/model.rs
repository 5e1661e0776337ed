//! The geometry of a listing.

use suspension_core::Scalar;
use suspension_core::generated::gather_vector;
use suspension_core::listing::{DriveKind, Kind, MeasureKind, Part, Parts, WheelPlaces};
use suspension_core::model::constraint::{
    Bilinear, Carried, Distance, Frame, Held, InPlane, OnLine, Product, Stretch, Turn,
};
use suspension_core::model::handedness::Linked;

use crate::fitted::Fitted;
use crate::form::Forms;
use crate::plan::Plan;
use crate::size::{Chassis, Few, Room, Size, Unknowns};
use crate::table::{Table, Value};

/// Lists the tables of constants: what each is for, how many of them a plan has, and what these are called.
macro_rules! model {
    ($($(#[$doc:meta])* $table:ident: $room:ident<$constant:ident>, |$plan:ident| $count:expr, $what:literal;)*) => {
        /// The geometry of a listing: chassis points at rest and the constants of every equation.
        #[derive(Clone, Copy, Debug)]
        pub struct Model<'l, T: Scalar, const N: usize>
        where
            Room<N>: Size,
        {
            pub(crate) listing: Fitted<'l, N>,
            pub(crate) fixed: Chassis<T, N>,
            pub(crate) size: T,
            $($(#[$doc])* pub(crate) $table: $room<$constant<T>, N>,)*
        }

        impl<'l, T: Scalar, const N: usize> Model<'l, T, N>
        where
            Room<N>: Size,
        {
            /// A model whose constants are yet to be found.
            pub(crate) fn with_chassis(listing: Fitted<'l, N>, fixed: Chassis<T, N>) -> Self {
                Self { listing, fixed, size: T::zero(), $($table: Default::default(),)* }
            }

            /// See [`gather`](suspension_core::linkage::Listing::gather).
            pub(crate) fn gather<S: Scalar>(
                listing: Fitted<'l, N>,
                number: impl Fn(&dyn Fn(&Model<'l, S, N>) -> S) -> T,
            ) -> Self {
                let (plan, number) = (listing.plan(), &number);
                Self {
                    listing,
                    fixed: first(plan.chassis.into(), |at| {
                        gather_vector(|model| model.fixed.get(at), number)
                    }),
                    size: number(&|model| model.size),
                    $($table: first((|$plan: &Plan| $count)(plan), |at| {
                        $constant::gather(|model: &Model<'l, S, N>| model.$table.get(at), number)
                    }),)*
                }
            }
        }

        /// How many constants of each kind a plan has, how many there is room for, and what they are called.
        pub(crate) fn counts_of_constants<const N: usize>(plan: &Plan) -> impl Iterator<Item = Count>
        where
            Room<N>: Size,
        {
            [$(((|$plan: &Plan| $count)(plan), <$room<u16, N> as Table<u16>>::ROOM, $what),)*].into_iter()
        }
    };
}

model! {
    markers: Few<Carried>, |plan| plan.markers.len(), "markers";
    /// Constants of all bodies.
    frames: Few<Frame>, |plan| plan.forms.bodies.len(), "bodies";
    /// Constants of the points that all bodies carry.
    carried: Few<Carried>, |plan| plan.forms.carried(), "points carried by bodies";
    cluster_frames: Few<Frame>, |plan| plan.clusters.len(), "rigid parts that links alone make";
    /// Constants of the points of all clusters, except those of their frames.
    linked: Few<Linked>, |plan| plan.linked(), "points that links alone hold rigidly";
    distances: Unknowns<Distance>, |plan| plan.forms.distances.len(), "constant lengths";
    /// Constants of the lines that points slide on.
    lines: Few<OnLine>, |plan| plan.forms.lines.len(), "slides";
    /// Constants of the planes that points stay in.
    planes: Few<InPlane>, |plan| plan.forms.planes.len(), "planes";
    /// Constants of the angles between lines that stay as they are.
    products: Few<Product>, |plan| plan.forms.products.len(), "angles";
    /// Constants of the angles about axes that drives prescribe.
    turns: Few<Turn>, |plan| plan.forms.turns.len(), "driven angles about axes";
    /// Constants of the lengths by which sums of products are divided.
    scales: Few<Bilinear>, |plan| plan.forms.scales.len(), "lengths of driven angles about axes";
    /// Constants of the sums of coordinates that stay as they are.
    held: Few<Held>, |plan| plan.forms.held().count(), "couples";
    /// Constants of the lengths that drives prescribe.
    stretches: Few<Stretch>, |plan| plan.forms.stretches.len(), "driven lengths";
}

/// A count, the most there is room for, and what is counted.
pub(crate) type Count = (usize, usize, &'static str);

impl<'l, T: Scalar, const N: usize> Model<'l, T, N>
where
    Room<N>: Size,
{
    #[inline(always)]
    pub(crate) fn plan(&self) -> &'l Plan {
        self.listing.plan()
    }

    #[inline(always)]
    pub(crate) fn forms(&self) -> &'l Forms {
        &self.plan().forms
    }
}

/// A table whose first `count` places are filled by `make`.
fn first<V: Value, F: Table<V>>(count: usize, make: impl Fn(u16) -> V) -> F {
    F::from_values((0..).take(count).map(make))
}

impl<T: Scalar, const N: usize> Parts for Model<'_, T, N>
where
    Room<N>: Size,
{
    fn name(&self, part: Part) -> &str {
        self.listing.name(part)
    }

    #[inline(always)]
    fn count(&self, kind: Kind) -> usize {
        self.listing.count(kind)
    }

    fn drive_kind(&self, drive: usize) -> DriveKind {
        self.listing.drive_kind(drive)
    }

    fn measure_kind(&self, measure: usize) -> MeasureKind {
        self.listing.measure_kind(measure)
    }

    fn wheel(&self, wheel: usize) -> Option<WheelPlaces<'_>> {
        self.listing.wheel(wheel)
    }
}
