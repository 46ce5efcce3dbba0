//! Kahan's iteration for one real root of a cubic (*To solve a real cubic equation*, 1986).

/// Kahan's iteration in 64-bit: from outside the three roots to the one farthest from the inflection point, monotonically.
pub(super) fn kahan_root([c0, c1, c2, c3]: [f64; 4]) -> f64 {
    let evaluate = |x: f64| {
        let lead = c3 * x;
        let first = lead + c2;
        let second = first * x + c1;
        (second * x + c0, (lead + first) * x + second)
    };
    let inflection = -(c2 / c3) / 3.0;
    let (value, slope) = evaluate(inflection);
    let height = value / c3;
    let direction = if height < 0.0 { -1.0 } else { 1.0 };
    let descent = -slope / c3;
    let mut reach = libm::cbrt(height.abs());
    if descent > 0.0 {
        // The root of x³ = x + 1 bounds the distance for both shapes of the cubic.
        reach = 1.324_717_957_244_746 * reach.max(descent.sqrt());
    }
    let mut next = inflection - direction * reach;
    let mut root = inflection;
    if next == inflection {
        return root;
    }
    let mut first = true;
    while first || direction * next > direction * root {
        first = false;
        root = next;
        let (value, slope) = evaluate(root);
        next = root - value / slope;
    }
    root
}
