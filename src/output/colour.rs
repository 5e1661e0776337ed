//! Colours of curves.

use plotters::style::RGBColor;

/// The colour of a curve.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Colour {
    /// One of its own, by its place among the curves of a plot.
    #[default]
    OfPlace,
    /// That of a place, in plots that lack some of the curves.
    Own(usize),
    /// One of a scale from blue, at 0, to red, at 1, for curves of increasing numbers.
    OfScale(f64),
    /// Black, for the curve with which others are compared.
    Black,
}

/// As many as the angles of a car's four wheels need.
const OWN: [RGBColor; 8] = [
    RGBColor(31, 90, 160),
    RGBColor(200, 80, 20),
    RGBColor(40, 130, 60),
    RGBColor(130, 60, 140),
    RGBColor(0, 150, 170),
    RGBColor(190, 150, 0),
    RGBColor(110, 70, 40),
    RGBColor(120, 120, 120),
];

/// The scale: colours that are as dark as each other on white, evenly spaced.
const SCALE: [[f64; 3]; 5] = [
    [40.0, 50.0, 190.0],
    [0.0, 150.0, 190.0],
    [60.0, 150.0, 60.0],
    [225.0, 140.0, 0.0],
    [190.0, 25.0, 40.0],
];

impl Colour {
    /// Returns the colour of the curve with this place in its plot.
    pub(super) fn of_curve(self, place: usize) -> RGBColor {
        match self {
            Self::OfPlace => Self::Own(place).of_curve(place),
            Self::Own(own) => OWN[own % OWN.len()],
            Self::OfScale(part) => on_scale(part),
            Self::Black => RGBColor(0, 0, 0),
        }
    }

    /// Returns the colour as in style sheets, for a legend beside plots.
    pub fn in_css(self) -> String {
        let RGBColor(red, green, blue) = self.of_curve(0);
        format!("rgb({red},{green},{blue})")
    }
}

fn on_scale(part: f64) -> RGBColor {
    let last = SCALE.len() - 1;
    let along = part.clamp(0.0, 1.0) * last as f64;
    let first = (along as usize).min(last - 1);
    let rest = along - first as f64;
    let [low, high] = [SCALE[first], SCALE[first + 1]];
    let mixed = |of: usize| (low[of] + rest * (high[of] - low[of])).round() as u8;
    RGBColor(mixed(0), mixed(1), mixed(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_goes_from_blue_to_red() {
        let css = |part| Colour::OfScale(part).in_css();
        assert_eq!([css(0.0), css(1.0)], ["rgb(40,50,190)", "rgb(190,25,40)"]);
        assert_eq!(css(0.125), "rgb(20,100,190)");
    }
}
