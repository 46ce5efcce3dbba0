//! Spells out the by-value and by-reference operator traits of [`Field`](super::Field) from one method each.

/// Implements `+`, `-`, `*` and `/` with the right side by value and by reference, from methods that take the right one by reference.
#[doc(hidden)]
#[macro_export]
macro_rules! implement_operators {
    ($number:ty, $($trait:ident :: $operator:ident => $method:ident),+ $(,)?) => {$(
        impl std::ops::$trait for $number {
            type Output = $number;
            #[inline(always)]
            fn $operator(self, other: $number) -> $number {
                self.$method(&other)
            }
        }
        impl<'r> std::ops::$trait<&'r $number> for $number {
            type Output = $number;
            #[inline(always)]
            fn $operator(self, other: &'r $number) -> $number {
                self.$method(other)
            }
        }
    )+};
}
