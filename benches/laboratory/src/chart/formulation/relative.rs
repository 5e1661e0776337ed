//! Relative coordinates: joint angles of an open chain, closed by the other links.

use nalgebra::{SMatrix, SVector, Vector3};
use suspension_core::{Real, Signal, Values};

use super::five_links::{FiveLinks, in_a_row};
use super::{Formulation, State};

/// Five unknowns: azimuth and angle from the vertical of the first link at the chassis, and three
/// Cardan angles of the knuckle on it. Rows: the lengths of the other four links,
/// `(|d|^2 - L^2) / (2 L)`, and the first link's driven angle, times its length.
///
/// The axes of the five joints, from chassis to knuckle: z; y turned by the azimuth; then x, y and
/// z of the link, each turned by the angles before it.
#[derive(Clone, Copy, Debug)]
pub struct Relative<T> {
    links: FiveLinks<T>,
    /// Angles of the first link at the instant that the motion begins.
    start: [T; 2],
    /// Knuckle ends, in axes of the first link at that instant.
    local: [Vector3<T>; 5],
}

const DRIVEN: usize = 1;
const DRIVE: usize = 4;

/// The joints' axes and the knuckle in one configuration, in chassis axes.
struct Chain<T> {
    axes: [Vector3<T>; 5],
    /// The first link.
    link: Vector3<T>,
    /// Knuckle ends, from the first one.
    arms: [Vector3<T>; 5],
}

/// The rate of turn of link or knuckle, and its change at constant joint rates.
#[derive(Clone, Copy)]
struct Turning<T> {
    rate: Vector3<T>,
    change: Vector3<T>,
}

impl<T: Real> Turning<T> {
    fn velocity(&self, arm: &Vector3<T>) -> Vector3<T> {
        self.rate.cross(arm)
    }

    fn acceleration(&self, arm: &Vector3<T>) -> Vector3<T> {
        self.change.cross(arm) + self.rate.cross(&self.rate.cross(arm))
    }
}

type Frame<T> = [Vector3<T>; 3];

/// A frame turned about its axis number `axis`.
fn turn<T: Real>(mut frame: Frame<T>, axis: usize, angle: T) -> Frame<T> {
    let (sine, cosine) = angle.sin_cos();
    let (second, third) = ((axis + 1) % 3, (axis + 2) % 3);
    let (v, w) = (frame[second], frame[third]);
    frame[second] = v * cosine + w * sine;
    frame[third] = w * cosine - v * sine;
    frame
}

fn along<T: Real>(frame: &Frame<T>, v: &Vector3<T>) -> Vector3<T> {
    frame[0] * v.x + frame[1] * v.y + frame[2] * v.z
}

fn link_frame<T: Real>(azimuth: T, angle: T) -> [Frame<T>; 2] {
    let turned = turn(
        std::array::from_fn(|axis| Vector3::ith(axis, T::one())),
        2,
        azimuth,
    );
    [turned, turn(turned, 1, angle)]
}

impl<T: Real> Relative<T> {
    /// The chain of the links' configuration.
    pub fn new(links: FiveLinks<T>) -> Self {
        let link = links.origin - links.chassis[0];
        let start = [link.y.atan2(link.x), link.x.hypot(link.y).atan2(link.z)];
        let [_, frame] = link_frame(start[0], start[1]);
        let local = links
            .knuckle
            .map(|arm| Vector3::from_fn(|axis, _| frame[axis].dot(&arm)));
        Self {
            links,
            start,
            local,
        }
    }

    fn chain(&self, x: &SVector<T, 5>) -> Chain<T> {
        let [azimuth, first] = link_frame(x[0], x[1]);
        let second = turn(first, 0, x[2]);
        let third = turn(second, 1, x[3]);
        let knuckle = turn(third, 2, x[4]);
        Chain {
            axes: [Vector3::z(), azimuth[1], first[0], second[1], third[2]],
            link: first[2] * self.links.lengths[0],
            arms: self.local.map(|arm| along(&knuckle, &arm)),
        }
    }

    fn vector(&self, chain: &Chain<T>, i: usize) -> Vector3<T> {
        self.links.chassis[0] + chain.link + chain.arms[i] - self.links.chassis[i]
    }
}

impl<T: Real> Chain<T> {
    /// First link and knuckle at joint rates `dx`.
    fn turning(&self, dx: &SVector<T, 5>) -> [Turning<T>; 2] {
        let mut all = [Turning {
            rate: Vector3::zeros(),
            change: Vector3::zeros(),
        }; 6];
        for (k, axis) in self.axes.iter().enumerate() {
            let before = all[k];
            let rate = axis * dx[k];
            all[k + 1] = Turning {
                rate: before.rate + rate,
                change: before.change + before.rate.cross(&rate),
            };
        }
        [all[2], all[5]]
    }

    /// A knuckle end's velocity.
    fn velocity(&self, [link, knuckle]: &[Turning<T>; 2], i: usize) -> Vector3<T> {
        link.velocity(&self.link) + knuckle.velocity(&self.arms[i])
    }

    /// A knuckle end's acceleration at constant joint rates.
    fn acceleration(&self, [link, knuckle]: &[Turning<T>; 2], i: usize) -> Vector3<T> {
        link.acceleration(&self.link) + knuckle.acceleration(&self.arms[i])
    }
}

impl<T: Real, D: Values<f64>, const N: usize> Formulation<T, D, 5, N> for Relative<T> {
    /// The first link's angle from the vertical.
    type Input = Signal<T>;

    fn input(&self, drives: &Signal<D>) -> Signal<T> {
        super::first_drive(drives)
    }

    fn size(&self) -> T {
        self.links.size()
    }

    fn residual(&self, x: &SVector<T, 5>, angle: &Signal<T>) -> SVector<T, 5> {
        let chain = self.chain(x);
        let mut rows = SVector::zeros();
        for (i, length) in self.links.lengths.iter().enumerate().skip(1) {
            let square = self.vector(&chain, i).norm_squared() - *length * *length;
            rows[i - 1] = square * T::constant(0.5) / *length;
        }
        rows[DRIVE] = (x[DRIVEN] - angle.value) * self.links.lengths[0];
        rows
    }

    fn jacobian(&self, x: &SVector<T, 5>, _: &Signal<T>) -> SMatrix<T, 5, 5> {
        let chain = self.chain(x);
        let mut rows = SMatrix::zeros();
        for (i, length) in self.links.lengths.iter().enumerate().skip(1) {
            let d = self.vector(&chain, i) / *length;
            let about_knuckle = chain.arms[i].cross(&d);
            let about_chassis = about_knuckle + chain.link.cross(&d);
            for (k, axis) in chain.axes.iter().enumerate() {
                let moment = if k < 2 { about_chassis } else { about_knuckle };
                rows[(i - 1, k)] = axis.dot(&moment);
            }
        }
        rows[(DRIVE, DRIVEN)] = self.links.lengths[0];
        rows
    }

    fn rate(&self, _: &SVector<T, 5>, angle: &Signal<T>) -> SVector<T, 5> {
        SVector::ith(DRIVE, angle.rate * self.links.lengths[0])
    }

    fn second_rate(
        &self,
        x: &SVector<T, 5>,
        velocity: &SVector<T, 5>,
        angle: &Signal<T>,
    ) -> SVector<T, 5> {
        let chain = self.chain(x);
        let turning = chain.turning(velocity);
        let mut rows = SVector::ith(DRIVE, angle.second_rate * self.links.lengths[0]);
        for (i, length) in self.links.lengths.iter().enumerate().skip(1) {
            let square = chain.velocity(&turning, i).norm_squared();
            let turned = self.vector(&chain, i).dot(&chain.acceleration(&turning, i));
            rows[i - 1] = -(square + turned) / *length;
        }
        rows
    }

    fn near_points(&self, _: &SVector<f64, N>) -> SVector<T, 5> {
        let [azimuth, angle] = self.start;
        SVector::from([azimuth, angle, T::zero(), T::zero(), T::zero()])
    }

    fn points(&self, [x, dx, ddx]: &State<T, 5>) -> [SVector<f64, N>; 3] {
        let chain = self.chain(x);
        let [turning, speeding] = [dx, ddx].map(|rates| chain.turning(rates));
        [
            in_a_row(|i| self.vector(&chain, i) + self.links.chassis[i]),
            in_a_row(|i| chain.velocity(&turning, i)),
            in_a_row(|i| chain.velocity(&speeding, i) + chain.acceleration(&turning, i)),
        ]
    }
}
