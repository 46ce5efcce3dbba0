//! The hand-written theorems with one of their equations altered: Coq must refuse the file.

use super::files::Library;
use super::{Said, Task};
use crate::machine;
use crate::prelude::*;

/// The folder of the altered files.
const FOLDER: &str = "by_hand/";

/// A task for each row of `proofs/equations.csv`: its file, with twice its definition.
pub fn altered(library: &Library, table: &str) -> Result<Vec<Task>> {
    let task = |row: &str| {
        let [file, name, ..] = row.split(',').collect::<Vec<_>>()[..] else { return None };
        let (_, text) = library.iter().find(|(known, _)| known == file)?;
        let text = format!("Set Default Timeout 60.\n{}", doubled(text, name)?);
        let fault = format!("{file}_{name}");
        Some(Task { file: format!("{FOLDER}{fault}"), text, theorems: vec![format!("fault_{fault}")] })
    };
    let missing = |row| Failure::check(format!("proofs/equations.csv: {row}: there is no such definition"));
    table.lines().skip(1).map(|row| task(row).ok_or_else(|| missing(row))).collect()
}

/// The text with twice the definition of this name.
fn doubled(text: &str, name: &str) -> Option<String> {
    let head = format!("\nLet {name} ");
    let (before, rest) = text.split_once(&head)?;
    let (definition, after) = rest.split_once(".\n")?;
    let (arguments, value) = definition.split_once(":= ")?;
    Some(format!("{before}{head}{arguments}:= 2 * ({value}).\n{after}"))
}

/// What Coq's error message means: an altered file is refused as a whole, but not by a time limit.
pub fn refusal(task: &Task, message: String) -> Said {
    match task.file.strip_prefix(FOLDER) {
        Some(fault) if !message.contains("Timeout") => Ok(format!("refused {fault}\n")),
        _ => Err(message),
    }
}

/// Has Gappa check the rounding errors of the 64-bit filter too, installing it where that is possible.
pub fn second_opinion() -> Result {
    if !machine::provide(&["gappa"])?.is_empty() {
        println!("prove: no second opinion on rounding errors, because gappa is not installed");
        return Ok(());
    }
    program("gappa", "proofs/row_filter.gappa").check()?;
    println!("prove: gappa accepts the rounding errors of the 64-bit filter");
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_definition_of_each_row_is_altered_and_a_missing_one_is_an_error() {
        let text = "From A Require B.\nLet c (V : R) := M / V.\nLet d := a.\n".to_owned();
        let library = vec![("Slider".to_owned(), text)];
        let tasks = altered(&library, "file,name\nSlider,c\n").unwrap();
        assert!(tasks[0].text.contains("\nLet c (V : R) := 2 * (M / V).\nLet d := a.\n"));
        assert_eq!(tasks[0].theorems, ["fault_Slider_c"]);
        assert!(altered(&library, "file,name\nSlider,e\n").is_err());
    }

    #[test]
    fn an_error_is_a_refusal_of_an_altered_file_and_a_time_limit_is_not() {
        let task = |file: &str| Task { file: file.into(), text: String::new(), theorems: Vec::new() };
        let altered = task("by_hand/Slider_c");
        assert_eq!(refusal(&altered, "no field equation".into()), Ok("refused Slider_c\n".into()));
        assert_eq!(refusal(&altered, "Timeout!".into()), Err("Timeout!".into()));
        assert_eq!(refusal(&task("r/claim_S1_faults"), "Error".into()), Err("Error".into()));
    }

    #[test]
    fn the_rounding_theorems_have_the_constants_of_the_filter() {
        let text = |path: &str| std::fs::read_to_string(crate::process::root().join(path)).unwrap();
        let theorems = text("proofs/Rounding.v");
        let power = |name: &str| -> u32 {
            let (_, rest) = theorems.split_once(&format!("Definition {name} : R := / 2 ^ ")).unwrap();
            rest.split_once('.').unwrap().0.parse().unwrap()
        };
        let code = text("crates/core/src/stability/batch/row_filter.rs");
        let relative = power("relative_bound");
        assert!(code.contains(&format!("const RELATIVE_BOUND: f64 = 1.0 / (1u64 << {relative}) as f64;")));
        let absolute = power("absolute_bound");
        assert!(
            code.contains(&format!("const ABSOLUTE_BOUND: f64 = f64::from_bits((1023 - {absolute}) << 52);"))
        );
        let number = |name: &str| {
            let (_, rest) = theorems.split_once(&format!("Definition {name} : R := ")).unwrap();
            rest.split_once('.').unwrap().0.to_owned()
        };
        let code = text("crates/core/src/stability/certain_signs.rs");
        let (factor, units) = (number("margin_factor"), number("margin_units"));
        assert!(code.contains(&format!("terms * {factor}.0 * (self.relative_error + {units}.0 * R::UNIT);")));
        let units = number("group_units");
        assert!(code.contains(&format!("relative_error: {units}.0 * f64::UNIT }}")));
        assert_eq!(power("unit_roundoff"), f64::MANTISSA_DIGITS);
        assert_eq!(power("underflow") as i32, f64::MANTISSA_DIGITS as i32 - f64::MIN_EXP);
    }
}
