//! `simulate --smallest-kick`: the smallest sudden change of velocity or stress by which the slider leaves steady sliding.

use std::cell::Cell;
use std::cmp::Ordering;

use serde_json::Value;
use slipmode_core::dynamics::{Kick, Model};
use slipmode_core::friction::{EvolutionLaw, Parameters};
use slipmode_core::number::format::round_digits;
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_theory::hopf::Criticality;

use crate::cli::answer::{Answer, SHOWN_DIGITS};
use crate::cli::simulate::view::certain;

/// What is known of the kicks of one slider.
#[derive(Debug)]
pub struct Kicks {
    /// V0 in m/s and aσ in Pa.
    units: [f64; 2],
    /// For each kick the sizes between which the smallest lies that leaves; none when no tried size does. Sampled.
    ///
    /// Nothing is tried where every disturbance grows: K < K_c, or K = K_c with the sign of the Lyapunov coefficient that says
    /// so. Exact.
    tried: Option<Vec<(Kick, Option<[f64; 2]>)>>,
}

impl Kicks {
    /// Searches the smallest kicks.
    ///
    /// # Errors
    /// When a run has no long-term behaviour.
    pub fn new(parameters: &Parameters<Rational>, law: EvolutionLaw) -> Result<Self, String> {
        let groups = parameters.groups();
        let grows = match groups.transition_margin().cmp0() {
            Ordering::Less => true,
            Ordering::Equal => {
                let [eta, beta] = [&groups.inertial_parameter, &groups.effect_ratio];
                Criticality::of(law, eta, beta) == Criticality::Subcritical
            }
            Ordering::Greater => false,
        };
        let model = Model::new(groups.map(nearest_f64), law);
        let decayed = Cell::new(0.0);
        let smallest =
            |kick: Kick| Ok((kick, kick.smallest(&model, &decayed).map_err(|failure| failure.to_string())?));
        let all = || Kick::ALL.into_iter().map(smallest).collect::<Result<_, String>>();
        let tried = (!grows).then(all).transpose()?;
        let parameters = parameters.map(nearest_f64);
        let units = [parameters.point.loading_velocity_m_per_s, parameters.direct_stress_pa()];
        Ok(Self { units, tried })
    }

    /// States that the kicks are not known.
    pub fn unknown() -> Answer {
        Answer::default().with("smallest_kicks", Value::Null)
    }

    /// States each kick, how it is known, and what follows for a laboratory.
    pub fn answer(&self) -> Answer {
        let (strength, parts): (_, Vec<Answer>) = match &self.tried {
            None => ("exact", Kick::ALL.map(|kick| self.part((kick, Some([0.0; 2])))).into()),
            Some(all) => ("sampled", all.iter().map(|tried| self.part(*tried)).collect()),
        };
        let conclusion = self.conclusion();
        let title = Answer::line(&format!("\nsmallest kicks that leave steady sliding ({strength}):"));
        let all = title.with("strength", strength).list("kicks", parts);
        let all = all.with("conclusion", &conclusion).text(&format!("{conclusion}\n"));
        Answer::default().part("smallest_kicks", all)
    }

    /// One kick; the sizes that bound it are of |ln(V/V0)| or |Δτ|/(aσ).
    fn part(&self, (kick, ends): (Kick, Option<[f64; 2]>)) -> Answer {
        let [unit, name, in_si] = if kick.is_of_velocity() {
            ["m/s", "V/V0 - 1", "velocity_change_m_per_s"]
        } else {
            ["Pa", "change of stress/(a sigma)", "stress_change_pa"]
        };
        let scale = self.units[usize::from(!kick.is_of_velocity())];
        let largest = kick.change(kick.largest());
        let answer = Answer::default().with("kick", kick.as_str()).with("largest_ratio", largest);
        let Some([decays, leaves]) = ends.map(|ends| ends.map(|size| kick.change(size))) else {
            let shown = |value| round_digits(value, SHOWN_DIGITS);
            return answer
                .with("ratio", Value::Null)
                .with("relative_error", Value::Null)
                .with(in_si, Value::Null)
                .named(kick.as_str(), &format!("none up to {} {unit}", shown(largest * scale)))
                .note(&format!("({name} up to {})", shown(largest)));
        };
        let (ratio, error) = (0.5 * (decays + leaves), 0.5 * (leaves - decays).abs());
        let relative_error = if error > 0.0 { error / ratio.abs() } else { 0.0 };
        answer
            .with("ratio", ratio)
            .with("relative_error", relative_error)
            .with(in_si, ratio * scale)
            .named(kick.as_str(), &format!("{} {unit}", certain(ratio * scale, error * scale)))
            .note(&format!("({name} = {})", certain(ratio, error)))
    }

    /// What a laboratory may conclude.
    fn conclusion(&self) -> String {
        let Some(all) = &self.tried else {
            return "Every disturbance leaves steady sliding, however small: no laboratory is quiet enough."
                .into();
        };
        let least = |of_velocity: bool| {
            let scale = self.units[usize::from(!of_velocity)];
            let sizes = all.iter().filter(|(kick, _)| kick.is_of_velocity() == of_velocity);
            let sizes = sizes.filter_map(|&(kick, ends)| Some(scale * kick.change(ends?[1]).abs()));
            sizes.reduce(f64::min)
        };
        let kicks = [(false, "stress", "Pa"), (true, "velocity", "m/s")].map(|(of_velocity, what, unit)| {
            Some(format!("of {what} by {} {unit}", round_digits(least(of_velocity)?, 3)))
        });
        let kicks: Vec<String> = kicks.into_iter().flatten().collect();
        if kicks.is_empty() {
            return "No tried kick leaves steady sliding.".into();
        }
        format!("Noise ends steady sliding if it contains a sudden change {}.", kicks.join(", or "))
    }
}
