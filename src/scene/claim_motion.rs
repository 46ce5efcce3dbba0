//! `motion` beside a claim's words: a statement on every motion of a system, through a general lemma.

use slipmode_algebra::{Expression, Symbol};
use slipmode_theory::Equations;
use slipmode_theory::lyapunov_sign::LyapunovSign;
use slipmode_theory::planar::{MotionLemma, MotionWord};

use crate::scene::Problem;
use crate::scene::claim_formula::grammar::read_side;
use crate::scene::claim_names::Names;
use crate::scene::nearest;
use crate::scene::section::{Entry, Section};

/// The lemma that a steady state is unstable although no root has a positive real part.
const WEAK_INSTABILITY: &str = "weak-instability";

/// The lemma on the sign of the first Lyapunov coefficient.
const TRANSITION: &str = "transition";

/// A statement on the motions of a system, in the names of the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ClaimMotion {
    /// The system's name. What it is, the equations say when the claim is decided.
    pub name: String,
    /// The variables that move.
    pub state: Vec<Symbol>,
    /// What is said.
    pub said: MotionSaid,
}

/// What is said of a system.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum MotionSaid {
    /// Of every motion of two equations.
    Planar(MotionLemma),
    /// Three equations have a pair of roots ±i times this on the axis, and this is said of their steady state.
    Lyapunov(LyapunovSign, Expression),
}

impl ClaimMotion {
    /// Reads the section; `equations` define the system.
    pub(super) fn read(entry: &Entry<'_>, equations: &Equations) -> Option<Self> {
        let read = |section: &mut Section<'_>| {
            let planar = MotionWord::ALL.map(MotionWord::as_str).into_iter();
            let words: Vec<&'static str> = planar.chain([WEAK_INSTABILITY, TRANSITION]).collect();
            let word = section.required("lemma", &words.join(", "));
            let word = word.and_then(|entry| entry.word(&words, |word| word));
            let system = section.required("system", "the name of a [[system]]");
            let Some((word, system)) = word.zip(system) else {
                // Without the lemma it is not known which of these the section should have.
                let planar = MotionWord::ALL.iter().flat_map(|word| word.expressions());
                planar.chain(&["variable", "frequency", "sign"]).for_each(|key| _ = section.optional(key));
                return None;
            };
            read_said(section, word, &system, equations)
        };
        entry.table(read)?
    }

    /// The expressions of the lemma, each with its word.
    #[must_use]
    pub fn expressions(&self) -> Vec<(&'static str, &Expression)> {
        match &self.said {
            MotionSaid::Planar(lemma) => lemma.expressions(),
            MotionSaid::Lyapunov(LyapunovSign::Positive, frequency) => vec![("frequency", frequency)],
            MotionSaid::Lyapunov(LyapunovSign::Of(sign), frequency) => {
                vec![("frequency", frequency), ("sign", sign)]
            }
        }
    }

    /// What is said, in words; `set` sets an expression.
    #[must_use]
    pub fn words(&self, set: impl Fn(&Expression) -> String) -> String {
        let name = &self.name;
        let says = match &self.said {
            MotionSaid::Lyapunov(LyapunovSign::Positive, _) => {
                format!("the steady state of {name} is unstable although no root has a positive real part")
            }
            MotionSaid::Lyapunov(LyapunovSign::Of(_), _) => {
                format!(
                    "the transition of {name} is subcritical where the sign is positive and supercritical where it is negative"
                )
            }
            MotionSaid::Planar(lemma) => {
                let variable = self.state.get(lemma.variable).map(Symbol::as_str).unwrap_or_default();
                match lemma.word {
                    MotionWord::Periodic => format!("every motion of {name} is periodic"),
                    MotionWord::Attraction => format!("every motion of {name} approaches the steady state"),
                    MotionWord::Escape => format!(
                        "every motion of {name} off the steady state leaves every compact set, and {variable} is unbounded along it"
                    ),
                    MotionWord::Runaway => format!(
                        "{variable} becomes infinite in finite time from every start of {name} in the region"
                    ),
                    MotionWord::Deceleration => {
                        format!("{variable} falls for ever from every start of {name} in the region")
                    }
                    MotionWord::LateDeceleration => format!(
                        "{variable} falls from some time on for ever, and tends to zero, from every start of {name}"
                    ),
                }
            }
        };
        let with = |(word, expression): (&str, &Expression)| format!("{word} {}", set(expression));
        let with: Vec<String> = self.expressions().into_iter().map(with).collect();
        format!("{says} ({})", with.join(", "))
    }
}

/// The lemma with its system.
fn read_said(
    section: &mut Section<'_>,
    word: &str,
    entry: &Entry<'_>,
    equations: &Equations,
) -> Option<ClaimMotion> {
    let name = entry.text()?;
    let names = Names::of(equations);
    let Some(system) = names.system(&name) else {
        let near = nearest(&name, names.system_names()).map(|near| format!("; did you mean `{near}`?"));
        let near = near.unwrap_or_default();
        return entry.needs(format!("the name of a [[system]] of equations.toml{near}"));
    };
    let states = system.state.len();
    let is_of_three = states == 3 && !system.steady.is_empty();
    let said = match MotionWord::from_word(word) {
        Some(word) if states == 2 => MotionSaid::Planar(read_lemma(section, word, &system.state, &names)?),
        Some(_) => return entry.needs("a system with two state variables"),
        None if !is_of_three => {
            return entry.needs("a system with three state variables and a steady state");
        }
        None if word == WEAK_INSTABILITY => {
            MotionSaid::Lyapunov(LyapunovSign::Positive, read_expression(section, "frequency", &names)?)
        }
        None => {
            let [frequency, sign] = ["frequency", "sign"].map(|key| read_expression(section, key, &names));
            MotionSaid::Lyapunov(LyapunovSign::Of(sign?), frequency?)
        }
    };
    Some(ClaimMotion { state: system.state.clone(), name, said })
}

fn read_expression(section: &mut Section<'_>, key: &'static str, names: &Names) -> Option<Expression> {
    let entry = section.required(key, "an expression")?;
    entry.equation(read_side(&entry.text()?, names))
}

/// Which of the two state variables `variable` names.
fn read_index(section: &mut Section<'_>, state: &[Symbol]) -> Option<usize> {
    let allowed = state.iter().map(Symbol::as_str).collect::<Vec<_>>().join(" or ");
    let entry = section.required("variable", &allowed)?;
    let name = entry.text()?;
    let place = state.iter().position(|known| known.as_str() == name);
    entry.sound(place.ok_or(Problem::Needs(allowed)))
}

/// All expressions are read before the first fault ends it.
fn read_lemma(
    section: &mut Section<'_>,
    word: MotionWord,
    state: &[Symbol],
    names: &Names,
) -> Option<MotionLemma> {
    let read: Vec<_> = word.expressions().iter().map(|key| read_expression(section, key, names)).collect();
    let variable = if word.has_variable() { read_index(section, state) } else { Some(0) };
    let read: Vec<Expression> = read.into_iter().collect::<Option<_>>()?;
    Some(MotionLemma::new(word, variable?, read))
}
