//! Rows and curves of the same quantity, one for each wheel, as groups.

/// Groups the things of equal name, in the order of the first of each.
pub(super) fn grouped<T>(things: &[T], called: impl Fn(&T) -> &String) -> Vec<Vec<&T>> {
    let mut groups: Vec<Vec<&T>> = Vec::new();
    for thing in things {
        let mut known = groups.iter_mut();
        match known.find(|group| called(group[0]) == called(thing)) {
            Some(group) => group.push(thing),
            None => groups.push(vec![thing]),
        }
    }
    groups
}
