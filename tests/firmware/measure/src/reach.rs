//! The reach of a call: its symbols, its size and its deepest stack.

use std::collections::{BTreeSet, HashMap};

use anyhow::{Context, Result, bail};

use crate::archive::{Archive, Section};

/// The functions and data that calls reach.
pub(crate) struct Reach<'a> {
    archive: &'a Archive,
    sections: BTreeSet<usize>,
}

impl<'a> Reach<'a> {
    /// Everything that the linker would keep for these sections.
    pub(crate) fn of(archive: &'a Archive, roots: &[usize]) -> Self {
        let mut sections = BTreeSet::new();
        let mut waiting = roots.to_vec();
        while let Some(next) = waiting.pop() {
            if sections.insert(next) {
                let section = &archive.sections[next];
                waiting.extend(section.calls.iter().chain(&section.refers));
            }
        }
        Self { archive, sections }
    }

    fn sections(&self) -> impl Iterator<Item = &'a Section> {
        self.sections.iter().map(|at| &self.archive.sections[*at])
    }

    /// Returns the reached sections, the largest first.
    pub(crate) fn by_size(&self) -> Vec<&'a Section> {
        let mut sections: Vec<_> = self.sections().collect();
        sections.sort_by_key(|section| std::cmp::Reverse(section.bytes));
        sections
    }

    /// The symbols, demangled.
    pub(crate) fn symbols(&self) -> impl Iterator<Item = &'a str> {
        self.sections()
            .flat_map(|section| &section.names)
            .map(String::as_str)
    }

    /// Code and constants.
    pub(crate) fn bytes(&self) -> u64 {
        self.sections().map(|section| section.bytes).sum()
    }

    /// Returns the deepest stack of a call of `root`, bytes. Any function whose address is taken may be called by any other,
    /// one of these at a time.
    pub(crate) fn stack(&self, root: usize) -> Result<u64> {
        let mut deepest = Deepest {
            archive: self.archive,
            known: HashMap::new(),
        };
        let direct = deepest.of(root)?;
        let mut indirect = 0;
        for section in self.sections() {
            for to in &section.refers {
                if self.archive.sections[*to].is_code {
                    indirect = indirect.max(deepest.of(*to)?);
                }
            }
        }
        Ok(direct + indirect)
    }
}

struct Deepest<'a> {
    archive: &'a Archive,
    /// Depths by section; `None` while it is being found.
    known: HashMap<usize, Option<u64>>,
}

impl Deepest<'_> {
    fn of(&mut self, at: usize) -> Result<u64> {
        let section = &self.archive.sections[at];
        match self.known.get(&at) {
            Some(Some(depth)) => return Ok(*depth),
            Some(None) => bail!("{:?} calls itself", section.names),
            None => self.known.insert(at, None),
        };
        let frame = section.frame;
        let mut depth =
            frame.with_context(|| format!("the stack of {:?} is not known", section.names))?;
        let mut below = 0;
        for called in &section.calls {
            below = below.max(self.of(*called)?);
        }
        depth += below;
        self.known.insert(at, Some(depth));
        Ok(depth)
    }
}

#[cfg(test)]
mod tests {
    use super::Reach;
    use crate::archive::{Archive, Section};

    fn code(name: &str, frame: u64, calls: &[usize], refers: &[usize]) -> Section {
        Section {
            names: vec![name.to_owned()],
            bytes: 100,
            is_code: true,
            frame: Some(frame),
            calls: calls.to_vec(),
            refers: refers.to_vec(),
        }
    }

    fn data(refers: &[usize]) -> Section {
        Section {
            bytes: 10,
            refers: refers.to_vec(),
            ..Section::default()
        }
    }

    fn archive(sections: impl Into<Vec<Section>>) -> Archive {
        Archive {
            sections: sections.into(),
            ..Archive::default()
        }
    }

    #[test]
    fn the_stack_is_that_of_the_deepest_call_path() {
        let archive = archive([
            code("root", 8, &[1, 2], &[]),
            code("shallow", 16, &[3], &[]),
            code("deep", 400, &[3], &[]),
            code("leaf", 4, &[], &[]),
            code("not reached", 1000, &[], &[]),
        ]);
        let reach = Reach::of(&archive, &[0]);
        assert_eq!(reach.stack(0).expect("known"), 8 + 400 + 4);
        assert_eq!(reach.bytes(), 400);
        assert!(reach.symbols().all(|name| name != "not reached"));
    }

    #[test]
    fn methods_of_a_referenced_vtable_count_as_called() {
        let archive = archive([
            code("root", 8, &[1], &[2]),
            code("caller of a method", 16, &[], &[]),
            data(&[3]),
            code("method", 64, &[], &[]),
        ]);
        let reach = Reach::of(&archive, &[0]);
        assert_eq!(reach.stack(0).expect("known"), 8 + 16 + 64);
        assert_eq!(reach.bytes(), 310);
    }

    #[test]
    fn recursion_and_frames_of_unknown_size_are_refused() {
        let mut recursive = archive([code("root", 8, &[1], &[]), code("again", 8, &[0], &[])]);
        let message = |archive: &Archive| {
            let error = Reach::of(archive, &[0]).stack(0).expect_err("no bound");
            error.to_string()
        };
        assert_eq!(message(&recursive), "[\"root\"] calls itself");
        recursive.sections[1].frame = None;
        assert_eq!(message(&recursive), "the stack of [\"again\"] is not known");
    }
}
