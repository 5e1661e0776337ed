use super::*;

/// The numbers of an attribute in the tags of an SVG that begin so.
fn numbers(svg: &str, tag: &str, attribute: &str) -> Vec<f64> {
    let tags = svg
        .split(tag)
        .skip(1)
        .filter_map(|rest| rest.split('>').next());
    let values = tags.filter_map(|tag| {
        tag.split_once(&format!(" {attribute}=\""))?
            .1
            .split('"')
            .next()
    });
    values
        .map(|value| value.parse().expect("a number"))
        .collect()
}

/// The lowest edge of the legend, which is no more opaque than 0.85.
fn legend_bottom(svg: &str) -> f64 {
    let legend = svg
        .split("<rect")
        .find(|rest| rest.contains("opacity=\"0.85\""));
    let legend = format!("<rect{}", legend.expect("a legend"));
    numbers(&legend, "<rect", "y")[0] + numbers(&legend, "<rect", "height")[0]
}

#[test]
fn the_legend_stands_clear_of_points() {
    for size in [(480, 330), SIZE] {
        for count in 1..6 {
            let curve = |name: usize| Curve {
                name: format!("curve {name}"),
                line: vec![(0.0, 1.0), (1.0, 0.0)],
                marks: vec![(0.0, 1.0)],
                ..Curve::default()
            };
            let chart = Chart {
                title: "Curves".to_owned(),
                across: "across (m)".to_owned(),
                quantity: "up (m)".to_owned(),
                curves: (0..count).map(curve).collect(),
            };
            let svg = chart.svg_of(size).expect("a plot");
            let [marks, radii] = ["cy", "r"].map(|name| numbers(&svg, "<circle", name));
            assert_eq!(marks.len(), count);
            let top = marks[0] - radii[0];
            let off = (top - legend_bottom(&svg)) / f64::from(FINE);
            assert!(
                (0.0..20.0).contains(&off),
                "{size:?}, {count} curves: {off}"
            );
        }
    }
}
