/* What is asked of a general multibody engine: the step as of every other rival; the forces of four
 * rods under one load; and what it does past the lock.
 *
 * An engine is a class with
 *   Engine(const Instant &first)        the mechanism in its first motion
 *   const char *step(const Instant &to) to the drive of `to`; what went wrong, or null
 *   void motion(Instant &) const        of the five points
 *   void rods(double tension[RODS])     under LOAD, at rest where the mechanism is
 * It adds to what the harness prints `lock,what it does`, and writes `FOLDER/rods.bin`. */
#ifndef ENGINE_H
#define ENGINE_H
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>

#include "geometry.h"
#include "harness.h"

enum { RODS = 4, LOADED = 100, PAST_LOCK = 2100 };
/* For the engines that solve dynamics: the knuckle's, on which no result here depends. */
static const double MASS = 20, INERTIA = 0.3;

template <class Engine> struct Measured {
    static inline std::unique_ptr<Engine> engine;

    /* A round begins anew. */
    static void step(const Instant *from, Instant *next)
    {
        if (from == found)
            engine = std::make_unique<Engine>(starts[0]);
        engine->step(*next);
        engine->motion(*next);
    }
};

/* The largest difference of a rod from its length, m. */
static inline double stretch(const Instant &at)
{
    double worst = 0;
    for (const Outer &link : OUTER) {
        double square = 0;
        for (int i = 0; i < 3; i++)
            square += std::pow(at.q[link.point + i] - link.chassis[i], 2);
        double off = std::fabs(std::sqrt(square) - link.length);
        worst = off > worst || off != off ? off : worst;
    }
    return worst;
}

static inline Instant driven(int k)
{
    Instant to = {};
    double t = k * DT;
    to.theta = THETA[0] + (THETA[1] + THETA[2] * t) * t;
    to.rate = THETA[1] + 2 * THETA[2] * t;
    to.second_rate = 2 * THETA[2];
    return to;
}

/* Follows the drive past the lock until the engine says something. */
template <class Engine> static void past_lock()
{
    double off = 0;
    int k = 1;
    try {
        Engine engine(starts[0]);
        for (; k <= PAST_LOCK; k++) {
            Instant at = driven(k);
            const char *wrong = engine.step(at);
            if (wrong) {
                printf("lock,%s at t = %.3f s\n", wrong, k * DT);
                return;
            }
            engine.motion(at);
            off = stretch(at);
        }
        printf("lock,silent; at t = %.1f s a rod is %.0f mm off\n", PAST_LOCK * DT, off * 1e3);
    } catch (const std::exception &error) {
        printf("lock,exception at t = %.3f s\n", k * DT);
    }
}

template <class Engine> static void loaded(const char *folder)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/rods.bin", folder);
    FILE *file = fopen(path, "wb");
    if (!file) {
        fprintf(stderr, "%s: cannot be written\n", path);
        exit(1);
    }
    Engine engine(starts[0]);
    for (int k = 1; k < STEPS; k++) {
        engine.step(starts[k]);
        if (k % LOADED == 0) {
            double tension[RODS];
            engine.rods(tension);
            fwrite(tension, sizeof(double), RODS, file);
        }
    }
    fclose(file);
}

template <class Engine> static int measure(int count, char **arguments)
{
    const char *folder = load(count, arguments);
    time_step(folder, Measured<Engine>::step);
    loaded<Engine>(folder);
    past_lock<Engine>();
    return 0;
}
#endif
