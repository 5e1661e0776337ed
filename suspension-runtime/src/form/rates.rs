//! What moving chassis points, and drives, contribute to rates: the forms concerned.

use suspension_listing::form::{self, Equations, Form};
use suspension_listing::system::{self, SiteMotion, System};

use super::linear::Term;
use crate::site::Site;
use crate::table::index;

/// The forms that chassis points of one motion, or drives, change.
#[derive(Clone, Debug, Default)]
pub(crate) struct InputRates {
    /// Distances from such a point.
    pub(crate) distances: Vec<u16>,
    /// Points carried by a frame with such points, and which of the frame's they are.
    pub(crate) carried: Vec<MovedFrame>,
    pub(crate) linear: Vec<LinearRate>,
    /// Variable lengths from such a point.
    pub(crate) stretches: Vec<u16>,
    /// Lines at an angle, and which of their ends are such points.
    pub(crate) products: Vec<(u16, [[bool; 2]; 2])>,
    /// Sums of products of coordinates, and the motion of such points.
    pub(crate) bilinear: Vec<(u16, SiteMotion)>,
    /// Points on lines, of which something is such a point.
    pub(crate) lines: Vec<MovedLines>,
    /// Points in planes.
    pub(crate) planes: Vec<MovedLines>,
}

/// A point on a line or in a plane, and which of the points concerned are moved.
#[derive(Clone, Debug)]
pub(crate) struct MovedLines {
    /// Of the points on lines, or of those in planes.
    pub(crate) form: u16,
    pub(crate) point: bool,
    pub(crate) from: bool,
    pub(crate) ends: Vec<bool>,
}

/// A carried point with its frame partly on the chassis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MovedFrame {
    pub(crate) body: u16,
    /// Of the points that the body carries.
    pub(crate) point: u16,
    /// Of the points that all bodies carry.
    pub(crate) constant: u16,
    pub(crate) moved: [Option<Site>; 3],
}

/// A row of prescribed coordinates.
#[derive(Clone, Debug)]
pub(crate) struct LinearRate {
    pub(crate) row: u16,
    /// Of drives alone.
    pub(crate) drive: Option<u16>,
    /// What is added, then what is subtracted.
    pub(crate) terms: Vec<Term>,
}

impl InputRates {
    /// Of the chassis points with a motion and, with those that are driven, of the drives.
    pub(crate) fn new(system: &System, motion: SiteMotion) -> Self {
        let mut rates = Self::default();
        let (mut row, mut distance, mut stretch) = (0, 0, 0);
        let (mut line, mut plane, mut product, mut bilinear) = (0, 0, 0, 0);
        let mut carried = vec![0; system.bodies.len()];
        for equation in &system.equations {
            match &equation.form {
                Form::Distance(form) => {
                    if form.from.motion == motion {
                        rates.distances.push(distance);
                    }
                    distance += 1;
                }
                Form::Carried(form) => {
                    rates
                        .carried
                        .extend(moved(system, form, motion, &mut carried));
                }
                Form::Linear(form) => {
                    let rate = linear(system, form, row, motion);
                    rates.linear.extend(rate);
                }
                Form::Along(form) => {
                    let (forms, index) = match form.ends.len() {
                        1 => (&mut rates.lines, &mut line),
                        _ => (&mut rates.planes, &mut plane),
                    };
                    forms.extend(moved_lines(form, *index, motion));
                    *index += 1;
                }
                Form::Product(form) => {
                    let is_moved = |site: &system::Site| site.motion == motion;
                    let lines = form.lines.each_ref();
                    let moved = lines.map(|line| line.each_ref().map(is_moved));
                    if moved.as_flattened().contains(&true) {
                        rates.products.push((product, moved));
                    }
                    product += 1;
                }
                Form::Bilinear(form) => {
                    if form.sites().iter().any(|site| site.motion == motion) {
                        rates.bilinear.push((bilinear, motion));
                    }
                    bilinear += 1;
                }
                Form::Turn(_) => {}
                Form::Stretch(form) => {
                    if form.from.motion == motion {
                        rates.stretches.push(stretch);
                    }
                    stretch += 1;
                }
            }
            row += equation.form.equations().rows();
        }
        rates
    }
}

/// `drive_rate` less the terms' rates; `None` where that is zero.
fn linear(
    system: &System,
    form: &form::Linear,
    row: usize,
    motion: SiteMotion,
) -> Option<LinearRate> {
    let is_drive = |drive: &system::Drive| match &form.prescribed {
        form::Prescribed::Drive(name) => drive.named.name == *name,
        form::Prescribed::Design => false,
    };
    let drive = system.drives.iter().position(is_drive);
    let drive = drive
        .filter(|_| motion == SiteMotion::DrivenAnchor)
        .map(index);
    let moved = form.terms.iter().filter(|term| term.site.motion == motion);
    let rates = moved.map(|term| Term::from(term).less());
    let (mut terms, less): (Vec<Term>, Vec<Term>) = rates.partition(Term::is_positive);
    terms.extend(less);
    (drive.is_some() || !terms.is_empty()).then(|| LinearRate {
        row: index(row),
        drive,
        terms,
    })
}

/// `None` where none of the points has that motion.
fn moved_lines(form: &form::Along, index: u16, motion: SiteMotion) -> Option<MovedLines> {
    let is_moved = |site: &system::Site| site.motion == motion;
    let moved = MovedLines {
        form: index,
        point: is_moved(&form.point),
        from: is_moved(&form.from),
        ends: form.ends.iter().map(is_moved).collect(),
    };
    (moved.point || moved.from || moved.ends.contains(&true)).then_some(moved)
}

/// `None` where no point of the frame has that motion. `carried` counts the points of each body.
fn moved(
    system: &System,
    form: &form::Carried,
    motion: SiteMotion,
    carried: &mut [usize],
) -> Option<MovedFrame> {
    let bodies = system.bodies.as_slice();
    let body = bodies.iter().position(|body| body.name == form.body)?;
    let count = carried.get_mut(body)?;
    let point = *count;
    *count += 1;
    let before = bodies.iter().take(body).map(|body| body.carried.len());
    let has_motion = |site: &system::Site| (site.motion == motion).then(|| Site::from(site));
    let moved = form.frame.each_ref().map(has_motion);
    moved.iter().any(Option::is_some).then(|| MovedFrame {
        body: index(body),
        point: index(point),
        constant: index(before.sum::<usize>() + point),
        moved,
    })
}
