//! What a claim reaches in a file of equations, as text in which nothing else of the file has a place.

use std::collections::BTreeSet;

use crate::Equations;
use crate::derivation::{Form, read_condition};
use slipmode_algebra::{Condition, Expression, Symbol};

/// Where a claim begins in a file of equations.
#[derive(Debug, Clone, Default)]
pub struct Start<'c> {
    /// The expressions that it names.
    pub expressions: Vec<&'c Expression>,
    /// The names that it has besides.
    pub names: Vec<&'c Symbol>,
    /// The systems that it names.
    pub systems: Vec<&'c str>,
    /// The numbers of the equations that it names.
    pub equations: Vec<&'c str>,
}

/// A part of a file of equations.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Part {
    Condition(String),
    Equation(String),
    Function(String),
    Name(String),
    System(String),
}

impl Equations {
    /// Everything in the file that this start reaches through names: equations, systems, definitions, conditions, and variables with
    /// what is assumed of them and their units. A line each, in one order: the file's order, layout and remarks do not matter.
    ///
    /// The conditions for everything in the file are reached from every start but an empty one.
    #[must_use]
    pub fn reached(&self, start: &Start<'_>) -> Vec<String> {
        let named = start.expressions.iter().flat_map(|expression| names_in(expression));
        let names = start.names.iter().map(|name| name_of(name));
        let systems = start.systems.iter().map(|name| Part::System((*name).to_owned()));
        let equations = start.equations.iter().map(|number| Part::Equation((*number).to_owned()));
        let mut open: Vec<Part> = named.chain(names).chain(systems).chain(equations).collect();
        if !open.is_empty() {
            open.extend(self.conditions().iter().cloned().map(Part::Condition));
        }
        let (mut seen, mut lines) = (BTreeSet::new(), BTreeSet::new());
        while let Some(part) = open.pop() {
            if seen.insert(part.clone()) {
                let (line, next) = self.part(&part);
                lines.extend(line);
                open.extend(next);
            }
        }
        lines.into_iter().collect()
    }

    /// The same file with these equations only: a derivation that starts from it can use no other, no system and no definition.
    #[must_use]
    pub fn only(&self, numbers: &[&str]) -> Self {
        let kept = self.iter().filter(|equation| numbers.contains(&equation.number.as_str()));
        self.with_equations(kept.cloned().collect())
    }

    /// What a part says, and what it names. A name that an equation defines says nothing besides the equation.
    fn part(&self, part: &Part) -> (Option<String>, Vec<Part>) {
        let given = |texts: Vec<String>| match &sorted(texts)[..] {
            [] => String::new(),
            all => format!(" given {}", all.join(", ")),
        };
        match part {
            Part::Condition(text) => {
                (Some(format!("condition {}", without_layout(text))), self.names_of_condition(text))
            }
            Part::Equation(number) => {
                let Some(equation) = self.iter().find(|equation| equation.number == *number) else {
                    return (Some(format!("equation {number}: none")), Vec::new());
                };
                let conditions = given(equation.given.iter().map(Condition::to_string).collect());
                let sides = [&equation.left, &equation.right].into_iter();
                let behind = sides.chain(equation.given.iter().map(|one| &one.expression));
                (
                    Some(format!("equation {number}: {equation}{conditions}")),
                    behind.flat_map(names_in).collect(),
                )
            }
            Part::System(name) => {
                let Some(system) = self.systems().iter().find(|system| system.name == *name) else {
                    return (Some(format!("system {name}: none")), Vec::new());
                };
                let of_state = |mark: &str, texts: &[String]| -> Vec<String> {
                    let pairs = system.state.iter().zip(texts);
                    pairs.map(|(state, text)| format!("{state}{mark} = {}", without_layout(text))).collect()
                };
                let (rates, steady) = (of_state("'", &system.rates), of_state("", &system.steady));
                let line = format!("system {name}: {}; steady {}", rates.join(", "), steady.join(", "));
                let states = system.state.iter().cloned().map(Part::Name);
                let texts = system.rates.iter().chain(&system.steady);
                let functions = self.names().functions();
                let sides = texts.filter_map(|text| Some(Expression::read_in(text, functions).ok()?.0));
                (Some(line), sides.flat_map(|side| names_in(&side)).chain(states).collect())
            }
            Part::Function(name) => self.function(name),
            Part::Name(name) => {
                if let Some(text) = self.definitions().iter().find(|text| text.name == *name) {
                    let conditions = given(text.given.iter().map(|one| without_layout(one)).collect());
                    let line = format!("definition {name} = {}{conditions}", without_layout(&text.is));
                    let mut next: Vec<Part> =
                        text.given.iter().flat_map(|one| self.names_of_condition(one)).collect();
                    if let Ok(form) = Form::read(&text.is, self.names().functions()) {
                        let values = form.values.iter().map(|(name, _)| name);
                        let variables = form.variables.iter().chain(values).map(name_of);
                        next.extend(variables);
                        next.extend(form.all_expressions().flat_map(names_in));
                        next.extend(form.system.map(Part::System));
                    }
                    return (Some(line), next);
                }
                match self.names().defining_equation(name) {
                    Some(number) => (None, vec![Part::Equation(number.to_owned())]),
                    None => (self.variable(name), Vec::new()),
                }
            }
        }
    }

    /// A function with the units of its value and of its argument.
    fn function(&self, name: &str) -> (Option<String>, Vec<Part>) {
        let known = self.functions().iter().find(|text| text.name == name);
        let of = known.and_then(|text| text.of.as_ref()).filter(|_| self.unit(name).is_some());
        let unit = |of: &String| format!(", {} of {of}", without_layout(self.unit(name).unwrap_or_default()));
        let units = of.map(unit).unwrap_or_default();
        let next = of.map(|of| Part::Name(of.clone())).into_iter().collect();
        (Some(format!("function {name}: smooth{units}")), next)
    }

    fn names_of_condition(&self, text: &str) -> Vec<Part> {
        let condition = read_condition(text, self.names().functions());
        condition.map_or_else(|_| Vec::new(), |condition| names_in(&condition.expression))
    }

    /// A variable with what is assumed of it and its unit; none for a constant of the grammar.
    fn variable(&self, name: &str) -> Option<String> {
        if ["i", "pm"].contains(&name) {
            return None;
        }
        let is_in = |list: &[String]| list.iter().any(|known| known == name);
        let assumed = if is_in(self.positive()) {
            "positive"
        } else if is_in(self.free()) {
            "free"
        } else {
            "no assumption"
        };
        let unit = self.unit(name.trim_end_matches('\'')).map(|unit| format!(", {}", without_layout(unit)));
        Some(format!("variable {name}: {assumed}{}", unit.unwrap_or_default()))
    }
}

/// A text with spaces only where they part two words.
#[must_use]
pub fn without_layout(text: &str) -> String {
    let is_inner = |character: char| character.is_alphanumeric() || "_'.".contains(character);
    text.split_whitespace().fold(String::new(), |line, word| {
        let parts_words = line.ends_with(is_inner) && word.starts_with(is_inner);
        line + if parts_words { " " } else { "" } + word
    })
}

fn name_of(symbol: &Symbol) -> Part {
    Part::Name(symbol.to_string())
}

fn names_in(expression: &Expression) -> Vec<Part> {
    let functions = expression.functions().into_iter().map(|name| Part::Function(name.to_string()));
    expression.variables().iter().map(name_of).chain(functions).collect()
}

fn sorted(mut texts: Vec<String>) -> Vec<String> {
    texts.sort();
    texts
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = r#"
        [assumptions]
        positive = ["A", "B", "L", "K", "V", "v", "theta"]
        free = ["x"]
        conditions = ["A < B"]
        [units]
        A = "Pa"
        B = "Pa"
        L = "m"
        K = "Pa/m"
        V = "m/s"
        v = "m/s"
        theta = "s"
        x = "m"
        s = "1/s"
        [[equation]]
        number = "1"
        equation = "tau = A*ln(v/V) + B*ln(V*theta/L)"
        [[equation]]
        number = "2"
        equation = "K_cr = (B - A)/L"
        given = ["B > A"]
        [[system]]
        name = "aging"
        state = ["v", "theta"]
        rates = ["v*(K*(V - v) - B*(1 - v*theta/L)/theta)/A", "1 - v*theta/L"]
        steady = ["V", "L/V"]
        [[definition]]
        name = "P"
        is = "characteristic(aging, s)"
        [[definition]]
        name = "slope"
        is = "derivative(tau, v)"
        given = ["x < L"]
    "#;

    fn reached(file: &str, from: &[&str]) -> Vec<String> {
        let equations = Equations::read(toml::from_str(file).expect("TOML")).expect("sound equations");
        let expressions: Vec<Expression> = from.iter().map(|text| text.parse().expect("a side")).collect();
        equations.reached(&Start { expressions: expressions.iter().collect(), ..Start::default() })
    }

    #[test]
    fn a_definition_reaches_its_system_and_a_name_its_equation() {
        let of_polynomial = reached(FILE, &["P"]);
        assert_eq!(
            of_polynomial,
            [
                "condition A<B",
                "definition P = characteristic(aging,s)",
                "system aging: v' = v*(K*(V-v)-B*(1-v*theta/L)/theta)/A, theta' = 1-v*theta/L; steady v = V, theta = L/V",
                "variable A: positive, Pa",
                "variable B: positive, Pa",
                "variable K: positive, Pa/m",
                "variable L: positive, m",
                "variable V: positive, m/s",
                "variable s: no assumption, 1/s",
                "variable theta: positive, s",
                "variable v: positive, m/s",
            ]
        );
        let of_slope = reached(FILE, &["slope"]);
        for line in ["equation 1: tau = A*ln(v/V) + B*ln(V*theta/L)", "variable x: free, m"] {
            assert!(of_slope.iter().any(|one| one == line), "{line}: {of_slope:?}");
        }
        assert_eq!(reached(FILE, &["left_2"]), reached(FILE, &["K_cr"]));
        assert!(
            reached(FILE, &["K_cr"]).contains(&"equation 2: K_cr = (B - A)/L given B - A > 0".to_owned())
        );
        assert!(reached(FILE, &[]).is_empty());
    }

    #[test]
    fn a_function_is_reached_with_the_units_of_its_value_and_of_its_argument() {
        let file = |units: &str, note: &str| {
            format!(
                "[assumptions]\npositive = [\"K\", \"V\"]\n{units}[[function]]\nname = \"f\"\nof = \"V\"\nnote = \"{note}\"\n\
                 [[definition]]\nname = \"D\"\nis = \"derivative(f(2*V), V)\"\n\
                 [[definition]]\nname = \"E\"\nis = \"2*K\"\n"
            )
        };
        let plain = reached(&file("", ""), &["D"]);
        assert_eq!(
            plain,
            ["definition D = derivative(f(2*V),V)", "function f: smooth", "variable V: positive"]
        );
        assert_eq!(reached(&file("", "Friction."), &["D"]), plain);
        assert!(!reached(&file("", ""), &["E"]).iter().any(|line| line.starts_with("function")));
        let units = "[units]\nK = \"N/m\"\nV = \"m/s\"\nf = \"N\"\n";
        let with_units = reached(&file(units, ""), &["D"]);
        assert!(with_units.contains(&"function f: smooth, N of V".to_owned()), "{with_units:?}");
    }

    #[test]
    fn what_is_reached_changes_the_text_and_nothing_else_does() {
        let known = reached(FILE, &["P"]);
        for (from, to) in [
            ("\"1 - v*theta/L\"]", "\"2 - 2*v*theta/L\"]"),
            ("characteristic(aging, s)", "K*V/L"),
            ("K = \"Pa/m\"", "K = \"Pa*m/m^2\""),
            ("[\"A < B\"]", "[\"A < 2*B\"]"),
        ] {
            assert!(FILE.contains(from), "{from}");
            // Without the polynomial the unit of its variable has no place.
            let altered = FILE.replace(from, to);
            let altered = if to == "K*V/L" { altered.replace("s = \"1/s\"\n", "") } else { altered };
            assert_ne!(reached(&altered, &["P"]), known, "{from}");
        }
        for (from, to) in [
            ("(B - A)/L", "2*(B - A)/L"),
            ("derivative(tau, v)", "derivative(tau,  theta)"),
            ("characteristic(aging, s)", " characteristic( aging,s ) "),
            ("[[system]]", "# a remark\n        [[system]]"),
            ("free = [\"x\"]", "free = []"),
        ] {
            assert!(FILE.contains(from), "{from}");
            // Without the free x neither its unit nor what is given of it has a place.
            let altered = FILE.replacen(from, to, 1);
            let altered = match to {
                "free = []" => altered.replace("x = \"m\"", "").replace("given = [\"x < L\"]", ""),
                _ => altered,
            };
            assert_eq!(reached(&altered, &["P"]), known, "{from}");
        }
    }

    #[test]
    fn an_equation_that_is_left_out_has_no_value() {
        let equations = Equations::read(toml::from_str(FILE).expect("TOML")).expect("sound equations");
        let only = equations.only(&["2"]);
        assert_eq!(only.iter().map(|one| one.number.as_str()).collect::<Vec<_>>(), ["2"]);
        assert_eq!(only.equation("1"), Equations::default().equation("1"));
        assert!(only.names().meaning(&Symbol::from("P")).is_none());
        assert_eq!(only.conditions(), equations.conditions());
    }

    #[test]
    fn spaces_part_words_only() {
        assert_eq!(without_layout("  not  stable( P,\n s )  and a < b "), "not stable(P,s)and a<b");
        assert_eq!(without_layout("theta' = 1 2"), "theta'=1 2");
    }
}
