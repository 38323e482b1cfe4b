//! Calls of tables in expressions: how many arguments, what they measure, and how smooth a table has to be where it stands.

use super::{LookUp, Table};
use crate::diagnostics::Region;
use crate::messages;
use crate::model::lower::{Lowering, Use};
use crate::model::unused::Scope;
use crate::model::values::Typed;
use crate::model::{Expr, Kink, fold};
use crate::symbolic::Orders;
use crate::syntax::{Label, Path, Term};

impl Lowering<'_> {
    /// The table that a name before parentheses means, and whether its slope is meant.
    pub fn table_of_call(&self, name: &str) -> Option<(usize, bool)> {
        let by_name = |name: &str| self.names.table(name);
        by_name(name).map(|index| (index, false)).or_else(|| {
            let owner = name.strip_suffix(".slope")?;
            by_name(owner).map(|index| (index, true))
        })
    }

    /// `lift(x)`, `lift.slope(x)`, `grip(x, y)`.
    pub fn call_of_table(
        &mut self,
        function: &Label,
        (index, steep): (usize, bool),
        arguments: &[Term],
        region: Region,
        usage: Use,
    ) -> Option<Typed> {
        self.used.insert((Scope::Table, &self.definition.tables[index].name.text));
        let Some(table) = self.tables.get(index) else {
            // They are made of constants.
            self.diagnostics.error(region, messages::table_in_constant(&function.text));
            return None;
        };
        let Table { arguments: axes, value, kind, curve, .. } = table.as_ref()?;
        let (axes, value, kind, curve) = (axes.clone(), value.dimension, *kind, curve.clone());
        let count = axes.len();
        if steep && count != 1 {
            self.diagnostics.error(region, messages::slope_of_grid(curve.name()));
            return None;
        }
        if arguments.len() != count {
            let message = messages::arguments(&function.text, &[count], arguments.len());
            self.diagnostics.error(region, message);
            return None;
        }
        let mut found = Vec::new();
        for (term, axis) in arguments.iter().zip(&axes) {
            let what = messages::argument_of_table(&axis.name, &function.text);
            let typed = self.value(term, usage);
            found.push(typed.and_then(|typed| self.expect_dimension(typed, axis.dimension, &what)));
        }
        let arguments: Vec<Expr> = found.into_iter().collect::<Option<_>>()?;
        let dimension = if steep { value.over(axes[0].dimension) } else { value };
        let smoothness = kind.smoothness().saturating_sub(usize::from(steep));
        let orders = Orders::new(u8::from(steep), 0);
        let expr = fold::table(LookUp { curve, orders, smoothness, arguments });
        if usage.accelerates {
            self.is_smooth(&expr, &function.text, region, usage)?;
        }
        let expr = self.finite(expr, region)?;
        Some(Typed { expr, dimension, zero: false, region })
    }

    /// What a constraint or a driver is made of has accelerations; those of a signal stand where the signal is named.
    pub fn smooth_contents(&mut self, expr: &Expr, path: &Path, usage: Use) -> Option<()> {
        if usage.accelerates { self.is_smooth(expr, &path.text, path.region, usage) } else { Some(()) }
    }

    /// An error where a slope would jump, a warning where accelerations do.
    fn is_smooth(&mut self, expr: &Expr, text: &str, region: Region, usage: Use) -> Option<()> {
        let mut least: Option<(usize, String)> = None;
        expr.visit(&mut |part| {
            if let Expr::Table(table) = part
                && table.arguments.iter().any(Expr::moves)
                && least.as_ref().is_none_or(|(smoothness, _)| table.smoothness < *smoothness)
            {
                least = Some((table.smoothness, table.curve.name().to_string()));
            }
        });
        match least {
            Some((0, name)) => {
                self.diagnostics.error(region, messages::table_with_corners(&name, text, usage.what));
                None
            }
            Some((1, name)) => {
                self.kinks.push(Kink { table: name, region });
                Some(())
            }
            _ => Some(()),
        }
    }
}
