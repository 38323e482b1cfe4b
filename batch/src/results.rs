//! What comes out, as arrays: one number for each member.

use crate::batch::{Batch, seen, step};
use crate::law::Law;
use linkwright::lanes::{InScalars, OutputsIn, fields_in_lane};
use linkwright::{Fields, LaneMethod, LaneStepper, Lanes, Mechanism, Real, Vector};

/// Named columns with one number for each member; NaN for members that could not be prepared.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns<R = f64> {
    names: Vec<&'static str>,
    /// Column by column.
    values: Vec<R>,
    members: usize,
}

impl<R: Real> Columns<R> {
    /// The names of the columns, in order.
    pub fn names(&self) -> &[&'static str] {
        &self.names
    }

    /// How many members there are.
    pub fn members(&self) -> usize {
        self.members
    }

    /// One number for each member.
    pub fn column(&self, name: &str) -> Option<&[R]> {
        let index = self.names.iter().position(|own| *own == name)?;
        self.values.get(index * self.members..(index + 1) * self.members)
    }
}

/// Outputs of all members at several times.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording<R = f64> {
    /// The steps after which it was recorded, zero for the beginning.
    pub steps: Vec<usize>,
    /// What was recorded then.
    pub samples: Vec<Columns<R>>,
}

impl<M: InScalars, S: LaneMethod<M, L>, L: Lanes> Batch<M, S, L> {
    /// The positions of all members, by the names of the entries of q.
    pub fn positions(&self) -> Columns<L::Scalar> {
        let names = self.names(|model| model.position_names());
        self.columns(names, |group, index| at(group.states().q.as_slice(), index))
    }

    /// The velocities of all members, by the names of the entries of v.
    pub fn velocities(&self) -> Columns<L::Scalar> {
        let names = self.names(|model| model.velocity_names());
        self.columns(names, |group, index| at(group.states().v.as_slice(), index))
    }

    /// The internal states of all members, by their names.
    pub fn internal_states(&self) -> Columns<L::Scalar> {
        let names = self.names(|model| model.internal_names());
        self.columns(names, |group, index| at(group.states().z.as_slice(), index))
    }

    /// The outputs of all members at their present states, by their names.
    pub fn outputs(&self, law: &impl Law<M, L>) -> Columns<L::Scalar> {
        let names = self.names(|model| model.output_names());
        let groups = self.groups().iter().enumerate();
        let rows: Vec<_> =
            groups.map(|(index, group)| row(group, law, (index * L::LANES, self.len()))).collect();
        let value = |member: usize, index: usize| {
            let row = &rows[member / L::LANES];
            at(row.as_slice(), index).lane(member % L::LANES)
        };
        self.gathered(names, value)
    }

    fn names(&self, of: impl Fn(&M::In<L>) -> &[&'static str]) -> Vec<&'static str> {
        self.groups().first().map(|group| of(group.models()).to_vec()).unwrap_or_default()
    }

    fn columns(
        &self,
        names: Vec<&'static str>,
        value: impl Fn(&LaneStepper<M, S, L>, usize) -> L,
    ) -> Columns<L::Scalar> {
        let groups = self.groups();
        self.gathered(names, |member, index| value(&groups[member / L::LANES], index).lane(member % L::LANES))
    }

    fn gathered(
        &self,
        names: Vec<&'static str>,
        value: impl Fn(usize, usize) -> L::Scalar,
    ) -> Columns<L::Scalar> {
        let members = self.len();
        let prepared: Vec<bool> = (0..members).map(|member| self.is_prepared(member)).collect();
        let none = <L::Scalar as Real>::from_f64(f64::NAN);
        let of = |index: usize| {
            let (value, prepared) = (&value, &prepared);
            (0..members).map(move |member| if prepared[member] { value(member, index) } else { none })
        };
        Columns { values: (0..names.len()).flat_map(of).collect(), names, members }
    }
}

impl<M: InScalars, S: LaneMethod<M, L>, L: Lanes> Batch<M, S, L> {
    /// So many steps of `h` seconds, with the outputs at the beginning and after every `every` steps; zero records the
    /// beginning alone.
    pub fn record(
        &mut self,
        law: &impl Law<M, L>,
        h: L::Scalar,
        steps: usize,
        every: usize,
    ) -> Recording<L::Scalar> {
        let sampled = |done: usize| every > 0 && done.is_multiple_of(every);
        let names = self.names(|model| model.output_names());
        let rows = self.each_group(|first, len, group| {
            let place = (first, len);
            let mut rows = vec![row(group, law, place)];
            for done in 1..=steps {
                step(group, law, place, h);
                if sampled(done) {
                    rows.push(row(group, law, place));
                }
            }
            rows
        });
        let steps: Vec<usize> = std::iter::once(0).chain((1..=steps).filter(|&done| sampled(done))).collect();
        let samples = (0..steps.len()).map(|sample| {
            self.gathered(names.clone(), |member, index| {
                let row = &rows[member / L::LANES][sample];
                at(row.as_slice(), index).lane(member % L::LANES)
            })
        });
        Recording { samples: samples.collect(), steps }
    }

    /// So many steps of `h` seconds, with a value of each member that is changed by its outputs after each: the largest of them, a
    /// sum, a count. The member's index comes first.
    pub fn fold<A: Clone + Send + Sync>(
        &mut self,
        law: &impl Law<M, L>,
        h: L::Scalar,
        steps: usize,
        begin: A,
        change: impl Fn(usize, &mut A, &OutputsIn<M, L::Scalar>) + Sync,
    ) -> Vec<A> {
        let members = self.len();
        let groups = self.each_group(|first, len, group| {
            let place = (first, len);
            let mut values = vec![begin.clone(); L::LANES.min(len - first)];
            for _ in 0..steps {
                step(group, law, place, h);
                let inputs = law.inputs(&seen(group, place));
                let outputs = group.outputs(&inputs);
                for (lane, value) in values.iter_mut().enumerate() {
                    if group.is_moving(lane) {
                        let outputs = fields_in_lane::<L, _, OutputsIn<M, L::Scalar>>(&outputs, lane);
                        change(first + lane, value, &outputs);
                    }
                }
            }
            values
        });
        let values: Vec<A> = groups.into_iter().flatten().collect();
        debug_assert_eq!(values.len(), members);
        values
    }
}

/// The outputs of a group, in lanes.
fn row<M: InScalars, S: LaneMethod<M, L>, L: Lanes>(
    group: &LaneStepper<M, S, L>,
    law: &impl Law<M, L>,
    place: (usize, usize),
) -> <OutputsIn<M, L> as Fields<L>>::Array {
    group.outputs(&law.inputs(&seen(group, place))).to_array()
}

/// The entry of this index; there is one for each name.
fn at<R: Real>(entries: &[R], index: usize) -> R {
    entries.get(index).copied().unwrap_or(R::ZERO)
}
