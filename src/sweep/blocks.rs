//! How a sweep is cut: blocks of a fixed number of points, dealt out to shards in turn.

use std::ops::Range;

/// The blocks of a sweep. They do not depend on how many shards share them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Blocks {
    /// The points of the whole sweep.
    pub points: u64,
    /// The points of every block but perhaps the last.
    pub block_points: u64,
}

/// One part of several: block k belongs to shard k mod count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// Its number, counted from 0.
    pub index: u64,
    /// How many shards there are; at least 1.
    pub count: u64,
}

impl Blocks {
    /// The number of blocks.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.points.div_ceil(self.block_points.max(1))
    }

    /// The points of a block, by their numbers in the sweep; none for a block beyond the last.
    #[must_use]
    pub fn range(&self, block: u64) -> Range<u64> {
        let start = block.saturating_mul(self.block_points).min(self.points);
        start..start.saturating_add(self.block_points).min(self.points)
    }

    /// The blocks of a shard, in order.
    pub fn of_shard(&self, shard: Shard) -> impl Iterator<Item = u64> + use<> {
        let step = usize::try_from(shard.count.max(1)).unwrap_or(usize::MAX);
        (shard.index..self.count()).step_by(step)
    }
}

impl Shard {
    /// Reads `I/N`, 0 ≤ I < N.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let (index, count) = text.split_once('/')?;
        let digits =
            |text: &str| text.bytes().all(|byte| byte.is_ascii_digit()).then(|| text.parse().ok())?;
        let shard = Self { index: digits(index)?, count: digits(count)? };
        (shard.index < shard.count).then_some(shard)
    }

    /// The number of the shard that has this block.
    #[must_use]
    pub fn of_block(block: u64, count: u64) -> u64 {
        block % count.max(1)
    }
}

/// Numbers in ascending order as an array string of a scheduler: runs joined, `3,17-19`.
#[must_use]
pub fn array_string(ascending: impl IntoIterator<Item = u64>) -> String {
    let mut runs: Vec<(u64, u64)> = Vec::new();
    for number in ascending {
        match runs.last_mut() {
            Some((_, last)) if *last + 1 == number => *last = number,
            _ => runs.push((number, number)),
        }
    }
    let text = |(first, last): &(u64, u64)| {
        if first == last { first.to_string() } else { format!("{first}-{last}") }
    };
    runs.iter().map(text).collect::<Vec<_>>().join(",")
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn an_array_string_joins_runs() {
        assert_eq!(array_string([3, 17, 18, 19]), "3,17-19");
        assert_eq!(array_string([0, 1, 5, 7, 8]), "0-1,5,7-8");
        assert_eq!(array_string([]), "");
    }

    #[test]
    fn a_shard_is_two_whole_numbers() {
        assert_eq!(Shard::parse("3/7"), Some(Shard { index: 3, count: 7 }));
        for bad in ["7/7", "1", "-1/3", "+1/3", "1/0", "a/b", "1/2/3", "/2", "1/", " 1/2"] {
            assert_eq!(Shard::parse(bad), None, "{bad}");
        }
    }

    proptest! {
        #[test]
        fn every_point_is_in_one_block_of_one_shard(points in 1u64..5000, size in 1u64..700, count in 1u64..20) {
            let blocks = Blocks { points, block_points: size };
            let mut seen: Vec<u64> = (0..count)
                .flat_map(|index| blocks.of_shard(Shard { index, count }))
                .inspect(|block| assert!(!blocks.range(*block).is_empty()))
                .flat_map(|block| blocks.range(block))
                .collect();
            seen.sort_unstable();
            prop_assert_eq!(seen, (0..points).collect::<Vec<_>>());
        }
    }
}
