/* Times functions that CasADi has generated. The build defines GENERATED (the C file), WORK (doubles
 * of scratch), INTEGERS and, where the step is one function, FUSED. */
#include GENERATED
#include "harness.h"

static double work[WORK + 1];
static casadi_int integers[INTEGERS + 1];

static inline void correct(double *q, const Instant *at)
{
    double corrected[N];
    const double *in[16] = {q, &at->theta};
    double *out[16] = {corrected};
    newton(in, out, integers, work, 0);
    memcpy(q, corrected, sizeof corrected);
}

/* One iteration from the prediction, which is all that 1e-14 m takes. */
static void position(const Instant *from, Instant *next)
{
    predict(from, next->q);
    correct(next->q, next);
}

static void step(const Instant *from, Instant *next)
{
#ifdef FUSED
    const double *in[16] = {from->q, from->v, from->a, &next->theta, &next->rate, &next->second_rate};
    double *out[16] = {next->q, next->v, next->a};
    fused(in, out, integers, work, 0);
#else
    position(from, next);
    const double *at[16] = {next->q, &next->theta, &next->rate};
    double *speed[16] = {next->v};
    velocity(at, speed, integers, work, 0);
    const double *moving[16] = {next->q, next->v, &next->theta, &next->rate, &next->second_rate};
    double *change[16] = {next->a};
    acceleration(moving, change, integers, work, 0);
#endif
}

int main(int count, char **arguments)
{
    const char *folder = load(count, arguments);
    time_part(folder, "newton", position);
    time_part(folder, "position", position);
    time_step(folder, step);
    return 0;
}
