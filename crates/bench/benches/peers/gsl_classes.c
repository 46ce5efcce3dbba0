/* GSL: signs, extremes and roots of many points by gsl_poly_complex_solve_cubic. */
#include <gsl/gsl_poly.h>
#include <gsl/gsl_version.h>

#include "common.h"

enum { COLUMNS = 24 };

struct point {
    double root[3][2];
    double real, imaginary;
};

static struct point solve(const double *table, long count, long i)
{
    double direct_stress = table[i] * table[5 * count + i], velocity = table[6 * count + i];
    double distance = table[2 * count + i];
    double eta = table[4 * count + i] * velocity * velocity / (direct_stress * distance);
    double kappa = table[3 * count + i] * distance / direct_stress;
    double beta = table[count + i] / table[i], rate = velocity / distance;
    gsl_complex roots[3];
    gsl_poly_complex_solve_cubic((1 + eta) / eta, (kappa + 1 - beta) / eta, kappa / eta, roots, roots + 1, roots + 2);
    struct point found = {.real = -INFINITY, .imaginary = 0};
    for (int j = 0; j < 3; j++) {
        found.root[j][0] = GSL_REAL(roots[j]) * rate;
        found.root[j][1] = GSL_IMAG(roots[j]) * rate;
        found.real = fmax(found.real, found.root[j][0]);
        found.imaginary = fmax(found.imaginary, found.root[j][1]);
    }
    return found;
}

/* Of max Re relative to that root's modulus, and of max Im relative to itself. */
static double extreme_error(const struct point *found, const double *table, long count, long i)
{
    double error = fabs(found->real - table[9 * count + i]) / table[10 * count + i];
    if (table[11 * count + i] > 0)
        error = fmax(error, fabs(found->imaginary / table[11 * count + i] - 1));
    return error;
}

/* The worst distance of a root from the nearest exact one, relative to the modulus of that. */
static double root_error(const struct point *found, const double *table, long count, long i)
{
    double worst = 0;
    for (int j = 0; j < 3; j++) {
        double nearest = INFINITY;
        for (int k = 0; k < 3; k++) {
            double re = table[(12 + 2 * k) * count + i], im = table[(13 + 2 * k) * count + i];
            nearest = fmin(nearest, hypot(found->root[j][0] - re, found->root[j][1] - im) / hypot(re, im));
        }
        worst = fmax(worst, nearest);
    }
    return worst;
}

int main(int count_of_words, char **words)
{
    if (count_of_words < 3) {
        printf("GSL %s\n", gsl_version);
        return 0;
    }
    int is_signs = strncmp(words[1], "signs-", 6) == 0, is_extremes = strncmp(words[1], "extremes-", 9) == 0;
    char name[256];
    snprintf(name, sizeof name, "points-%s.f64", strchr(words[1], '-') + 1);
    FILE *file = open_input(words[2], name);
    fseek(file, 0, SEEK_END);
    long count = ftell(file) / (long)(COLUMNS * sizeof(double));
    rewind(file);
    double *table = malloc(COLUMNS * sizeof(double) * count);
    struct point *found = malloc(sizeof(struct point) * count);
    if (fread(table, COLUMNS * sizeof(double), count, file) != (size_t)count)
        return 1;
    double best = INFINITY;
    for (int repetition = 0; repetition < 3; repetition++) {
        double start = cpu_seconds();
        for (long i = 0; i < count; i++)
            found[i] = solve(table, count, i);
        best = fmin(best, cpu_seconds() - start);
    }
    long wrong = 0;
    double error = is_signs ? -1 : 0;
    for (long i = 0; i < count; i++) {
        double transition = (found[i].real < 0) - (found[i].real > 0), boundary = found[i].imaginary > 0 ? -1 : 1;
        if (!(transition == table[7 * count + i] && boundary == table[8 * count + i]))
            wrong++;
        else if (!is_signs)
            error = fmax(error, (is_extremes ? extreme_error : root_error)(found + i, table, count, i));
    }
    print_row(words[1], "gsl-complex_solve_cubic", "one~call~for~each~point", 0, count, best, error, wrong);
    return 0;
}
