//! The parts of a mechanism that can be assembled one after another: its block triangular form.
//!
//! Duff, Erisman and Reid, Direct Methods for Sparse Matrices, chapter 6. Both corners of an axle follow from the rack, and a
//! rocker from the corner whose pushrod it holds: their assemblies multiply, but are found one part at a time.

use suspension_listing::matching::augment;

use crate::assemblies::factors::Vector;

/// Some of the equations, with as many unknowns that only they determine.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Part {
    /// Each equation with one of the unknowns, all different.
    pub(crate) own: Vec<[usize; 2]>,
    /// All other equations and unknowns, likewise.
    pub(crate) others: Vec<[usize; 2]>,
    /// The pairs in `others` whose unknowns occur in the part's equations.
    pub(crate) needed: Vec<[usize; 2]>,
    /// Whether its equations are linear in its unknowns.
    pub(crate) is_linear: bool,
}

/// Whether each unknown (column) occurs in each equation (row).
pub(crate) type Pattern = Vec<Vec<bool>>;

/// The parts in an order in which each needs only those before it. Linear parts that need nothing else come first;
/// later ones belong to the part that they follow from, which might otherwise have too few coordinates to be cut by a
/// general plane.
pub(crate) fn parts_in_order(pattern: &Pattern, is_linear: &dyn Fn(&Part) -> bool) -> Vec<Part> {
    let Some(matched) = matching(pattern) else {
        // Singular whatever the position: no order is possible.
        let all: Vec<_> = (0..pattern.len()).map(|row| [row, row]).collect();
        return vec![Part::new(pattern, &all, |_| true)];
    };
    let part = |rows: Vec<usize>| Part::new(pattern, &matched, |row| rows.contains(&row));
    let mut pending = Pending::new(pattern, &matched, is_linear);
    let mut ordered = Vec::new();
    while let Some(rows) = pending.take_linear() {
        ordered.push(Part {
            is_linear: true,
            ..part(rows)
        });
    }
    while let Some(mut rows) = pending.take_first() {
        rows.extend(std::iter::from_fn(|| pending.take_linear()).flatten());
        ordered.push(part(rows));
    }
    ordered
}

/// Parts that are not yet in order.
struct Pending<'a> {
    parts: Vec<Part>,
    /// The equations of the parts that are in order.
    found: Vec<bool>,
    is_linear: &'a dyn Fn(&Part) -> bool,
}

impl<'a> Pending<'a> {
    /// All parts, each as small as possible.
    fn new(
        pattern: &Pattern,
        matched: &[[usize; 2]],
        is_linear: &'a dyn Fn(&Part) -> bool,
    ) -> Self {
        let count = pattern.len();
        let needs = reachable(pattern, matched);
        let together = |a: usize, b: usize| a == b || needs[a][b] && needs[b][a];
        let firsts = (0..count).filter(|row| (0..*row).all(|before| !together(*row, before)));
        let part = |first| Part::new(pattern, matched, |row| together(first, row));
        Self {
            parts: firsts.map(part).collect(),
            found: vec![false; count],
            is_linear,
        }
    }

    /// The equations of the first part that needs only what is found.
    fn take_first(&mut self) -> Option<Vec<usize>> {
        let is_first = |part: &Part| part.follows_from(&self.found);
        let first = self.parts.iter().position(is_first)?;
        Some(self.take(vec![self.parts[first].clone()]))
    }

    /// The equations of all linear parts that need only what is found.
    fn take_linear(&mut self) -> Option<Vec<usize>> {
        let ready = |part: &&Part| part.follows_from(&self.found) && (self.is_linear)(part);
        let ready: Vec<Part> = self.parts.iter().filter(ready).cloned().collect();
        (!ready.is_empty()).then(|| self.take(ready))
    }

    fn take(&mut self, parts: Vec<Part>) -> Vec<usize> {
        self.parts.retain(|part| !parts.contains(part));
        let rows: Vec<usize> = parts.iter().flat_map(Part::rows).collect();
        rows.iter().for_each(|row| self.found[*row] = true);
        rows
    }
}

impl Part {
    /// The part that consists of these rows.
    fn new(pattern: &Pattern, matched: &[[usize; 2]], is_own: impl Fn(usize) -> bool) -> Self {
        let (own, others): (Vec<_>, Vec<_>) = matched.iter().partition(|[row, _]| is_own(*row));
        let is_needed = |[_, column]: &[usize; 2]| {
            let mut rows = own.iter();
            rows.any(|[row, _]: &[usize; 2]| pattern[*row][*column])
        };
        let needed = others.iter().copied().filter(is_needed).collect();
        Self {
            own,
            others,
            needed,
            is_linear: false,
        }
    }

    /// The right-hand sides that give all other unknowns the values of an assembly.
    pub(crate) fn right_hand_side<const N: usize>(&self, assembly: &Vector<N>) -> Vector<N> {
        let mut right = Vector::zeros();
        for &[row, column] in &self.others {
            right[row] = assembly[column];
        }
        right
    }

    /// An assembly with the part's unknowns taken from another.
    pub(crate) fn put<const N: usize>(
        &self,
        source: &Vector<N>,
        mut assembly: Vector<N>,
    ) -> Vector<N> {
        for column in self.columns() {
            assembly[column] = source[column];
        }
        assembly
    }

    /// Whether all that it needs is found.
    fn follows_from(&self, found: &[bool]) -> bool {
        self.needed.iter().all(|[row, _]| found[*row])
    }

    /// Its equations.
    pub(crate) fn rows(&self) -> impl Iterator<Item = usize> {
        self.own.iter().map(|[row, _]| *row)
    }

    /// Its unknowns.
    pub(crate) fn columns(&self) -> impl Iterator<Item = usize> {
        self.own.iter().map(|[_, column]| *column)
    }
}

/// An unknown for each equation, all different; `None` if there are none such.
fn matching(pattern: &Pattern) -> Option<Vec<[usize; 2]>> {
    let count = pattern.len();
    let columns = |row: &Vec<bool>| (0..count).filter(|column| row[*column]).collect();
    let columns: Vec<Vec<usize>> = pattern.iter().map(columns).collect();
    let mut row_of = vec![None; count];
    let mut rows = 0..count;
    if !rows.all(|row| augment(row, &columns, &mut row_of, &mut vec![false; count])) {
        return None;
    }
    let mut matched = vec![[0; 2]; count];
    for (column, row) in row_of.into_iter().enumerate() {
        matched[row?] = [row?, column];
    }
    Some(matched)
}

/// The equations that must be solved before each one: those of its unknowns, and theirs in turn (Warshall 1962).
fn reachable(pattern: &Pattern, matched: &[[usize; 2]]) -> Pattern {
    let needs_of = |row: &Vec<bool>| matched.iter().map(|[_, column]| row[*column]).collect();
    let mut needs: Pattern = pattern.iter().map(needs_of).collect();
    for through in 0..pattern.len() {
        let beyond = needs[through].clone();
        for row in &mut needs {
            if row[through] {
                for (needed, beyond) in row.iter_mut().zip(&beyond) {
                    *needed |= beyond;
                }
            }
        }
    }
    needs
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The unknowns of each part.
    fn parts(rows: [[u8; 5]; 5], is_linear: impl Fn(&Part) -> bool) -> Vec<Vec<usize>> {
        let pattern = rows
            .map(|row| row.map(|entry| entry != 0).to_vec())
            .to_vec();
        let parts = parts_in_order(&pattern, &is_linear);
        let columns = parts.iter().map(|part| {
            let mut columns: Vec<usize> = part.columns().collect();
            columns.sort_unstable();
            columns
        });
        columns.collect()
    }

    /// Unknowns 0 and 1 need 4, which stands alone; 2 needs 1, and 3 needs both.
    const ROWS: [[u8; 5]; 5] = [
        [1, 1, 0, 0, 0],
        [0, 1, 1, 1, 0],
        [1, 1, 0, 0, 1],
        [0, 0, 0, 0, 1],
        [0, 1, 1, 0, 0],
    ];

    #[test]
    fn each_part_depends_on_earlier_parts_only() {
        let expected: [&[usize]; 4] = [&[4], &[0, 1], &[2], &[3]];
        assert_eq!(parts(ROWS, |_| false), expected);
    }

    #[test]
    fn linear_parts_are_merged_with_the_part_they_follow_from() {
        let expected: [&[usize]; 2] = [&[4], &[0, 1, 2, 3]];
        assert_eq!(parts(ROWS, |part| part.own.len() == 1), expected);
    }

    #[test]
    fn a_structurally_singular_system_is_one_part() {
        let singular = [[1, 0, 0, 0, 0]; 5];
        assert_eq!(parts(singular, |_| false), [[0, 1, 2, 3, 4]]);
    }
}
