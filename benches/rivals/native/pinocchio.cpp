/* Pinocchio: the driven link and the knuckle as a tree of joints, the four rods closed by Newton's
 * method of our own on its Jacobians, as its example of inverse kinematics does. */
#include <pinocchio/fwd.hpp>

#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/algorithm/kinematics.hpp>

#include <pinocchio/multibody.hpp>

#include <Eigen/LU>

#include "engine.h"

using Eigen::Vector3d;
using Eigen::Vector4d;
using Rates = Eigen::Matrix<double, 5, 1>; /* about the vertical, theta, the knuckle's three */
using Rows = Eigen::Matrix<double, 4, 5>;
namespace pin = pinocchio;

static const int POINTS = 5, MOST_ITERATIONS = 20;
static const double TOLERANCE = 1e-15; /* of half the squares of lengths, m^2 */

class Engine
{
public:
    explicit Engine(const Instant &first)
    {
        build(first);
        q = pin::neutral(model);
        Vector3d link = Vector3d(first.q) - Vector3d(OUTER[0].chassis);
        double around = std::atan2(link.y(), link.x());
        q[0] = around;
        q[1] = first.theta;
        Eigen::Quaterniond turned(Eigen::AngleAxisd(-first.theta, Vector3d::UnitY()) *
                                  Eigen::AngleAxisd(-around, Vector3d::UnitZ()));
        q.tail<4>() = turned.coeffs();
        place();
        rates(first);
    }

    const char *step(const Instant &to)
    {
        q = pin::integrate(model, q, DT * (v + DT / 2 * a));
        q[1] = to.theta;
        for (int i = 0; i < MOST_ITERATIONS; i++) {
            place();
            if (residual.cwiseAbs().maxCoeff() < TOLERANCE) {
                rates(to);
                return nullptr;
            }
            q = pin::integrate(model, q, spread(factors.solve(-residual), 0));
        }
        return "no error of its own; our iteration ends";
    }

    void motion(Instant &at) const
    {
        for (int p = 0; p < POINTS; p++) {
            Eigen::Map<Vector3d>(at.q + 3 * p) = data.oMf[frame[p]].translation();
            Eigen::Map<Vector3d>(at.v + 3 * p).noalias() = jacobian[p].topRows<3>() * v;
            Eigen::Map<Vector3d>(at.a + 3 * p).noalias() = jacobian[p].topRows<3>() * a + bias[p];
        }
    }

    /* The other joints' work of the load, by the rods' unit directions. */
    void rods(double tension[RODS])
    {
        Eigen::Matrix<double, 6, 5> wheel = Eigen::Matrix<double, 6, 5>::Zero();
        pin::getFrameJacobian(model, data, frame[POINTS], pin::LOCAL_WORLD_ALIGNED, wheel);
        Rates work = wheel.topRows<3>().transpose() * Eigen::Map<const Vector3d>(LOAD);
        Vector4d multipliers = unknowns(rows).transpose().partialPivLu().solve(
            Vector4d(work[0], work[2], work[3], work[4]));
        for (int rod = 0; rod < RODS; rod++)
            tension[rod] = multipliers[rod] * OUTER[rod + 1].length;
    }

private:
    void build(const Instant &first)
    {
        Vector3d knuckle(first.q);
        auto at = [](const Vector3d &place) { return pin::SE3(Eigen::Matrix3d::Identity(), place); };
        auto joint = model.addJoint(0, pin::JointModelRZ(), at(Vector3d(OUTER[0].chassis)), "around");
        joint = model.addJoint(joint, pin::JointModelRY(), at(Vector3d::Zero()), "theta");
        Vector3d end = DRIVEN_LENGTH * Vector3d::UnitZ();
        joint = model.addJoint(joint, pin::JointModelSpherical(), at(end), "knuckle");
        for (int p = 0; p <= POINTS; p++) {
            Vector3d place = p < POINTS ? Vector3d(first.q + 3 * p) - knuckle : Vector3d(WHEEL_CENTRE);
            frame[p] = model.addFrame(
                pin::Frame("p" + std::to_string(p + 6), joint, 0, at(place), pin::OP_FRAME));
        }
        data = pin::Data(model);
        for (auto &matrix : jacobian)
            matrix.setZero();
        v.setZero();
        a.setZero();
    }

    /* Residual and factors of the rods at `q`. */
    void place()
    {
        pin::computeJointJacobians(model, data, q);
        pin::updateFramePlacements(model, data);
        for (int p = 0; p < POINTS; p++)
            pin::getFrameJacobian(model, data, frame[p], pin::LOCAL_WORLD_ALIGNED, jacobian[p]);
        for (int rod = 0; rod < RODS; rod++) {
            const Outer &link = OUTER[rod + 1];
            along[rod] = data.oMf[frame[rod + 1]].translation() - Vector3d(link.chassis);
            residual[rod] = (along[rod].squaredNorm() - link.length * link.length) / 2;
            rows.row(rod).noalias() = along[rod].transpose() * jacobian[rod + 1].topRows<3>();
        }
        factors.compute(unknowns(rows));
    }

    void rates(const Instant &to)
    {
        v = spread(factors.solve(-rows.col(1) * to.rate), to.rate);
        pin::forwardKinematics(model, data, q, v, Rates::Zero());
        Vector4d right = -rows.col(1) * to.second_rate;
        for (int p = 0; p < POINTS; p++)
            bias[p] = pin::getFrameClassicalAcceleration(model, data, frame[p], pin::LOCAL_WORLD_ALIGNED)
                          .linear();
        for (int rod = 0; rod < RODS; rod++) {
            Vector3d speed = jacobian[rod + 1].topRows<3>() * v;
            right[rod] -= along[rod].dot(bias[rod + 1]) + speed.squaredNorm();
        }
        a = spread(factors.solve(right), to.second_rate);
    }

    static Eigen::Matrix4d unknowns(const Rows &rows)
    {
        Eigen::Matrix4d square;
        square << rows.col(0), rows.rightCols<3>();
        return square;
    }

    static Rates spread(const Vector4d &unknown, double driven)
    {
        return (Rates() << unknown[0], driven, unknown.tail<3>()).finished();
    }

    pin::Model model;
    pin::Data data;
    pin::FrameIndex frame[POINTS + 1];
    Eigen::VectorXd q;
    Rates v, a;
    Eigen::Matrix<double, 6, 5> jacobian[POINTS];
    Vector3d bias[POINTS], along[RODS];
    Rows rows;
    Vector4d residual;
    Eigen::PartialPivLU<Eigen::Matrix4d> factors;
};

int main(int count, char **arguments)
{
    return measure<Engine>(count, arguments);
}
