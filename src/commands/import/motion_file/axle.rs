//! An axle of both corners: the corner of the catalogue and its mirror image, with one rack if they are steered.

use std::fs;
use std::path::{Path, PathBuf};

use suspension_core::linkages::LISTINGS;
use suspension_runtime::Listing;

use crate::commands::import::imported_corner::ImportedCorner;
use crate::commands::import::layout_choice::Choice;
use crate::commands::import::rack;
use crate::commands::import::upper_wishbone::on_upper;
use crate::failure::Failure;
use crate::output::default_path::name_of;
use crate::output::files::{refuse_input, write_file};

/// An axle made of a layout of the catalogue.
pub(super) struct Axle {
    /// The statements of the motion file.
    pub(super) statements: String,
    /// The listing that the motion file includes, with its path, if it differs from the catalogue's.
    pub(super) corner: Option<(PathBuf, String)>,
    /// Whether both corners are on one rack.
    is_steered: bool,
}

/// The statements of a rack that both corners share: its ends move across the vehicle at a constant distance.
const SHARED_RACK: &str = "\
/// A point that the rack moves past.
fixed: rack_housing;
couple left_rack_x: left_rack.x = rack_housing.x;
couple left_rack_z: left_rack.z = rack_housing.z;
couple rack:        left_rack.y = right_rack.y;
/// Lateral position of the rack.
drive steer: left_rack.y;
";

/// The comment at the top of a corner's listing, which states no coordinates.
const ABOVE_CORNER: &str = "\
//! A corner of the axle: statements of the catalogue, without the drive of its rack. The motion file that includes it states the
//! hardpoints, under [points].
";

/// A point of layouts with an anti-roll bar, and the measure of the bar's twist. If the bar's middle is in the middle of the
/// vehicle, both corners have that point.
const BAR: &str = "bar_outer";
const TWIST: &str = "\
/// Twist of the anti-roll bar, between its arms.
measure bar_twist: angle(right_bar_outer -> right_drop_lower, left_bar_outer -> left_drop_lower
                         about right_bar_outer -> left_bar_outer);
";

impl Axle {
    /// Makes an axle of a layout, for a motion file.
    pub(super) fn new(choice: &Choice<'_>, out: &Path) -> Self {
        let twist = if choice.layout.has(BAR) { TWIST } else { "" };
        let mirrored =
            |what: &str| format!("mirror: left -> right;\ninclude left: {what};\n{twist}");
        let is_steered = rack::steers(&choice.text);
        if !is_steered && !choice.is_changed {
            return Self {
                statements: mirrored(choice.linkage()),
                corner: None,
                is_steered,
            };
        }
        let name = name_of(out);
        let name = format!("{name}_corner.linkage");
        let (of_rack, corner) = if is_steered {
            (SHARED_RACK, rack::shared(&choice.text))
        } else {
            ("", choice.text.clone())
        };
        Self {
            statements: mirrored(&format!("{name:?}")) + of_rack,
            corner: Some((out.with_file_name(name), corner_of(&corner))),
            is_steered,
        }
    }

    /// Returns name, position and origin of the rack housing, which is in the middle of the vehicle.
    pub(super) fn housing(&self, left: &ImportedCorner<'_>) -> Option<[String; 3]> {
        self.is_steered.then_some(())?;
        let [x, _, z] = left.position("rack")?;
        Some([
            "rack_housing".to_owned(),
            format!("{:?}", [x, 0.0, z]),
            "in the middle of the vehicle, beside the rack".to_owned(),
        ])
    }

    /// Refuses to overwrite a listing that differs from what import writes: the option `--out` names only the motion file.
    pub(super) fn check_corner(&self, out: &Path) -> Result<(), Failure> {
        let Some((path, _)) = &self.corner else {
            return Ok(());
        };
        refuse_input(path, "--out")?;
        let is_as_written = fs::read_to_string(path).is_ok_and(|there| {
            let layouts = LISTINGS.iter();
            let mut layouts = layouts.flat_map(|(_, text)| [(*text).to_owned(), on_upper(text)]);
            layouts.any(|text| {
                let corners = [rack::shared(&text), rack::fixed(&text)];
                corners.iter().any(|corner| corner_of(corner) == there)
            })
        });
        if is_as_written || !path.exists() {
            return Ok(());
        }
        let (path, out) = (path.display(), out.display());
        let message = format!(
            "{path}: exists already, and is not as import writes it; the axle of {out} needs a listing there: move it, or name another \
             motion file by --out"
        );
        Err(Failure::Input(message))
    }

    /// Writes the motion file, with `text`, and the listing that it includes. If the axle cannot be built, both files stay
    /// as they were.
    pub(super) fn write(
        &self,
        out: &Path,
        text: impl FnOnce(&Listing) -> Result<String, Failure>,
    ) -> Result<Vec<PathBuf>, Failure> {
        let Some((path, corner)) = &self.corner else {
            write_file(out, &text(&self.listing(out)?)?)?;
            return Ok(vec![out.to_owned()]);
        };
        // The listing must exist before the motion file that includes it is read.
        let before = path.is_file().then(|| fs::read(path)).and_then(Result::ok);
        write_file(path, corner)?;
        let text = self.listing(out).and_then(|listing| text(&listing));
        if text.is_err() {
            // A mistake in the axle is reported rather than a failure to restore the listing.
            let _ = match before {
                Some(before) => fs::write(path, before),
                None => fs::remove_file(path),
            };
        }
        write_file(out, &text?)?;
        Ok(vec![out.to_owned(), path.clone()])
    }

    fn listing(&self, out: &Path) -> Result<Listing, Failure> {
        let out = out.display().to_string();
        let listing = Listing::parse_file(&self.statements, &out);
        listing.map_err(|mistakes| {
            Failure::Input(format!(
                "both corners make no axle, --side left takes one of them: {mistakes}"
            ))
        })
    }
}

/// Returns the listing of a corner with the statements of a layout.
fn corner_of(layout: &str) -> String {
    format!("{ABOVE_CORNER}{}", rack::without_places(layout))
}
