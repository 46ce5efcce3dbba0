//! Eigenvalues of the balanced companion matrix by Francis's double-shift QR steps (1961), as numerical packages do it.

use num_complex::Complex;

use super::Three;

type Matrix = [[f64; 3]; 3];

/// Steps after which the iteration counts as failed.
const MOST_STEPS: usize = 60;

/// The eigenvalues of the companion matrix of the cubic divided by c3; not a number when the steps are used up.
#[must_use]
pub fn companion([c0, c1, c2, c3]: [f64; 4]) -> Three {
    let mut matrix = [[-c2 / c3, -c1 / c3, -c0 / c3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    if matrix[0].iter().any(|entry| !entry.is_finite()) {
        return [Complex::new(f64::NAN, f64::NAN); 3];
    }
    balance(&mut matrix);
    for step in 0..MOST_STEPS {
        if is_negligible(&matrix, 2) {
            let [first, second] = of_block(&matrix, 0);
            return [first, second, Complex::from(matrix[2][2])];
        }
        if is_negligible(&matrix, 1) {
            let [second, third] = of_block(&matrix, 1);
            return [Complex::from(matrix[0][0]), second, third];
        }
        francis_step(&mut matrix, step % 10 == 9);
    }
    [Complex::new(f64::NAN, f64::NAN); 3]
}

/// Scales rows and columns by powers of two until their sizes agree (Parlett & Reinsch 1969).
fn balance(matrix: &mut Matrix) {
    let mut changed = true;
    while changed {
        changed = false;
        for i in [0, 1, 2] {
            let others = (0..3).filter(|&j| j != i);
            let column: f64 = others.clone().map(|j| matrix[j][i].abs()).sum();
            let row: f64 = others.map(|j| matrix[i][j].abs()).sum();
            if column == 0.0 || row == 0.0 {
                continue;
            }
            let mut scale = 1.0;
            while column * scale * scale < row / 2.0 {
                scale *= 2.0;
            }
            while column * scale * scale >= row * 2.0 {
                scale /= 2.0;
            }
            if (column * scale + row / scale) < 0.95 * (column + row) {
                changed = true;
                for j in [0, 1, 2] {
                    matrix[i][j] /= scale;
                    matrix[j][i] *= scale;
                }
            }
        }
    }
}

/// Whether the entry below the diagonal in this row may be dropped without harm to small eigenvalues (Ahues & Tisseur 1997).
fn is_negligible(matrix: &Matrix, row: usize) -> bool {
    let (above, below) = (matrix[row - 1][row].abs(), matrix[row][row - 1].abs());
    let corner = matrix[row][row].abs();
    let gap = (matrix[row - 1][row - 1] - matrix[row][row]).abs();
    if below > f64::EPSILON * (matrix[row - 1][row - 1].abs() + corner) {
        return false;
    }
    let sum = corner.max(gap) + above.max(below);
    let product = above.min(below) * (above.max(below) / sum);
    below == 0.0 || product <= f64::EPSILON * (corner.min(gap) * (corner.max(gap) / sum))
}

/// The eigenvalues of the 2 × 2 block that begins at `first` on the diagonal.
fn of_block(matrix: &Matrix, first: usize) -> [Complex<f64>; 2] {
    let last = first + 1;
    let (a, b, c, d) = (matrix[first][first], matrix[first][last], matrix[last][first], matrix[last][last]);
    let half = 0.5 * (a - d);
    let product = b * c;
    let discriminant = half * half + product;
    if discriminant < 0.0 {
        let im = (-discriminant).sqrt();
        return [Complex::new(d + half, im), Complex::new(d + half, -im)];
    }
    let far = half + half.signum() * discriminant.sqrt();
    let near = if far == 0.0 { d } else { d - product / far };
    [Complex::from(d + far), Complex::from(near)]
}

/// One double-shift step; an exceptional one shakes an iteration that goes in circles.
fn francis_step(matrix: &mut Matrix, exceptional: bool) {
    let h = &*matrix;
    let (sum, product) = if exceptional {
        let size = h[2][1].abs() + h[1][0].abs();
        (1.5 * size, size * size)
    } else {
        (h[1][1] + h[2][2], h[1][1] * h[2][2] - h[1][2] * h[2][1])
    };
    // The first column of H² − sum·H + product.
    let first = [
        h[0][0] * h[0][0] + h[0][1] * h[1][0] - sum * h[0][0] + product,
        h[1][0] * (h[0][0] + h[1][1] - sum),
        h[1][0] * h[2][1],
    ];
    reflect(matrix, first);
    reflect(matrix, [0.0, matrix[1][0], matrix[2][0]]);
    matrix[2][0] = 0.0;
}

/// The similarity by the Householder reflection that turns this vector into its first non-zero direction.
fn reflect(matrix: &mut Matrix, vector: [f64; 3]) {
    let lead = if vector[0] == 0.0 { 1 } else { 0 };
    let largest = vector.iter().fold(0.0f64, |largest, entry| largest.max(entry.abs()));
    if largest == 0.0 {
        return;
    }
    let mut v = vector.map(|entry| entry / largest);
    let norm = v.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
    v[lead] += if v[lead] < 0.0 { -norm } else { norm };
    let scale = 2.0 / v.iter().map(|entry| entry * entry).sum::<f64>();
    for j in [0, 1, 2] {
        let dot = scale * (0..3).map(|i| v[i] * matrix[i][j]).sum::<f64>();
        (0..3).for_each(|i| matrix[i][j] -= dot * v[i]);
    }
    for row in matrix.iter_mut() {
        let dot = scale * (0..3).map(|j| row[j] * v[j]).sum::<f64>();
        (0..3).for_each(|j| row[j] -= dot * v[j]);
    }
}
