//! The range that is proposed in place of one that cannot be baked.

/// Returns the part of a range that can be baked, which `widest` finds, rounded to a few digits in the file's coordinates
/// and units; `shown` converts local values to these. An end that is `kept`, because nothing limits it, is not rounded if
/// the range up to it can be baked.
pub(super) fn possible_in_few_digits(
    range: [f64; 2],
    kept: [bool; 2],
    shown: impl Fn(f64) -> f64,
    widest: impl FnOnce([f64; 2]) -> Option<[f64; 2]>,
) -> Option<[f64; 2]> {
    /// How near to a turning point the mechanism is solved, as a part of the range.
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
