/* GSL: class of many points by gsl_poly_complex_solve_cubic. */
#include <gsl/gsl_poly.h>
#include <gsl/gsl_version.h>

#include "common.h"

enum { COLUMNS = 12 };

struct largest {
    double real, imaginary;
};

static struct largest solve(const double *table, long count, long i)
{
    double direct_stress = table[i] * table[5 * count + i], velocity = table[6 * count + i];
    double distance = table[2 * count + i];
    double eta = table[4 * count + i] * velocity * velocity / (direct_stress * distance);
    double kappa = table[3 * count + i] * distance / direct_stress;
    double beta = table[count + i] / table[i], rate = velocity / distance;
    gsl_complex roots[3];
    gsl_poly_complex_solve_cubic((1 + eta) / eta, (kappa + 1 - beta) / eta, kappa / eta, roots, roots + 1, roots + 2);
    struct largest found = {-INFINITY, 0};
    for (int j = 0; j < 3; j++) {
        found.real = fmax(found.real, GSL_REAL(roots[j]) * rate);
        found.imaginary = fmax(found.imaginary, GSL_IMAG(roots[j]) * rate);
    }
    return found;
}

int main(int count_of_words, char **words)
{
    if (count_of_words < 3) {
        printf("GSL %s\n", gsl_version);
        return 0;
    }
    char name[256];
    snprintf(name, sizeof name, "%s.f64", words[1] + strlen("classes-"));
    FILE *file = open_input(words[2], name);
    fseek(file, 0, SEEK_END);
    long count = ftell(file) / (long)(COLUMNS * sizeof(double));
    rewind(file);
    double *table = malloc(COLUMNS * sizeof(double) * count);
    struct largest *found = malloc(sizeof(struct largest) * count);
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
    double error = 0;
    for (long i = 0; i < count; i++) {
        double transition = (found[i].real < 0) - (found[i].real > 0), boundary = found[i].imaginary > 0 ? -1 : 1;
        if (!(transition == table[7 * count + i] && boundary == table[8 * count + i])) {
            wrong++;
            continue;
        }
        error = fmax(error, fabs(found[i].real - table[9 * count + i]) / table[10 * count + i]);
        if (boundary < 0)
            error = fmax(error, fabs(found[i].imaginary / table[11 * count + i] - 1));
    }
    print_row(words[1], "gsl-complex_solve_cubic", 0, count, best, error, wrong);
    return 0;
}
