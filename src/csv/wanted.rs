//! The columns that a header has to have, under any of their names and in any unit, with or without columns of their errors.

use slipmode_core::number::Rational;

use crate::csv::name::{MOST_WORDS, Reading, Unit, Wanted, is_named, of_what, readings, words};
use crate::scene::{CsvProblem, Quantity, nearest, stem_of_key, symbols, unit_of_key};

/// Where a column of values stands, and the size of its unit in SI, unless it is that of SI.
pub type ColumnPlace = (usize, Option<Rational>);

/// Where a column of errors stands, and its unit. Without a unit, the errors are in that of the values.
pub type ErrorPlace = (usize, Unit);

/// What the columns of a header give.
#[derive(Debug, Clone)]
pub struct Assigned {
    /// The columns of values, in the order of what is wanted.
    pub values: Vec<Option<ColumnPlace>>,
    /// The columns of errors.
    pub errors: Vec<Option<ErrorPlace>>,
    /// The columns that give none of these.
    pub others: Vec<usize>,
}

/// A column and what is wrong with it.
pub type ColumnFault = (String, CsvProblem);

/// What one column gives.
#[derive(Debug, Clone)]
enum Meaning {
    /// The values of what is wanted there, in SI and by its own name, or in another unit of this size.
    Values(usize, Option<Rational>),
    /// The errors of what is wanted there.
    Errors(usize, Unit),
    /// Values in a unit that cannot be used: the column is at fault if no other one has them.
    Unusable(usize, String),
    /// Something else.
    Other,
    /// What is at fault by itself.
    Faulty,
}

impl Wanted {
    /// The column of a quantity.
    pub fn quantity(quantity: Quantity, is_optional: bool) -> Self {
        Self { key: quantity.as_str(), symbols: symbols(quantity), is_optional }
    }

    /// The names that the column may have.
    fn allowed(&self) -> String {
        let names: Vec<&str> = [self.key].into_iter().chain(self.symbols.iter().copied()).collect();
        match self.other_unit() {
            "" => names.join(", "),
            other => {
                format!("{}; with another unit behind the name, {}_{other}", names.join(", "), self.short())
            }
        }
    }

    /// A name that the column of its errors may have.
    fn error_name(&self) -> String {
        let unit = self.other_unit();
        format!("{}_error{}{unit}", self.short(), if unit.is_empty() { "" } else { "_" })
    }

    /// Its shortest name.
    fn short(&self) -> &'static str {
        self.symbols.last().copied().unwrap_or(stem_of_key(self.key))
    }

    /// A unit beside that of SI.
    fn other_unit(&self) -> &'static str {
        match unit_of_key(self.key) {
            "m" => "um",
            "m/s" => "um_per_s",
            "Pa" => "mpa",
            "Pa/m" => "mpa_per_mm",
            "kg/m^2" => "kg_per_cm2",
            "s" => "ms",
            _ => "",
        }
    }
}

/// Finds the columns that are wanted. `is_known` names further columns that are read, and columns that slipmode itself appends.
///
/// A fault is every column that is missing, given twice, or in no unit or one of another dimension, and every one whose name says
/// "error" and is not understood.
pub fn assign(
    names: &[String],
    wanted: &[Wanted],
    is_known: impl Fn(&str) -> bool,
) -> (Assigned, Vec<ColumnFault>) {
    let mut faults = Vec::new();
    let mut meanings = Vec::new();
    for name in names {
        let found = if is_known(name) { Ok(Meaning::Other) } else { meaning(name, wanted) };
        let found = found.map_err(|problem| faults.push((name.clone(), problem)));
        meanings.push(found.unwrap_or(Meaning::Faulty));
    }
    let (mut values, mut errors) = (Vec::new(), Vec::new());
    for (index, of) in wanted.iter().enumerate() {
        let place = place(names, &meanings, index, of).map_err(|fault| faults.push(fault));
        values.push(place.unwrap_or_default());
        let place = error_place(names, &meanings, index, of).map_err(|fault| faults.push(fault));
        errors.push(place.unwrap_or_default());
    }
    let is_read = |index: usize| {
        values.iter().flatten().any(|(position, _)| *position == index)
            || errors.iter().flatten().any(|(position, _)| *position == index)
    };
    let others: Vec<usize> = (0..names.len()).filter(|index| !is_read(*index)).collect();
    let is_other = |index: &&usize| matches!(meanings[**index], Meaning::Other) && !is_known(&names[**index]);
    let unread = others.iter().filter(is_other).map(|index| &names[*index]);
    faults.extend(unknown_errors(unread, wanted));
    (Assigned { values, errors, others }, faults)
}

/// What a column gives by its name.
///
/// # Errors
/// When its errors have a unit that cannot be used, or the name can be understood in two ways.
fn meaning(name: &str, wanted: &[Wanted]) -> Result<Meaning, CsvProblem> {
    if let Some(index) = wanted.iter().position(|wanted| is_named(name, wanted.key)) {
        return Ok(Meaning::Values(index, None));
    }
    let words = words(name);
    let of = |(index, of): (usize, &Wanted)| {
        readings(&words, of).into_iter().map(move |reading| (index, reading)).collect::<Vec<_>>()
    };
    let mut all: Vec<(usize, Reading)> = wanted.iter().enumerate().flat_map(of).collect();
    // What is not understood as one quantity may be understood as another, as `sigma_Dc_err`.
    if all.iter().any(|(_, reading)| reading.unit != Unit::Unclear) {
        all.retain(|(_, reading)| reading.unit != Unit::Unclear);
    }
    // A unit that fits tells the error of M in kg/m2 from a stress in m kg/m2.
    let has_unit = |unit: &Unit| matches!(unit, Unit::Size(_) | Unit::Share(_));
    if all.iter().filter(|(_, reading)| has_unit(&reading.unit)).count() == 1 {
        all.retain(|(_, reading)| has_unit(&reading.unit));
    }
    let [(index, Reading { is_error, unit })] = &all[..] else {
        return if all.is_empty() { Ok(Meaning::Other) } else { Err(ambiguous(&all, wanted)) };
    };
    match (is_error, unit) {
        (_, Unit::Unclear) => Err(CsvProblem::UnknownError(wanted[*index].error_name())),
        (true, Unit::Refused(reason)) => {
            Err(CsvProblem::Unit { reason: reason.clone(), allowed: wanted[*index].error_name() })
        }
        (true, unit) => Ok(Meaning::Errors(*index, unit.clone())),
        (false, Unit::Refused(reason)) => Ok(Meaning::Unusable(*index, reason.clone())),
        (false, Unit::Size(size)) => Ok(Meaning::Values(*index, (*size != 1).then(|| size.clone()))),
        (false, Unit::Absent | Unit::Share(_)) => Ok(Meaning::Values(*index, None)),
    }
}

/// The fault of a name that can be understood in two ways.
fn ambiguous(readings: &[(usize, Reading)], wanted: &[Wanted]) -> CsvProblem {
    let words = |(index, reading): &(usize, Reading)| match reading.is_error {
        true => (format!("the error of {}", wanted[*index].key), wanted[*index].error_name()),
        false => (wanted[*index].key.to_string(), wanted[*index].key.to_string()),
    };
    let (readings, allowed): (Vec<_>, Vec<_>) = readings.iter().map(words).unzip();
    CsvProblem::Ambiguous { readings: readings.join(" or "), allowed: allowed.join(", ") }
}

/// Where the values of what is wanted stand.
fn place(
    names: &[String],
    meanings: &[Meaning],
    index: usize,
    wanted: &Wanted,
) -> Result<Option<ColumnPlace>, ColumnFault> {
    let places = of_meaning(meanings, |meaning| match meaning {
        Meaning::Values(of, unit) if *of == index => Some(unit.clone()),
        _ => None,
    });
    let place = only(places, names, wanted.key.into())?;
    if place.is_some() {
        return Ok(place);
    }
    // Where nothing has to be there, a column in an unknown unit is still not to be passed over.
    let unusable = of_meaning(meanings, |meaning| match meaning {
        Meaning::Unusable(of, reason) if *of == index => Some(reason.clone()),
        _ => None,
    });
    if let Some((position, reason)) = unusable.into_iter().next() {
        return Err((names[position].clone(), CsvProblem::Unit { reason, allowed: wanted.allowed() }));
    }
    if wanted.is_optional {
        return Ok(None);
    }
    let others = names.iter().zip(meanings).filter(|(_, meaning)| matches!(meaning, Meaning::Other));
    let nearest = nearest(wanted.key, others.map(|(name, _)| name.as_str())).map(str::to_string);
    Err((wanted.key.into(), CsvProblem::MissingColumn { nearest, allowed: wanted.allowed() }))
}

/// Where the errors of what is wanted stand.
fn error_place(
    names: &[String],
    meanings: &[Meaning],
    index: usize,
    wanted: &Wanted,
) -> Result<Option<ErrorPlace>, ColumnFault> {
    let places = of_meaning(meanings, |meaning| match meaning {
        Meaning::Errors(of, unit) if *of == index => Some(unit.clone()),
        _ => None,
    });
    only(places, names, format!("the error of {}", wanted.key))
}

/// The columns of a meaning.
fn of_meaning<T>(meanings: &[Meaning], of: impl Fn(&Meaning) -> Option<T>) -> Vec<(usize, T)> {
    meanings.iter().enumerate().filter_map(|(position, meaning)| Some((position, of(meaning)?))).collect()
}

/// The column of a content; two are a fault. A column with the very same name is reported as doubled.
fn only<T>(
    places: Vec<(usize, T)>,
    names: &[String],
    wanted: String,
) -> Result<Option<(usize, T)>, ColumnFault> {
    if let [(first, _), (second, _), ..] = places[..]
        && names[first] != names[second]
    {
        let first = names[first].clone();
        return Err((names[second].clone(), CsvProblem::SecondColumn { first, wanted }));
    }
    Ok(places.into_iter().next())
}

/// The columns that nothing reads and whose names say "error", unless they have the errors of other such columns.
fn unknown_errors<'n>(
    unread: impl Iterator<Item = &'n String>,
    wanted: &[Wanted],
) -> impl Iterator<Item = ColumnFault> {
    let (mut errors, mut others) = (Vec::new(), Vec::new());
    for name in unread {
        let words = words(name);
        match of_what(&words) {
            Some(of) => errors.push((name.clone(), of)),
            // Long names are not compared, so that a header of any bytes is read in time.
            None if words.len() <= MOST_WORDS => {
                others.push(words.iter().map(|word| word.to_lowercase()).collect::<Vec<_>>());
            }
            None => {}
        }
    }
    let allowed = wanted.last().map(Wanted::error_name).unwrap_or_default();
    let is_unknown = move |of: &[String]| {
        let is_of = |other: &Vec<String>| of.iter().all(|word| other.contains(word));
        of.is_empty() || of.len() > MOST_WORDS || !others.iter().any(is_of)
    };
    let unknown = errors.into_iter().filter(move |(_, of)| is_unknown(of));
    unknown.map(move |(name, _)| (name, CsvProblem::UnknownError(allowed.clone())))
}

/// A column that gives a value of SI in a unit of its own or in none; where the value has its column, one that gives it again.
pub fn misnamed(key: &'static str, names: &[String]) -> Option<(String, CsvProblem)> {
    let wanted = Wanted { key, symbols: &[], is_optional: false };
    let first = names.iter().find(|name| is_named(name, key));
    let is_meant =
        |reading: &Reading| !reading.is_error && (first.is_none() || matches!(reading.unit, Unit::Size(_)));
    let is_other =
        |name: &&String| !is_named(name, key) && readings(&words(name), &wanted).iter().any(is_meant);
    let name = names.iter().find(is_other)?;
    let problem = match first {
        Some(first) => CsvProblem::SecondColumn { first: first.clone(), wanted: key.into() },
        None => CsvProblem::UnknownUnit(key),
    };
    Some((name.clone(), problem))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(quantity: Quantity, names: &[&str]) -> Result<Assigned, ColumnFault> {
        let names: Vec<String> = names.iter().map(|name| (*name).to_string()).collect();
        let (found, mut faults) = assign(&names, &[Wanted::quantity(quantity, false)], |_| false);
        if faults.is_empty() { Ok(found) } else { Err(faults.swap_remove(0)) }
    }

    fn place(quantity: Quantity, names: &[&str]) -> Result<ColumnPlace, ColumnFault> {
        found(quantity, names).map(|found| found.values[0].clone().expect("a place"))
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
        assert_eq!(place(Quantity::DirectEffect, &["a [-]", "a_sample", "a_2"]), Ok((0, None)));
        let smallest = Rational::from((1, 1_000_000));
        assert_eq!(place(Quantity::CriticalSlipDistance, &["d_c_um"]), Ok((0, Some(smallest))));
        let stiffest = Rational::from(1_000_000_000);
        assert_eq!(place(Quantity::Stiffness, &["k_c", "K_MPa_per_mm"]), Ok((1, Some(stiffest))));
    }

    #[test]
    fn two_columns_of_one_quantity_are_refused_in_any_unit_and_spelling() {
        for [first, second] in [
            ["m", "mass_per_area_kg_per_cm2"],
            ["m", "mass_per_area_kg_per_m2"],
            ["mass_per_area_kg_per_m2", "M"],
            ["mass_per_area_kg_per_m2", "mass_per_area_kg_per_cm2"],
            ["m", "M"],
        ] {
            let (name, problem) = place(Quantity::MassPerArea, &[first, "id", second]).unwrap_err();
            assert_eq!(name, second);
            assert!(problem.to_string().contains(&format!("`{first}` gives")), "{problem}");
        }
        assert!(place(Quantity::DirectEffect, &["direct_effect", "Direct_Effect"]).is_err());
        let names = ["period_s", "period_ms"].map(String::from);
        assert_eq!(misnamed("period_s", &names).map(|(name, _)| name), Some("period_ms".into()));
        assert_eq!(misnamed("period_s", &["period_s", "period_count"].map(String::from)), None);
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
