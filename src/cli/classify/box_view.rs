//! What `classify` says of values with error bars: as text for people, as one JSON object for programs.

use serde_json::{Value, json};
use slipmode::scene::Quantity;
use slipmode_core::friction::Parameters;
use slipmode_core::number::format::rational_to_decimal;
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::{
    InertialThreshold, OverBox, ParameterBox, Possible, SlipMode, SpectralClass, over_box, transition_sign,
};

use crate::cli::classify::ranges::{RootRanges, outward};
use crate::cli::classify::rows::NEUTRAL;
use crate::cli::classify::sample::{Sample, Sampled};
use crate::cli::inputs::{SCHEMA, exact_json, ranges_json};
use crate::cli::terminal;

/// Significant digits in the text for people.
const SHOWN_DIGITS: usize = 6;

/// A classified box.
#[derive(Debug)]
pub struct BoxView {
    region: ParameterBox,
    found: OverBox,
    ranges: RootRanges,
    sampled: Option<Sampled>,
}

impl BoxView {
    /// Classifies all values within the error bars; none for a threshold that is not allowed.
    pub fn new(region: ParameterBox, threshold: &InertialThreshold, sample: Option<&Sample>) -> Option<Self> {
        let found = over_box(&region, threshold)?;
        let ranges = RootRanges::new(&region, &found);
        let sampled = sample.map(|sample| sample.draw(&region, threshold));
        Some(Self { region, found, ranges, sampled })
    }

    /// One object: what is certain, what is possible at which point, and ranges.
    pub fn json(&self) -> Value {
        let found = &self.found;
        let modes =
            found.slip_modes.iter().map(|possible| entry("mode", mode_word(possible), &possible.witness));
        let class = |possible: &Possible<SpectralClass>| {
            entry("spectral_class", possible.what.as_str(), &possible.witness)
        };
        let undecided = |(mode, share): &(SlipMode, Rational)| json!({ "mode": mode.as_str(), "share": nearest_f64(share) });
        let [real, imaginary, frequency] = self.ranges.enclosures();
        json!({
            "schema": SCHEMA,
            "inputs": ranges_json(&self.region, &[]),
            "certain": found.certain_mode().is_some(),
            "slip_modes": modes.collect::<Vec<_>>(),
            "undecided": found.undecided.iter().map(undecided).collect::<Vec<_>>(),
            "undecided_share": nearest_f64(&found.undecided_share()),
            "spectral_classes": found.spectral_classes.iter().map(class).collect::<Vec<_>>(),
            "transition_signs": found.transition_signs,
            "boundary_signs": found.boundary_signs,
            "max_real_per_s": real,
            "max_imaginary_per_s": imaginary,
            "frequency_hz": frequency,
            "attained": self.ranges.attained_json(),
            "critical_stiffness_pa_per_m": outward(&found.critical_stiffness_pa_per_m),
            "sampled": self.sampled.as_ref().map(Sampled::json),
        })
    }

    /// Lines of name, value and meaning.
    pub fn text(&self) -> String {
        let found = &self.found;
        let is_certain = found.certain_mode().is_some();
        let name = if is_certain { "slip mode" } else { "possible slip mode" };
        let meaning = |witness: &Option<Parameters<Rational>>| match witness {
            _ if is_certain => "(certain: all values within the error bars)".to_string(),
            Some(point) => format!("(at {})", self.place(point)),
            None => "(at values that are not rational)".to_string(),
        };
        let mut lines: Vec<(&str, String, String)> = Vec::new();
        for possible in &found.slip_modes {
            lines.push((name, mode_word(possible).to_string(), meaning(&possible.witness)));
        }
        for (mode, share) in &found.undecided {
            let share = rational_to_decimal(&(share.clone() * 100u32), 3);
            let meaning = format!("(in at most {share} % of the box)");
            lines.push(("undecided slip mode", mode.as_str().to_string(), meaning));
        }
        for possible in &found.spectral_classes {
            lines.push(("spectral class", possible.what.as_str().to_string(), String::new()));
        }
        let signs =
            [("sign of K - K_c", found.transition_signs), ("sign of discriminant", found.boundary_signs)];
        for (name, [least, greatest]) in signs {
            let sign = if least == greatest { format!("{least}") } else { format!("{least} to {greatest}") };
            lines.push((name, sign, String::new()));
        }
        lines.extend(self.ranges.lines());
        let [least, greatest] = found.critical_stiffness_pa_per_m.each_ref().map(shown);
        lines.push(("K_c", format!("{least} to {greatest} Pa/m"), "(eq 9)".to_string()));
        lines.extend(self.sampled.iter().flat_map(Sampled::lines));
        let lines: Vec<_> =
            lines.iter().map(|(name, value, meaning)| (*name, value.clone(), meaning.as_str())).collect();
        terminal::named_values(&lines)
    }

    /// The uncertain values of a point.
    fn place(&self, point: &Parameters<Rational>) -> String {
        let values: [[Rational; 7]; 3] =
            [&self.region.lower(), &self.region.upper(), point].map(|point| point.clone().into());
        let [lower, upper, point] = values;
        let of = |i: usize| format!("{} = {}", Quantity::ALL[i].key(), shown(&point[i]));
        let uncertain: Vec<String> = (0..7).filter(|i| lower[*i] != upper[*i]).map(of).collect();
        if uncertain.is_empty() { "the given values".to_string() } else { uncertain.join(", ") }
    }
}

/// The mode as the classification of its witness states it: neutral on K = K_c.
fn mode_word(possible: &Possible<SlipMode>) -> &'static str {
    let is_neutral = possible.witness.as_ref().is_some_and(|point| transition_sign(&point.groups()) == 0);
    if is_neutral { NEUTRAL } else { possible.what.as_str() }
}

fn entry(key: &str, word: &str, witness: &Option<Parameters<Rational>>) -> Value {
    json!({ key: word, "witness": witness.as_ref().map(|point| exact_json(point, None)) })
}

fn shown(value: &Rational) -> String {
    rational_to_decimal(value, SHOWN_DIGITS)
}
