//! What the solver walks: a listing as indices. It is made once of a listing; nothing of it is a number of a
//! geometry.

mod clusters;
mod elimination;
mod lengths;
mod places;
mod readout;
mod room;
mod substitution;

use suspension_listing::eliminate::Order;
use suspension_listing::form::Form;
use suspension_listing::name::Name;
use suspension_listing::system::{SiteMotion, System};

use crate::form::{
    Along, Bilinear, Body, Distance, InputRates, Linear, Product, Scale, Stretch, Turn,
};
use crate::site::Site;
use crate::table::index;

pub(crate) use clusters::Cluster;
pub(crate) use elimination::{Elimination, Step};
pub(crate) use lengths::{BodyPoint, Length, LengthNames, LineLength};
pub(crate) use readout::{Coordinate, Drive, Measure, Wheel};
pub(crate) use substitution::{Carrier, Term};

/// The last place but one: zero among the numbers of the factors.
pub(crate) const ZERO: u16 = u16::MAX - 1;

/// The indices of a listing.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    pub(crate) unknowns: u16,
    /// How many of the points are free: their coordinates are the first unknowns.
    pub(crate) free: u16,
    pub(crate) chassis: u16,
    pub(crate) distances: Vec<Distance>,
    /// All bodies of three points or more, each with the points that it carries.
    pub(crate) bodies: Vec<Body>,
    pub(crate) linear: Vec<Linear>,
    pub(crate) lines: Vec<Along<1>>,
    pub(crate) planes: Vec<Along<2>>,
    pub(crate) stretches: Vec<Stretch>,
    pub(crate) products: Vec<Product>,
    pub(crate) turns: Vec<Turn>,
    pub(crate) bilinear: Vec<Bilinear>,
    /// The lengths that these are over, each once.
    pub(crate) scales: Vec<Scale>,
    /// What drives contribute to rates, with the chassis points that they move.
    pub(crate) driven: InputRates,
    /// What the other chassis points contribute.
    pub(crate) undriven: InputRates,
    pub(crate) elimination: Elimination,
    pub(crate) drives: Vec<Drive>,
    pub(crate) measures: Vec<Measure>,
    /// The sites that carry each marker.
    pub(crate) markers: Vec<[Site; 3]>,
    pub(crate) clusters: Vec<Cluster>,
    pub(crate) lengths: Vec<Length>,
    pub(crate) wheels: Vec<Wheel>,
}

impl Plan {
    pub(crate) fn new(system: &System, order: &Order) -> Self {
        let elimination = Elimination::new(system, order);
        let entry = |row, column: Option<usize>| elimination.entry(row, column);
        let lengths = LengthNames::new(system);
        let (mut distances, mut linear) = (Vec::new(), Vec::<Linear>::new());
        let (mut lines, mut planes, mut stretches) = (Vec::new(), Vec::new(), Vec::new());
        let (mut products, mut turns) = (Vec::new(), Vec::new());
        let (mut bilinear, mut scales) = (Vec::new(), Vec::<Scale>::new());
        let mut bodies: Vec<Body> = (system.bodies.iter())
            .map(|body| Body::new(body, &lengths))
            .collect();
        let substituted: Vec<&Name> = (system.substituted().iter())
            .map(|substituted| substituted.point)
            .collect();
        let mut row = 0;
        for equation in &system.equations {
            match &equation.form {
                Form::Distance(form) => {
                    let length = lengths.place(&equation.named.name);
                    distances.push(Distance::new(form, row, length, entry));
                }
                Form::Linear(form) => {
                    let held = linear.iter().filter(|other| other.is_held()).count();
                    linear.push(Linear::new(system, form, row, held, entry));
                }
                Form::Carried(form) => {
                    let mut named = system.bodies.iter().zip(&mut bodies);
                    if let Some((_, body)) = named.find(|(body, _)| body.name == form.body) {
                        let is_stored = !substituted.contains(&&form.point.name);
                        body.carry(form, row, &lengths, is_stored.then_some(entry));
                    }
                }
                Form::Along(form) => {
                    lines.extend(Along::new(system, form, row, &lengths, entry));
                    planes.extend(Along::new(system, form, row, &lengths, entry));
                }
                Form::Stretch(form) => stretches.push(Stretch::new(system, form, row, entry)),
                Form::Turn(form) => turns.push(Turn::new(system, form, row, entry)),
                Form::Bilinear(form) => {
                    let scale = Scale::new(form, &lengths);
                    let known = scales.iter().position(|other| *other == scale);
                    let constant = known.unwrap_or(scales.len());
                    if known.is_none() {
                        scales.push(scale);
                    }
                    bilinear.push(Bilinear::new(system, form, row, constant, entry));
                }
                Form::Product(form) => products.push(Product::new(form, row, &lengths, entry)),
            }
            row += equation.form.equations().rows();
        }
        let rates = |motion| InputRates::new(system, motion);
        Self {
            unknowns: index(system.size()),
            free: index(system.free.len()),
            chassis: index(system.fixed.len()),
            driven: rates(SiteMotion::DrivenAnchor),
            undriven: rates(SiteMotion::Anchor),
            drives: readout::drives(system),
            measures: readout::measures(system),
            markers: (system.markers.iter())
                .map(|marker| marker.frame.each_ref().map(Site::from))
                .collect(),
            clusters: clusters::clusters(system, &lengths),
            lengths: lengths.lengths(),
            wheels: readout::wheels(system),
            distances,
            bodies,
            linear,
            lines,
            planes,
            stretches,
            products,
            turns,
            bilinear,
            scales,
            elimination,
        }
    }

    /// The sums of coordinates that stay as they are.
    pub(crate) fn held(&self) -> impl Iterator<Item = &Linear> {
        self.linear.iter().filter(|linear| linear.is_held())
    }

    /// How many points bodies carry.
    pub(crate) fn carried(&self) -> usize {
        self.bodies.iter().map(|body| body.carried.len()).sum()
    }
}
