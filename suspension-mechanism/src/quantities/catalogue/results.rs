//! The measures of the linkage, and the solver's report on its solution.

use crate::file::Dimension;
use crate::quantities::quantity::{Quantity, Shown};
use crate::quantities::readings::{each, number};

catalogue! {
    MEASURES: "measures" {
        name: "",
        sign: "",
        definition: "the measures of the linkage; the derivative of a measure with respect to a drive is a motion \
                     ratio, negative where a length gets shorter. An angle about an axis is within half a turn of its \
                     design value",
        source: "`measure` of the listing",
        shown: Shown::InBoth,
        read: |names| {
            let measures = names.measures.iter();
            let measures = measures.map(|measure| (measure.name.as_str(), measure.kind.into()));
            each(measures, true, |reader, measure| reader.positions.numbers.measure(measure))
        },
    }
    ITERATIONS: "iterations of Newton's method" {
        name: "iterations",
        sign: "",
        definition: "since the previous instant, including steps in between",
        source: "the solver",
        shown: Shown::InTables,
        read: |_| number(Dimension::Count, |state| state.iterations as f64),
    }
    RESIDUAL: "largest residual" {
        name: "residual",
        sign: "",
        definition: "over all equations; (|d|^2 - L^2) / (2 L) for a length",
        source: "the solver",
        shown: Shown::InTables,
        read: |_| number(Dimension::Length, |state| state.residual),
    }
}
