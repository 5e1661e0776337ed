//! A five-link suspension in `float`, called as C does.
#![allow(dead_code)]

use std::mem::MaybeUninit;

use suspension_c::catalogue::five_link_f32::{self, Drives, Inputs, Model, Motion, Points};
use suspension_c::{Out, Status};

/// Attia 2003, tables 1 and 2: points 1 to 10 in metres, and a wheel centre.
pub(crate) const DESIGN: Points = Points {
    values: [
        [-1.396, -0.025, -0.082],
        [-1.301, 0.1168, 0.106],
        [-1.0941, 0.1987, 0.09],
        [-0.9838, 0.2609, -0.0501],
        [-1.095, 0.183, -0.0158],
        [-1.315, 0.4, 0.027],
        [-1.302, 0.383, 0.24],
        [-1.27, 0.315, 0.218],
        [-1.292, 0.309, -0.005],
        [-1.188, 0.418, 0.167],
        [-1.27, 0.415, 0.218],
    ],
};

/// Calls a function and returns the object that it writes.
pub(crate) fn made<T>(call: impl FnOnce(Out<'_, T>) -> Status) -> Result<T, Status> {
    let mut memory = MaybeUninit::uninit();
    match call((&mut memory).into()) {
        // SAFETY: the status `Ok` means that the object is written.
        Status::Ok => Ok(unsafe { memory.assume_init() }),
        status => Err(status),
    }
}

pub(crate) fn model() -> Model {
    made(|model| five_link_f32::model_new(model, size_of::<Model>(), (&DESIGN).into(), None.into()))
        .expect("a model")
}

pub(crate) fn at_rest() -> Motion {
    let model = model();
    made(|motion| {
        let size = size_of::<Motion>();
        five_link_f32::motion_at_rest((&model).into(), motion, size, (&DESIGN).into())
    })
    .expect("a motion")
}

pub(crate) fn inputs(value: Drives, rate: f32) -> Inputs {
    Inputs {
        value,
        rate: Drives { values: [rate] },
        second_rate: Drives { values: [0.0] },
    }
}
