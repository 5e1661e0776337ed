/* The example car for an engine: what it is built of, what the engine tells, what acts on it.
 *
 * The engine is a C++ class with
 *   Engine(const Design &)                        the car at the start of the drive
 *   void look(State &)                            before a step
 *   void step(const Forces &, const double rack[3], const double next[3])
 * and `drive<Engine>` in its `main`, whose arguments are steps in a tick and inertia of wheels across. Driver, tyres, road, struts, stops, bars, clock and errors are Rust's, in the
 * library beside (`../src/interface.rs` has the meanings). */
#ifndef CAR_H
#define CAR_H
#include <cstdio>
#include <cstdlib>

enum { CORNERS = 4, POINTS = 14 };
/* Points of a corner, in chassis axes from the chassis' centre of mass: first those of all, then those of an axle. */
enum { WHEEL_CENTRE, AXLE, STRUT_UPPER, STRUT_LOWER };
enum { LOWER_FRONT = 4, LOWER_REAR, UPPER_FRONT, UPPER_REAR, RACK, LOWER_BALL, UPPER_BALL, TIE_BALL };
enum { LATERAL_INNER = 4, DIAGONAL_INNER, UPPER_FRONT_INNER, UPPER_REAR_INNER, TOE_INNER };
enum { LATERAL_BALL = 9, DIAGONAL_BALL, UPPER_FRONT_BALL, UPPER_REAR_BALL, TOE_BALL };

struct Corner {
    double points[POINTS][3];
    double mass, spin_inertia, spin;
};
struct Design {
    double mass, inertia[3], height, speed, gravity, dt, across;
    Corner corners[CORNERS];
};
struct Wheel {
    double centre[3], velocity[3], axis[3], turning[3], rolling, strut[2];
};
struct State {
    double position[3], rotation[9], velocity[3], turning[3];
    Wheel wheels[CORNERS];
};
struct OnWheel {
    double force[3], moment[3], drive, travel, strut;
};
struct Forces {
    OnWheel wheels[CORNERS];
};

extern "C" {
struct CarEngine {
    void *self;
    void (*look)(void *, State *);
    void (*step)(void *, const Forces *, const double *, const double *);
};
int car_design(Design *design, unsigned steps, double across);
int car_drive(const CarEngine *engine, unsigned steps);
}

template <class Engine> static int drive(int count, char **arguments)
{
    if (count != 3) {
        fprintf(stderr, "usage: %s STEPS ACROSS\n", arguments[0]);
        return 2;
    }
    Design design;
    unsigned steps = atoi(arguments[1]);
    if (car_design(&design, steps, atof(arguments[2])))
        return 1;
    Engine engine(design);
    CarEngine entry = {
        &engine, [](void *self, State *state) { static_cast<Engine *>(self)->look(*state); },
        [](void *self, const Forces *forces, const double *rack, const double *next) {
            static_cast<Engine *>(self)->step(*forces, rack, next);
        }};
    return car_drive(&entry, steps);
}

/* Of a carrier, which the example car has not: what an engine needs not to be singular, kg m^2. */
static const double CARRIER_INERTIA = 1e-3;
#endif
