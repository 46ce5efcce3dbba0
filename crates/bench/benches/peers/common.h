/* What the C and C++ players share: CPU time, and the row that every player prints. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static double cpu_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

/* One row; options are words joined by `;`, with `~` for a blank, a tolerance of 0 and a negative error are none. */
static inline void print_row(const char *work, const char *method, const char *options, double tolerance, long items,
                             double seconds, double error, long wrong)
{
    char asked[32] = "-", found[32] = "-";
    if (tolerance > 0)
        snprintf(asked, sizeof asked, "%.2e", tolerance);
    if (error >= 0)
        snprintf(found, sizeof found, "%.2e", error);
    printf("row work=%s method=%s options=%s tolerance=%s items=%ld seconds=%.6e error=%s wrong=%ld steps=- evaluations=-\n",
           work, method, options, asked, items, seconds, found, wrong);
    fflush(stdout);
}

static inline FILE *open_input(const char *folder, const char *name)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "rb");
    if (!file) {
        perror(path);
        exit(1);
    }
    return file;
}
