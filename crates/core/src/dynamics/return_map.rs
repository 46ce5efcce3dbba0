//! The return map of V = V_l (upward): one cycle seen from a crossing, the map's derivative, and Newton's correction.

use super::integrator::{Control, Integrator, Work};
use super::observables::Observables;
use super::section_return::{Return, ReturnEnd, next_return};
use super::stepper::Stepper;
use super::{Failure, Model, Scalar};

/// The return map over a number of returns, with the method that integrates it.
#[derive(Debug, Clone)]
pub(super) struct ReturnMap<'m, R, M> {
    pub model: &'m Model<R>,
    pub method: M,
    /// Upward crossings of V = V_l in one cycle.
    pub returns: usize,
    pub most_steps: u64,
    /// What it cost so far.
    pub work: Work,
}

/// One cycle from a crossing.
#[derive(Debug, Clone)]
pub(super) struct MappedReturn<R> {
    /// y and ζ at its start and at its end.
    pub from: [R; 2],
    pub image: [R; 2],
    pub orbit: Return<R>,
    /// Steps it took: each leaves a rounding error.
    pub steps: u64,
}

impl<'m, R: Scalar, M: Stepper<R> + Clone> ReturnMap<'m, R, M> {
    pub fn new(model: &'m Model<R>, method: M, returns: usize, most_steps: u64) -> Self {
        Self { model, method, returns, most_steps, work: Work::default() }
    }

    /// One cycle from (0, y, ζ).
    pub fn apply(&mut self, from: &[R; 2], local_tolerance: f64) -> Result<MappedReturn<R>, Failure> {
        let control = Control { local_tolerance, most_steps: self.most_steps };
        let state = [R::from(0), from[0].clone(), from[1].clone()];
        let mut run = Integrator::new(self.model, self.method.clone(), state, control)?;
        let whole = whole_cycle(&mut run, self.returns);
        self.work += run.work();
        let (accepted, _) = run.step_counts();
        let [_, y, zeta] = run.state().clone();
        Ok(MappedReturn { from: from.clone(), image: [y, zeta], orbit: whole?, steps: accepted })
    }
}

/// So many returns as one.
fn whole_cycle<R: Scalar, M: Stepper<R> + Clone>(
    run: &mut Integrator<'_, R, M>,
    returns: usize,
) -> Result<Return<R>, Failure> {
    let mut whole: Option<Return<R>> = None;
    for done in 1..=returns {
        let (orbit, end) = next_return(run)?;
        if end != ReturnEnd::Crossing {
            return Err(Failure::Undecided { cycles: done as u64, change: 1.0 });
        }
        whole = Some(match whole {
            Some(so_far) => so_far.joined(orbit),
            None => orbit,
        });
    }
    whole.ok_or(Failure::Undecided { cycles: 0, change: 1.0 })
}

impl<R: Scalar> MappedReturn<R> {
    /// Image minus start.
    pub fn residual(&self) -> [f64; 2] {
        std::array::from_fn(|i| (self.image[i].clone() - &self.from[i]).to_f64())
    }

    /// The size of the state on the section.
    pub fn size(&self) -> f64 {
        self.image.iter().fold(0.0f64, |size, c| size.max(c.to_f64().abs()))
    }
}

/// Derivatives of image and observables by the crossing.
///
/// On V = V_l quasi-static trajectories keep ζ − βy very near zero, so the crossing is described by u = βy and w = ζ − βy: a
/// difference in u stays on their surface, and w is differenced within what is there.
#[derive(Debug, Clone)]
pub(super) struct Derivative {
    effect_ratio: f64,
    image: [[f64; 2]; 2],
    /// The same with the entries that may be errors of the returns alone; elsewhere these count as zero.
    raw: [[f64; 2]; 2],
    /// Part of the momentum of the crossing over which it was differenced.
    pub width: f64,
    /// Moduli of the derivatives of the observables.
    observed: Observables<[f64; 2]>,
}

/// Relative size of the differences: their truncation error is its square.
const DIFFERENCE: f64 = 3e-4;

/// Most that a difference may be of the coordinate it changes.
const LARGEST_PART: f64 = 0.03;

/// Error of a return's end over the 3/2nd power of its tolerance, relative to a state below 1 as the tolerance is; over a difference it
/// is what a derivative can resolve.
const RETURN_ERROR: f64 = 1.0;

/// The same for the rounding errors of a return's steps, relative to any state.
const ROUNDING: f64 = 1e-14;

/// How nearly two derivatives must agree on an entry for it to be more than errors.
const AGREEMENT: f64 = 0.1;

/// y and ζ moved by u and w.
pub(super) fn shifted<R: Scalar>(from: &[R; 2], [u, w]: [f64; 2], effect_ratio: f64) -> [R; 2] {
    [from[0].clone() + R::from_f64(u / effect_ratio), from[1].clone() + R::from_f64(u + w)]
}

impl Derivative {
    /// Central differences around a crossing.
    pub fn at<M: Stepper<f64> + Clone>(
        map: &mut ReturnMap<'_, f64, M>,
        from: [f64; 2],
        local_tolerance: f64,
    ) -> Result<Self, Failure> {
        let effect_ratio = map.model.groups().effect_ratio;
        let size = from[0].abs().max(from[1].abs());
        // Trajectories cross the section upward where ζ > φ.
        let upward = map.model.imbalance(&[0.0, from[0], from[1]]).abs();
        let along = (effect_ratio * from[0]).abs();
        let steps = [along, upward]
            .map(|part| (DIFFERENCE * size).min(LARGEST_PART * part).max(1e-6 * DIFFERENCE * size));
        let return_error = RETURN_ERROR * local_tolerance * local_tolerance.sqrt();
        let zero = [[0.0; 2]; 2];
        let mut derivative = Self {
            effect_ratio,
            image: zero,
            raw: zero,
            width: steps[1] / upward,
            observed: Observables::all([0.0; 2]),
        };
        for (column, h) in steps.into_iter().enumerate() {
            let mut moved = |sign: f64| {
                let mut by = [0.0; 2];
                by[column] = sign * h;
                map.apply(&shifted(&from, by, effect_ratio), local_tolerance)
            };
            let (low, high) = (moved(-1.0)?, moved(1.0)?);
            let resolution = (return_error * size.min(1.0) + ROUNDING * size) / h;
            let slope = |difference: f64| difference / (2.0 * h);
            let image = derivative.coordinates([high.image[0] - low.image[0], high.image[1] - low.image[1]]);
            for (row, difference) in image.into_iter().enumerate() {
                let slope = slope(difference);
                derivative.raw[row][column] = slope;
                derivative.image[row][column] = if slope.abs() < resolution { 0.0 } else { slope };
            }
            let differences = Observables::differences(&high.orbit, &low.orbit);
            derivative.observed = derivative.observed.zip(differences).map(|&(mut row, difference)| {
                // Errors are bounded by these: what cannot be resolved counts with all it may be.
                row[column] = slope(difference).abs().max(resolution);
                row
            });
        }
        Ok(derivative)
    }

    fn coordinates(&self, [y, zeta]: [f64; 2]) -> [f64; 2] {
        [self.effect_ratio * y, zeta - self.effect_ratio * y]
    }

    /// The modulus of the leading multiplier.
    pub fn multiplier(&self) -> f64 {
        let [[a, b], [c, d]] = self.image;
        let half_trace = 0.5 * (a + d);
        let discriminant = 0.25 * (a - d) * (a - d) + b * c;
        if discriminant < 0.0 {
            return (a * d - b * c).abs().sqrt();
        }
        half_trace.abs() + discriminant.sqrt()
    }

    /// Takes for more than errors, however small they are, the entries on which returns at another tolerance agree.
    ///
    /// Where ln θ moves by a part in 10^8 of what the stress does, such an entry decides about a multiplier next to 1.
    pub fn confirmed_by(mut self, other: &Self) -> Self {
        for (entry, (raw, others)) in self
            .image
            .as_flattened_mut()
            .iter_mut()
            .zip(self.raw.as_flattened().iter().zip(other.raw.as_flattened()))
        {
            if (raw - others).abs() <= AGREEMENT * raw.abs() {
                *entry = *raw;
            }
        }
        self
    }

    /// How far the slow direction is from neither growing nor shrinking, whether or not unresolved entries count.
    pub fn least_neutrality(&self) -> f64 {
        neutrality(self.image).abs().min(neutrality(self.raw).abs())
    }

    /// det(1 − P') over its faster factor: how far the slow direction is from neither growing nor shrinking; negative when it grows.
    pub fn neutrality(&self) -> f64 {
        neutrality(self.image)
    }

    /// (1 − P')^{-1}.
    fn resolvent(&self) -> [[f64; 2]; 2] {
        let [[a, b], [c, d]] = self.image;
        let determinant = (1.0 - a) * (1.0 - d) - b * c;
        [[(1.0 - d) / determinant, b / determinant], [c / determinant, (1.0 - a) / determinant]]
    }

    /// How far (in u and w) the fixed point is from a crossing with this residual in y and ζ: Newton's correction.
    pub fn correction(&self, residual: [f64; 2]) -> [f64; 2] {
        let [u, w] = self.coordinates(residual);
        self.resolvent().map(|row| row[0] * u + row[1] * w)
    }

    /// The crossing moved by a correction.
    pub fn corrected<R: Scalar>(&self, from: &[R; 2], by: [f64; 2]) -> [R; 2] {
        shifted(from, by, self.effect_ratio)
    }

    /// The largest change of the observables when the crossing moves by this much.
    pub fn moved(&self, by: [f64; 2]) -> Observables<f64> {
        self.observed.map(|row| row[0] * by[0].abs() + row[1] * by[1].abs())
    }

    /// The largest change of the observables of the fixed point when the image errs by up to these amounts in y and ζ.
    pub fn worst(&self, error: [f64; 2], units: f64) -> Observables<f64> {
        let [u, w] = self.coordinates(error).map(|error| error.abs() + units);
        let resolvent = self.resolvent();
        self.moved(resolvent.map(|row| row[0].abs() * u + row[1].abs() * w))
    }
}

/// det(1 − P') over its faster factor.
fn neutrality([[a, b], [c, d]]: [[f64; 2]; 2]) -> f64 {
    let determinant = (1.0 - a) * (1.0 - d) - b * c;
    let faster = (2.0 - a - d).abs().max(determinant.abs().sqrt());
    determinant / faster
}
