/* MuJoCo: rods as tendons of constant length, integrated. The build defines STIFF where constraints are
 * as stiff as the time step allows and the angle, its rate and its acceleration are set by hand, and
 * SUBSTEPS. */
#include <mujoco/mujoco.h>

#include <string>

#include "engine.h"

#ifndef SUBSTEPS
#define SUBSTEPS 1
#endif

enum { THETA_JOINT = 1, POINTS = 5 };
/* A joint so heavy goes on as it is set. */
static const double DRIVEN_ARMATURE = 1e8;

static std::string numbers(const double *x, int count)
{
    std::string text;
    char digits[32];
    for (int i = 0; i < count; i++) {
        snprintf(digits, sizeof digits, "%.17g ", x[i]);
        text += digits;
    }
    return text;
}

/* The angle in MuJoCo's own way is an equality of its joint. */
static std::string description(const Instant &first)
{
    std::string world, knuckle, tendons, rods;
    for (int p = 0; p < POINTS; p++) {
        double from_first[3];
        for (int i = 0; i < 3; i++)
            from_first[i] = first.q[3 * p + i] - first.q[i];
        std::string number = std::to_string(p);
        world += "<site name='c" + number + "' pos='" + numbers(OUTER[p].chassis, 3) + "'/>";
        knuckle += "<site name='k" + number + "' pos='" + numbers(from_first, 3) + "'/>";
        if (p > 0) {
            tendons += "<spatial name='r" + number + "'><site site='c" + number + "'/><site site='k" +
                       number + "'/></spatial>";
            rods += "<tendon tendon1='r" + number + "'/>";
        }
    }
    double end[3] = {0, 0, DRIVEN_LENGTH}, inertia[3] = {INERTIA, INERTIA, INERTIA};
    double step = DT / SUBSTEPS, mass = MASS;
#ifdef STIFF
    double soft[2] = {2 * step, 1};
    std::string angle = "armature='" + numbers(&DRIVEN_ARMATURE, 1) + "'", drive;
    std::string stiff =
        "<default><equality solref='" + numbers(soft, 2) + "' solimp='0.9999 0.9999 1'/></default>";
#else
    std::string angle, stiff, drive = "<joint joint1='theta'/>";
#endif
    return "<mujoco><option timestep='" + numbers(&step, 1) + "'/>" + stiff + "<worldbody>" + world +
           "<body pos='" + numbers(OUTER[0].chassis, 3) + "'><inertial pos='0 0 0' mass='0.01' " +
           "diaginertia='1e-4 1e-4 1e-4'/><joint axis='0 0 1'/><joint name='theta' axis='0 1 0' " +
           angle + "/><body name='knuckle' pos='" + numbers(end, 3) +
           "'><joint type='ball'/><inertial pos='0 0 0' mass='" + numbers(&mass, 1) +
           "' diaginertia='" + numbers(inertia, 3) + "'/>" + knuckle +
           "</body></body></worldbody><tendon>" + tendons + "</tendon><equality>" + rods + drive +
           "</equality></mujoco>";
}

class Engine
{
public:
    explicit Engine(const Instant &first)
    {
        char error[1000] = "";
        mjSpec *spec = mj_parseXMLString(description(first).c_str(), nullptr, error, sizeof error);
        model = spec ? mj_compile(spec, nullptr) : nullptr;
        mj_deleteSpec(spec);
        if (!model) {
            fprintf(stderr, "error: %s\n", error);
            exit(1);
        }
        data = mj_makeData(model);
        knuckle = mj_name2id(model, mjOBJ_BODY, "knuckle");
        for (int p = 0; p < POINTS; p++)
            site[p] = mj_name2id(model, mjOBJ_SITE, ("k" + std::to_string(p)).c_str());
        for (int rod = 0; rod < RODS; rod++)
            model->eq_data[rod * mjNEQDATA] = OUTER[rod + 1].length - model->tendon_length0[rod];
        start(first);
    }

    ~Engine()
    {
        mj_deleteData(data);
        mj_deleteModel(model);
    }

    Engine(const Engine &) = delete;

    const char *step(const Instant &to)
    {
        for (int part = SUBSTEPS - 1; part >= 0; part--) {
            double before = part * DT / SUBSTEPS;
            mj_Euler(model, data);
            drive(to.theta - (to.rate - to.second_rate / 2 * before) * before,
                  to.rate - to.second_rate * before, to.second_rate);
            mj_forward(model, data);
        }
        bool warned = data->warning[mjWARN_BADQPOS].number + data->warning[mjWARN_BADQVEL].number +
                      data->warning[mjWARN_BADQACC].number;
        return warned ? "warning" : nullptr;
    }

    void motion(Instant &at) const
    {
        mj_rnePostConstraint(model, data);
        for (int p = 0; p < POINTS; p++) {
            double turning[6];
            memcpy(at.q + 3 * p, data->site_xpos + 3 * site[p], 3 * sizeof(double));
            mj_objectVelocity(model, data, mjOBJ_SITE, site[p], turning, 0);
            memcpy(at.v + 3 * p, turning + 3, 3 * sizeof(double));
            mj_objectAcceleration(model, data, mjOBJ_SITE, site[p], turning, 0);
            /* The world is said to accelerate against gravity. */
            for (int i = 0; i < 3; i++)
                at.a[3 * p + i] = turning[3 + i] + model->opt.gravity[i];
        }
    }

    /* In a copy, at rest and without gravity. */
    void rods(double tension[RODS])
    {
        mjData *rest = mj_copyData(nullptr, model, data);
        double gravity[3], centre[3];
        memcpy(gravity, model->opt.gravity, sizeof gravity);
        memset(model->opt.gravity, 0, sizeof gravity);
        memset(rest->qvel, 0, model->nv * sizeof(double));
        memset(rest->qfrc_applied, 0, model->nv * sizeof(double));
        mju_mulMatVec3(centre, data->xmat + 9 * knuckle, WHEEL_CENTRE);
        mju_addTo3(centre, data->xpos + 3 * knuckle);
        mj_applyFT(model, rest, LOAD, nullptr, centre, knuckle, rest->qfrc_applied);
        mj_forward(model, rest);
        for (int rod = 0; rod < RODS; rod++)
            tension[rod] = -rest->efc_force[rod];
        memcpy(model->opt.gravity, gravity, sizeof gravity);
        mj_deleteData(rest);
    }

private:
    void start(const Instant &first)
    {
        double link[3];
        mju_sub3(link, first.q, OUTER[0].chassis);
        double around = std::atan2(link[1], link[0]);
        double back[4] = {std::cos(first.theta / 2), 0, -std::sin(first.theta / 2), 0};
        double turned[4] = {std::cos(around / 2), 0, 0, -std::sin(around / 2)};
        data->qpos[0] = around;
        data->qpos[THETA_JOINT] = first.theta;
        mju_mulQuat(data->qpos + 2, back, turned);
        mj_forward(model, data);
        start_velocity(first);
        drive(first.theta, first.rate, first.second_rate);
        mj_forward(model, data);
    }

    /* From the speeds of the points: that of the link about the vertical, then the knuckle's spin in
     * its own axes, which are the world's. */
    void start_velocity(const Instant &first)
    {
        double link[3], spin[3] = {0, 0, 0};
        mju_sub3(link, first.q, OUTER[0].chassis);
        double flat = link[0] * link[0] + link[1] * link[1];
        double about = (link[0] * first.v[1] - link[1] * first.v[0]) / flat;
        double cosine = link[0] / std::sqrt(flat), sine = link[1] / std::sqrt(flat);
        spin_of(first, spin);
        data->qvel[0] = about;
        data->qvel[THETA_JOINT] = first.rate;
        data->qvel[2] = spin[0] + sine * first.rate;
        data->qvel[3] = spin[1] - cosine * first.rate;
        data->qvel[4] = spin[2] - about;
    }

    /* v1 - v0 = w x (p1 - p0) and the same of points 0 and 2: w = (dv1 x dv2) / (dv1 . d2). */
    static void spin_of(const Instant &first, double spin[3])
    {
        double one[3], two[3], d2[3];
        mju_sub3(one, first.v + 3, first.v);
        mju_sub3(two, first.v + 6, first.v);
        mju_sub3(d2, first.q + 6, first.q);
        mju_cross(spin, one, two);
        mju_scl3(spin, spin, 1 / mju_dot3(one, d2));
    }

    void drive(double theta, double rate, double second_rate)
    {
#ifdef STIFF
        data->qpos[THETA_JOINT] = theta;
        data->qvel[THETA_JOINT] = rate;
        data->qfrc_applied[THETA_JOINT] = DRIVEN_ARMATURE * second_rate;
#else
        (void)rate, (void)second_rate;
        model->eq_data[RODS * mjNEQDATA] = theta;
#endif
    }

    mjModel *model;
    mjData *data;
    int knuckle, site[POINTS];
};

int main(int count, char **arguments)
{
    return measure<Engine>(count, arguments);
}
