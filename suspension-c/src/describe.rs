//! The description from which a header is written: functions and structs in words.

use suspension_core::listing::Part;

use crate::names::{Naming, Table, Text};

/// A C function.
#[derive(Clone, Copy, Debug)]
pub struct Function {
    /// Its name without the prefix.
    pub name: &'static str,
    /// Its contract, line by line.
    pub docs: &'static [&'static str],
    /// Name, kind (`In`, `InOut`, `Out` or a type) and what is pointed to.
    pub arguments: &'static [[&'static str; 3]],
    /// The type of its answer.
    pub returns: &'static str,
}

/// A C struct.
#[derive(Clone, Copy, Debug)]
pub struct Structure {
    /// Its name in Rust.
    pub name: &'static str,
    /// What it is, line by line.
    pub docs: &'static [&'static str],
    /// What is in it.
    pub shape: Shape,
}

/// What is in a struct.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// Bytes.
    Opaque {
        /// How many.
        size: usize,
        /// Their alignment.
        align: usize,
    },
    /// Not C's to look into, nor to make: it is known by its pointer.
    Handle,
    /// Numbers, or vectors of three, under names.
    Named {
        /// The names.
        names: &'static [&'static str],
        /// Whether each is a vector.
        vectors: bool,
    },
    /// A struct with its first and second time derivative.
    Rates(&'static str),
    /// Name, type and meaning of each field.
    Fields(&'static [(&'static str, &'static str, &'static [&'static str])]),
}

/// A C interface: structs and functions with a prefix, over one number type.
#[derive(Clone, Copy, Debug)]
pub struct Interface {
    /// What all names begin with.
    pub prefix: &'static str,
    /// `f32` or `f64`.
    pub number: &'static str,
    /// What it is about, line by line.
    pub docs: &'static [&'static str],
    /// Structs in groups, each after those that it holds.
    pub structures: &'static [&'static [Structure]],
    /// Functions, in groups.
    pub functions: &'static [&'static [Function]],
}

/// The names of a linkage.
#[derive(Clone, Copy, Debug)]
pub struct Names {
    /// Chassis points, free points and markers.
    pub points: Table,
    /// Drives.
    pub drives: Table,
    /// Measures.
    pub measures: Table,
    /// Lengths.
    pub lengths: Table,
    /// Equations.
    pub equations: Table,
    /// Unknowns.
    pub unknowns: Table,
}

impl Naming for Names {
    fn name(&self, part: Part) -> Text {
        let (table, index) = match part {
            Part::Equation(index) => (self.equations, index),
            Part::Unknown(index) => (self.unknowns, index),
            Part::Point(index) => (self.points, index),
            Part::Drive(index) => (self.drives, index),
            Part::Measure(index) => (self.measures, index),
            Part::Length(index) => (self.lengths, index),
        };
        table.at(index)
    }
}
