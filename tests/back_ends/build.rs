//! Writes random listings for `linkage!` to compile into the tests: `SUSPENSION_RANDOM_LISTINGS` of them, or 200.

use std::error::Error;
use std::fmt::Write;
use std::path::Path;

use suspension_listing::include::NoIncludes;
use suspension_listing::text;

mod random;

/// Free points of each, about.
const FREE: usize = 3;
const COUNT: &str = "SUSPENSION_RANDOM_LISTINGS";
/// Unknowns that models read at run time have room for.
const ROOMS: [usize; 4] = [15, 30, 60, 120];

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=random.rs");
    println!("cargo::rerun-if-env-changed={COUNT}");
    let count = std::env::var(COUNT).map_or(Ok(200), |count| count.parse())?;
    let mut listings = String::new();
    for seed in 0..count {
        let text = random::listing(seed, FREE);
        let unknowns = unknowns(&text)?;
        let room = ROOMS.iter().find(|room| unknowns <= **room);
        let room = room.ok_or("a listing that is too large")?;
        writeln!(
            listings,
            "random_{seed}: {seed}, {unknowns} in {room}, {text:?} {{\n{text}}}"
        )?;
    }
    let folder = std::env::var("OUT_DIR")?;
    let file = Path::new(&folder).join("random_listings.rs");
    std::fs::write(file, format!("listings! {{\n{listings}}}\n"))?;
    Ok(())
}

fn unknowns(listing: &str) -> Result<usize, Box<dyn Error>> {
    let system = text::parse(listing, "random", &NoIncludes);
    let system = system.map_err(|_| "a listing that cannot be read")?;
    Ok(3 * system.free.len() + system.scalars.len())
}
