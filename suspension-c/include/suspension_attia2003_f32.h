/*
 * The multi-link five-point suspension of Attia 2003 as printed: fourteen distances and the
 * drive `theta`, the angle of the lower leading link from the vertical, rad.
 *
 * suspension.h documents the rules for every function.
 */
#ifndef SUSP_ATTIA2003_F32_H
#define SUSP_ATTIA2003_F32_H

#include "suspension.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The geometry, which does not change while the mechanism moves. Opaque; may be copied. */
#define SUSP_ATTIA2003_F32_MODEL_SIZE 260
#define SUSP_ATTIA2003_F32_MODEL_ALIGN 4
typedef struct {
    uint32_t words[SUSP_ATTIA2003_F32_MODEL_SIZE / 4];
} susp_attia2003_f32_model;

/** The state: unknowns with velocities and accelerations. Opaque; may be copied. */
#define SUSP_ATTIA2003_F32_MOTION_SIZE 188
#define SUSP_ATTIA2003_F32_MOTION_ALIGN 4
typedef struct {
    uint32_t words[SUSP_ATTIA2003_F32_MOTION_SIZE / 4];
} susp_attia2003_f32_motion;

/** Every point: chassis points, free points, markers. x, y, z of each, in the axes and the
 * unit of length of the hardpoints; or their velocities or accelerations. */
#define SUSP_ATTIA2003_F32_POINTS_COUNT 11
typedef struct {
    float p1[3];
    float p2[3];
    float p3[3];
    float p4[3];
    float p5[3];
    float p6[3];
    float p7[3];
    float p8[3];
    float p9[3];
    float p10[3];
    float p11[3];
} susp_attia2003_f32_points;

/** Positions, velocities and accelerations of every point. */
typedef struct {
    susp_attia2003_f32_points value;
    /** Per second. */
    susp_attia2003_f32_points rate;
    /** Per second squared. */
    susp_attia2003_f32_points second_rate;
} susp_attia2003_f32_point_rates;

/** The chassis points. */
#define SUSP_ATTIA2003_F32_CHASSIS_COUNT 5
typedef struct {
    float p1[3];
    float p2[3];
    float p3[3];
    float p4[3];
    float p5[3];
} susp_attia2003_f32_chassis;

/** The chassis points with velocities and accelerations. */
typedef struct {
    susp_attia2003_f32_chassis value;
    /** Per second. */
    susp_attia2003_f32_chassis rate;
    /** Per second squared. */
    susp_attia2003_f32_chassis second_rate;
} susp_attia2003_f32_chassis_rates;

/** The prescribed quantities: coordinates in the unit of the points, angles in rad. */
#define SUSP_ATTIA2003_F32_DRIVES_COUNT 1
typedef struct {
    float theta;
} susp_attia2003_f32_drives;

/** The drives with their first and second time derivatives. */
typedef struct {
    susp_attia2003_f32_drives value;
    /** Per second. */
    susp_attia2003_f32_drives rate;
    /** Per second squared. */
    susp_attia2003_f32_drives second_rate;
} susp_attia2003_f32_inputs;

/** The measures of the listing: lengths and coordinates in the unit of the points, angles in
 * rad. */
#define SUSP_ATTIA2003_F32_MEASURES_COUNT 1
typedef struct {
    float height;
} susp_attia2003_f32_measures;

/** The measures with their first and second time derivatives. */
typedef struct {
    susp_attia2003_f32_measures value;
    /** Per second. */
    susp_attia2003_f32_measures rate;
    /** Per second squared. */
    susp_attia2003_f32_measures second_rate;
} susp_attia2003_f32_measure_rates;

/** One number per equation. */
#define SUSP_ATTIA2003_F32_EQUATIONS_COUNT 15
typedef struct {
    float d6_1;
    float d7_2;
    float d8_3;
    float d9_4;
    float d10_5;
    float d7_6;
    float d8_6;
    float d9_6;
    float d10_6;
    float d8_7;
    float d9_7;
    float d10_7;
    float d9_8;
    float d10_8;
    float theta;
} susp_attia2003_f32_equations;

/** Constant lengths of links and bodies, in the unit of the points. */
#define SUSP_ATTIA2003_F32_LENGTHS_COUNT 14
typedef struct {
    float d6_1;
    float d7_2;
    float d8_3;
    float d9_4;
    float d10_5;
    float d7_6;
    float d8_6;
    float d9_6;
    float d10_6;
    float d8_7;
    float d9_7;
    float d10_7;
    float d9_8;
    float d10_8;
} susp_attia2003_f32_lengths;

/** Makes a model with the lengths between the points. `size` is `sizeof *model`.
 * With SUSP_ERROR_SMALL_PIVOT the model is made nevertheless: steps to tolerance then use partial
 * pivoting, and attempts are refused. */
susp_status susp_attia2003_f32_model_new(
        susp_attia2003_f32_model *model,
        size_t size,
        const susp_attia2003_f32_points *design,
        susp_f32_failure *failure);

/** Changes the lengths of a model; each body keeps its handedness. */
susp_status susp_attia2003_f32_model_set_lengths(
        susp_attia2003_f32_model *model,
        const susp_attia2003_f32_lengths *lengths,
        susp_f32_failure *failure);

/** Attaches a model's markers to their bodies at the given points. */
susp_status susp_attia2003_f32_model_set_markers(
        susp_attia2003_f32_model *model,
        const susp_attia2003_f32_points *points,
        susp_f32_failure *failure);

/** The lengths of a model. */
susp_status susp_attia2003_f32_model_lengths(
        const susp_attia2003_f32_model *model,
        susp_attia2003_f32_lengths *lengths);

/** The values of the drives in a configuration. */
susp_status susp_attia2003_f32_model_drives(
        const susp_attia2003_f32_model *model,
        const susp_attia2003_f32_points *points,
        susp_attia2003_f32_drives *drives);

/** Makes a motion at rest with the free points at `points`. `size` is `sizeof *motion`. Where the points
 * do not satisfy the listing, for example where one is a tenth of a millimetre off the line of its
 * `slide`, bounded steps are refused with SUSP_ERROR_NOT_CONVERGED: use `assemble` there. */
susp_status susp_attia2003_f32_motion_at_rest(
        const susp_attia2003_f32_model *model,
        susp_attia2003_f32_motion *motion,
        size_t size,
        const susp_attia2003_f32_points *points);

/** Makes a motion at rest in the configuration nearest to the guess, of which only the free points
 * matter. A step with `dt` = 0 then computes its rates. `size` is `sizeof *motion`; `assembly` may
 * be NULL. This call is for initialisation: it takes hundreds of times as long as a step. */
susp_status susp_attia2003_f32_assemble(
        const susp_attia2003_f32_model *model,
        const susp_attia2003_f32_inputs *inputs,
        const susp_attia2003_f32_points *guess,
        susp_attia2003_f32_motion *motion,
        size_t size,
        susp_f32_assembly *assembly,
        susp_f32_failure *failure);

/** One step to tolerance, of `dt` seconds, to the configuration of `inputs`: position, velocity
 * and acceleration. `report` may be NULL. */
susp_status susp_attia2003_f32_step(
        const susp_attia2003_f32_model *model,
        const susp_attia2003_f32_inputs *inputs,
        float dt,
        susp_attia2003_f32_motion *motion,
        susp_f32_report *report,
        susp_f32_failure *failure);

/** A step of `dt` seconds between two inputs that may be far apart, or near each other if `dt` is
 * 0: to tolerance, in as many sub-steps as necessary, at most 200. `motion` is the one at `from`.
 * In between the drives follow the cubics with their values and rates at both ends or, if these
 * lead past a lock, straight lines from rest, in at most 200 further sub-steps. A refusal at a
 * lock takes 500 to 2,000 times as long as a step of a millisecond. `report` may be NULL. */
susp_status susp_attia2003_f32_step_between(
        const susp_attia2003_f32_model *model,
        const susp_attia2003_f32_inputs *from,
        const susp_attia2003_f32_inputs *to,
        float dt,
        susp_attia2003_f32_motion *motion,
        susp_f32_report *report,
        susp_f32_failure *failure);

/** `step_between` along the cubics only, which keeps its progress if it stops early, for example at
 * a lock: `inputs`, those of `motion`, become `to`. If the step stops early, `inputs` and `motion`
 * become those of the last good sub-step, `failure->reached` seconds after the start. The status is
 * then the reason why the next sub-step was refused, however short: at a lock SUSP_ERROR_SINGULAR,
 * SUSP_ERROR_DIVERGING or another, and shorter steps do not help. From a lock there may be no step
 * forwards or backwards, because rates are unbounded there. `report` may be NULL. */
susp_status susp_attia2003_f32_advance(
        const susp_attia2003_f32_model *model,
        susp_attia2003_f32_inputs *inputs,
        const susp_attia2003_f32_inputs *to,
        float dt,
        susp_attia2003_f32_motion *motion,
        susp_f32_report *report,
        susp_f32_failure *failure);

/** One step of fixed cost, of `dt` seconds, to the configuration of `inputs`. `outputs` states what
 * it solves for: SUSP_POSITION, SUSP_VELOCITY (and position) or SUSP_ACCELERATION (all three). The
 * other rates are estimates, which suffice for the next step. `report` may be NULL. The first step
 * from rest has `dt` = 0. */
susp_status susp_attia2003_f32_bounded_step(
        const susp_attia2003_f32_model *model,
        const susp_attia2003_f32_inputs *inputs,
        susp_outputs outputs,
        float dt,
        susp_attia2003_f32_motion *motion,
        susp_f32_report *report,
        susp_f32_failure *failure);

/** `bounded_step` with two corrections in place of one, for longer steps, and for steps of a
 * millisecond that do not solve for the acceleration. */
susp_status susp_attia2003_f32_bounded_step_twice(
        const susp_attia2003_f32_model *model,
        const susp_attia2003_f32_inputs *inputs,
        susp_outputs outputs,
        float dt,
        susp_attia2003_f32_motion *motion,
        susp_f32_report *report,
        susp_f32_failure *failure);

/** `bounded_step` in one fixed order of pivots, or a refusal: the call for a hard real-time loop. A
 * refusal takes no longer than a step and does not change the motion; `bounded_step` with the same
 * arguments returns the reason, or uses another order. Numbers that are not finite are
 * SUSP_ERROR_OVERFLOW here, inputs as well as results. `report` may be NULL. */
susp_status susp_attia2003_f32_attempt(
        const susp_attia2003_f32_model *model,
        const susp_attia2003_f32_inputs *inputs,
        susp_outputs outputs,
        float dt,
        susp_attia2003_f32_motion *motion,
        susp_f32_report *report);

/** `attempt` with two corrections in place of one, like `bounded_step_twice`: in `double` for a
 * wheel on a smooth road. */
susp_status susp_attia2003_f32_attempt_twice(
        const susp_attia2003_f32_model *model,
        const susp_attia2003_f32_inputs *inputs,
        susp_outputs outputs,
        float dt,
        susp_attia2003_f32_motion *motion,
        susp_f32_report *report);

/** `attempt` without the terms for the error of the prediction, which saves a quarter of the time.
 * It refuses unless that error is within the tolerance, so that the omitted terms are rounding:
 * for `float` at 1 ms. */
susp_status susp_attia2003_f32_attempt_without_corrections(
        const susp_attia2003_f32_model *model,
        const susp_attia2003_f32_inputs *inputs,
        susp_outputs outputs,
        float dt,
        susp_attia2003_f32_motion *motion,
        susp_f32_report *report);

/** Positions, velocities and accelerations of all points of a motion. `inputs` must be those of the
 * step that computed the motion. */
susp_status susp_attia2003_f32_read_points(
        const susp_attia2003_f32_model *model,
        const susp_attia2003_f32_inputs *inputs,
        const susp_attia2003_f32_motion *motion,
        susp_attia2003_f32_point_rates *points);

/** The measures of the listing, with rates. A rate is NaN where a measured length is zero, or a
 * measured angle without `about` is 0 or pi. */
susp_status susp_attia2003_f32_read_measures(
        const susp_attia2003_f32_model *model,
        const susp_attia2003_f32_point_rates *points,
        susp_attia2003_f32_measure_rates *measures);

/** Motion ratios: all points of a motion with their first and second derivatives for the change
 * `change` of the drives, for example 1 for one of them and 0 for the rest; the mechanism may be
 * at rest. The members `rate` are per unit of that change, `second_rate` per unit squared;
 * `read_measures` computes the derivatives of the measures from them. The rates of `inputs` do not
 * matter. SUSP_ERROR_SINGULAR where the drives lock. */
susp_status susp_attia2003_f32_read_derivatives(
        const susp_attia2003_f32_model *model,
        const susp_attia2003_f32_inputs *inputs,
        const susp_attia2003_f32_motion *motion,
        const susp_attia2003_f32_drives *change,
        susp_attia2003_f32_point_rates *points,
        susp_f32_failure *failure);

/** The effects of forces at the points, N in the axes of the points, on the mechanism at rest at the
 * position of a motion. A force at a marker acts on its body, a force at a chassis point on the
 * drive that moves it. `drives` receives the work of the forces per unit of each drive,
 * which is the load on its actuator; `equations` the multiplier of each equation. The multiplier
 * of a link is the force in it, positive in tension; if a drive prescribes the link's angle from
 * an axis, the part of the force along the link that the drive causes is not included. The rates
 * of `inputs` do not matter. Takes about half as long as a step. SUSP_ERROR_SINGULAR where the
 * drives lock. */
susp_status susp_attia2003_f32_read_loads(
        const susp_attia2003_f32_model *model,
        const susp_attia2003_f32_inputs *inputs,
        const susp_attia2003_f32_motion *motion,
        const susp_attia2003_f32_points *forces,
        susp_attia2003_f32_drives *drives,
        susp_attia2003_f32_equations *equations,
        susp_f32_failure *failure);

/** Adds weight and inertia of masses to `forces`, for `read_loads`. `points` come from
 * `read_points` with their accelerations; `design` are the points at which the masses are stated.
 * A mass may refer to any points; SUSP_ERROR_ABSENT for a number without a point,
 * SUSP_ERROR_NO_DIRECTION if the three points of a body are in line, SUSP_ERROR_OVERFLOW if a
 * force is not finite. */
susp_status susp_attia2003_f32_add_masses(
        const susp_f32_masses *masses,
        const susp_attia2003_f32_points *design,
        const susp_attia2003_f32_point_rates *points,
        susp_attia2003_f32_points *forces);

/** Proves that near the position of a motion there is exactly one configuration for `inputs`, whose
 * rates do not matter. Takes about as long as five steps to tolerance. */
susp_status susp_attia2003_f32_certify(
        const susp_attia2003_f32_model *model,
        const susp_attia2003_f32_inputs *inputs,
        const susp_attia2003_f32_motion *motion,
        susp_f32_certificate *certificate,
        susp_f32_failure *failure);

/** Transforms points that were computed in chassis axes to world axes for a chassis that moves.
 * This is cheaper than a step with chassis points that move. */
susp_status susp_attia2003_f32_carry(
        const susp_f32_rigid_motion *chassis,
        const susp_attia2003_f32_point_rates *points,
        susp_attia2003_f32_point_rates *carried);

/** Computes the chassis points of a model, which are fixed in chassis axes, for a chassis that
 * moves: the input of the `moving_` functions. */
susp_status susp_attia2003_f32_move_chassis(
        const susp_attia2003_f32_model *model,
        const susp_f32_rigid_motion *chassis,
        susp_attia2003_f32_chassis_rates *points);

/** `step` with chassis points that move. Drives prescribe coordinates in the same axes as these
 * points. */
susp_status susp_attia2003_f32_moving_step(
        const susp_attia2003_f32_model *model,
        const susp_attia2003_f32_chassis_rates *chassis,
        const susp_attia2003_f32_inputs *inputs,
        float dt,
        susp_attia2003_f32_motion *motion,
        susp_f32_report *report,
        susp_f32_failure *failure);

/** `bounded_step` with chassis points that move. */
susp_status susp_attia2003_f32_moving_bounded_step(
        const susp_attia2003_f32_model *model,
        const susp_attia2003_f32_chassis_rates *chassis,
        const susp_attia2003_f32_inputs *inputs,
        susp_outputs outputs,
        float dt,
        susp_attia2003_f32_motion *motion,
        susp_f32_report *report,
        susp_f32_failure *failure);

/** `read_points` with chassis points that move. */
susp_status susp_attia2003_f32_moving_read_points(
        const susp_attia2003_f32_model *model,
        const susp_attia2003_f32_chassis_rates *chassis,
        const susp_attia2003_f32_inputs *inputs,
        const susp_attia2003_f32_motion *motion,
        susp_attia2003_f32_point_rates *points);

/** The name of a point by its number in `points`, from 0; NULL beyond the last. */
const char *susp_attia2003_f32_point_name(
        size_t index);

/** The name of a drive by its number; NULL beyond the last. */
const char *susp_attia2003_f32_drive_name(
        size_t index);

/** The name of a measure by its number; NULL beyond the last. */
const char *susp_attia2003_f32_measure_name(
        size_t index);

/** The name of a length by its number; NULL beyond the last. */
const char *susp_attia2003_f32_length_name(
        size_t index);

/** The wheel of positions that `read_points` found. */
susp_status susp_attia2003_f32_read_wheel(
        const susp_attia2003_f32_points *points,
        susp_f32_wheel *wheel);

/** That wheel with its derivatives: per second from points of `read_points`, and per unit of a change
 * of the drives, such as camber gain and bump steer, from those of `read_derivatives`. */
susp_status susp_attia2003_f32_read_wheel_rates(
        const susp_attia2003_f32_point_rates *points,
        susp_f32_wheel_rates *wheel);

/** How the body that carries the wheel turns. */
susp_status susp_attia2003_f32_read_rotation(
        const susp_attia2003_f32_point_rates *points,
        susp_f32_carrier_rotation *rotation);

/** The kingpin of positions that `read_points` found. */
susp_status susp_attia2003_f32_read_kingpin(
        const susp_attia2003_f32_points *points,
        susp_f32_kingpin *kingpin);

#ifdef __cplusplus
}
#endif

#endif
