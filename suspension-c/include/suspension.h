/*
 * Suspension kinematics for C. This file declares what all linkages share; include the header of a linkage,
 * such as suspension_five_link_f32.h. Generated from the source of the functions: do not edit.
 *
 * Memory    The caller owns every object: on the stack, in static memory, or anywhere else. Nothing is
 *           allocated, and nothing has to be freed. Objects may be copied by assignment or memcpy. Only
 *           listings from text are on the heap: see suspension_listing.h.
 * Opaque    The content of `words` is private. The function that takes the size of an object must have made
 *           the object before another function uses it; otherwise that function returns SUSP_ERROR_OBJECT
 *           (unless the memory happens to begin with the tag of such an object).
 * Threads   There is no state outside the caller's objects. Calls may run at the same time in any
 *           threads or interrupts as long as none writes an object that another one uses.
 * Pointers  May not be NULL, except `failure` and where the documentation says so. Each is checked for NULL
 *           and for its alignment. Arguments may share memory to which only pointers to const point; no
 *           other memory may overlap.
 * Status    SUSP_OK, or the reason for a refusal. A refused call changes nothing but `*failure`, which is
 *           written only then. The functions named `advance` keep their progress. With
 *           SUSP_ERROR_SMALL_PIVOT a model is made nevertheless.
 * Numbers   Any unit of length, the same throughout; angles in rad, times in s. Functions that make models
 *           or solve report NaN and infinities among the numbers on which their results depend. They do not
 *           examine others, for example rates of the drives in a step for SUSP_POSITION, or the inputs from
 *           which `step_between` and `advance` start, which only sub-steps need. Functions that only read,
 *           transform or evaluate may pass NaN on. Axes of wheels: x forward, y left, z up (ISO 8855).
 * Structs   of named points or numbers are also arrays in the order of their members.
 */
#ifndef SUSP_H
#define SUSP_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The result of a function. */
typedef int32_t susp_status;
enum {
    /** done */
    SUSP_OK = 0,
    /** a pointer that must not be NULL is NULL */
    SUSP_ERROR_NULL = 1,
    /** a pointer is not aligned for its type */
    SUSP_ERROR_MISALIGNED = 2,
    /** the memory has another size than the library needs: header and library differ, or an array has another count than the listing */
    SUSP_ERROR_SIZE = 3,
    /** the object was not made by the function that makes its kind, or not successfully */
    SUSP_ERROR_OBJECT = 4,
    /** an argument has a value that is not permitted */
    SUSP_ERROR_ARGUMENT = 5,
    /** the drive is outside the range of the curve */
    SUSP_ERROR_OUTSIDE = 6,
    /** the points that give a direction coincide, lie in line or are not finite */
    SUSP_ERROR_NO_DIRECTION = 7,
    /** the text is not a listing that can be solved; the message says where and why */
    SUSP_ERROR_LISTING = 8,
    /** the listing has no such part */
    SUSP_ERROR_ABSENT = 9,
    /** a coordinate of a point is not a finite number, or too large to compute with; give hardpoints in one unit and near the vehicle */
    SUSP_ERROR_POINT_NOT_FINITE = 20,
    /** a length is not positive, or too large or too small to compute with; keep points apart that a link or a body joins */
    SUSP_ERROR_BAD_LENGTH = 21,
    /** the three points that carry a point, or that a plane goes through, lie in line; move one of them off the line, or name three that form a triangle */
    SUSP_ERROR_COLLINEAR = 22,
    /** a point lies in the plane of the points that links join it to, where their lengths do not hold it; state these points as a `body` */
    SUSP_ERROR_FLAT = 23,
    /** no rigid body has these lengths: they do not close at a point; measure its lengths again */
    SUSP_ERROR_NOT_CLOSED = 24,
    /** a line has no length, or lies along the axis of its angle; put its ends apart, or off the axis */
    SUSP_ERROR_NO_LINE = 25,
    /** the fixed order of elimination has too small a pivot at these hardpoints; state hardpoints near these in the listing, or step with partial pivoting */
    SUSP_ERROR_SMALL_PIVOT = 26,
    /** the equations do not determine the motion at these hardpoints: the mechanism locks there, or a drive has no effect; state hardpoints away from the lock, or drive something else */
    SUSP_ERROR_SINGULAR_DESIGN = 27,
    /** an input or a residual is not a finite number; look at inputs, start and time step */
    SUSP_ERROR_NOT_FINITE = 40,
    /** a correction, velocity, acceleration or force is not a finite number; look at the inputs and their rates, or at the forces */
    SUSP_ERROR_OVERFLOW = 41,
    /** the step ends in another assembly, beyond a singularity; take shorter steps */
    SUSP_ERROR_CROSSED_SINGULARITY = 42,
    /** the equations do not determine the motion here: the mechanism locks, or a drive has no effect; stay away from the lock, or lead the motion by a measure */
    SUSP_ERROR_SINGULAR = 43,
    /** a point stands on the wrong side of the points that links join it to; start from the assembly that is meant */
    SUSP_ERROR_MIRRORED = 44,
    /** there is no configuration near by: the correction is too large; take shorter steps, or assemble */
    SUSP_ERROR_DIVERGING = 45,
    /** the step is too long to tell assemblies apart; take shorter steps */
    SUSP_ERROR_TOO_FAR = 46,
    /** the step is longer than the series is good for; take shorter steps */
    SUSP_ERROR_STEP_TOO_LONG = 47,
    /** the quantity that leads turns before it meets its target; lead by another one, or not so far */
    SUSP_ERROR_TURNING_POINT = 48,
    /** the residual is above the tolerance after all corrections that are allowed; take shorter steps, give rates that match the drives, allow more corrections, or assemble a start that is no configuration; in assembling, see that lengths and drives fit together */
    SUSP_ERROR_NOT_CONVERGED = 49,
    /** all steps that are allowed are used up; allow more of them */
    SUSP_ERROR_STEPS_USED_UP = 50,
    /** the pivots of the fixed order of elimination are too small here; make the step with partial pivoting */
    SUSP_ERROR_UNHEALTHY_PIVOTS = 51,
    /** an angle is driven beyond its range; drive it from 0 to pi where it is between a link and an axis, else by less than a whole turn */
    SUSP_ERROR_ANGLE_OUT_OF_RANGE = 52,
    /** the time step or the time after it is not a finite number; give finite times */
    SUSP_ERROR_STEP_NOT_FINITE = 53,
    /** nothing is proved: the Jacobian is singular to rounding; prove roots away from singularities */
    SUSP_ERROR_UNPROVED_NEAR_SINGULAR = 60,
    /** nothing is proved: the root is too far away, or a singularity too near; correct the position first */
    SUSP_ERROR_UNPROVED_TOO_FAR = 61,
};

/** The rates for which a bounded step solves. */
typedef int32_t susp_outputs;
enum { SUSP_POSITION = 0, SUSP_VELOCITY = 1, SUSP_ACCELERATION = 2 };

/** The meaning of a status: a text that lives as long as the program. */
const char *susp_status_text(
        susp_status status);

/** An array of numbers of the caller. */
typedef struct {
    /** The first number. */
    const float *numbers;
    /** The number of elements. */
    size_t count;
} susp_f32_numbers;

/** Details of a failure. */
typedef struct {
    /** The status that the call returns. */
    susp_status status;
    /** The drive, point, length, equation or unknown concerned, by its name in the listing; NULL if
     * there is none. Lives as long as the program, or with a listing from text as long as the object. */
    const char *culprit;
    /** The residual, correction, pivot or other number to which `status` refers, in the unit of the
     * points; 0 if there is none. */
    float value;
    /** The limit for `value`. */
    float bound;
    /** For steps in sub-steps: the time from the start of the step, s, up to which there are solutions. */
    float reached;
} susp_f32_failure;

/** The report of a step. */
typedef struct {
    /** The number of factorisations for the position. */
    uint32_t iterations;
    /** The number of sub-steps. */
    uint32_t steps;
    /** The remaining residual, in the unit of the points: the largest, or for a bounded step the norm.
     * Without corrections it is a bound, `error`. */
    float residual;
    /** The limit for the residual. */
    float tolerance;
    /** The first correction of the last step, in the unit of the points: the error of the predicted
     * position. The largest entry, or for a bounded step the norm. */
    float error;
    /** Pivot growth, the norm of the inverses of the pivots: about how much rounding errors grow. */
    float growth;
} susp_f32_report;

/** The report of an assembly. */
typedef struct {
    /** The distance from the guess: the norm over all coordinates, in the unit of the points. */
    float distance;
    /** The distance of the next nearest configuration that was found; infinite if there was none. If
     * both distances are nearly equal the guess is ambiguous. */
    float next;
    /** The largest remaining residual, in the unit of the points. */
    float residual;
    /** The limit for the residual. */
    float tolerance;
} susp_f32_assembly;

/** A proof, rounding included, that a root is near a position. Distances are the largest difference of
 * any unknown, in the unit of the points. */
typedef struct {
    /** There is a root within this distance. */
    float radius;
    /** There is no other root within this distance. */
    float unique_within;
} susp_f32_certificate;

/** The wheel, or the first wheel that the listing of an axle states. Axes of ISO 8855: x forward, y
 * left, z up. */
typedef struct {
    /** The wheel centre, in the unit of the points. */
    float centre[3];
    /** The spin axis, of unit length, outboard. */
    float axis[3];
    /** Camber, rad: positive if the top leans outboard, atan2(-s_z, |s_y|) of the axis s. */
    float camber;
    /** Camber as the angle between spin axis and ground, rad: asin(-s_z). */
    float camber_to_ground;
    /** Toe, rad: positive if the front points inboard, atan2(s_x, |s_y|). */
    float toe;
} susp_f32_wheel;

/** The wheel with its first and second derivatives, with respect to time or to a change of the drives. */
typedef struct {
    /** The wheel. */
    susp_f32_wheel value;
    /** Per second, or per unit of the change. */
    susp_f32_wheel rate;
    /** Per second squared, or per unit of the change squared. */
    susp_f32_wheel second_rate;
} susp_f32_wheel_rates;

/** The rotation of the body that carries the wheel. */
typedef struct {
    /** Angular velocity, rad/s. */
    float omega[3];
    /** Angular acceleration, rad/s^2. */
    float alpha[3];
} susp_f32_carrier_rotation;

/** The kingpin k, which points upwards. */
typedef struct {
    /** Inclination, rad: positive if the top leans inboard, atan2(-k_y, k_z) on the left. */
    float angle;
    /** Caster, rad: positive if the top leans rearwards, atan2(-k_x, k_z). */
    float caster;
} susp_f32_kingpin;

/** A part with a mass. With points in m the mass is in kg, with points in mm in t: forces are then in N. */
typedef struct {
    /** The number of points that locate it: 1 for a mass at a point, 2 for a uniform rod between two
     * points, 3 for a body with these three points, which are not in line. */
    uint32_t count;
    /** The numbers of these points, from 0: the order of the members of the points, or the result of
     * `susp_listing_find`. */
    uint32_t points[3];
    /** The mass, zero or positive. */
    float mass;
    /** For a body, its centre of mass, for the points as in `design`; otherwise any finite numbers. */
    float centre[3];
    /** For a body, its inertia about that centre in the axes of `design`, entries xx, yy, zz, xy, yz
     * and zx of the matrix, which are the products of inertia with a minus sign: with points in m, kg
     * m^2, with points in mm, t mm^2. Otherwise any finite numbers. */
    float inertia[6];
} susp_f32_mass;

/** The motion of the chassis as a rigid body, in world axes. */
typedef struct {
    /** The quaternion w, x, y, z from chassis axes to world axes. Any length but zero, which is
     * SUSP_ERROR_ARGUMENT. */
    float rotation[4];
    /** Position of the chassis' origin, in the unit of the points. */
    float position[3];
    /** Velocity of the origin, per second. */
    float velocity[3];
    /** Acceleration of the origin, per second squared. */
    float acceleration[3];
    /** Angular velocity, rad/s. */
    float omega[3];
    /** Angular acceleration, rad/s^2. */
    float alpha[3];
} susp_f32_rigid_motion;

/** A baked motion of the wheel from `suspension bake`: a piecewise polynomial of one drive. */
typedef struct {
    /** The drive's first and last value, in rad or the unit of the points. */
    float range[2];
    /** The number of segments divided by the length of the range. */
    float segments_per_unit;
    /** By segment, power (six, constants first) and output (six: centre, axis). They must live as long
     * as the curve is used. */
    susp_f32_numbers coefficients;
} susp_f32_curve;

/** A wheel computed from a curve. */
typedef struct {
    /** The wheel centre, in the unit of the points. */
    float centre[3];
    /** The spin axis, outboard: of unit length within the tolerance of the curve. */
    float axis[3];
} susp_f32_baked_wheel;

/** The wheel with its first and second time derivatives. */
typedef struct {
    /** The wheel. */
    susp_f32_baked_wheel value;
    /** Per second. */
    susp_f32_baked_wheel rate;
    /** Per second squared. */
    susp_f32_baked_wheel second_rate;
} susp_f32_baked_wheel_rates;

/** An array of masses of the caller, and the gravity that acts on them. */
typedef struct {
    /** The first mass; not NULL. */
    const susp_f32_mass *masses;
    /** The number of elements. */
    size_t count;
    /** The acceleration of free fall minus that of the chassis, in the unit of the points per second
     * squared. */
    float gravity[3];
} susp_f32_masses;

/** Evaluates a wheel for the value of a drive, its rate, per second, and its second rate,
 * per second squared. SUSP_ERROR_OUTSIDE beyond the range of the curve,
 * SUSP_ERROR_ARGUMENT if its numbers do not belong to one table. */
susp_status susp_f32_look_up_wheel(
        const susp_f32_curve *curve,
        float drive,
        float rate,
        float second_rate,
        susp_f32_baked_wheel_rates *wheel);

/** An array of numbers of the caller. */
typedef struct {
    /** The first number. */
    const double *numbers;
    /** The number of elements. */
    size_t count;
} susp_f64_numbers;

/** Details of a failure. */
typedef struct {
    /** The status that the call returns. */
    susp_status status;
    /** The drive, point, length, equation or unknown concerned, by its name in the listing; NULL if
     * there is none. Lives as long as the program, or with a listing from text as long as the object. */
    const char *culprit;
    /** The residual, correction, pivot or other number to which `status` refers, in the unit of the
     * points; 0 if there is none. */
    double value;
    /** The limit for `value`. */
    double bound;
    /** For steps in sub-steps: the time from the start of the step, s, up to which there are solutions. */
    double reached;
} susp_f64_failure;

/** The report of a step. */
typedef struct {
    /** The number of factorisations for the position. */
    uint32_t iterations;
    /** The number of sub-steps. */
    uint32_t steps;
    /** The remaining residual, in the unit of the points: the largest, or for a bounded step the norm.
     * Without corrections it is a bound, `error`. */
    double residual;
    /** The limit for the residual. */
    double tolerance;
    /** The first correction of the last step, in the unit of the points: the error of the predicted
     * position. The largest entry, or for a bounded step the norm. */
    double error;
    /** Pivot growth, the norm of the inverses of the pivots: about how much rounding errors grow. */
    double growth;
} susp_f64_report;

/** The report of an assembly. */
typedef struct {
    /** The distance from the guess: the norm over all coordinates, in the unit of the points. */
    double distance;
    /** The distance of the next nearest configuration that was found; infinite if there was none. If
     * both distances are nearly equal the guess is ambiguous. */
    double next;
    /** The largest remaining residual, in the unit of the points. */
    double residual;
    /** The limit for the residual. */
    double tolerance;
} susp_f64_assembly;

/** A proof, rounding included, that a root is near a position. Distances are the largest difference of
 * any unknown, in the unit of the points. */
typedef struct {
    /** There is a root within this distance. */
    double radius;
    /** There is no other root within this distance. */
    double unique_within;
} susp_f64_certificate;

/** The wheel, or the first wheel that the listing of an axle states. Axes of ISO 8855: x forward, y
 * left, z up. */
typedef struct {
    /** The wheel centre, in the unit of the points. */
    double centre[3];
    /** The spin axis, of unit length, outboard. */
    double axis[3];
    /** Camber, rad: positive if the top leans outboard, atan2(-s_z, |s_y|) of the axis s. */
    double camber;
    /** Camber as the angle between spin axis and ground, rad: asin(-s_z). */
    double camber_to_ground;
    /** Toe, rad: positive if the front points inboard, atan2(s_x, |s_y|). */
    double toe;
} susp_f64_wheel;

/** The wheel with its first and second derivatives, with respect to time or to a change of the drives. */
typedef struct {
    /** The wheel. */
    susp_f64_wheel value;
    /** Per second, or per unit of the change. */
    susp_f64_wheel rate;
    /** Per second squared, or per unit of the change squared. */
    susp_f64_wheel second_rate;
} susp_f64_wheel_rates;

/** The rotation of the body that carries the wheel. */
typedef struct {
    /** Angular velocity, rad/s. */
    double omega[3];
    /** Angular acceleration, rad/s^2. */
    double alpha[3];
} susp_f64_carrier_rotation;

/** The kingpin k, which points upwards. */
typedef struct {
    /** Inclination, rad: positive if the top leans inboard, atan2(-k_y, k_z) on the left. */
    double angle;
    /** Caster, rad: positive if the top leans rearwards, atan2(-k_x, k_z). */
    double caster;
} susp_f64_kingpin;

/** A part with a mass. With points in m the mass is in kg, with points in mm in t: forces are then in N. */
typedef struct {
    /** The number of points that locate it: 1 for a mass at a point, 2 for a uniform rod between two
     * points, 3 for a body with these three points, which are not in line. */
    uint32_t count;
    /** The numbers of these points, from 0: the order of the members of the points, or the result of
     * `susp_listing_find`. */
    uint32_t points[3];
    /** The mass, zero or positive. */
    double mass;
    /** For a body, its centre of mass, for the points as in `design`; otherwise any finite numbers. */
    double centre[3];
    /** For a body, its inertia about that centre in the axes of `design`, entries xx, yy, zz, xy, yz
     * and zx of the matrix, which are the products of inertia with a minus sign: with points in m, kg
     * m^2, with points in mm, t mm^2. Otherwise any finite numbers. */
    double inertia[6];
} susp_f64_mass;

/** The motion of the chassis as a rigid body, in world axes. */
typedef struct {
    /** The quaternion w, x, y, z from chassis axes to world axes. Any length but zero, which is
     * SUSP_ERROR_ARGUMENT. */
    double rotation[4];
    /** Position of the chassis' origin, in the unit of the points. */
    double position[3];
    /** Velocity of the origin, per second. */
    double velocity[3];
    /** Acceleration of the origin, per second squared. */
    double acceleration[3];
    /** Angular velocity, rad/s. */
    double omega[3];
    /** Angular acceleration, rad/s^2. */
    double alpha[3];
} susp_f64_rigid_motion;

/** A baked motion of the wheel from `suspension bake`: a piecewise polynomial of one drive. */
typedef struct {
    /** The drive's first and last value, in rad or the unit of the points. */
    double range[2];
    /** The number of segments divided by the length of the range. */
    double segments_per_unit;
    /** By segment, power (six, constants first) and output (six: centre, axis). They must live as long
     * as the curve is used. */
    susp_f64_numbers coefficients;
} susp_f64_curve;

/** A wheel computed from a curve. */
typedef struct {
    /** The wheel centre, in the unit of the points. */
    double centre[3];
    /** The spin axis, outboard: of unit length within the tolerance of the curve. */
    double axis[3];
} susp_f64_baked_wheel;

/** The wheel with its first and second time derivatives. */
typedef struct {
    /** The wheel. */
    susp_f64_baked_wheel value;
    /** Per second. */
    susp_f64_baked_wheel rate;
    /** Per second squared. */
    susp_f64_baked_wheel second_rate;
} susp_f64_baked_wheel_rates;

/** An array of masses of the caller, and the gravity that acts on them. */
typedef struct {
    /** The first mass; not NULL. */
    const susp_f64_mass *masses;
    /** The number of elements. */
    size_t count;
    /** The acceleration of free fall minus that of the chassis, in the unit of the points per second
     * squared. */
    double gravity[3];
} susp_f64_masses;

/** Evaluates a wheel for the value of a drive, its rate, per second, and its second rate,
 * per second squared. SUSP_ERROR_OUTSIDE beyond the range of the curve,
 * SUSP_ERROR_ARGUMENT if its numbers do not belong to one table. */
susp_status susp_f64_look_up_wheel(
        const susp_f64_curve *curve,
        double drive,
        double rate,
        double second_rate,
        susp_f64_baked_wheel_rates *wheel);

#ifdef __cplusplus
}
#endif

#endif
