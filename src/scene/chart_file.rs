//! `charts/NAME.toml`: a chart of what the equations of a report say, along one variable or over two.

use std::collections::BTreeMap;

use slipmode_algebra::{Domain, Expression, Literal, Symbol};
use slipmode_core::number::format::round_digits;
use slipmode_core::number::{Rational, nearest_f64, parse_decimal};
use slipmode_plot::figure::{Axis, Caption, Scale};
use slipmode_theory::Equations;
use slipmode_theory::root_location::{MOST_DEGREE, coefficients};

use crate::scene::claim_formula::grammar::{read_side, read_variable};
use crate::scene::claim_names::Names;
use crate::scene::claim_scope::number;
use crate::scene::document::read_document;
use crate::scene::report_plan::distinct_name;
use crate::scene::section::{Entry, Section};
use crate::scene::sections::NAME_RULE;
use crate::scene::{Faults, FormulaCondition, Limits, LogAxis, Problem};

/// A chart of equations.
#[derive(Debug, Clone)]
pub struct EquationChart {
    /// Id, title and description; the id is the name of the file, of the figure and of the table with the numbers.
    pub caption: Caption,
    /// What it shows and what to look at, in Markdown.
    pub caption_markdown: String,
    /// The variable along the horizontal axis.
    pub x: Sampled,
    /// The vertical axis.
    pub y: Axis,
    /// Lines whose height is the value of an expression.
    pub lines: Vec<ChartLine>,
    /// What the plane below the lines shows, if anything.
    pub map: Option<ChartMap>,
}

/// An axis with the values of a variable at which something is computed.
#[derive(Debug, Clone)]
pub struct Sampled {
    /// The variable.
    pub variable: Symbol,
    /// Its axis.
    pub axis: Axis,
    /// Its values, ascending: decimals of few digits, so that exact arithmetic is fast.
    pub values: Vec<Rational>,
}

/// A line of a chart.
#[derive(Debug, Clone)]
pub struct ChartLine {
    /// The name of its column in the table.
    pub column: String,
    /// Its name in the legend, in figure markup.
    pub label: String,
    /// Its height, in the variable of the horizontal axis alone.
    pub value: Expression,
    /// Where it has a value, in the same variable.
    pub given: Vec<Literal>,
}

/// Where the roots of a polynomial lie, over the plane of two variables.
#[derive(Debug, Clone)]
pub struct ChartMap {
    /// The variable along the vertical axis.
    pub y: Sampled,
    /// The coefficients of the polynomial by ascending power, in the variables of both axes.
    pub coefficients: Vec<Expression>,
    /// Where the polynomial is defined, in the same variables.
    pub given: Vec<Literal>,
}

/// Reads a chart. Without sound equations, its expressions cannot be read, and no chart comes back.
///
/// # Errors
/// All the faults at once.
pub fn read_chart(
    file: &str,
    bytes: &[u8],
    limits: &Limits,
    id: &str,
    equations: Option<&Equations>,
) -> Result<Option<EquationChart>, Faults> {
    let Some(equations) = equations else { return Ok(None) };
    let reader = Reader { names: Names::of(equations), equations };
    read_document(file, bytes, *limits, |top| reader.chart(top, id)).map(Some)
}

/// What is known while a chart is read.
struct Reader<'e> {
    names: Names,
    equations: &'e Equations,
}

/// The values of variables that no axis has.
type Values = BTreeMap<Symbol, Expression>;

impl Reader<'_> {
    fn chart(&self, top: &mut Section<'_>, id: &str) -> Option<EquationChart> {
        let [title, caption, description] =
            ["title", "caption", "description"].map(|key| top.text(key, "a text"));
        let values = top.optionally("values", |entry| self.values(entry, &Values::new()));
        let x = top.required("x", SAMPLED).and_then(|entry| self.sampled(&entry));
        let map = top.optional("map");
        let y = top.required("y", if map.is_some() { SAMPLED } else { "[y] with title, from and to" });
        let lines = top.optional("line");
        if lines.is_none() && map.is_none() {
            top.fault("line", Problem::Missing { allowed: "[[line]] sections, or [map]".into() });
        }
        let (values, x, y) = (values.unwrap_or_default(), x?, y?);
        let (y, map) = match &map {
            None => (y.table(axis)??.0, None),
            Some(entry) => {
                let map = self.map(entry, &values, &x, self.sampled(&y)?)?;
                (map.y.axis.clone(), Some(map))
            }
        };
        let taken = map.iter().flat_map(|map| [map.y.variable.as_str()].into_iter().chain(COUNTS));
        let mut earlier = [x.variable.as_str()].into_iter().chain(taken).map(str::to_owned).collect();
        let lines = lines.map_or(Some(Vec::new()), |entry| {
            entry.list(|member| self.line(member, &values, &x.variable, &mut earlier))
        })?;
        self.check_units(top, &lines, map.as_ref())?;
        Some(EquationChart {
            caption: Caption::new(id, &title, &description),
            caption_markdown: caption,
            x,
            y,
            lines: lines.into_iter().map(|(line, _)| line).collect(),
            map,
        })
    }

    /// Values of variables, together with those of the whole chart.
    fn values(&self, entry: &Entry<'_>, of_chart: &Values) -> Option<Values> {
        let own = entry.members(|name, member| {
            let name = member.equation(read_variable(name, &self.names));
            let (name, value) = (name?, number(member)?);
            self.check_sign(member, &name, &value)?;
            Some((name, Expression::Number(value)))
        })?;
        Some(of_chart.clone().into_iter().chain(own).collect())
    }

    fn check_sign(&self, entry: &Entry<'_>, name: &Symbol, value: &Rational) -> Option<()> {
        match self.names.is_positive(name) && *value <= 0 {
            true => entry.refuse(Problem::NotPositive { allowed: format!("{name} > 0 by assumption") }),
            false => Some(()),
        }
    }

    /// An axis with the values of its variable.
    fn sampled(&self, entry: &Entry<'_>) -> Option<Sampled> {
        let (variable, points, axis) = entry.table(|section| {
            let variable = section.required("variable", "the name of a variable");
            let variable =
                variable.and_then(|entry| entry.equation(read_variable(&entry.text()?, &self.names)));
            let points: u32 = section.whole("points", 2..=MOST_POINTS);
            (variable, points, axis(section))
        })?;
        let (variable, (axis, from, to)) = (variable?, axis?);
        self.check_sign(entry, &variable, &from)?;
        let values = match axis.scale {
            Scale::Log10 => LogAxis { from, to, points }.coordinates(),
            _ => {
                let width = Rational::from(&to - &from) / (points - 1);
                (0..points).map(|index| nearest_f64(&(width.clone() * index + &from))).collect()
            }
        };
        Some(Sampled { variable, axis, values: short_decimals(&values) })
    }

    /// An expression as it is written; its value with the values put in, which may have these variables alone; and where it has one.
    fn put_in(
        &self,
        entry: &Entry<'_>,
        values: &Values,
        variables: &[&Symbol],
    ) -> Option<(Expression, Expression, Vec<Literal>)> {
        let read = entry.equation(read_side(&entry.text()?, &self.names))?;
        let put = |one: &Expression| self.names.resolved(one).substitute(values);
        let of_definitions = self.names.given_of(&read).into_iter();
        let of_definitions =
            of_definitions.map(|one| Literal::new(put(&one.expression), one.relation.into()));
        let of_file = self.equations.conditions().iter();
        let of_file = of_file.filter_map(|text| FormulaCondition::read(text, &self.names).ok());
        let of_file =
            of_file.map(|one| one.literal()).map(|one| Literal::new(put(&one.expression), one.sign));
        let (value, given) = (put(&read), of_definitions.chain(of_file).collect::<Vec<_>>());
        if let Some(function) = value.functions().first() {
            return entry.equation(Err(format!("{function} is a function without values")));
        }
        let all = std::iter::once(&value).chain(given.iter().map(|one| &one.expression));
        let open = all.flat_map(Expression::variables).find(|name| !variables.contains(&name));
        match open {
            Some(name) => entry.needs(format!("a value for {name} in `values`")),
            None => Some((read, value, given)),
        }
    }

    /// A line, with its expression as written.
    fn line(
        &self,
        entry: &Entry<'_>,
        values: &Values,
        x: &Symbol,
        earlier: &mut Vec<String>,
    ) -> Option<(ChartLine, Expression)> {
        let (column, label, own, is) = entry.table(|section| {
            let column = section.read("column", NAME_RULE, |entry| distinct_name(entry, earlier));
            let label = section.text("label", "a text");
            let own = section.optionally("values", |entry| self.values(entry, values));
            (column, label, own, section.required("is", "an expression"))
        })?;
        let (written, value, given) = self.put_in(&is?, own.as_ref().unwrap_or(values), &[x])?;
        Some((ChartLine { column, label, value, given }, written))
    }

    fn map(&self, entry: &Entry<'_>, values: &Values, x: &Sampled, y: Sampled) -> Option<ChartMap> {
        let keys = [("polynomial", "an expression"), ("roots", "the name of its roots, such as \"s\"")];
        let [polynomial, roots] =
            entry.table(|section| keys.map(|(key, allowed)| section.required(key, allowed)))?;
        let (polynomial, roots) = (polynomial?, roots?);
        let root = roots.equation(read_variable(&roots.text()?, &self.names))?;
        entry.check_points(x.values.len() as u64 * y.values.len() as u64)?;
        let variables = [&x.variable, &y.variable, &root];
        let (_, value, given) = self.put_in(&polynomial, values, &variables)?;
        let domain = Domain::of_positive(self.names.positive().iter().cloned());
        let function = domain.rational_function(&value).ok();
        let plain = function.filter(|one| one.generators().iter().all(|one| one.symbol().is_some()));
        match plain.and_then(|one| coefficients(&one, &root, MOST_DEGREE)) {
            Some(coefficients) => Some(ChartMap { y, coefficients, given }),
            None => polynomial.needs(format!(
                "a polynomial in {root} of degree 1 to {MOST_DEGREE} with rational coefficients"
            )),
        }
    }

    /// Lines have one unit; over a map it is that of its vertical axis.
    fn check_units(
        &self,
        top: &Section<'_>,
        lines: &[(ChartLine, Expression)],
        map: Option<&ChartMap>,
    ) -> Option<()> {
        let vertical = map.map(|map| Expression::variable(&map.y.variable));
        let mut all = vertical.iter().chain(lines.iter().map(|(_, written)| written));
        let first = all.next()?;
        match all.find_map(|other| self.names.same_units(first, other).err()) {
            Some(message) => {
                top.fault("line", Problem::Equation(message));
                None
            }
            None => Some(()),
        }
    }
}

/// What an axis with a variable has.
const SAMPLED: &str = "a table with variable, title, from, to and points";

/// The columns of the table of a map, besides its variables and its lines.
const COUNTS: [&str; 4] = ["roots_right", "roots_on_axis", "real_roots", "mode"];

/// The most points along an axis.
const MOST_POINTS: u64 = 2000;

/// An axis and its ends.
fn axis(section: &mut Section<'_>) -> Option<(Axis, Rational, Rational)> {
    let title = section.text("title", "a text");
    let unit = section.optionally("unit", Entry::text).unwrap_or_default();
    let is_linear = section.optionally("linear", Entry::truth) == Some(true);
    let [from, to] = ["from", "to"].map(|key| section.required(key, "a number"));
    let ends = [from?, to?].map(|entry| number(&entry).map(|value| (entry, value)));
    let [Some((first, from)), Some((_, to))] = ends else { return None };
    if from >= to {
        return first.refuse(if from == to { Problem::EmptyRange } else { Problem::ReversedRange });
    }
    if from <= 0 && !is_linear {
        return first.refuse(Problem::NotPositive { allowed: "from > 0, or `linear = true`".into() });
    }
    let make = if is_linear { Axis::linear } else { Axis::log10 };
    Some((make(&title, &unit, nearest_f64(&from), nearest_f64(&to)), from, to))
}

/// The values with as few digits as keep them apart, four at least.
fn short_decimals(values: &[f64]) -> Vec<Rational> {
    let decimal = |text: &str| parse_decimal(text).unwrap_or_default();
    let rounded =
        |digits| values.iter().map(|&value| decimal(&round_digits(value, digits))).collect::<Vec<_>>();
    let mut all = (4..=17).map(rounded);
    all.find(|values| values.is_sorted_by(|one, next| one < next)).unwrap_or_else(|| rounded(17))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::read_equations;

    const EQUATIONS: &str = "[assumptions]\npositive = [\"k\", \"m\", \"x\"]\nfree = [\"d\", \"s\"]\n\
        [units]\nk = \"N/m\"\nm = \"kg\"\nd = \"kg/s\"\nx = \"1\"\ns = \"1/s\"\n\
        [[equation]]\nnumber = \"1\"\nequation = \"omega = sqrt(k/m)\"\nnote = \"N.\"\n\
        [[equation]]\nnumber = \"2\"\nequation = \"tau = m/d\"\ngiven = [\"d > 0\"]\nnote = \"N.\"\n\
        [[definition]]\nname = \"P\"\nis = \"m*s^2 + d*s + k\"\n";

    const LINES: &str = "title = \"T\"\ncaption = \"C.\"\ndescription = \"D\"\nvalues = { m = 4 }\n\
        [x]\nvariable = \"k\"\ntitle = \"K\"\nfrom = 1\nto = 100\npoints = 3\n\
        [y]\ntitle = \"Frequency\"\nunit = \"1/s\"\nfrom = 0.1\nto = 10\n\
        [[line]]\ncolumn = \"first\"\nlabel = \"one\"\nis = \"omega\"\n\
        [[line]]\ncolumn = \"second\"\nlabel = \"two\"\nis = \"2*omega\"\nvalues = { m = \"1/4\" }\n";

    const MAP: &str = "title = \"T\"\ncaption = \"C.\"\ndescription = \"D\"\nvalues = { m = 1 }\n\
        [x]\nvariable = \"d\"\ntitle = \"D\"\nlinear = true\nfrom = -1\nto = 1\npoints = 3\n\
        [y]\nvariable = \"k\"\ntitle = \"K\"\nfrom = 1\nto = 100\npoints = 3\n\
        [map]\npolynomial = \"P\"\nroots = \"s\"\n";

    const LINED_MAP: &str = "title = \"T\"\ncaption = \"C.\"\ndescription = \"D\"\nvalues = { m = 1 }\n\
        [x]\nvariable = \"d\"\ntitle = \"D\"\nfrom = 1\nto = 10\npoints = 3\n\
        [y]\nvariable = \"k\"\ntitle = \"K\"\nfrom = 1\nto = 100\npoints = 3\n\
        [map]\npolynomial = \"P\"\nroots = \"s\"\n\
        [[line]]\ncolumn = \"h\"\nlabel = \"H\"\nis = \"d^2/(4*m)\"\n";

    fn read(text: &str) -> Result<EquationChart, String> {
        let equations = read_equations("equations.toml", EQUATIONS.as_bytes()).expect("equations");
        read_chart("c.toml", text.as_bytes(), &Limits::default(), "c", Some(&equations))
            .map(|chart| chart.expect("sound equations"))
            .map_err(|faults| faults.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))
    }

    #[test]
    fn values_are_put_in_and_each_line_may_have_its_own() {
        let chart = read(LINES).unwrap();
        assert_eq!(chart.x.values, [1, 10, 100]);
        let at = [("k".parse().unwrap(), Rational::from(16))].into();
        let values: Vec<_> = chart.lines.iter().map(|line| line.value.rational_value(&at)).collect();
        assert_eq!(values, [Some(Rational::from(2)), Some(Rational::from(16))]);
        let map = read(MAP).unwrap();
        assert_eq!(
            (map.x.values, map.map.unwrap().coefficients.len()),
            ([-1, 0, 1].map(Rational::from).to_vec(), 3)
        );
    }

    #[test]
    fn every_fault_is_named_with_its_key() {
        for (text, from, to, named) in [
            (LINES, "m = 4", "q = 4", "values.q"),
            (LINES, "m = 4", "m = 0", "m > 0 by assumption"),
            (LINES, "values = { m = 4 }\n", "", "line[1].is = \"omega\": needs a value for m in `values`"),
            (LINES, "\"2*omega\"", "\"2*omaga\"", "did you mean `omega`"),
            (LINES, "\"2*omega\"", "\"m\"", "line"),
            (LINES, "\"second\"", "\"FIRST\"", "line[2].column"),
            (LINES, "\"second\"", "\"k\"", "line[2].column"),
            (LINES, "from = 0.1", "from = 10", "y.from"),
            (LINES, "from = 0.1", "from = 0", "`linear = true`"),
            (LINES, "points = 3", "points = 1", "x.points"),
            (LINES, "variable = \"k\"", "variable = \"omega\"", "x.variable"),
            (LINES, "\"omega\"", "\"tau\"", "needs a value for d"),
            (&LINES[..LINES.find("[[line]]").unwrap()], "C.", "C.", "line: missing"),
            (MAP, "\"P\"", "\"omega + s\"", "map.polynomial"),
            (MAP, "\"P\"", "\"k\"", "a polynomial in s of degree 1 to 6"),
            (MAP, "roots = \"s\"", "roots = \"q\"", "map.roots"),
            (MAP, "from = 1\n", "from = -1\n", "y.from"),
            (MAP, "points = 3\n[map]", "[map]", "y.points: missing"),
            (MAP, "[map]", "[mapp]", "mapp"),
            (LINED_MAP, "\"h\"", "\"mode\"", "line[1].column"),
            (LINED_MAP, "\"h\"", "\"k\"", "line[1].column"),
        ] {
            assert!(text.contains(from), "{from}");
            let faults = read(&text.replacen(from, to, 1)).unwrap_err();
            assert!(faults.contains(named), "{faults} for {named}");
        }
    }
}
