/* MPSolve: roots of integer cubics to many digits by both of its algorithms; each root comes with an inclusion radius.
 *
 * One thread. The polynomials are ready; a context serves one polynomial, so that making it is part of the work. */
#include <gmp.h>
#include <mps/mps.h>

#include "common.h"

enum { MOST = 1000 };

/* In the library, but in none of its installed headers. */
void mps_thread_pool_set_concurrency_limit(mps_context *context, mps_thread_pool *pool, unsigned int limit);

static mpz_t cubics[MOST][4];
static mpc_t found[3 * MOST];

static mps_monomial_poly *polynomial_of(mps_context *context, mpz_t *cubic)
{
    mps_monomial_poly *polynomial = mps_monomial_poly_new(context, 3);
    mpq_t real, imaginary;
    mpq_init(real);
    mpq_init(imaginary);
    for (int i = 0; i < 4; i++) {
        mpq_set_z(real, cubic[i]);
        mps_monomial_poly_set_coefficient_q(context, polynomial, i, real, imaginary);
    }
    mpq_clear(real);
    mpq_clear(imaginary);
    return polynomial;
}

static void solve(mpz_t *cubic, mps_algorithm algorithm, long digits, mpc_t *into)
{
    mps_context *context = mps_context_new();
    mps_monomial_poly *polynomial = polynomial_of(context, cubic);
    mps_context_set_input_poly(context, MPS_POLYNOMIAL(polynomial));
    mps_context_select_algorithm(context, algorithm);
    mps_context_set_output_goal(context, MPS_OUTPUT_GOAL_APPROXIMATE);
    mps_context_set_output_prec(context, (long)(digits * 3.3219281) + 8);
    mps_mpsolve(context);
    mps_context_get_roots_m(context, &into, NULL);
    mps_monomial_poly_free(context, MPS_POLYNOMIAL(polynomial));
    mps_context_free(context);
}

/* |root - (re + i im)| / |re + i im|, as a number with a wide exponent. */
static void distance(mpf_t out, mpc_t root, mpf_t re, mpf_t im)
{
    mpf_t a, b, modulus;
    mpf_inits(a, b, modulus, NULL);
    mpf_sub(a, mpc_Re(root), re), mpf_sub(b, mpc_Im(root), im);
    mpf_mul(a, a, a), mpf_mul(b, b, b), mpf_add(out, a, b);
    mpf_mul(a, re, re), mpf_mul(b, im, im), mpf_add(modulus, a, b);
    mpf_div(out, out, modulus);
    mpf_sqrt(out, out);
    mpf_clears(a, b, modulus, NULL);
}

/* One row: all cubics by one algorithm. */
static void measure(const char *work, const char *method, mps_algorithm algorithm, long digits, long count,
                    mpf_t (*reference)[2])
{
    double best = INFINITY;
    for (int repetition = 0; repetition < 2; repetition++) {
        double start = cpu_seconds();
        for (long i = 0; i < count; i++)
            solve(cubics[i], algorithm, digits, found + 3 * i);
        best = fmin(best, cpu_seconds() - start);
    }
    mpf_t worst, nearest, other;
    mpf_inits(worst, nearest, other, NULL);
    for (long i = 0; i < 3 * count; i++) {
        distance(nearest, found[i], reference[i / 3 * 3][0], reference[i / 3 * 3][1]);
        for (int j = 1; j < 3; j++) {
            distance(other, found[i], reference[i / 3 * 3 + j][0], reference[i / 3 * 3 + j][1]);
            if (mpf_cmp(other, nearest) < 0)
                mpf_set(nearest, other);
        }
        if (mpf_cmp(nearest, worst) > 0)
            mpf_set(worst, nearest);
    }
    char error[64];
    gmp_snprintf(error, sizeof error, "%.2Fe", worst);
    printf("row work=%s method=%s options=goal=approximate;one~thread tolerance=- items=%ld seconds=%.6e error=%s wrong=0 steps=- "
           "evaluations=-\n", work, method, count, best, error);
    mpf_clears(worst, nearest, other, NULL);
}

int main(int words, char **word)
{
    if (words < 3) {
        printf("MPSolve 3.2\n");
        return 0;
    }
    long digits = atol(word[1] + strlen("roots-"));
    const char *family = strrchr(word[1], '-') + 1;
    mpf_set_default_prec((unsigned long)(digits * 3.3219281) + 128);
    char name[256];
    snprintf(name, sizeof name, "roots-%s-%ld.txt", family, digits);
    FILE *file = open_input(word[2], name);
    static mpf_t reference[3 * MOST][2];
    long roots = 0;
    for (;; roots++) {
        mpf_inits(reference[roots][0], reference[roots][1], NULL);
        if (!mpf_inp_str(reference[roots][0], file, 10) || !mpf_inp_str(reference[roots][1], file, 10))
            break;
    }
    long count = roots / 3;
    snprintf(name, sizeof name, "roots-%s.txt", family);
    file = open_input(word[2], name);
    for (long i = 0; i < count; i++)
        for (int j = 0; j < 4; j++) {
            mpz_init(cubics[i][j]);
            mpz_inp_str(cubics[i][j], file, 10);
        }
    for (long i = 0; i < 3 * count; i++)
        mpc_init2(found[i], (unsigned long)(digits * 3.3219281) + 128);
    mps_context *context = mps_context_new();
    mps_thread_pool_set_concurrency_limit(context, NULL, 1);
    mps_context_free(context);
    measure(word[1], "mpsolve-secular", MPS_ALGORITHM_SECULAR_GA, digits, count, reference);
    measure(word[1], "mpsolve-standard", MPS_ALGORITHM_STANDARD_MPSOLVE, digits, count, reference);
    return 0;
}
