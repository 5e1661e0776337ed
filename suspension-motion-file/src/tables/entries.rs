//! Tables of a motion file.

use std::fmt;
use std::marker::PhantomData;
use std::ops::Index;

use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use toml::Spanned;

/// Values by name, with the place of the table in the file.
pub type Table<V> = Spanned<Entries<V>>;

/// Values by name in the order of the file, each with its place there.
#[derive(Clone, Debug, PartialEq)]
pub struct Entries<V>(Vec<(Spanned<String>, Spanned<V>)>);

impl<V> Entries<V> {
    /// A table without entries.
    pub const EMPTY: Self = Self(Vec::new());

    /// Returns whether the table has no entry.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns the entries in the order of the file.
    pub fn iter(&self) -> impl Iterator<Item = (&Spanned<String>, &Spanned<V>)> {
        self.0.iter().map(|(name, value)| (name, value))
    }

    /// Returns the names in the order of the file.
    pub fn names(&self) -> impl Iterator<Item = &Spanned<String>> {
        self.0.iter().map(|(name, _)| name)
    }

    /// Returns the values in the order of the file.
    pub fn values(&self) -> impl Iterator<Item = &Spanned<V>> {
        self.0.iter().map(|(_, value)| value)
    }

    /// Returns the values in the order of the file.
    pub fn values_mut(&mut self) -> impl Iterator<Item = &mut Spanned<V>> {
        self.0.iter_mut().map(|(_, value)| value)
    }

    /// Returns whether the table has an entry for a name.
    pub fn has(&self, name: &str) -> bool {
        self.get(name).is_some()
    }

    /// Returns the value of a name; `None` if there is none.
    pub fn get(&self, name: &str) -> Option<&Spanned<V>> {
        let mut entries = self.0.iter();
        let (_, value) = entries.find(|(other, _)| other.get_ref() == name)?;
        Some(value)
    }

    /// Adds an entry for a name that has none.
    pub fn add(&mut self, name: Spanned<String>, value: Spanned<V>) {
        self.0.push((name, value));
    }
}

impl<V> Index<&str> for Entries<V> {
    type Output = Spanned<V>;

    fn index(&self, name: &str) -> &Spanned<V> {
        self.get(name).expect("a name of the table")
    }
}

impl<'de, V: Deserialize<'de>> Deserialize<'de> for Entries<V> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(EntriesVisitor(PhantomData))
    }
}

struct EntriesVisitor<V>(PhantomData<V>);

impl<'de, V: Deserialize<'de>> Visitor<'de> for EntriesVisitor<V> {
    type Value = Entries<V>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a table with a line for each name")
    }

    /// The parser gives the entries in the order of the alphabet.
    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Entries<V>, A::Error> {
        let mut entries: Vec<(Spanned<String>, _)> = Vec::new();
        while let Some(entry) = map.next_entry()? {
            entries.push(entry);
        }
        entries.sort_by_key(|(name, _)| name.span().start);
        Ok(Entries(entries))
    }
}
