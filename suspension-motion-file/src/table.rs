//! Tables of a motion file.

use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;

use serde::Deserialize;
use serde::de::{self, MapAccess, Visitor, value::MapAccessDeserializer};
use toml::Spanned;

/// Values by name, each with its place in the file.
pub type Table<V> = Spanned<BTreeMap<Spanned<String>, Spanned<V>>>;

/// Returns the entries in the order of the file.
pub fn in_order<V>(table: &Table<V>) -> impl Iterator<Item = (&Spanned<String>, &Spanned<V>)> {
    let mut stated: Vec<_> = table.get_ref().iter().collect();
    stated.sort_by_key(|(name, _)| name.span().start);
    stated.into_iter()
}

/// The keys of tables that have names, as `[springs.NAME]`.
pub(crate) trait UnderName {
    /// A description of the keys, and the heading to write.
    const EXPECTED: &str;
}

/// Reads tables that have names. The error about keys without a name says what heading to write; a list is refused too,
/// because serde would read its entries as keys in order.
pub(crate) fn read_named_tables<'de, D, V>(deserializer: D) -> Result<Table<V>, D::Error>
where
    D: de::Deserializer<'de>,
    V: UnderName + Deserialize<'de>,
{
    let stated = Table::<Keys<V>>::deserialize(deserializer)?;
    let span = stated.span();
    let each = stated.into_inner().into_iter();
    let each = each.map(|(name, keys)| {
        let place = keys.span();
        (name, Spanned::new(place, keys.into_inner().0))
    });
    Ok(Spanned::new(span, each.collect()))
}

struct Keys<V>(V);

impl<'de, V: UnderName + Deserialize<'de>> Deserialize<'de> for Keys<V> {
    fn deserialize<D: de::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(KeysVisitor(PhantomData))
    }
}

struct KeysVisitor<V>(PhantomData<V>);

impl<'de, V: UnderName + Deserialize<'de>> Visitor<'de> for KeysVisitor<V> {
    type Value = Keys<V>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(V::EXPECTED)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Keys<V>, A::Error> {
        V::deserialize(MapAccessDeserializer::new(map)).map(Keys)
    }
}
