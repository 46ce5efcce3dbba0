//! The grammar of formulas: every fault has the column at which it was found.

use slipmode_algebra::{Comparison, End, Expression, Source, Symbol, Toward};
use slipmode_theory::root_location::RootStatement;

use super::{Crossing, Formula, Statement};
use crate::scene::claim_names::Names;

/// The most words, brackets and comparisons of one formula.
const MOST_PIECES: usize = 200;

/// The deepest nesting of groups and negations.
const MOST_DEPTH: usize = 32;

/// What a formula may consist of.
const FORMS: &str = "a formula has '=', '!=', '<', '>', '<=' or '>=' once between two sides, or a predicate such as stable(P, s), \
                     joined by 'not', 'and', 'or', 'implies' and 'iff'; or it has '->', 'rises with', 'falls with', 'depends on' or \
                     'does not depend on'";

const CROSSING: &str = "pair_crosses";

/// Reads a whole statement.
pub(super) fn statement(text: &str, names: &Names) -> Result<Statement, String> {
    let reader = Reader::new(text, names);
    let side = |part| reader.side(part);
    let name = |part| reader.variable(part);
    if let Some((left, rest)) = text.split_once("->") {
        let form = "a limit has the form `side -> side as name -> 0` or `-> infinity`, where the second side may be infinity or -infinity";
        let (value, rest) = rest.split_once(" as ").ok_or(form)?;
        let (variable, end) = rest.split_once("->").ok_or(form)?;
        let toward = match end.trim() {
            "0" => Toward::Zero,
            "infinity" => Toward::Infinity,
            _ => return Err(form.into()),
        };
        let value = match value.trim() {
            "infinity" => End::Infinite(1),
            "-infinity" => End::Infinite(-1),
            value => End::Finite(side(value)?),
        };
        return Ok(Statement::Limit(side(left)?, value, name(variable)?, toward));
    }
    for (word, comparison) in [(" rises with ", Comparison::Greater), (" falls with ", Comparison::Less)] {
        if let Some((expression, variable)) = text.split_once(word) {
            return Ok(Statement::Monotone(side(expression)?, comparison, name(variable)?));
        }
    }
    for (words, depends) in [(" does not depend on ", false), (" depends on ", true)] {
        if let Some((expression, variable)) = text.split_once(words) {
            return Ok(Statement::Depends(side(expression)?, depends, name(variable)?));
        }
    }
    let mut pieces = pieces(text);
    if pieces.len() > MOST_PIECES {
        return Err(format!("longer than {MOST_PIECES} words, brackets and comparisons"));
    }
    pieces.reverse();
    let mut parser = Parser { reader, rest: pieces, depth: 0 };
    let formula = parser.iff()?;
    match parser.rest.last() {
        None => Ok(Statement::True(formula)),
        Some(piece) => Err(reader.fault(piece, format!("unexpected '{piece}'"))),
    }
}

/// The two sides of the one comparison in a text.
pub(super) fn compared(text: &str, names: &Names) -> Result<(Expression, Comparison, Expression), String> {
    Reader::new(text, names).comparison(text)
}

/// An expression in known names.
pub(in crate::scene) fn read_side(text: &str, names: &Names) -> Result<Expression, String> {
    Reader::new(text, names).side(text)
}

/// The name of a variable.
pub(in crate::scene) fn read_variable(text: &str, names: &Names) -> Result<Symbol, String> {
    Reader::new(text, names).variable(text)
}

/// The words that join, the brackets, and the texts between them.
fn pieces(text: &str) -> Vec<&str> {
    let in_name = |c: char| c.is_alphanumeric() || c == '_' || c == '\'';
    let (mut found, mut between, mut at) = (Vec::new(), 0, 0);
    while let Some(first) = text[at..].chars().next() {
        let name = text[at..].find(|c| !in_name(c)).unwrap_or(text.len() - at);
        let end = at + name.max(first.len_utf8());
        if ["not", "and", "or", "implies", "iff", "[", "]"].contains(&&text[at..end]) {
            found.extend([&text[between..at], &text[at..end]]);
            between = end;
        }
        at = end;
    }
    found.push(&text[between..]);
    found.into_iter().map(str::trim).filter(|piece| !piece.is_empty()).collect()
}

/// Recursive descent over the pieces, of which the next one is last.
struct Parser<'t> {
    reader: Reader<'t>,
    rest: Vec<&'t str>,
    depth: usize,
}

impl Parser<'_> {
    fn take(&mut self, word: &str) -> bool {
        self.rest.pop_if(|next| *next == word).is_some()
    }

    fn iff(&mut self) -> Result<Formula, String> {
        let left = self.implied()?;
        Ok(match self.take("iff") {
            true => Formula::Iff(Box::new([left, self.implied()?])),
            false => left,
        })
    }

    fn implied(&mut self) -> Result<Formula, String> {
        let left = self.either()?;
        Ok(match self.take("implies") {
            true => Formula::Implies(Box::new([left, self.either()?])),
            false => left,
        })
    }

    fn either(&mut self) -> Result<Formula, String> {
        let mut parts = vec![self.both()?];
        while self.take("or") {
            parts.push(self.both()?);
        }
        Ok(if parts.len() == 1 { parts.remove(0) } else { Formula::Any(parts) })
    }

    fn both(&mut self) -> Result<Formula, String> {
        let mut parts = vec![self.negated()?];
        while self.take("and") {
            parts.push(self.negated()?);
        }
        Ok(if parts.len() == 1 { parts.remove(0) } else { Formula::All(parts) })
    }

    fn negated(&mut self) -> Result<Formula, String> {
        self.depth += 1;
        if self.depth > MOST_DEPTH {
            return Err(format!("nested deeper than {MOST_DEPTH} levels"));
        }
        let formula = match self.rest.pop() {
            Some("not") => Formula::Not(Box::new(self.negated()?)),
            Some("[") => {
                let inner = self.iff()?;
                if !self.take("]") {
                    return Err(self.reader.fault(self.rest.last().unwrap_or(&""), "expected ']'"));
                }
                inner
            }
            Some(word @ ("and" | "or" | "implies" | "iff" | "]")) => {
                return Err(self.reader.fault(word, format!("expected a formula, found '{word}'")));
            }
            Some(atom) => self.reader.atom(atom)?,
            None => return Err(self.reader.fault("", "expected a formula, found the end")),
        };
        self.depth -= 1;
        Ok(formula)
    }
}

/// Reads parts of a text.
#[derive(Clone, Copy)]
struct Reader<'t> {
    source: Source<'t>,
    names: &'t Names,
}

impl<'t> Reader<'t> {
    fn new(text: &'t str, names: &'t Names) -> Self {
        Self { source: Source::new(text).with_functions(names.functions()), names }
    }

    fn fault(&self, part: &str, message: impl AsRef<str>) -> String {
        format!("column {}: {}", self.source.column(part), message.as_ref())
    }

    fn atom(&self, text: &str) -> Result<Formula, String> {
        let (word, arguments) = Source::call(text);
        let statement = RootStatement::from_word(word);
        if statement.is_none() && word != CROSSING {
            let predicates = RootStatement::ALL.map(RootStatement::as_str).into_iter().chain([CROSSING]);
            if let Some(word) = predicates.into_iter().find(|word| text.contains(&format!("{word}("))) {
                return Err(
                    self.fault(text, format!("{word}(...) is true or false and has no value to compare"))
                );
            }
            let (left, comparison, right) = self.comparison(text)?;
            return Ok(Formula::Compare(left, comparison, right));
        }
        let arguments = arguments.ok_or_else(|| {
            let alone = format!("{word}(...) stands alone: it is true or false and has no value to compare");
            self.fault(text, alone)
        })?;
        match (statement, &arguments[..]) {
            (Some(statement), [polynomial, variable]) => {
                let variable = self.free(variable)?;
                Ok(Formula::Roots(statement, self.side_in(polynomial, Some(&variable))?, variable))
            }
            (None, [polynomial, variable, parameter, critical, frequency]) => {
                let (variable, parameter) = (self.free(variable)?, self.variable(parameter)?);
                let polynomial = self.side_in(polynomial, Some(&variable))?;
                let [critical, frequency] = [critical, frequency].map(|part| self.side(part));
                let (critical, frequency) = (critical?, frequency?);
                let crossing = Crossing { polynomial, variable, parameter, critical, frequency };
                Ok(Formula::Crossing(Box::new(crossing)))
            }
            (_, given) => {
                let known = if statement.is_some() { "(P, s) has 2" } else { "(P, s, K, K_c, omega) has 5" };
                Err(self.fault(text, format!("{word}{known} arguments, not {}", given.len())))
            }
        }
    }

    fn comparison(&self, text: &str) -> Result<(Expression, Comparison, Expression), String> {
        match Source::comparisons(text)[..] {
            [(left, comparison, right)] => Ok((self.side(left)?, comparison, self.side(right)?)),
            [] => Err(self.fault(text, FORMS)),
            [_, (before, ..), ..] => Err(self.fault(&text[before.len()..], FORMS)),
        }
    }

    fn side(&self, part: &str) -> Result<Expression, String> {
        self.side_in(part, None)
    }

    /// An expression in known names and in one more.
    fn side_in(&self, part: &str, own: Option<&Symbol>) -> Result<Expression, String> {
        let part = part.trim();
        let (expression, _) = self
            .source
            .expression(part)
            .map_err(|error| format!("column {}: '{part}': {}", error.column, error.message))?;
        let unknown = |name: &&Symbol| !self.names.has(name) && Some(*name) != own;
        match expression.variables().iter().find(unknown) {
            Some(unknown) => Err(self.fault(part, self.names.refusal(unknown.as_str()))),
            None => Ok(expression),
        }
    }

    fn variable(&self, part: &str) -> Result<Symbol, String> {
        let part = part.trim();
        let name = part.parse().ok().filter(|name| self.names.variables().contains(name));
        name.ok_or_else(|| self.fault(part, self.names.refusal(part)))
    }

    /// A name for the roots: nothing may be assumed of it.
    fn free(&self, part: &str) -> Result<Symbol, String> {
        let part = part.trim();
        match part.parse::<Symbol>() {
            Ok(name) if self.names.is_positive(&name) => {
                Err(self
                    .fault(part, format!("{name} is positive by assumption; the roots may have any value")))
            }
            Ok(name) if self.names.functions().contains(&name.undifferentiated()) => {
                Err(self.fault(part, format!("{part} is a function, and no name for the roots")))
            }
            Ok(name) if !["i", "pm"].contains(&name.as_str()) => Ok(name),
            _ => Err(self.fault(part, format!("'{part}' is no name for the roots"))),
        }
    }
}
