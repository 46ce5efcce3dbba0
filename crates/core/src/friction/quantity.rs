//! The seven physical inputs of the spring-slider: their names in scenes, CSV files, messages and on the command line.

slipmode_algebra::named! {
    /// An input of the slider, by its name with its unit of SI; in the order of columns and options.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Quantity {
        /// a of eq 1, dimensionless.
        DirectEffect = "direct_effect",
        /// b of eq 1, dimensionless.
        EvolutionEffect = "evolution_effect",
        /// D_c, m.
        CriticalSlipDistance = "critical_slip_distance_m",
        /// K, Pa/m.
        Stiffness = "stiffness_pa_per_m",
        /// M, kg/m².
        MassPerArea = "mass_per_area_kg_per_m2",
        /// σ, Pa.
        NormalStress = "normal_stress_pa",
        /// V0, m/s.
        LoadingVelocity = "loading_velocity_m_per_s",
    }
}

impl Quantity {
    /// Those of the material and the machine.
    pub const OF_THE_SLIDER: [Self; 5] = {
        let [a, b, d, k, m, ..] = Self::ALL;
        [a, b, d, k, m]
    };
}
