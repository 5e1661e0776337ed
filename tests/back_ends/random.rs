//! Random listings: groups of points, each a rigid body or a single point, held by as many links and drives as it has
//! degrees of freedom.

use std::collections::BTreeSet;
use std::fmt::Write;
use suspension_listing::include::NoIncludes;

use fastrand::Rng;
use suspension_listing::text;

const AXES: [&str; 3] = ["x", "y", "z"];

/// Returns a valid listing of about `free` free points; the same for the same seed.
pub(crate) fn listing(seed: u64, free: usize) -> String {
    let mut random = Rng::with_seed(seed);
    for _ in 0..1000 {
        let mut draft = Draft::default();
        draft.bodies(&mut random, free);
        draft.hold(&mut random);
        draft.readings(&mut random);
        let listing = draft.text(&mut random);
        if text::parse(&listing, "random", &NoIncludes).is_ok() {
            return listing;
        }
    }
    panic!("no listing from seed {seed}")
}

/// Points that move as one body.
struct Group {
    points: Vec<usize>,
    /// The number of equations that the group still needs.
    open: usize,
}

#[derive(Default)]
struct Draft {
    free: usize,
    chassis: usize,
    groups: Vec<Group>,
    statements: String,
    /// Pairs that a link joins.
    links: BTreeSet<[String; 2]>,
    /// Chassis points that no body lists.
    ends: Vec<String>,
    drives: usize,
}

fn point(index: usize) -> String {
    format!("p{index}")
}

impl Draft {
    fn line(&mut self, statement: &str) {
        writeln!(self.statements, "{statement}").expect("a string takes all text");
    }

    fn free_points(&mut self, count: usize) -> Vec<usize> {
        self.free += count;
        (self.free - count..self.free).collect()
    }

    fn chassis_point(&mut self) -> String {
        self.chassis += 1;
        format!("c{}", self.chassis - 1)
    }

    /// Bodies, some on chassis points or on points of the body before, and points by themselves.
    fn bodies(&mut self, random: &mut Rng, free: usize) {
        while self.free < free {
            if random.f64() < 0.3 {
                let points = self.free_points(1);
                self.groups.push(Group { points, open: 3 });
                continue;
            }
            let name = format!("body{}", self.groups.len());
            let own = random.usize(3..=5);
            let points = self.free_points(own);
            let mut names: Vec<String> = points.iter().map(|&index| point(index)).collect();
            let mut open = 6;
            let before = self.groups.last().filter(|group| group.points.len() > 1);
            match (random.usize(0..6), before) {
                (0, _) => {
                    names.extend([self.chassis_point(), self.chassis_point()]);
                    open = 1;
                }
                (1, _) => {
                    names.push(self.chassis_point());
                    open = 3;
                }
                (2, Some(before)) => {
                    names.push(point(before.points[0]));
                    open = 3;
                }
                (3, Some(before)) => {
                    names.extend([point(before.points[0]), point(before.points[1])]);
                    open = 1;
                }
                _ => {}
            }
            random.shuffle(&mut names);
            self.line(&format!("body {name}: {};", names.join(", ")));
            self.groups.push(Group { points, open });
        }
    }

    /// Links, slides and drives.
    fn hold(&mut self, random: &mut Rng) {
        let mut earlier = Vec::new();
        for group in std::mem::take(&mut self.groups) {
            let mut open = group.open;
            while open > 0 {
                let name = point(group.points[random.usize(0..group.points.len())]);
                open -= self.equation(random, &name, &earlier, open);
            }
            earlier.extend(group.points);
        }
    }

    /// Holds a point; returns by how many equations.
    fn equation(&mut self, random: &mut Rng, name: &str, earlier: &[usize], open: usize) -> usize {
        let (chance, axis) = (random.f64(), AXES[random.usize(0..3)]);
        let other = match earlier {
            [] => None,
            _ => Some(point(earlier[random.usize(0..earlier.len())])),
        };
        self.drives += 1;
        let index = self.drives;
        if chance < 0.06 {
            self.line(&format!("drive drive{index}: {name}.{axis};"));
        } else if let (true, Some(other)) = (chance < 0.12, &other) {
            self.line(&format!(
                "drive drive{index}: {name}.{axis} - {other}.{axis};"
            ));
        } else if chance < 0.18 && open >= 2 {
            let end = self.chassis_point();
            self.line(&format!("link link{index}: {end} -> {name};"));
            self.line(&format!(
                "drive turn{index}: angle({end} -> {name}, {axis});"
            ));
            return 2;
        } else if chance < 0.26 && open >= 2 {
            let (from, to) = (self.chassis_point(), self.chassis_point());
            self.line(&format!("slide slide{index}: {name} on {from} -> {to};"));
            return 2;
        } else {
            let end = match other.filter(|_| chance < 0.55) {
                Some(other) => other,
                None if self.ends.len() > 5 => self.ends[random.usize(0..self.ends.len())].clone(),
                None => {
                    let end = self.chassis_point();
                    self.ends.push(end.clone());
                    end
                }
            };
            if !self.links.insert([end.clone(), name.to_owned()]) {
                return 0;
            }
            self.line(&format!("link link{index}: {end} -> {name};"));
        }
        1
    }

    /// A moved chassis point, a marker, measures and roles.
    fn readings(&mut self, random: &mut Rng) {
        if let (true, Some(end)) = (random.bool(), self.ends.first().cloned()) {
            let axis = AXES[random.usize(0..3)];
            self.line(&format!("drive rack: {end}.{axis};"));
        }
        if self.free >= 3 && random.f64() < 0.7 {
            self.line("point marker: p0, p1, p2;");
            self.line("measure height: marker.z;");
            self.line("measure lean: angle(p0 -> marker, x);");
            self.line("measure reach: length(p0 -> p1);");
            self.line("measure gap: p1.y - p0.y;");
            self.line("wheel: p0 -> marker;");
            self.line("kingpin: p0 -> p1;");
        }
    }

    /// The listing, with or without a design.
    fn text(&self, random: &mut Rng) -> String {
        let is_stated = random.f64() < 0.7;
        let mut text = String::new();
        let mut declare = |kind: &str, name: String| {
            let at: [f64; 3] = [(); 3].map(|()| (1000.0 * random.f64()).round() / 1000.0);
            let at = if is_stated {
                format!(" at {at:?}")
            } else {
                String::new()
            };
            writeln!(text, "{kind}: {name}{at};").expect("a string takes all text");
        };
        (0..self.chassis).for_each(|index| declare("fixed", format!("c{index}")));
        (0..self.free).for_each(|index| declare("free", point(index)));
        text + &self.statements
    }
}
