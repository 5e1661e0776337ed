//! The front end for listings: it turns the text of a listing into a system of equations and the order of their
//! elimination.
//!
//! `suspension-macros` generates Rust from this system; `suspension-runtime` walks it at run time.

mod check;
mod cluster;
pub mod did_you_mean;
pub mod eliminate;
pub mod errors;
mod flat;
pub mod form;
pub mod include;
mod kind;
mod lexed;
mod listing;
mod lower;
pub mod matching;
mod mistake;
pub mod name;
pub mod parse;
mod random;
pub mod sample;
mod sides;
mod site;
mod statement;
pub mod system;
pub mod text;
mod vector;

use eliminate::EliminationOrder;
use errors::Errors;
use system::{Positions, System};

pub use kind::Kind;
pub use listing::Listing;

/// The system of a listing, and everything that is wrong with it, including the `errors` of its statements. If the
/// listing has mistakes, the system contains what can be determined.
pub fn checked(listing: &Listing, mut errors: Errors) -> (System, syn::Result<()>) {
    check::names(listing, &mut errors);
    let mut on_the_way = Errors::default();
    let system = lower::system(listing, &mut on_the_way);
    if !listing.incomplete {
        for statement in &listing.statements {
            statement.check_lowered(listing, &system, &mut errors);
        }
    }
    if errors.is_empty() {
        check::chassis_points(listing, &mut errors);
        errors.append(on_the_way);
        check::generated_names(listing, &system, &mut errors);
        check::determined(listing, &system, &mut errors);
    }
    let errors = check::report_one_side(listing, errors);
    (system, errors.into_result())
}

/// The order in which a system without mistakes is eliminated: chosen by the positions around its design if the
/// listing states it, otherwise by typical suspension designs; if none of those is regular, by structure alone.
pub fn order(system: &System) -> EliminationOrder {
    match system.design() {
        Some(design) => order_at(system, design),
        None => match sample::likely(system) {
            designs if designs.is_empty() => {
                eliminate::order(system.size(), &sample::entries(system, &[]))
            }
            designs => eliminate::order_for_most(system.size(), &sample::entries(system, &designs)),
        },
    }
}

/// As [`order`], by the positions around a given design.
pub fn order_at(system: &System, design: Positions) -> EliminationOrder {
    let entries = sample::entries(system, &sample::positions(system, design));
    eliminate::order(system.size(), &entries)
}
