//! The rows that players print, and the best of several.

/// One measurement, as a player printed it.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The work, with what it was done on.
    pub work: String,
    /// How it was done.
    pub method: String,
    /// The settings that matter, separated by `; `, or `-`.
    pub options: String,
    /// The tolerance asked for, or `-`.
    pub tolerance: String,
    /// How many items were done.
    pub items: f64,
    /// CPU seconds for all items.
    pub seconds: f64,
    /// The worst error, or `-`; below the range of 64 bits at many digits.
    pub error: String,
    /// Wrong answers and failures.
    pub wrong: u64,
    /// Steps taken, or `-`.
    pub steps: String,
    /// Evaluations of the right-hand side, or `-`.
    pub evaluations: String,
    /// The program that did it, with its version.
    pub program: String,
    /// The command that printed it.
    pub command: String,
}

impl Row {
    /// Reads a line `row key=value …` that a command of a program printed; any other line is none.
    pub fn parse(line: &str, program: &str, command: &str) -> Option<Self> {
        let cells = line.strip_prefix("row ")?;
        let value = |key: &str| {
            cells.split(' ').find_map(|cell| cell.strip_prefix(key)?.strip_prefix('=')).map(str::to_string)
        };
        Some(Self {
            work: value("work")?,
            method: value("method")?,
            options: value("options")?.replace(';', "; ").replace('~', " "),
            tolerance: value("tolerance")?,
            items: value("items")?.parse().ok()?,
            seconds: value("seconds")?.parse().ok()?,
            error: value("error")?,
            wrong: value("wrong")?.parse().ok()?,
            steps: value("steps")?,
            evaluations: value("evaluations")?,
            program: program.to_string(),
            command: command.to_string(),
        })
    }

    /// CPU seconds of one item.
    pub fn seconds_per_item(&self) -> f64 {
        self.seconds / self.items
    }

    /// The error as a number, where there is one; what is below the range of 64 bits is 0.
    pub fn error_value(&self) -> Option<f64> {
        self.error.parse().ok()
    }

    /// Whether slipmode did it.
    pub fn is_ours(&self) -> bool {
        self.method.starts_with("slipmode")
    }

    fn is_repeated_by(&self, other: &Self) -> bool {
        self.work == other.work && self.method == other.method && self.tolerance == other.tolerance
    }
}

/// Adds a row, or keeps the faster of the two that measured the same.
pub fn keep_best(rows: &mut Vec<Row>, row: Row) {
    match rows.iter_mut().find(|known| known.is_repeated_by(&row)) {
        Some(known) if row.seconds_per_item() < known.seconds_per_item() => *known = row,
        Some(_) => {}
        None => rows.push(row),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LINE: &str = "row work=roots-50-hard method=x options=a=1;b~c tolerance=- items=4 seconds=2.0e0 error=1.2e-400 wrong=1 steps=- evaluations=-";

    #[test]
    fn a_row_is_read_and_anything_else_is_not() {
        let row = Row::parse(LINE, "p 1.0", "x").unwrap();
        assert_eq!((row.seconds_per_item(), row.wrong, row.error_value()), (0.5, 1, Some(0.0)));
        assert_eq!((row.options.as_str(), row.program.as_str()), ("a=1; b c", "p 1.0"));
        assert_eq!(Row::parse("warning: row", "", ""), None);
        assert_eq!(Row::parse("row work=a", "", ""), None);
    }

    #[test]
    fn of_two_measurements_the_faster_stays() {
        let row = Row::parse(LINE, "p 1.0", "x").unwrap();
        let mut rows = vec![row.clone()];
        keep_best(&mut rows, Row { seconds: 1.0, ..row.clone() });
        keep_best(&mut rows, Row { seconds: 3.0, ..row.clone() });
        keep_best(&mut rows, Row { tolerance: "1e-3".into(), ..row });
        assert_eq!(rows.iter().map(|row| row.seconds).collect::<Vec<_>>(), [1.0, 2.0]);
    }
}
