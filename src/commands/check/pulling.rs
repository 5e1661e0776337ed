//! Springs that pull a wheel up at the design position.

use crate::characteristics::{Parameter, parameters};
use crate::kinematics::Kinematics;
use crate::number::rounded;
use crate::quantities::SPRING_LOAD;

/// A smaller force, in N, may be that of a bar at rest.
const LEAST: f64 = 1.0;

/// Returns a note for each wheel that its springs pull up.
pub(super) fn notes(mechanism: &dyn Kinematics) -> impl Iterator<Item = String> {
    let of_design = parameters(mechanism, mechanism.unit).into_iter();
    let pulled =
        |parameter: &Parameter| *parameter.quantity == SPRING_LOAD && parameter.value < -LEAST;
    of_design.filter(pulled).map(|parameter| {
        let wheel = parameter.title.wheel.map(|name| name.replace('_', " ") + " wheel");
        format!(
            "springs pull the {} up with {} N at the design position: is the sign of their load right? It is positive where \
             it makes the measure larger",
            wheel.as_deref().unwrap_or("wheel"),
            rounded(-parameter.value, 4)
        )
    })
}
