//! Transition K = K_c, boundary max Im(s) = 0, its asymptotes and how far off they are.
