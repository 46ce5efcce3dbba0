//! Units: products and quotients of powers of kg, m and s.

use std::collections::BTreeMap;
use std::fmt;

use rug::Rational;

use slipmode_algebra::{Expression, Function, Symbol};

/// Powers of kg, m and s.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Dimension([Rational; 3]);

/// The words for units, as powers of kg, m and s.
const WORDS: [(&str, [i32; 3]); 8] = [
    ("1", [0, 0, 0]),
    ("kg", [1, 0, 0]),
    ("m", [0, 1, 0]),
    ("s", [0, 0, 1]),
    ("Pa", [1, -1, -2]),
    ("N", [1, 1, -2]),
    ("J", [1, 2, -2]),
    ("Hz", [0, 0, -1]),
];

impl Dimension {
    /// Reads a unit such as `Pa*s/m` or `m^2`.
    ///
    /// # Errors
    /// The part that is no unit.
    pub fn read(text: &str) -> Result<Self, String> {
        let mut found = Self::default();
        for (mut part, divides) in parts(text) {
            let mut exponent = if divides { -1 } else { 1 };
            if let Some((base, power)) = part.split_once('^') {
                let power = power.trim().parse::<i32>().ok().filter(|power| power.abs() <= 12);
                exponent *=
                    power.ok_or_else(|| format!("'{part}': a power is a whole number from -12 to 12"))?;
                part = base;
            }
            let word = WORDS.iter().find(|(word, _)| *word == part.trim());
            let (_, powers) = word.ok_or_else(|| {
                format!(
                    "'{}' is no unit (allowed: kg, m, s, Pa, N, J, Hz and 1, with *, / and ^)",
                    part.trim()
                )
            })?;
            found = found.times(&Self(powers.map(Rational::from)).power(&Rational::from(exponent)));
        }
        Ok(found)
    }

    /// A product.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        Self(std::array::from_fn(|index| Rational::from(&self.0[index] + &other.0[index])))
    }

    /// A power.
    #[must_use]
    pub fn power(&self, exponent: &Rational) -> Self {
        Self(std::array::from_fn(|index| Rational::from(&self.0[index] * exponent)))
    }

    /// The unit of a rate of change.
    pub(crate) fn per_second(&self) -> Self {
        self.over(&Self([0, 0, 1].map(Rational::from)))
    }

    /// A quotient.
    #[must_use]
    pub fn over(&self, other: &Self) -> Self {
        self.times(&other.power(&Rational::from(-1)))
    }
}

/// The factors and divisors of a product.
fn parts(text: &str) -> Vec<(&str, bool)> {
    let mut divides = false;
    let mut found = Vec::new();
    let mut start = 0;
    for (place, character) in text.char_indices().filter(|(_, character)| ['*', '/'].contains(character)) {
        found.push((&text[start..place], divides));
        (start, divides) = (place + 1, character == '/');
    }
    found.push((&text[start..], divides));
    found
}

impl fmt::Display for Dimension {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let named = ["kg", "m", "s"].iter().zip(&self.0).filter(|(_, power)| !power.is_zero());
        let written = named.map(|(name, power)| match *power == 1 {
            true => (*name).to_owned(),
            false => format!("{name}^{power}"),
        });
        let written: Vec<String> = written.collect();
        formatter.write_str(if written.is_empty() { "1" } else { "" })?;
        formatter.write_str(&written.join(" "))
    }
}

/// The units of names, and those of the arguments of functions; none for a name that means zero.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Units(pub(super) BTreeMap<Symbol, Option<Dimension>>, pub(super) BTreeMap<Symbol, Dimension>);

impl Units {
    /// The unit of an expression; none for zero, which fits any.
    ///
    /// # Errors
    /// A sum of different units, a function of something with a unit, a name without one.
    pub fn of(&self, expression: &Expression) -> Result<Option<Dimension>, String> {
        let one = Dimension::default;
        match expression {
            Expression::Number(value) if value.is_zero() => Ok(None),
            Expression::Number(_) => Ok(Some(one())),
            Expression::Variable(name) => self.of_name(name),
            Expression::Sum(parts) => self.of_sum(expression, parts),
            Expression::Product(parts) => parts.iter().try_fold(Some(one()), |product, part| {
                Ok(self.of(part)?.zip(product).map(|(part, product)| product.times(&part)))
            }),
            Expression::Quotient(above, below) => {
                Ok(self.of(above)?.zip(self.of(below)?).map(|(above, below)| above.over(&below)))
            }
            Expression::Negation(inner) | Expression::Call(Function::Abs, inner) => self.of(inner),
            Expression::Power(inner, exponent) => {
                Ok(self.of(inner)?.map(|inner| inner.power(&Rational::from(*exponent))))
            }
            Expression::Call(Function::Sqrt, inner) => {
                Ok(self.of(inner)?.map(|inner| inner.power(&Rational::from((1, 2)))))
            }
            Expression::Generic(function, inner) => self.of_function(function, inner),
            Expression::Call(function, inner) => match self.of(inner)? {
                Some(found) if found != one() => {
                    let word = function.as_str();
                    Err(format!("the argument of {word}({inner}) is {found}, and must be 1"))
                }
                _ => Ok(Some(one())),
            },
        }
    }

    /// A derivative has the unit of the function over that of the argument.
    fn of_function(&self, function: &Symbol, inner: &Expression) -> Result<Option<Dimension>, String> {
        let base = function.undifferentiated();
        let stated = self.0.get(&base).cloned().flatten().zip(self.1.get(&base));
        let (value, argument) = stated.ok_or_else(|| format!("'{base}' has no unit"))?;
        match self.of(inner)? {
            Some(found) if found != *argument => {
                Err(format!("the argument of {function}({inner}) is {found}, and must be {argument}"))
            }
            _ => Ok(Some(value.over(&argument.power(&Rational::from(function.derivative_order()))))),
        }
    }

    fn of_name(&self, name: &Symbol) -> Result<Option<Dimension>, String> {
        if ["i", "pm"].contains(&name.as_str()) {
            return Ok(Some(Dimension::default()));
        }
        if let Some(found) = self.0.get(name) {
            return Ok(found.clone());
        }
        let base = name.base().parse::<Symbol>().ok().and_then(|base| self.0.get(&base));
        let base = base.ok_or_else(|| format!("'{name}' has no unit"))?;
        let rate = |unit: Option<Dimension>, _| unit.map(|unit| unit.per_second());
        Ok((0..name.derivative_order()).fold(base.clone(), rate))
    }

    fn of_sum(&self, sum: &Expression, parts: &[Expression]) -> Result<Option<Dimension>, String> {
        let mut first: Option<(&Expression, Dimension)> = None;
        for part in parts {
            let Some(found) = self.of(part)? else { continue };
            let part = if let Expression::Negation(inner) = part { inner } else { part };
            match &first {
                None => first = Some((part, found)),
                Some((other, unit)) if *unit != found => {
                    return Err(format!("in '{sum}', '{other}' is {unit} and '{part}' is {found}"));
                }
                Some(_) => {}
            }
        }
        Ok(first.map(|(_, unit)| unit))
    }

    /// Checks that both sides have the same unit.
    ///
    /// # Errors
    /// Both units, or what is wrong with a side.
    pub fn same(&self, left: &Expression, right: &Expression) -> Result<(), String> {
        match (self.of(left)?, self.of(right)?) {
            (Some(one), Some(other)) if one != other => {
                Err(format!("'{left}' is {one} and '{right}' is {other}"))
            }
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn units() -> Units {
        let listed = [("A", "Pa"), ("L", "m"), ("V", "m/s"), ("K", "Pa/m"), ("M", "kg/m^2")];
        Units(
            listed.map(|(name, unit)| (Symbol::from(name), Some(Dimension::read(unit).expect(unit)))).into(),
            BTreeMap::new(),
        )
    }

    fn of(text: &str) -> String {
        let found = units().of(&text.parse().expect("in the grammar"));
        found.map_or_else(|error| error, |found| found.map_or("any".to_owned(), |found| found.to_string()))
    }

    #[test]
    fn units_follow_from_those_of_the_variables() {
        for (text, unit) in [
            ("A/(K*L)", "1"),
            ("M*V^2/L", "kg m^-1 s^-2"),
            ("sqrt(K/M) + V/L", "s^-1"),
            ("sqrt(A)", "kg^1/2 m^-1/2 s^-1"),
            ("V' - 0", "m s^-2"),
            ("A*ln(V/(L*sqrt(K/M)))", "kg m^-1 s^-2"),
            ("0", "any"),
            ("abs(-A) + 0*L", "kg m^-1 s^-2"),
        ] {
            assert_eq!(of(text), unit, "{text}");
        }
        assert_eq!(Dimension::read("N*s^2/m"), Dimension::read("kg"));
        assert_eq!(Dimension::read("J/Pa*Hz"), Dimension::read("m^3/s"));
    }

    #[test]
    fn what_does_not_fit_is_named_with_both_units() {
        assert_eq!(of("A + K*L + V"), "in 'A + K*L + V', 'A' is kg m^-1 s^-2 and 'V' is m s^-1");
        assert_eq!(of("ln(V)"), "the argument of ln(V) is m s^-1, and must be 1");
        assert_eq!(of("q"), "'q' has no unit");
        let sides = ["K*L", "V"].map(|text| text.parse::<Expression>().expect("in the grammar"));
        assert_eq!(
            units().same(&sides[0], &sides[1]),
            Err("'K*L' is kg m^-1 s^-2 and 'V' is m s^-1".to_owned())
        );
        assert!(Dimension::read("kg*mm").expect_err("mm").contains("'mm' is no unit"));
        assert!(Dimension::read("m^x").is_err() && Dimension::read("").is_err());
    }
}
