/* CVODE (SUNDIALS): one stick-slip cycle by BDF with the analytic Jacobian.
 *
 * With the default limits it gives up in cycles of the aging law, after 7 failed error tests or 10 failed iterations of one step.
 * Both limits are raised, so that it reduces the step further, as the other methods do. */
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_config.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include "slider.h"

#define MOST_FAILURES 1000
#define OPTIONS "BDF;dense~analytic~Jacobian;MaxErrTestFails=1000;MaxConvFails=1000"

static int rate(realtype t, N_Vector state, N_Vector out, void *model)
{
    (void)t;
    slider_rate(model, N_VGetArrayPointer(state), N_VGetArrayPointer(out));
    return isfinite(NV_Ith_S(out, 0)) ? 0 : 1;
}

static int jacobian(realtype t, N_Vector state, N_Vector out, SUNMatrix matrix, void *model, N_Vector a, N_Vector b,
                    N_Vector c)
{
    (void)t, (void)out, (void)a, (void)b, (void)c;
    double entries[3][3];
    slider_jacobian(model, N_VGetArrayPointer(state), entries);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            SM_ELEMENT_D(matrix, i, j) = entries[i][j];
    return 0;
}

/* Where the step's polynomial has x (derivative 0) or x' (derivative 1) change its sign between two times. */
static double crossing(void *solver, N_Vector work, int derivative, double low, double high)
{
    CVodeGetDky(solver, low, derivative, work);
    int sign = NV_Ith_S(work, 0) > 0;
    for (int i = 0; i < 60; i++) {
        double middle = 0.5 * (low + high);
        CVodeGetDky(solver, middle, derivative, work);
        if ((NV_Ith_S(work, 0) > 0) == sign)
            low = middle;
        else
            high = middle;
    }
    CVodeGetDky(solver, high, 0, work);
    return high;
}

/* One cycle from V = V_l; returns 0 when it ends there again. Time `far` is only a direction and a scale. */
static int cycle(struct slider *model, const double *start, double far, double tolerance, double *peak,
                 double *duration)
{
    SUNContext context;
    SUNContext_Create(NULL, &context);
    N_Vector state = N_VNew_Serial(3, context), work = N_VNew_Serial(3, context);
    memcpy(N_VGetArrayPointer(state), start, 3 * sizeof(double));
    void *solver = CVodeCreate(CV_BDF, context);
    CVodeInit(solver, rate, 0, state);
    CVodeSStolerances(solver, tolerance, tolerance);
    CVodeSetUserData(solver, model);
    CVodeSetErrFile(solver, NULL);
    CVodeSetMaxErrTestFails(solver, MOST_FAILURES);
    CVodeSetMaxConvFails(solver, MOST_FAILURES);
    SUNMatrix matrix = SUNDenseMatrix(3, 3, context);
    SUNLinearSolver linear = SUNLinSol_Dense(state, matrix, context);
    CVodeSetLinearSolver(solver, linear, matrix);
    CVodeSetJacFn(solver, jacobian);
    double time = 0, before = 0, slope = 1;
    int outcome = 1, below = 0;
    *peak = -INFINITY;
    for (long step = 0; step < 200000; step++) {
        if (CVode(solver, far, state, &time, CV_ONE_STEP) < 0)
            break;
        double x = NV_Ith_S(state, 0), last_slope = slope;
        CVodeGetDky(solver, time, 1, work);
        slope = NV_Ith_S(work, 0);
        if (x > 0 && slope < 0 && last_slope > 0) {
            crossing(solver, work, 1, before, time);
            *peak = fmax(*peak, NV_Ith_S(work, 0));
        }
        if (x > 0 && below) {
            *duration = crossing(solver, work, 0, before, time);
            outcome = 0;
            break;
        }
        below = x < 0;
        before = time;
    }
    CVodeFree(&solver);
    SUNLinSolFree(linear);
    SUNMatDestroy(matrix);
    N_VDestroy(state);
    N_VDestroy(work);
    SUNContext_Free(&context);
    return outcome;
}

int main(int count, char **words)
{
    if (count < 3) {
        printf("SUNDIALS %s\n", SUNDIALS_VERSION);
        return 0;
    }
    FILE *file = open_input(words[2], "cycles.txt");
    struct slider model;
    double given[5];
    while (read_slider(file, &model)) {
        for (int i = 0; i < 5; i++)
            if (fscanf(file, "%lf", given + i) != 1)
                return 1;
        for (int halves = FIRST_HALF_DECADE; halves <= LAST_HALF_DECADE; halves++) {
            double best = INFINITY, peak = 0, duration = 0, tolerance = tolerance_of(halves);
            int outcome = 1;
            for (int repetition = 0; repetition < 3; repetition++) {
                double start = cpu_seconds();
                outcome = cycle(&model, given, 10 * given[4], tolerance, &peak, &duration);
                best = fmin(best, cpu_seconds() - start);
            }
            char work[96];
            snprintf(work, sizeof work, "cycles-%s", model.name);
            double error = outcome ? -1 : fmax(fabs(peak - given[3]), fabs(duration / given[4] - 1));
            print_row(work, "cvode-bdf", OPTIONS, tolerance, 1, best, error, outcome);
        }
    }
    return 0;
}
