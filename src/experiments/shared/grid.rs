//! Values on a (V, σ) grid, row by row of constant normal stress.

/// A rectangle of values over loading velocity (fast index) and normal stress (slow index).
#[derive(Debug, Clone, PartialEq)]
pub struct Grid<T> {
    /// Loading velocities, m/s, ascending.
    pub loading_velocity_m_per_s: Vec<f64>,
    /// Normal stresses, Pa, ascending.
    pub normal_stress_pa: Vec<f64>,
    /// One value a point, row by row of constant normal stress.
    pub values: Vec<T>,
}

impl<T> Grid<T> {
    /// The points in storage order as (V, σ, value).
    pub fn points(&self) -> impl Iterator<Item = (f64, f64, &T)> {
        let columns = self.loading_velocity_m_per_s.len();
        self.values.iter().enumerate().map(move |(index, value)| {
            (self.loading_velocity_m_per_s[index % columns], self.normal_stress_pa[index / columns], value)
        })
    }

    /// The same grid with every value mapped.
    pub(crate) fn map<S>(&self, convert: impl FnMut(&T) -> S) -> Grid<S> {
        Grid {
            loading_velocity_m_per_s: self.loading_velocity_m_per_s.clone(),
            normal_stress_pa: self.normal_stress_pa.clone(),
            values: self.values.iter().map(convert).collect(),
        }
    }
}

impl<T: PartialEq> Grid<T> {
    /// How many connected areas of equal value `wanted` the grid shows; points that touch at a corner are connected.
    ///
    /// A count on a grid is a sample: two areas nearer to each other than its lines count as one, and one that is narrower somewhere,
    /// as at a cusp, as two.
    pub(crate) fn areas_of(&self, wanted: &T) -> usize {
        let mut seen = vec![false; self.values.len()];
        let mut areas = 0;
        for start in 0..self.values.len() {
            if !seen[start] && self.values[start] == *wanted {
                areas += 1;
                self.flood(start, wanted, &mut seen);
            }
        }
        areas
    }

    /// How far, in decades along one of the axes, the nearest point of this value is from the point at an index; infinite without one.
    pub(crate) fn distance_dex(&self, index: usize, wanted: &T) -> f64 {
        let columns = self.loading_velocity_m_per_s.len();
        let (row, column) = (index / columns, index % columns);
        let along = |axis: &[f64], from: usize, index: &dyn Fn(usize) -> usize| {
            let reached = (0..axis.len()).filter(|&place| self.values[index(place)] == *wanted);
            let dex = reached.map(|place| libm::log10(axis[place] / axis[from]).abs());
            dex.fold(f64::INFINITY, f64::min)
        };
        along(&self.loading_velocity_m_per_s, column, &|place| row * columns + place).min(along(
            &self.normal_stress_pa,
            row,
            &|place| place * columns + column,
        ))
    }

    fn flood(&self, start: usize, wanted: &T, seen: &mut [bool]) {
        let mut open = vec![start];
        while let Some(index) = open.pop() {
            if std::mem::replace(&mut seen[index], true) {
                continue;
            }
            open.extend(self.neighbours(index).filter(|&next| !seen[next] && self.values[next] == *wanted));
        }
    }

    fn neighbours(&self, index: usize) -> impl Iterator<Item = usize> {
        let columns = self.loading_velocity_m_per_s.len();
        let (row, column) = (index / columns, index % columns);
        let near = |place: usize, count: usize| place.saturating_sub(1)..(place + 2).min(count);
        let rows = near(row, self.normal_stress_pa.len());
        rows.flat_map(move |row| near(column, columns).map(move |column| row * columns + column))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_distance_is_the_shorter_one_along_an_axis() {
        let grid = Grid {
            loading_velocity_m_per_s: vec![1.0, 10.0, 100.0],
            normal_stress_pa: vec![1.0, 1e3],
            values: vec![0, 0, 1, 1, 0, 0],
        };
        assert_eq!([0, 1, 4].map(|index| grid.distance_dex(index, &1)), [2.0, 1.0, 1.0]);
        assert_eq!((grid.distance_dex(0, &0), grid.distance_dex(0, &7)), (0.0, f64::INFINITY));
    }

    #[test]
    fn an_area_may_run_across_corners() {
        let grid = Grid {
            loading_velocity_m_per_s: vec![1.0, 2.0, 3.0],
            normal_stress_pa: vec![1.0, 2.0, 3.0],
            values: vec![1, 0, 0, 0, 1, 0, 0, 0, 1],
        };
        assert_eq!((grid.areas_of(&1), grid.areas_of(&0), grid.areas_of(&2)), (1, 1, 0));
        let parted = Grid { values: vec![1, 0, 1, 1, 0, 1, 1, 0, 1], ..grid.clone() };
        assert_eq!((parted.areas_of(&1), parted.areas_of(&0)), (2, 1));
        let ring = Grid { values: vec![1, 1, 1, 1, 0, 1, 1, 1, 1], ..grid };
        assert_eq!((ring.areas_of(&1), ring.areas_of(&0)), (1, 1));
    }
}
