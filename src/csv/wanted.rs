//! The columns that a header has to have, under any of their names and in any unit.

use slipmode_core::number::Rational;

use crate::csv::header::is_named;
use crate::scene::{
    CsvProblem, Quantity, nearest, read_unit, stem_of_key, unit_for, unit_of_column, unit_of_key,
};

/// A column that a header has to have.
#[derive(Debug, Clone, Copy)]
pub struct Wanted {
    /// Its name in SI.
    pub key: &'static str,
    /// Short names, in SI unless a unit stands behind them; a longer one before one with which it begins.
    pub symbols: &'static [&'static str],
    /// Whether it may be missing.
    pub is_optional: bool,
}

/// Where a column stands, and the size of its unit in SI, unless it is that of SI.
pub type Place = (usize, Option<Rational>);

impl Wanted {
    /// The column of a quantity.
    pub fn quantity(quantity: Quantity, is_optional: bool) -> Self {
        Self { key: quantity.key(), symbols: quantity.symbols(), is_optional }
    }

    /// Where the column stands among these; its name in SI comes before any other.
    ///
    /// # Errors
    /// The column that is missing, given twice, or in no unit or one of another dimension.
    pub fn place(&self, names: &[String]) -> Result<Place, (String, CsvProblem)> {
        let in_si = names.iter().enumerate().filter(|(_, name)| is_named(name, self.key));
        let mut places: Vec<Place> = in_si.map(|(position, _)| (position, None)).collect();
        let mut refused = None;
        if places.is_empty() {
            for (position, name) in names.iter().enumerate() {
                match self.reading(name) {
                    Some(Ok(size)) => places.push((position, (size != 1).then_some(size))),
                    Some(Err(reason)) => refused = refused.or(Some((name, reason))),
                    None => {}
                }
            }
        }
        // A column with the very same name is reported as doubled.
        if let [(first, _), (second, _), ..] = places[..]
            && names[first] != names[second]
        {
            let first = names[first].clone();
            return Err((names[second].clone(), CsvProblem::SecondColumn { first, wanted: self.key }));
        }
        match (places.into_iter().next(), refused) {
            (Some(place), _) => Ok(place),
            (None, Some((name, reason))) => {
                Err((name.clone(), CsvProblem::Unit { reason, allowed: self.allowed() }))
            }
            (None, None) => {
                let near = nearest(self.key, names.iter().map(String::as_str)).map(str::to_string);
                Err((self.key.into(), CsvProblem::MissingColumn { nearest: near, allowed: self.allowed() }))
            }
        }
    }

    /// The size in SI of the unit in which a column gives this quantity, or why that is none; none for another column.
    pub fn reading(&self, name: &str) -> Option<Result<Rational, String>> {
        let in_si = unit_of_key(self.key);
        if let Some(unit) = unit_behind(name, stem_of_key(self.key)) {
            let is_lacking = unit.is_empty() && in_si != "1";
            return Some(if is_lacking { Err("no unit".into()) } else { unit_for(&unit, in_si) });
        }
        let unit = self.symbols.iter().find_map(|symbol| unit_behind(name, symbol))?;
        if unit.is_empty() {
            return Some(Ok(Rational::from(1)));
        }
        // A column that only begins with a symbol, such as `a_error`, is another one.
        read_unit(&unit).is_ok().then(|| unit_for(&unit, in_si))
    }

    /// The names that the column may have.
    fn allowed(&self) -> String {
        let names: Vec<&str> = [self.key].into_iter().chain(self.symbols.iter().copied()).collect();
        let stem = self.symbols.last().copied().unwrap_or(stem_of_key(self.key));
        let other = match unit_of_key(self.key) {
            "m" => "um",
            "m/s" => "um_per_s",
            "Pa" => "mpa",
            "Pa/m" => "mpa_per_mm",
            "kg/m^2" => "kg_per_cm2",
            "s" => "ms",
            _ => return names.join(", "),
        };
        format!("{}; with another unit behind the name, {stem}_{other}", names.join(", "))
    }
}

/// The unit behind a name: `um` in `d_c_um`, `MPa` in `sigma [MPa]`; empty when there is none, absent when the column has another name.
fn unit_behind(column: &str, name: &str) -> Option<String> {
    let column = column.trim();
    let beginning = column.get(..name.len())?;
    let rest = &column[name.len()..];
    if !beginning.eq_ignore_ascii_case(name) {
        return None;
    }
    match rest.chars().next() {
        None => Some(String::new()),
        Some('_') => Some(unit_of_column(&rest[1..])),
        Some(' ' | '[' | '(') => {
            let unit = rest.trim_matches([' ', '[', ']', '(', ')']);
            Some(if unit == "-" { "1".into() } else { unit.to_string() })
        }
        Some(_) => None,
    }
}

/// A column that gives a value of SI in a unit of its own or in none.
pub fn misnamed(key: &'static str, names: &[String]) -> Option<(String, CsvProblem)> {
    let name = names.iter().find(|name| unit_behind(name, stem_of_key(key)).is_some())?;
    Some((name.clone(), CsvProblem::UnknownUnit { wanted: key }))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place(quantity: Quantity, names: &[&str]) -> Result<Place, (String, CsvProblem)> {
        let names: Vec<String> = names.iter().map(|name| (*name).to_string()).collect();
        Wanted::quantity(quantity, false).place(&names)
    }

    #[test]
    fn a_quantity_is_found_under_its_symbol_and_in_its_unit() {
        let stress = Quantity::NormalStress;
        let millionfold = Some(Rational::from(1_000_000));
        for (name, unit) in [
            ("normal_stress_pa", None),
            (" Normal_Stress_Pa ", None),
            ("sigma", None),
            ("SIGMA_N", None),
            ("sigma_pa", None),
            ("sigma_mpa", millionfold.clone()),
            ("sigma_n_MPa", millionfold.clone()),
            ("normal_stress_mpa", millionfold.clone()),
            ("Sigma [MPa]", millionfold.clone()),
            ("sigma(MPa)", millionfold),
        ] {
            assert_eq!(place(stress, &["id", name]), Ok((1, unit)), "{name}");
        }
        assert_eq!(place(Quantity::DirectEffect, &["a [-]", "a_error"]), Ok((0, None)));
        let smallest = Rational::from((1, 1_000_000));
        assert_eq!(place(Quantity::CriticalSlipDistance, &["d_c_um"]), Ok((0, Some(smallest))));
        let stiffest = Rational::from(1_000_000_000);
        assert_eq!(place(Quantity::Stiffness, &["k_c", "K_MPa_per_mm"]), Ok((1, Some(stiffest))));
    }

    #[test]
    fn the_name_in_si_comes_before_all_others_and_two_others_are_refused() {
        assert_eq!(place(Quantity::MassPerArea, &["m", "mass_per_area_kg_per_m2", "M"]), Ok((1, None)));
        let (name, problem) = place(Quantity::MassPerArea, &["m", "mass_per_area_kg_per_cm2"]).unwrap_err();
        assert_eq!(name, "mass_per_area_kg_per_cm2");
        assert!(problem.to_string().contains("`m` gives"), "{problem}");
        assert!(place(Quantity::DirectEffect, &["direct_effect", "Direct_Effect"]).is_err());
    }

    #[test]
    fn a_unit_of_another_dimension_is_named_and_a_missing_column_lists_its_names() {
        let told = |quantity, names: &[&str]| {
            let (name, problem) = place(quantity, names).unwrap_err();
            format!("{name}: {problem}")
        };
        assert!(
            told(Quantity::NormalStress, &["sigma_um"]).starts_with("sigma_um: um is a length; stress is Pa")
        );
        assert!(told(Quantity::NormalStress, &["normal_stress_psi"]).contains("\"psi\" is no unit"));
        assert!(told(Quantity::NormalStress, &["normal_stress"]).starts_with("normal_stress: no unit"));
        assert_eq!(
            told(Quantity::NormalStress, &["a"]),
            "normal_stress_pa: missing column (allowed: normal_stress_pa, sigma_n, sigma; with another unit behind the \
             name, sigma_mpa)"
        );
        assert!(told(Quantity::DirectEffect, &["a_error"]).ends_with("(allowed: direct_effect, a)"));
    }
}
