//! The points of a file in the axes of ISO 8855, on the requested side.

use nalgebra::Vector3;

use super::layout_choice::Choice;
use crate::mechanism::{Axes, extent};
use crate::vehicle_corner::Side;

/// The points of a corner, in ISO 8855.
#[derive(Debug)]
pub(super) struct CornerPoints {
    /// Coordinates in the order of the choice.
    pub(super) at: Vec<[f64; 3]>,
    /// The side on which the points are.
    pub(super) side: Side,
    /// Whether the points were mirrored to that side.
    pub(super) mirrored: bool,
    /// The side for which the file states its points and numbers.
    pub(super) stated_side: Side,
}

impl CornerPoints {
    /// Converts the points of a choice.
    ///
    /// # Errors
    ///
    /// If the coordinates put the corner on the other side than its names do, and no option states the side.
    pub(super) fn new(
        choice: &Choice<'_>,
        axes: Axes,
        wanted: Option<Side>,
    ) -> Result<Self, String> {
        let iso = |at: [f64; 3]| {
            let turned = axes.turned(Vector3::from(at));
            // Adding zero turns -0 into 0.
            turned.map(|x| x + 0.0).into()
        };
        let at = choice.found.iter().map(|(_, point)| iso(point.at));
        let at: Vec<[f64; 3]> = at.collect();
        let Some(centre) = choice.point("wheel_centre") else {
            return match wanted {
                None => Ok(Self {
                    at,
                    side: Side::Left,
                    mirrored: false,
                    stated_side: Side::Left,
                }),
                Some(_) => Err(format!(
                    "--side is for corners; {} has both sides",
                    choice.linkage()
                )),
            };
        };
        let [_, y, _] = iso(centre.at);
        let is = if y < 0.0 { Side::Right } else { Side::Left };
        let named = centre.side.unwrap_or(is);
        if wanted.is_none() && named != is {
            return Err(format!(
                "`{}` is on the {} by its name, and on the {} by y = {} in axes {} ({}); say other --axes, or --side to have \
                 the corner mirrored to that side",
                centre.name,
                named.name(),
                is.name(),
                centre.at[1],
                axes.name(),
                axes.meaning()
            ));
        }
        let side = wanted.unwrap_or(is);
        let mirrored = side != is;
        let mirror = |[x, y, z]: [f64; 3]| if mirrored { [x, 0.0 - y, z] } else { [x, y, z] };
        Ok(Self {
            at: at.into_iter().map(mirror).collect(),
            side,
            mirrored,
            stated_side: named,
        })
    }

    /// Returns whether names state this side, and the coordinates put the points on the other one.
    pub(super) fn is_elsewhere(&self) -> bool {
        self.mirrored && self.stated_side == self.side
    }

    /// Returns the largest distance of two points along an axis.
    pub(super) fn apart(&self) -> f64 {
        extent(self.at.iter().map(|at| Vector3::from(*at))).max()
    }
}
