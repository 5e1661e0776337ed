//! Lanes against the same steps made alone, and lanes that fail among others that do not.

mod support;

mod lanes {
    mod agreement;
    mod failures;
    pub(crate) mod fleet;
}
