/*
 * Listings of a suspension from text, as `linkage!` and motion files have them, in double: read, given
 * hardpoints and moved. For hosted systems.
 *
 * Memory    `susp_listing_parse`, `susp_corner_new` and `susp_corner_copy` make objects on the heap, which
 *           the functions `_destroy` free: each object once, which is not checked, as an object that was destroyed is
 *           no object any more. No other function allocates or frees anything.
 * Arrays    of double in the order of the listing's names, with how many numbers they have: any other
 *           count is answered by SUSP_ERROR_SIZE. Points are x, y, z of each. With rates an array
 *           has all values, then all rates, per second, then all second rates, per second squared:
 *           double points[3][POINTS][3], drives[3][DRIVES], measures[3][MEASURES].
 * Units     as the listing has them: points in any unit of length, angles in rad, times in s.
 * Panics    would be a defect of the library. They end the program and never unwind into C.
 *
 * What holds for every function is said in suspension.h.
 */
#ifndef SUSP_LISTING_H
#define SUSP_LISTING_H

#include "suspension.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What of a listing has numbers and names: points (on the chassis, free, markers), drives, measures, wheels, and
 * the parts that hold its points: links, bodies, hinges, slides and the like. The name of an only wheel that is
 * stated without one is empty. */
typedef int32_t susp_kind;
enum { SUSP_POINT = 0, SUSP_DRIVE = 1, SUSP_MEASURE = 2, SUSP_WHEEL = 3, SUSP_PART = 4 };

/** A listing that was read. Never changes: threads may share it. */
typedef struct susp_listing susp_listing;

/** A suspension that moves: model, configuration, drives and time. */
typedef struct susp_corner susp_corner;

/** Reads a listing: `length` bytes of UTF-8, the statements as they stand in a `.linkage` file. If it
 * answers SUSP_ERROR_LISTING, `message` has every mistake on a line of its own, as
 * `listing:LINE:COLUMN: what is wrong and what to write instead`, closed by a zero and cut after
 * `size` bytes; `needed`, how many bytes the whole takes. Both may be NULL. */
susp_status susp_listing_parse(
        const char *text,
        size_t length,
        susp_listing **listing,
        char *message,
        size_t size,
        size_t *needed);

/** Frees a listing; NULL is none. Corners that were made of it stay good. */
susp_status susp_listing_destroy(
        susp_listing *listing);

/** How many parts of a kind a listing has. */
susp_status susp_listing_count(
        const susp_listing *listing,
        susp_kind kind,
        size_t *count);

/** The name of a part by its number, from 0: a text that lives as long as the listing. NULL beyond
 * the last, and where `listing` is none or there is no such kind. */
const char *susp_listing_name(
        const susp_listing *listing,
        susp_kind kind,
        size_t index);

/** The number of a part by its name, which a zero closes; SUSP_ERROR_ABSENT where there is none. */
susp_status susp_listing_find(
        const susp_listing *listing,
        susp_kind kind,
        const char *name,
        size_t *index);

/** The positions that the listing states, `points[POINTS][3]`; NaN where it states none. */
susp_status susp_listing_design(
        const susp_listing *listing,
        double *points,
        size_t count);

/** Makes a suspension at rest where the points are, `points[POINTS][3]`: those that `susp_listing_design`
 * gives, or others in their place. Where the listing states no positions the order of elimination is
 * chosen by these. */
susp_status susp_corner_new(
        const susp_listing *listing,
        const double *points,
        size_t count,
        susp_corner **corner,
        susp_f64_failure *failure);

/** Makes a copy of a suspension, which stands as it does and goes on by itself: with it a state is saved, before a
 * lock say. */
susp_status susp_corner_copy(
        const susp_corner *corner,
        susp_corner **copy);

/** Frees a suspension; NULL is none. */
susp_status susp_corner_destroy(
        susp_corner *corner);

/** The time, s, from 0 where the suspension was made. */
susp_status susp_corner_time(
        const susp_corner *corner,
        double *time);

/** The values of the drives, `drives[DRIVES]`. */
susp_status susp_corner_drives(
        const susp_corner *corner,
        double *drives,
        size_t count);

/** A step of `dt` seconds (0: a pause, to drives near the last ones) to the values and rates of the drives at its end,
 * `drives[3][DRIVES]`, however far: in as many sub-steps as it takes, 200 at most. In between the
 * drives follow the cubics that have their values and rates at both ends or, where these lead past a
 * lock, straight lines from rest, in 200 more. `report` may be NULL. */
susp_status susp_corner_step(
        susp_corner *corner,
        const double *drives,
        size_t count,
        double dt,
        susp_f64_report *report,
        susp_f64_failure *failure);

/** `susp_corner_step` that keeps what it has got to where it stops early, as at a lock:
 * `failure->reached` seconds from its start. Time, drives and points are then those there; from a lock
 * no step may lead on or back, as rates have no bound there. */
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

/** What the listing measures, `measures[3][MEASURES]`. A rate is NaN where a measured length is zero, or
 * a measured angle 0 or pi. */
susp_status susp_corner_read_measures(
        const susp_corner *corner,
        double *measures,
        size_t count);

/** Motion ratios: points and measures with their first and second derivative where the drives change
 * as `change[DRIVES]` says, say one of them by 1 and the rest by 0, at rest too: per unit of that
 * change in place of per second. `points[3][POINTS][3]` and `measures[3][MEASURES]` may each be NULL.
 * SUSP_ERROR_SINGULAR where the drives lock. */
susp_status susp_corner_read_derivatives(
        const susp_corner *corner,
        const double *change,
        size_t drive_count,
        double *points,
        size_t point_count,
        double *measures,
        size_t measure_count,
        susp_f64_failure *failure);

/** Adds to `forces[POINTS][3]` weight and inertia of masses where the suspension is, as it moves: for
 * `susp_corner_read_loads`. `design[POINTS][3]` are the points where the masses are stated. Each is at any points;
 * SUSP_ERROR_ABSENT of no point, SUSP_ERROR_NO_DIRECTION where three points that hold a body are in line. */
susp_status susp_corner_add_masses(
        const susp_corner *corner,
        const susp_f64_masses *masses,
        const double *design,
        size_t design_count,
        double *forces,
        size_t force_count);

/** What forces at the points do, `forces[POINTS][3]`, in N in the axes of the points, the suspension at rest where it
 * is: at a marker on its body, at a chassis point on the drive that moves it. `drives[DRIVES]` is their work per unit of each
 * drive, which what moves the drive bears, of a length in N, of an angle in N times the unit of the points;
 * `tensions[PARTS]` the force in each link, positive in tension, 0 of other parts; `reactions[PARTS][POINTS][3]`
 * the forces that each part exerts on the points; what drives or holds an angle acts on the parts that carry the
 * angle's lines, so that an angle between lines of parts exerts none itself. Each of these may be NULL.
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

/** The wheel, the first of several; SUSP_ERROR_ABSENT where the listing states none. */
susp_status susp_corner_read_wheel(
        const susp_corner *corner,
        susp_f64_wheel *wheel);

/** How the body that carries that wheel turns; SUSP_ERROR_ABSENT where the listing states no wheel. */
susp_status susp_corner_read_rotation(
        const susp_corner *corner,
        susp_f64_carrier_rotation *rotation);

/** The kingpin of that wheel; SUSP_ERROR_ABSENT where the listing states none, or no wheel. */
susp_status susp_corner_read_kingpin(
        const susp_corner *corner,
        susp_f64_kingpin *kingpin);

/** Any of several wheels, by its number as SUSP_WHEEL; SUSP_ERROR_ABSENT where there is no such wheel. */
susp_status susp_corner_read_wheel_at(
        const susp_corner *corner,
        size_t index,
        susp_f64_wheel *wheel);

/** How the body that carries it turns; SUSP_ERROR_ABSENT where there is no such wheel. */
susp_status susp_corner_read_rotation_at(
        const susp_corner *corner,
        size_t index,
        susp_f64_carrier_rotation *rotation);

/** Its kingpin; SUSP_ERROR_ABSENT where there is no such wheel, or it has none. */
susp_status susp_corner_read_kingpin_at(
        const susp_corner *corner,
        size_t index,
        susp_f64_kingpin *kingpin);

#ifdef __cplusplus
}
#endif

#endif
