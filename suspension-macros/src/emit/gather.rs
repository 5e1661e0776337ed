//! The listing as a type of its own, and its model over other numbers: `impl Listing`.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::quantity;
use super::types::constants;
use suspension_listing::name::Name;
use suspension_listing::system::{System, Wheel};

pub(super) fn listing(system: &System) -> TokenStream {
    let constants = constants(system)
        .map(|(name, kind)| quote!(#name: #kind::gather(|model| model.#name, number)));
    let model = quote! {
        let number = &number;
        Model {
            fixed: gather_vectors(|model| model.fixed, number),
            size: number(&|model| model.size),
            #(#constants,)*
        }
    };
    listing_of(system, &model)
}

/// The implementation, with the given expression that gathers a model.
pub(super) fn listing_of(system: &System, model: &TokenStream) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let names = names(system);
    quote! {
        /// This listing, over any number.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub struct Listing;

        impl Listing {
            /// Names and kinds of its parts.
            pub const PARTS: Names = #names;
        }

        impl Parts for Listing {
            #[inline(always)]
            fn table(&self) -> &Names {
                &Self::PARTS
            }
        }

        impl<T: Scalar> Parts for Model<T> {
            #[inline(always)]
            fn table(&self) -> &Names {
                &Listing::PARTS
            }
        }

        impl AnyNumber<#n> for Listing {
            type Model<T: Scalar> = Model<T>;
            type Fixed<T: Scalar> = Fixed<T>;
            type Drives<T: Scalar> = Drives<T>;
            type Measures<T: Scalar> = Measures<T>;
            type Points<T: Scalar> = Points<T>;

            fn gather<S: Scalar, T: Scalar>(
                _: &Model<S>,
                number: impl Fn(&dyn Fn(&Model<S>) -> S) -> T,
            ) -> Model<T> {
                #model
            }
        }
    }
}

fn names(system: &System) -> TokenStream {
    let equations = system.rows().into_iter().map(|row| row.to_string());
    let free = system.free.iter().map(|point| point.named.name.as_str());
    let scalars = system.scalars.iter().map(Name::as_str);
    let markers = Literal::usize_unsuffixed(system.markers.len());
    let drives = system.drives.iter();
    let drive_kinds = drives.map(|drive| quantity::drive_kind(&drive.quantity));
    let measures = system.measures.iter();
    let measure_kinds = measures.map(|measure| quantity::measure_kind(&measure.quantity));
    let wheels = system
        .wheels
        .iter()
        .map(|wheel| wheel_places(system, wheel));
    quote! {
        Names {
            equations: &[#(#equations),*],
            unknowns: unknown_names![#(#free),*; #(#scalars),*],
            chassis: <Fixed<f64> as Named<Vector3<f64>>>::NAMES,
            points: <Points<f64> as Named<Vector3<f64>>>::NAMES,
            markers: #markers,
            drives: <Drives<f64> as Named<f64>>::NAMES,
            drive_kinds: &[#(#drive_kinds),*],
            measures: <Measures<f64> as Named<f64>>::NAMES,
            measure_kinds: &[#(#measure_kinds),*],
            lengths: <Lengths<f64> as Named<f64>>::NAMES,
            wheels: &[#(#wheels),*],
        }
    }
}

/// The name of a wheel and the indices of its points among all points.
fn wheel_places(system: &System, wheel: &Wheel) -> TokenStream {
    let name = wheel.name.as_ref().map_or("", Name::as_str);
    let points = system.points();
    let place = |name: &Name| points.iter().position(|point| *point == name);
    let places = |names: &[Name]| {
        let places = names.iter().map(|name| place(name).unwrap_or_default());
        let places = places.map(Literal::usize_unsuffixed);
        quote!([#(#places),*])
    };
    let [axis, carrier] = [places(&wheel.axis), places(&wheel.carrier)];
    let kingpin = match &wheel.kingpin {
        Some(ends) => {
            let ends = places(ends);
            quote!(Some(#ends))
        }
        None => quote!(None),
    };
    quote!(WheelPlaces { name: #name, axis: #axis, carrier: #carrier, kingpin: #kingpin })
}
