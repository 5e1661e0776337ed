//! The model from positions or lengths: `impl Build`.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::fields::point_index;
use super::terms::{ident, parameter, value_of};
use super::{clusters, form, frames, lengths, quantity};
use suspension_listing::name::Name;
use suspension_listing::system::{System, carried_name, frame_name};

pub(super) fn build_impl(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let methods = [
        new(system),
        check_pivots(),
        lengths::with_lengths(system),
        with_markers(system),
        lengths::lengths(system),
        drives_at(system),
        fit(system),
    ];
    let sized = sized(system);
    let designed = designed(system);
    quote! {
        #sized

        impl<T: Real> Build<#n> for Model<T> {
            type Lengths = Lengths<T>;

            #(#methods)*
        }

        #designed
    }
}

/// `impl Designed`, if the listing states every point.
fn designed(system: &System) -> Option<TokenStream> {
    let fields: Option<Vec<TokenStream>> = positions(system)
        .map(|(name, at)| {
            let [x, y, z] = at?.map(Literal::f64_unsuffixed);
            Some(quote!(#name: Vector3::new(#x, #y, #z).map(T::constant)))
        })
        .collect();
    let fields = fields?;
    Some(designed_as(system, &quote!(Points { #(#fields),* })))
}

/// Every point with its position, if that is stated.
pub(super) fn positions(system: &System) -> impl Iterator<Item = (&Name, Option<[f64; 3]>)> {
    let points = system.fixed.iter().chain(&system.free);
    let markers = system.markers.iter();
    points
        .map(|point| (&point.named.name, point.at))
        .chain(markers.map(|marker| (&marker.named.name, marker.at)))
}

/// The implementation, with the given expression of the points.
pub(super) fn designed_as(system: &System, points: &TokenStream) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    quote! {
        impl<T: Real> Designed<#n> for Model<T> {
            fn design() -> Points<T> {
                #points
            }
        }
    }
}

fn check_pivots() -> TokenStream {
    quote! {
        fn check_pivots(&self, points: &Points<T>) -> Result<(), GeometryError> {
            check_pivots(self, points)
        }
    }
}

fn new(system: &System) -> TokenStream {
    let frames = system.bodies.iter().map(|body| {
        let name = frame_name(&body.name);
        let [.., third] = &body.frame;
        let third = point_index(system, &third.name);
        let frame = frames::frame_from_points(system, &body.frame, &quote!(at));
        quote!(let #name = parts::frame(#third, #frame)?;)
    });
    let frame_names = system.bodies.iter().map(|body| frame_name(&body.name));
    let [stated, framed] = [false, true].map(|framed| {
        let constants = form::constants(system, framed);
        constants.map(|form::Constant { name, form, .. }| {
            let value = form.constant_from_points(name, system);
            quote!(#name: #value)
        })
    });
    let [cluster_frames, clustered] = clusters::designed(system);
    let markers = markers(system);
    quote! {
        fn of(_listing: Listing, at: &Points<T>) -> Result<Self, GeometryError> {
            parts::finite(at.values())?;
            #(#frames)*
            #cluster_frames
            let model = Self {
                fixed: Fixed::from_values(at.values()),
                size: T::zero(),
                #(#stated,)*
                #(#frame_names,)*
                #(#framed,)*
                #clustered
                #(#markers,)*
            };
            Ok(model.sized())
        }
    }
}

/// The markers' constants from the points `at`.
fn markers(system: &System) -> impl Iterator<Item = TokenStream> {
    system.markers.iter().map(|marker| {
        let name = &marker.named.name;
        let frame = frames::frame_from_points(system, &marker.frame, &quote!(at));
        let index = point_index(system, name);
        quote!(#name: parts::carried(#index, at.#name, &#frame)?)
    })
}

/// Sets `size`, which depends on all other constants.
fn sized(system: &System) -> TokenStream {
    let constants = [false, true].map(|framed| form::constants(system, framed));
    let constants = constants.into_iter().flatten();
    let lengths = constants.filter(|constant| constant.form.has_length());
    let lengths = lengths.map(|constant| constant.name);
    quote! {
        impl<T: Real> Model<T> {
            /// With `size` brought up to the other constants.
            fn sized(self) -> Self {
                Self { size: parts::longest(&[#(self.#lengths.length()),*]), ..self }
            }
        }
    }
}

fn with_markers(system: &System) -> TokenStream {
    let markers: Vec<TokenStream> = markers(system).collect();
    let model = if markers.is_empty() {
        quote!(self)
    } else {
        quote!(Self { #(#markers,)* ..self })
    };
    quote! {
        fn with_markers(self, at: &Points<T>) -> Result<Self, GeometryError> {
            parts::finite(at.values())?;
            Ok(#model)
        }
    }
}

fn drives_at(system: &System) -> TokenStream {
    let values = system.drives.iter().map(|drive| {
        let (name, value) = (&drive.named.name, quantity::driven(drive));
        quote!(#name: #value)
    });
    quote! {
        fn drives_at(&self, points: &Points<T>) -> Drives<T> {
            Drives { #(#values),* }
        }
    }
}

fn fit(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let (free, fixed) = (ident("free"), ident("fixed"));
    let fits = system.bodies.iter().chain(&system.clusters).map(|body| {
        let frame = frame_name(&body.name);
        let carried = body.carried.iter().map(|point| {
            let name = carried_name(&body.name, &point.name);
            quote!(self.#name.position(&self.#frame))
        });
        let sites = || body.frame.iter().chain(&body.carried);
        let guess = sites().map(|site| value_of(site, &free, &fixed));
        let targets = sites().map(|site| {
            let target = value_of(site, &free, &fixed);
            if site.is_free() { target } else { quote!(_) }
        });
        quote! {
            let [origin, second, third] = self.#frame.points();
            [#(#targets),*] = best_rigid_fit(&[origin, second, third, #(#carried),*], &[#(#guess),*]);
        }
    });
    let scalars = form::scalars(system, &|site| value_of(site, &free, &fixed));
    let fits: Vec<TokenStream> = fits.chain(scalars).collect();
    let body = if fits.is_empty() {
        quote!(*q)
    } else {
        quote! {
            let mut free = Free::of(q);
            #(#fits)*
            free.unknowns()
        }
    };
    let fixed = parameter("fixed", &quote!(&Fixed<T>), &body);
    quote! {
        fn fit(&self, q: &SVector<T, #n>, #fixed) -> SVector<T, #n> {
            #body
        }
    }
}
