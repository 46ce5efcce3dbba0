//! The boundary and the transition over error bars: the normal stresses or loading velocities at which some values have them, and the
//! parts of a map in which some values have them, as bands.

use crate::parallel;

use crate::scene::Quantity;
use slipmode_core::number::Rational;
use slipmode_core::stability::ParameterBox;
use slipmode_core::stability::inverse::{SolutionRange, Target, Unknown, is_nowhere, solve_over_box};
use slipmode_plot::figure::{Axis, Line, LineRole, zones_of_grid};

/// Columns and rows of the cells of a map: about one for each unit of the canvas.
pub(crate) const FINE: [usize; 2] = [448, 416];

/// A block with so many columns and rows at most is filled without a look at each cell if a band holds its corners and its centre.
const BLOCK: usize = 12;

slipmode_algebra::named! {
    /// A line of theory with error bars.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum BandOf {
        /// The boundary max Im(s) = 0.
        Boundary = "boundary",
        /// The transition K = K_c.
        Transition = "transition",
    }
}

impl BandOf {
    fn look(self) -> (&'static str, LineRole) {
        match self {
            Self::Boundary => ("boundary within the error bars", LineRole::BoundaryBand),
            Self::Transition => ("transition within the error bars", LineRole::TransitionBand),
        }
    }

    /// What is met on it.
    pub(crate) fn target(self) -> Target {
        match self {
            Self::Boundary => Target::Boundary,
            Self::Transition => Target::GrowthRate(Rational::new()),
        }
    }
}

/// All solutions for one coordinate at this value of the other one, which the box's own values do not affect.
pub(crate) fn ranges_at(
    region: &ParameterBox,
    target: &Target,
    unknown: Unknown,
    known: &Rational,
) -> Vec<SolutionRange> {
    let other = match unknown {
        Unknown::NormalStress => Quantity::LoadingVelocity,
        _ => Quantity::NormalStress,
    };
    let region = region.clone().with_ends(other, [known.clone(), known.clone()]);
    region.map_or_else(Vec::new, |region| solve_over_box(&region, unknown, target))
}

/// The box with V0 and σ from the first pair to the second one.
fn over(region: &ParameterBox, [from, to]: [[Rational; 2]; 2]) -> Option<ParameterBox> {
    let ([slow, low], [fast, high]) = (from, to);
    let region = region.clone().with_ends(Quantity::LoadingVelocity, [slow, fast])?;
    region.with_ends(Quantity::NormalStress, [low, high])
}

/// The bands as areas of a map with so many columns and rows of cells.
///
/// A cell belongs to a band unless it is certain that no values within the error bars have the line there. Inside a band, blocks are
/// filled by their corners and their centre.
pub(crate) fn band_lines(region: &ParameterBox, x: &Axis, y: &Axis, cells: [usize; 2]) -> Vec<Line> {
    let lines = |of: BandOf| {
        let (label, role) = of.look();
        let classes = Cells::new(region, of, [x, y], cells).classes();
        let outlines = zones_of_grid(x, y, cells[0], &classes, 2).pop().unwrap_or_default();
        outlines.into_iter().map(|outline| Line::new(label, role, outline)).collect::<Vec<_>>()
    };
    BandOf::ALL.into_iter().flat_map(lines).collect()
}

/// The cells of a map around the points of a grid that covers it.
struct Cells<'a> {
    region: &'a ParameterBox,
    target: Target,
    /// The edges of the columns and of the rows, one more than there are of them.
    edges: [Vec<Rational>; 2],
}

/// Columns and rows from the first pair up to the second one.
type Block = [[usize; 2]; 2];

impl<'a> Cells<'a> {
    fn new(region: &'a ParameterBox, of: BandOf, axes: [&Axis; 2], cells: [usize; 2]) -> Self {
        let edges = |axis: usize| {
            let at = |index: usize| (index as f64 - 0.5) / (cells[axis] - 1) as f64;
            let edge = |index: usize| Rational::from_f64(axes[axis].value_at(at(index))?);
            (0..=cells[axis]).filter_map(edge).collect()
        };
        Self { region, target: of.target(), edges: [edges(0), edges(1)] }
    }

    /// 1 for each cell of the band and 0 for the others, row by row.
    fn classes(&self) -> Vec<usize> {
        let [columns, rows] = self.edges.each_ref().map(|edges| edges.len().saturating_sub(1));
        let strips: Vec<Block> =
            (0..columns).step_by(BLOCK).map(|from| [[from, 0], [columns.min(from + BLOCK), rows]]).collect();
        let found = parallel::flat_map(&strips, |strip| {
            let mut blocks = Vec::new();
            self.collect(*strip, &mut blocks);
            blocks
        });
        let mut classes = vec![0; columns * rows];
        for [[left, bottom], [right, top]] in found {
            for row in bottom..top {
                classes[row * columns + left..row * columns + right].fill(1);
            }
        }
        classes
    }

    /// The blocks of the band within a block.
    fn collect(&self, block: Block, blocks: &mut Vec<Block>) {
        let [[left, bottom], [right, top]] = block;
        if !self.may_have(block) {
            return;
        }
        let [columns, rows] = [right - left, top - bottom];
        let is_cell = columns <= 1 && rows <= 1;
        if is_cell || (columns.max(rows) <= BLOCK && self.holds_corners_and_centre(block)) {
            blocks.push(block);
            return;
        }
        let [middle, half] = [left + columns / 2, bottom + rows / 2];
        let parts = if columns >= rows {
            [[[left, bottom], [middle, top]], [[middle, bottom], [right, top]]]
        } else {
            [[[left, bottom], [right, half]], [[left, half], [right, top]]]
        };
        parts.into_iter().for_each(|part| self.collect(part, blocks));
    }

    fn holds_corners_and_centre(&self, [[left, bottom], [right, top]]: Block) -> bool {
        let centre = [usize::midpoint(left, right), usize::midpoint(bottom, top)];
        let corners = [[left, bottom], [right, bottom], [left, top], [right, top], centre];
        corners.into_iter().all(|corner| self.may_have([corner; 2]))
    }

    /// Whether some values in a block have the line, its edges included.
    fn may_have(&self, block: Block) -> bool {
        let ends = block.map(|[column, row]| [self.edges[0][column].clone(), self.edges[1][row].clone()]);
        over(self.region, ends).is_none_or(|region| !is_nowhere(&region, &self.target))
    }
}
#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::friction::Parameters;
    use slipmode_core::number::split_mix::SplitMix64;
    use slipmode_core::stability::inverse::solve;
    use slipmode_core::stability::{InertialThreshold, over_box};

    const VELOCITY: [f64; 2] = [1e-7, 1e1];
    const STRESS: [f64; 2] = [1e3, 1e10];
    const COARSE: [usize; 2] = [96, 80];

    fn slow() -> u32 {
        if std::env::var_os("SLIPMODE_SLOW").is_some() { 25 } else { 1 }
    }

    fn decimal(value: f64) -> Rational {
        Rational::from_f64(value).unwrap()
    }

    /// A slider near that of a laboratory, with error bars of random size in a random choice of its parameters.
    fn laboratory(random: &mut SplitMix64) -> ParameterBox {
        let factors: [f64; 5] = std::array::from_fn(|_| libm::exp10(random.unit() - 0.5));
        let shares: [f64; 5] = std::array::from_fn(|_| {
            if random.unit() < 0.3 { 0.0 } else { libm::exp10(-3.0 + 2.5 * random.unit()) }
        });
        let end = |sign: f64| {
            let value =
                |i: usize| [0.009, 0.0126, 8e-6, 2e9, 2400.0][i] * factors[i] * (1.0 + sign * shares[i]);
            let [a, b, d, k, m] = std::array::from_fn(value).map(decimal);
            Parameters::from([a, b, d, k, m, Rational::from(1), Rational::from(1)])
        };
        ParameterBox::new(end(-1.0), end(1.0)).unwrap()
    }

    fn axes() -> [Axis; 2] {
        [Axis::log10("V", "m/s", VELOCITY[0], VELOCITY[1]), Axis::log10("S", "Pa", STRESS[0], STRESS[1])]
    }

    /// The cells that hold a place: one, or two or four if an edge may pass through it.
    fn cells_at(place: [f64; 2], axes: &[Axis; 2]) -> Vec<usize> {
        let near = |i: usize| {
            let at = axes[i].position(place[i]).unwrap() * (COARSE[i] - 1) as f64 + 0.5;
            let last = COARSE[i] - 1;
            [at - 1e-6, at + 1e-6].map(|at| (at.max(0.0) as usize).min(last))
        };
        let [columns, rows] = [near(0), near(1)];
        rows.into_iter().flat_map(|row| columns.map(|column| row * COARSE[0] + column)).collect()
    }

    #[test]
    fn bands_hold_every_place_that_classify_leaves_open_and_every_line_of_a_slider() {
        let axes = axes();
        let mut random = SplitMix64(11);
        let [mut lines, mut open, mut outside] = [0; 3];
        for _ in 0..8 * slow() {
            let region = laboratory(&mut random);
            for of in BandOf::ALL {
                let classes = Cells::new(&region, of, [&axes[0], &axes[1]], COARSE).classes();
                let is_in = |cells: &[usize]| cells.iter().any(|cell| classes[*cell] == 1);
                for _ in 0..150 {
                    let within = |ends: [f64; 2], share: f64| ends[0] * (ends[1] / ends[0]).powf(share);
                    let [velocity, stress] = [within(VELOCITY, random.unit()), within(STRESS, random.unit())];
                    let cells = cells_at([velocity, stress], &axes);
                    let place = [decimal(velocity), decimal(stress)];
                    let point = over(&region, [place.clone(), place]).unwrap();
                    let found = over_box(&point, &InertialThreshold::default()).unwrap();
                    let signs =
                        if of == BandOf::Boundary { found.boundary_signs } else { found.transition_signs };
                    let is_open = signs[0] != signs[1];
                    assert!(!is_open || is_in(&cells), "{of:?} {velocity} {stress} {signs:?} {region:?}");
                    open += u32::from(is_open);
                    outside += u32::from(!is_in(&cells));
                }
                for _ in 0..10 {
                    let share = |i: usize, random: &mut SplitMix64| {
                        let [low, high]: [[Rational; 7]; 2] = [region.lower().into(), region.upper().into()];
                        let share = decimal(random.unit());
                        (high[i].clone() - &low[i]) * share + &low[i]
                    };
                    let [a, b, d, k, m] = std::array::from_fn(|i| share(i, &mut random));
                    let velocity = VELOCITY[0] * (VELOCITY[1] / VELOCITY[0]).powf(random.unit());
                    let point = Parameters::from([a, b, d, k, m, Rational::from(1), decimal(velocity)]);
                    for solution in solve(&point, Unknown::NormalStress, &of.target(), 20).unwrap() {
                        let stress = solution.value.to_f64();
                        if (STRESS[0]..STRESS[1]).contains(&stress) {
                            let cells = cells_at([velocity, stress], &axes);
                            assert!(is_in(&cells), "{of:?} {velocity} {stress} {region:?}");
                            lines += 1;
                        }
                    }
                }
            }
        }
        assert!(lines > 100 && open > 30 && outside > 300, "{lines} {open} {outside}");
    }

    #[test]
    fn every_cell_on_the_edge_of_a_band_may_have_the_line_and_few_cells_of_a_band_may_not() {
        let axes = axes();
        let mut random = SplitMix64(5);
        for _ in 0..4 * slow() {
            let region = laboratory(&mut random);
            for of in BandOf::ALL {
                let cells = Cells::new(&region, of, [&axes[0], &axes[1]], COARSE);
                let exact: Vec<usize> = (0..COARSE[0] * COARSE[1])
                    .map(|at| {
                        let [column, row] = [at % COARSE[0], at / COARSE[0]];
                        usize::from(cells.may_have([[column, row], [column + 1, row + 1]]))
                    })
                    .collect();
                assert_eq!(cells.classes(), exact, "{of:?} {region:?}");
            }
        }
    }

    #[test]
    fn the_band_of_the_transition_reaches_beyond_the_middle_line() {
        let end = |values: [&str; 5]| {
            let [a, b, d, k, m] = values.map(|text| slipmode_core::number::parse_decimal(text).unwrap());
            Parameters::from([a, b, d, k, m, Rational::from(1), Rational::from(1)])
        };
        let region = ParameterBox::new(
            end(["0.0088", "0.0122", "7.8e-6", "2e9", "2400"]),
            end(["0.0092", "0.0130", "8.2e-6", "2e9", "2400"]),
        );
        let (x, y) = (Axis::log10("V", "m/s", 1e-6, 1.0), Axis::log10("S", "Pa", 1e4, 1e9));
        let lines = band_lines(&region.unwrap(), &x, &y, FINE);
        let of_transition = lines.iter().filter(|line| line.role == LineRole::TransitionBand);
        let velocities = of_transition.flat_map(|line| line.points.iter().map(|point| point.0));
        let fastest = velocities.fold(0.0, f64::max);
        // K D_c²a/((b − a)M) is largest for a = 0.0092, b = 0.0122, D_c = 8.2e-6: V0 = 0.013107 m/s.
        let expected = (2e9 * 8.2e-6_f64.powi(2) * 0.0092 / (0.003 * 2400.0)).sqrt();
        assert!((1.0..1.03).contains(&(fastest / expected)), "{fastest} {expected}");
    }
}
