//! Where names stand beside their points.

/// The upper left corner of a name.
pub(super) struct Boxed {
    pub(super) left: i32,
    pub(super) top: i32,
}

/// Names that were put, and places, beyond the sheet's sides too, that they must keep clear of.
pub(super) struct Labels {
    taken: Vec<[i32; 4]>,
    unit: i32,
}

/// Of a name, as shown: the width of a letter and the height of a line.
const LETTER: i32 = 8;
const LINE: i32 = 16;
/// Between a point and its name.
const GAP: i32 = 9;

impl Labels {
    /// Beside points on a sheet of a size as shown; `unit` drawing units are one as shown.
    pub(super) fn among(points: &[(i32, i32)], (width, height): (u32, u32), unit: i32) -> Self {
        let [width, height] = [width, height].map(|size| size as i32 * unit);
        let left = [-width, 0, 0, height];
        let right = [width, 0, 2 * width, height];
        let half = 6 * unit;
        let around = |&(x, y): &(i32, i32)| [x - half, y - half, x + half, y + half];
        Self {
            taken: points.iter().map(around).chain([left, right]).collect(),
            unit,
        }
    }

    /// Finds a place for a name beside its point: the first that overlaps least.
    pub(super) fn put(&mut self, name: &str, (x, y): (i32, i32)) -> Boxed {
        let unit = self.unit;
        let width = LETTER * name.chars().count() as i32 * unit;
        let (height, gap) = (LINE * unit, GAP * unit);
        let columns = [x + gap, x - gap - width, x - width / 2];
        let rows = [y - height / 2, y - gap - height, y + gap];
        let places = [
            (0, 0),
            (1, 0),
            (0, 1),
            (0, 2),
            (1, 1),
            (1, 2),
            (2, 1),
            (2, 2),
        ];
        let boxes = places.map(|(column, row): (usize, usize)| {
            let (left, top) = (columns[column], rows[row]);
            [left, top, left + width, top + height]
        });
        let overlap = |place: &&[i32; 4]| {
            self.taken
                .iter()
                .map(|other| common(place, other))
                .sum::<i64>()
        };
        let best = boxes
            .iter()
            .min_by_key(overlap)
            .copied()
            .unwrap_or([x, y, x, y]);
        self.taken.push(best);
        Boxed {
            left: best[0],
            top: best[1],
        }
    }
}

/// The area that two boxes have in common.
fn common(a: &[i32; 4], b: &[i32; 4]) -> i64 {
    let along =
        |low: usize, high: usize| i64::from((a[high].min(b[high]) - a[low].max(b[low])).max(0));
    along(0, 2) * along(1, 3)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_points_side_by_side_do_not_overlap() {
        let points = [(100, 100), (120, 100), (100, 120)];
        let mut labels = Labels::among(&points, (300, 300), 1);
        for point in points {
            labels.put("upper_front", point);
        }
        let [a, b, c] = &labels.taken[5..] else {
            panic!("three names")
        };
        assert_eq!([common(a, b), common(a, c), common(b, c)], [0; 3]);
    }

    #[test]
    fn names_of_points_at_the_sides_stay_on_the_sheet() {
        let points = [(10, 100), (290, 100), (10, 120), (290, 120)];
        let mut labels = Labels::among(&points, (300, 300), 1);
        for point in points {
            labels.put("upper_front", point);
        }
        let names = &labels.taken[6..];
        assert!(
            names
                .iter()
                .all(|[left, _, right, _]| *left >= 0 && *right <= 300)
        );
    }
}
