//! Moves of one side of an axle only.

use toml::Spanned;

use crate::file::MoveTable;
use crate::mechanism::{Description, name_on_other_side, quoted};
use crate::prepare::loaded::Loaded;

impl Loaded<'_> {
    /// Notes on moves of points or links whose counterparts on the other side no move names, each with the line to add.
    pub fn one_sided_moves(&self, mechanism: &Description) -> Vec<String> {
        let names = &mechanism.names;
        let tables = self.file.tune.iter();
        let moves: Vec<_> = tables
            .flat_map(|table| table.get_ref().moves.get_ref().iter())
            .collect();
        let tables = moves.iter().map(|(_, each)| each.get_ref());
        let moved: Vec<&str> = tables.flat_map(named).collect();
        let exists = |name: &str| names.point(name).is_some() || names.link(name).is_some();
        let note = |(name, each): &(&Spanned<String>, &Spanned<MoveTable>)| {
            let others = named(each.get_ref()).filter_map(name_on_other_side);
            let others = others.filter(|other| exists(other) && !moved.contains(&other.as_str()));
            let others: Vec<String> = others.collect();
            let [them, stay] = match others.len() {
                0 => return None,
                1 => ["it", "stays"],
                _ => ["them", "stay"],
            };
            let all = quoted(&others);
            let list = others.iter().map(|other| format!("\"{other}\""));
            let list = list.collect::<Vec<_>>().join(", ");
            Some(format!(
                "{}: [tune.moves.{}] moves only one side of the vehicle, {all} {stay} where the file has {them}; to keep both sides alike, \
                 write mirrored = [{list}] there",
                self.source.name(),
                name.get_ref(),
            ))
        };
        moves.iter().filter_map(note).collect()
    }
}

/// The points or links that a move names.
fn named(table: &MoveTable) -> impl Iterator<Item = &str> {
    let all = table.points.iter().chain(&table.mirrored);
    all.chain(&table.length).map(|name| name.get_ref().as_str())
}
