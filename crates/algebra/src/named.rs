//! Enumerations whose variants have a word each: the list, the words and the search by word come from one place. And the nearest word
//! to a misspelt one.

/// Declares an enumeration of words: `Variant = "word"`.
///
/// It gets `ALL`, every variant in the order of the declaration, `as_str`, and `from_word`, the inverse of `as_str`.
#[doc(hidden)]
#[macro_export]
macro_rules! named {
    (
        $(#[$attribute:meta])*
        $visibility:vis enum $name:ident { $($(#[$note:meta])* $variant:ident = $word:literal,)+ }
    ) => {
        $(#[$attribute])*
        $visibility enum $name { $($(#[$note])* $variant,)+ }

        impl $name {
            /// Every variant, in the order of the declaration.
            pub const ALL: [Self; [$($name::$variant),+].len()] = [$(Self::$variant),+];

            /// The word of the command line, of tables and of JSON.
            #[must_use]
            pub const fn as_str(self) -> &'static str {
                match self {
                    $(Self::$variant => $word,)+
                }
            }

            /// The variant of a word, the inverse of [`Self::as_str`].
            #[must_use]
            pub fn from_word(word: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|variant| variant.as_str() == word)
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                formatter.pad(self.as_str())
            }
        }

        impl std::str::FromStr for $name {
            type Err = $crate::UnknownWord;

            fn from_str(word: &str) -> Result<Self, Self::Err> {
                Self::from_word(word).ok_or_else(|| $crate::UnknownWord::new(word, &Self::ALL.map(Self::as_str)))
            }
        }
    };
}

/// A text that is none of a list of words.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{written:?} is unknown (allowed: {allowed})")]
pub struct UnknownWord {
    written: String,
    allowed: String,
}

impl UnknownWord {
    #[doc(hidden)]
    #[must_use]
    pub fn new(written: &str, allowed: &[&str]) -> Self {
        Self { written: written.into(), allowed: allowed.join(", ") }
    }
}

/// The longest text that may be a misspelt word, in bytes: the distance costs the product of both lengths.
const LONGEST: usize = 200;

/// The known word nearest to a misspelt one, if any is near enough to be meant.
///
/// Near is an edit distance of at most a third of the length (swapped neighbours count once).
#[must_use]
pub fn nearest<'k>(written: &str, known: impl IntoIterator<Item = &'k str>) -> Option<&'k str> {
    if written.len() > LONGEST {
        return None;
    }
    known
        .into_iter()
        .map(|word| (strsim::damerau_levenshtein(&written.to_lowercase(), &word.to_lowercase()), word))
        .filter(|(distance, word)| *distance <= (word.chars().count() / 3).max(1))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, word)| word)
}
