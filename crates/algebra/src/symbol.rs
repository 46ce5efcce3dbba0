//! Names of variables.
//!
//! Primes at the end of a name count time derivatives (`theta'` is dθ/dt), so that a differential equation is a
//! polynomial in the names.

use std::fmt;
use std::sync::Arc;

/// The name of a variable, cheap to clone and ordered alphabetically.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symbol(Arc<str>);

impl Symbol {
    /// A symbol of this name.
    #[must_use]
    pub fn new(name: &str) -> Self {
        Self(Arc::from(name))
    }

    /// The whole name, primes included.
    #[must_use]
    pub fn as_str(&self) -> &str {
        &self.0
    }

    /// The name without its primes.
    #[must_use]
    pub fn base(&self) -> &str {
        self.0.trim_end_matches('\'')
    }

    /// The number of primes: the order of the time derivative.
    #[must_use]
    pub fn derivative_order(&self) -> usize {
        self.0.len() - self.base().len()
    }

    /// The time derivative of this variable: one more prime.
    #[must_use]
    pub fn time_derivative(&self) -> Self {
        Self(Arc::from(format!("{}'", self.0)))
    }
}

impl From<&str> for Symbol {
    fn from(name: &str) -> Self {
        Self::new(name)
    }
}

impl fmt::Display for Symbol {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn primes_count_time_derivatives() {
        let velocity = Symbol::new("delta").time_derivative();
        assert_eq!(velocity.as_str(), "delta'");
        assert_eq!(velocity.time_derivative().derivative_order(), 2);
        assert_eq!(velocity.base(), "delta");
    }
}
