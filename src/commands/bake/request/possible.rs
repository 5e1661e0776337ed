//! The part of a range that is proposed in place of one that cannot be baked.

/// The part of a range that can be baked, found by `widest`, in a few digits and the file's coordinates and units, as
/// `shown` makes them of local ones. An end that is `kept`, as nothing is in its way, stays as it is where all up to it can be baked.
pub(super) fn possible_in_few_digits(
    range: [f64; 2],
    kept: [bool; 2],
    shown: impl Fn(f64) -> f64,
    widest: impl FnOnce([f64; 2]) -> Option<[f64; 2]>,
) -> Option<[f64; 2]> {
    /// Of a range: how close to a turning point the mechanism is solved.
    const CLOSE: f64 = 1e-6;
    let [from, to] = range;
    if from >= to {
        return None;
    }
    let inset = CLOSE * (to - from);
    let within = [from + inset, to - inset];
    let tried = [0, 1].map(|end| if kept[end] { range[end] } else { within[end] });
    let found = widest(tried)?;
    let [from, to] = found.map(&shown);
    let steps_a_unit = 10_f64.powf(3.0 - (to - from).log10().floor());
    let few = [
        (from * steps_a_unit).ceil() / steps_a_unit,
        (to * steps_a_unit).floor() / steps_a_unit,
    ];
    let stays = |end: usize| kept[end] && (found[end] - range[end]).abs() < inset;
    Some([0, 1].map(|end| match stays(end) {
        true => shown(range[end]),
        false => few[end],
    }))
}
