/* Newton's method with Eigen's LU of fixed size, partial pivoting. */
#include <Eigen/LU>
#include <cmath>

#include "geometry.h"
#include "harness.h"

using Vector = Eigen::Matrix<double, N, 1>;
using Matrix = Eigen::Matrix<double, N, N>;
using Point = Eigen::Vector3d;
using Factors = Eigen::PartialPivLU<Matrix>;

static inline void equations(const Vector &q, double theta, Vector &residual, Matrix &jacobian)
{
    int row = 0;
    jacobian.setZero();
    for (const Outer &link : OUTER) {
        Point d = q.segment<3>(link.point) - Eigen::Map<const Point>(link.chassis);
        residual[row] = (d.squaredNorm() - link.length * link.length) / 2;
        jacobian.row(row++).segment<3>(link.point) = d;
    }
    for (const Inner &link : INNER) {
        Point d = q.segment<3>(link.second) - q.segment<3>(link.first);
        residual[row] = (d.squaredNorm() - link.length * link.length) / 2;
        jacobian.row(row).segment<3>(link.first) = -d;
        jacobian.row(row++).segment<3>(link.second) = d;
    }
    residual[row] = q[2] - DRIVEN_FROM - DRIVEN_LENGTH * std::cos(theta);
    jacobian(row, 2) = 1;
}

/* C(v, v), of the distances. */
static inline Vector curvature(const Vector &v)
{
    Vector terms = Vector::Zero();
    int row = 0;
    for (const Outer &link : OUTER)
        terms[row++] = v.segment<3>(link.point).squaredNorm();
    for (const Inner &link : INNER)
        terms[row++] = (v.segment<3>(link.second) - v.segment<3>(link.first)).squaredNorm();
    return terms;
}

static inline void position(const Instant *from, Instant *next)
{
    Vector q, residual;
    Matrix jacobian;
    predict(from, q.data());
    equations(q, next->theta, residual, jacobian);
    Eigen::Map<Vector>(next->q) = q - Factors(jacobian).solve(residual);
}

static inline void step(const Instant *from, Instant *next)
{
    position(from, next);
    Vector q = Eigen::Map<Vector>(next->q), residual;
    Matrix jacobian;
    equations(q, next->theta, residual, jacobian);
    Factors factors(jacobian);
    double sine = std::sin(next->theta), cosine = std::cos(next->theta), rate = next->rate;
    Vector right = Vector::Zero();
    right[N - 1] = -DRIVEN_LENGTH * sine * rate;
    Vector v = factors.solve(right);
    right = -curvature(v);
    right[N - 1] = -DRIVEN_LENGTH * (cosine * rate * rate + sine * next->second_rate);
    Eigen::Map<Vector>(next->v) = v;
    Eigen::Map<Vector>(next->a) = factors.solve(right);
}

int main(int count, char **arguments)
{
    const char *folder = load(count, arguments);
    time_part(folder, "newton", position);
    time_part(folder, "position", position);
    time_step(folder, step);
    return 0;
}
