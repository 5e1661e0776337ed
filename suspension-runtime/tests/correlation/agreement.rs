//! Differences from published numbers, beside their gates.

/// The worst difference of each quantity.
#[derive(Default)]
pub(crate) struct Agreement(Vec<Quantity>);

struct Quantity {
    name: String,
    gate: f64,
    worst: f64,
    count: usize,
}

impl Agreement {
    /// Takes a difference into account.
    pub(crate) fn note(&mut self, name: &str, gate: f64, difference: f64) {
        let found = self.0.iter().position(|quantity| quantity.name == name);
        let place = found.unwrap_or_else(|| {
            self.0.push(Quantity {
                name: name.to_owned(),
                gate,
                worst: 0.0,
                count: 0,
            });
            self.0.len() - 1
        });
        let quantity = &mut self.0[place];
        // A NaN counts as the largest difference.
        let difference = if difference.is_nan() {
            f64::INFINITY
        } else {
            difference.abs()
        };
        quantity.worst = quantity.worst.max(difference);
        quantity.count += 1;
    }

    /// That every quantity was compared as often as there are numbers, and that no difference exceeds its gate.
    pub(crate) fn holds(&self, source: &str, numbers: usize) {
        let row = |quantity: &Quantity| {
            let Quantity {
                name,
                gate,
                worst,
                count,
            } = quantity;
            let verdict = if worst <= gate { "" } else { " EXCEEDED" };
            format!("{source}: {name}: {worst:.2e} of {gate:.1e}, {count} numbers{verdict}\n")
        };
        let table: String = self.0.iter().map(row).collect();
        println!("{table}");
        assert!(!table.contains("EXCEEDED"), "\n{table}");
        let compared: usize = self.0.iter().map(|quantity| quantity.count).sum();
        assert_eq!(compared, numbers, "numbers compared\n{table}");
    }
}
