//! Names beside points, without overlap.

/// A rectangle of the drawing: left, top, right, bottom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area(pub [f64; 4]);

impl Area {
    /// Makes an area around a centre.
    pub fn around((x, y): (f64, f64), half_width: f64, half_height: f64) -> Self {
        Self([
            x - half_width,
            y - half_height,
            x + half_width,
            y + half_height,
        ])
    }

    /// Returns whether two areas share a point.
    pub fn meets(&self, other: &Self) -> bool {
        let (a, b) = (self.0, other.0);
        a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
    }

    fn holds(&self, other: &Self) -> bool {
        let (a, b) = (self.0, other.0);
        a[0] <= b[0] && a[1] <= b[1] && a[2] >= b[2] && a[3] >= b[3]
    }

    fn overlap(&self, other: &Self) -> f64 {
        let (a, b) = (self.0, other.0);
        let along = |low: usize, high: usize| (a[high].min(b[high]) - a[low].max(b[low])).max(0.0);
        along(0, 2) * along(1, 3)
    }
}

/// Height of a line of text.
pub const LINE: f64 = 13.0;

/// Returns an upper estimate of the width of a text in the figures' font size.
pub fn width(text: &str) -> f64 {
    7.0 * text.chars().count() as f64
}

/// Places each text near its point: at the nearest of many places that is inside `frame` and overlaps neither `drawn` nor
/// another text, or else at the place with the least overlap.
pub fn place(texts: &[(String, (f64, f64))], drawn: &[Area], frame: Area) -> Vec<Area> {
    let mut taken = drawn.to_vec();
    let mut placed = Vec::new();
    for (text, at) in texts {
        let (half_width, half_height) = (width(text) / 2.0, LINE / 2.0);
        let covers = |area: &Area| -> f64 { taken.iter().map(|other| area.overlap(other)).sum() };
        let candidates: Vec<Area> = around(*at, half_width)
            .map(|centre| Area::around(centre, half_width, half_height))
            .filter(|area| frame.holds(area))
            .collect();
        let free = candidates
            .iter()
            .find(|area| !taken.iter().any(|other| area.meets(other)));
        let least = || {
            candidates
                .iter()
                .min_by(|a, b| covers(a).total_cmp(&covers(b)))
        };
        let chosen = free.or_else(least).copied();
        let chosen = chosen.unwrap_or_else(|| Area::around(*at, half_width, half_height));
        taken.push(chosen);
        placed.push(chosen);
    }
    placed
}

/// Centres of texts around a point, the nearest rings first.
fn around((x, y): (f64, f64), half_width: f64) -> impl Iterator<Item = (f64, f64)> {
    const DIRECTIONS: [(f64, f64); 8] = [
        (1.0, -0.6),
        (1.0, 0.6),
        (1.0, 0.0),
        (-1.0, -0.6),
        (-1.0, 0.6),
        (-1.0, 0.0),
        (0.0, -1.0),
        (0.0, 1.0),
    ];
    (0..14).flat_map(move |ring| {
        let reach = 8.0 + 9.0 * f64::from(ring);
        DIRECTIONS.map(move |(right, down)| {
            let beside = right * (reach.min(40.0) + half_width);
            let below = if right == 0.0 {
                reach + LINE / 2.0
            } else {
                reach
            };
            (x + beside, y + down * below)
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crowded_labels_overlap_neither_points_nor_each_other() {
        let points: Vec<(f64, f64)> = (0..8)
            .map(|k| (200.0 + 3.0 * f64::from(k), 200.0 + 2.0 * f64::from(k)))
            .collect();
        let texts: Vec<_> = points
            .iter()
            .map(|point| ("generated f32 ×8".to_owned(), *point))
            .collect();
        let frame = Area([0.0, 0.0, 600.0, 400.0]);
        let drawn: Vec<Area> = points.iter().map(|p| Area::around(*p, 4.0, 4.0)).collect();
        let placed = place(&texts, &drawn, frame);
        for (index, area) in placed.iter().enumerate() {
            assert!(frame.holds(area));
            assert!(placed[..index].iter().all(|other| !area.meets(other)));
            assert!(
                points
                    .iter()
                    .all(|p| !area.meets(&Area::around(*p, 4.0, 4.0)))
            );
        }
    }
}
