//! The members of a batch, and how they are moved.

use crate::failure::{BatchError, Failure};
use crate::law::{Group, Law};
use linkwright::lanes::{InScalars, ParametersIn, StateIn};
use linkwright::{AssembleExt, LaneMethod, LaneStepper, Lanes, Parametric};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};

/// As many numbers in double precision as a register of the processor holds that the program is compiled for.
#[cfg(target_feature = "avx512f")]
pub type Widest = linkwright::F64x8;
/// As many numbers in double precision as a register of the processor holds that the program is compiled for.
#[cfg(not(target_feature = "avx512f"))]
pub type Widest = linkwright::F64x4;

/// Mechanisms of the definition `M` that are moved together by the method `S`, in the lanes of `L`.
#[derive(Clone, Debug)]
pub struct Batch<M: InScalars, S: LaneMethod<M, L>, L: Lanes = Widest> {
    groups: Vec<LaneStepper<M, S, L>>,
    len: usize,
    /// Members that could not be prepared.
    unprepared: BTreeMap<usize, Failure>,
}

/// What happened in a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Summary {
    /// Steps of single members.
    pub steps: u64,
    /// Those of them that a member had to take alone, at singular positions for example.
    pub alone: u64,
    /// Members that failed in this run.
    pub failed: usize,
}

impl Summary {
    fn and(self, other: Summary) -> Summary {
        let Summary { steps, alone, failed } = other;
        Summary { steps: self.steps + steps, alone: self.alone + alone, failed: self.failed + failed }
    }
}

impl<M: InScalars, S: LaneMethod<M, L>, L: Lanes> Batch<M, S, L> {
    /// So many members alike, at time zero.
    ///
    /// # Errors
    /// [`BatchError::Empty`].
    pub fn alike(
        count: usize,
        model: &M::In<L::Scalar>,
        start: &StateIn<M, L::Scalar>,
        method: S,
    ) -> Result<Self, BatchError> {
        if count == 0 {
            return Err(BatchError::Empty);
        }
        let group = LaneStepper::new(model, start, method);
        let mut batch =
            Batch { groups: vec![group; count.div_ceil(L::LANES)], len: count, unprepared: BTreeMap::new() };
        batch.empty_the_rest();
        Ok(batch)
    }

    /// So many members at time zero, each with parameters of its own, assembled near the start of the definition. Members that cannot be
    /// prepared or assembled do not move, and are among the [`failures`](Batch::failures).
    ///
    /// # Errors
    /// [`BatchError::Empty`]; [`BatchError::NoMember`] if no member can.
    pub fn prepare(
        count: usize,
        method: S,
        parameters: impl Fn(usize) -> ParametersIn<M, L::Scalar> + Sync,
    ) -> Result<Self, BatchError> {
        Self::build(count, method, |member| {
            let model = <M::In<L::Scalar> as Parametric<L::Scalar>>::prepare(parameters(member))?;
            let start = model.assemble(&model.start())?;
            Ok((model, start))
        })
    }

    /// So many members at time zero, each with the model and state that this function gives. Members for which it gives none do not
    /// move, and are among the [`failures`](Batch::failures). Members are asked for side by side.
    ///
    /// # Errors
    /// [`BatchError::Empty`]; [`BatchError::NoMember`] if there is none for any member.
    pub fn build(
        count: usize,
        method: S,
        member: impl Fn(usize) -> Result<(M::In<L::Scalar>, StateIn<M, L::Scalar>), Failure> + Sync,
    ) -> Result<Self, BatchError> {
        let found: Vec<_> = (0..count).into_par_iter().map(&member).collect();
        let Some(first) = found.iter().find_map(|found| found.as_ref().ok()) else {
            let failure = found.into_iter().find_map(Result::err);
            return Err(failure.map_or(BatchError::Empty, BatchError::NoMember));
        };
        let mut batch = Self::alike(count, &first.0, &first.1, method)?;
        for (index, found) in found.iter().enumerate() {
            let (group, lane) = (index / L::LANES, index % L::LANES);
            let placed = match found {
                Ok((model, state)) => {
                    let zero = <L::Scalar as linkwright::Real>::ZERO;
                    batch.groups[group].set(lane, model, zero, state).map_err(Failure::Step)
                }
                Err(failure) => Err(*failure),
            };
            if let Err(failure) = placed {
                batch.groups[group].stop(lane);
                batch.unprepared.insert(index, failure);
            }
        }
        Ok(batch)
    }

    fn empty_the_rest(&mut self) {
        if let Some(last) = self.groups.last_mut() {
            let used = (self.len - 1) % L::LANES + 1;
            (used..L::LANES).for_each(|lane| last.stop(lane));
        }
    }

    /// How many members there are.
    #[allow(clippy::len_without_is_empty)] // It has at least one.
    pub fn len(&self) -> usize {
        self.len
    }

    /// The members that do not move, and why, in order.
    pub fn failures(&self) -> impl Iterator<Item = (usize, Failure)> {
        (0..self.len).filter_map(|member| Some((member, self.failure(member)?)))
    }

    /// Why a member does not move.
    pub fn failure(&self, member: usize) -> Option<Failure> {
        let unprepared = self.unprepared.get(&member).copied();
        let stopped = || self.groups.get(member / L::LANES)?.error(member % L::LANES).map(Failure::Step);
        unprepared.or_else(stopped)
    }

    /// The model of a member; of one that could not be prepared there is none.
    pub fn model(&self, member: usize) -> Option<M::In<L::Scalar>> {
        let group = self.group_of(member)?;
        Some(group.model(member % L::LANES))
    }

    /// The state of a member, of one that failed the last good one; of one that could not be prepared there is none.
    pub fn state(&self, member: usize) -> Option<StateIn<M, L::Scalar>> {
        let group = self.group_of(member)?;
        Some(group.state(member % L::LANES))
    }

    /// The time of a member, s; of one that could not be prepared there is none.
    pub fn time(&self, member: usize) -> Option<L::Scalar> {
        let group = self.group_of(member)?;
        Some(group.time(member % L::LANES))
    }

    fn group_of(&self, member: usize) -> Option<&LaneStepper<M, S, L>> {
        let exists = member < self.len && !self.unprepared.contains_key(&member);
        self.groups.get(member / L::LANES).filter(|_| exists)
    }

    pub(crate) fn is_prepared(&self, member: usize) -> bool {
        self.group_of(member).is_some()
    }

    pub(crate) fn groups(&self) -> &[LaneStepper<M, S, L>] {
        &self.groups
    }

    /// Another mechanism or state for a member, such as its start once more. It moves, also where it had failed.
    ///
    /// # Errors
    /// [`BatchError::OutOfRange`], and [`BatchError::Member`] for a state that makes no sense; nothing has changed then.
    pub fn set(
        &mut self,
        member: usize,
        model: &M::In<L::Scalar>,
        time: L::Scalar,
        state: &StateIn<M, L::Scalar>,
    ) -> Result<(), BatchError> {
        if member >= self.len {
            return Err(BatchError::OutOfRange { member, len: self.len });
        }
        let placed = self.groups[member / L::LANES].set(member % L::LANES, model, time, state);
        placed.map_err(|error| BatchError::Member { member, failure: Failure::Step(error) })?;
        self.unprepared.remove(&member);
        Ok(())
    }
}

impl<M: InScalars, S: LaneMethod<M, L>, L: Lanes> Batch<M, S, L> {
    /// One step of `h` seconds of all members.
    pub fn step(&mut self, law: &impl Law<M, L>, h: L::Scalar) -> Summary {
        self.run(law, h, 1)
    }

    /// So many steps of `h` seconds of all members. Each thread takes one group after the other through all of them.
    pub fn run(&mut self, law: &impl Law<M, L>, h: L::Scalar, steps: usize) -> Summary {
        self.run_with_progress(law, h, steps, |_| ())
    }

    /// As [`run`](Batch::run); `progress` is told which part is done, from 0 to 1, by any thread.
    pub fn run_with_progress(
        &mut self,
        law: &impl Law<M, L>,
        h: L::Scalar,
        steps: usize,
        progress: impl Fn(f64) + Sync,
    ) -> Summary {
        let (count, done) = (self.groups.len(), AtomicUsize::new(0));
        self.each_group(|first, len, group| {
            let mut summary = Summary::default();
            for _ in 0..steps {
                summary = summary.and(step(group, law, (first, len), h));
            }
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            progress(done as f64 / count as f64);
            summary
        })
        .into_iter()
        .fold(Summary::default(), Summary::and)
    }

    /// The result of this function of every group, side by side: of the index of its first member, of the number of members of the
    /// batch, and of the group.
    pub(crate) fn each_group<T: Send>(
        &mut self,
        f: impl Fn(usize, usize, &mut LaneStepper<M, S, L>) -> T + Sync,
    ) -> Vec<T> {
        let len = self.len;
        let groups = self.groups.par_iter_mut().enumerate();
        groups.map(|(index, group)| f(index * L::LANES, len, group)).collect()
    }
}

/// The group as laws see it.
pub(crate) fn seen<M: InScalars, S: LaneMethod<M, L>, L: Lanes>(
    group: &LaneStepper<M, S, L>,
    (first, len): (usize, usize),
) -> Group<'_, M, L> {
    Group { first, len, models: group.models(), times: group.times(), states: group.states() }
}

#[inline]
pub(crate) fn step<M: InScalars, S: LaneMethod<M, L>, L: Lanes>(
    group: &mut LaneStepper<M, S, L>,
    law: &impl Law<M, L>,
    place: (usize, usize),
    h: L::Scalar,
) -> Summary {
    let moving = group.moving();
    if moving == 0 {
        return Summary::default();
    }
    let inputs = law.inputs(&seen(group, place));
    let ticks = group.step(&inputs, L::splat(h));
    let failed = ticks.failed().count();
    Summary { steps: (moving - failed) as u64, alone: (ticks.alone().count() - failed) as u64, failed }
}
