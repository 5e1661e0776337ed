//! The published motion.

use suspension_core::{
    Build, Certificate, Certifier, Inputs, Linkage, Listing, Motion, Newton, Real, Still, Tracker,
    assemble,
};

use crate::support;

fn follow<T: Real, L>(model: &L, rough: &L::Points, inputs: fn(T) -> Inputs<Still, L::Drives>)
where
    L: Build<15, Scalar = T> + Linkage<15, Listing: Listing<15, Model<T> = L>> + Copy,
{
    let certifier = Certifier::new(model);
    let mut q = L::unknowns(rough);
    assemble(&Newton::from_afar(), model, &inputs(T::zero()), &mut q).expect("assembles");
    let mut motion = Motion::at_rest(q);
    let dt = 1e-3;
    for step in 0..=1900 {
        let now = inputs(T::constant(f64::from(step) * dt));
        Tracker::default()
            .step(model, &now, T::constant(dt), &mut motion)
            .expect("regular");
        let certificate = certifier.certify(&now, &motion.position);
        if step % 100 == 0 {
            println!("{certificate:?}");
        }
    }
}

#[test]
fn every_step_of_the_published_motion_is_proved() {
    follow::<f64, _>(
        &support::five_link_model(),
        &support::five_link_rough(),
        support::five_link_inputs,
    );
    follow::<f64, _>(
        &support::attia_model(),
        &support::attia_rough(),
        support::attia_inputs,
    );
    follow::<f32, _>(
        &support::five_link_model(),
        &support::five_link_rough(),
        support::five_link_inputs,
    );
    follow::<f32, _>(
        &support::attia_model(),
        &support::attia_rough(),
        support::attia_inputs,
    );
}
