//! The linkages of the catalogue in each number type, as the features select them.

#[cfg(all(feature = "attia2003", feature = "f32"))]
crate::export!(
    /// The multi-link five-point suspension of Attia 2003 as printed: fourteen distances and the
    /// drive `theta`, the angle of the lower leading link from the vertical, rad.
    pub mod attia2003_f32 = suspension_core::linkages::attia2003, f32, "susp_attia2003_f32", wheel, kingpin
);

#[cfg(all(feature = "attia2003", feature = "f64"))]
crate::export!(
    /// The multi-link five-point suspension of Attia 2003 as printed: fourteen distances and the
    /// drive `theta`, the angle of the lower leading link from the vertical, rad.
    pub mod attia2003_f64 = suspension_core::linkages::attia2003, f64, "susp_attia2003_f64", wheel, kingpin
);

#[cfg(all(feature = "five_link", feature = "f32"))]
crate::export!(
    /// Five links between chassis and a rigid knuckle. Drive `theta`: the angle of the lower leading
    /// link from the vertical, rad.
    pub mod five_link_f32 = suspension_core::linkages::five_link, f32, "susp_five_link_f32", wheel, kingpin
);

#[cfg(all(feature = "five_link", feature = "f64"))]
crate::export!(
    /// Five links between chassis and a rigid knuckle. Drive `theta`: the angle of the lower leading
    /// link from the vertical, rad.
    pub mod five_link_f64 = suspension_core::linkages::five_link, f64, "susp_five_link_f64", wheel, kingpin
);
