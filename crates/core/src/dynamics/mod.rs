//! The nonlinear slider: equations, integrators, long-term behaviour, observables.
//!
//! [`simulate`] goes from parameters in SI to observables in SI with stated errors; [`simulate_model`] is the same without units. Below
//! them: [`Model`] (equations and Jacobian in logarithms), one-step methods ([`Stepper`]), the adaptive [`Integrator`] with its
//! cycle-local clock, events refined to the order of the method, returns between upward crossings of V = V_l, and [`long_term_behaviour`], which
//! decides the long-term behaviour on the return map; [`CycleFamily`] finds cycles, stable or not, with the stiffness that they need.
//! Nothing here knows the linear theory, with one exception: where an oscillation grows or dies by less in a return than f64 resolves (`slow_pair`), the
//! roots of eq 8 and the normal form near K = K_c take the place of returns.
//!
//! # Which method, and why
//! Time of one period of the limit cycle in µs, slip law, by the cheapest tolerance that meets an error of 1e-4, 1e-8 and 1e-12 of
//! ln V_peak and of the duration (`cargo xtask bench --peers cycles`, the rows of `crates/bench/results/peers.csv`; read them as ratios):
//!
//! | case | Rodas5P | Radau 5 | Radau 9 | Radau 13 |
//! |---|---|---|---|---|
//! | σ 10^6.5 Pa, V_l 10^-5.5 m/s | 77, 364, never | **41**, 152, 1039 | 69, **74**, **132** | 124, 126, 161 |
//! | σ 10^4 Pa, V_l 10^-1.5 m/s | 33, 94, 594 | **18**, 43, 249 | 32, **33**, **56** | 54, 54, 63 |
//! | σ 10^2.5 Pa, V_l 10^-1 m/s | 67, 145, 683 | **36**, **55**, 421 | 60, 60, **93** | 90, 93, 120 |
//!
//! Radau IIA of order 9 wins from about 1e-8 down to rounding and is what [`simulate`] uses; order 13 overtakes it only at its last
//! digits. Order 5 wins above, Rodas5P nowhere. The Taylor series keeps up where a cycle never sticks (`cargo bench --bench simulation`)
//! and is useless one stick phase later, also for η ≫ 1, because the limit cycle of vibration itself sticks: V falls
//! to 1e-65 V_l and below, where e^{−x}/η is not small. [`simulate`] uses it for decays in which nothing is stiff (`smooth_decay`): a run to 1e-8
//! takes 40 to 140 µs. The library uses Rodas5P nowhere; it is in `crates/bench`.
//! [`simulate`] takes Radau IIA of order 5 for limit cycles to errors of 3e-4 and more: at a local tolerance of 1e-2 a stick-slip return is twice as
//! fast as with order 9 at 1e-3, where its 1e-8 is of no use. Neither Rodas5P (at 1e-1 a return of the aging law lost its peak) nor
//! order 13 (five times slower at loose tolerances, half of its steps refused) won anywhere in a sweep.
//! Three things took most of the steps of deep stick-slip and are gone. In a stick phase the stiffness e^{−x}/η changes by many
//! decades within a step: the row of x of each stage is scaled to the stiffness of the Jacobian, or Newton's iteration diverges beyond a factor
//! of two. A slider that stops runs into the singularity of ln V, which costs a step per factor of two of V: `arrest` takes it in one step
//! with a bound of its error. After it the steps start from the slow time scale.
//! Two more choices mattered more than the order: the Jacobian of the predicted *middle* of the step halves the iterations, and
//! Gustafsson's prediction halves the steps, because the way into an event shortens every step by the same factor.
//!
//! # Example
//! ```
//! use slipmode_core::dynamics::{Model, Options, simulate_model};
//! use slipmode_core::friction::{EvolutionLaw, Groups};
//!
//! // Without units: η, κ and β are all that the equations of motion contain.
//! let groups = Groups { inertial_parameter: 9.0, stiffness_group: 4.85, effect_ratio: 1.5 };
//! let found = simulate_model(&Model::new(groups, EvolutionLaw::Slip), &Options::at(1e-4)).unwrap();
//! assert_eq!(found.slip_mode().as_str(), "harmonic-vibration");
//! assert!(found.log_peak() > 0.0); // ln(V_peak/V_l)
//! ```

mod arrest;
mod arrow;
mod barely_stops;
mod clock;
mod collocation;
mod cycle_family;
mod cycle_fold;
mod decay;
mod dense_matrix;
mod deviations;
mod double_double_exp;
mod driven;
mod edge_law;
pub mod events;
mod failure;
mod floquet;
mod friction_work;
mod history;
mod integrator;
mod kick;
mod long_term;
mod loose_cycle;
mod model;
mod observables;
mod options;
mod outcome;
mod peak_law;
mod profile;
mod quick_exp;
mod radau;
mod refine;
mod return_errors;
mod return_map;
mod scalar;
mod search;
mod section_return;
mod sensitivity;
mod simulation;
mod slow_pair;
mod small_cycle;
mod smooth_decay;
mod start;
mod stepper;
mod taylor;
mod taylor_series;
#[cfg(test)]
mod tests;
mod threshold;
mod trajectory;

pub use arrow::{Arrow, Factors};
pub use cycle_family::{CycleFamily, Member};
pub use cycle_fold::Fold;
pub use decay::{Decay, Oscillation};
pub use deviations::oscillation_of_small_deviations;
pub use driven::{DRIVEN_PARAMETERS, Driven, DrivenControl, DrivenSlider, Piece, drive};
pub use edge_law::{EdgeOrbit, edge_orbit};
pub use failure::Failure;
pub use integrator::{Control, Integrator};
pub use kick::Kick;
pub use long_term::{Cycle, LongTerm, long_term_behaviour};
pub use model::{Balance, Model, State};
pub use options::Options;
pub use outcome::{Behaviour, Outcome, Simulation};
pub use peak_law::{DEEP, DeepCycle, PeakLaw, drop_over_impedance, least_loading};
pub use profile::{Estimate, Profile};
pub use quick_exp::exponentials;
pub use radau::Radau;
pub use scalar::Scalar;
pub use section_return::{Return, ReturnEnd, next_return};
pub use simulation::{simulate, simulate_model};
pub use start::Start;
pub use stepper::{Stepper, Trial, Weight, increment};
pub use taylor::Taylor;
pub use threshold::start_threshold;
pub use trajectory::{Sample, Trajectory, trajectory, trajectory_at};
