suspension_core::linkage! {
    mod m in "file_with_mistakes.linkage";
}

fn main() {
    let points = m::Points::<f64>::default();
    println!("{} {}", points.a, points.p);
}
