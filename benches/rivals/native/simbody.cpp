/* Simbody: rods as its constraints, the driven angle as a prescribed motion, and its projection onto
 * both at each step. */
#include <Simbody.h>

#include "engine.h"

using namespace SimTK;

static const Real ACCURACY = 1e-13; /* the loosest that keeps 1e-14 m */

struct Drive : Motion::Custom::Implementation {
    explicit Drive(const Instant &now) : now(now) {}
    Motion::Level getLevel(const State &) const override { return Motion::Position; }
    void calcPrescribedPosition(const State &, int, Real *q) const override { *q = now.theta; }
    void calcPrescribedPositionDot(const State &, int, Real *rate) const override { *rate = now.rate; }
    void calcPrescribedPositionDotDot(const State &, int, Real *second) const override
    {
        *second = now.second_rate;
    }
    const Instant &now;
};

class Engine
{
public:
    explicit Engine(const Instant &first) : now(first), matter(system), forces(system)
    {
        build(first);
        state = system.realizeTopology();
        system.realizeModel(state);
        Vec3 link = Vec3::getAs(first.q) - Vec3::getAs(OUTER[0].chassis);
        Real around = std::atan2(link[1], link[0]);
        column.setOneQ(state, 0, around);
        arm.setOneQ(state, 0, first.theta);
        knuckle.setQToFitRotation(state, Rotation(-first.theta, YAxis) * Rotation(-around, ZAxis));
        settle();
    }

    const char *step(const Instant &to)
    {
        now = to;
        Vector q = state.getQ() + DT * (state.getQDot() + DT / 2 * state.getQDotDot());
        Vector u = state.getU() + DT * state.getUDot();
        state.setTime(state.getTime() + DT);
        state.setQ(q);
        state.setU(u);
        settle();
        return nullptr;
    }

    void motion(Instant &at) const
    {
        for (int p = 0; p < N; p += 3) {
            knuckle.findStationLocationVelocityAndAccelerationInGround(
                state, station[p / 3], Vec3::updAs(at.q + p), Vec3::updAs(at.v + p), Vec3::updAs(at.a + p));
        }
    }

    /* In a copy of the state, at rest. */
    void rods(double tension[RODS])
    {
        Instant moving = now;
        now.rate = now.second_rate = 0;
        State rest = state;
        rest.invalidateAllCacheAtOrAbove(Stage::Time);
        rest.setU(Vector(rest.getNU(), 0.0));
        load.enable(rest);
        system.realize(rest, Stage::Acceleration);
        for (int i = 0; i < RODS; i++)
            tension[i] = rod[i].getRodTension(rest);
        now = moving;
    }

private:
    void build(const Instant &first)
    {
        const Body::Massless light;
        column = MobilizedBody::Pin(matter.Ground(), Vec3::getAs(OUTER[0].chassis), light, Vec3(0));
        Transform about_y(Rotation(-Pi / 2, XAxis));
        arm = MobilizedBody::Pin(column, about_y, light, about_y);
        Motion::Custom(arm, new Drive(now));
        MassProperties mass(MASS, Vec3(0), Inertia(INERTIA));
        knuckle = MobilizedBody::Ball(arm, Vec3(0, 0, DRIVEN_LENGTH), Body::Rigid(mass), Vec3(0));
        for (int p = 0; p < N; p += 3)
            station[p / 3] = Vec3::getAs(first.q + p) - Vec3::getAs(first.q);
        for (int i = 0; i < RODS; i++) {
            const Outer &link = OUTER[i + 1];
            rod[i] = Constraint::Rod(matter.Ground(), Vec3::getAs(link.chassis), knuckle,
                                     station[link.point / 3], link.length);
        }
        load = Force::ConstantForce(forces, knuckle, Vec3::getAs(WHEEL_CENTRE), Vec3::getAs(LOAD));
        load.setDisabledByDefault(true);
    }

    void settle()
    {
        system.project(state, ACCURACY);
        system.realize(state, Stage::Acceleration);
    }

    Instant now;
    MultibodySystem system;
    SimbodyMatterSubsystem matter;
    GeneralForceSubsystem forces;
    MobilizedBody::Pin column, arm;
    MobilizedBody::Ball knuckle;
    Constraint::Rod rod[RODS];
    Force::ConstantForce load;
    Vec3 station[N / 3];
    State state;
};

int main(int count, char **arguments)
{
    return measure<Engine>(count, arguments);
}
