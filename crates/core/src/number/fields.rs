//! Structs whose fields all have one type: arrays with names.

/// Declares such a struct, and makes it from the array of its fields and the array from it, in the order of the fields. `map` gives
/// the same fields in another type.
macro_rules! fields {
    (
        $(#[$attribute:meta])*
        $visibility:vis struct $name:ident<$type:ident>[$count:expr] {
            $($(#[$note:meta])* $shown:vis $field:ident,)+
        }
    ) => {
        $(#[$attribute])*
        $visibility struct $name<$type> { $($(#[$note])* $shown $field: $type,)+ }

        impl<$type> From<[$type; $count]> for $name<$type> {
            #[inline(always)]
            fn from([$($field),+]: [$type; $count]) -> Self {
                Self { $($field),+ }
            }
        }

        impl<$type> From<$name<$type>> for [$type; $count] {
            #[inline(always)]
            fn from($name { $($field),+ }: $name<$type>) -> Self {
                [$($field),+]
            }
        }

        impl<$type> $name<$type> {
            /// The same in another type of numbers.
            #[must_use]
            #[inline(always)]
            $visibility fn map<Other>(&self, mut convert: impl FnMut(&$type) -> Other) -> $name<Other> {
                $name { $($field: convert(&self.$field)),+ }
            }
        }
    };
}
pub(crate) use fields;
