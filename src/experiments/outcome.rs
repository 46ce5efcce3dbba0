//! What was computed, scene by scene, and what scenes refer to.

use std::cmp::Ordering;

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::experiments::SceneOutcome;
use crate::experiments::certificates::Stored;
use crate::experiments::swept::Swept;
use crate::fitting::StepRecord;
use slipmode_core::friction::Slider;
use slipmode_core::number::Rational;

impl SceneOutcome {
    /// The slider, where the scene states one.
    pub(crate) fn slider(&self) -> Option<&Slider<Rational>> {
        self.scene.parameters.as_ref().map(|section| &section.slider)
    }

    /// Whether friction of its slider falls or rises with velocity, in the words of tables.
    pub(crate) fn slider_words(&self) -> Option<&'static str> {
        let slider = self.slider()?;
        Some(match slider.direct_effect.cmp(&slider.evolution_effect) {
            Ordering::Less => "a < b",
            Ordering::Equal => "a = b",
            Ordering::Greater => "a > b",
        })
    }
}

/// The outcomes of a report's scenes, in the report's order.
#[derive(Debug, Clone, Default)]
pub struct Outcome {
    /// One per scene.
    pub scenes: Vec<SceneOutcome>,
}

impl Outcome {
    /// What was computed of one kind, with the name of its scene.
    pub fn each<'o, T: 'o>(
        &'o self,
        of: impl Fn(&'o SceneOutcome) -> &'o Option<T>,
    ) -> impl Iterator<Item = (&'o str, &'o T)> {
        self.scenes.iter().filter_map(move |scene| Some((scene.scene.name.as_str(), of(scene).as_ref()?)))
    }

    /// The first scene with a < b: the potentially unstable slider of the paper.
    pub(crate) fn potentially_unstable(&self) -> Option<&SceneOutcome> {
        self.first_with(|p| p.evolution_effect > p.direct_effect)
    }

    /// The first scene with a > b: the intrinsically stable slider of the paper.
    pub(crate) fn intrinsically_stable(&self) -> Option<&SceneOutcome> {
        self.first_with(|p| p.evolution_effect < p.direct_effect)
    }

    /// The first scene whose a is not below its b: the slider that no velocity makes unstable.
    pub(crate) fn never_unstable(&self) -> Option<&SceneOutcome> {
        self.first_with(|p| p.evolution_effect <= p.direct_effect)
    }

    fn first_with(&self, wanted: impl Fn(&Slider<Rational>) -> bool) -> Option<&SceneOutcome> {
        self.scenes.iter().find(|scene| scene.slider().is_some_and(&wanted))
    }
}

/// What scenes refer to by file name and `cli` has read: nothing here opens a file.
#[derive(Debug, Clone, Default)]
pub struct References {
    /// Sweeps by name.
    pub swept: BTreeMap<String, Swept>,
    /// Certificates by the name of their file.
    pub certificates: BTreeMap<String, Vec<Stored>>,
    /// Records of velocity steps by the name of their file.
    pub records: BTreeMap<String, Arc<StepRecord>>,
}
