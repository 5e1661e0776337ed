/*
 * Suspension kinematics for C. This file has what all linkages share; include the one of a linkage,
 * such as suspension_five_link_f32.h. Written from the functions' source: do not edit.
 *
 * Memory    The caller owns every object: on the stack, static, or wherever. Nothing is allocated, and
 *           nothing has to be freed. Objects may be copied by assignment or memcpy. Listings from text
 *           alone are on the heap: see suspension_listing.h.
 * Opaque    What is in `words` is the library's. An object must have been made by the function that
 *           takes its size before another function takes it; if not, SUSP_ERROR_OBJECT is answered
 *           (with any content but one that happens to begin with the right mark).
 * Threads   There is no other state than the caller's objects. Calls may run at the same time in any
 *           threads or interrupts as long as none writes an object that another one uses.
 * Pointers  None may be NULL, save `failure` and where it is said. Each is checked for that and for its
 *           alignment. What a pointer to const points to may be shared by arguments; no other
 *           memory may overlap.
 * Answers   SUSP_OK, or why nothing was done: then everything is as it was but for `*failure`, which is
 *           written only then. Only those named `advance` keep what they have got to.
 *           SUSP_ERROR_SMALL_PIVOT alone comes with a model.
 * Numbers   Any unit of length, the same throughout; angles in rad, times in s. NaN and infinities are
 *           told by the answers of what makes a model and of what solves, but for drives that measures
 *           alone read; what only reads, carries or looks up may pass them on. Axes: x forward, y left,
 *           z up (ISO 8855) where wheels are read off.
 * Structs   of named points or numbers are arrays in the order of their members as well.
 */
#ifndef SUSP_H
#define SUSP_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What a function answers. */
typedef int32_t susp_status;
enum {
    /** done */
    SUSP_OK = 0,
    /** a pointer is NULL that must not be */
    SUSP_ERROR_NULL = 1,
    /** a pointer is not aligned for what it points to */
    SUSP_ERROR_MISALIGNED = 2,
    /** the memory has another size than the library needs: header and library differ, or an array has another count than the listing */
    SUSP_ERROR_SIZE = 3,
    /** the object was not made by the function that makes its kind, or not successfully */
    SUSP_ERROR_OBJECT = 4,
    /** an argument is none of the values that it may have */
    SUSP_ERROR_ARGUMENT = 5,
    /** the drive is outside the range of the curve */
    SUSP_ERROR_OUTSIDE = 6,
    /** the points that give a direction coincide, lie in line or are not finite */
    SUSP_ERROR_NO_DIRECTION = 7,
    /** the text is no listing that can be solved; the message says where and why */
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
    /** a line has no length; put its ends apart */
    SUSP_ERROR_NO_LINE = 25,
    /** the fixed order of elimination has too small a pivot at these hardpoints; state hardpoints near these in the listing, or step with partial pivoting */
    SUSP_ERROR_SMALL_PIVOT = 26,
    /** a residual is not a finite number; look at inputs, start and time step */
    SUSP_ERROR_NOT_FINITE = 40,
    /** a correction, velocity or acceleration is not a finite number; look at the inputs and their rates */
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
    /** the residual is above the tolerance after all corrections that are allowed; take shorter steps, or allow more corrections; in assembling, see that lengths and drives fit together */
    SUSP_ERROR_NOT_CONVERGED = 49,
    /** all steps that are allowed are used up; allow more of them */
    SUSP_ERROR_STEPS_USED_UP = 50,
    /** the pivots of the fixed order of elimination are too small here; make the step with partial pivoting */
    SUSP_ERROR_UNHEALTHY_PIVOTS = 51,
    /** an angle is driven beyond its range; drive it from 0 to pi where it is between a link and an axis, else by less than a whole turn */
    SUSP_ERROR_ANGLE_OUT_OF_RANGE = 52,
    /** nothing is proved: the Jacobian is singular to rounding; prove roots away from singularities */
    SUSP_ERROR_UNPROVED_NEAR_SINGULAR = 60,
    /** nothing is proved: the root is too far away, or a singularity too near; correct the position first */
    SUSP_ERROR_UNPROVED_TOO_FAR = 61,
};

/** What a bounded step solves for. */
typedef int32_t susp_outputs;
enum { SUSP_POSITION = 0, SUSP_VELOCITY = 1, SUSP_ACCELERATION = 2 };

/** What an answer means: a text that lives as long as the program. */
const char *susp_status_text(
        susp_status status);

/** Numbers of the caller's. */
typedef struct {
    /** The first of them. */
    const float *numbers;
    /** How many. */
    size_t count;
} susp_f32_numbers;

/** What went wrong. */
typedef struct {
    /** What the call answers. */
    susp_status status;
    /** The point, length, equation or unknown concerned, as the listing names it; NULL where there
     * is none. Lives as long as the program; of a listing from text as long as the object. */
    const char *culprit;
    /** What was found: the residual, correction, pivot or the like that `status` speaks of; in the
     * unit of the points. 0 where nothing is compared. */
    float value;
    /** What `value` had to stay within, or to exceed. */
    float bound;
    /** Of a step in sub-steps: the time from its start, s, up to which there are solutions. */
    float reached;
} susp_f32_failure;

/** What a step did. */
typedef struct {
    /** Factorisations for the position. */
    uint32_t iterations;
    /** Sub-steps. */
    uint32_t steps;
    /** The residual that is left, in the unit of the points: the largest, of a bounded step the
     * norm of all; without corrections a bound, the error. */
    float residual;
    /** What it was compared with. */
    float tolerance;
    /** The first correction of the last step, in the unit of the points: the error of the
     * predicted position. The largest entry, of a bounded step the norm. */
    float error;
    /** Pivot growth, the norm of the pivots' inverses: rounding grows with it, at most. */
    float growth;
} susp_f32_report;

/** How a configuration was found. */
typedef struct {
    /** How far it is from the guess: the norm over all coordinates, in the unit of the points. */
    float distance;
    /** How far the next nearest one that was met is from it; infinite where there is none. Where the
     * two are nearly alike the guess does not tell which is meant. */
    float next;
    /** The largest residual that is left, in the unit of the points. */
    float residual;
    /** What it was compared with. */
    float tolerance;
} susp_f32_assembly;

/** A proof, rounding included, that a root lies near a position. Distances are the largest
 * difference of any unknown, in the unit of the points. */
typedef struct {
    /** A root lies within this distance. */
    float radius;
    /** No other root lies within this one. */
    float unique_within;
} susp_f32_certificate;

/** The wheel; of an axle the first that the listing states. Axes of ISO 8855: x forward, y left, z up. */
typedef struct {
    /** Its centre, in the unit of the points. */
    float centre[3];
    /** Its spin axis, of unit length, outboard. */
    float axis[3];
    /** Camber, rad: positive where the top leans outboard, atan2(-s_z, |s_y|) of the axis s. */
    float camber;
    /** Camber as the angle between spin axis and ground, rad: asin(-s_z). */
    float camber_to_ground;
    /** Toe, rad: positive where the front points inboard, atan2(s_x, |s_y|). */
    float toe;
} susp_f32_wheel;

/** How the body that carries the wheel turns. */
typedef struct {
    /** Angular velocity, rad/s. */
    float omega[3];
    /** Angular acceleration, rad/s^2. */
    float alpha[3];
} susp_f32_carrier_rotation;

/** The kingpin k, which points upwards. */
typedef struct {
    /** Inclination, rad: positive where the top leans inboard, atan2(-k_y, k_z) on the left. */
    float angle;
    /** Caster, rad: positive where the top leans rearwards, atan2(-k_x, k_z). */
    float caster;
} susp_f32_kingpin;

/** A part that has a mass: with points in m, kg. */
typedef struct {
    /** How many points say where it is: 1 of a mass in a point, 2 of a uniform rod between two, 3 of a body that three
     * of its points hold, which are not in line. */
    uint32_t count;
    /** Their numbers, from 0: the places of the members among the points, or what `susp_listing_find` tells. */
    uint32_t points[3];
    /** From zero on. */
    float mass;
    /** Of a body, else anything finite: its centre of mass, where its points are as in `design`. */
    float centre[3];
    /** Of a body, else anything finite: its inertia about that centre in the axes of `design`, entries xx, yy, zz, xy, yz
     * and zx of the matrix, the products of inertia with a minus: with points in m, kg m^2. */
    float inertia[6];
} susp_f32_mass;

/** How a chassis moves as a rigid body, in world axes. */
typedef struct {
    /** From chassis axes to world axes: w, x, y, z. Of any length but zero, else SUSP_ERROR_ARGUMENT. */
    float rotation[4];
    /** Position of the chassis' origin, in the unit of the points. */
    float position[3];
    /** Its velocity, per second. */
    float velocity[3];
    /** Its acceleration, per second squared. */
    float acceleration[3];
    /** Angular velocity, rad/s. */
    float omega[3];
    /** Angular acceleration, rad/s^2. */
    float alpha[3];
} susp_f32_rigid_motion;

/** A baked motion of the wheel, as `suspension bake` writes it: a piecewise polynomial of one drive. */
typedef struct {
    /** The drive's first and last value, in rad or the unit of the points. */
    float range[2];
    /** The number of segments divided by the length of the range. */
    float segments_per_unit;
    /** By segment, power (six, constants first) and output (six: centre, axis). They must live as
     * long as the curve is used. */
    susp_f32_numbers coefficients;
} susp_f32_curve;

/** A wheel that was looked up. */
typedef struct {
    /** Its centre, in the unit of the points. */
    float centre[3];
    /** Its spin axis, outboard: of unit length within the tolerance of the curve. */
    float axis[3];
} susp_f32_baked_wheel;

/** The same with its first and second time derivatives. */
typedef struct {
    /** The wheel. */
    susp_f32_baked_wheel value;
    /** Per second. */
    susp_f32_baked_wheel rate;
    /** Per second squared. */
    susp_f32_baked_wheel second_rate;
} susp_f32_baked_wheel_rates;

/** Masses of the caller's in a field. */
typedef struct {
    /** The first of them; not NULL. */
    const susp_f32_mass *masses;
    /** How many. */
    size_t count;
    /** The acceleration of free fall, in the unit of the points per second squared; less that of the chassis,
     * where it has one. */
    float gravity[3];
} susp_f32_masses;

/** Looks a wheel up where the drive has a value and moves at a rate, per second, and a
 * second rate, per second squared. SUSP_ERROR_OUTSIDE where the curve does not reach,
 * SUSP_ERROR_ARGUMENT where its numbers are not those of one table. */
susp_status susp_f32_look_up_wheel(
        const susp_f32_curve *curve,
        float drive,
        float rate,
        float second_rate,
        susp_f32_baked_wheel_rates *wheel);

/** Numbers of the caller's. */
typedef struct {
    /** The first of them. */
    const double *numbers;
    /** How many. */
    size_t count;
} susp_f64_numbers;

/** What went wrong. */
typedef struct {
    /** What the call answers. */
    susp_status status;
    /** The point, length, equation or unknown concerned, as the listing names it; NULL where there
     * is none. Lives as long as the program; of a listing from text as long as the object. */
    const char *culprit;
    /** What was found: the residual, correction, pivot or the like that `status` speaks of; in the
     * unit of the points. 0 where nothing is compared. */
    double value;
    /** What `value` had to stay within, or to exceed. */
    double bound;
    /** Of a step in sub-steps: the time from its start, s, up to which there are solutions. */
    double reached;
} susp_f64_failure;

/** What a step did. */
typedef struct {
    /** Factorisations for the position. */
    uint32_t iterations;
    /** Sub-steps. */
    uint32_t steps;
    /** The residual that is left, in the unit of the points: the largest, of a bounded step the
     * norm of all; without corrections a bound, the error. */
    double residual;
    /** What it was compared with. */
    double tolerance;
    /** The first correction of the last step, in the unit of the points: the error of the
     * predicted position. The largest entry, of a bounded step the norm. */
    double error;
    /** Pivot growth, the norm of the pivots' inverses: rounding grows with it, at most. */
    double growth;
} susp_f64_report;

/** How a configuration was found. */
typedef struct {
    /** How far it is from the guess: the norm over all coordinates, in the unit of the points. */
    double distance;
    /** How far the next nearest one that was met is from it; infinite where there is none. Where the
     * two are nearly alike the guess does not tell which is meant. */
    double next;
    /** The largest residual that is left, in the unit of the points. */
    double residual;
    /** What it was compared with. */
    double tolerance;
} susp_f64_assembly;

/** A proof, rounding included, that a root lies near a position. Distances are the largest
 * difference of any unknown, in the unit of the points. */
typedef struct {
    /** A root lies within this distance. */
    double radius;
    /** No other root lies within this one. */
    double unique_within;
} susp_f64_certificate;

/** The wheel; of an axle the first that the listing states. Axes of ISO 8855: x forward, y left, z up. */
typedef struct {
    /** Its centre, in the unit of the points. */
    double centre[3];
    /** Its spin axis, of unit length, outboard. */
    double axis[3];
    /** Camber, rad: positive where the top leans outboard, atan2(-s_z, |s_y|) of the axis s. */
    double camber;
    /** Camber as the angle between spin axis and ground, rad: asin(-s_z). */
    double camber_to_ground;
    /** Toe, rad: positive where the front points inboard, atan2(s_x, |s_y|). */
    double toe;
} susp_f64_wheel;

/** How the body that carries the wheel turns. */
typedef struct {
    /** Angular velocity, rad/s. */
    double omega[3];
    /** Angular acceleration, rad/s^2. */
    double alpha[3];
} susp_f64_carrier_rotation;

/** The kingpin k, which points upwards. */
typedef struct {
    /** Inclination, rad: positive where the top leans inboard, atan2(-k_y, k_z) on the left. */
    double angle;
    /** Caster, rad: positive where the top leans rearwards, atan2(-k_x, k_z). */
    double caster;
} susp_f64_kingpin;

/** A part that has a mass: with points in m, kg. */
typedef struct {
    /** How many points say where it is: 1 of a mass in a point, 2 of a uniform rod between two, 3 of a body that three
     * of its points hold, which are not in line. */
    uint32_t count;
    /** Their numbers, from 0: the places of the members among the points, or what `susp_listing_find` tells. */
    uint32_t points[3];
    /** From zero on. */
    double mass;
    /** Of a body, else anything finite: its centre of mass, where its points are as in `design`. */
    double centre[3];
    /** Of a body, else anything finite: its inertia about that centre in the axes of `design`, entries xx, yy, zz, xy, yz
     * and zx of the matrix, the products of inertia with a minus: with points in m, kg m^2. */
    double inertia[6];
} susp_f64_mass;

/** How a chassis moves as a rigid body, in world axes. */
typedef struct {
    /** From chassis axes to world axes: w, x, y, z. Of any length but zero, else SUSP_ERROR_ARGUMENT. */
    double rotation[4];
    /** Position of the chassis' origin, in the unit of the points. */
    double position[3];
    /** Its velocity, per second. */
    double velocity[3];
    /** Its acceleration, per second squared. */
    double acceleration[3];
    /** Angular velocity, rad/s. */
    double omega[3];
    /** Angular acceleration, rad/s^2. */
    double alpha[3];
} susp_f64_rigid_motion;

/** A baked motion of the wheel, as `suspension bake` writes it: a piecewise polynomial of one drive. */
typedef struct {
    /** The drive's first and last value, in rad or the unit of the points. */
    double range[2];
    /** The number of segments divided by the length of the range. */
    double segments_per_unit;
    /** By segment, power (six, constants first) and output (six: centre, axis). They must live as
     * long as the curve is used. */
    susp_f64_numbers coefficients;
} susp_f64_curve;

/** A wheel that was looked up. */
typedef struct {
    /** Its centre, in the unit of the points. */
    double centre[3];
    /** Its spin axis, outboard: of unit length within the tolerance of the curve. */
    double axis[3];
} susp_f64_baked_wheel;

/** The same with its first and second time derivatives. */
typedef struct {
    /** The wheel. */
    susp_f64_baked_wheel value;
    /** Per second. */
    susp_f64_baked_wheel rate;
    /** Per second squared. */
    susp_f64_baked_wheel second_rate;
} susp_f64_baked_wheel_rates;

/** Masses of the caller's in a field. */
typedef struct {
    /** The first of them; not NULL. */
    const susp_f64_mass *masses;
    /** How many. */
    size_t count;
    /** The acceleration of free fall, in the unit of the points per second squared; less that of the chassis,
     * where it has one. */
    double gravity[3];
} susp_f64_masses;

/** Looks a wheel up where the drive has a value and moves at a rate, per second, and a
 * second rate, per second squared. SUSP_ERROR_OUTSIDE where the curve does not reach,
 * SUSP_ERROR_ARGUMENT where its numbers are not those of one table. */
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
