/* Batches over the recorded motion, the same for every native rival. They are short, a part of
 * a scheduler's slice, so that other load on the machine falls into few of them.
 *
 * The program is called with the file of starts and a folder. For each quantity it prints
 * `quantity,nanoseconds,spread` (median of the batches and interquartile range, a call each)
 * and writes to `FOLDER/quantity.bin` what was computed at steps 1 to STEPS, 45 numbers each. */
#ifndef HARNESS_H
#define HARNESS_H
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { N = 15, STEPS = 1900, STRIDE = 30, CHUNK = 100, ROUNDS = 100, MOST_BATCHES = 2000 };
static const double DT = 1e-3;

typedef struct {
    double theta, rate, second_rate;
    double q[N], v[N], a[N];
} Instant;

static Instant starts[STEPS + 1];
static Instant found[STEPS + 1];

static inline void predict(const Instant *from, double *q)
{
    for (int i = 0; i < N; i++)
        q[i] = from->q[i] + (from->v[i] + from->a[i] * (DT * 0.5)) * DT;
}

/* From the motion at one instant to the drive of the next, written to `next`. */
typedef void (*Method)(const Instant *from, Instant *next);

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

static void drives(void)
{
    for (int k = 0; k <= STEPS; k++) {
        found[k].theta = starts[k].theta;
        found[k].rate = starts[k].rate;
        found[k].second_rate = starts[k].second_rate;
    }
}

static double batches[MOST_BATCHES];

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void report(const char *folder, const char *quantity, int count)
{
    qsort(batches, count, sizeof *batches, ascending);
    double spread = batches[3 * count / 4] - batches[count / 4];
    printf("%s,%.2f,%.2f\n", quantity, batches[count / 2], spread);
    char path[4096];
    snprintf(path, sizeof path, "%s/%s.bin", folder, quantity);
    FILE *file = fopen(path, "wb");
    if (!file) {
        fprintf(stderr, "%s: cannot be written\n", path);
        exit(1);
    }
    for (int k = 1; k <= STEPS; k++)
        fwrite(found[k].q, sizeof(double), 3 * N, file);
    fclose(file);
}

/* A step of the control loop: each starts from the last result; a batch is CHUNK steps. */
static inline __attribute__((always_inline)) void time_step(const char *folder, Method method)
{
    int count = 0;
    found[0] = starts[0];
    for (int round = 0; round < ROUNDS; round++)
        for (int chunk = 0; chunk < STEPS; chunk += CHUNK) {
            double begin = now();
            for (int k = chunk; k < chunk + CHUNK; k++)
                method(&found[k], &found[k + 1]);
            batches[count++] = (now() - begin) / CHUNK;
        }
    report(folder, "step", count);
}

/* A part of the step, from recorded starts; a batch is one call from each of 64 of them. The
 * result is kept from being optimised away. */
static inline __attribute__((always_inline)) void time_part(const char *folder, const char *quantity,
                                                            Method method)
{
    Instant next = {0};
    for (int k = 0; k < STEPS; k++) {
        memset(found[k + 1].v, 0, sizeof found[k + 1].v);
        memset(found[k + 1].a, 0, sizeof found[k + 1].a);
        method(&starts[k], &found[k + 1]);
    }
    for (int round = 0; round < MOST_BATCHES; round++) {
        double begin = now();
        for (int k = 0; k < STEPS; k += STRIDE) {
            next.theta = starts[k + 1].theta;
            method(&starts[k], &next);
            __asm__ volatile("" : : "r"(&next) : "memory");
        }
        batches[round] = (now() - begin) / ((STEPS + STRIDE - 1) / STRIDE);
    }
    report(folder, quantity, MOST_BATCHES);
}

static const char *load(int count, char **arguments)
{
    FILE *file = count == 3 ? fopen(arguments[1], "rb") : NULL;
    if (!file || fread(starts, sizeof(Instant), STEPS + 1, file) != STEPS + 1) {
        fprintf(stderr, "usage: %s STARTS FOLDER\n", arguments[0]);
        exit(2);
    }
    fclose(file);
    drives();
    return arguments[2];
}
#endif
