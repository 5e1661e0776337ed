/*
 * The multi-link five-point suspension of Attia 2003 as printed: fourteen distances and the
 * drive `theta`, the angle of the lower leading link from the vertical, rad.
 *
 * What holds for every function is said in suspension.h.
 */
#ifndef SUSP_ATTIA2003_F64_H
#define SUSP_ATTIA2003_F64_H

#include "suspension.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The geometry: what never changes while the mechanism moves. Opaque; may be copied. */
#define SUSP_ATTIA2003_F64_MODEL_SIZE 520
#define SUSP_ATTIA2003_F64_MODEL_ALIGN 8
typedef struct {
    uint64_t words[SUSP_ATTIA2003_F64_MODEL_SIZE / 8];
} susp_attia2003_f64_model;

/** The state: unknowns with velocities and accelerations. Opaque; may be copied. */
#define SUSP_ATTIA2003_F64_MOTION_SIZE 376
#define SUSP_ATTIA2003_F64_MOTION_ALIGN 8
typedef struct {
    uint64_t words[SUSP_ATTIA2003_F64_MOTION_SIZE / 8];
} susp_attia2003_f64_motion;

/** Every point: chassis points, free points, markers. x, y, z of each, in the axes and the
 * unit of length of the hardpoints; or velocities or accelerations alike. */
#define SUSP_ATTIA2003_F64_POINTS_COUNT 11
typedef struct {
    double p1[3];
    double p2[3];
    double p3[3];
    double p4[3];
    double p5[3];
    double p6[3];
    double p7[3];
    double p8[3];
    double p9[3];
    double p10[3];
    double p11[3];
} susp_attia2003_f64_points;

/** Positions, velocities and accelerations of every point. */
typedef struct {
    susp_attia2003_f64_points value;
    /** Per second. */
    susp_attia2003_f64_points rate;
    /** Per second squared. */
    susp_attia2003_f64_points second_rate;
} susp_attia2003_f64_point_rates;

/** The chassis points. */
#define SUSP_ATTIA2003_F64_CHASSIS_COUNT 5
typedef struct {
    double p1[3];
    double p2[3];
    double p3[3];
    double p4[3];
    double p5[3];
} susp_attia2003_f64_chassis;

/** The chassis points with velocities and accelerations. */
typedef struct {
    susp_attia2003_f64_chassis value;
    /** Per second. */
    susp_attia2003_f64_chassis rate;
    /** Per second squared. */
    susp_attia2003_f64_chassis second_rate;
} susp_attia2003_f64_chassis_rates;

/** What is prescribed: coordinates in the unit of the points, angles in rad. */
#define SUSP_ATTIA2003_F64_DRIVES_COUNT 1
typedef struct {
    double theta;
} susp_attia2003_f64_drives;

/** The drives with their first and second time derivatives. */
typedef struct {
    susp_attia2003_f64_drives value;
    /** Per second. */
    susp_attia2003_f64_drives rate;
    /** Per second squared. */
    susp_attia2003_f64_drives second_rate;
} susp_attia2003_f64_inputs;

/** What the listing measures: lengths and coordinates in the unit of the points, angles in rad. */
#define SUSP_ATTIA2003_F64_MEASURES_COUNT 1
typedef struct {
    double height;
} susp_attia2003_f64_measures;

/** The measures with their first and second time derivatives. */
typedef struct {
    susp_attia2003_f64_measures value;
    /** Per second. */
    susp_attia2003_f64_measures rate;
    /** Per second squared. */
    susp_attia2003_f64_measures second_rate;
} susp_attia2003_f64_measure_rates;

/** A number of each equation. */
#define SUSP_ATTIA2003_F64_EQUATIONS_COUNT 15
typedef struct {
    double d6_1;
    double d7_2;
    double d8_3;
    double d9_4;
    double d10_5;
    double d7_6;
    double d8_6;
    double d9_6;
    double d10_6;
    double d8_7;
    double d9_7;
    double d10_7;
    double d9_8;
    double d10_8;
    double theta;
} susp_attia2003_f64_equations;

/** Constant lengths of links and bodies, in the unit of the points. */
#define SUSP_ATTIA2003_F64_LENGTHS_COUNT 14
typedef struct {
    double d6_1;
    double d7_2;
    double d8_3;
    double d9_4;
    double d10_5;
    double d7_6;
    double d8_6;
    double d9_6;
    double d10_6;
    double d8_7;
    double d9_7;
    double d10_7;
    double d9_8;
    double d10_8;
} susp_attia2003_f64_lengths;

/** Makes a model whose lengths are those of the points as they stand. `size` is
 * `sizeof *model`. With SUSP_ERROR_SMALL_PIVOT the model is made all the same: steps to
 * tolerance go on with partial pivoting, attempts are refused. */
susp_status susp_attia2003_f64_model_new(
        susp_attia2003_f64_model *model,
        size_t size,
        const susp_attia2003_f64_points *design,
        susp_f64_failure *failure);

/** Gives a model other lengths; each body keeps its handedness. */
susp_status susp_attia2003_f64_model_set_lengths(
        susp_attia2003_f64_model *model,
        const susp_attia2003_f64_lengths *lengths,
        susp_f64_failure *failure);

/** Attaches a model's markers as they stand among the points. */
susp_status susp_attia2003_f64_model_set_markers(
        susp_attia2003_f64_model *model,
        const susp_attia2003_f64_points *points,
        susp_f64_failure *failure);

/** The lengths of a model. */
susp_status susp_attia2003_f64_model_lengths(
        const susp_attia2003_f64_model *model,
        susp_attia2003_f64_lengths *lengths);

/** The values that the drives have in a configuration. */
susp_status susp_attia2003_f64_model_drives(
        const susp_attia2003_f64_model *model,
        const susp_attia2003_f64_points *points,
        susp_attia2003_f64_drives *drives);

/** Makes a motion: at rest, the free points where they stand among `points`. `size` is
 * `sizeof *motion`. */
susp_status susp_attia2003_f64_motion_at_rest(
        const susp_attia2003_f64_model *model,
        susp_attia2003_f64_motion *motion,
        size_t size,
        const susp_attia2003_f64_points *points);

/** Makes a motion: at rest, in the configuration nearest to the guess, of which the free points
 * matter. A step with `dt` = 0 finds its rates. `size` is `sizeof *motion`; `assembly` may be
 * NULL. For setting up: it takes hundreds of times as long as a step. */
susp_status susp_attia2003_f64_assemble(
        const susp_attia2003_f64_model *model,
        const susp_attia2003_f64_inputs *inputs,
        const susp_attia2003_f64_points *guess,
        susp_attia2003_f64_motion *motion,
        size_t size,
        susp_f64_assembly *assembly,
        susp_f64_failure *failure);

/** One step to tolerance, of `dt` seconds, to the configuration of `inputs`: position, velocity
 * and acceleration. `report` may be NULL. */
susp_status susp_attia2003_f64_step(
        const susp_attia2003_f64_model *model,
        const susp_attia2003_f64_inputs *inputs,
        double dt,
        susp_attia2003_f64_motion *motion,
        susp_f64_report *report,
        susp_f64_failure *failure);

/** A step of `dt` seconds between two inputs that may lie far apart, near by where `dt` is 0: to tolerance,
 * in as many sub-steps as it takes, 200 at most. `motion` is the one at `from`; in between the
 * drives follow the cubics that have their values and rates at the ends or, where these lead
 * past a lock, straight lines from rest, in 200 more. `report` may be NULL. */
susp_status susp_attia2003_f64_step_between(
        const susp_attia2003_f64_model *model,
        const susp_attia2003_f64_inputs *from,
        const susp_attia2003_f64_inputs *to,
        double dt,
        susp_attia2003_f64_motion *motion,
        susp_f64_report *report,
        susp_f64_failure *failure);

/** `step_between` along the cubics alone that keeps what it has got to where it stops early, as at a lock:
 * `inputs`, those of `motion`, become `to`. If not, both are those of the last good sub-step,
 * `failure->reached` seconds from the start; from a lock no step may lead on or back, as rates have no bound
 * there. `report` may be NULL. */
susp_status susp_attia2003_f64_advance(
        const susp_attia2003_f64_model *model,
        susp_attia2003_f64_inputs *inputs,
        const susp_attia2003_f64_inputs *to,
        double dt,
        susp_attia2003_f64_motion *motion,
        susp_f64_report *report,
        susp_f64_failure *failure);

/** One step of fixed cost, of `dt` seconds, to the configuration of `inputs`. Solved for:
 * SUSP_POSITION, SUSP_VELOCITY (position too) or SUSP_ACCELERATION (all three). Rates that are
 * not solved for are estimates, good for the next step. `report` may be NULL. A first step from
 * rest is one with `dt` = 0. */
susp_status susp_attia2003_f64_bounded_step(
        const susp_attia2003_f64_model *model,
        const susp_attia2003_f64_inputs *inputs,
        susp_outputs outputs,
        double dt,
        susp_attia2003_f64_motion *motion,
        susp_f64_report *report,
        susp_f64_failure *failure);

/** The same with two corrections in place of one, for longer steps, and for steps of a millisecond
 * that do not solve for the acceleration. */
susp_status susp_attia2003_f64_bounded_step_twice(
        const susp_attia2003_f64_model *model,
        const susp_attia2003_f64_inputs *inputs,
        susp_outputs outputs,
        double dt,
        susp_attia2003_f64_motion *motion,
        susp_f64_report *report,
        susp_f64_failure *failure);

/** `bounded_step` in one fixed order of pivots or not at all: the call for a hard real-time loop. A
 * refusal takes no longer than a step and leaves the motion; `bounded_step` with the same
 * arguments finds the reason, or another order. `report` may be NULL. */
susp_status susp_attia2003_f64_attempt(
        const susp_attia2003_f64_model *model,
        const susp_attia2003_f64_inputs *inputs,
        susp_outputs outputs,
        double dt,
        susp_attia2003_f64_motion *motion,
        susp_f64_report *report);

/** `attempt` with two corrections in place of one, as `bounded_step_twice` has them: in `double` for a wheel on a road. */
susp_status susp_attia2003_f64_attempt_twice(
        const susp_attia2003_f64_model *model,
        const susp_attia2003_f64_inputs *inputs,
        susp_outputs outputs,
        double dt,
        susp_attia2003_f64_motion *motion,
        susp_f64_report *report);

/** `attempt` without the terms of the prediction's error, for a quarter less. Accepted only where
 * that error is within the tolerance, so that what is left out is rounding: `float` at 1 ms. */
susp_status susp_attia2003_f64_attempt_without_corrections(
        const susp_attia2003_f64_model *model,
        const susp_attia2003_f64_inputs *inputs,
        susp_outputs outputs,
        double dt,
        susp_attia2003_f64_motion *motion,
        susp_f64_report *report);

/** Positions, velocities and accelerations of all points of a motion, which must be the one that
 * a step with these inputs left. */
susp_status susp_attia2003_f64_read_points(
        const susp_attia2003_f64_model *model,
        const susp_attia2003_f64_inputs *inputs,
        const susp_attia2003_f64_motion *motion,
        susp_attia2003_f64_point_rates *points);

/** What the listing measures, with rates. A rate is NaN where a measured length is zero, or a
 * measured angle 0 or pi. */
susp_status susp_attia2003_f64_read_measures(
        const susp_attia2003_f64_model *model,
        const susp_attia2003_f64_point_rates *points,
        susp_attia2003_f64_measure_rates *measures);

/** Motion ratios: all points of a motion with their first and second derivative where the drives change
 * as `change` says, say one of them by 1 and the rest by 0, at rest too. The members `rate` are per unit
 * of that change, `second_rate` per unit squared; `read_measures` takes them on to the measures.
 * The rates of `inputs` do not matter. SUSP_ERROR_SINGULAR where the drives lock. */
susp_status susp_attia2003_f64_read_derivatives(
        const susp_attia2003_f64_model *model,
        const susp_attia2003_f64_inputs *inputs,
        const susp_attia2003_f64_motion *motion,
        const susp_attia2003_f64_drives *change,
        susp_attia2003_f64_point_rates *points,
        susp_f64_failure *failure);

/** What forces at the free points do, N in the axes of the points, the mechanism at rest at the position of a
 * motion; what acts at markers loads nothing, at chassis points the drive that moves them. `drives` gets their work per unit of each
 * drive, which what moves the drive bears; `equations` the multiplier of each equation: of a
 * link the force in it, positive in tension; where a drive prescribes the link's own angle from an axis, without
 * that drive's part along the link. The rates of `inputs` do not matter. Takes about half a step.
 * SUSP_ERROR_SINGULAR where the drives lock. */
susp_status susp_attia2003_f64_read_loads(
        const susp_attia2003_f64_model *model,
        const susp_attia2003_f64_inputs *inputs,
        const susp_attia2003_f64_motion *motion,
        const susp_attia2003_f64_points *forces,
        susp_attia2003_f64_drives *drives,
        susp_attia2003_f64_equations *equations,
        susp_f64_failure *failure);

/** Adds to `forces` weight and inertia of masses where the points move, which `read_points` found with their
 * accelerations: for `read_loads`. `design` are the points where the masses are stated. Each is at chassis points and
 * free points, as what acts at markers loads nothing: SUSP_ERROR_ARGUMENT of a marker, SUSP_ERROR_ABSENT of no
 * point. SUSP_ERROR_NO_DIRECTION where three points that hold a body are in line. */
susp_status susp_attia2003_f64_add_masses(
        const susp_f64_masses *masses,
        const susp_attia2003_f64_points *design,
        const susp_attia2003_f64_point_rates *points,
        susp_attia2003_f64_points *forces);

/** Proves that a configuration for `inputs`, of which the rates do not matter, is near a motion's
 * position, and no other. Takes about as long as five steps to tolerance. */
susp_status susp_attia2003_f64_certify(
        const susp_attia2003_f64_model *model,
        const susp_attia2003_f64_inputs *inputs,
        const susp_attia2003_f64_motion *motion,
        susp_f64_certificate *certificate,
        susp_f64_failure *failure);

/** Points that were found in chassis axes, carried into the world with a chassis that moves:
 * cheaper than to solve with chassis points that move. */
susp_status susp_attia2003_f64_carry(
        const susp_f64_rigid_motion *chassis,
        const susp_attia2003_f64_point_rates *points,
        susp_attia2003_f64_point_rates *carried);

/** The chassis points of a model, which rest in chassis axes, with a chassis that moves: what
 * the `moving_` functions take. */
susp_status susp_attia2003_f64_move_chassis(
        const susp_attia2003_f64_model *model,
        const susp_f64_rigid_motion *chassis,
        susp_attia2003_f64_chassis_rates *points);

/** `step` with chassis points that move. Drives prescribe coordinates in the axes of these. */
susp_status susp_attia2003_f64_moving_step(
        const susp_attia2003_f64_model *model,
        const susp_attia2003_f64_chassis_rates *chassis,
        const susp_attia2003_f64_inputs *inputs,
        double dt,
        susp_attia2003_f64_motion *motion,
        susp_f64_report *report,
        susp_f64_failure *failure);

/** `bounded_step` with chassis points that move. */
susp_status susp_attia2003_f64_moving_bounded_step(
        const susp_attia2003_f64_model *model,
        const susp_attia2003_f64_chassis_rates *chassis,
        const susp_attia2003_f64_inputs *inputs,
        susp_outputs outputs,
        double dt,
        susp_attia2003_f64_motion *motion,
        susp_f64_report *report,
        susp_f64_failure *failure);

/** `read_points` with chassis points that move. */
susp_status susp_attia2003_f64_moving_read_points(
        const susp_attia2003_f64_model *model,
        const susp_attia2003_f64_chassis_rates *chassis,
        const susp_attia2003_f64_inputs *inputs,
        const susp_attia2003_f64_motion *motion,
        susp_attia2003_f64_point_rates *points);

/** The name of a point by its number in `points`, from 0; NULL beyond the last. */
const char *susp_attia2003_f64_point_name(
        size_t index);

/** The name of a drive by its number; NULL beyond the last. */
const char *susp_attia2003_f64_drive_name(
        size_t index);

/** The name of a measure by its number; NULL beyond the last. */
const char *susp_attia2003_f64_measure_name(
        size_t index);

/** The name of a length by its number; NULL beyond the last. */
const char *susp_attia2003_f64_length_name(
        size_t index);

/** The wheel of positions that `read_points` found. */
susp_status susp_attia2003_f64_read_wheel(
        const susp_attia2003_f64_points *points,
        susp_f64_wheel *wheel);

/** How the body that carries the wheel turns. */
susp_status susp_attia2003_f64_read_rotation(
        const susp_attia2003_f64_point_rates *points,
        susp_f64_carrier_rotation *rotation);

/** The kingpin of positions that `read_points` found. */
susp_status susp_attia2003_f64_read_kingpin(
        const susp_attia2003_f64_points *points,
        susp_f64_kingpin *kingpin);

#ifdef __cplusplus
}
#endif

#endif
