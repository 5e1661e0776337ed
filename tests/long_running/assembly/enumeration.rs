//! The enumeration of assemblies against results of other methods.

use nalgebra::SVector;
use suspension::assemblies::{Assemblies, Census};
use suspension::mechanism::Suspension;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::{Inputs, Newton, Still};

use super::random::Random;
use crate::support::{self, INSTANTS};

type Vector = SVector<f64, 15>;

/// The signed volume of points 6, 7, 8 and another.
fn side(q: &Vector, other: usize) -> f64 {
    let point = |number: usize| q.fixed_rows::<3>(3 * (number - 6)).into_owned();
    let [u, v, w] = [7, 8, other].map(|number| point(number) - point(6));
    u.cross(&v).dot(&w)
}

fn enumerate<L: Suspension<15>>(
    model: &L,
    rough: &L::Points,
    inputs: impl Fn(f64) -> Inputs<Still, L::Drives>,
) -> Vec<Census<15>> {
    let near = model.unknowns(rough);
    let mut search = Assemblies::new(model, &near, &inputs(0.0), &|_, _| true);
    let each = INSTANTS.iter();
    let each = each.map(|t| search.at(&inputs(*t)).expect("a census"));
    each.collect()
}

/// Newton's method from anywhere finds none that the list has not. Tells how many of the list it
/// finds.
fn search_at_random<L: Suspension<15>>(
    model: &L,
    near: &Vector,
    inputs: &Inputs<Still, L::Drives>,
    census: &Census<15>,
) -> usize {
    const SEED: u64 = 5;
    const STARTS: usize = 500;
    let mut random = Random(SEED);
    let mut found = vec![false; census.real.len()];
    for start in 0..STARTS {
        let mut q = near + random.within(0.5);
        if Newton::from_afar().solve(model, inputs, &mut q).is_ok() {
            let known = census
                .real
                .iter()
                .position(|known| (known - q).amax() < 1e-6);
            found[known.unwrap_or_else(|| panic!("start {start} of seed {SEED}: {q}"))] = true;
        }
    }
    found.iter().filter(|found| **found).count()
}

/// Five links and a drive: 40 complex assemblies, as many as a platform on six legs has (Raghavan
/// 1993; Husty 1996). Nine distances: four times as many, one for each side on which points 9 and
/// 10 can stand. At t = 1 s 24 real ones had been found before, 4 of them right-handed.
#[test]
fn both_closures_enumerate_the_same_right_handed_assemblies() {
    let body: five_link::Model<f64> = support::five_link_model();
    let links: attia2003::Model<f64> = support::attia_model();
    let of_body = enumerate(
        &body,
        &support::five_link_rough(),
        support::five_link_inputs,
    );
    let of_links = enumerate(&links, &support::attia_rough(), support::attia_inputs);
    let published = support::Reference::load().unknowns(0, "");
    for (instant, (of_body, of_links)) in of_body.iter().zip(&of_links).enumerate() {
        let t = INSTANTS[instant];
        println!(
            "t = {t}: {} and {} real",
            of_body.real.len(),
            of_links.real.len()
        );
        let doubts = [of_body, of_links].map(|census| census.tally.doubts());
        assert!(doubts.iter().all(Vec::is_empty), "t = {t}: {doubts:?}");
        let generic = [of_body, of_links].map(|census| census.tally.parts[0].generic);
        assert_eq!(generic, [40, 160]);
        let right = |q: &&Vector| {
            [9, 10]
                .iter()
                .all(|k| side(q, *k) * side(&published, *k) > 0.0)
        };
        let right_handed: Vec<_> = of_links.real.iter().filter(right).collect();
        assert_eq!(right_handed.len(), of_body.real.len(), "t = {t}");
        for q in &of_body.real {
            let nearest = right_handed.iter().map(|other| (*other - q).amax());
            assert!(nearest.fold(f64::INFINITY, f64::min) < 1e-9, "t = {t}");
        }
        let inputs = support::five_link_inputs(t);
        let found = search_at_random(&body, &published, &inputs, of_body);
        println!("  Newton's method from 500 random starts: {found}");
        let inputs = support::attia_inputs(t);
        let found = search_at_random(&links, &published, &inputs, of_links);
        println!("  the same on nine distances: {found}");
    }
    assert_eq!(of_links[4].real.len(), 24);
    assert_eq!(of_body[4].real.len(), 4);
}
