/* The nonlinear slider in x = ln(V/V_l), y = ln(V_l theta/D_c) and zeta, with its Jacobian; and one line of an input file. */
#include "common.h"

struct slider {
    char name[64];
    int aging;
    double eta, kappa, beta;
};

/* Tolerances of every method: 10^-1.5, 10^-2 ... 10^-12. */
enum { FIRST_HALF_DECADE = 3, LAST_HALF_DECADE = 24 };

static inline double tolerance_of(int half_decades) { return pow(10, -0.5 * half_decades); }

/* Reads name, law and groups; the caller reads what follows. */
static inline int read_slider(FILE *file, struct slider *model)
{
    char law[16];
    if (fscanf(file, "%63s %15s %lf %lf %lf", model->name, law, &model->eta, &model->kappa, &model->beta) != 5)
        return 0;
    model->aging = strcmp(law, "aging") == 0;
    return 1;
}

static inline void slider_rate(const struct slider *model, const double *state, double *rate)
{
    double x = state[0], y = state[1], u = exp(x);
    rate[0] = (state[2] - x - model->beta * y) / (u * model->eta);
    rate[1] = model->aging ? exp(-y) - u : -u * (x + y);
    rate[2] = -model->kappa * expm1(x);
}

static inline void slider_jacobian(const struct slider *model, const double *state, double jacobian[3][3])
{
    double x = state[0], y = state[1], u = exp(x), stiff = 1 / (u * model->eta);
    jacobian[0][0] = -stiff * (1 + state[2] - x - model->beta * y);
    jacobian[0][1] = -stiff * model->beta;
    jacobian[0][2] = stiff;
    jacobian[1][0] = model->aging ? -u : -u * (x + y + 1);
    jacobian[1][1] = model->aging ? -exp(-y) : -u;
    jacobian[1][2] = 0;
    jacobian[2][0] = -model->kappa * u;
    jacobian[2][1] = jacobian[2][2] = 0;
}
