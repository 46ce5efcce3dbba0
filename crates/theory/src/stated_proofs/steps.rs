//! The steps of a proof.

use std::collections::BTreeSet;

use slipmode_algebra::{Certificate, Domain, Expression, Proof, Refutation, Symbol, Toward};

use super::super::derivation::read_name;
use super::domain::{DomainForm, Equal, read_equal};
use super::names::{Form, Named, OF_SYSTEM};
use super::{Faults, StepText};

/// A step, parsed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct StepForm {
    pub says: String,
    pub over: String,
    pub besides: DomainForm,
    kind: Kind,
}

/// What a step states.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Kind {
    Identity(Form, Form),
    Sign(Form, i8),
    Root {
        of: Form,
        variable: Symbol,
        between: [Option<Form>; 2],
    },
    Limit {
        of: Form,
        variable: Symbol,
        toward: Toward,
        value: Form,
    },
    Growth {
        of: Form,
        variable: Symbol,
        order: u32,
    },
    Connected(Vec<Equal>),
    Value {
        of: Form,
        at: Vec<Equal>,
        value: Form,
    },
    Difference {
        sides: [Form; 2],
        at: Vec<Equal>,
        values: [Form; 2],
    },
    Argued,
    /// The steps of a block, or a lemma.
    Of(String),
}

impl StepForm {
    pub fn read(text: &StepText, faults: &mut Faults) -> Self {
        let kinds: Vec<Result<Kind, String>> = [
            text.identity.as_deref().map(read_identity),
            text.positive.as_deref().map(|text| Ok(Kind::Sign(read(text)?, 1))),
            text.negative.as_deref().map(|text| Ok(Kind::Sign(read(text)?, -1))),
            text.root.as_ref().map(|root| {
                let end = |text: &Option<String>| text.as_deref().map(read).transpose();
                let between = [end(&root.above)?, end(&root.below)?];
                Ok(Kind::Root { of: read(&root.of)?, variable: variable(&root.variable)?, between })
            }),
            text.limit.as_ref().map(|limit| {
                let toward = Toward::from_word(&limit.to)
                    .ok_or_else(|| format!("to = '{}' (allowed: 0 or infinity)", limit.to))?;
                let (of, value) = (read(&limit.of)?, read(&limit.is)?);
                Ok(Kind::Limit { of, variable: variable(&limit.variable)?, toward, value })
            }),
            text.growth.as_ref().map(|growth| {
                let variable = variable(&growth.variable)?;
                Ok(Kind::Growth { of: read(&growth.of)?, variable, order: growth.order })
            }),
            text.connected.as_ref().map(|image| read_point(image).map(Kind::Connected)),
            text.value.as_ref().map(|value| {
                let at = read_point(&value.at)?;
                Ok(Kind::Value { of: read(&value.of)?, at, value: read(&value.is)? })
            }),
            text.difference.as_ref().map(|difference| {
                let at = read_point(&difference.at)?;
                let sides = [read(&difference.left)?, read(&difference.right)?];
                let [left, right] = &difference.are;
                Ok(Kind::Difference { sides, at, values: [read(left)?, read(right)?] })
            }),
            text.argued.then_some(Ok(Kind::Argued)),
            text.block.as_ref().or(text.lemma.as_ref()).map(|name| Ok(Kind::Of(name.clone()))),
        ]
        .into_iter()
        .flatten()
        .collect();
        let kind = match <[_; 1]>::try_from(kinds) {
            Ok([kind]) => faults.keep(kind),
            Err(kinds) => {
                let allowed = "identity, positive, negative, root, limit, growth, connected, value, difference, argued, block or lemma";
                faults.add(format!("it has {} kinds (allowed: one of {allowed})", kinds.len()));
                None
            }
        };
        let besides = faults.under("where", |faults| DomainForm::read(&text.besides, faults));
        let kind = kind.unwrap_or(Kind::Argued);
        if text.says.is_empty() && !matches!(kind, Kind::Of(_)) {
            faults.add("`says` is missing".to_owned());
        }
        Self { says: text.says.clone(), over: text.over.clone(), besides, kind }
    }

    /// The block or the lemma whose steps stand here.
    pub fn refers_to(&self) -> Option<&str> {
        match &self.kind {
            Kind::Of(name) => Some(name),
            _ => None,
        }
    }

    /// The names in it, and in what it assumes besides.
    pub fn names(&self) -> BTreeSet<Symbol> {
        let forms: Vec<&Form> = match &self.kind {
            Kind::Identity(left, right) => vec![left, right],
            Kind::Sign(of, _) | Kind::Growth { of, .. } => vec![of],
            Kind::Root { of, between, .. } => std::iter::once(of).chain(between.iter().flatten()).collect(),
            Kind::Limit { of, value, .. } | Kind::Value { of, value, .. } => vec![of, value],
            Kind::Difference { sides, values, .. } => sides.iter().chain(values).collect(),
            Kind::Connected(_) | Kind::Argued | Kind::Of(_) => Vec::new(),
        };
        let expressions = self.listed().iter().map(|(_, value)| value).chain(self.besides.values());
        let expressions = expressions.flat_map(Expression::variables);
        forms.into_iter().flat_map(Form::names).chain(expressions).collect()
    }

    /// The values of the point or of the image that the step is about; none for others.
    fn listed(&self) -> &[Equal] {
        match &self.kind {
            Kind::Connected(list) | Kind::Value { at: list, .. } | Kind::Difference { at: list, .. } => list,
            _ => &[],
        }
    }

    /// The proof with this step.
    ///
    /// # Errors
    /// When it does not hold.
    pub fn add(&self, proof: Proof, named: &Named<'_>) -> Result<Proof, Refutation> {
        if self.kind == Kind::Argued {
            return Ok(proof.reason(&self.says));
        }
        let (certificate, numbers) = self
            .certificate(named)
            .map_err(|reason| proof.refute(&self.says, &named.numbers_behind(&self.names()), reason))?;
        let numbers: Vec<&str> = numbers.iter().map(String::as_str).collect();
        proof.certify(&self.says, &numbers, certificate)
    }

    fn certificate(&self, named: &Named<'_>) -> Result<(Certificate, Vec<String>), String> {
        let domain = self.domain(named)?;
        let mut behind = BTreeSet::new();
        for value in self.besides.values() {
            behind.extend(named.meant(value)?.1);
        }
        let mut listed = Vec::new();
        for (name, value) in self.listed() {
            let (value, numbers) = named.meant(value)?;
            behind.extend(numbers);
            listed.push((name.clone(), value));
        }
        let mut meant = |form: &Form| {
            let (value, numbers) = named.formed(form)?;
            behind.extend(numbers);
            Ok::<_, String>(value)
        };
        let certificate = match &self.kind {
            Kind::Identity(left, right) => {
                Certificate::Identity { left: meant(left)?, right: meant(right)?, domain }
            }
            Kind::Sign(of, sign) => Certificate::Sign { expression: meant(of)?, sign: *sign, domain },
            Kind::Root { of, variable, between: [above, below] } => {
                let mut end = |end: &Option<Form>| end.as_ref().map(&mut meant).transpose();
                let between = [end(above)?, end(below)?];
                Certificate::Root { polynomial: meant(of)?, variable: variable.clone(), between, domain }
            }
            Kind::Limit { of, variable, toward, value } => {
                let (expression, value) = (meant(of)?, meant(value)?);
                Certificate::Limit { expression, variable: variable.clone(), toward: *toward, value, domain }
            }
            Kind::Growth { of, variable, order } => {
                let (expression, variable) = (meant(of)?, variable.clone());
                Certificate::Growth { expression, variable, order: *order, domain }
            }
            Kind::Connected(_) => Certificate::Connected { image: listed, domain },
            Kind::Value { .. } | Kind::Difference { .. } if !is_inside(&domain, &listed) => {
                return Err("the point is outside of what is assumed".to_owned());
            }
            Kind::Value { of, value, .. } => {
                Certificate::Value { expression: meant(of)?, point: listed, value: meant(value)? }
            }
            Kind::Difference { sides: [left, right], values: [before, after], .. } => {
                let (left, right) = (meant(left)?, meant(right)?);
                let values = [meant(before)?, meant(after)?];
                Certificate::Difference { left, right, point: listed, values }
            }
            Kind::Argued | Kind::Of(_) => return Err("it states nothing that can be computed".to_owned()),
        };
        Ok((certificate, named.in_order(&behind)))
    }

    /// What the step assumes: its own domain or that of the proof, and what it adds.
    fn domain(&self, named: &Named<'_>) -> Result<Domain, String> {
        let over = if self.over.is_empty() { &named.proof.over } else { &self.over };
        self.besides.add_to(named.all.domain(over, named)?, named)
    }
}

/// Whether a point meets every assumption on its coordinates.
fn is_inside(domain: &Domain, point: &[Equal]) -> bool {
    let has = |name: &Symbol| point.iter().any(|(known, _)| known == name);
    let positive = point.iter().map(|(name, _)| name.clone()).filter(|name| domain.is_positive(name));
    let met = domain.conditions().iter().filter(|one| one.expression.variables().iter().all(has));
    let bare =
        met.fold(Domain::of_positive(positive), |bare, one| bare.given(one.expression.clone(), one.relation));
    point.iter().fold(bare, |bare, (name, value)| bare.example(name.clone(), value.clone())).check().is_ok()
}

fn read(text: &str) -> Result<Form, String> {
    let form = Form::read(text, &BTreeSet::new()).map_err(|error| format!("'{text}', {error}"))?;
    if form.system.is_some() { Err(OF_SYSTEM.to_owned()) } else { Ok(form) }
}

fn read_point(entries: &[String]) -> Result<Vec<Equal>, String> {
    entries.iter().map(|entry| read_equal(entry)).collect()
}

fn variable(text: &str) -> Result<Symbol, String> {
    read_name(text).ok_or_else(|| format!("'{text}' is no name"))
}

/// `left = right`, where a derivation on either side may have `=` between its parentheses.
fn read_identity(text: &str) -> Result<Kind, String> {
    let mut depth = 0_i32;
    let at = text.char_indices().find(|(_, c)| {
        depth += i32::from(*c == '(') - i32::from(*c == ')');
        depth == 0 && *c == '='
    });
    match at {
        Some((at, _)) => Ok(Kind::Identity(read(text[..at].trim())?, read(text[at + 1..].trim())?)),
        None => Err(format!("'{text}' is not of the form `left = right`")),
    }
}
