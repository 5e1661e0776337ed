//! The sections of an archive, one per function, and their references to each other.

use std::collections::HashMap;
use std::path::Path;

use anyhow::{Context, Result};
use object::read::archive::ArchiveFile;
use object::{
    Object, ObjectSection, ObjectSymbol, RelocationFlags, RelocationTarget, SectionIndex,
    SectionKind, elf,
};

/// A function, or data.
#[derive(Clone, Debug, Default)]
pub(crate) struct Section {
    /// Its symbols, demangled; the section's name for data without symbols.
    pub names: Vec<String>,
    /// Size.
    pub bytes: u64,
    pub is_code: bool,
    /// The stack of the function alone, bytes, if the compiler has recorded it.
    pub frame: Option<u64>,
    /// Sections that it calls.
    pub calls: Vec<usize>,
    /// Sections of which it has the address.
    pub refers: Vec<usize>,
}

/// All sections of all objects.
#[derive(Clone, Debug, Default)]
pub(crate) struct Archive {
    pub sections: Vec<Section>,
    /// Sections by global symbol, as the linker sees it.
    pub globals: HashMap<String, usize>,
}

impl Archive {
    pub(crate) fn read(path: &Path) -> Result<Self> {
        let data = std::fs::read(path)?;
        let archive = ArchiveFile::parse(&*data)?;
        let members: Vec<&[u8]> = archive
            .members()
            .map(|member| member?.data(&*data))
            .collect::<object::Result<_>>()?;
        let objects: Vec<object::File<'_>> = members
            .into_iter()
            .map(object::File::parse)
            .collect::<object::Result<_>>()?;
        let mut all = Self::default();
        let places: Vec<_> = objects
            .iter()
            .map(|object| all.add_sections(object))
            .collect();
        for (object, places) in objects.iter().zip(&places) {
            all.add_references(object, places)?;
        }
        Ok(all)
    }

    /// The section of a global symbol.
    pub(crate) fn find(&self, symbol: &str) -> Result<usize> {
        let found = self.globals.get(symbol).copied();
        found.with_context(|| format!("there is no {symbol}"))
    }

    fn add_sections(&mut self, object: &object::File<'_>) -> HashMap<SectionIndex, usize> {
        let mut places = HashMap::new();
        for section in object.sections() {
            places.insert(section.index(), self.sections.len());
            let is_loaded = !matches!(
                section.kind(),
                SectionKind::Metadata | SectionKind::Other | SectionKind::Debug
            );
            self.sections.push(Section {
                bytes: if is_loaded { section.size() } else { 0 },
                is_code: section.kind() == SectionKind::Text,
                ..Section::default()
            });
        }
        for symbol in object.symbols() {
            let Some(place) = symbol.section_index().and_then(|index| places.get(&index)) else {
                continue;
            };
            let name = symbol.name().unwrap_or_default();
            if symbol.is_global() {
                self.globals.entry(name.to_owned()).or_insert(*place);
            }
            // The others are marks within sections.
            if symbol.is_definition() {
                let demangled = format!("{:#}", rustc_demangle::demangle(name));
                self.sections[*place].names.push(demangled);
            }
        }
        places
    }

    fn add_references(
        &mut self,
        object: &object::File<'_>,
        places: &HashMap<SectionIndex, usize>,
    ) -> Result<()> {
        for section in object.sections() {
            let from = places[&section.index()];
            for (offset, relocation) in section.relocations() {
                let RelocationTarget::Symbol(index) = relocation.target() else {
                    continue;
                };
                let symbol = object.symbol_by_index(index)?;
                let to = match symbol.section_index() {
                    Some(index) => places[&index],
                    None => self.elsewhere(symbol.name()?),
                };
                if section.name()? == ".stack_sizes" {
                    let start = offset as usize + if object.is_64() { 8 } else { 4 };
                    self.sections[to].frame = section.data()?.get(start..).map(unsigned_leb128);
                } else if to != from && is_call(object, relocation.flags()) {
                    self.sections[from].calls.push(to);
                } else if to != from {
                    self.sections[from].refers.push(to);
                }
            }
        }
        Ok(())
    }

    /// The section of a symbol that another object defines, or none.
    fn elsewhere(&mut self, symbol: &str) -> usize {
        let new = self.sections.len();
        let place = *self.globals.entry(symbol.to_owned()).or_insert(new);
        if place == new {
            self.sections.push(Section {
                names: vec![symbol.to_owned()],
                ..Section::default()
            });
        }
        place
    }
}

fn is_call(object: &object::File<'_>, flags: RelocationFlags) -> bool {
    let RelocationFlags::Elf { r_type } = flags else {
        return false;
    };
    match object.architecture() {
        object::Architecture::Arm => [
            elf::R_ARM_THM_PC22,
            elf::R_ARM_THM_JUMP24,
            elf::R_ARM_THM_JUMP19,
        ]
        .contains(&r_type),
        _ => [elf::R_RISCV_CALL, elf::R_RISCV_CALL_PLT, elf::R_RISCV_JAL].contains(&r_type),
    }
}

/// Reads a number with seven bits per byte, the lowest first; the highest bit says that another byte follows.
fn unsigned_leb128(bytes: &[u8]) -> u64 {
    let length = bytes.iter().take_while(|byte| **byte >= 0x80).count() + 1;
    let digits = bytes.iter().take(length).rev();
    digits.fold(0, |number, byte| number << 7 | u64::from(byte & 0x7f))
}

#[cfg(test)]
mod tests {
    use super::unsigned_leb128;

    #[test]
    fn leb128_numbers_are_decoded() {
        assert_eq!(unsigned_leb128(&[8, 99]), 8);
        // DWARF 5, section 7.6.
        assert_eq!(unsigned_leb128(&[0xe5, 0x8e, 0x26]), 624_485);
    }
}
