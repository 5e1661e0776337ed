//! Levels of detail: how a car's corners are computed.

use std::error::Error;

use crate::kinematics::{Baked, Constant, Grid, Kinematics, Table, bounded, exact};
use crate::linkages::{front, rear};
use crate::tables;

/// A level of detail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Detail {
    /// The linkage to rounding, f64.
    Exact,
    /// The linkage at a fixed cost, f32.
    Bounded,
    /// Baked surfaces and curves.
    Baked,
    /// Places of these, and linear between them: the usual table of K&C data.
    Table,
    /// The ratios of the design.
    Constant,
}

impl Detail {
    /// All, the finest first.
    pub const ALL: [Self; 5] = [
        Self::Exact,
        Self::Bounded,
        Self::Baked,
        Self::Table,
        Self::Constant,
    ];

    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Bounded => "bounded f32",
            Self::Baked => "baked",
            Self::Table => "linear table",
            Self::Constant => "constant ratios",
        }
    }

    /// Makes the left corner of the front axle (0) or of the rear axle (1).
    ///
    /// # Errors
    ///
    /// If the positions in a listing do not suit its linkage.
    pub fn corner(self, axle: usize) -> Result<Box<dyn Kinematics>, Box<dyn Error>> {
        let is_front = axle == 0;
        Ok(match self {
            Self::Exact if is_front => Box::new(exact::<front::Model<f64>, _>()?),
            Self::Exact => Box::new(exact::<rear::Model<f64>, _>()?),
            Self::Bounded if is_front => Box::new(bounded::<front::Listing, _>()?),
            Self::Bounded => Box::new(bounded::<rear::Listing, _>()?),
            Self::Baked if is_front => Box::new(baked_front()?),
            Self::Baked => Box::new(baked_rear()?),
            Self::Table if is_front => Box::new(in_a_grid(baked_front()?)?),
            Self::Table => Box::new(in_a_grid(baked_rear()?)?),
            Self::Constant => Box::new(Constant::of(&mut *Self::Exact.corner(axle)?)?),
        })
    }

    /// Makes all four corners of a car.
    ///
    /// # Errors
    ///
    /// Those of [`corner`](Self::corner).
    pub fn corners(self) -> Result<[Box<dyn Kinematics>; 4], Box<dyn Error>> {
        let corner = |axle| self.corner(axle);
        Ok([corner(0)?, corner(0)?, corner(1)?, corner(1)?])
    }
}

fn baked_front() -> Result<Baked<impl Table>, Box<dyn Error>> {
    let corner = front::Corner::<f64>::design()?;
    let front::Drives { bump, steer } = corner.drives();
    Ok(Baked {
        table: tables::FRONT,
        design: [bump, steer],
        strut_upper: corner.points().value.strut_upper,
    })
}

fn baked_rear() -> Result<Baked<impl Table>, Box<dyn Error>> {
    let corner = rear::Corner::<f64>::design()?;
    Ok(Baked {
        table: tables::REAR,
        design: [corner.drives().bump, 0.0],
        strut_upper: corner.points().value.strut_upper,
    })
}

fn in_a_grid(baked: Baked<impl Table>) -> Result<Baked<Grid>, Box<dyn Error>> {
    let grid = Grid::of(&baked.table, baked.design);
    Ok(Baked {
        table: grid.map_err(|outside| format!("no table at {}", outside.drive))?,
        design: baked.design,
        strut_upper: baked.strut_upper,
    })
}
