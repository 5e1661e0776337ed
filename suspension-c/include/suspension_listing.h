/*
 * Listings of a suspension from text, in the language of `linkage!` and motion files: parsed, placed at
 * hardpoints and moved, in double. For hosted systems.
 *
 * Memory    `susp_listing_parse`, `susp_corner_new` and `susp_corner_copy` make objects on the heap, and the
 *           functions `_destroy` free them. Each object may be freed only once; the library cannot check this.
 *           No other function allocates or frees anything.
 * Arrays    contain double in the order of the listing's names. Each is passed with its number of elements;
 *           for a wrong number the result is SUSP_ERROR_SIZE. Points have x, y, z each. An array with rates
 *           has all values, then all rates, per second, then all second rates, per second squared:
 *           double points[3][POINTS][3], drives[3][DRIVES], measures[3][MEASURES].
 * Units     are those of the listing: points in any unit of length, angles in rad, times in s.
 * Panics    are defects of the library. They end the program and never unwind into C.
 *
 * suspension.h documents the rules for every function.
 */
#ifndef SUSP_LISTING_H
#define SUSP_LISTING_H

#include "suspension.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The kinds of numbered and named items of a listing: points (chassis points, free points, markers), drives,
 * measures, wheels, and the parts that hold points, such as links, bodies, hinges and slides. A single wheel that
 * the listing states without a name has an empty name. */
typedef int32_t susp_kind;
enum { SUSP_POINT = 0, SUSP_DRIVE = 1, SUSP_MEASURE = 2, SUSP_WHEEL = 3, SUSP_PART = 4 };

/** A parsed listing. It never changes: threads may share it. */
typedef struct susp_listing susp_listing;

/** A suspension that moves: model, configuration, drives and time. */
typedef struct susp_corner susp_corner;

/** Parses a listing: `length` bytes of UTF-8, the statements as in a `.linkage` file. If the result is
 * SUSP_ERROR_LISTING, `message` receives every mistake on a line of its own, as
 * `listing:LINE:COLUMN: what is wrong and what to write instead`, truncated to `size` bytes and
 * terminated by a zero; `needed` receives the size of the whole message. Both may be NULL. */
susp_status susp_listing_parse(
        const char *text,
        size_t length,
        susp_listing **listing,
        char *message,
        size_t size,
        size_t *needed);

/** Frees a listing; NULL has no effect. Corners made from it stay valid. */
susp_status susp_listing_destroy(
        susp_listing *listing);

/** The number of parts of a kind in a listing. */
susp_status susp_listing_count(
        const susp_listing *listing,
        susp_kind kind,
        size_t *count);

/** The name of a part by its number, from 0: a text that lives as long as the listing. NULL beyond the
 * last number, and if `listing` is not a listing or there is no such kind. */
const char *susp_listing_name(
        const susp_listing *listing,
        susp_kind kind,
        size_t index);

/** The number of a part by its name, a text terminated by a zero; SUSP_ERROR_ABSENT if there is no such
 * part. */
susp_status susp_listing_find(
        const susp_listing *listing,
        susp_kind kind,
        const char *name,
        size_t *index);

/** The positions that the listing states, `points[POINTS][3]`; NaN for points without a position. */
susp_status susp_listing_design(
        const susp_listing *listing,
        double *points,
        size_t count);

/** Makes a suspension at rest at the points `points[POINTS][3]`: those that `susp_listing_design`
 * returns, or others. If the listing states no positions, they determine the order of elimination. */
susp_status susp_corner_new(
        const susp_listing *listing,
        const double *points,
        size_t count,
        susp_corner **corner,
        susp_f64_failure *failure);

/** Frees a suspension; NULL has no effect. */
susp_status susp_corner_destroy(
        susp_corner *corner);

/** The time, s, which is 0 when the suspension is made. */
susp_status susp_corner_time(
        const susp_corner *corner,
        double *time);

/** The values of the drives, `drives[DRIVES]`. */
susp_status susp_corner_drives(
        const susp_corner *corner,
        double *drives,
        size_t count);

/** A step of `dt` seconds to `drives[3][DRIVES]`, the values and rates of the drives at its end,
 * however far: in as many sub-steps as necessary, at most 200. With `dt` = 0 the step takes no time,
 * and the drives must be near the last ones. In between the drives follow the cubics with their values
 * and rates at both ends or, if these lead past a lock, straight lines from rest, in at most 200
 * further sub-steps. A refusal at a lock takes 500 to 2,000 times as long as a step of a millisecond.
 * `report` may be NULL. */
susp_status susp_corner_step(
        susp_corner *corner,
        const double *drives,
        size_t count,
        double dt,
        susp_f64_report *report,
        susp_f64_failure *failure);

/** `susp_corner_step` that keeps its progress if it stops early, for example at a lock: time, drives
 * and points become those of `failure->reached` seconds after its start. The status is then the reason
 * why the next sub-step was refused, however short: at a lock SUSP_ERROR_SINGULAR,
 * SUSP_ERROR_DIVERGING or another, and shorter steps do not help. From a lock there may be no step
 * forwards or backwards, because rates are unbounded there. */
susp_status susp_corner_advance(
        susp_corner *corner,
        const double *drives,
        size_t count,
        double dt,
        susp_f64_report *report,
        susp_f64_failure *failure);

/** Positions, velocities and accelerations of all points, `points[3][POINTS][3]`. */
susp_status susp_corner_read_points(
        const susp_corner *corner,
        double *points,
        size_t count);

/** The measures of the listing, `measures[3][MEASURES]`. A rate is NaN where a measured length is zero,
 * or a measured angle without `about` is 0 or pi. */
susp_status susp_corner_read_measures(
        const susp_corner *corner,
        double *measures,
        size_t count);

/** Motion ratios: points and measures with their first and second derivatives for the change
 * `change[DRIVES]` of the drives, for example 1 for one of them and 0 for the rest; the suspension may
 * be at rest. Derivatives are per unit of that change in place of per second. `points[3][POINTS][3]`
 * and `measures[3][MEASURES]` may each be NULL. SUSP_ERROR_SINGULAR where the drives lock. */
susp_status susp_corner_read_derivatives(
        const susp_corner *corner,
        const double *change,
        size_t drive_count,
        double *points,
        size_t point_count,
        double *measures,
        size_t measure_count,
        susp_f64_failure *failure);

/** Adds weight and inertia of masses in the present motion of the suspension to `forces[POINTS][3]`,
 * for `susp_corner_read_loads`. `design[POINTS][3]` are the points at which the masses are stated. A
 * mass may refer to any points; SUSP_ERROR_ABSENT for a number without a point,
 * SUSP_ERROR_NO_DIRECTION if the three points of a body are in line, SUSP_ERROR_OVERFLOW if a
 * force is not finite. */
susp_status susp_corner_add_masses(
        const susp_corner *corner,
        const susp_f64_masses *masses,
        const double *design,
        size_t design_count,
        double *forces,
        size_t force_count);

/** The effects of forces at the points, `forces[POINTS][3]`, N in the axes of the points, on the
 * suspension at rest at its present position. A force at a marker acts on its body, a force at a
 * chassis point on the drive that moves it. `drives[DRIVES]` receives the work of the forces per unit
 * of each drive, which is the load on its actuator: N for a length, N times the unit of the points for
 * an angle. `tensions[PARTS]` receives the force in each link, positive in tension, and 0 for other
 * parts. `reactions[PARTS][POINTS][3]` receives the forces that each part exerts on the points. A
 * force at a marker acts at three points of its body and is not in the reactions of the body there:
 * the force in a joint of a loaded body is what the other parts exert on the point. The
 * moment that drives or holds an angle acts on the parts that carry the lines of the angle, so that an
 * angle between lines of parts exerts no force itself. A `couple` exerts forces on its points alone,
 * whose sum is not zero: no chassis point bears the difference. Each of these three may be NULL.
 * SUSP_ERROR_SINGULAR where the drives lock. */
susp_status susp_corner_read_loads(
        const susp_corner *corner,
        const double *forces,
        size_t force_count,
        double *drives,
        size_t drive_count,
        double *tensions,
        size_t tension_count,
        double *reactions,
        size_t reaction_count,
        susp_f64_failure *failure);

/** The wheel, or the first of several; SUSP_ERROR_ABSENT if the listing states none. */
susp_status susp_corner_read_wheel(
        const susp_corner *corner,
        susp_f64_wheel *wheel);

/** The rotation of the body that carries that wheel; SUSP_ERROR_ABSENT if the listing states no wheel. */
susp_status susp_corner_read_rotation(
        const susp_corner *corner,
        susp_f64_carrier_rotation *rotation);

/** The kingpin of that wheel; SUSP_ERROR_ABSENT if the listing states none, or no wheel. */
susp_status susp_corner_read_kingpin(
        const susp_corner *corner,
        susp_f64_kingpin *kingpin);

/** One of several wheels, by its number as SUSP_WHEEL; SUSP_ERROR_ABSENT if there is no such wheel. */
susp_status susp_corner_read_wheel_at(
        const susp_corner *corner,
        size_t index,
        susp_f64_wheel *wheel);

/** A wheel with its time derivatives, by its number, 0 for the first or only one; SUSP_ERROR_ABSENT if there is
 * no such wheel. */
susp_status susp_corner_read_wheel_rates(
        const susp_corner *corner,
        size_t index,
        susp_f64_wheel_rates *wheel);

/** A wheel with its derivatives per unit of the change `change[DRIVES]` of the drives, such as camber gain and
 * bump steer, by its number, 0 for the first or only one: see `susp_corner_read_derivatives`.
 * SUSP_ERROR_ABSENT if there is no such wheel, SUSP_ERROR_SINGULAR where the drives lock. */
susp_status susp_corner_read_wheel_derivatives(
        const susp_corner *corner,
        size_t index,
        const double *change,
        size_t drive_count,
        susp_f64_wheel_rates *wheel,
        susp_f64_failure *failure);

/** The rotation of the body that carries it; SUSP_ERROR_ABSENT if there is no such wheel. */
susp_status susp_corner_read_rotation_at(
        const susp_corner *corner,
        size_t index,
        susp_f64_carrier_rotation *rotation);

/** Its kingpin; SUSP_ERROR_ABSENT if there is no such wheel, or it has none. */
susp_status susp_corner_read_kingpin_at(
        const susp_corner *corner,
        size_t index,
        susp_f64_kingpin *kingpin);

/** Makes an independent copy of a suspension in its present state, on the heap. Without the heap
 * `susp_corner_read_state` and `susp_corner_set_state` copy the state into a suspension of the same
 * hardpoints that is already there. */
susp_status susp_corner_copy(
        const susp_corner *corner,
        susp_corner **copy);

/** The count of numbers in a state, STATE. All suspensions of a listing have the same. */
susp_status susp_corner_state_count(
        const susp_corner *corner,
        size_t *count);

/** The state of a suspension, `state[STATE]`, to be kept in memory or in a file, for example before a
 * lock: time, drives and unknowns with their rates. */
susp_status susp_corner_read_state(
        const susp_corner *corner,
        double *state,
        size_t count);

/** Returns a suspension to a state of its own, or of another with the same listing and hardpoints. The
 * same steps then give the same points, bit by bit. Nothing tests whether the state belongs to the
 * listing and the hardpoints; SUSP_ERROR_ARGUMENT if a number is not finite. */
susp_status susp_corner_set_state(
        susp_corner *corner,
        const double *state,
        size_t count);

#ifdef __cplusplus
}
#endif

#endif
