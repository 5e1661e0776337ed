//! The description from which headers are written: functions and structs.

use suspension_core::listing::Part;

use crate::names::{Naming, Table, Text};

/// A C function.
#[derive(Clone, Copy, Debug)]
pub struct Function {
    /// The name without the prefix.
    pub name: &'static str,
    /// The documentation, line by line.
    pub docs: &'static [&'static str],
    /// Name, kind (`In`, `InOut`, `Out` or a type) and pointed-to type of each argument.
    pub arguments: &'static [[&'static str; 3]],
    /// The return type.
    pub returns: &'static str,
}

/// A C struct.
#[derive(Clone, Copy, Debug)]
pub struct Structure {
    /// The name in Rust.
    pub name: &'static str,
    /// The documentation, line by line.
    pub docs: &'static [&'static str],
    /// The contents.
    pub shape: Shape,
}

/// The contents of a struct.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// Bytes that C does not interpret.
    Opaque {
        /// The number of bytes.
        size: usize,
        /// The alignment.
        align: usize,
    },
    /// An incomplete type, which C has only pointers to.
    Handle,
    /// Named numbers, or named vectors of three.
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
    /// The prefix of all names.
    pub prefix: &'static str,
    /// `f32` or `f64`.
    pub number: &'static str,
    /// The documentation, line by line.
    pub docs: &'static [&'static str],
    /// Structs in groups, each after those that it contains.
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
