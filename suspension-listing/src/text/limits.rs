//! The limits of a text read at run time: large enough for a car with any four corners of the catalogue, and small enough that
//! no text takes long or much memory.

use std::fmt::Display;

use syn::{Error, Ident};

use crate::lexed::MOST_BYTES;
use crate::listing::{Listing, Rank, Rigid, Statement};
use crate::mistake::Mistake;

/// The largest number of statements, without those that declare points.
pub const MOST_STATEMENTS: usize = 256;

/// The largest number of chassis points and free points together, and of names in one statement.
pub const MOST_POINTS: usize = 128;

/// The largest number of unknowns.
pub const MOST_UNKNOWNS: usize = 120;

/// Refuses a text that is too long.
pub(super) fn length(text: &str) -> Result<(), Mistake> {
    if text.len() <= MOST_BYTES {
        return Ok(());
    }
    Err(Mistake {
        message: format!(
            "the text is {} bytes long; at most {MOST_BYTES} are allowed",
            text.len()
        ),
        line: 1,
        column: 1,
        length: 0,
    })
}

/// Refuses a listing that is too large.
pub(super) fn listing(listing: &Listing) -> syn::Result<()> {
    let points = listing.fixed.len() + listing.free.len();
    let most_names = listing
        .statements
        .iter()
        .map(|other| other.operands().len());
    let counts = [
        (points, MOST_POINTS, "points"),
        (listing.statements.len(), MOST_STATEMENTS, "statements"),
        (
            most_names.max().unwrap_or(0),
            MOST_POINTS,
            "names in one statement",
        ),
    ];
    for (count, most, what) in counts {
        if count > most {
            return Err(refused(listing, &too_many(count, most, what, "")));
        }
    }
    // Slides, planes and driven lengths have further ones.
    let of_points = 3 * listing.free.len();
    few_unknowns(listing, of_points, &format!("at least {of_points}"))
}

/// Refuses a system that is too large.
pub(super) fn unknowns(listing: &Listing, count: usize) -> syn::Result<()> {
    few_unknowns(listing, count, &count.to_string())
}

/// Refuses more unknowns than are allowed, with their count in words.
fn few_unknowns(listing: &Listing, count: usize, counted: &str) -> syn::Result<()> {
    if count > MOST_UNKNOWNS {
        let savings = savings(listing);
        let message = too_many(counted, MOST_UNKNOWNS, "unknowns", &savings);
        return Err(refused(listing, &message));
    }
    Ok(())
}

/// The message that a listing has too many of something, with the remedy: first what should be `tried`, if anything.
pub fn too_many(count: impl Display, most: usize, what: &str, tried: &str) -> String {
    format!(
        "{count} {what}; at most {most} are allowed in a listing read at run time: {tried}state parts that do not meet, as two \
         corners or two axles, in listings of their own, or write it with `linkage!`, which has no such limit"
    )
}

fn refused(listing: &Listing, message: &str) -> Error {
    Error::new(listing.free_span, message)
}

/// A sentence that tells which free points could be markers without unknowns; empty if none is known.
fn savings(listing: &Listing) -> String {
    let bodies = listing.statements.iter();
    let mut bodies = bodies.filter_map(|body| Some((body.named()?.0, spared(listing, &**body))));
    let Some((body, points)) = bodies.find(|(_, points)| !points.is_empty()) else {
        return String::new();
    };
    let names: Vec<String> = points.iter().map(|point| format!("`{point}`")).collect();
    let (need, them) = match points.len() {
        1 => ("needs", "it"),
        _ => ("need", "them"),
    };
    format!(
        "{} {need} none where `point {}: {} at [x, y, z];` states {them}, and not `free` and the body; or ",
        names.join(", "),
        points[0],
        body.name
    )
}

/// The free points of a body that no other statement holds, moves, or needs for a marker, beside three points that
/// hold the body.
fn spared<'a>(listing: &'a Listing, body: &'a dyn Statement) -> Vec<&'a Ident> {
    const HELD: usize = 3;
    let Some(Rigid::Body(points)) = body.rigid() else {
        return Vec::new();
    };
    let is_free = |point: &&Ident| listing.free.iter().any(|free| free.named.name == **point);
    let needs = |other: &dyn Statement, point: &Ident| {
        let is_read = other.rank() >= Rank::Reading && other.carriers().is_none();
        !is_read && other.operands().contains(&point)
    };
    let is_alone = |point: &&Ident| {
        let others = listing.statements.iter();
        others.filter(|other| needs(&***other, point)).count() == 1
    };
    let alone = points.iter().filter(is_free).filter(is_alone);
    let alone: Vec<&Ident> = alone.collect();
    let kept = HELD.saturating_sub(points.len() - alone.len());
    alone.into_iter().skip(kept).collect()
}
