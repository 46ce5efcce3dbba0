//! Enumerations whose variants have a word each: the list, the words and the search by word come from one place.

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
    };
}
