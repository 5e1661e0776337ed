//! Listings from their text to equations and an order of elimination, called as the macro and models from text call it.

mod bodies;
mod catalogue;
mod did_you_mean;
mod elimination;
mod flat;
mod freedom;
mod include;
mod limits;
mod lowering;
mod mirror;
mod remedies;
mod sampling;
mod texts;

use proc_macro2::{Span, TokenStream};
use suspension_listing::Listing;
use suspension_listing::errors::Errors;
use suspension_listing::include::NoIncludes;
use suspension_listing::system::{Positions, System};
use suspension_listing::{checked, parse, sample, text};
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Ident, Token, Visibility, braced};

/// The listing of `mod name { statements }`.
fn listing(module: TokenStream) -> (Listing, Errors) {
    let parser = |input: ParseStream<'_>| {
        input.call(Attribute::parse_outer)?;
        input.parse::<Visibility>()?;
        input.parse::<Token![mod]>()?;
        input.parse::<Ident>()?;
        let content;
        braced!(content in input);
        parse::statements(&content, Span::call_site(), &NoIncludes)
    };
    parser.parse2(module).expect("a listing")
}

/// The system of a listing, and its mistakes.
fn lower(module: TokenStream) -> (System, Vec<String>) {
    let (listing, errors) = listing(module);
    let (system, found) = checked(&listing, errors);
    let errors = found.err().into_iter().flatten();
    (system, errors.map(|error| error.to_string()).collect())
}

/// The design position, and others that the drives lead to from there.
fn positions(system: &System) -> Vec<Positions> {
    sample::positions(system, system.design().expect("a design position"))
}

/// The text of a catalogue file.
fn catalogue_text(name: &str) -> String {
    let folder = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../suspension-core/src/linkages"
    );
    let file = format!("{folder}/{name}.linkage");
    std::fs::read_to_string(&file).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// The system of a catalogue file.
fn catalogue_system(name: &str) -> System {
    text::parse(&catalogue_text(name), name, &NoIncludes)
        .unwrap_or_else(|mistakes| panic!("{mistakes}"))
}
