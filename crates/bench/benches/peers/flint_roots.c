/* FLINT and Arb from C: enclosed roots of integer cubics, and the boundary at given normal stress. The polynomials are ready. */
#include <arb_fmpz_poly.h>
#include <flint/fmpz_poly.h>

#include "common.h"

#define OPTIONS "arb_fmpz_poly_complex_roots;flags=0;polynomials~ready"

enum { MOST = 1000 };

static fmpz_poly_t polynomials[MOST];
static acb_struct found[3 * MOST];

/* Binary digits for decimal ones. */
static slong bits(long digits) { return (slong)(digits * 3.3219281) + 8; }

/* Reads up to `most` lines of four integers, from the constant term; words before them are skipped, those after them are left. */
static long read_polynomials(FILE *file, long most, int words_before, char (*after)[4096])
{
    static char text[1 << 20];
    long count = 0;
    for (; count < most; count++) {
        for (int i = 0; i < words_before; i++)
            if (fscanf(file, "%1048575s", text) != 1)
                return count;
        fmpz_poly_init(polynomials[count]);
        for (int i = 0; i < 4; i++) {
            fmpz_t number;
            fmpz_init(number);
            if (fscanf(file, "%1048575s", text) != 1)
                return count;
            fmpz_set_str(number, text, 10);
            fmpz_poly_set_coeff_fmpz(polynomials[count], i, number);
            fmpz_clear(number);
        }
        if (after && fscanf(file, "%4095s %4095s", after[2 * count], after[2 * count + 1]) != 2)
            return count;
    }
    return count;
}

static void read_ball(arb_t number, FILE *file, slong precision)
{
    static char text[1 << 20];
    if (fscanf(file, "%1048575s", text) != 1 || arb_set_str(number, text, precision))
        arb_indeterminate(number);
}

/* The largest distance of any point of an enclosure from the nearest reference, relative. */
static void worst_distance(arb_t worst, acb_srcptr reference, long count, slong precision)
{
    arb_t size, distance, nearest;
    acb_t difference;
    arb_init(size), arb_init(distance), arb_init(nearest), acb_init(difference);
    arb_zero(worst);
    for (long i = 0; i < count; i++) {
        arb_pos_inf(nearest);
        for (int j = 0; j < 3; j++) {
            acb_sub(difference, found + i, reference + i / 3 * 3 + j, precision);
            acb_abs(distance, difference, precision);
            acb_abs(size, reference + i / 3 * 3 + j, precision);
            arb_div(distance, distance, size, precision);
            arb_get_ubound_arf(arb_midref(distance), distance, precision);
            mag_zero(arb_radref(distance));
            arb_min(nearest, nearest, distance, precision);
        }
        arb_max(worst, worst, nearest, precision);
    }
    arb_clear(size), arb_clear(distance), arb_clear(nearest), acb_clear(difference);
}

static void print_found(const char *work, long items, double seconds, const arb_t worst, long wrong)
{
    char *error = arb_get_str(worst, 3, ARB_STR_NO_RADIUS);
    printf("row work=%s method=flint-complex_roots options=" OPTIONS
           " tolerance=- items=%ld seconds=%.6e error=%s wrong=%ld steps=- evaluations=-\n",
           work, items, seconds, error, wrong);
    flint_free(error);
}

static void roots(const char *work, const char *folder)
{
    const long digits = atol(work + strlen("roots-"));
    const slong precision = bits(digits + 20);
    const char *family = strrchr(work, '-') + 1;
    char name[256];
    snprintf(name, sizeof name, "roots-%s-%ld.txt", family, digits);
    FILE *file = open_input(folder, name);
    static acb_struct reference[3 * MOST];
    long count = 0;
    for (;; count++) {
        acb_init(reference + count);
        read_ball(acb_realref(reference + count), file, precision);
        read_ball(acb_imagref(reference + count), file, precision);
        if (!acb_is_finite(reference + count))
            break;
        acb_init(found + count);
    }
    count /= 3;
    snprintf(name, sizeof name, "roots-%s.txt", family);
    count = read_polynomials(open_input(folder, name), count, 0, NULL);
    const int rounds = digits <= 100 ? 20 : 1;
    double best = INFINITY;
    for (int repetition = 0; repetition < 3; repetition++) {
        const double start = cpu_seconds();
        for (int round = 0; round < rounds; round++)
            for (long i = 0; i < count; i++)
                arb_fmpz_poly_complex_roots(found + 3 * i, polynomials[i], 0, bits(digits));
        best = fmin(best, cpu_seconds() - start);
    }
    arb_t worst;
    arb_init(worst);
    worst_distance(worst, reference, 3 * count, precision);
    print_found(work, rounds * count, best, worst, 0);
}

/* V0 = sqrt(eta a sigma D_c / M) of every positive root in eta; returns how many there are. */
static int velocities(arb_struct *into, long i, const arb_t scale, slong precision)
{
    int count = 0;
    arb_fmpz_poly_complex_roots(found, polynomials[i], 0, precision);
    for (int j = 0; j < 3; j++)
        if (arb_is_zero(acb_imagref(found + j)) && arb_is_positive(acb_realref(found + j))) {
            arb_mul(into + count, acb_realref(found + j), scale, precision);
            arb_sqrt(into + count, into + count, precision);
            count++;
        }
    return count;
}

static void boundary(const char *work, const char *folder)
{
    const long digits = atol(work + strlen("boundary-"));
    const slong precision = bits(digits), fine = bits(digits + 10);
    static char after[2 * MOST][4096];
    char name[256];
    snprintf(name, sizeof name, "boundary-%ld.txt", digits);
    const long count = read_polynomials(open_input(folder, name), MOST, 1, after);
    static arb_struct scales[MOST], reached[3 * MOST];
    int counts[MOST] = {0};
    for (long i = 0; i < count; i++) {
        fmpq_t scale;
        fmpq_init(scale);
        fmpq_set_str(scale, after[2 * i], 10);
        arb_init(scales + i);
        arb_set_fmpq(scales + i, scale, fine);
        fmpq_clear(scale);
    }
    for (long i = 0; i < 3 * MOST; i++)
        arb_init(reached + i);
    for (int i = 0; i < 3; i++)
        acb_init(found + i);
    const int rounds = 20;
    double best = INFINITY;
    for (int repetition = 0; repetition < 3; repetition++) {
        const double start = cpu_seconds();
        for (int round = 0; round < rounds; round++)
            for (long i = 0; i < count; i++)
                counts[i] = velocities(reached + 3 * i, i, scales + i, precision);
        best = fmin(best, cpu_seconds() - start);
    }
    arb_t worst, nearest, distance, expected;
    arb_init(worst), arb_init(nearest), arb_init(distance), arb_init(expected);
    long wrong = 0;
    for (long i = 0; i < count; i++) {
        wrong += counts[i] == 0;
        arb_set_str(expected, after[2 * i + 1], fine);
        arb_pos_inf(nearest);
        for (int j = 0; j < counts[i]; j++) {
            arb_sub(distance, reached + 3 * i + j, expected, fine);
            arb_div(distance, distance, expected, fine);
            arb_abs(distance, distance);
            arb_get_ubound_arf(arb_midref(distance), distance, fine);
            mag_zero(arb_radref(distance));
            arb_min(nearest, nearest, distance, fine);
        }
        if (counts[i])
            arb_max(worst, worst, nearest, fine);
    }
    print_found(work, rounds * count, best, worst, wrong);
}

int main(int count, char **words)
{
    if (count < 3) {
        printf("FLINT %s with Arb %s\n", FLINT_VERSION, arb_version);
        return 0;
    }
    if (strncmp(words[1], "boundary-", strlen("boundary-")) == 0)
        boundary(words[1], words[2]);
    else
        roots(words[1], words[2]);
    return 0;
}
