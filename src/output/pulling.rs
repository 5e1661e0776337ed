//! Springs that pull a wheel up at the design position.

use crate::characteristics::Parameter;
use crate::number::rounded;
use crate::quantities::SPRING_LOAD;

/// A smaller force, in N, may be that of a bar at rest.
const LEAST: f64 = 1.0;

/// Returns a note for each wheel that its springs pull up, from the values at the design position.
pub fn notes(of_design: &[Parameter]) -> impl Iterator<Item = String> {
    let is_pulled =
        |parameter: &&Parameter| *parameter.quantity == SPRING_LOAD && parameter.value < -LEAST;
    let pulled = of_design.iter().filter(is_pulled);
    pulled.map(|parameter| {
        let wheel = parameter.title.wheel.as_ref();
        let wheel = wheel.map(|name| name.replace('_', " ") + " wheel");
        format!(
            "springs pull the {} up with {} N at the design position: is the sign of their load right? It is positive where \
             it makes the measure larger",
            wheel.as_deref().unwrap_or("wheel"),
            rounded(-parameter.value, 4)
        )
    })
}
