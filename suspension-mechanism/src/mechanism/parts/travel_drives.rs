//! Suggestions for a file that does not name the drives of travel.

use crate::mechanism::parts::names::Names;
use crate::mechanism::parts::vehicle::Wheel;

impl Names {
    /// The value of `travel` under `[vehicle]` for some of the wheels: the drives that alone lift them, or `NAME` for
    /// a wheel without one.
    pub fn travel_in_file<'a>(&self, wheels: impl IntoIterator<Item = &'a Wheel>) -> String {
        let quoted = |wheel: &Wheel| {
            let drive = match *wheel.lifted_by {
                [only] => &self.drives[only].name,
                _ => "NAME",
            };
            format!("{drive:?}")
        };
        let each: Vec<(&str, String)> = wheels
            .into_iter()
            .map(|wheel| (wheel.name.as_str(), quoted(wheel)))
            .collect();
        match each.as_slice() {
            [] => "\"NAME\"".to_owned(),
            [("", drive)] => drive.clone(),
            each => {
                let each: Vec<_> = each
                    .iter()
                    .map(|(wheel, drive)| format!("{wheel} = {drive}"))
                    .collect();
                format!("{{ {} }}", each.join(", "))
            }
        }
    }
}
