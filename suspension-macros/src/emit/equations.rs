//! The unrolled residual, Jacobian, curvature and input rates: `impl Linkage`.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use syn::Ident;

use super::{indices, readout};
use crate::system::{AXES, Body, Equation, Site, SiteMotion, System, carried_name, frame_name};

pub(super) fn linkage_impl(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let tables = tables(system);
    let methods = [
        inputs(system),
        residual(system),
        jacobian(system),
        curvature(system),
        drive_rate(system),
        chassis_rate(system),
        readout::points(system),
    ];
    quote! {
        // Some linkages have no moving anchors, or no markers; their code then takes no notice.
        #[allow(unused_variables)]
        impl<T: Scalar> Linkage<#n> for Model<T> {
            type Scalar = T;
            type Fixed = Fixed<T>;
            type Drives = Drives<T>;
            type Points = Points<T>;
            #tables

            fn fixed(&self) -> &Fixed<T> {
                &self.fixed
            }

            fn size(&self) -> T {
                self.size
            }

            #(#methods)*
        }
    }
}

fn tables(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let equations = system.rows().into_iter().map(|row| row.to_string());
    let free = system.free.iter();
    let unknowns = free.flat_map(|point| AXES.map(|axis| format!("{}.{axis}", point.name)));
    let kinds = system.drives.iter().map(|drive| match drive.angle_of {
        Some(_) => quote!(DriveKind::Angle),
        None => quote!(DriveKind::Coordinate),
    });
    quote! {
        const EQUATIONS: [&'static str; #n] = [#(#equations),*];
        const UNKNOWNS: [&'static str; #n] = [#(#unknowns),*];
        const DRIVE_KINDS: &'static [DriveKind] = &[#(#kinds),*];
    }
}

/// Angles to coordinates, and driven coordinates into anchors.
fn inputs(system: &System) -> TokenStream {
    let angles: Vec<_> = system
        .drives
        .iter()
        .filter(|drive| drive.angle_of.is_some())
        .collect();
    let conversions = angles.iter().map(|drive| {
        let (name, link) = (&drive.named.name, &drive.angle_of);
        quote! {
            let #name = angle_to_coordinate(
                self.#link.length(),
                Signal {
                    value: drives.value.#name,
                    rate: drives.rate.#name,
                    second_rate: drives.second_rate.#name,
                },
            );
        }
    });
    let names: Vec<&Ident> = angles.iter().map(|drive| &drive.named.name).collect();
    let anchors = system
        .drives
        .iter()
        .filter(|drive| !drive.of.is_free() && drive.minus.is_none());
    let anchors = anchors.map(|drive| {
        let (name, point, axis) = (
            &drive.named.name,
            &drive.of.name,
            format_ident!("{}", AXES[drive.axis]),
        );
        quote!(fixed.#point.#axis = drives.#name;)
    });
    let anchors: Vec<TokenStream> = anchors.collect();
    let mutable = (!anchors.is_empty()).then(|| quote!(mut));
    let coordinates = if names.is_empty() {
        quote!(*drives)
    } else {
        quote! {
            Signal {
                value: Drives { #(#names: #names.value,)* ..drives.value },
                rate: Drives { #(#names: #names.rate,)* ..drives.rate },
                second_rate: Drives { #(#names: #names.second_rate,)* ..drives.second_rate },
            }
        }
    };
    quote! {
        #[inline(always)]
        #[allow(clippy::needless_update)]
        fn coordinates(&self, drives: &Signal<Drives<T>>) -> Signal<Drives<T>> {
            #(#conversions)*
            #coordinates
        }

        #[inline(always)]
        fn drive_anchors(#mutable fixed: Fixed<T>, drives: &Drives<T>) -> Fixed<T> {
            #(#anchors)*
            fixed
        }
    }
}

impl Site {
    /// The point's value in one of two structs, by where it belongs.
    fn of(&self, free: &Ident, fixed: &Ident) -> TokenStream {
        let Self { name, .. } = self;
        if self.is_free() {
            quote!(#free.#name)
        } else {
            quote!(#fixed.#name)
        }
    }
}

/// `to - from`.
fn vector(from: &Site, to: &Site, free: &Ident, fixed: &Ident) -> TokenStream {
    let (from, to) = (from.of(free, fixed), to.of(free, fixed));
    quote!(#to - #from)
}

/// `let body_frame = Frame::new(..);` for each body that carries points.
fn frames<'a>(
    system: &'a System,
    suffix: &'a str,
    free: &'a Ident,
    fixed: &'a Ident,
) -> impl Iterator<Item = TokenStream> {
    let bodies = system.bodies.iter().filter(|body| !body.carried.is_empty());
    bodies.map(move |body| {
        let name = format_ident!("{}{suffix}", frame_name(&body.name));
        let points = body.frame.iter().map(|site| site.of(free, fixed));
        quote!(let #name = Frame::new(#(#points),*);)
    })
}

/// `let body_point = self.body_point.method(arguments);` for each point that a body carries.
fn carried<'a>(
    bodies: impl Iterator<Item = &'a Body>,
    call: impl Fn(&Body, &Site) -> TokenStream,
) -> Vec<TokenStream> {
    let mut lets = Vec::new();
    for body in bodies {
        for point in &body.carried {
            let (name, call) = (carried_name(&body.name, &point.name), call(body, point));
            lets.push(quote!(let #name = self.#name.#call;));
        }
    }
    lets
}

fn ident(name: &str) -> Ident {
    Ident::new(name, proc_macro2::Span::call_site())
}

/// The rows of a vector with one entry for each equation.
fn rows(system: &System, entry: impl Fn(&Equation) -> Option<TokenStream>) -> TokenStream {
    let rows = system
        .equations
        .iter()
        .flat_map(|equation| match (equation, entry(equation)) {
            (Equation::Carried { .. }, Some(vector)) => {
                vec![quote!(#vector.x), quote!(#vector.y), quote!(#vector.z)]
            }
            (Equation::Carried { .. }, None) => vec![quote!(T::zero()); 3],
            (_, Some(entry)) => vec![entry],
            (_, None) => vec![quote!(T::zero())],
        });
    quote!(SVector::from([#(#rows),*]))
}

fn residual(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let (free, fixed) = (&ident("free"), &ident("fixed"));
    let frames = frames(system, "", free, fixed);
    let carried = carried(system.bodies.iter(), |body, point| {
        let (point, frame) = (point.of(free, fixed), frame_name(&body.name));
        quote!(residual(#point, &#frame))
    });
    let rows = rows(system, |equation| {
        Some(match equation {
            Equation::Distance {
                named, from, to, ..
            } => {
                let (name, vector) = (&named.name, vector(from, to, free, fixed));
                quote!(self.#name.residual(#vector))
            }
            Equation::Carried { body, point, .. } => {
                let name = carried_name(body, &point.name);
                quote!(#name)
            }
            Equation::Coordinate {
                drive,
                axis,
                of,
                minus,
            } => {
                let axis = ident(AXES[*axis]);
                let of = of.of(free, fixed);
                let minus = minus.as_ref().map(|minus| minus.of(free, fixed));
                let minus = minus.map(|minus| quote!(- #minus.#axis));
                quote!(#of.#axis #minus - drives.#drive)
            }
        })
    });
    quote! {
        #[inline(always)]
        fn residual(&self, q: &SVector<T, #n>, fixed: &Fixed<T>, drives: &Drives<T>) -> SVector<T, #n> {
            let free = Free::of(q);
            #(#frames)*
            #(#carried)*
            #rows
        }
    }
}

fn jacobian(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let (free, fixed) = (&ident("free"), &ident("fixed"));
    let frames = frames(system, "", free, fixed);
    let entries = system.equations.iter().map(|equation| {
        let rows: Vec<TokenStream> = equation.rows().iter().map(indices::equation).collect();
        match equation {
            Equation::Distance {
                named, from, to, ..
            } => {
                let (name, vector) = (&named.name, vector(from, to, free, fixed));
                let to = gradient_entries(to, &rows[0], &quote!());
                let from = gradient_entries(from, &rows[0], &quote!(-));
                quote! {
                    let gradient = self.#name.gradient(#vector);
                    #to
                    #from
                }
            }
            Equation::Carried { body, point, frame } => {
                let (name, frame_of) = (carried_name(body, &point.name), frame_name(body));
                let identity = identity_entries(point, &rows);
                let blocks = ["origin", "second", "third"].into_iter().zip(frame);
                let blocks = blocks.map(|(block, site)| block_entries(site, &rows, &ident(block)));
                quote! {
                    let gradient = self.#name.gradient(&#frame_of);
                    #identity
                    #(#blocks)*
                }
            }
            Equation::Coordinate {
                axis, of, minus, ..
            } => {
                let row = &rows[0];
                let entry = |site: &Site, value: TokenStream| {
                    let column = &indices::unknowns(&site.name)[*axis];
                    site.is_free()
                        .then(|| quote!(columns[#column][#row] = #value;))
                };
                let of = entry(of, quote!(T::one()));
                let minus = minus
                    .as_ref()
                    .and_then(|minus| entry(minus, quote!(-T::one())));
                quote!(#of #minus)
            }
        }
    });
    quote! {
        #[inline(always)]
        fn jacobian(&self, q: &SVector<T, #n>, fixed: &Fixed<T>) -> SMatrix<T, #n, #n> {
            let free = Free::of(q);
            let mut columns = [[T::zero(); #n]; #n];
            #(#frames)*
            #(#entries)*
            from_columns(columns)
        }
    }
}

fn gradient_entries(site: &Site, row: &TokenStream, sign: &TokenStream) -> Option<TokenStream> {
    let [x, y, z] = indices::unknowns(&site.name);
    site.is_free().then(|| {
        quote! {
            columns[#x][#row] = #sign gradient.x;
            columns[#y][#row] = #sign gradient.y;
            columns[#z][#row] = #sign gradient.z;
        }
    })
}

fn identity_entries(site: &Site, rows: &[TokenStream]) -> Option<TokenStream> {
    let columns = indices::unknowns(&site.name);
    site.is_free()
        .then(|| quote!(#(columns[#columns][#rows] = T::one();)*))
}

fn block_entries(site: &Site, rows: &[TokenStream], block: &Ident) -> Option<TokenStream> {
    if !site.is_free() {
        return None;
    }
    let mut entries = TokenStream::new();
    for (i, row) in (1..).zip(rows) {
        for (j, column) in (1..).zip(indices::unknowns(&site.name)) {
            let entry = format_ident!("m{i}{j}");
            entries.extend(quote!(columns[#column][#row] = gradient.#block.#entry;));
        }
    }
    Some(entries)
}

fn curvature(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let [v, v_fixed, w, w_fixed] = &["v", "v_fixed", "w", "w_fixed"].map(ident);
    let frames = frames(system, "_v", v, v_fixed).chain(frames(system, "_w", w, w_fixed));
    let carried = carried(system.bodies.iter(), |body, _| {
        let [v, w] = ["v", "w"].map(|suffix| format_ident!("{}_{suffix}", frame_name(&body.name)));
        quote!(curvature(&#v, &#w))
    });
    let rows = rows(system, |equation| match equation {
        Equation::Distance {
            named, from, to, ..
        } => {
            let name = &named.name;
            let (v, w) = (vector(from, to, v, v_fixed), vector(from, to, w, w_fixed));
            Some(quote!(self.#name.curvature(#v, #w)))
        }
        Equation::Carried { body, point, .. } => {
            let name = carried_name(body, &point.name);
            Some(quote!(#name))
        }
        Equation::Coordinate { .. } => None,
    });
    quote! {
        #[inline(always)]
        fn curvature(
            &self,
            v: &SVector<T, #n>,
            v_fixed: &Fixed<T>,
            w: &SVector<T, #n>,
            w_fixed: &Fixed<T>,
        ) -> SVector<T, #n> {
            let (v, w) = (Free::of(v), Free::of(w));
            #(#frames)*
            #(#carried)*
            #rows
        }
    }
}

fn drive_rate(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let body = anchor_terms(system, SiteMotion::DrivenAnchor, |drive| {
        Some(quote!(drive_rate.#drive))
    });
    quote! {
        #[inline(always)]
        fn drive_rate(
            &self,
            q: &SVector<T, #n>,
            fixed: &Fixed<T>,
            fixed_rate: &Fixed<T>,
            drive_rate: &Drives<T>,
        ) -> SVector<T, #n> {
            #body
        }
    }
}

fn chassis_rate(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let body = anchor_terms(system, SiteMotion::Anchor, |_| None);
    quote! {
        #[inline(always)]
        fn chassis_rate(&self, q: &SVector<T, #n>, fixed: &Fixed<T>, fixed_rate: &Fixed<T>) -> SVector<T, #n> {
            #body
        }
    }
}

/// `-dF/du udot` for the chassis points with the given motion and, where `drive` gives one, the
/// drive's own rate.
fn anchor_terms(
    system: &System,
    motion: SiteMotion,
    drive_rate: impl Fn(&Ident) -> Option<TokenStream>,
) -> TokenStream {
    let (free, fixed) = (&ident("free"), &ident("fixed"));
    let moves = |site: &&Site| site.motion == motion;
    let frames = frames(system, "", free, fixed);
    let moved = system
        .bodies
        .iter()
        .filter(|body| body.frame.iter().any(|site| moves(&site)));
    let gradients = carried(moved, |body, _| {
        let frame = frame_name(&body.name);
        quote!(gradient(&#frame))
    });
    let rows = rows(system, |equation| match equation {
        Equation::Distance {
            named, from, to, ..
        } => moves(&from).then(|| {
            let (name, vector, from) = (&named.name, vector(from, to, free, fixed), &from.name);
            quote!(self.#name.gradient(#vector).dot(&fixed_rate.#from))
        }),
        Equation::Carried { body, point, frame } => {
            let name = carried_name(body, &point.name);
            let blocks = ["origin", "second", "third"]
                .map(ident)
                .into_iter()
                .zip(frame);
            let terms = blocks.filter(|(_, site)| moves(site)).map(|(block, site)| {
                let site = &site.name;
                quote!(- #name.#block * fixed_rate.#site)
            });
            let terms: Vec<TokenStream> = terms.collect();
            (!terms.is_empty()).then(|| quote!((#(#terms)*)))
        }
        Equation::Coordinate {
            drive,
            axis,
            of,
            minus,
        } => {
            let axis = ident(AXES[*axis]);
            let of = Some(of).filter(moves).map(|site| (&site.name, quote!(-)));
            let minus = minus
                .as_ref()
                .filter(moves)
                .map(|site| (&site.name, quote!(+)));
            let ends = of.into_iter().chain(minus);
            let ends = ends.map(|(site, sign)| quote!(#sign fixed_rate.#site.#axis));
            let ends: Vec<TokenStream> = ends.collect();
            match (drive_rate(drive), ends.is_empty()) {
                (None, true) => None,
                (None, false) => Some(quote!(T::zero() #(#ends)*)),
                (Some(rate), _) => Some(quote!(#rate #(#ends)*)),
            }
        }
    });
    quote! {
        let free = Free::of(q);
        #(#frames)*
        #(#gradients)*
        #rows
    }
}
