//! Numbers as the text of a `.flex` file, which reads back to the same numbers.

use super::Reduced;

impl Reduced {
    /// Modes are numbered anew from 1. `about` are lines of comments.
    pub fn text(&self, about: &str) -> String {
        let mut text: String = about.lines().map(|line| format!("# {line}\n")).collect();
        let [x, y, z] = self.inertia;
        let modes = self.modes();
        let axis = |of: &[[f64; 3]]| [0, 1, 2].map(|axis| of.iter().map(|it| it[axis]).collect::<Vec<_>>());
        text.push_str("flex 1\n");
        text.push_str(&format!("mass    {}\n", row(&[self.mass])));
        text.push_str(&format!("center  {}\n", row(&self.center)));
        text.push_str("# xx yy zz xy xz yz about the origin\n");
        text.push_str(&format!("inertia {}\n", row(&[x[0], y[1], z[2], x[1], x[2], y[2]])));
        text.push_str(&format!("modes   {modes}\n"));
        text.push_str(&section("momentum", &axis(&self.momentum)));
        text.push_str(&section("angular_momentum", &axis(&self.angular_momentum)));
        text.push_str(&section("moments", &self.moments));
        text.push_str(&section("generalised_mass", &self.generalised_mass));
        text.push_str(&section("stiffness", &self.stiffness));
        for node in &self.nodes {
            let head = format!("node {} {}", node.number, row(&node.at));
            let rows: Vec<Vec<f64>> = axis(&node.shifts).into_iter().chain(axis(&node.turns)).collect();
            text.push_str(&section(&head, &rows));
        }
        text
    }
}

fn section<R: AsRef<[f64]>>(head: &str, rows: &[R]) -> String {
    let rows: String = rows.iter().map(|values| format!("  {}\n", row(values.as_ref()))).collect();
    format!("{head}\n{rows}")
}

fn row(values: &[f64]) -> String {
    // No −0.
    let number = |value: &f64| if *value == 0.0 { "0".to_string() } else { format!("{value:?}") };
    values.iter().map(number).collect::<Vec<_>>().join(" ")
}
