//! The contribution of the inputs' rates to velocity and acceleration: `-dF/du udot`.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::terms::{parameter, position_parameters, vector};
use super::written_out::written_out;
use super::{form, frames};
use suspension_listing::system::{SiteMotion, System};

/// The rates of the drives, and of the chassis points that they move.
pub(super) fn drive_rate(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let body = terms(system, SiteMotion::DrivenAnchor);
    let [q, fixed, fixed_rate] = parameters(system, &body);
    let drive_rate = parameter("drive_rate", &quote!(&Drives<T>), &body);
    written_out(&quote! {
        fn drive_rate(&self, #q, #fixed, #fixed_rate, #drive_rate) -> SVector<T, #n> {
            #body
        }
    })
}

/// The rates of the chassis points that no drive moves.
pub(super) fn chassis_rate(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let body = terms(system, SiteMotion::Anchor);
    let [q, fixed, fixed_rate] = parameters(system, &body);
    written_out(&quote! {
        fn chassis_rate(&self, #q, #fixed, #fixed_rate) -> SVector<T, #n> {
            #body
        }
    })
}

fn parameters(system: &System, body: &TokenStream) -> [TokenStream; 3] {
    let [q, fixed] = position_parameters(system, body);
    [q, fixed, parameter("fixed_rate", &quote!(&Fixed<T>), body)]
}

/// The non-zero rows for the chassis points with the given motion.
fn terms(system: &System, motion: SiteMotion) -> TokenStream {
    let equations = system.equations.iter();
    let rows = equations
        .filter_map(|equation| form::emitter(equation).input_rate(&equation.named.name, motion));
    vector(system, frames::with_free(system), rows)
}
