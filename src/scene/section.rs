//! Reading one table: keys are requested by name, values by type, and any other key is a fault.

use std::ops::RangeInclusive;

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use crate::scene::document::Source;
use crate::scene::{AllowedRange, Fault, Faults, Limits, Problem, nearest, parse_whole};
use slipmode_core::number::Rational;

/// The most unknown keys that are reported of one table: each is compared with every known one.
const MOST_UNKNOWN_KEYS: usize = 20;

/// The most faults of a list after which its further members are not looked at.
const MOST_LIST_FAULTS: usize = 100;

/// A table of the file.
#[derive(Debug)]
pub struct Section<'t> {
    source: &'t Source<'t>,
    path: String,
    offset: usize,
    table: &'t DeTable<'t>,
    requested: Vec<&'static str>,
}

/// A value of the file, with its full key.
#[derive(Debug, Clone)]
pub struct Entry<'t> {
    source: &'t Source<'t>,
    key: String,
    value: &'t Spanned<DeValue<'t>>,
}

impl<'t> Section<'t> {
    /// The file's top table.
    pub(crate) fn top(source: &'t Source<'t>, table: &'t DeTable<'t>) -> Self {
        Self { source, path: String::new(), offset: 0, table, requested: Vec::new() }
    }

    /// The value of a key that may be absent.
    pub fn optional(&mut self, key: &'static str) -> Option<Entry<'t>> {
        if !self.requested.contains(&key) {
            self.requested.push(key);
        }
        let value = self.table.get(key)?;
        Some(Entry { source: self.source, key: self.full_key(key), value })
    }

    /// The value of a key that must be there; its absence is a fault that states what may stand there.
    pub fn required(&mut self, key: &'static str, allowed: &str, faults: &mut Faults) -> Option<Entry<'t>> {
        let entry = self.optional(key);
        if entry.is_none() {
            faults.push(self.fault(key, Problem::Missing { allowed: allowed.to_string() }));
        }
        entry
    }

    /// A fault of the section as a whole, under one of its keys.
    pub fn fault(&self, key: &str, problem: Problem) -> Fault {
        self.source.fault(self.offset, self.full_key(key), None, problem)
    }

    /// Every key that no reader requested is a fault.
    pub fn finish(self, faults: &mut Faults) {
        let is_unknown = |key: &&Spanned<DeString<'_>>| !self.requested.contains(&key.get_ref().as_ref());
        for key in self.table.keys().filter(is_unknown).take(MOST_UNKNOWN_KEYS) {
            let near = nearest(key.get_ref(), self.requested.iter().copied()).map(str::to_string);
            let problem = Problem::UnknownKey { nearest: near, known: self.requested.join(", ") };
            faults.push(self.source.fault(key.span().start, self.full_key(key.get_ref()), None, problem));
        }
    }

    fn full_key(&self, key: &str) -> String {
        if self.path.is_empty() { key.to_string() } else { format!("{}.{key}", self.path) }
    }
}

impl<'t> Entry<'t> {
    /// A fault of this value.
    pub fn fault(&self, problem: Problem) -> Fault {
        let value = match self.value.get_ref() {
            DeValue::Table(_) => None,
            DeValue::String(text) => Some(format!("{text:?}")),
            _ => Some(self.written().to_string()),
        };
        self.source.fault(self.value.span().start, self.key.clone(), value, problem)
    }

    fn wrong_type(&self, wanted: &str) -> Fault {
        let found = match self.value.get_ref() {
            DeValue::String(_) => "a text",
            DeValue::Integer(_) | DeValue::Float(_) => "a number",
            DeValue::Boolean(_) => "true or false",
            DeValue::Datetime(_) => "a date",
            DeValue::Array(_) => "a list",
            DeValue::Table(_) => "a table",
        };
        self.fault(Problem::WrongType { wanted: wanted.to_string(), found })
    }

    /// The value as it stands in the file.
    fn written(&self) -> &'t str {
        self.source.text.get(self.value.span()).unwrap_or_default()
    }

    /// The text of a number, written bare or between quotes.
    fn number_text(&self) -> Option<&str> {
        match self.value.get_ref() {
            DeValue::Integer(_) | DeValue::Float(_) => Some(self.written()),
            DeValue::String(text) => Some(text),
            _ => None,
        }
    }

    /// A number read exactly from its text by `parse`.
    pub fn number<T>(
        &self,
        faults: &mut Faults,
        parse: impl FnOnce(&str) -> Result<T, Problem>,
    ) -> Option<T> {
        let Some(text) = self.number_text() else {
            faults.push(self.wrong_type("a number"));
            return None;
        };
        parse(text).map_err(|problem| faults.push(self.fault(problem))).ok()
    }

    /// A decimal in a range.
    pub fn decimal(&self, range: AllowedRange, faults: &mut Faults) -> Option<Rational> {
        self.number(faults, |text| range.parse(text))
    }

    /// A whole number in a range.
    pub fn whole(&self, range: RangeInclusive<u64>, faults: &mut Faults) -> Option<u64> {
        self.number(faults, |text| parse_whole(text, &range))
    }

    /// True or false.
    pub fn truth(&self, faults: &mut Faults) -> Option<bool> {
        let DeValue::Boolean(value) = self.value.get_ref() else {
            faults.push(self.wrong_type("true or false"));
            return None;
        };
        Some(*value)
    }

    /// A text that is not empty.
    pub fn text(&self, faults: &mut Faults) -> Option<String> {
        let DeValue::String(text) = self.value.get_ref() else {
            faults.push(self.wrong_type("a text in quotes"));
            return None;
        };
        if text.trim().is_empty() {
            faults.push(self.fault(Problem::Empty { allowed: "a text".into() }));
            return None;
        }
        Some(text.to_string())
    }

    /// Whether the value is a table.
    pub fn is_table(&self) -> bool {
        matches!(self.value.get_ref(), DeValue::Table(_))
    }

    /// A table.
    pub fn section(&self, faults: &mut Faults) -> Option<Section<'t>> {
        let DeValue::Table(table) = self.value.get_ref() else {
            faults.push(self.wrong_type("a table"));
            return None;
        };
        let offset = self.value.span().start;
        Some(Section { source: self.source, path: self.key.clone(), offset, table, requested: Vec::new() })
    }

    /// The members of a list that is not empty, each with the key `list[i]`, counted from 1.
    pub fn members(&self, faults: &mut Faults) -> Option<Vec<Entry<'t>>> {
        let DeValue::Array(array) = self.value.get_ref() else {
            faults.push(self.wrong_type("a list"));
            return None;
        };
        if array.is_empty() {
            faults.push(self.fault(Problem::Empty { allowed: "at least one member".into() }));
            return None;
        }
        let member = |(index, value)| Entry {
            source: self.source,
            key: format!("{}[{}]", self.key, index + 1),
            value,
        };
        Some(array.iter().enumerate().map(member).collect())
    }

    /// A list of which every member is read by `read`; `None` when any of them is faulty.
    pub fn list<T>(
        &self,
        faults: &mut Faults,
        mut read: impl FnMut(&Entry<'t>, &mut Faults) -> Option<T>,
    ) -> Option<Vec<T>> {
        let most = faults.len() + MOST_LIST_FAULTS;
        let mut values = Vec::new();
        for member in self.members(faults)? {
            if faults.len() >= most {
                return None;
            }
            values.push(read(&member, faults));
        }
        values.into_iter().collect()
    }
}

/// A section of a scene, read and valid.
pub trait ReadSection: Sized {
    /// Reads it; its faults are added to the others.
    fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self>;
}

/// A section is absent, or there and sound; `None` when it is there and faulty.
pub(crate) fn given<T>(section: Option<Option<T>>) -> Option<Option<T>> {
    match section {
        None => Some(None),
        Some(read) => read.map(Some),
    }
}
