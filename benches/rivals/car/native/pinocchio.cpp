/* Pinocchio: chassis, wishbones, links, carriers and wheels a tree of joints; the rods that close its loops are rows of ours
 * in `forwardDynamics`, which keep the lengths at the end of the step. Semi-implicit Euler. */
#include <pinocchio/fwd.hpp>

#include <pinocchio/algorithm/contact-dynamics.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/algorithm/kinematics.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/multibody.hpp>

#include "car.h"

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;
namespace pin = pinocchio;

static Vector3d vector(const double *x) { return Eigen::Map<const Vector3d>(x); }
static Eigen::Map<Vector3d> at(double *x) { return Eigen::Map<Vector3d>(x); }
static pin::SE3 beyond(const Vector3d &place) { return pin::SE3(Matrix3d::Identity(), place); }

/* From a place of the chassis to one of a carrier. */
struct Rod {
    Vector3d inner, outer;
    pin::JointIndex carrier;
    int first_column, columns;
    double square;
    bool on_rack;
};

struct Suspended {
    pin::JointIndex carrier, wheel, strut;
    Vector3d axis, strut_upper, strut_lower;
};

/* Of a place of a joint, which moves there with the rate and second rate; in world axes. */
struct Moving {
    Vector3d place, velocity, acceleration;
};

class Engine
{
public:
    explicit Engine(const Design &design) : dt(design.dt), across(design.across)
    {
        build(design);
        data = pin::Data(model);
        q = pin::neutral(model);
        v = VectorXd::Zero(model.nv);
        q[2] = design.height;
        v[0] = design.speed;
        for (int i = 0; i < CORNERS; i++)
            v[model.joints[corners[i].wheel].idx_v()] = design.corners[i].spin;
        none = VectorXd::Zero(model.nv);
        rows = Eigen::MatrixXd::Zero(rods.size(), model.nv);
        drift = VectorXd::Zero(rods.size());
        pushes.resize(model.njoints);
    }

    void look(State &state)
    {
        pin::forwardKinematics(model, data, q, v, none);
        Moving of_chassis = moving(chassis, Vector3d::Zero());
        at(state.position) = of_chassis.place;
        at(state.velocity) = of_chassis.velocity;
        Eigen::Map<Matrix3d>(state.rotation) = data.oMi[chassis].rotation();
        at(state.turning) = data.oMi[chassis].rotation() * data.v[chassis].angular();
        for (int i = 0; i < CORNERS; i++)
            look(corners[i], state.wheels[i]);
    }

    void step(const Forces &forces, const double *rack, const double *)
    {
        for (size_t rod = 0; rod < rods.size(); rod++)
            moved[rod] = moving(rods[rod].carrier, rods[rod].outer);
        push(forces);
        pin::crba(model, data, q, pin::Convention::WORLD);
        for (size_t rod = 0; rod < rods.size(); rod++)
            close(rod, rack);
        pin::rnea(model, data, q, v, none, pushes);
        data.nle = data.tau;
        v += dt * pin::forwardDynamics(model, data, none, rows, drift, 0.0);
        q = pin::integrate(model, q, dt * v);
    }

private:
    void build(const Design &design)
    {
        model.gravity.linear() = Vector3d(0, 0, -design.gravity);
        auto floating = model.addJoint(0, pin::JointModelTranslation(), pin::SE3::Identity(), "place");
        chassis = model.addJoint(floating, pin::JointModelSpherical(), pin::SE3::Identity(), "chassis");
        Matrix3d inertia = vector(design.inertia).asDiagonal();
        model.appendBodyToJoint(chassis, pin::Inertia(design.mass, Vector3d::Zero(), inertia));
        for (int i = 0; i < CORNERS; i++) {
            const Corner &corner = design.corners[i];
            corners[i] = i < 2 ? front(corner, i) : rear(corner, i);
        }
    }

    Suspended front(const Corner &corner, int i)
    {
        auto place = [&](int point) { return vector(corner.points[point]); };
        Vector3d hinge = (place(LOWER_FRONT) - place(LOWER_REAR)).normalized();
        auto wishbone = joint(chassis, pin::JointModelRevoluteUnaligned(hinge), place(LOWER_FRONT), "wishbone", i);
        auto carrier = joint(wishbone, pin::JointModelSpherical(), place(LOWER_BALL) - place(LOWER_FRONT), "upright", i);
        int ends[3][2] = {{UPPER_FRONT, UPPER_BALL}, {UPPER_REAR, UPPER_BALL}, {RACK, TIE_BALL}};
        for (auto &[inner, outer] : ends)
            rod(place(inner), place(outer), place(LOWER_BALL), carrier, wishbone, inner == RACK);
        return suspended(corner, carrier, place(LOWER_BALL), wishbone, place(LOWER_FRONT), i);
    }

    /* The lateral link turns about two axes across it. */
    Suspended rear(const Corner &corner, int i)
    {
        auto place = [&](int point) { return vector(corner.points[point]); };
        Vector3d along = (place(LATERAL_BALL) - place(LATERAL_INNER)).normalized();
        Vector3d one = Vector3d::UnitZ().cross(along).normalized(), two = along.cross(one);
        auto turned = joint(chassis, pin::JointModelRevoluteUnaligned(one), place(LATERAL_INNER), "turned", i);
        auto link = joint(turned, pin::JointModelRevoluteUnaligned(two), Vector3d::Zero(), "link", i);
        auto carrier = joint(link, pin::JointModelSpherical(), place(LATERAL_BALL) - place(LATERAL_INNER), "knuckle", i);
        for (int rest = 1; rest < 5; rest++)
            rod(place(LATERAL_INNER + rest), place(LATERAL_BALL + rest), place(LATERAL_BALL), carrier, turned, false);
        return suspended(corner, carrier, place(LATERAL_BALL), carrier, place(LATERAL_BALL), i);
    }

    template <class Joint>
    pin::JointIndex joint(pin::JointIndex parent, const Joint &kind, const Vector3d &place, const char *name, int i)
    {
        return model.addJoint(parent, kind, beyond(place), name + std::to_string(i));
    }

    void rod(const Vector3d &inner, const Vector3d &outer, const Vector3d &origin, pin::JointIndex carrier,
             pin::JointIndex first, bool on_rack)
    {
        int from = model.joints[first].idx_v(), to = model.joints[carrier].idx_v() + model.joints[carrier].nv();
        rods.push_back({inner, outer - origin, carrier, from, to - from, (outer - inner).squaredNorm(), on_rack});
        moved.emplace_back();
    }

    Suspended suspended(const Corner &corner, pin::JointIndex carrier, const Vector3d &of_carrier, pin::JointIndex strut,
                        const Vector3d &of_strut, int i)
    {
        auto place = [&](int point) { return vector(corner.points[point]); };
        Vector3d axis = (place(WHEEL_CENTRE) - place(AXLE)).normalized();
        if (axis.y() < 0)
            axis = -axis;
        auto wheel = joint(carrier, pin::JointModelRevoluteUnaligned(axis), place(WHEEL_CENTRE) - of_carrier, "wheel", i);
        Matrix3d whole = across * Matrix3d::Identity();
        Matrix3d inertia = whole + (corner.spin_inertia - across) * axis * axis.transpose();
        model.appendBodyToJoint(wheel, pin::Inertia(corner.mass, Vector3d::Zero(), inertia));
        model.appendBodyToJoint(carrier, pin::Inertia(0, Vector3d::Zero(), CARRIER_INERTIA * Matrix3d::Identity()));
        return {carrier, wheel, strut, axis, place(STRUT_UPPER), place(STRUT_LOWER) - of_strut};
    }

    Moving moving(pin::JointIndex joint, const Vector3d &r, const Vector3d &rate = Vector3d::Zero(),
                  const Vector3d &second_rate = Vector3d::Zero()) const
    {
        const auto &pose = data.oMi[joint];
        Vector3d w = data.v[joint].angular(), velocity = data.v[joint].linear() + w.cross(r);
        Vector3d acceleration = data.a[joint].linear() + data.a[joint].angular().cross(r) + w.cross(velocity);
        acceleration += 2 * w.cross(rate) + second_rate;
        return {pose.act(r), pose.rotation() * (velocity + rate), pose.rotation() * acceleration};
    }

    void look(const Suspended &corner, Wheel &wheel) const
    {
        const Matrix3d &turned = data.oMi[corner.carrier].rotation();
        Moving centre = moving(corner.wheel, Vector3d::Zero());
        at(wheel.centre) = centre.place;
        at(wheel.velocity) = centre.velocity;
        at(wheel.axis) = turned * corner.axis;
        at(wheel.turning) = turned * data.v[corner.carrier].angular();
        wheel.rolling = v[model.joints[corner.wheel].idx_v()];
        Moving lower = moving(corner.strut, corner.strut_lower), upper = moving(chassis, corner.strut_upper);
        Vector3d along = upper.place - lower.place;
        wheel.strut[0] = along.norm();
        wheel.strut[1] = along.dot(upper.velocity - lower.velocity) / along.norm();
    }

    void push(const Forces &forces)
    {
        for (auto &push : pushes)
            push.setZero();
        for (int i = 0; i < CORNERS; i++)
            push(corners[i], forces.wheels[i]);
    }

    void push(const Suspended &corner, const OnWheel &on)
    {
        const auto &body = data.oMi[chassis];
        Vector3d centre = data.oMi[corner.wheel].translation();
        Vector3d axis = data.oMi[corner.carrier].rotation() * corner.axis;
        Vector3d travel = on.travel * body.rotation().col(2), drive = on.drive * axis;
        push(corner.wheel, vector(on.force) + travel, centre, vector(on.moment) + drive);
        push(chassis, -travel, centre, -drive);
        Vector3d lower = data.oMi[corner.strut].act(corner.strut_lower), upper = body.act(corner.strut_upper);
        Vector3d apart = on.strut * (upper - lower).normalized();
        push(chassis, apart, upper, Vector3d::Zero());
        push(corner.strut, -apart, lower, Vector3d::Zero());
    }

    void push(pin::JointIndex joint, const Vector3d &force, const Vector3d &place, const Vector3d &moment)
    {
        const auto &pose = data.oMi[joint];
        Vector3d about = (place - pose.translation()).cross(force) + moment;
        pushes[joint] += pin::Force(pose.rotation().transpose() * force, pose.rotation().transpose() * about);
    }

    /* Half the difference of squares is zero at the end of the step: its series to the second order. */
    void close(size_t number, const double *rack)
    {
        const Rod &rod = rods[number];
        Vector3d lead = rod.on_rack ? Vector3d::UnitY().eval() : Vector3d::Zero().eval();
        Moving inner = moving(chassis, rod.inner + rack[0] * lead, rack[1] * lead, rack[2] * lead);
        const Moving &outer = moved[number];
        Vector3d along = outer.place - inner.place, rate = outer.velocity - inner.velocity;
        double value = (along.squaredNorm() - rod.square) / 2;
        double second = along.dot(outer.acceleration - inner.acceleration) + rate.squaredNorm();
        Eigen::Matrix<double, 6, 1> line;
        line << along, outer.place.cross(along);
        rows.row(number).segment(rod.first_column, rod.columns).noalias() =
            line.transpose() * data.J.middleCols(rod.first_column, rod.columns);
        drift[number] = (value / dt + along.dot(rate)) / dt + second / 2;
    }

    double dt, across;
    pin::Model model;
    pin::Data data;
    pin::JointIndex chassis;
    Suspended corners[CORNERS];
    std::vector<Rod> rods;
    std::vector<Moving> moved;
    VectorXd q, v, none, drift;
    Eigen::MatrixXd rows;
    std::vector<pin::Force> pushes;
};

int main(int count, char **arguments)
{
    return drive<Engine>(count, arguments);
}
