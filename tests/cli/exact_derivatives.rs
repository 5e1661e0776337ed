//! Derivatives and sensitivities of every quantity, at every layout of the catalogue, against central differences in numbers
//! of 32 digits: see `suspension_exact_derivatives`.

use suspension_exact_derivatives::{GATE, Worst, layouts};

use super::program::{folder, run};

/// Returns the output of the program for a motion file.
fn program(file: &str, arguments: &[&str]) -> Vec<u8> {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), arguments);
    assert_eq!(output.status.code(), Some(0), "{file}: {output:?}");
    output.stdout
}

/// Asserts that the largest error of a layout, of at least `least` numbers, is within the gate.
fn hold(layout: &str, Worst { off, what, count }: Worst, least: usize) {
    println!("{count} numbers within {off:.1e}, the worst {what}");
    assert!(off <= GATE, "{what}: off by {off:e}");
    assert!(count > least, "{layout}: {count}");
}

#[test]
fn derivatives_of_all_layouts_agree_with_differences_in_32_digits() {
    for layout in layouts() {
        hold(layout.name, layout.derivatives(&program), 300);
    }
}

#[test]
fn sensitivities_of_all_layouts_agree_with_differences_in_32_digits() {
    let seed = fastrand::u64(..);
    println!("seed {seed}");
    let random = &mut fastrand::Rng::with_seed(seed);
    for layout in layouts() {
        hold(layout.name, layout.sensitivities(random, &program), 100);
    }
}
