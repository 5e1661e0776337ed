//! All causes of failure: number, description and remedy of each.

/// Passes the table of causes to the definition of [`Cause`] and to the C library, whose statuses and header are made
/// from the same rows.
#[doc(hidden)]
#[macro_export]
macro_rules! causes {
    ($define:ident { $($before:tt)* }) => {
        $define! {
            $($before)*

            PointNotFinite = 20: "a coordinate of a point is not a finite number, or too large to compute with",
                "give hardpoints in one unit and near the vehicle";
            BadLength = 21: "a length is not positive, or too large or too small to compute with",
                "keep points apart that a link or a body joins";
            Collinear = 22: "the three points that carry a point, or that a plane goes through, lie in line",
                "move one of them off the line, or name three that form a triangle";
            Flat = 23: "a point lies in the plane of the points that links join it to, where their lengths do not hold it",
                "state these points as a `body`";
            NotClosed = 24: "no rigid body has these lengths: they do not close at a point",
                "measure its lengths again";
            NoLine = 25: "a line has no length, or lies along the axis of its angle",
                "put its ends apart, or off the axis";
            SmallPivot = 26: "the fixed order of elimination has too small a pivot at these hardpoints",
                "state hardpoints near these in the listing, or step with partial pivoting";
            SingularDesign = 27: "the equations do not determine the motion at these hardpoints: the mechanism locks there, or a drive has no effect",
                "state hardpoints away from the lock, or drive something else";

            NotFinite = 40: "an input or a residual is not a finite number",
                "look at inputs, start and time step";
            Overflow = 41: "a correction, velocity, acceleration or force is not a finite number",
                "look at the inputs and their rates, or at the forces";
            CrossedSingularity = 42: "the step ends in another assembly, beyond a singularity",
                "take shorter steps";
            Singular = 43: "the equations do not determine the motion here: the mechanism locks, or a drive has no effect",
                "stay away from the lock, or lead the motion by a measure";
            Mirrored = 44: "a point stands on the wrong side of the points that links join it to",
                "start from the assembly that is meant";
            Diverging = 45: "there is no configuration near by: the correction is too large",
                "take shorter steps, or assemble";
            TooFar = 46: "the step is too long to tell assemblies apart",
                "take shorter steps";
            StepTooLong = 47: "the step is longer than the series is good for",
                "take shorter steps";
            TurningPoint = 48: "the quantity that leads turns before it meets its target",
                "lead by another one, or not so far";
            NotConverged = 49: "the residual is above the tolerance after all corrections that are allowed",
                "take shorter steps, give rates that match the drives, allow more corrections, or assemble a start that is no configuration; in assembling, see that lengths and drives fit together";
            StepsUsedUp = 50: "all steps that are allowed are used up",
                "allow more of them";
            UnhealthyPivots = 51: "the pivots of the fixed order of elimination are too small here",
                "make the step with partial pivoting";
            AngleOutOfRange = 52: "an angle is driven beyond its range",
                "drive it from 0 to pi where it is between a link and an axis, else by less than a whole turn";
            StepNotFinite = 53: "the time step or the time after it is not a finite number",
                "give finite times";

            UnprovedNearSingular = 60: "nothing is proved: the Jacobian is singular to rounding",
                "prove roots away from singularities";
            UnprovedTooFar = 61: "nothing is proved: the root is too far away, or a singularity too near",
                "correct the position first";
        }
    };
}

macro_rules! define {
    ($($name:ident = $number:literal: $what:literal, $remedy:literal;)*) => {
        /// The reason why something could not be done: the kind of a failure, without its numbers.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Cause {
            $(#[doc = $what] $name = $number,)*
        }

        impl Cause {
            /// What happened, as a sentence without its full stop.
            pub const fn what(self) -> &'static str {
                match self {
                    $(Self::$name => $what,)*
                }
            }

            /// What to do about it.
            pub const fn remedy(self) -> &'static str {
                match self {
                    $(Self::$name => $remedy,)*
                }
            }

            /// The remedy after an advance, which has already shortened its steps itself.
            pub const fn remedy_of_advance(self) -> &'static str {
                match self {
                    Self::CrossedSingularity
                    | Self::Diverging
                    | Self::TooFar
                    | Self::StepTooLong
                    | Self::NotConverged => {
                        "shorter steps lead no further: the mechanism locks here, the drives jump, or the start is no configuration: assemble it"
                    }
                    _ => self.remedy(),
                }
            }
        }
    };
}

causes!(define {});
