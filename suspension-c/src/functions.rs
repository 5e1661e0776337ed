//! The functions of a listing; each is a thin call to the core.

mod making;
mod moving;
mod reading;
mod stepping;

/// Functions of every listing that tell names.
#[doc(hidden)]
#[macro_export]
macro_rules! functions_of_naming {
    ($prefix:literal) => {
        $crate::functions! { $prefix, NAMING:
            /// The name of a point by its number in `points`, from 0; NULL beyond the last.
            fn point_name(index: usize) -> Text {
                NAMES.points.at(index)
            }

            /// The name of a drive by its number; NULL beyond the last.
            fn drive_name(index: usize) -> Text {
                NAMES.drives.at(index)
            }

            /// The name of a measure by its number; NULL beyond the last.
            fn measure_name(index: usize) -> Text {
                NAMES.measures.at(index)
            }

            /// The name of a length by its number; NULL beyond the last.
            fn length_name(index: usize) -> Text {
                NAMES.lengths.at(index)
            }
        }
    };
}

/// The functions of listings that say what some of their points are.
#[doc(hidden)]
#[macro_export]
macro_rules! functions_of_a_part {
    (design, $prefix:literal) => {
        use $crate::private::Designed as _;

        $crate::functions! { $prefix:
            /// The positions that the listing states.
            fn design(points: Out<Points>) -> Status {
                answer(|| {
                    points.get()?.write(values_of_points(&Linkage::design()));
                    Ok(())
                })
            }
        }
    };
    (wheel, $prefix:literal) => {
        $crate::functions! { $prefix:
            /// The wheel of positions that `read_points` found.
            fn read_wheel(points: In<Points>, wheel: Out<Wheel>) -> Status {
                answer(|| {
                    let (points, wheel) = (points.get()?, wheel.get()?);
                    wheel.write(wheel_of(points_of(points).wheel())?);
                    Ok(())
                })
            }

            /// That wheel with its derivatives: per second from points of `read_points`, and per unit of a change
            /// of the drives, such as camber gain and bump steer, from those of `read_derivatives`.
            fn read_wheel_rates(points: In<PointRates>, wheel: Out<WheelRates>) -> Status {
                answer(|| {
                    let (points, wheel) = (points.get()?, wheel.get()?);
                    wheel.write(wheel_rates_of(&signal(points, |points| points_of(points).wheel()))?);
                    Ok(())
                })
            }

            /// How the body that carries the wheel turns.
            fn read_rotation(points: In<PointRates>, rotation: Out<CarrierRotation>) -> Status {
                answer(|| {
                    let (points, rotation) = (points.get()?, rotation.get()?);
                    rotation.write(rotation_of(&signal(points, |points| points_of(points).carrier()))?);
                    Ok(())
                })
            }
        }
    };
    (kingpin, $prefix:literal) => {
        $crate::functions! { $prefix:
            /// The kingpin of positions that `read_points` found.
            fn read_kingpin(points: In<Points>, kingpin: Out<Kingpin>) -> Status {
                answer(|| {
                    let (points, kingpin) = (points.get()?, kingpin.get()?);
                    let points = points_of(points);
                    kingpin.write(kingpin_of(points.kingpin(), points.wheel())?);
                    Ok(())
                })
            }
        }
    };
}
