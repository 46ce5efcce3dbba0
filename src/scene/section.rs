//! Reading one table: keys are requested by name, values by type, and any other key is a fault.

use std::cell::RefCell;
use std::ops::RangeInclusive;

use serde::de::DeserializeOwned;
use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue, Deserializer};

use crate::scene::file_text::line_at;
use crate::scene::range::whole_range_text;
use crate::scene::units::unit_of_key;
use crate::scene::{
    AllowedRange, Fault, Faults, Limits, Problem, Uncertain, check_name, forbidden_character, nearest,
    parse_whole,
};
use slipmode_core::number::Rational;

/// The most unknown keys that are reported of one table: each is compared with every known one.
const MOST_UNKNOWN_KEYS: usize = 20;

/// The most faults of a list after which its further members are not looked at.
const MOST_LIST_FAULTS: usize = 100;

/// Where values come from: the file's name, text and limits, and the faults found so far.
#[derive(Debug)]
pub(crate) struct Source<'s> {
    pub file: &'s str,
    pub text: &'s str,
    pub limits: Limits,
    pub faults: RefCell<Faults>,
}

impl Source<'_> {
    /// Notes a fault of this file at a byte offset.
    pub fn fault(&self, offset: usize, key: String, value: Option<String>, problem: Problem) {
        let line = Some(line_at(self.text.as_bytes(), offset));
        self.faults.borrow_mut().push(Fault { file: self.file.to_string(), line, key, value, problem });
    }

    /// How many faults were found so far.
    pub fn fault_count(&self) -> usize {
        self.faults.borrow().len()
    }
}

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

/// The values of some keys of a table.
#[derive(Debug)]
pub struct Entries<'t>(Vec<(&'static str, Entry<'t>)>);

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

    /// The values of those of these keys that are there.
    pub fn entries(&mut self, keys: &[&'static str]) -> Entries<'t> {
        Entries(keys.iter().filter_map(|key| Some((*key, self.optional(key)?))).collect())
    }

    /// The value of a key that must be there; its absence is a fault that states what may stand there.
    pub fn required(&mut self, key: &'static str, allowed: &str) -> Option<Entry<'t>> {
        let entry = self.optional(key);
        if entry.is_none() {
            self.fault(key, Problem::Missing { allowed: allowed.to_string() });
        }
        entry
    }

    /// What `read` makes of a key that may be absent; `None` when it is absent or faulty.
    pub fn optionally<T>(
        &mut self,
        key: &'static str,
        read: impl FnOnce(&Entry<'t>) -> Option<T>,
    ) -> Option<T> {
        self.optional(key).and_then(|entry| read(&entry))
    }

    /// What a reader makes of the section under a key.
    pub(crate) fn key<T>(&mut self, key: &'static str, read: impl FnOnce(&mut Self, &'static str) -> T) -> T {
        read(self, key)
    }

    /// What `read` makes of a key that must be there.
    ///
    /// A value that is absent or faulty is read as the default of its type: its fault is noted, and [`Entry::table`] then gives
    /// nothing.
    pub fn read<T: Default>(
        &mut self,
        key: &'static str,
        allowed: &str,
        read: impl FnOnce(&Entry<'t>) -> Option<T>,
    ) -> T {
        self.required(key, allowed).and_then(|entry| read(&entry)).unwrap_or_default()
    }

    /// A list that must be there, of which every member is read by `read`.
    pub fn list<T>(
        &mut self,
        key: &'static str,
        allowed: &str,
        read: impl FnMut(&Entry<'t>) -> Option<T>,
    ) -> Vec<T> {
        self.read(key, allowed, |entry| entry.list(read))
    }

    /// A text that must be there.
    pub fn text(&mut self, key: &'static str, allowed: &str) -> String {
        self.read(key, allowed, Entry::text)
    }

    /// A text that must be there and be safe as the name of a file.
    pub fn name(&mut self, key: &'static str, allowed: &str) -> String {
        self.read(key, allowed, Entry::name)
    }

    /// A decimal that must be there.
    pub fn decimal(&mut self, key: &'static str, range: AllowedRange) -> Rational {
        self.read(key, &range.wanted(), |entry| entry.decimal(range))
    }

    /// A list of decimals that must be there.
    pub fn decimals(&mut self, key: &'static str, allowed: &str, range: AllowedRange) -> Vec<Rational> {
        self.list(key, allowed, |member| member.decimal(range))
    }

    /// A list of numbers within a range, which may be absent.
    pub fn any_decimals(&mut self, key: &'static str, range: AllowedRange) -> Vec<Rational> {
        self.optionally(key, |entry| entry.list(|member| member.decimal(range))).unwrap_or_default()
    }

    /// A whole number that must be there.
    pub fn whole<T: TryFrom<u64> + Default>(&mut self, key: &'static str, range: RangeInclusive<u64>) -> T {
        self.read(key, &whole_range_text(&range), |entry| T::try_from(entry.whole(range)?).ok())
    }

    /// What serde reads of the keys `keys`; `None` when one of them is faulty.
    pub fn deserialized<T: DeserializeOwned>(&mut self, keys: &[&'static str]) -> Option<T> {
        self.requested.extend(keys);
        let of_keys = self.table.iter().filter(|(key, _)| keys.contains(&key.get_ref().as_ref()));
        let table: DeTable<'t> = of_keys.map(|(key, value)| (key.clone(), value.clone())).collect();
        let read = T::deserialize(Deserializer::from(Spanned::new(0..0, table)));
        let fault = |error: toml::de::Error| {
            let (at, message) = (error.span().map_or(0, |span| span.start), error.message().to_owned());
            self.source.fault(at, String::new(), None, Problem::Equation(message));
        };
        read.map_err(fault).ok()
    }

    /// A fault of the section as a whole, under one of its keys.
    pub fn fault(&self, key: &str, problem: Problem) {
        self.source.fault(self.offset, self.full_key(key), None, problem);
    }

    /// A fault of the section as a whole.
    pub fn refuse(&self, problem: Problem) {
        self.source.fault(self.offset, self.path.clone(), None, problem);
    }

    /// Refuses more points than the limit of the file.
    pub fn check_points(&self, points: u64) {
        if let Err(problem) = self.limits().check(points) {
            self.refuse(problem);
        }
    }

    /// The ends of a range, `from` < `to`, which must be there.
    pub fn ends(&mut self) -> (Rational, Rational) {
        let [from, to] = ["from", "to"].map(|key| self.decimal(key, AllowedRange::PHYSICAL));
        if from >= to && to > 0 {
            self.refuse(if from == to { Problem::EmptyRange } else { Problem::ReversedRange });
        }
        (from, to)
    }

    /// The limits of the file.
    pub fn limits(&self) -> &'t Limits {
        &self.source.limits
    }

    /// Every key that no reader requested is a fault.
    pub(super) fn finish(self) {
        let is_unknown = |key: &&Spanned<DeString<'_>>| !self.requested.contains(&key.get_ref().as_ref());
        for key in self.table.keys().filter(is_unknown).take(MOST_UNKNOWN_KEYS) {
            let near = nearest(key.get_ref(), self.requested.iter().copied()).map(str::to_string);
            let problem = Problem::UnknownKey { nearest: near, known: self.requested.join(", ") };
            self.source.fault(key.span().start, self.full_key(key.get_ref()), None, problem);
        }
    }

    fn full_key(&self, key: &str) -> String {
        if self.path.is_empty() { key.to_string() } else { format!("{}.{key}", self.path) }
    }
}

impl<'t> Entries<'t> {
    /// The value of a key.
    pub fn get(&self, key: &str) -> Option<&Entry<'t>> {
        self.0.iter().find(|(known, _)| *known == key).map(|(_, entry)| entry)
    }

    /// All values.
    pub fn iter(&self) -> impl Iterator<Item = &Entry<'t>> {
        self.0.iter().map(|(_, entry)| entry)
    }

    /// A text; `None` when it is absent or faulty.
    pub fn text(&self, key: &str) -> Option<String> {
        self.get(key).and_then(Entry::text)
    }

    /// A list of texts; empty when it is absent or faulty.
    pub fn texts(&self, key: &str) -> Vec<String> {
        self.get(key).and_then(|entry| entry.list(Entry::text)).unwrap_or_default()
    }
}

impl<'t> Entry<'t> {
    /// Notes a fault of this value, which then has no reading.
    pub fn refuse<T>(&self, problem: Problem) -> Option<T> {
        let value = match self.value.get_ref() {
            DeValue::Table(_) => None,
            DeValue::String(text) => Some(format!("{text:?}")),
            _ => Some(self.written().to_string()),
        };
        self.source.fault(self.value.span().start, self.key.clone(), value, problem);
        None
    }

    /// Refuses the value, which needs `what`.
    pub fn needs<T>(&self, what: impl Into<String>) -> Option<T> {
        self.refuse(Problem::Needs(what.into()))
    }

    /// What was read of an equation or a part of one; the fault is noted when there is one.
    pub fn equation<T>(&self, read: Result<T, String>) -> Option<T> {
        self.sound(read.map_err(Problem::Equation))
    }

    /// What was read; the problem is noted when there is one.
    pub fn sound<T>(&self, read: Result<T, Problem>) -> Option<T> {
        read.map_err(|problem| self.refuse::<T>(problem)).ok()
    }

    fn wrong_type<T>(&self, wanted: &str) -> Option<T> {
        let found = match self.value.get_ref() {
            DeValue::String(_) => "a text",
            DeValue::Integer(_) | DeValue::Float(_) => "a number",
            DeValue::Boolean(_) => "true or false",
            DeValue::Datetime(_) => "a date",
            DeValue::Array(_) => "a list",
            DeValue::Table(_) => "a table",
        };
        self.refuse(Problem::WrongType { wanted: wanted.to_string(), found })
    }

    /// The value as it stands in the file.
    fn written(&self) -> &'t str {
        self.source.text.get(self.value.span()).unwrap_or_default()
    }

    /// A number read exactly from its text, written bare or between quotes, by `parse`.
    pub fn number<T>(&self, parse: impl FnOnce(&str) -> Result<T, Problem>) -> Option<T> {
        let parsed = match self.value.get_ref() {
            DeValue::Integer(_) | DeValue::Float(_) => parse(self.written()),
            DeValue::String(text) => parse(text),
            _ => return self.wrong_type("a number"),
        };
        self.sound(parsed)
    }

    /// A decimal in a range, in the unit of SI that the key states, or with a unit of its own.
    pub fn decimal(&self, range: AllowedRange) -> Option<Rational> {
        self.number(|text| range.parse_measured(text, unit_of_key(&self.key)))
    }

    /// As [`Self::decimal`], with or without an error bar.
    pub fn uncertain(&self, range: AllowedRange) -> Option<Uncertain> {
        let read = |number: &str| range.parse_measured(number, unit_of_key(&self.key));
        self.number(|text| Uncertain::parse(text, read))
    }

    /// A whole number in a range.
    pub fn whole(&self, range: RangeInclusive<u64>) -> Option<u64> {
        self.number(|text| parse_whole(text, &range))
    }

    /// True or false.
    pub fn truth(&self) -> Option<bool> {
        match self.value.get_ref() {
            DeValue::Boolean(value) => Some(*value),
            _ => self.wrong_type("true or false"),
        }
    }

    /// A text that is not empty.
    pub fn text(&self) -> Option<String> {
        match self.value.get_ref() {
            DeValue::String(text) if text.trim().is_empty() => self.refuse(Problem::Empty("a text".into())),
            DeValue::String(text) => match forbidden_character(text) {
                // TOML can write it as an escape, which the check of the file does not see.
                Some(problem) => self.refuse(problem),
                None => Some(text.to_string()),
            },
            _ => self.wrong_type("a text in quotes"),
        }
    }

    /// A text that is safe as the name of a file.
    pub fn name(&self) -> Option<String> {
        let name = self.text()?;
        self.sound(check_name(&name).map_err(Problem::BadName))?;
        Some(name)
    }

    /// One of `all`, by its word.
    pub fn word<T: Copy>(&self, all: &[T], word_of: impl Fn(T) -> &'static str) -> Option<T> {
        let text = self.text()?;
        self.sound(of_word(&text, all, word_of))
    }

    /// Whether the value is a table.
    pub fn is_table(&self) -> bool {
        matches!(self.value.get_ref(), DeValue::Table(_))
    }

    fn section(&self) -> Option<Section<'t>> {
        let DeValue::Table(table) = self.value.get_ref() else {
            return self.wrong_type("a table");
        };
        let offset = self.value.span().start;
        Some(Section { source: self.source, path: self.key.clone(), offset, table, requested: Vec::new() })
    }

    /// What `read` makes of a table, of which every other key is a fault; `None` when the table has a fault.
    pub fn table<T>(&self, read: impl FnOnce(&mut Section<'t>) -> T) -> Option<T> {
        let mut section = self.section()?;
        let earlier = self.source.fault_count();
        let value = read(&mut section);
        section.finish();
        (self.source.fault_count() == earlier).then_some(value)
    }

    /// A list that is not empty, of which every member is read by `read`; `None` when any of them is faulty.
    ///
    /// A member has the key `list[i]`, counted from 1.
    pub fn list<T>(&self, mut read: impl FnMut(&Entry<'t>) -> Option<T>) -> Option<Vec<T>> {
        let DeValue::Array(array) = self.value.get_ref() else {
            return self.wrong_type("a list");
        };
        if array.is_empty() {
            return self.refuse(Problem::Empty("at least one member".into()));
        }
        let most = self.source.fault_count() + MOST_LIST_FAULTS;
        let mut values = Vec::new();
        for (index, value) in array.iter().enumerate() {
            if self.source.fault_count() >= most {
                return None;
            }
            let key = format!("{}[{}]", self.key, index + 1);
            values.push(read(&Entry { source: self.source, key, value }));
        }
        values.into_iter().collect()
    }

    /// A table with any keys, of which every member is read by `read`; `None` when any of them is faulty.
    pub fn members<T>(&self, mut read: impl FnMut(&str, &Entry<'t>) -> Option<T>) -> Option<Vec<T>> {
        let section = self.section()?;
        let member = |(key, value): (&Spanned<DeString<'t>>, &'t Spanned<DeValue<'t>>)| {
            let entry = Entry { source: self.source, key: section.full_key(key.get_ref()), value };
            read(key.get_ref(), &entry)
        };
        let members: Vec<Option<T>> = section.table.iter().map(member).collect();
        members.into_iter().collect()
    }

    /// A list of which no member occurs twice; `earlier` names the member that is doubled.
    pub fn distinct<T: PartialEq + Clone>(
        &self,
        earlier: impl Fn(&T) -> String,
        read: impl Fn(&Entry<'t>) -> Option<T>,
    ) -> Option<Vec<T>> {
        let mut seen = Vec::new();
        self.list(|member| {
            let value = read(member)?;
            if seen.contains(&value) {
                return member.refuse(Problem::Duplicate { of: earlier(&value), folded: false });
            }
            seen.push(value.clone());
            Some(value)
        })
    }

    /// Refuses more points than the limit of the file.
    pub fn check_points(&self, points: u64) -> Option<()> {
        self.sound(self.source.limits.check(points))
    }
}

/// A section of a scene.
pub trait ReadSection: Sized {
    /// Reads its keys; its faults are added to the others.
    fn read(section: &mut Section<'_>) -> Self;
}

/// Declares a section by its keys: each with its meaning, its type and how it is read from the section under its name. They are read
/// in this order. The limit of the file is for the number of `points`.
macro_rules! keys {
    (
        $(#[$about:meta])* pub struct $name:ident { $($(#[$meaning:meta])* pub $key:ident: $type:ty = $read:expr,)* }
        $(points: $points:expr,)?
    ) => {
        $(#[$about])*
        #[derive(Debug, Clone, PartialEq, Eq)]
        pub struct $name { $($(#[$meaning])* pub $key: $type,)* }

        impl $crate::scene::section::ReadSection for $name {
            #[allow(unused_variables)]
            fn read(section: &mut $crate::scene::section::Section<'_>) -> Self {
                let read = Self { $($key: section.key(stringify!($key), $read),)* };
                $(let points: fn(&Self) -> u64 = $points;
                section.check_points(points(&read));)?
                read
            }
        }
    };
}
pub(crate) use keys;

/// The one of `all` that has a word.
///
/// # Errors
/// When none has it; the nearest word is named.
pub fn of_word<'w, T: Copy>(text: &str, all: &[T], word_of: impl Fn(T) -> &'w str) -> Result<T, Problem> {
    all.iter().copied().find(|one| word_of(*one) == text).ok_or_else(|| {
        let words: Vec<&str> = all.iter().map(|one| word_of(*one)).collect();
        let nearest = nearest(text, words.iter().copied()).map(str::to_string);
        Problem::UnknownWord { nearest, allowed: words.join(", ") }
    })
}
