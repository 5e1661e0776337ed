//! The equations of one form, and which of them inputs enter: the rows of the others in `-dF/du udot` are zero.

use core::ops::{Deref, DerefMut};

use suspension_listing::form;
use suspension_listing::system::SiteMotion;

use crate::table::index;

/// The equations of a form.
#[derive(Clone, Debug)]
pub(crate) struct Equations<F> {
    all: Vec<F>,
    /// The equations in which drives, or chassis points that these move, occur.
    driven: Vec<u16>,
    /// The equations in which other chassis points occur.
    undriven: Vec<u16>,
}

impl<F> Equations<F> {
    pub(super) fn push(&mut self, form: F, equation: &dyn form::Equations) {
        self.enter(self.all.len(), equation);
        self.all.push(form);
    }

    /// Notes which inputs occur in the equation at `place`.
    pub(super) fn enter(&mut self, place: usize, equation: &dyn form::Equations) {
        let (place, sites) = (index(place), equation.sites());
        let has = |motion| sites.iter().any(|site| site.motion == motion);
        let by_drives = equation.drive().is_some() || has(SiteMotion::DrivenAnchor);
        let others = has(SiteMotion::Anchor);
        for (enter, places) in [(by_drives, &mut self.driven), (others, &mut self.undriven)] {
            if enter && !places.contains(&place) {
                places.push(place);
            }
        }
    }

    /// All equations, each with its constant.
    #[inline(always)]
    pub(crate) fn all<C>(
        &self,
        constants: impl Iterator<Item = C>,
    ) -> impl Iterator<Item = (&F, C)> {
        self.all.iter().zip(constants)
    }

    /// The equations in which drives and the points that they move occur, or those in which other chassis points
    /// occur; each with its constant.
    #[inline(always)]
    pub(crate) fn entered<C>(
        &self,
        constants: impl Iterator<Item = C> + Clone,
        by_drives: bool,
    ) -> impl Iterator<Item = (&F, C)> {
        let places = match by_drives {
            true => &self.driven,
            false => &self.undriven,
        };
        places.iter().filter_map(move |place| {
            let place = usize::from(*place);
            self.all.get(place).zip(constants.clone().nth(place))
        })
    }
}

impl<F> Default for Equations<F> {
    fn default() -> Self {
        Self::from(Vec::new())
    }
}

impl<F> From<Vec<F>> for Equations<F> {
    fn from(all: Vec<F>) -> Self {
        Self {
            all,
            driven: Vec::new(),
            undriven: Vec::new(),
        }
    }
}

impl<F> Deref for Equations<F> {
    type Target = [F];

    fn deref(&self) -> &[F] {
        &self.all
    }
}

impl<F> DerefMut for Equations<F> {
    fn deref_mut(&mut self) -> &mut [F] {
        &mut self.all
    }
}
