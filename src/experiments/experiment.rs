//! What an experiment is: a section of a scene, what is computed for it, and the tables and figures that show it.

use crate::experiments::{Drawer, References, SceneOutcome, TableMaker, Work};
use crate::scene::section::ReadSection;

/// A section that states a computation.
pub trait Experiment: ReadSection {
    /// What is computed.
    type Outcome;

    /// What a scene with this section has to state besides.
    const REQUIREMENT: Requirement = Requirement::Parameters;

    /// The tables that show it.
    const TABLES: &'static [&'static [TableMaker]] = &[];

    /// What draws the figures that show it.
    const FIGURES: &'static [&'static [Drawer]] = &[];

    /// What the section asks of the machine.
    fn work(&self) -> Work;

    /// Computes the outcome from what was computed for the scene before, in the order of the registry, and from the content of the files
    /// that scenes name; `None` when these lack what the section refers to.
    fn run(&self, earlier: &SceneOutcome, references: &References) -> Option<Self::Outcome>;
}

/// How the section of an experiment computes its outcome.
pub(crate) type RunOf<E> = fn(&E, &SceneOutcome, &References) -> Option<<E as Experiment>::Outcome>;

/// Declares an experiment: the keys of its section, as [`crate::scene::section::keys`] takes them, and how it implements [`Experiment`].
macro_rules! experiment {
    (
        $(#[$about:meta])* pub struct $name:ident { $($keys:tt)* }
        $(points: $points:expr,)?
        $(requires: $requirement:ident,)?
        outcome: $outcome:ty,
        $(tables: [$($tables:path),+],)?
        $(figures: [$($figures:path),+],)?
        work: $work:expr,
        run: $run:expr,
    ) => {
        $crate::scene::section::keys! {
            $(#[$about])* pub struct $name { $($keys)* }
            $(points: $points,)?
        }

        impl $crate::experiments::Experiment for $name {
            type Outcome = $outcome;
            $(const REQUIREMENT: $crate::experiments::Requirement = $crate::experiments::Requirement::$requirement;)?
            $(const TABLES: &'static [&'static [$crate::experiments::TableMaker]] = &[$($tables),+];)?
            $(const FIGURES: &'static [&'static [$crate::experiments::Drawer]] = &[$($figures),+];)?

            fn work(&self) -> $crate::experiments::Work {
                let work: fn(&Self) -> $crate::experiments::Work = $work;
                work(self)
            }

            fn run(
                &self,
                earlier: &$crate::experiments::SceneOutcome,
                references: &$crate::experiments::References,
            ) -> Option<Self::Outcome> {
                let run: $crate::experiments::RunOf<Self> = $run;
                run(self, earlier, references)
            }
        }
    };
}
pub(crate) use experiment;

/// What a scene has to state for a section to have a meaning.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Requirement {
    /// The section stands alone.
    Nothing,
    /// A slider in `[parameters]`.
    Parameters,
    /// A slider with σ and V0.
    OperatingPoint,
    /// A slider with b > a: no other has a critical normal stress.
    CriticalNormalStress,
}
