//! Colours as data: one scale for values, one set for lines, one for zones.

/// Anchors of the value scale, dark to bright.
///
/// Lightness rises evenly (OKLab L from 0.27 to 0.905) while the hue turns from indigo over teal to yellow, so the
/// order survives greyscale and the common colour deficiencies.
const VALUE_ANCHORS: [u32; 17] = [
    0x291459, 0x2b2269, 0x2c2f78, 0x2a3d87, 0x254b96, 0x155d9b, 0x036d9e, 0x087c9f, 0x228aa0, 0x189aa2,
    0x21aaa0, 0x3ab89a, 0x5bc591, 0x7dd083, 0xa3d972, 0xcbe05f, 0xf4e44d,
];

/// Colours of line series: Okabe and Ito's set, the two brightest darkened to 3 : 1 against white, yellow left out.
pub(crate) const SERIES: [&str; 6] = ["#0072b2", "#d55e00", "#008a64", "#a6468a", "#9a6b00", "#333"];

/// Dashes of line series; the first is solid.
pub(crate) const DASHES: [&str; 6] = ["", "9 3.5", "3 3", "10 3 2.5 3", "5 2 1.5 2 1.5 2", "14 4"];

/// Fills of zones: light enough for dark text at 7 : 1, apart in lightness as well as in hue.
pub(crate) const ZONES: [&str; 8] =
    ["#f4f1e8", "#cfe3f1", "#9cc9e6", "#f3c6a5", "#f6e3a1", "#d9c8e3", "#bfe0cf", "#ddd"];

/// Strokes of the zones' patterns.
pub(crate) const ZONE_INKS: [&str; 8] =
    ["#b9b19a", "#6f9dc0", "#2f7fb3", "#c26a2d", "#b8962c", "#8a68a3", "#4c9a77", "#8c8c8c"];

/// Bars of range charts from the loosest level to the strictest.
pub(crate) const LEVELS: [&str; 4] = ["#cfe0ee", "#7fb2d6", "#2c7fb8", "#08306b"];

/// Ink of axes and text on the plate.
pub(crate) const INK: &str = "#1f2328";
/// Ink of secondary lines: frames, ticks.
pub(crate) const FAINT_INK: &str = "#59636e";
/// Lines of the grid.
pub(crate) const GRID: &str = "#e3e6ea";
/// The plate behind everything.
pub(crate) const PLATE: &str = "#fff";

/// Colour of step `index` out of `steps` on the value scale, as `#rrggbb`.
pub(crate) fn value_colour(index: usize, steps: usize) -> String {
    let last = VALUE_ANCHORS.len() - 1;
    let (numerator, denominator) = (index * last, (steps - 1).max(1));
    let (at, rest) = ((numerator / denominator).min(last), numerator % denominator);
    let (low, high) = (VALUE_ANCHORS[at], VALUE_ANCHORS[(at + 1).min(last)]);
    let mix = |shift: u32| {
        let (from, to) = ((low >> shift & 255) as usize, (high >> shift & 255) as usize);
        (from * (denominator - rest) + to * rest + denominator / 2) / denominator
    };
    format!("#{:02x}{:02x}{:02x}", mix(16), mix(8), mix(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance as WCAG 2 defines it.
    fn luminance(colour: &str) -> f64 {
        let digits = (colour.len() - 1) / 3;
        let largest = f64::from((1 << (4 * digits)) - 1);
        let channel = |index: usize| {
            let at = 1 + index * digits;
            let c = f64::from(u8::from_str_radix(&colour[at..at + digits], 16).unwrap()) / largest;
            if c <= 0.04045 { c / 12.92 } else { libm::pow((c + 0.055) / 1.055, 2.4) }
        };
        0.2126 * channel(0) + 0.7152 * channel(1) + 0.0722 * channel(2)
    }

    fn contrast(one: &str, other: &str) -> f64 {
        let (a, b) = (luminance(one) + 0.05, luminance(other) + 0.05);
        if a > b { a / b } else { b / a }
    }

    #[test]
    fn the_value_scale_rises_in_luminance_at_every_step() {
        for steps in [2, 7, 20, 40, 64] {
            let scale: Vec<f64> = (0..steps).map(|i| luminance(&value_colour(i, steps))).collect();
            assert!(scale.windows(2).all(|pair| pair[0] < pair[1]), "{steps}: {scale:?}");
        }
        assert_eq!(value_colour(0, 20), "#291459");
        assert_eq!(value_colour(19, 20), "#f4e44d");
    }

    #[test]
    fn lines_and_text_stand_out_from_what_is_behind_them() {
        assert!(SERIES.iter().all(|colour| contrast(colour, PLATE) >= 3.0));
        assert!(ZONES.iter().all(|fill| contrast(fill, INK) >= 7.0));
        assert!(contrast(FAINT_INK, PLATE) >= 4.5);
    }
}
