//! Random listings: points, bodies that may share points, slides, and then links and drives until there are as many
//! equations as unknowns.

use std::fmt::Write;

use fastrand::Rng;
use suspension_listing::text;

const AXES: [&str; 3] = ["x", "y", "z"];

/// A listing, of at most so many free points, that can be read; the same for the same seed.
pub(crate) fn listing(seed: u64, most_free: usize) -> String {
    let mut random = Rng::with_seed(seed);
    for _ in 0..1000 {
        if let Some(listing) = attempt(&mut random, most_free)
            && text::parse(&listing, "random").is_ok()
        {
            return listing;
        }
    }
    panic!("no listing from seed {seed}")
}

struct Draft {
    text: String,
    points: Vec<String>,
    fixed: usize,
    /// Pairs that have a length already.
    kept: Vec<[usize; 2]>,
}

fn attempt(random: &mut Rng, most_free: usize) -> Option<String> {
    let mut draft = Draft::points(random, most_free);
    draft.bodies(random);
    let needed = draft.needed()?;
    let mut links = Vec::new();
    for index in 0..needed {
        draft.equation(random, index, &mut links);
    }
    draft.readings(random);
    Some(draft.text)
}

impl Draft {
    fn points(random: &mut Rng, most_free: usize) -> Self {
        let (fixed, free) = (random.usize(3..=8), random.usize(2..=most_free));
        let mut draft = Self {
            text: String::new(),
            points: Vec::new(),
            fixed,
            kept: Vec::new(),
        };
        let is_stated = random.f64() < 0.7;
        for index in 0..fixed + free {
            let (kind, name) = if index < fixed {
                ("fixed", format!("c{index}"))
            } else {
                ("free", format!("p{}", index - fixed))
            };
            let at: [f64; 3] = [(); 3].map(|()| (1000.0 * random.f64()).round() / 1000.0);
            let at = if is_stated { format!(" at {at:?}") } else { String::new() };
            draft.line(format!("{kind}: {name}{at};"));
            draft.points.push(name);
        }
        draft
    }

    fn line(&mut self, statement: String) {
        writeln!(self.text, "{statement}").expect("a string takes all text");
    }

    /// Some of the points, each once.
    fn some(&self, random: &mut Rng, count: usize, from: usize) -> Vec<usize> {
        let mut points: Vec<usize> = (from..self.points.len()).collect();
        random.shuffle(&mut points);
        points.truncate(count);
        points
    }

    fn names(&self, points: &[usize]) -> String {
        let names: Vec<&str> = points.iter().map(|&point| self.points[point].as_str()).collect();
        names.join(", ")
    }

    fn bodies(&mut self, random: &mut Rng) {
        for index in 0..random.usize(0..=3) {
            let count = random.usize(3..=6);
            let on_chassis = random.usize(0..=2);
            let mut points = self.some(random, count, self.fixed);
            let mut anchors: Vec<usize> = (0..self.fixed).collect();
            random.shuffle(&mut anchors);
            points.extend(anchors.into_iter().take(on_chassis));
            random.shuffle(&mut points);
            if points.len() < 3 {
                continue;
            }
            self.line(format!("body body{index}: {};", self.names(&points)));
            if random.f64() < 0.3 {
                let outside = self.some(random, self.points.len(), 0);
                let sliding = outside.into_iter().find(|point| !points.contains(point));
                if let Some(sliding) = sliding {
                    let line = [points[0], points[1]].map(|point| &self.points[point]);
                    let (from, to) = (line[0].clone(), line[1].clone());
                    let sliding = self.points[sliding].clone();
                    self.line(format!("slide slide{index}: {sliding} on {from} -> {to};"));
                }
            }
            for (first, &a) in points.iter().enumerate() {
                self.kept.extend(points[first + 1..].iter().map(|&b| [a.min(b), a.max(b)]));
            }
        }
    }

    /// How many equations are still needed; `None` where there are too many.
    fn needed(&self) -> Option<usize> {
        let system = text::read(&self.text).system?;
        system.size().checked_sub(system.rows().len())
    }

    fn equation(&mut self, random: &mut Rng, index: usize, links: &mut Vec<[String; 2]>) {
        let chance = random.f64();
        let free = random.usize(self.fixed..self.points.len());
        let axis = AXES[random.usize(0..3)];
        let name = self.points[free].clone();
        if chance < 0.08 {
            self.line(format!("drive drive{index}: {name}.{axis};"));
        } else if chance < 0.16 {
            let other = self.points[random.usize(0..self.points.len())].clone();
            self.line(format!("drive drive{index}: {name}.{axis} - {other}.{axis};"));
        } else if let (true, Some([from, to])) = (chance < 0.22, links.pop()) {
            self.line(format!("drive drive{index}: angle({from} -> {to}, {axis});"));
        } else {
            let ends = (0..50).find_map(|_| {
                let other = if random.f64() < 0.7 {
                    random.usize(0..self.fixed)
                } else {
                    random.usize(self.fixed..self.points.len())
                };
                let pair = [other.min(free), other.max(free)];
                (other != free && !self.kept.contains(&pair)).then_some((other, pair))
            });
            if let Some((other, pair)) = ends {
                let from = self.points[other].clone();
                self.line(format!("link link{index}: {from} -> {name};"));
                self.kept.push(pair);
                links.push([from, name]);
            }
        }
    }

    /// Moved chassis points, markers, measures and roles.
    fn readings(&mut self, random: &mut Rng) {
        if random.f64() < 0.5 {
            let (point, axis) = (random.usize(0..self.fixed), AXES[random.usize(0..3)]);
            self.line(format!("drive rack: c{point}.{axis};"));
        }
        let carriers = self.some(random, 3, self.fixed.saturating_sub(1));
        if carriers.len() == 3 && random.f64() < 0.7 {
            self.line(format!("point marker: {};", self.names(&carriers)));
            self.line("measure height: marker.z;".to_owned());
            let [a, b, _] = [0, 1, 2].map(|index| self.points[carriers[index]].clone());
            self.line(format!("measure lean: angle({a} -> marker, x);"));
            self.line(format!("measure reach: length({a} -> {b});"));
            self.line(format!("measure gap: {a}.y - {b}.y;"));
            self.line(format!("wheel: {a} -> marker;"));
            self.line(format!("kingpin: {a} -> {b};"));
        }
    }
}
