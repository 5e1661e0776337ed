//! The table of methods, one row each.

use nalgebra::{Const, DimMin, SVector};
use suspension_core::{Build, Linkage, Listing, Real, Values};

use super::baked::{Baked, Tables};
use super::by_series::BySeries;
use super::formulation::absolute::Absolute;
use super::formulation::five_links::FiveLinks;
use super::formulation::points::Points;
use super::formulation::relative::Relative;
use super::in_lanes::InLanes;
use super::method::Method;
use super::newton::{Nalgebra, Newton, Own};
use super::tracked::{InCorrections, ToTolerance, Tracked};
use super::trial::{Candidate, Entry};
use suspension_double_double::DoubleDouble;
use suspension_lanes::{Lane, Lanes};

/// The methods of the chart, for drives `D` and `N` coordinates.
pub struct Methods<'a, D, const N: usize> {
    /// The methods in the order of the table.
    pub rows: Vec<Box<dyn Candidate<'a, D, N> + 'a>>,
}

impl<'a, D: Values<f64> + 'a, const N: usize> Methods<'a, D, N> {
    /// The methods that work on one suspension, in the number type of `model`. `position` are the
    /// coordinates at the first instant.
    pub fn add_scalar<T, L, M>(
        &mut self,
        published: &L,
        model: &'a M,
        position: &SVector<DoubleDouble, N>,
    ) where
        T: Real,
        L: Build<N, Scalar = f64>,
        M: Linkage<N, Scalar = T>,
        Const<N>: DimMin<Const<N>, Output = Const<N>>,
    {
        let (scalar, points) = (std::any::type_name::<T>(), Points(model));
        self.add("nalgebra_lu", scalar, Newton::new(points, Nalgebra));
        self.add("dense_lu", scalar, Newton::new(points, Own));
        self.add("generated", scalar, tracked(model, ToTolerance));
        self.add("bounded_1", scalar, tracked(model, InCorrections::<1>));
        self.add("bounded_2", scalar, tracked(model, InCorrections::<2>));
        self.add("bounded_3", scalar, tracked(model, InCorrections::<3>));
        self.add("series_2", scalar, BySeries::<_, 2>(model));
        self.add("series_3", scalar, BySeries::<_, 3>(model));
        self.add("series_4", scalar, BySeries::<_, 4>(model));
        self.add("series_5", scalar, BySeries::<_, 5>(model));
        self.add("series_6", scalar, BySeries::<_, 6>(model));
        self.add("series_7", scalar, BySeries::<_, 7>(model));
        self.add("series_8", scalar, BySeries::<_, 8>(model));
        if let Some(links) = FiveLinks::<T>::of(published, position) {
            self.add("absolute", scalar, Newton::new(Absolute(links), Own));
            self.add("relative", scalar, Newton::new(Relative::new(links), Own));
        }
    }

    /// Adds bounded steps in lanes, in the number type of `model`. A single lane with the best instructions of the processor
    /// has its own name.
    pub fn add_lanes<G, T>(&mut self, model: &'a G::Model<T>)
    where
        G: Listing<N, Drives<f64> = D> + 'static,
        T: Lane,
    {
        let one = Lanes::<G, T, N, 1>::new;
        self.rows
            .push(Box::new(InLanes::new("bounded_1_vector", model, one)));
        let four = Lanes::<G, T, N, 4>::new;
        self.rows
            .push(Box::new(InLanes::new("bounded_1", model, four)));
        let eight = Lanes::<G, T, N, 8>::new;
        self.rows
            .push(Box::new(InLanes::new("bounded_1", model, eight)));
    }

    /// A baked motion, in `f64` and `f32`.
    pub fn add_baked(&mut self, name: &str, tables: &'a Tables<N>) {
        self.add(name, "f64", Baked(tables.double()));
        self.add(name, "f32", Baked(tables.single()));
    }

    fn add<M>(&mut self, name: &str, scalar: &'static str, method: M)
    where
        M: Method<D, N> + Copy + 'a,
    {
        self.rows.push(Box::new(Entry::new(name, scalar, method)));
    }
}

fn tracked<R, S>(linkage: R, stepper: S) -> Tracked<R, S> {
    Tracked { linkage, stepper }
}
