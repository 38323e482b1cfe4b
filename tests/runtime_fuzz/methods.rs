//! Formulations and integrators chosen at run time, so that each model is compiled once for all of them.

use crate::random::Random;
use linkwright::{
    Ali3p, Assemble, AssemblyError, AugmentedLagrangian, Baumgarte, DormandPrince, Dynamics, Evaluation,
    ExplicitTrapezoidal, Formulation, GeneralisedAlpha, ImplicitDynamics, ImplicitTrapezoidal, Integrator,
    LagrangeIndex1, Method, NullSpace, Partitioned, Penalty, PivotOf, Projected, Rk4, SemiImplicitEuler,
    SettingError, Settled, StateOf, StepFailure, SteppedOf, Variables, partition::PartitionOf,
};

/// A formulation; what its pivot is of goes with the type, so there are as many types as values of it.
#[derive(Clone, Copy, Debug)]
pub enum Way {
    Index1(LagrangeIndex1),
    Baumgarte(Baumgarte),
    Partitioned(Partitioned),
    ProjectedIndex1(Projected<LagrangeIndex1>),
    ProjectedBaumgarte(Projected<Baumgarte>),
    Penalty(Penalty),
    Augmented(AugmentedLagrangian),
    ProjectedPenalty(Projected<Penalty>),
    NullSpace(NullSpace),
    ProjectedNullSpace(Projected<NullSpace>),
}

/// A way whose pivot is one of rows (0), of velocities (1), of D (2).
#[derive(Clone, Copy, Debug)]
pub struct Of<const PIVOT: u8>(pub Way);

#[allow(dead_code)]
impl Way {
    pub fn any(random: &mut Random) -> Self {
        let baumgarte = Baumgarte { alpha: random.near(10.0), beta: random.near(10.0) };
        let penalty = Penalty { alpha: random.near(1e9), omega: random.near(10.0), mu: random.near(1.0) };
        let (tolerance, iterations) = (random.near(1e-13), random.below(12) as u32);
        let augmented = AugmentedLagrangian { penalty, tolerance, iterations };
        match random.below(10) {
            0 => Way::Index1(LagrangeIndex1),
            1 => Way::Baumgarte(baumgarte),
            2 => Way::Partitioned(Partitioned { tolerance, iterations }),
            3 => Way::ProjectedIndex1(Projected {
                weight: random.near(1e10),
                ..Projected::after(LagrangeIndex1)
            }),
            4 => Way::ProjectedBaumgarte(Projected { tolerance, iterations, ..Projected::after(baumgarte) }),
            5 => Way::Penalty(penalty),
            6 => Way::Augmented(augmented),
            7 => Way::ProjectedPenalty(Projected::after(penalty)),
            8 => Way::NullSpace(NullSpace),
            _ => Way::ProjectedNullSpace(Projected::after(NullSpace)),
        }
    }

    pub fn pivot(&self) -> u8 {
        match self {
            Way::Penalty(_) | Way::Augmented(_) | Way::ProjectedPenalty(_) => 1,
            Way::NullSpace(_) | Way::ProjectedNullSpace(_) => 2,
            _ => 0,
        }
    }
}

/// The same expression with the formulation and what of the memory is its.
macro_rules! each {
    ($way:expr, $memory:ident, ($formulation:ident, $own:ident) => $call:expr) => {
        match $way {
            Way::Index1($formulation) => {
                let $own = &mut ();
                $call
            }
            Way::Baumgarte($formulation) => {
                let $own = &mut ();
                $call
            }
            Way::Partitioned($formulation) => {
                let $own = &mut $memory.1;
                $call
            }
            Way::ProjectedIndex1($formulation) => {
                let $own = &mut ();
                $call
            }
            Way::ProjectedBaumgarte($formulation) => {
                let $own = &mut ();
                $call
            }
            Way::Penalty($formulation) => {
                let $own = &mut ();
                $call
            }
            Way::Augmented($formulation) => {
                let $own = &mut $memory.0;
                $call
            }
            Way::ProjectedPenalty($formulation) => {
                let $own = &mut ();
                $call
            }
            Way::NullSpace($formulation) => {
                let $own = &mut $memory.1;
                $call
            }
            Way::ProjectedNullSpace($formulation) => {
                let $own = &mut $memory.1;
                $call
            }
        }
    };
}

impl<M: Assemble<f64>, const PIVOT_OF: u8> Formulation<f64, M> for Of<PIVOT_OF> {
    type Memory = (M::Lambda, PartitionOf<f64, M>);

    fn pivot_of(_model: &M) -> PivotOf {
        match PIVOT_OF {
            0 => PivotOf::Rows,
            1 => PivotOf::Velocities,
            _ => PivotOf::Jacobian,
        }
    }

    fn memory(&self, model: &M) -> Self::Memory {
        (model.zero_lambda(), linkwright::partition::Partition::new(model))
    }

    fn acceleration(
        &self,
        memory: &mut Self::Memory,
        model: &M,
        time: f64,
        state: &mut StateOf<M>,
        u: &M::Inputs,
        a: &mut M::V,
        lambda: &mut M::Lambda,
    ) -> Evaluation<f64> {
        each!(&self.0, memory, (way, own) => way.acceleration(own, model, time, state, u, a, lambda))
    }

    fn settle(
        &self,
        memory: &mut Self::Memory,
        model: &M,
        time: f64,
        state: &mut StateOf<M>,
    ) -> Result<Settled<f64>, AssemblyError> {
        each!(&self.0, memory, (way, own) => way.settle(own, model, time, state))
    }

    fn check(&self) -> Result<(), SettingError> {
        match &self.0 {
            Way::Index1(way) => Formulation::<f64, M>::check(way),
            Way::Baumgarte(way) => Formulation::<f64, M>::check(way),
            Way::Partitioned(way) => Formulation::<f64, M>::check(way),
            Way::ProjectedIndex1(way) => Formulation::<f64, M>::check(way),
            Way::ProjectedBaumgarte(way) => Formulation::<f64, M>::check(way),
            Way::Penalty(way) => Formulation::<f64, M>::check(way),
            Way::Augmented(way) => Formulation::<f64, M>::check(way),
            Way::ProjectedPenalty(way) => Formulation::<f64, M>::check(way),
            Way::NullSpace(way) => Formulation::<f64, M>::check(way),
            Way::ProjectedNullSpace(way) => Formulation::<f64, M>::check(way),
        }
    }
}

/// An integrator.
#[derive(Clone, Copy, Debug)]
pub enum Means {
    Rk4,
    SemiImplicitEuler,
    ExplicitTrapezoidal,
    DormandPrince(DormandPrince),
    GeneralisedAlpha(GeneralisedAlpha),
    ImplicitTrapezoidal(ImplicitTrapezoidal),
    Ali3p(Ali3p),
}

/// Steps of its own choice that a run may have.
const MOST: u64 = 100;

/// One that is explicit, for mechanisms that emit no derivatives.
#[derive(Clone, Copy, Debug)]
#[allow(dead_code)]
pub struct Explicit(pub Means);

#[allow(dead_code)]
impl Means {
    pub fn adaptive(tolerance: f64) -> Self {
        Means::DormandPrince(DormandPrince::tolerance(tolerance))
    }

    pub fn any(random: &mut Random) -> Self {
        match random.below(7) {
            0 => Means::Rk4,
            1 => Means::SemiImplicitEuler,
            2 => Means::ExplicitTrapezoidal,
            3 => Means::DormandPrince(DormandPrince::tolerance(random.near(1e-6)).most_steps(MOST)),
            4 => Means::GeneralisedAlpha(GeneralisedAlpha::new(random.near(0.8))),
            5 => Means::ImplicitTrapezoidal(ImplicitTrapezoidal::default()),
            _ => Means::Ali3p(Ali3p::new(random.near(1e5))),
        }
    }
}

/// What the integrators carry: one of Dormand and Prince, one of the implicit ones.
/// What a method carries from step to step.
type MemoryOf<I, X> = <I as Method<f64>>::Memory<X>;

impl Method<f64> for Means {
    type Memory<X: Variables<f64>> = (MemoryOf<DormandPrince, X>, MemoryOf<ImplicitTrapezoidal, X>);

    fn memory<X: Variables<f64>>(&self) -> Self::Memory<X> {
        let carried = ImplicitTrapezoidal::default().memory::<X>();
        (DormandPrince::tolerance(1e-6).memory::<X>(), carried)
    }

    fn most_steps(&self) -> u64 {
        match self {
            Means::DormandPrince(means) => Method::<f64>::most_steps(means),
            _ => u64::MAX,
        }
    }

    fn check(&self) -> Result<(), SettingError> {
        match self {
            Means::DormandPrince(means) => means.check(),
            Means::GeneralisedAlpha(means) => means.check(),
            Means::ImplicitTrapezoidal(means) => means.check(),
            Means::Ali3p(means) => means.check(),
            _ => Ok(()),
        }
    }
}

impl<D: ImplicitDynamics<f64> + Dynamics<f64>> Integrator<f64, D> for Means {
    fn step(
        &self,
        memory: &mut Self::Memory<D::Variables>,
        dynamics: &mut D,
        time: f64,
        h: f64,
        state: &StateOf<D::Variables>,
    ) -> Result<SteppedOf<D::Variables>, StepFailure<f64>> {
        match self {
            Means::Rk4 => Rk4.step(&mut (), dynamics, time, h, state),
            Means::SemiImplicitEuler => SemiImplicitEuler.step(&mut (), dynamics, time, h, state),
            Means::ExplicitTrapezoidal => ExplicitTrapezoidal.step(&mut (), dynamics, time, h, state),
            Means::DormandPrince(means) => means.step(&mut memory.0, dynamics, time, h, state),
            Means::GeneralisedAlpha(means) => means.step(&mut memory.1, dynamics, time, h, state),
            Means::ImplicitTrapezoidal(means) => means.step(&mut memory.1, dynamics, time, h, state),
            Means::Ali3p(means) => means.step(&mut memory.1, dynamics, time, h, state),
        }
    }
}

impl Method<f64> for Explicit {
    type Memory<X: Variables<f64>> = MemoryOf<DormandPrince, X>;

    fn memory<X: Variables<f64>>(&self) -> Self::Memory<X> {
        DormandPrince::tolerance(1e-6).memory::<X>()
    }

    fn check(&self) -> Result<(), SettingError> {
        self.0.check()
    }
}

impl<D: Dynamics<f64>> Integrator<f64, D> for Explicit {
    fn step(
        &self,
        memory: &mut Self::Memory<D::Variables>,
        dynamics: &mut D,
        time: f64,
        h: f64,
        state: &StateOf<D::Variables>,
    ) -> Result<SteppedOf<D::Variables>, StepFailure<f64>> {
        match self.0 {
            Means::SemiImplicitEuler => SemiImplicitEuler.step(&mut (), dynamics, time, h, state),
            Means::ExplicitTrapezoidal => ExplicitTrapezoidal.step(&mut (), dynamics, time, h, state),
            Means::DormandPrince(means) => means.step(memory, dynamics, time, h, state),
            // Implicit ones are not asked for.
            _ => Rk4.step(&mut (), dynamics, time, h, state),
        }
    }
}
