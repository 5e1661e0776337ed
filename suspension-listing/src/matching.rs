//! Bipartite matching: a different unknown for each equation.

/// Finds a column for `row` among those of its `pattern`, moving earlier rows to other columns if necessary (an
/// augmenting path). `seen` has a place for each column; none of them may be marked yet.
pub fn augment(
    row: usize,
    pattern: &[Vec<usize>],
    row_of: &mut [Option<usize>],
    seen: &mut [bool],
) -> bool {
    pattern[row].iter().any(|&column| {
        if std::mem::replace(&mut seen[column], true) {
            return false;
        }
        let free = row_of[column].is_none_or(|other| augment(other, pattern, row_of, seen));
        if free {
            row_of[column] = Some(row);
        }
        free
    })
}
