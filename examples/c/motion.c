/*
 * A five-link suspension through its published motion (H. A. Attia, KSME International Journal 17(8),
 * 2003) in steps of a millisecond of fixed cost: the quantities of its wheel, and the loads on its links due to
 * weight and inertia of its parts and 3 kN at an end of a link.
 *
 * In float, or in double if DOUBLE is defined. The last column is a checksum of the bits of everything
 * computed so far: suspension-c/examples/motion.rs, the same program in Rust, prints the same.
 */
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#ifdef DOUBLE
#include "suspension_five_link_f64.h"
typedef double number;
#define SUSP(name) susp_f64_##name
#define FIVE_LINK(name) susp_five_link_f64_##name
#else
#include "suspension_five_link_f32.h"
typedef float number;
#define SUSP(name) susp_f32_##name
#define FIVE_LINK(name) susp_five_link_f32_##name
#endif

enum { STEPS = 1900, STEPS_A_ROW = 100 };

/* Metres. The ends of the links on the knuckle are a guess, because the lengths are stated. */
static const FIVE_LINK(points) guess = {
    .lower_front_inner = {-1.396, -0.025, -0.082},
    .upper_front_inner = {-1.301, 0.1168, 0.106},
    .upper_rear_inner = {-1.0941, 0.1987, 0.09},
    .lower_rear_inner = {-0.9838, 0.2609, -0.0501},
    .track_rod_inner = {-1.095, 0.183, -0.0158},
    .lower_front_outer = {-1.324, 0.415, -0.059},
    .upper_front_outer = {-1.327, 0.41, 0.155},
    .upper_rear_outer = {-1.287, 0.345, 0.14},
    .lower_rear_outer = {-1.29, 0.325, -0.084},
    .track_rod_outer = {-1.212, 0.453, 0.089},
    .wheel_centre = {-1.287, 0.445, 0.14},
};

static const FIVE_LINK(lengths) lengths = {
    .lower_front = 0.445872,
    .upper_front = 0.298452,
    .upper_rear = 0.247006,
    .lower_rear = 0.315105,
    .track_rod = 0.311988,
    .knuckle_lower_front_outer_upper_front_outer = 0.214453,
    .knuckle_lower_front_outer_upper_rear_outer = 0.214367,
    .knuckle_upper_front_outer_upper_rear_outer = 0.078413,
    .knuckle_lower_rear_outer_lower_front_outer = 0.098894,
    .knuckle_lower_rear_outer_upper_front_outer = 0.256446,
    .knuckle_lower_rear_outer_upper_rear_outer = 0.224708,
    .knuckle_track_rod_outer_lower_front_outer = 0.190070,
    .knuckle_track_rod_outer_upper_front_outer = 0.139680,
    .knuckle_track_rod_outer_upper_rear_outer = 0.141405,
};

/* The number of a point. */
#define POINT(name) (offsetof(FIVE_LINK(points), name) / sizeof(number[3]))

/* kg, m and kg m^2, for the points where the lower leading link is level. */
static const SUSP(mass) parts[] = {
    {.count = 3,
        .points = {POINT(lower_front_outer), POINT(upper_front_outer), POINT(track_rod_outer)},
        .mass = 20,
        .centre = {(number)-1.29, (number)0.4, (number)0.06},
        .inertia = {(number)0.4, (number)0.3, (number)0.35, (number)0.01, (number)-0.02, (number)0.03}},
    {.count = 2, .points = {POINT(track_rod_inner), POINT(track_rod_outer)}, .mass = (number)1.5},
    {.count = 1, .points = {POINT(lower_rear_outer)}, .mass = (number)0.5},
};
static const SUSP(masses) masses = {
    .masses = parts, .count = sizeof parts / sizeof *parts, .gravity = {0, 0, (number)-9.81}};
static FIVE_LINK(points) design;

static SUSP(failure) failure;

/* Ends the program if a call failed. */
static void check(susp_status status, const char *what)
{
    if (status == SUSP_OK)
        return;
    fprintf(stderr, "%s: %s", what, susp_status_text(status));
    if (failure.status == status && failure.culprit != NULL)
        fprintf(stderr, " (%s: %g, bound %g)", failure.culprit, (double)failure.value, (double)failure.bound);
    fputc('\n', stderr);
    exit(EXIT_FAILURE);
}

/* The driving angle of the paper: 0.7 + 0.5 t + 0.125 t^2 rad. */
static FIVE_LINK(inputs) inputs_at(number t)
{
    FIVE_LINK(inputs) inputs;
    inputs.value.theta = (number)0.7 + ((number)0.5 + (number)0.125 * t) * t;
    inputs.rate.theta = (number)0.5 + (number)0.25 * t;
    inputs.second_rate.theta = (number)0.25;
    return inputs;
}

/* Adds bytes to an FNV-1a checksum. */
static uint64_t checksum = 0xcbf29ce484222325u;

static void add_to_checksum(const void *bytes, size_t count)
{
    for (const unsigned char *byte = bytes; count > 0; byte++, count--)
        checksum = (checksum ^ *byte) * 0x100000001b3u;
}

/*
 * The model, and the motion at t = 0. When the lower leading link is level, the wheel centre is 0.1 m
 * outboard of the upper trailing link's end.
 */
static void set_up(FIVE_LINK(model) *model, FIVE_LINK(motion) *motion)
{
    const FIVE_LINK(inputs) level = {.value = {.theta = 1.5707963267948966}};
    const FIVE_LINK(inputs) start = inputs_at(0);
    FIVE_LINK(point_rates) points;

    check(FIVE_LINK(model_new)(model, sizeof *model, &guess, &failure), "the points");
    check(FIVE_LINK(model_set_lengths)(model, &lengths, &failure), "the lengths");
    check(FIVE_LINK(assemble)(model, &level, &guess, motion, sizeof *motion, NULL, &failure), "assembling");
    check(FIVE_LINK(read_points)(model, &level, motion, &points), "reading the points");
    design = points.value;
    for (int i = 0; i < 3; i++)
        points.value.wheel_centre[i] = points.value.upper_rear_outer[i];
    points.value.wheel_centre[1] += (number)0.1;
    check(FIVE_LINK(model_set_markers)(model, &points.value, &failure), "the wheel centre");
    check(FIVE_LINK(step_between)(model, &level, &start, 1, motion, NULL, &failure), "moving to the start");
}

/* Adds the loads on drive and links to the checksum. */
static void read_loads(const FIVE_LINK(model) *model, const FIVE_LINK(inputs) *inputs,
        const FIVE_LINK(motion) *motion, const FIVE_LINK(point_rates) *points)
{
    FIVE_LINK(points) forces = {.upper_front_outer = {200, -100, 3000}};
    FIVE_LINK(drives) drives;
    FIVE_LINK(equations) equations;

    check(FIVE_LINK(add_masses)(&masses, &design, points, &forces), "the masses");
    check(FIVE_LINK(read_loads)(model, inputs, motion, &forces, &drives, &equations, &failure), "the loads");
    add_to_checksum(&forces, sizeof forces);
    add_to_checksum(&drives, sizeof drives);
    add_to_checksum(&equations, sizeof equations);
}

/* Adds the quantities of the wheel to the checksum and, if `t` is the time of a row, prints them. */
static void read_wheel(const FIVE_LINK(model) *model, const FIVE_LINK(inputs) *inputs,
        const FIVE_LINK(motion) *motion, double t, int is_row)
{
    const double degrees = 57.29577951308232;
    FIVE_LINK(point_rates) points;
    FIVE_LINK(measure_rates) measures;
    SUSP(wheel) wheel;
    SUSP(carrier_rotation) rotation;
    SUSP(kingpin) kingpin;

    check(FIVE_LINK(read_points)(model, inputs, motion, &points), "reading the points");
    check(FIVE_LINK(read_measures)(model, &points, &measures), "measuring");
    check(FIVE_LINK(read_wheel)(&points.value, &wheel), "the wheel");
    check(FIVE_LINK(read_rotation)(&points, &rotation), "the rotation");
    check(FIVE_LINK(read_kingpin)(&points.value, &kingpin), "the kingpin");
    add_to_checksum(&points, sizeof points);
    add_to_checksum(&measures, sizeof measures);
    add_to_checksum(&wheel, sizeof wheel);
    add_to_checksum(&rotation, sizeof rotation);
    add_to_checksum(&kingpin, sizeof kingpin);
    read_loads(model, inputs, motion, &points);
    if (is_row)
        printf("%5.2f %9.5f %9.5f %8.4f %8.4f %8.4f %8.4f  %08lx%08lx\n", t,
                (double)measures.value.height, (double)measures.rate.height,
                (double)wheel.camber * degrees, (double)wheel.toe * degrees,
                (double)kingpin.angle * degrees, (double)kingpin.caster * degrees,
                (unsigned long)(checksum >> 32), (unsigned long)(checksum & 0xffffffffu));
}

int main(void)
{
    static FIVE_LINK(model) model;
    static FIVE_LINK(motion) motion;

    set_up(&model, &motion);
    printf("    t    height      rate   camber      toe  kingpin   caster\n");
    printf("    s         m       m/s      deg      deg      deg      deg\n");
    for (int step = 0; step <= STEPS; step++) {
        const number dt = step == 0 ? 0 : (number)0.001;
        const FIVE_LINK(inputs) inputs = inputs_at((number)step * (number)0.001);
        check(FIVE_LINK(bounded_step)(&model, &inputs, SUSP_ACCELERATION, dt, &motion, NULL, &failure),
                "a step");
        read_wheel(&model, &inputs, &motion, step * 0.001, step % STEPS_A_ROW == 0);
    }
    return EXIT_SUCCESS;
}
